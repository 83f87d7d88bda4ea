// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/forms/argumentform.h"

#include "widgets/forms/formrows.h"
#include "widgets/forms/numberbox.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"
#include "widgets/theme/theme.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

constexpr int kNumberWidth = 72;

}  // namespace

ArgumentForm::ArgumentForm(const ActionSpec &action, const QStringList &hidden, QWidget *parent)
    : QWidget(parent)
    , m_action(action)
{
    auto *layout = new QFormLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(Metric::kGap);
    layout->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
    for (const ArgumentSpec &argument : action.arguments) {
        if (hidden.contains(QLatin1String(argument.key)))
            continue;
        QWidget *field = makeField(argument);
        QString label = tableText(argument.label);
        field->setAccessibleName(label);
        field->setObjectName(QLatin1String(argument.key));
        field->setMaximumWidth(Metric::kFieldWidth);
        auto *name = new QLabel(label);
        name->setBuddy(field);
        layout->addRow(name, field);
        m_fields.insert(QLatin1String(argument.key), field);
    }
    alignLabels(*layout);
}

QWidget *ArgumentForm::makeField(const ArgumentSpec &argument)
{
    const QString standard = QLatin1String(argument.defaultText);
    switch (argument.kind) {
    case ArgumentKind::Choice: {
        auto *box = new QComboBox;
        for (const Choice &choice : argument.choices)
            box->addItem(tableText(choice.name), QString::number(choice.value));
        for (int i = 0; i < box->count(); ++i) {
            if (QLatin1String(argument.choices[std::size_t(i)].name) == standard)
                box->setCurrentIndex(i);
        }
        return box;
    }
    case ArgumentKind::Toggle: {
        auto *box = new QCheckBox;
        box->setChecked(standard == u"on"_s);
        return box;
    }
    case ArgumentKind::Text: {
        auto *line = new QLineEdit(standard);
        return line;
    }
    case ArgumentKind::Integer:
    case ArgumentKind::Real: break;
    }
    const int decimals = argument.kind == ArgumentKind::Integer ? 0 : 2;
    // An argument that may be left out ("nan") is an empty field with a hint.
    if (standard == u"nan"_s) {
        auto *box = new NumberBox(argument.min, argument.max, decimals);
        box->setEmptyAllowed(true,
                             tr("leave alone (%1 to %2 %3)")
                                 .arg(shortNumberText(argument.min))
                                 .arg(shortNumberText(argument.max))
                                 .arg(QString::fromUtf8(argument.unit)));
        box->setValue(std::clamp(0.0, argument.min, argument.max));
        box->setButtonSymbols(QAbstractSpinBox::NoButtons);
        box->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        box->clear();
        return box;
    }
    auto *box = new NumberBox(argument.min, argument.max, decimals,
                              *argument.unit ? u' ' + QString::fromUtf8(argument.unit) : QString());
    box->setMinimumWidth(kNumberWidth);  // by its range alone it would take the width of one digit
    box->setValue(standard.toDouble());
    box->setToolTip(tr("%1 to %2").arg(shortNumberText(argument.min), shortNumberText(argument.max)));
    return box;
}

void ArgumentForm::setText(const QString &key, const QString &text)
{
    QWidget *field = m_fields.value(key);
    if (auto *line = qobject_cast<QLineEdit *>(field))
        line->setText(text);
    else if (auto *number = qobject_cast<NumberBox *>(field)) {
        number->type(text);
        number->settle();
    } else if (auto *box = qobject_cast<QCheckBox *>(field))
        box->setChecked(text == u"on"_s);
    else if (auto *choice = qobject_cast<QComboBox *>(field))
        choice->setCurrentIndex(choice->findData(text));
}

Result<QVariantMap> ArgumentForm::arguments() const
{
    QMap<QString, QString> texts;
    for (auto it = m_fields.begin(); it != m_fields.end(); ++it) {
        QString text;
        if (auto *number = qobject_cast<NumberBox *>(it.value()); number && !number->settle())
            return failure(ErrorCode::OutOfRange, u"%1: %2"_s.arg(it.key(), number->text()));
        if (const auto *line = qobject_cast<QLineEdit *>(it.value()))
            text = line->text().trimmed();
        else if (const auto *number = qobject_cast<NumberBox *>(it.value()))
            text = number->isEmpty() ? QString() : QString::number(number->value(), 'f', number->decimals());
        else if (const auto *box = qobject_cast<QCheckBox *>(it.value()))
            text = box->isChecked() ? u"on"_s : u"off"_s;
        else if (const auto *choice = qobject_cast<QComboBox *>(it.value()))
            text = choice->currentData().toString();
        if (!text.isEmpty())
            texts.insert(it.key(), text);
    }
    return parseArguments(m_action, texts);
}
