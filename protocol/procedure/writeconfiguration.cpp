// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedure/writeconfiguration.h"

#include "protocol/procedure/inuse.h"
#include "protocol/procedure/motorsnow.h"
#include "protocol/procedure/writer.h"

#include <algorithm>
#include <tuple>

using namespace Qt::StringLiterals;

namespace {

// A board that has confirmed the write goes down within this time; also the interval of asking whether it is
// back.
constexpr milliseconds kRestartPause = 1s;
constexpr int kStoringAttempts = 4;

}  // namespace

Result<WriteReport> Writer::run()
{
    if (!m_device.identity().writable)
        return failure(ErrorCode::ReadOnly, m_device.identity().firmware);
    m_changes = m_base.changesTo(m_edited);
    m_data = m_base.dataChangesTo(m_edited);
    m_report.namesWanted = m_names.isWanted();
    if (m_options.contents)
        m_whole.start(*m_options.contents, m_report);
    // What is in use as wanted may not be stored so.
    if (const auto read = m_options.named.isEmpty() ? Result<void>() : m_whole.read(m_report); !read)
        return tl::unexpected(read.error());
    addNamed();
    m_report.before = m_base;
    m_report.wanted = m_edited;
    m_report.onBoard = m_base;
    for (const ParameterChange &change : m_changes)
        m_report.lines.push_back(
            {change.spec, change.profile, change.from, change.to, WriteState::NotWritten, change.from});
    for (const DataChange &change : m_data)
        m_report.data.push_back({change.spec, change.key, WriteState::NotWritten});
    if (m_changes.empty() && m_data.empty() && !m_names.isWanted())
        return m_report;
    if (const auto checked = m_edited.checkRules(m_base); !checked)
        return tl::unexpected(checked.error());
    collectBlocks();
    if (const auto read = readWhole(); !read)
        return tl::unexpected(read.error());
    if (const auto saved = backUp(); !saved)
        return tl::unexpected(saved.error());
    if (const auto read = readBoard(); !read)
        return tl::unexpected(read.error());
    if (const auto checked = checkConflicts(); !checked)
        return tl::unexpected(checked.error());
    if (const auto checked = checkProfile(); !checked)
        return tl::unexpected(checked.error());
    if (const auto checked = m_whole.isKnown() ? m_whole.check(patchedBlocks()) : Result<void>(); !checked)
        return tl::unexpected(checked.error());

    std::vector<const ParameterSpec *> changed;
    for (const ParameterChange &change : m_changes)
        changed.push_back(change.spec);
    m_ranBefore = askMotorsBefore(m_channel, m_device, changed);
    readOthers();
    auto result = writeBlocks();
    if (result && m_whole.isUntellable() && !m_keys.empty())
        result = m_whole.readAfterAll(m_report);
    if (result)
        result = verify();
    if (result)
        result = m_names.write(m_report);
    if (!result)
        finishReport(result.error());
    else
        settleProfile();
    if (result || !isLinkGone(result.error())) {
        tellReplaced();
        lookForRestart();
    }
    if (result && m_report.storedUntold)
        leaveUntold();
    if (result && m_report.strayProfile)
        m_report.error = Error{ErrorCode::NoEffect, u"the active profile is another than before"_s, 0};
    const int active = m_base.activeProfile();
    m_report.storesUse
        = answersWithUse(m_device)
        && std::any_of(m_report.lines.begin(), m_report.lines.end(), [this, active](const WriteLine &line) {
               return line.profile == active
                   && specOf({line.profile, line.spec->row->block}).effect != WriteEffect::Volatile
                   && (line.state == WriteState::Verified || line.state == WriteState::RolledBack
                       || line.state == WriteState::Unknown);
           });
    m_report.wasSent = !m_written.empty() || m_report.namesWanted;
    const auto back = m_whole.finish(m_report);
    m_report.areOthersUnknown = !back && !m_report.others.empty();
    if (!back && !m_report.error)
        m_report.error = back.error();
    else if (!back && !isLinkGone(*m_report.error))
        addDetail(m_report.error->detail,
                  u"what was in use before is not in use again: "_s + back.error().detail);
    return m_report;
}

