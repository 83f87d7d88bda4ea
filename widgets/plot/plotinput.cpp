// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Input to a plot: mouse, keys and dragged channels.
#include "widgets/models/channelmodel.h"
#include "widgets/plot/plotview.h"

#include <QChart>
#include <QDragEnterEvent>
#include <QKeyEvent>
#include <QMimeData>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace {

constexpr double kClick = 4;  // pixels: less is no drag
constexpr double kMinBox = 6;  // pixels

}  // namespace

void PlotView::wheelEvent(QWheelEvent *event)
{
    const int steps = event->angleDelta().y();
    if (steps == 0) {
        event->ignore();
        return;
    }
    emit zoomRequested(steps > 0 ? 0.8 : 1.25, timeAt(event->position().x()));
    event->accept();
}

void PlotView::mousePressEvent(QMouseEvent *event)
{
    QChartView::mousePressEvent(event);
    if (const int entry = m_legend.at(event->position()); event->button() == Qt::LeftButton && entry >= 0) {
        TraceImage::Trace &trace = m_traces.traces()[std::size_t(entry)];
        trace.visible = !trace.visible;
        applyTheme();
        return;
    }
    if (event->button() != Qt::LeftButton || !chart()->plotArea().contains(event->position()))
        return;
    m_drag = event->modifiers() & Qt::ShiftModifier ? Drag::Box : Drag::Undecided;
    m_dragFrom = m_dragAt = event->position();
}

void PlotView::mouseMoveEvent(QMouseEvent *event)
{
    QChartView::mouseMoveEvent(event);
    const QRectF area = chart()->plotArea();
    if (m_drag == Drag::Undecided && std::abs(event->position().x() - m_dragFrom.x()) >= kClick)
        m_drag = Drag::Pan;
    if (m_drag == Drag::Pan)
        emit panRequested(-(event->position().x() - m_dragAt.x()) / std::max(1.0, area.width()) * m_window);
    if (m_drag != Drag::None)
        m_dragAt = event->position();
    if (m_drag == Drag::Box)
        viewport()->update();
    if (m_drag == Drag::Pan || m_drag == Drag::Box)
        return;
    if (area.contains(event->position()))
        emit cursorMoved(timeAt(event->position().x()));
    else
        emit cursorMoved({});
}

void PlotView::mouseReleaseEvent(QMouseEvent *event)
{
    QChartView::mouseReleaseEvent(event);
    const Drag drag = std::exchange(m_drag, Drag::None);
    if (drag == Drag::Box) {
        zoomToBox(QRectF(m_dragFrom, event->position()).normalized().intersected(chart()->plotArea()));
    } else if (drag == Drag::Undecided) {
        // A click sets the line that differences count from; a click on it takes it away.
        const bool onIt = m_reference && std::abs(xAt(*m_reference) - event->position().x()) <= kClick;
        emit referenceMoved(onIt ? std::nullopt : std::optional(timeAt(event->position().x())));
    }
}

void PlotView::mouseDoubleClickEvent(QMouseEvent *event)
{
    QChartView::mouseDoubleClickEvent(event);
    autoScale();
}

void PlotView::zoomToBox(const QRectF &box)
{
    viewport()->update();
    if (box.width() < kMinBox)
        return;
    const QRectF area = chart()->plotArea();
    if (box.height() >= kMinBox) {
        for (ValueAxis &axis : m_axes) {
            const double span = axis.scale.high() - axis.scale.low();
            const double high = axis.scale.high() - (box.top() - area.top()) / area.height() * span;
            axis.scale.fix(high - box.height() / area.height() * span, high);
            applyScale(axis);
        }
        updateView();
    }
    emit spanRequested(timeAt(box.left()), timeAt(box.right()));
}

void PlotView::leaveEvent(QEvent *event)
{
    QChartView::leaveEvent(event);
    emit cursorMoved({});
}

void PlotView::keyPressEvent(QKeyEvent *event)
{
    constexpr double kStep = 0.01;
    const double step = m_window * kStep * (event->modifiers() & Qt::ShiftModifier ? 0.1 : 1.0);
    const double cursor = m_cursor.value_or(endTime() - m_window / 2);
    const bool forward = event->key() == Qt::Key_Right;
    switch (event->key()) {
    case Qt::Key_Left:
    case Qt::Key_Right:
        if (event->modifiers() & Qt::ControlModifier) {
            if (const auto mark = m_marks ? m_marks->next(cursor, forward) : std::nullopt)
                emit cursorMoved(*mark);
        } else {
            emit cursorMoved(std::min(cursor + (forward ? step : -step), endTime()));
        }
        return;
    case Qt::Key_R: emit referenceMoved(m_reference ? std::nullopt : std::optional(cursor)); return;
    case Qt::Key_A: autoScale(); return;
    case Qt::Key_PageUp: emit panRequested(-m_window / 2); return;
    case Qt::Key_PageDown: emit panRequested(m_window / 2); return;
    case Qt::Key_Plus: emit zoomRequested(0.8, cursor); return;
    case Qt::Key_Minus: emit zoomRequested(1.25, cursor); return;
    case Qt::Key_End: emit followRequested(); return;
    default: QChartView::keyPressEvent(event);
    }
}

void PlotView::dragEnterEvent(QDragEnterEvent *event)
{
    if (event->mimeData()->hasFormat(ChannelModel::kMimeType))
        event->acceptProposedAction();
}

void PlotView::dragMoveEvent(QDragMoveEvent *event)
{
    if (event->mimeData()->hasFormat(ChannelModel::kMimeType))
        event->acceptProposedAction();
}

void PlotView::dropEvent(QDropEvent *event)
{
    const QList<int> channels = ChannelModel::channelsOf(*event->mimeData());
    if (channels.isEmpty())
        return;
    event->acceptProposedAction();
    emit channelsDropped(channels);
}
