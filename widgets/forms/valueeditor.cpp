// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/forms/valueeditor.h"

#include "widgets/forms/flagsbutton.h"
#include "widgets/forms/latebutton.h"
#include "widgets/forms/parameterbox.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"
#include "widgets/theme/theme.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QScrollBar>
#include <QVBoxLayout>

#include <utility>

using namespace Qt::StringLiterals;

namespace {

constexpr int kResetWidth = 18;
constexpr int kListMargin = 6;  // of the theme

/// Its list is as wide as its texts: the field itself has no room for the long ones.
class ChoiceBox final : public QComboBox
{
public:
    void showPopup() override
    {
        const int wide = view()->sizeHintForColumn(0) + view()->verticalScrollBar()->sizeHint().width()
            + 2 * view()->frameWidth() + kListMargin;
        view()->setMinimumWidth(std::max(width(), wide));
        QComboBox::showPopup();
    }
};

void markChanged(QWidget *widget, bool changed)
{
    if (widget->property("changed").toBool() == changed)
        return;
    widget->setProperty("changed", changed);
    repolish(widget);
    QFont font = widget->font();
    font.setBold(changed);
    widget->setFont(font);
    // A spin box keeps its text in a line edit that does not always follow under a style sheet.
    if (auto *line = widget->findChild<QLineEdit *>())
        line->setFont(font);
}

}  // namespace

ValueEditor::ValueEditor(const ParameterSpec &spec, int firmware, QWidget *parent)
    : QWidget(parent)
    , m_spec(spec)
    , m_reset(new LateButton(this))
{
    switch (spec.row->kind) {
    case ValueKind::Number: m_control = makeNumber(); break;
    case ValueKind::Choice: m_control = makeChoice(firmware); break;
    case ValueKind::Toggle: m_control = makeToggle(); break;
    case ValueKind::Flags: m_control = makeFlags(firmware); break;
    }
    QString name = parameterLabel(spec);
    if (*spec.row->unit)
        name += u", "_s + QString::fromUtf8(spec.row->unit);
    m_control->setAccessibleName(name);
    m_control->setAccessibleDescription(tableText(spec.row->help));
    m_control->setObjectName(spec.key);
    m_control->setEnabled(!spec.row->state);
    m_control->installEventFilter(this);
    if (auto *line = m_control->findChild<QLineEdit *>())
        line->installEventFilter(this);
    setFocusProxy(m_control);

    m_reset->setObjectName(u"reset"_s);
    m_reset->setAutoRaise(true);
    m_reset->setFocusPolicy(Qt::TabFocus);
    m_reset->setVisible(false);
    connect(m_reset, &LateButton::clicked, this, [this] { emit edited(m_boardRaw); });

    // Its place is kept, so that nothing moves when a value changes.
    m_reset->setText(u"↺"_s);
    QSizePolicy policy = m_reset->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    m_reset->setSizePolicy(policy);
    m_reset->setFixedWidth(kResetWidth);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    auto *line = new QHBoxLayout;
    line->setSpacing(0);
    line->addWidget(m_control, 1);
    line->addWidget(m_reset);
    layout->addLayout(line);
    if (!spec.row->textFigure)
        return;
    m_figure = new QLabel;
    m_figure->setObjectName(u"muted"_s);
    m_figure->setAlignment(Qt::AlignRight);
    m_figure->setContentsMargins(0, 0, kResetWidth + Metric::kUnit, 0);
    layout->addWidget(m_figure);
    showFigure({});
}

QWidget *ValueEditor::makeNumber()
{
    m_number = new ParameterBox(m_spec);
    m_number->setFocusPolicy(Qt::StrongFocus);
    m_number->setMinimumWidth(72);
    connect(m_number, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        if (!m_updating)
            emit edited(m_spec.clamped(m_spec.toRaw(value)));
    });
    connect(m_number, &NumberBox::refusedChanged, this, [this] {
        if (!m_updating)
            emit refusedChanged();
    });
    return m_number;
}

QWidget *ValueEditor::makeChoice(int firmware)
{
    m_choice = new ChoiceBox;
    m_choice->setFocusPolicy(Qt::StrongFocus);
    m_choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_choice->setMinimumContentsLength(6);
    for (const Choice &choice : m_spec.choices(firmware))
        m_choice->addItem(tableText(choice.name), choice.value);
    connect(m_choice, &QComboBox::currentIndexChanged, this, [this](int index) {
        if (!m_updating && index >= 0)
            emit edited(m_choice->itemData(index).toInt());
    });
    return m_choice;
}

QWidget *ValueEditor::makeToggle()
{
    m_toggle = new QCheckBox;
    connect(m_toggle, &QCheckBox::toggled, this, [this](bool on) {
        if (!m_updating)
            emit edited(on ? 1 : 0);
    });
    return m_toggle;
}

QWidget *ValueEditor::makeFlags(int firmware)
{
    m_flags = new FlagsButton;
    m_flagsMenu = new QMenu(m_flags);
    for (const Choice &choice : m_spec.choices(firmware)) {
        QAction *action = m_flagsMenu->addAction(tableText(choice.name));
        action->setCheckable(true);
        action->setData(choice.value);
        connect(action, &QAction::triggered, this, [this, bit = choice.value](bool on) {
            const quint32 mask = 1U << bit;
            const quint32 bits = flagBits(m_raw);
            emit edited(on ? bits | mask : bits & ~mask);
        });
    }
    m_flags->setMenu(m_flagsMenu);
    return m_flags;
}

