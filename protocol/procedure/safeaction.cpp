// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedure/safeaction.h"

#include "protocol/base/linkloss.h"
#include "protocol/configuration/aftermath.h"
#include "protocol/device/flight.h"
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
    if (!now)
        return error;
    error = settled(std::move(error), withoutLive(*std::move(now), live));
    // A restart in the middle has put it back, or somebody else.
    if (error.code == ErrorCode::NotRestored && error.after->changes().empty()
        && error.after->dataChanges().empty())
        error.code = ErrorCode::NotSeen;
    return error;
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
    if (!isUntold(both.error()) && both.error().code != ErrorCode::Disabled)
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

// Storing changes nothing that is in use: where it has changed, the board has started anew, or switched its
// profile, and what it has stored is not what was meant.
Result<void> checkStillUsed(Channel &channel, Device &device, const std::vector<AdjustableValue> &before)
{
    if (before.empty())
        return {};
    const auto now = device.live()->readAllAdjustables(channel);
    if (!now)
        return tl::unexpected(now.error());
    QHash<int, double> is;
    for (const AdjustableValue &value : *now)
        is.insert(value.id, value.value);
    QStringList different;
    for (const AdjustableValue &was : before) {
        const double value = is.value(was.id, was.value);
        const auto &all = device.parameters()->all();
        const auto spec = std::find_if(
            all.begin(), all.end(), [&was](const ParameterSpec &each) { return each.adjustable == was.id; });
        if (value != was.value && spec != all.end())
            different.append(u"%1 was %2 in use and is %3 now"_s.arg(
                spec->key, spec->format(spec->rawOf(was.value)), spec->format(spec->rawOf(value))));
    }
    return different.isEmpty() ? Result<void>() : failure(ErrorCode::NotStored, different.join(u"; "_s));
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

// Older telemetry does not show the present state; a board that has just been connected tells it within that
// time.
constexpr auto kFresh = 2s;
constexpr auto kLookAgain = 50ms;

std::optional<bool> freshFlag(int channel, const LatestValues *latest, TimePoint now)
{
    const bool told = latest && channel >= 0 && now - latest->latestAt(channel) < kFresh
        && !std::isnan(latest->latest(channel));
    return told ? std::optional(latest->latest(channel) != 0.0F) : std::nullopt;
}

Result<void> checkCondition(Channel &board, Condition condition, const Device &device,
                            const LatestValues *latest)
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
    std::optional<bool> is = freshFlag(channel, latest, board.now());
    for (const TimePoint begun = board.now();
         !is && latest && channel >= 0 && board.now() - begun < kFresh;) {
        if (const auto waited = board.sleep(kLookAgain); !waited)
            return tl::unexpected(waited.error());
        is = freshFlag(channel, latest, board.now());
    }
    if (!is)
        return failure(ErrorCode::ConditionUnmet, u"nothing tells %1"_s.arg(row.unknown));
    if (*is != row.wanted)
        return failure(ErrorCode::ConditionUnmet, row.unmet);
    return {};
}

// An action, from the safety copy to what the board says that it holds since.
class SafeAction
{
public:
    SafeAction(Channel &channel, Device &device, const ActionSpec &action, const QVariantMap &arguments,
               const BoardHistory &history, const LiveValues &live)
        : m_channel(channel)
        , m_device(device)
        , m_action(action)
        , m_key(QLatin1String(action.key))
        , m_arguments(arguments)
        , m_history(history)
        , m_live(live)
    {
        const bool isOverwriting
            = action.memory == MemoryEffect::Stores || action.memory == MemoryEffect::Erases;
        m_memory = isOverwriting && device.identity().writable ? device.wholeMemory() : nullptr;
    }

