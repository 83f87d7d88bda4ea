// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/views/videoview.h"

#include "widgets/theme/theme.h"

#include <QKeyEvent>
#include <QPainter>

#include <cmath>

namespace {

// On black in both looks, as a screen for pictures is.
constexpr QColor kAround(0, 0, 0);
constexpr QColor kWords(200, 205, 212);

}  // namespace

VideoView::VideoView(QWidget *parent)
    : QWidget(parent)
{
    setAttribute(Qt::WA_OpaquePaintEvent);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Picture of the camera"));
}

void VideoView::setPicture(const std::shared_ptr<const VideoPicture> &picture)
{
    if (picture == m_picture)
        return;
    const QRectF before = place();
    m_picture = picture;
    m_isNew = picture != nullptr;
    // Around a picture of the same shape nothing changes.
    const QRectF now = place();
    if (before == now && !now.isEmpty())
        update(now.toAlignedRect());
    else
        update();
}

void VideoView::setNote(const QString &note)
{
    if (note == m_note)
        return;
    m_note = note;
    setAccessibleDescription(note);
    if (!m_picture)
        update();
}

QSize VideoView::pixels() const
{
    const double ratio = devicePixelRatioF();
    return {int(std::lround(width() * ratio)), int(std::lround(height() * ratio))};
}

// In whole pixels of the screen: a picture that fits is copied as it is.
QRectF VideoView::place() const
{
    if (!m_picture)
        return {};
    const QSize all = pixels();
    const QSize own(m_picture->width, m_picture->height);
    const QSize size = own.scaled(all, Qt::KeepAspectRatio);
    const bool isNear
        = std::abs(size.width() - own.width()) <= 1 && std::abs(size.height() - own.height()) <= 1;
    const QSize shown = isNear ? own : size;
    const double ratio = devicePixelRatioF();
    const QPoint corner((all.width() - shown.width()) / 2, (all.height() - shown.height()) / 2);
    return {QPointF(corner) / ratio, QSizeF(shown) / ratio};
}

void VideoView::paintEvent(QPaintEvent *event)
{
    QPainter painter(this);
    if (!m_picture) {
        painter.fillRect(event->rect(), kAround);
        painter.setPen(kWords);
        const QRect room
            = rect().adjusted(Metric::kMargin, Metric::kMargin, -Metric::kMargin, -Metric::kMargin);
        painter.drawText(room, Qt::AlignCenter | Qt::TextWordWrap, m_note);
        return;
    }
    const QRectF area = place();
    if (!area.contains(event->rect())) {
        // Whole points that it covers wholly.
        const QRect inner(QPoint(int(std::ceil(area.left())), int(std::ceil(area.top()))),
                          QPoint(int(std::floor(area.right())) - 1, int(std::floor(area.bottom())) - 1));
        for (const QRect &edge : QRegion(event->rect()) - inner)
            painter.fillRect(edge, kAround);
    }
    const QImage image(m_picture->pixels.data(), m_picture->width, m_picture->height, m_picture->stride(),
                       QImage::Format_RGB32);
    painter.setRenderHint(QPainter::SmoothPixmapTransform,
                          area.size() * devicePixelRatioF() != QSizeF(image.size()));
    painter.drawImage(area, image);
    painter.end();
    if (std::exchange(m_isNew, false))
        emit painted(m_picture);
}

void VideoView::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    emit pixelsChanged(pixels());
}

void VideoView::mouseDoubleClickEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton)
        emit activated();
}

// As a shortcut, Esc would not reach what stops the motors while it is held.
void VideoView::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape)
        emit escaped();
    else
        QWidget::keyPressEvent(event);
}
