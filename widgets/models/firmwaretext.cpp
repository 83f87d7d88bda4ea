// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/firmwaretext.h"

#include <QCoreApplication>

using namespace Qt::StringLiterals;

namespace {

struct FirmwareText
{
    Q_DECLARE_TR_FUNCTIONS(FirmwareText)
};

// Commands of the console alone are left out: whoever sends them by hand finds them there.
QString countsText(const FirmwareStep &step)
{
    QStringList parts;
    const auto add = [&parts](const QStringList &keys, const QString &text) {
        if (!keys.isEmpty())
            parts.append(text);
    };
    const auto count = [](const QStringList &keys) { return int(keys.size()); };
    add(step.parameters, FirmwareText::tr("%n parameter(s)", nullptr, count(step.parameters)));
    add(step.actions, FirmwareText::tr("%n action(s)", nullptr, count(step.actions)));
    add(step.variables, FirmwareText::tr("%n live variable(s)", nullptr, count(step.variables)));
    add(step.modes, FirmwareText::tr("%n way(s) of steering", nullptr, count(step.modes)));
    add(step.streams, FirmwareText::tr("%n stream(s)", nullptr, count(step.streams)));
    add(step.channels, FirmwareText::tr("%n channel(s) of live data", nullptr, count(step.channels)));
    return parts.join(u", "_s);
}

}  // namespace

QString gainText(const std::vector<FirmwareStep> &steps)
{
    FirmwareStep all;
    for (const FirmwareStep &step : steps) {
        all.parameters += step.parameters;
        all.actions += step.actions;
        all.variables += step.variables;
        all.modes += step.modes;
        all.streams += step.streams;
        all.channels += step.channels;
    }
    const QString counts = countsText(all);
    return counts.isEmpty() ? QString() : FirmwareText::tr("Newer firmware would bring: %1.").arg(counts);
}

QString stepsText(const std::vector<FirmwareStep> &steps)
{
    QStringList lines;
    for (const FirmwareStep &step : steps) {
        const QString version
            = step.isAbout ? FirmwareText::tr("about %1").arg(step.firmware) : step.firmware;
        QStringList parts;
        if (const QString counts = countsText(step); !counts.isEmpty())
            parts.append(counts);
        if (!step.gone.isEmpty())
            parts.append(FirmwareText::tr("%n parameter(s) no longer", nullptr, int(step.gone.size())));
        if (!parts.isEmpty())
            lines.append(version + u": "_s + parts.join(u", "_s));
    }
    return lines.join(u'\n');
}