// What was read back is in use, which says nothing about what is stored.
void Writer::leaveUntold()
{
    m_report.error = m_report.storedUntold;
    for (const BlockKey key : m_written)
        markBlock(key, WriteState::Unknown);
}

// What is wanted in use, and stored already, is a change for the board all the same.
void Writer::addNamed()
{
    const bool mayBeUnstored = m_options.evenIfInUse && answersWithUse(m_device);
    if (m_report.othersUnknown || mayBeUnstored) {
        for (const ParameterSpec &spec : m_base.parameters().all()) {
            const auto raw = m_base.raw(spec, m_base.activeProfile());
            const bool isTold = !m_report.othersUnknown && m_device.live()->variableOf(spec) < 0;
            if (m_options.named.contains(spec.key) && raw && !isTold
                && sameValue(m_edited.raw(spec, m_base.activeProfile()), raw))
                m_changes.push_back({&spec, m_base.activeProfile(), *raw, *raw});
        }
    }
    if (!m_whole.isKnown())
        return;
    for (const ParameterChange &change : m_whole.inUse().changesTo(m_edited)) {
        const bool isStored = sameValue(m_base.raw(*change.spec, change.profile), change.to);
        if (isStored && m_options.named.contains(change.spec->key))
            m_changes.push_back(change);
    }
    for (const DataChange &change : m_whole.inUse().dataChangesTo(m_edited)) {
        const bool isStored = m_base.block(change.key) == change.to;
        if (isStored && m_options.named.contains(QLatin1String(change.spec->data)))
            m_data.push_back(change);
    }
    m_whole.setWanted(m_changes, m_data, m_report);
}

// Where nobody can tell what is stored, what is in use is all there is; the report says so.
Result<void> Writer::readWhole()
{
    if (const auto read = m_whole.read(m_report); !read)
        return read;
    m_whole.setWanted(m_changes, m_data, m_report);
    return {};
}

Result<void> Writer::backUp()
{
    // Of a text that is written each state has a copy: what stood in it cannot be guessed afterwards.
    if (m_options.backupDone && m_data.empty())
        return {};
    if (!m_options.history)
        return failure(ErrorCode::NoBackup);
    auto fresh = m_whole.isKnown() ? Result<Configuration>(m_whole.kept())
                                   : m_device.readConfiguration(m_channel).map([this](Configuration read) {
                                         return withoutLive(std::move(read), m_options.live);
                                     });
    if (!fresh)
        return tl::unexpected(fresh.error());
    // What the copy lacks could not be brought back.
    for (const MissingPart &part : fresh->missing()) {
        const bool isTouched = part.key.block == MissingPart::kProfileNames
            ? m_names.isWanted()
            : std::find(m_keys.begin(), m_keys.end(), part.key) != m_keys.end();
        if (isTouched)
            return failure(ErrorCode::NoBackup, u"%1 could not be read"_s.arg(fresh->partName(part.key)));
    }
    auto path = m_options.history->save(*fresh, u"before the first write"_s);
    if (!path)
        return tl::unexpected(path.error());
    m_report.snapshotPath = *path;
    for (const MissingPart &part : fresh->missing())
        m_report.snapshotLacks.append(fresh->partName(part.key));
    return {};
}

