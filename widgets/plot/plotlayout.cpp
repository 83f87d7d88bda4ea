// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/plotlayout.h"

#include "protocol/base/jsonplace.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>

using namespace Qt::StringLiterals;

QByteArray PlotLayout::toJson(ChannelTable table) const
{
    QJsonArray list;
    for (const Plot &plot : plots) {
        QJsonArray channels;
        for (const int channel : plot.channels)
            channels.append(QLatin1String(table[std::size_t(channel)].key));
        list.append(QJsonObject{
            {u"channels"_s, channels}, {u"ownScales"_s, plot.ownScales}, {u"figures"_s, plot.figures}});
    }
    return QJsonDocument(QJsonObject{{u"plots"_s, list}, {u"seconds"_s, seconds}})
        .toJson(QJsonDocument::Compact);
}

PlotLayout PlotLayout::fromJson(const QByteArray &json, ChannelTable table)
{
    PlotLayout layout;
    const QJsonObject object = QJsonDocument::fromJson(json).object();
    layout.seconds = std::clamp(object.value(u"seconds"_s).toDouble(), 0.0, 3600.0);
    const QJsonArray plots = object.value(u"plots"_s).toArray();
    for (const QJsonValue value : plots) {
        Plot plot;
        plot.ownScales = value[u"ownScales"_s].toBool();
        plot.figures = value[u"figures"_s].toBool();
        const QJsonArray keys = value[u"channels"_s].toArray();
        for (const QJsonValue key : keys) {
            const int channel = findChannel(table, key.toString());
            if (channel >= 0 && !plot.channels.contains(channel))
                plot.channels.append(channel);
        }
        if (!plot.channels.isEmpty())
            layout.plots.append(plot);
    }
    return layout;
}

Result<void> PlotLayout::check(const QByteArray &json, const QString &name)
{
    QJsonParseError parse;
    const QJsonDocument document = QJsonDocument::fromJson(json, &parse);
    if (!document.isObject())
        return tl::unexpected(inFile(jsonFault(json, parse, FileKind::Layout).error(), name));
    if (!document.object().value(u"plots"_s).isArray())
        return fileFailure({.problem = FileProblem::MissingEntry,
                            .kind = FileKind::Layout,
                            .path = name,
                            .key = u"plots"_s});
    if (const auto once = checkOnce(json, FileKind::Layout); !once)
        return tl::unexpected(inFile(once.error(), name));
    return {};
}

PlotLayout PlotLayout::byUnit(ChannelTable table, const QList<int> &channels)
{
    PlotLayout layout;
    for (const int channel : channels) {
        const auto same = [&](const Plot &plot) {
            return qstrcmp(table[std::size_t(plot.channels.first())].unit, table[std::size_t(channel)].unit)
                == 0;
        };
        const auto plot = std::find_if(layout.plots.begin(), layout.plots.end(), same);
        if (plot == layout.plots.end())
            layout.plots.append({{channel}, false, false});
        else
            plot->channels.append(channel);
    }
    return layout;
}
