// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/views/inputbars.h"

#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"
#include "widgets/views/stickbar.h"

#include <QCollator>
#include <QGridLayout>
#include <QLabel>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr double kForgets = 0.1;  // of the difference, with each value
constexpr double kMoves = 8;  // % away from where it has been

}  // namespace

InputBars::InputBars(const Theme &theme, QWidget *parent)
    : QWidget(parent)
    , m_theme(theme)
    , m_grid(new QGridLayout(this))
    , m_nothing(new QLabel(tr("No input has a signal.")))
{
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(12);
    m_grid->setVerticalSpacing(4);
    m_grid->setColumnStretch(1, 1);
    m_nothing->setObjectName(u"muted"_s);
    m_nothing->setWordWrap(true);
    m_grid->addWidget(m_nothing, 0, 0, 1, 3);
}

void InputBars::setValues(const QMap<QString, double> &percents)
{
    const bool areSame = percents.size() == qsizetype(m_rows.size())
        && std::all_of(m_rows.begin(), m_rows.end(),
                       [&percents](const auto &row) { return percents.contains(row.first); });
    if (!areSame)
        makeRows(percents.keys());
    for (auto &[name, row] : m_rows) {
        const double now = percents.value(name);
        row.slow = areSame ? row.slow + kForgets * (now - row.slow) : now;
        row.bar->setValue(now / 100, now / 100);
        row.percent->setText(tr("%1 %").arg(numberText(now, 0)));
        QFont font = this->font();
        font.setBold(std::abs(now - row.slow) > kMoves);
        row.name->setFont(font);
    }
}

void InputBars::setInputs(const QVariantMap &reply)
{
    QMap<QString, double> percents;
    for (auto it = reply.begin(); it != reply.end(); ++it)
        percents.insert(it.key().section(u'.', 1), it.value().toDouble());
    setValues(percents);
}

void InputBars::makeRows(const QStringList &names)
{
    for (auto &[name, row] : m_rows) {
        for (QWidget *widget : std::initializer_list<QWidget *>{row.name, row.bar, row.percent})
            delete widget;
    }
    m_rows.clear();
    QStringList sorted = names;
    QCollator order;
    order.setNumericMode(true);
    std::sort(sorted.begin(), sorted.end(), order);
    QFont bold = font();
    bold.setBold(true);
    int at = 1;
    for (const QString &name : std::as_const(sorted)) {
        const QString text = tableText(name.toUtf8().constData());
        Row row{new QLabel(text), new StickBar(m_theme, false), new QLabel};
        row.name->setMinimumWidth(QFontMetrics(bold).horizontalAdvance(text));
        row.bar->setAccessibleName(text);
        row.percent->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        row.percent->setMinimumWidth(fontMetrics().horizontalAdvance(u"-100 %  "_s));
        m_grid->addWidget(row.name, at, 0);
        m_grid->addWidget(row.bar, at, 1);
        m_grid->addWidget(row.percent, at++, 2);
        m_rows.emplace(name, row);
    }
    m_nothing->setVisible(names.isEmpty());
}

double InputBars::value(const QString &name) const
{
    const auto found = m_rows.find(name);
    return found == m_rows.end() ? std::nan("") : 100 * found->second.bar->value();
}

bool InputBars::isMoving(const QString &name) const
{
    const auto found = m_rows.find(name);
    return found != m_rows.end() && found->second.name->font().bold();
}