// Board-wide values are shared by all profiles, so one block would do; but every block that is written
// carries them and must not write the old ones back.
void Writer::collectBlocks()
{
    std::set<BlockKey> keys;
    for (const ParameterChange &change : m_changes)
        keys.insert({change.profile, change.spec->row->block});
    for (const DataChange &change : m_data)
        keys.insert(change.key);
    m_keys.assign(keys.begin(), keys.end());
    const int active = m_base.activeProfile();
    std::stable_partition(m_keys.begin(), m_keys.end(),
                          [active](BlockKey key) { return key.profile != active; });
    const auto after = std::stable_partition(m_keys.begin(), m_keys.end(),
                                             [this](BlockKey key) { return !restarts(key); });
    if (after != m_keys.end())  // what a restart would lose follows it
        std::stable_partition(m_keys.begin(), m_keys.end(), [this](BlockKey key) { return !isLost(key); });
}

Result<void> Writer::readBoard()
{
    for (const BlockKey key : m_keys) {
        report(u"read-block"_s, key);
        if (m_whole.isKnown()) {
            m_board[key] = m_whole.origin().block(key);
            continue;
        }
        auto bytes = m_device.readBlock(m_channel, key);
        if (!bytes)
            return tl::unexpected(bytes.error());
        m_answered[key] = *bytes;
        m_board[key] = asStored(key, std::move(*bytes), m_options.live);
    }
    return {};
}

// What such a board answers for the active profile may be what is in use.
QByteArray Writer::asStored(BlockKey key, QByteArray bytes, const LiveValues &live) const
{
    if (key.profile != m_base.activeProfile() || m_device.wholeMemory())
        return bytes;
    return withoutLive(std::move(bytes), key.block, m_base.parameters(), live);
}

// A button on the board, or a remote control, may have switched it since. Writing would switch it back.
Result<void> Writer::checkProfile()
{
    ProfileAccess *profiles = m_device.profiles();
    const int wanted = m_base.activeProfile();
    const int active = profiles ? profiles->activeProfile(m_channel).value_or(wanted) : wanted;
    if (active == wanted)
        return {};
    return failure(ErrorCode::Conflict,
                   u"profile %1 is in use now, and was profile %2 when the board was read"_s.arg(active + 1)
                       .arg(wanted + 1));
}

Result<void> Writer::checkConflicts() const
{
    QStringList conflicts;
    for (const ParameterChange &change : m_changes) {
        const auto now = change.spec->read(boardNow({change.profile, change.spec->row->block}));
        if (now && !sameValue(*now, change.from) && !sameValue(*now, change.to)
            && !isKnownLive(change, *now)) {
            conflicts.append(u"%1: %2, read as %3, now %4"_s.arg(
                m_base.profileName(change.profile), change.spec->key, change.spec->format(change.from),
                change.spec->format(*now)));
        }
    }
    for (const DataChange &change : m_data) {
        if (const QByteArray now = boardNow(change.key); now != change.from && now != change.to
            && !(m_whole.isKnown() && m_whole.inUse().block(change.key) == change.from))
            conflicts.append(u"%1 was changed meanwhile"_s.arg(QLatin1String(change.spec->data)));
    }
    if (const auto names = m_names.check(conflicts); !names)
        return names;
    if (conflicts.isEmpty())
        return {};
    return failure(ErrorCode::Conflict, conflicts.join(u"; "_s));
}

QByteArray Writer::boardNow(BlockKey key) const
{
    return m_whole.isKnown() ? m_whole.kept().block(key) : m_board.at(key);
}

// It was read as it was in use: by this program, or because somebody had set it before the board was read.
bool Writer::isKnownLive(const ParameterChange &change, double now) const
{
    const bool wasInUse
        = m_whole.isKnown() && sameValue(m_whole.inUse().raw(*change.spec, change.profile), change.from);
    return wasInUse || std::any_of(m_options.live.begin(), m_options.live.end(), [&](const LiveValue &value) {
               return value.key == change.spec->key && sameValue(value.inUse, now);
           });
}

