// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/forms/liveslider.h"

#include "widgets/forms/valueeditor.h"
#include "widgets/models/parametermodel.h"

#include <QKeyEvent>
#include <QSlider>
#include <QVBoxLayout>
#include <QWheelEvent>

namespace {

constexpr int kSteps = 50;  // from end to end with the keys, when not by single counts

}  // namespace

LiveSlider::LiveSlider(const ParameterSpec &spec, std::pair<int, int> range, int firmware, QWidget *parent)
    : QWidget(parent)
    , m_spec(spec)
    , m_editor(new ValueEditor(spec, firmware))
{
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(m_editor);
    connect(m_editor, &ValueEditor::edited, this, &LiveSlider::edited);
    if (spec.row->kind != ValueKind::Number)
        return;
    m_slider = new QSlider(Qt::Horizontal);
    m_slider->setRange(range.first, range.second);
    m_slider->setSingleStep(std::max(1, (range.second - range.first) / kSteps));
    m_slider->setPageStep(m_slider->singleStep() * 5);
    m_slider->setFocusPolicy(Qt::StrongFocus);
    m_slider->setAccessibleName(parameterLabel(spec));
    m_slider->setObjectName(spec.key);
    m_slider->setProperty("axis", int(spec.axis));
    m_slider->installEventFilter(this);
    layout->addWidget(m_slider);
    connect(m_slider, &QSlider::valueChanged, this, [this](int raw) {
        if (!m_updating)
            emit edited(raw);
    });
}

void LiveSlider::show(std::optional<int> value, std::optional<int> stored)
{
    m_updating = true;
    m_editor->show(value, stored);
    if (m_slider) {
        m_slider->setEnabled(value.has_value());
        if (value)
            m_slider->setValue(*value);
    }
    m_updating = false;
}

bool LiveSlider::eventFilter(QObject *watched, QEvent *event)
{
    // The wheel scrolls the page unless the slider has been chosen on purpose.
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