    Result<ActionOutcome> perform()
    {
        if (const auto backedUp = backUp(); !backedUp)
            return tl::unexpected(backedUp.error());
        if (const auto asked = askBefore(); !asked)
            return tl::unexpected(asked.error());
        auto reply = act();
        if (!reply && m_backup && !isOwn(reply.error()))
            return tl::unexpected(withAftermath(reply.error(), m_channel, m_device, *m_backup, m_live));
        if (!reply)
            return tl::unexpected(reply.error());
        m_outcome.reply = *std::move(reply);
        if (const auto kept = keepHistory(); !kept)
            return tl::unexpected(kept.error());
        askAfter();
        if (const auto stored = prove(); !stored)
            return tl::unexpected(stored.error());
        return std::move(m_outcome);
    }

private:
    Result<void> backUp();
    Result<void> askBefore();
    Result<ActionReply> act();
    Result<void> keepHistory();
    void askAfter();
    Result<void> prove();

    Channel &m_channel;
    Device &m_device;
    const ActionSpec &m_action;
    const QString m_key;
    const QVariantMap &m_arguments;
    const BoardHistory &m_history;
    const LiveValues &m_live;
    WholeMemory *m_memory = nullptr;  // of an action that overwrites it
    Backup m_backup;
    std::optional<Configuration> m_wanted;  // to be stored
    std::optional<Configuration> m_usedBefore;  // and to be replaced by what is stored
    std::vector<AdjustableValue> m_valuesBefore;  // in use, and to be stored
    std::optional<bool> m_ranBefore;
    bool m_tellsApart = false;  // the board was seen to answer with what is stored, not with what is in use
    ActionOutcome m_outcome;
};

Result<void> SafeAction::backUp()
{
    const auto take = [this](Result<Backup> saved) {
        return std::move(saved).map([this](Backup backup) { m_backup = std::move(backup); });
    };
    if (m_memory) {
        m_outcome.stored.emplace();
        if (auto saved
            = take(backUpStored(m_channel, *m_memory, u"before "_s + m_key, m_history, *m_outcome.stored));
            !saved)
            return saved;
        if (m_action.memory == MemoryEffect::Erases)
            m_outcome.stored.reset();
    }
    if (!m_backup) {
        if (auto saved = take(backupFor(m_channel, m_device, m_action.risk, m_key, m_history, m_live));
            !saved)
            return saved;
    }
    if (!m_backup)
        return {};
    m_outcome.snapshotPath = m_backup->snapshotPath;
    m_backup->endedBy = QLatin1String(m_action.endedBy);
    // Nor is a file of the board.
    const bool isOfFiles = m_key.startsWith(u"file."_s) || m_key.startsWith(u"script."_s);
    m_backup->isUnseen = !m_action.isShown || isOfFiles;
    m_backup->isUnstored = m_action.memory == MemoryEffect::ChangesInUse;
    m_backup->isStoring = m_memory && m_action.memory == MemoryEffect::Stores;
    m_backup->isStoreUntold = m_action.memory == MemoryEffect::Stores && !m_memory;
    return {};
}

// What is in use, whoever has put it there, and whether motors run.
Result<void> SafeAction::askBefore()
{
    if (m_memory && m_action.memory == MemoryEffect::Stores) {
        auto inUse = m_device.readConfiguration(m_channel);
        if (!inUse)
            return tl::unexpected(inUse.error());
        m_wanted = *std::move(inUse);
    }
    if (m_action.memory == MemoryEffect::Stores && !m_memory && m_backup)
        m_tellsApart = !checkActiveStored(m_channel, m_device, m_backup->before);
    if (m_action.memory == MemoryEffect::Stores && !m_memory && m_device.live()) {
        if (auto values = m_device.live()->readAllAdjustables(m_channel))
            m_valuesBefore = *std::move(values);
    }
    // What is erased stays in use; where a restart came in between, it does not.
    const bool mayLose = m_action.memory == MemoryEffect::Reloads || m_action.memory == MemoryEffect::Erases;
    if (mayLose && m_device.wholeMemory()) {
        if (auto inUse = m_device.readConfiguration(m_channel))
            m_usedBefore = *std::move(inUse);
    }
    if (m_action.risk != ActionRisk::Safe && !m_action.switchesMotors)
        m_ranBefore = motorsIfTold(m_channel, m_device);
    return {};
}

