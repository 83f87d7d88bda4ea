// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/forms/helpcard.h"

#include "widgets/models/parametermodel.h"
#include "widgets/theme/theme.h"

#include <QLabel>
#include <QVBoxLayout>

#include <utility>

using namespace Qt::StringLiterals;

HelpCard::HelpCard(ConfigurationModel &configuration, QWidget *parent)
    : QFrame(parent)
    , m_configuration(configuration)
    , m_title(new QLabel)
    , m_help(new QLabel)
    , m_facts(new QLabel)
{
    setObjectName(u"card"_s);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(Metric::kMargin, Metric::kMargin, Metric::kMargin, Metric::kMargin);
    layout->setSpacing(Metric::kGap);
    m_title->setObjectName(u"title"_s);
    m_facts->setObjectName(u"muted"_s);
    m_facts->setTextFormat(Qt::RichText);
    for (QLabel *label : {m_title, m_help, m_facts}) {
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
        layout->addWidget(label);
    }
    layout->addStretch(1);
    connect(&m_configuration, &ConfigurationModel::boardReset, this, [this] { show(-1); });
    connect(&m_configuration, &ConfigurationModel::valueChanged, this, &HelpCard::refresh);
    connect(&m_configuration, &ConfigurationModel::shownProfileChanged, this, &HelpCard::refresh);
    refresh();
}

void HelpCard::show(int parameter)
{
    m_parameter = parameter;
    refresh();
}

void HelpCard::refresh()
{
    if (m_parameter < 0 || m_configuration.isEmpty()) {
        m_title->setText(tr("What a value does"));
        m_help->setText(
            tr("Choose a field to see its effect, range, default and the value on the board here."));
        m_facts->clear();
        return;
    }
    const ParameterSpec &spec = m_configuration.edited().parameters().at(m_parameter);
    m_title->setText(parameterLabel(spec));
    m_help->setText(tableText(spec.row->help));
    QStringList lines;
    const auto line = [&lines](const QString &name, const QString &value) {
        lines.append(
            u"<tr><td style='padding-right:12px'>%1</td><td>%2</td></tr>"_s.arg(name, value.toHtmlEscaped()));
    };
    const int profile = m_configuration.shownProfile();
    if (const auto board = m_configuration.boardValue(spec, profile))
        line(tr("On the board"),
             std::as_const(m_configuration).board().findMissing(spec, profile)
                 ? unknownText()
                 : parameterQuantityText(spec, *board));
    if (!spec.row->state)
        line(tr("Default"), parameterQuantityText(spec, spec.defaultRaw));
    if (const QString range = parameterRangeText(spec); !range.isEmpty())
        line(tr("Range"), range);
    if (std::as_const(m_configuration).board().identity().profileCount > 1)
        line(tr("Belongs to"), spec.row->scope == Scope::Board ? tr("the whole board") : tr("this profile"));
    line(tr("Key"), spec.key);
    QString facts = u"<table>%1</table>"_s.arg(lines.join(QString()));
    if (const QString text = contradictionText(m_configuration, spec, profile); !text.isEmpty())
        facts += u"<p><b>"_s + text.toHtmlEscaped() + u"</b></p>"_s;
    if (const QString inactive = inactiveReason(m_configuration, spec, m_configuration.shownProfile());
        !inactive.isEmpty())
        facts += u"<p>"_s + inactive.toHtmlEscaped() + u"</p>"_s;
    if (spec.row->risk == Risk::Red)
        facts += u"<p>"_s + tr("⚠ Risk: a wrong value can make a motor run away or overheat.") + u"</p>"_s;
    m_facts->setText(facts);
}