void ValueEditor::show(std::optional<double> value, std::optional<double> onBoard, bool isKnown)
{
    m_control->setEnabled(value && !m_spec.row->state);
    if (!value)
        return;
    // What was typed and is no value, or none yet, stays until there is another value.
    const bool isOther = std::exchange(m_shown, true) && !sameValue(*value, m_raw);
    const bool keepsText = m_number && (m_number->isRefused() || unfinishedText()) && !isOther;
    m_raw = *value;
    m_boardRaw = onBoard.value_or(*value);
    m_updating = true;
    if (!keepsText)
        showValue(*value);
    if (!keepsText && m_number && m_number->isRefused())
        m_number->goBack();
    m_updating = false;
    const bool changed = !sameValue(m_raw, m_boardRaw);
    markChanged(m_control, changed);
    m_reset->setVisible(changed);
    const QString board = isKnown ? parameterValueText(m_spec, m_boardRaw) : unknownText();
    if (changed && !isKnown) {
        const QString text = tr("Discard the change. What the board has is not known now.");
        m_reset->setToolTip(text);
        m_reset->setAccessibleName(text);
    } else if (changed) {
        m_reset->setToolTip(tr("The board has %1. Discard the change.").arg(board));
        m_reset->setAccessibleName(tr("Discard the change; the board has %1").arg(board));
    }
    QString remarks;
    for (const QString &remark : {m_contradiction, m_inactive}) {
        if (!remark.isEmpty())
            remarks += u'\n' + remark;
    }
    // A long entry is cut where the window is small.
    const QString chosen = m_choice ? m_choice->currentText() + u'\n' : QString();
    m_control->setToolTip(chosen
                          + u"%1\n%2%3%4"_s.arg(tableText(m_spec.row->help), parameterRangeText(m_spec),
                                                changed ? tr("\nOn the board: %1").arg(board) : QString(),
                                                remarks));
    m_control->setAccessibleDescription(tableText(m_spec.row->help) + remarks);
}

void ValueEditor::showFigure(std::optional<double> figure)
{
    if (!m_figure)
        return;
    m_figure->setText(figure ? tr("≙ %1 in the text").arg(shortNumberText(*figure))
                             : tr("not told by the text"));
    m_figure->setToolTip(tr("The text that the board keeps has another number for this value."));
}

std::optional<QString> ValueEditor::refusedText() const
{
    return m_number && m_number->isRefused() ? std::optional(m_number->typed()) : std::nullopt;
}

void ValueEditor::showRefused(const std::optional<QString> &text)
{
    if (!m_number || refusedText() == text)
        return;
    m_updating = true;
    if (text)
        m_number->type(*text);
    else
        m_number->goBack();
    m_updating = false;
}

std::optional<QString> ValueEditor::unfinishedText() const
{
    const auto *line = m_number ? m_number->findChild<QLineEdit *>() : nullptr;
    return line && line->isModified() ? std::optional(m_number->typed()) : std::nullopt;
}

void ValueEditor::goOnTyping(const QString &text)
{
    if (m_number)
        m_number->goOnTyping(text);
}

void ValueEditor::setInactive(const QString &reason)
{
    if (reason == std::exchange(m_inactive, reason))
        return;
    m_control->setProperty("inactive", !reason.isEmpty());
    repolish(m_control);
}

void ValueEditor::setContradiction(const QString &text)
{
    if (text == std::exchange(m_contradiction, text))
        return;
    m_control->setProperty("conflict", !text.isEmpty());
    repolish(m_control);
}

void ValueEditor::forgetTyping()
{
    m_updating = true;
    if (unfinishedText())
        m_number->goBack();
    m_updating = false;
}

void ValueEditor::showValue(double raw)
{
    if (m_number) {
        m_number->showRaw(raw);
    } else if (m_choice) {
        int index = m_choice->findData(int(raw));
        if (index < 0) {
            m_choice->addItem(tr("Unknown (%1)").arg(int(raw)), int(raw));
            index = m_choice->count() - 1;
        }
        m_choice->setCurrentIndex(index);
    } else if (m_toggle) {
        m_toggle->setChecked(raw != 0);
    } else if (m_flags) {
        updateFlagsText(raw);
    }
}

void ValueEditor::updateFlagsText(double raw)
{
    for (QAction *action : m_flagsMenu->actions())
        action->setChecked(flagBits(raw) & (1U << action->data().toInt()));
    m_flags->setWords(parameterValueText(m_spec, raw));
}

bool ValueEditor::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::FocusIn)
        emit focused();
    // Undo and redo belong to the configuration, not to the text of one field.
    if (event->type() == QEvent::ShortcutOverride) {
        const auto *key = static_cast<QKeyEvent *>(event);
        if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
            event->ignore();
            return true;
        }
    }
    // The wheel scrolls the page unless the control has the focus.
    if (event->type() == QEvent::Wheel && !m_control->hasFocus()) {
        event->ignore();
        return true;
    }
    return QWidget::eventFilter(watched, event);
}
