// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedure/safeaction.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

// The path of the snapshot, empty where the risk needs none.
Result<QString> backupFor(Channel &channel, Device &device, ActionRisk risk, const QString &reason,
                          const BoardHistory &history, const LiveValues &live)
{
    if (!device.identity().writable && risk != ActionRisk::Safe)
        return failure(ErrorCode::ReadOnly, device.identity().firmware);
    if (risk != ActionRisk::Writes && risk != ActionRisk::Destroys)
        return QString();
    const auto configuration = device.readConfiguration(channel);
    if (!configuration)
        return tl::unexpected(configuration.error());  // the board's own reason; nothing was sent yet
    return history.save(withoutLive(*configuration, live), reason);
}

}  // namespace

Result<ActionOutcome> performSafely(Channel &channel, Device &device, const QString &key,
                                    const QVariantMap &arguments, const BoardHistory &history,
                                    const LiveValues &live)
{
    const auto actions = device.actions();
    const auto it = std::find_if(actions.begin(), actions.end(), [&key](const ActionSpec &action) {
        return key == QLatin1String(action.key);
    });
    if (it == actions.end())
        return failure(ErrorCode::Unsupported, key);
    ActionOutcome outcome;
    auto path = backupFor(channel, device, it->risk, u"before "_s + key, history, live);
    if (!path)
        return tl::unexpected(path.error());
    outcome.snapshotPath = *path;
    auto reply = device.perform(channel, key, arguments);
    if (!reply)
        return tl::unexpected(reply.error());
    outcome.reply = std::move(*reply);
    return outcome;
}

Result<bool> sendRaw(Channel &channel, Device &device, const RawCommand &command, const BoardHistory &history,
                     const LiveValues &live)
{
    if (const auto path
        = backupFor(channel, device, command.risk, u"before "_s + command.name, history, live);
        !path)
        return tl::unexpected(path.error());
    Request request;
    request.name = command.name;
    request.bytes = command.bytes;
    channel.post(request);
    return true;
}
