// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedure/safeaction.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

// The path of the snapshot, empty if the risk requires none.
Result<QString> backupFor(Channel &channel, Device &device, ActionRisk risk, const QString &reason,
                          const BoardHistory &history, const LiveValues &live)
{
    if (!device.identity().writable && risk != ActionRisk::Safe)
        return failure(ErrorCode::ReadOnly, device.identity().firmware);
    if (risk != ActionRisk::Writes && risk != ActionRisk::Destroys)
        return QString();
    const auto configuration = device.readConfiguration(channel);
    if (!configuration)
        return tl::unexpected(configuration.error());  // the board's own error; nothing was sent yet
    // What cannot be read over this link at all is no reason to forbid everything.
    for (const MissingPart &part : configuration->missing()) {
        if (part.why.code != ErrorCode::Unsupported)
            return failure(ErrorCode::NoBackup,
                           u"%1 could not be read"_s.arg(configuration->partName(part.key)));
    }
    return history.save(withoutLive(*configuration, live), reason);
}

// Older telemetry does not show the present state.
constexpr auto kFresh = 2s;

Result<void> checkCondition(Condition condition, const Device &device, const LatestValues *latest,
                            TimePoint now)
{
    struct Row
    {
        bool wanted;
        QString unmet;
        QString unknown;
    };
    const int channel = channelOf(condition, rolesOf(device));
    const Row row = condition == Condition::Disarmed
        ? Row{false, u"the board is armed"_s, u"whether the board is armed"_s}
        : condition == Condition::Calibrated
        ? Row{true, u"the sensors are not calibrated"_s, u"whether the sensors are calibrated"_s}
        : Row{false, u"the motors are running"_s, u"whether the motors are running"_s};
    const bool told = latest && channel >= 0 && now - latest->latestAt(channel) < kFresh
        && !std::isnan(latest->latest(channel));
    if (!told)
        return failure(ErrorCode::ConditionUnmet, u"nothing tells %1"_s.arg(row.unknown));
    if ((latest->latest(channel) != 0.0F) != row.wanted)
        return failure(ErrorCode::ConditionUnmet, row.unmet);
    return {};
}

}  // namespace

int channelOf(Condition condition, const ChannelRoles &roles)
{
    switch (condition) {
    case Condition::Disarmed: return roles.armed;
    case Condition::Calibrated: return roles.calibrated;
    case Condition::MotorsOff: return roles.outputs;
    }
    return -1;
}

Result<ActionOutcome> performSafely(Channel &channel, Device &device, const QString &key,
                                    const QVariantMap &arguments, const BoardHistory &history,
                                    const LiveValues &live, const LatestValues *latest)
{
    const auto actions = device.actions();
    const auto it = std::find_if(actions.begin(), actions.end(), [&key](const ActionSpec &action) {
        return key == QLatin1String(action.key);
    });
    if (it == actions.end())
        return failure(ErrorCode::Unsupported, key);
    for (const Condition condition : it->needs) {
        if (const auto met = checkCondition(condition, device, latest, channel.now()); !met)
            return tl::unexpected(met.error());
    }
    ActionOutcome outcome;
    auto path = backupFor(channel, device, it->risk, u"before "_s + key, history, live);
    if (!path)
        return tl::unexpected(path.error());
    outcome.snapshotPath = *path;
    if (it->silence > 0ms)
        channel.expectSilence(it->silence);
    auto reply = device.perform(channel, key, arguments);
    if (!reply)
        return tl::unexpected(reply.error());
    outcome.reply = std::move(*reply);
    // A board without a serial number that was renamed here keeps its history.
    if (const QString look = outcome.reply.take(BoardHistory::kLook).toString(); !look.isEmpty()) {
        if (const auto kept
            = history.follow(device.identity(), look, outcome.reply.value(u"name"_s).toString());
            !kept)
            return tl::unexpected(kept.error());
    }
    // A calibration whose confirmation never came says so itself.
    outcome.answered = it->answered && outcome.reply.value(u"confirmed"_s, true).toBool();
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