Result<ActionReply> SafeAction::act()
{
    if (m_action.silence > 0ms)
        m_channel.expectSilence(m_action.silence);
    Result<ActionReply> reply = failure(ErrorCode::Unsupported);
    const auto perform = [&] {
        reply = m_device.perform(m_channel, m_key, m_arguments);
        return reply.has_value();
    };
    // A board that tunes itself changes values as well as an operator does.
    if (LiveAccess *access
        = m_action.isProcedure && m_action.risk == ActionRisk::Writes ? m_device.live() : nullptr)
        access->noteChangesBy(m_channel, perform);
    else
        perform();
    // Only the answer may have been lost.
    if (!reply && reply.error().code == ErrorCode::Timeout && m_action.risk == ActionRisk::Moves)
        addDetail(reply.error().detail,
                  m_action.switchesMotors ? u"the motors may run, or start yet"_s
                                          : u"the board may have carried it out: the camera may be moving"_s);
    if (!reply && !isLinkLoss(reply.error()) && reply.error().code != ErrorCode::Cancelled) {
        if (const auto run = findMotorsChanged(m_channel, m_device, m_ranBefore))
            addDetail(reply.error().detail, motorsChangedText(*run));
    }
    return reply;
}

// A board without a serial number that was renamed here keeps its history.
Result<void> SafeAction::keepHistory()
{
    const QString look = m_outcome.reply.take(BoardHistory::kLook).toString();
    if (look.isEmpty())
        return {};
    return m_history.follow(m_device.identity(), look, m_outcome.reply.value(u"name"_s).toString());
}

void SafeAction::askAfter()
{
    // A calibration whose confirmation never came says so itself.
    m_outcome.answered
        = m_action.answered && m_action.isShown && m_outcome.reply.value(u"confirmed"_s, true).toBool();
    // So does one by hand.
    if (!m_action.letsGo && !m_outcome.reply.contains(u"motors_switched_off"_s))
        m_outcome.motorsNow = findMotorsChanged(m_channel, m_device, m_ranBefore);
    if (m_usedBefore)
        m_outcome.lost = changedSince(m_channel, m_device, *m_usedBefore);
}

// An acknowledgement proves nothing: the board is asked what it has stored.
Result<void> SafeAction::prove()
{
    if (m_action.memory == MemoryEffect::Stores && !m_memory && m_backup) {
        if (const auto stored = checkActiveStored(m_channel, m_device, m_backup->before); !stored)
            return tl::unexpected(withKnown(stored.error(), *m_backup));
        if (const auto used = checkStillUsed(m_channel, m_device, m_valuesBefore); !used)
            return tl::unexpected(withKnown(used.error(), *m_backup));
        m_outcome.isStoreUntold = !m_tellsApart && !m_action.provesStore;
    }
    if (!m_wanted)
        return {};
    const auto proven = proveStored(m_channel, *m_memory, *m_wanted, m_backup, m_outcome);
    if (proven)
        return {};
    return tl::unexpected(m_backup->now
                              ? withKnown(proven.error(), *m_backup)
                              : withAftermath(proven.error(), m_channel, m_device, *m_backup, m_live));
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
        if (const auto met = checkCondition(channel, condition, device, latest); !met)
            return tl::unexpected(met.error());
    }
    return SafeAction(channel, device, action, arguments, history, live).perform();
}

Result<bool> sendRaw(Channel &channel, Device &device, const RawCommand &command, const BoardHistory &history,
                     const LiveValues &live)
{
    // What flies refuses hardly anything by itself (BCFlight errata 9.1).
    if (device.flight() && device.identity().writable) {
        if (const auto may = device.flight()->checkMayTake(channel, command); !may)
            return tl::unexpected(may.error());
    }
    if (const auto backup = backupFor(channel, device, command.risk, command.name, history, live); !backup)
        return tl::unexpected(backup.error());
    Request request;
    request.name = command.name;
    request.bytes = command.bytes;
    channel.post(request);
    return true;
}
