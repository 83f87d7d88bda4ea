// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/result.h"
#include "protocol/telemetry/channelspec.h"

#include <QByteArray>
#include <QList>

/// Which plots there are and what each shows, as it is kept under a name.
struct PlotLayout
{
    struct Plot
    {
        QList<int> channels;
        bool ownScales = false;
        bool figures = false;
        friend bool operator==(const Plot &, const Plot &) = default;
    };
    QList<Plot> plots;
    double seconds = 0;  ///< shown; 0 = as it is

    [[nodiscard]] QByteArray toJson(ChannelTable table) const;
    /// What this board has of a kept layout: unknown channels are left out, and plots without any. Anything
    /// unreadable is an empty layout.
    [[nodiscard]] static PlotLayout fromJson(const QByteArray &json, ChannelTable table);
    /// Whether a kept layout can be read at all. Errors: BadFile.
    [[nodiscard]] static Result<void> check(const QByteArray &json, const QString &name);
    /// One plot for each unit: values of different kinds do not share a picture unless somebody wants it.
    [[nodiscard]] static PlotLayout byUnit(ChannelTable table, const QList<int> &channels);
};