QByteArray Writer::patched(BlockKey key) const
{
    const auto started = m_started.find(key);
    QByteArray bytes = started == m_started.end() ? m_board.at(key) : started->second;
    for (const DataChange &change : m_data) {
        if (change.key == key)
            return change.to;
    }
    for (const ParameterChange &change : m_changes) {
        const bool boardWide = change.spec->row->scope == Scope::Board;
        const int source = boardWide ? m_edited.activeProfile() : change.profile;
        if (change.spec->row->block == key.block && (boardWide || change.profile == key.profile))
            change.spec->copy(bytes, m_edited.block({source, key.block}));
    }
    return bytes;
}

std::map<BlockKey, QByteArray> Writer::patchedBlocks() const
{
    std::map<BlockKey, QByteArray> blocks;
    for (const BlockKey key : m_keys)
        blocks[key] = patched(key);
    return blocks;
}

Result<void> Writer::writeBlocks()
{
    if (m_keys.empty())
        return {};
    if (m_whole.isKnown())
        return writeWhole();
    if (const auto written = writeBracketed(); !written)
        return written;
    if (const auto written = writeRestarting(); !written)
        return written;
    if (const auto written = writeLost(); !written)
        return written;
    if (m_keys.back().profile != m_base.activeProfile())
        return selectActive();
    return {};
}

Result<void> Writer::writeBracketed()
{
    if (restarts(m_keys.front()))
        return {};
    if (const auto begun = begin(); !begun)
        return begun;
    m_bracketOpen = true;
    for (const BlockKey key : m_keys) {
        if (restarts(key))
            break;
        report(u"write-block"_s, key);
        // Until it is read back, it is unknown what the board holds.
        markBlock(key, WriteState::Unknown);
        m_written.insert(key);
        if (const auto written = put(key, patched(key)); !written)
            return written;
    }
    if (const auto ended = end(); !ended)
        return ended;
    m_bracketOpen = false;
    return {};
}

Result<void> Writer::writeWhole()
{
    if (const auto begun = begin(); !begun)
        return begun;
    m_bracketOpen = true;
    const std::map<BlockKey, QByteArray> blocks = patchedBlocks();
    for (const BlockKey key : m_keys) {
        report(u"write-block"_s, key);
        markBlock(key, WriteState::Unknown);
        m_written.insert(key);
    }
    const auto stored = storeWhole([this, &blocks] { return m_whole.use(blocks); });
    for (WriteLine &line : m_report.lines)
        line.setBy = m_whole.setter(line.spec->key);
    return stored;
}

// A script may set a value between putting it into use and storing it; the next time it may not.
Result<void> Writer::storeWhole(const std::function<Result<void>()> &put)
{
    for (int attempt = 1;; ++attempt) {
        if (const auto used = put(); !used)
            return used;
        if (const auto ended = end(); !ended)
            return ended;
        m_bracketOpen = false;
        if (const auto read = m_whole.readAgain(); !read)
            return read;
        if (!m_whole.isDisturbed() || attempt == kStoringAttempts)
            return {};
    }
}

// Outside the bracket, which the restart would end.
Result<void> Writer::writeRestarting()
{
    for (const BlockKey key : m_keys) {
        if (!restarts(key))
            continue;
        report(u"write-block"_s, key);
        markBlock(key, WriteState::Unknown);
        m_written.insert(key);
        if (const auto written = put(key, patched(key)); !written)
            return written;
    }
    return {};
}

// What is in use only until the board restarts, once it is back: onto what it has started with.
Result<void> Writer::writeLost()
{
    const auto first
        = std::find_if(m_keys.begin(), m_keys.end(), [this](BlockKey key) { return restarts(key); });
    for (auto it = first; it != m_keys.end(); ++it) {
        if (restarts(*it))
            continue;
        auto started = fetch(*it);
        if (!started)
            return tl::unexpected(started.error());
        m_started[*it] = std::move(*started);
        report(u"write-block"_s, *it);
        markBlock(*it, WriteState::Unknown);
        m_written.insert(*it);
        if (const auto written = put(*it, patched(*it)); !written)
            return written;
    }
    return {};
}

