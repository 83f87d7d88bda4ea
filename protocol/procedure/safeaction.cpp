// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedure/safeaction.h"

#include <algorithm>

using namespace Qt::StringLiterals;

Result<ActionOutcome> performSafely(Channel &channel, Device &device, const QString &key, const QVariantMap &arguments,
                                    const BoardHistory &history)
{
    const auto actions = device.actions();
    const auto it = std::find_if(actions.begin(), actions.end(),
                                 [&key](const ActionSpec &action) { return key == QLatin1String(action.key); });
    if (it == actions.end())
        return failure(ErrorCode::Unsupported, key);
    if (!device.identity().writable && it->risk != ActionRisk::Safe)
        return failure(ErrorCode::ReadOnly, device.identity().firmware);
    ActionOutcome outcome;
    if (it->risk == ActionRisk::Writes || it->risk == ActionRisk::Destroys) {
        const auto configuration = device.readConfiguration(channel);
        if (!configuration)
            return failure(ErrorCode::NoBackup, configuration.error().detail);
        auto path = history.save(*configuration, u"before "_s + key);
        if (!path)
            return tl::unexpected(path.error());
        outcome.snapshotPath = *path;
    }
    auto reply = device.perform(channel, key, arguments);
    if (!reply)
        return tl::unexpected(reply.error());
    outcome.reply = std::move(*reply);
    return outcome;
}
