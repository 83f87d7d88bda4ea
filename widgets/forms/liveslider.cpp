// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/forms/liveslider.h"

#include "protocol/configuration/leap.h"
#include "widgets/forms/valueeditor.h"
#include "widgets/models/parametermodel.h"

#include <QKeyEvent>
#include <QSlider>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace {

constexpr int kSteps = 50;  // from end to end with the keys, when not by single counts
constexpr int kPositions = 1000;  // of a slider for a value that has no counts, or too many of them
constexpr double kMaxCounts = 1e6;
constexpr double kFromNothing = 1e-3;  // of the range, where that is 0

}  // namespace

LiveSlider::LiveSlider(const ParameterSpec &spec, std::pair<double, double> range, int firmware,
                       QWidget *parent)
    : QWidget(parent)
    , m_spec(spec)
    , m_editor(new ValueEditor(spec, firmware))
    , m_range(range)
    , m_span(range)
{
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(m_editor);
    connect(m_editor, &ValueEditor::edited, this, &LiveSlider::edited);
    if (spec.row->kind != ValueKind::Number)
        return;
    m_slider = new QSlider(Qt::Horizontal);
    m_inCounts = spec.row->wire != WireType::F32 && range.second - range.first <= kMaxCounts;
    if (m_inCounts)
        m_slider->setRange(int(range.first), int(range.second));
    else
        m_slider->setRange(0, kPositions);
    m_slider->setSingleStep(std::max(1, (m_slider->maximum() - m_slider->minimum()) / kSteps));
    m_slider->setPageStep(m_slider->singleStep() * 5);
    m_slider->setFocusPolicy(Qt::StrongFocus);
    m_slider->setAccessibleName(parameterLabel(spec));
    m_slider->setObjectName(spec.key);
    m_slider->setProperty("axis", int(spec.axis));
    m_slider->installEventFilter(this);
    layout->addWidget(m_slider);
    connect(m_slider, &QSlider::valueChanged, this, [this](int position) {
        if (!m_updating)
            emit edited(rawAt(position));
    });
}

// Gains are often a thousandth of what a board accepts: over all of it the smallest step would be many times
// the gain.
void LiveSlider::span(double value, std::optional<double> stored)
{
    const auto [low, high] = m_range;
    if (m_inCounts || m_spec.row->wire != WireType::F32 || low < 0)
        return;
    if (stored)
        m_reference = stored;
    else if (!m_reference)
        m_reference = value;
    const double most = *m_reference > low ? kLeap * (*m_reference - low) : kFromNothing * (high - low);
    m_span = {low, std::clamp(low + most, std::min(value, high), high)};
}

double LiveSlider::rawAt(int position) const
{
    const auto [low, high] = m_span;
    return m_inCounts ? position : m_spec.clamped(low + (high - low) * position / kPositions);
}

int LiveSlider::positionOf(double raw) const
{
    const auto [low, high] = m_span;
    const double inside = std::clamp(raw, low, high);
    if (m_inCounts)
        return int(inside);
    return high > low ? int(std::lround((inside - low) / (high - low) * kPositions)) : 0;
}

void LiveSlider::show(std::optional<double> value, std::optional<double> stored)
{
    m_updating = true;
    m_editor->show(value, stored);
    if (m_slider) {
        m_slider->setEnabled(value.has_value());
        if (value && std::isfinite(*value)) {
            span(*value, stored);
            m_slider->setValue(positionOf(*value));
        }
    }
    m_updating = false;
}

bool LiveSlider::eventFilter(QObject *watched, QEvent *event)
{
    // The wheel scrolls the page unless the slider has the focus.
    if (event->type() == QEvent::Wheel) {
        auto *wheel = static_cast<QWheelEvent *>(event);
        if (!m_slider->hasFocus()) {
            event->ignore();
            return true;
        }
        if (wheel->modifiers() & Qt::ShiftModifier) {
            const int delta = wheel->angleDelta().y() + wheel->angleDelta().x();
            m_slider->setValue(m_slider->value() + (delta > 0 ? 1 : -1));
            return true;
        }
    }
    if (event->type() == QEvent::KeyPress) {
        const auto *key = static_cast<QKeyEvent *>(event);
        const bool up = key->key() == Qt::Key_Up || key->key() == Qt::Key_Right;
        const bool down = key->key() == Qt::Key_Down || key->key() == Qt::Key_Left;
        if ((up || down) && (key->modifiers() & Qt::ShiftModifier)) {
            m_slider->setValue(m_slider->value() + (up ? 1 : -1));
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}
