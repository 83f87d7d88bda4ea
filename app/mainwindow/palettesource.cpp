// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/palettesource.h"

#include "app/mainwindow/navigation.h"
#include "app/mainwindow/pagetable.h"
#include "app/pages/setup/parameterspage.h"
#include "app/pages/watch/monitorpage.h"
#include "widgets/models/parametermodel.h"

#include <QKeySequence>

using namespace Qt::StringLiterals;

namespace {

PaletteEntry makeEntry(const QString &kind, const QString &text, const QString &hint, const QString &more,
                       std::function<void()> chosen)
{
    return {kind, text, hint, (kind + u' ' + text + u' ' + hint + u' ' + more).toLower(), std::move(chosen)};
}

}  // namespace

QList<PaletteEntry> paletteEntries(Workspace &workspace, const Navigation &navigation,
                                   const PaletteTargets &targets)
{
    const auto showPage = targets.showPage;
    QList<PaletteEntry> entries;
    for (const PageEntry &page : pageTable()) {
        const QString key = QLatin1String(page.key);
        if (!navigation.isOffered(key))
            continue;
        entries.append(makeEntry(CommandPalette::tr("Page"), pageText(page.title), pageText(page.group), key,
                                 [showPage, key] { showPage(key); }));
    }
    entries.append(makeEntry(CommandPalette::tr("Command"), CommandPalette::tr("Stop motors"), u"F12"_s, {},
                             [&workspace] { workspace.setMotors(false); }));
    entries.append(makeEntry(CommandPalette::tr("Command"), CommandPalette::tr("Messages so far"), {}, {},
                             targets.showMessages));
    entries.append(makeEntry(CommandPalette::tr("Command"), CommandPalette::tr("Open a file"),
                             CommandPalette::tr("configuration, recording, black box"), {},
                             targets.openFile));
    if (workspace.client().isConnected()) {
        // A drone is armed on its own page, or not at all.
        const Device *board = workspace.client().device();
        if (board && board->motorSwitch())
            entries.append(makeEntry(CommandPalette::tr("Command"), CommandPalette::tr("Start motors"), {},
                                     {}, targets.startMotors));
        entries.append(makeEntry(CommandPalette::tr("Command"), CommandPalette::tr("Read the board again"),
                                 QKeySequence(QKeySequence::Refresh).toString(QKeySequence::NativeText), {},
                                 [&workspace] { workspace.readBoard(); }));
    }
    if (!workspace.configuration().isEmpty()) {
        entries.append(makeEntry(CommandPalette::tr("Command"), CommandPalette::tr("Review and write"),
                                 u"Ctrl+S"_s, {}, targets.review));
        entries.append(makeEntry(CommandPalette::tr("Command"), CommandPalette::tr("Take a snapshot"), {}, {},
                                 [&workspace] { workspace.takeSnapshot(); }));
        for (const ParameterSpec &spec :
             std::as_const(workspace.configuration()).board().parameters().all()) {
            if (spec.row->state)
                continue;
            entries.append(
                makeEntry(CommandPalette::tr("Parameter"), parameterLabel(spec), spec.key,
                          tableText(spec.row->group), [showPage, key = spec.key] {
                              static_cast<ParametersPage *>(showPage(u"parameters"_s))->showParameter(key);
                          }));
        }
    }
    const Device *device = workspace.client().device();
    if (!device)
        return entries;
    const ChannelTable channels = device->channels();
    for (std::size_t i = 0; i < channels.size(); ++i) {
        entries.append(makeEntry(
            CommandPalette::tr("Channel"), tableText(channels[i].label), QLatin1String(channels[i].key),
            tableText(channels[i].group), [showPage, channel = int(i)] {
                ChannelModel &model = static_cast<MonitorPage *>(showPage(u"monitor"_s))->channels();
                QList<int> ticked = model.ticked();
                if (!ticked.contains(channel))
                    model.setTicked(ticked << channel);
            }));
    }
    for (const ActionSpec &action : device->actions()) {
        entries.append(makeEntry(
            CommandPalette::tr("Action"), tableText(action.label), QLatin1String(action.key),
            tableText(action.help),
            [showAction = targets.showAction, key = QString::fromLatin1(action.key)] { showAction(key); }));
    }
    return entries;
}