// Writes a block; if that restarts the board, returns once the board is back.
Result<void> Writer::put(BlockKey key, const QByteArray &bytes)
{
    if (!restarts(key)) {
        const TimePoint sent = m_channel.now();
        const auto written = m_device.writeBlock(m_channel, key, bytes);
        if (written)
            noteSilence(sent);
        else
            noteGone(written.error());
        return written;
    }
    const milliseconds absence = specOf(key).restartTime > 0ms ? specOf(key).restartTime : kRestartLimit;
    m_channel.expectSilence(absence);
    const auto written = m_device.writeBlock(m_channel, key, bytes);
    // A board that restarts at once cannot confirm. What it holds is read when it is back.
    const bool mayBeRestarting = written || written.error().code == ErrorCode::Timeout
        || written.error().code == ErrorCode::LinkClosed;
    if (!mayBeRestarting)
        return written;
    m_backBy = m_channel.now() + absence;
    report(u"await-restart"_s, key);
    if (const auto slept = m_channel.sleep(kRestartPause);
        !slept && slept.error().code == ErrorCode::Cancelled)
        return slept;
    const auto back = fetch(key);
    if (!back)
        return tl::unexpected(back.error());
    // It is there, and holds what it held: it was silent for another reason than a restart.
    const bool wasMissed = !written && written.error().code == ErrorCode::Timeout && *back == m_board.at(key)
        && *back != bytes;
    return wasMissed ? written : Result<void>();
}

// Reads a block; a restarting board gets time to come back. On a closed link no time passes, so the number of
// attempts is limited as well.
Result<QByteArray> Writer::fetch(BlockKey key)
{
    for (auto attempts = (m_backBy - m_channel.now()) / kRestartPause;; --attempts) {
        const TimePoint asked = m_channel.now();
        auto bytes = m_device.readBlock(m_channel, key);
        if (bytes && !m_written.empty() && asked >= m_backBy)
            noteSilence(asked);
        if (!bytes && asked >= m_backBy)
            noteGone(bytes.error());
        if (bytes || bytes.error().code == ErrorCode::Cancelled || attempts <= 0
            || m_channel.now() >= m_backBy)
            return bytes;
        if (const auto slept = m_channel.sleep(kRestartPause);
            !slept && slept.error().code == ErrorCode::Cancelled)
            return tl::unexpected(slept.error());
    }
}

Result<void> Writer::begin()
{
    WriteBracket *bracket = m_device.writeBracket();
    return bracket ? bracket->beginWrite(m_channel) : Result<void>();
}

Result<void> Writer::end()
{
    WriteBracket *bracket = m_device.writeBracket();
    return bracket ? bracket->endWrite(m_channel) : Result<void>();
}

Result<void> Writer::selectActive()
{
    ProfileAccess *profiles = m_device.profiles();
    return profiles ? profiles->selectProfile(m_channel, m_base.activeProfile()) : Result<void>();
}

void Writer::markBlock(BlockKey key, WriteState state)
{
    for (WriteLine &line : m_report.lines) {
        if (line.spec->row->block == key.block && line.profile == key.profile)
            line.state = state;
    }
    for (WriteData &data : m_report.data) {
        if (data.key == key)
            data.state = state;
    }
}

void Writer::report(const QString &step, BlockKey key)
{
    Progress progress;
    progress.done = m_done++;
    const auto restarting
        = std::count_if(m_keys.begin(), m_keys.end(), [this](BlockKey k) { return restarts(k); });
    progress.total = int(3 * m_keys.size() + std::size_t(restarting));
    progress.step = step;
    progress.subject = QLatin1String(specOf(key).name);
    progress.profile = m_base.identity().profileCount > 1 ? key.profile : -1;
    m_channel.progress(progress);
}

Result<WriteReport> writeConfiguration(Channel &channel, Device &device, const Configuration &base,
                                       const Configuration &edited, const WriteOptions &options)
{
    return Writer(channel, device, base, edited, options).run();
}
