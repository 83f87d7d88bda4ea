// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/setup/livefigures.h"

#include "app/workspace/workspace.h"
#include "widgets/models/channelmodel.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"
#include "widgets/views/card.h"
#include "widgets/views/stalecover.h"

#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr int kColumnWidth = 110;

}  // namespace

LiveFigures::LiveFigures(Workspace &workspace, QWidget *parent)
    : QWidget(parent)
    , m_workspace(workspace)
    , m_body(new QWidget)
    , m_grid(new QGridLayout(m_body))
{
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setHorizontalSpacing(16);
    auto *card = new Card(tr("What the board tells now"));
    card->content()->addWidget(m_body);
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(card);
    workspace.freshness().watch(*new StaleCover(workspace.theme(), *m_body, StaleCover::Look::Fade), [this] {
        QList<int> channels;
        for (const Figure &figure : m_figures)
            channels.append(figure.channel);
        return channels;
    });
}

void LiveFigures::showStep(SetupStep step)
{
    m_figures.clear();
    qDeleteAll(m_body->findChildren<QLabel *>());
    if (m_workspace.tables()) {
        const ChannelRoles &roles = m_workspace.client().roles();
        int row = 0;
        for (const SetupLiveSpec &spec : setupLive()) {
            if (spec.step == step)
                addRow(spec, roles, ++row);
        }
        const bool isOfAxes = std::ranges::any_of(
            m_figures, [](const Figure &figure) { return figure.spec->triple != nullptr; });
        if (isOfAxes)
            addHeads();
    }
    setVisible(!m_figures.empty());
    refresh();
}

void LiveFigures::addHeads()
{
    for (const Axis axis : kAxes) {
        auto *head = new QLabel(axisLabel(axis));
        head->setObjectName(u"muted"_s);
        head->setAlignment(Qt::AlignRight);
        m_grid->addWidget(head, 0, 1 + int(axis));
    }
}

void LiveFigures::addRow(const SetupLiveSpec &spec, const ChannelRoles &roles, int row)
{
    const auto channels = spec.channels(roles);
    if (std::ranges::all_of(channels, [](int channel) { return channel < 0; }))
        return;
    m_grid->addWidget(new QLabel(tableText(spec.label)), row, 0);
    for (std::size_t i = 0; i < channels.size(); ++i) {
        if (channels[i] < 0)
            continue;
        auto *value = new QLabel;
        value->setAlignment(Qt::AlignRight);
        value->setMinimumWidth(kColumnWidth);
        m_grid->addWidget(value, row, 1 + int(i));
        m_figures.push_back({&spec, channels[i], value});
    }
    m_grid->setColumnStretch(int(kAxisCount) + 1, 1);
}

QString LiveFigures::valueText(const Figure &figure) const
{
    const auto store = m_workspace.client().telemetry();
    const Device *device = m_workspace.tables();
    if (!store || !device)
        return u"–"_s;
    const ChannelSpec &spec = device->channels()[std::size_t(figure.channel)];
    const QString unit = *spec.unit ? u' ' + QString::fromUtf8(spec.unit) : QString();
    const auto value = figure.spec->value(*store, figure.channel);
    if (!value)
        return u"–"_s;
    return (figure.spec->isSpread ? numberText(*value, kSpreadDecimals) : channelValueText(spec, *value))
        + unit;
}

void LiveFigures::refresh()
{
    for (const Figure &figure : m_figures) {
        const QString text = valueText(figure);
        if (figure.label->text() != text)
            figure.label->setText(text);
    }
}

QString LiveFigures::text(const char *label) const
{
    QStringList texts;
    for (const Figure &figure : m_figures) {
        if (QLatin1String(figure.spec->label) == QLatin1String(label))
            texts.append(figure.label->text());
    }
    return texts.join(u' ');
}
