// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedure/safeaction.h"

#include "protocol/base/linkloss.h"
#include "protocol/configuration/aftermath.h"
#include "protocol/procedure/inuse.h"
#include "protocol/procedure/motorsnow.h"
#include "protocol/procedure/wholewrite.h"

#include <QSet>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace Qt::StringLiterals;

namespace {

// The safety copy, and where it lies.
using Backup = std::optional<Aftermath>;

// What is stored is about to be overwritten, by what is in use or by nothing: the snapshot holds it. Empty
// where only what is in use can be told.
Result<Backup> backUpStored(Channel &channel, WholeMemory &memory, const QString &reason,
                            const BoardHistory &history, WriteReport &report)
{
    const auto both = memory.readBoth(channel);
    if (both) {
        report.othersWere = OtherValues::Store;
        listOthers(*both, memory.movedBy(both->inUse), report);
        return history.save(both->stored, reason).map([&both](const QString &path) {
            return Backup({path, both->stored});
        });
    }
    if (both.error().code == ErrorCode::Unready || !isUntold(both.error()))
        return tl::unexpected(both.error());
    report.othersUnknown = both.error();
    return Backup();
}

// Empty if the risk requires none.
Result<Backup> backupFor(Channel &channel, Device &device, ActionRisk risk, const QString &key,
                         const BoardHistory &history, const LiveValues &live)
{
    if (!device.identity().writable && risk != ActionRisk::Safe)
        return failure(ErrorCode::ReadOnly, device.identity().firmware);
    if (risk != ActionRisk::Writes && risk != ActionRisk::Destroys)
        return Backup();
    const auto configuration = device.readConfiguration(channel);
    if (!configuration)
        return tl::unexpected(configuration.error());  // the board's own error; nothing was sent yet
    // What cannot be read over this link at all is no reason to forbid everything.
    for (const MissingPart &part : configuration->missing()) {
        if (part.why.code != ErrorCode::Unsupported)
            return failure(ErrorCode::NoBackup,
                           u"%1 could not be read"_s.arg(configuration->partName(part.key)));
    }
    Configuration before = withoutLive(*configuration, live);
    const auto path = history.save(before, u"before "_s + key);
    if (!path)
        return tl::unexpected(path.error());
    // What a sensor is calibrated to is no parameter.
    const bool isBlind = key.startsWith(u"calibrat"_s);
    return Backup({*path, std::move(before), device.wholeMemory() != nullptr, {}, isBlind});
}

QString valueIn(const Configuration &configuration, const ParameterSpec &spec)
{
    const auto raw = configuration.raw(spec, configuration.activeProfile());
    return raw ? spec.format(*raw) : u"?"_s;
}

// Errors that come before anything was sent.
bool isOwn(const Error &error)
{
    return error.code == ErrorCode::InvalidArgument || error.code == ErrorCode::OutOfRange
        || error.code == ErrorCode::Unsupported || error.code == ErrorCode::ReadOnly
        || error.code == ErrorCode::NotConnected;
}

// What the board holds is what it says afterwards, whatever the action has said.
Error withAftermath(Error error, Channel &channel, Device &device, const Aftermath &backup,
                    const LiveValues &live)
{
    error.after = std::make_shared<const Aftermath>(backup);
    if (isLinkLoss(error) || error.code == ErrorCode::Cancelled)
        return error;  // whoever asked for it reads the board later
    if (!backup.isInUse && device.wholeMemory()) {
        auto both = device.wholeMemory()->readBoth(channel);
        return both ? settled(std::move(error), std::move(both->stored)) : error;
    }
    auto now = device.readConfiguration(channel);
    return now ? settled(std::move(error), withoutLive(*std::move(now), live)) : error;
}

Error withKnown(Error error, const Aftermath &backup)
{
    error.after = std::make_shared<const Aftermath>(backup);
    return error;
}

// What was in use before everything was stored, and what the board says that it holds since.
Result<void> checkStored(WholeMemory &memory, const Configuration &wanted, const WholeMemory::Contents &now)
{
    const auto movedBefore = memory.movedBy(wanted);
    const auto moved = memory.movedBy(now.inUse);
    QStringList different;
    for (const ParameterChange &change : wanted.changesTo(now.stored)) {
        if (!movedBefore.contains(change.spec->key) && !moved.contains(change.spec->key))
            different.append(u"%1 is %2 in use and %3 where it is stored"_s.arg(
                change.spec->key, valueIn(now.inUse, *change.spec), change.spec->format(change.to)));
    }
    for (const DataChange &change : wanted.dataChangesTo(now.stored))
        different.append(u"%1 in use are not the stored ones"_s.arg(QLatin1String(change.spec->data)));
    return different.isEmpty() ? Result<void>() : failure(ErrorCode::NotStored, different.join(u"; "_s));
}

// An acknowledgement proves nothing: the board is asked what it has stored.
Result<void> proveStored(Channel &channel, WholeMemory &memory, const Configuration &wanted, Backup &backup,
                         ActionOutcome &outcome)
{
    const auto both = readBothOnceReady(channel, memory);
    if (both) {
        if (backup && !backup->isInUse)
            backup->now = both->stored;
        return checkStored(memory, wanted, *both);
    }
    // A motor's usage is not where it was to be stored.
    if (both.error().code == ErrorCode::ConditionUnmet)
        return failure(ErrorCode::NotStored, both.error().detail);
    // Nor while the motors are being stopped.
    if (!isUntold(both.error()) && both.error().code != ErrorCode::Busy)
        return tl::unexpected(both.error());
    outcome.answered = false;
    outcome.reply.insert(u"unproven"_s, both.error().detail);
    outcome.stored.reset();  // nor are those known to be stored that were not before
    return {};
}

// What a script moves by itself is nobody's loss.
std::vector<ParameterChange> changedSince(Channel &channel, Device &device, const Configuration &before)
{
    const auto now = device.readConfiguration(channel);
    if (!now)
        return {};
    auto changes = before.changesTo(*now);
    const auto moved = device.wholeMemory()->movedBy(*now);
    std::erase_if(changes,
                  [&moved](const ParameterChange &change) { return moved.contains(change.spec->key); });
    return changes;
}

// A board that keeps what is stored apart, and was told to store what is in use in the active profile: what
// it holds since is read. One that answers with what is in use proves nothing, and contradicts nothing.
Result<void> checkActiveStored(Channel &channel, Device &device, Configuration before)
{
    QSet<int> blocks;
    for (const ParameterSpec &spec : before.parameters().all()) {
        if (spec.adjustable >= 0)
            blocks.insert(spec.row->block);
    }
    std::vector<BlockKey> keys;
    for (const auto &[key, bytes] : before.blocks())
        keys.push_back(key);
    for (const BlockKey key : keys) {
        if (key.profile != before.activeProfile() || !blocks.contains(key.block))
            continue;
        if (const auto bytes = device.readBlock(channel, key))
            before.setBlock(key, *bytes);
        else if (isLinkLoss(bytes.error()))
            return tl::unexpected(bytes.error());
    }
    QStringList different;
    for (const OtherValue &value : readReplaceable(channel, device, before))
        different.append(u"%1 is %2 in use and %3 where it is stored"_s.arg(
            value.spec->key, value.spec->format(value.inUse), value.spec->format(value.stored)));
    return different.isEmpty() ? Result<void>() : failure(ErrorCode::NotStored, different.join(u"; "_s));
}

// Older telemetry does not show the present state.
constexpr auto kFresh = 2s;

std::optional<bool> freshFlag(int channel, const LatestValues *latest, TimePoint now)
{
    const bool told = latest && channel >= 0 && now - latest->latestAt(channel) < kFresh
        && !std::isnan(latest->latest(channel));
    return told ? std::optional(latest->latest(channel) != 0.0F) : std::nullopt;
}

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
    const std::optional<bool> is = freshFlag(channel, latest, now);
    if (!is)
        return failure(ErrorCode::ConditionUnmet, u"nothing tells %1"_s.arg(row.unknown));
    if (*is != row.wanted)
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

std::optional<bool> motorsRun(const Device &device, const LatestValues *latest, TimePoint now)
{
    return freshFlag(rolesOf(device).outputs, latest, now);
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
    const ActionSpec action = chosenAction(*it, arguments);
    for (const Condition condition : action.needs) {
        if (const auto met = checkCondition(condition, device, latest, channel.now()); !met)
            return tl::unexpected(met.error());
    }
    ActionOutcome outcome;
    const bool isOverwriting = action.memory == MemoryEffect::Stores || action.memory == MemoryEffect::Erases;
    WholeMemory *memory = isOverwriting && device.identity().writable ? device.wholeMemory() : nullptr;
    Backup backup;
    if (memory) {
        outcome.stored.emplace();
        auto saved = backUpStored(channel, *memory, u"before "_s + key, history, *outcome.stored);
        if (!saved)
            return tl::unexpected(saved.error());
        backup = *std::move(saved);
        if (action.memory == MemoryEffect::Erases)
            outcome.stored.reset();
    }
    if (!backup) {
        auto saved = backupFor(channel, device, action.risk, key, history, live);
        if (!saved)
            return tl::unexpected(saved.error());
        backup = *std::move(saved);
    }
    if (backup) {
        outcome.snapshotPath = backup->snapshotPath;
        backup->isUnstored = action.memory == MemoryEffect::ChangesInUse;
        backup->isStoreUntold = action.memory == MemoryEffect::Stores && !memory;
    }
    std::optional<Configuration> wanted;
    if (memory && action.memory == MemoryEffect::Stores) {
        auto inUse = device.readConfiguration(channel);
        if (!inUse)
            return tl::unexpected(inUse.error());
        wanted = *std::move(inUse);
    }
    // Whoever has put it into use.
    const bool isReloading = action.memory == MemoryEffect::Reloads && device.wholeMemory();
    const auto usedBefore = isReloading ? device.readConfiguration(channel) : failure(ErrorCode::Unsupported);
    if (action.silence > 0ms)
        channel.expectSilence(action.silence);
    const bool isWatched = action.risk != ActionRisk::Safe && !action.switchesMotors;
    const auto ranBefore = isWatched ? askMotors(channel, device) : std::nullopt;
    Result<ActionReply> reply = failure(ErrorCode::Unsupported);
    const auto perform = [&] {
        reply = device.perform(channel, key, arguments);
        return reply.has_value();
    };
    // A board that tunes itself changes values as well as an operator does.
    if (LiveAccess *access
        = action.isProcedure && action.risk == ActionRisk::Writes ? device.live() : nullptr)
        access->noteChangesBy(channel, perform);
    else
        perform();
    if (!reply && !isLinkLoss(reply.error()) && reply.error().code != ErrorCode::Cancelled) {
        if (const auto run = findMotorsChanged(channel, device, ranBefore))
            reply.error().detail
                += (reply.error().detail.isEmpty() ? QString() : u"; "_s) + motorsChangedText(*run);
    }
    if (!reply && backup && !isOwn(reply.error()))
        return tl::unexpected(withAftermath(reply.error(), channel, device, *backup, live));
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
    outcome.answered
        = action.answered && action.isShown && outcome.reply.value(u"confirmed"_s, true).toBool();
    // A calibration by hand says so itself.
    if (!action.letsGo && !outcome.reply.contains(u"motors_switched_off"_s))
        outcome.motorsNow = findMotorsChanged(channel, device, ranBefore);
    if (usedBefore)
        outcome.lost = changedSince(channel, device, *usedBefore);
    if (action.memory == MemoryEffect::Stores && !memory && backup) {
        if (const auto stored = checkActiveStored(channel, device, backup->before); !stored)
            return tl::unexpected(withKnown(stored.error(), *backup));
    }
    if (wanted) {
        if (const auto proven = proveStored(channel, *memory, *wanted, backup, outcome); !proven)
            return tl::unexpected(backup->now
                                      ? withKnown(proven.error(), *backup)
                                      : withAftermath(proven.error(), channel, device, *backup, live));
    }
    return outcome;
}

Result<bool> sendRaw(Channel &channel, Device &device, const RawCommand &command, const BoardHistory &history,
                     const LiveValues &live)
{
    if (const auto backup = backupFor(channel, device, command.risk, command.name, history, live); !backup)
        return tl::unexpected(backup.error());
    Request request;
    request.name = command.name;
    request.bytes = command.bytes;
    channel.post(request);
    return true;
}
