// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedure/writeconfiguration.h"

#include "protocol/procedure/wholewrite.h"

#include <algorithm>
#include <set>
#include <tuple>

using namespace Qt::StringLiterals;

namespace {

/// One run of writeConfiguration(): sequential, step by step.
class Writer
{
public:
    Writer(Channel &channel, Device &device, const Configuration &base, const Configuration &edited,
           const WriteOptions &options)
        : m_channel(channel)
        , m_device(device)
        , m_base(base)
        , m_edited(edited)
        , m_options(options)
        , m_whole(device, channel, options.others)
    {
    }

    Result<WriteReport> run();

private:
    Result<void> backUp();
    void collectBlocks();
    Result<void> readBoard();
    Result<void> checkConflicts() const;
    [[nodiscard]] QByteArray boardNow(BlockKey key) const;
    [[nodiscard]] bool isKnownLive(const ParameterChange &change, double now) const;
    Result<void> writeBlocks();
    Result<void> writeBracketed();
    Result<void> writeWhole();
    Result<void> readWhole();
    void addNamed();
    Result<void> writeRestarting();
    Result<void> put(BlockKey key, const QByteArray &bytes);
    Result<QByteArray> fetch(BlockKey key);
    Result<void> writeNames();
    Result<void> verify();
    bool rollBack();
    void readTruth(bool isBack);
    void finishReport(const Error &error);
    // For boards with a WriteBracket.
    Result<void> begin();
    Result<void> end();
    Result<void> selectActive();
    void markBlock(BlockKey key, WriteState state);
    void report(const QString &step, BlockKey key);
    [[nodiscard]] QByteArray patched(BlockKey key) const;
    [[nodiscard]] QString placeOf(BlockKey key, qsizetype byte) const;
    [[nodiscard]] std::vector<bool> uncheckedBytes(int block) const;
    [[nodiscard]] const BlockSpec &specOf(BlockKey key) const
    {
        return *m_base.parameters().block(key.block);
    }
    [[nodiscard]] bool restarts(BlockKey key) const { return specOf(key).effect == WriteEffect::Restarts; }

    Channel &m_channel;
    Device &m_device;
    const Configuration &m_base;
    const Configuration &m_edited;
    const WriteOptions &m_options;

    WriteReport m_report;
    std::vector<ParameterChange> m_changes;
    std::vector<DataChange> m_data;
    std::vector<BlockKey> m_keys;  // in writing order: the active profile last, then what restarts
    WholeWrite m_whole;  // for boards that can only store everything in use
    std::map<BlockKey, QByteArray> m_board;  // as read from the board before anything was written
    std::set<BlockKey> m_written;
    bool m_namesChanged = false;
    bool m_bracketOpen = false;
    TimePoint m_backBy{};  // until then a restarting board may be silent
    int m_done = 0;
};

// A board that has confirmed the write goes down within this time; also the interval of asking whether it is
// back.
constexpr milliseconds kRestartPause = 1s;

bool isLinkGone(const Error &error)
{
    return error.code == ErrorCode::LinkClosed || error.code == ErrorCode::Cancelled
        || error.code == ErrorCode::NotConnected;
}

Result<WriteReport> Writer::run()
{
    if (!m_device.identity().writable)
        return failure(ErrorCode::ReadOnly, m_device.identity().firmware);
    m_changes = m_base.changesTo(m_edited);
    m_data = m_base.dataChangesTo(m_edited);
    m_namesChanged = m_base.hasOtherNames(m_edited);
    if (m_options.contents)
        m_whole.start(*m_options.contents, m_report);
    addNamed();
    m_report.before = m_base;
    m_report.wanted = m_edited;
    m_report.onBoard = m_base;
    for (const ParameterChange &change : m_changes)
        m_report.lines.push_back(
            {change.spec, change.profile, change.from, change.to, WriteState::NotWritten, change.from});
    for (const DataChange &change : m_data)
        m_report.data.push_back({change.spec, change.key, WriteState::NotWritten});
    if (m_changes.empty() && m_data.empty() && !m_namesChanged)
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

    auto result = writeBlocks();
    if (result)
        result = verify();
    if (result)
        result = writeNames();
    if (!result)
        finishReport(result.error());
    if (const auto back = m_whole.finish(m_report); !back && !m_report.error)
        m_report.error = back.error();
    return m_report;
}

// What is wanted in use, and stored already, is a change for the board all the same.
void Writer::addNamed()
{
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
    if (m_options.backupDone)
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
            ? m_namesChanged
            : std::find(m_keys.begin(), m_keys.end(), part.key) != m_keys.end();
        if (isTouched)
            return failure(ErrorCode::NoBackup, u"%1 could not be read"_s.arg(fresh->partName(part.key)));
    }
    auto path = m_options.history->save(*fresh, u"before the first write"_s);
    if (!path)
        return tl::unexpected(path.error());
    m_report.snapshotPath = *path;
    m_report.isSnapshotComplete = fresh->missing().empty();
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
    std::stable_partition(m_keys.begin(), m_keys.end(), [this](BlockKey key) { return !restarts(key); });
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
        if (key.profile == m_base.activeProfile() && !m_device.wholeMemory())
            *bytes = withoutLive(std::move(*bytes), key.block, m_base.parameters(), m_options.live);
        m_board[key] = std::move(*bytes);
    }
    return {};
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
    QByteArray bytes = m_board.at(key);
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
    std::map<BlockKey, QByteArray> blocks;
    for (const BlockKey key : m_keys) {
        report(u"write-block"_s, key);
        markBlock(key, WriteState::Unknown);
        m_written.insert(key);
        blocks[key] = patched(key);
    }
    if (const auto used = m_whole.use(blocks); !used)
        return used;
    if (const auto ended = end(); !ended)
        return ended;
    m_bracketOpen = false;
    return m_whole.readAgain();
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

// Writes a block; if that restarts the board, returns once the board is back.
Result<void> Writer::put(BlockKey key, const QByteArray &bytes)
{
    if (!restarts(key))
        return m_device.writeBlock(m_channel, key, bytes);
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
    return back ? Result<void>() : tl::unexpected(back.error());
}

// Reads a block; a restarting board gets time to come back. On a closed link no time passes, so the number of
// attempts is limited as well.
Result<QByteArray> Writer::fetch(BlockKey key)
{
    for (auto attempts = (m_backBy - m_channel.now()) / kRestartPause;; --attempts) {
        auto bytes = m_device.readBlock(m_channel, key);
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

Result<void> Writer::writeNames()
{
    if (!m_namesChanged)
        return {};
    ProfileAccess *profiles = m_device.profiles();
    if (!profiles)
        return failure(ErrorCode::Unsupported, u"this board has one profile, without a name"_s);
    if (const auto written = profiles->writeProfileNames(m_channel, m_edited.profileNames()); !written)
        return written;
    const auto again = profiles->readProfileNames(m_channel);
    if (!again)
        return tl::unexpected(again.error());
    m_report.onBoard.setProfileNames(*again);
    if (m_report.onBoard.hasOtherNames(m_edited))
        return failure(ErrorCode::VerifyFailed, again->join(u", "_s));
    m_report.namesWritten = true;
    return {};
}

// What the board changes by itself.
std::vector<bool> Writer::uncheckedBytes(int block) const
{
    std::vector<bool> mask;
    for (const ParameterSpec &spec : m_base.parameters().all()) {
        if (spec.row->block != block || spec.row->bitCount || !(spec.row->state || m_whole.isMoved(spec)))
            continue;
        const auto end = std::size_t(spec.offset) + std::size_t(wireSize(spec.row->wire));
        if (mask.size() < end)
            mask.resize(end);
        std::fill(mask.begin() + spec.offset, mask.begin() + std::ptrdiff_t(end), true);
    }
    return mask;
}

// The parameter, or the byte where none is.
QString Writer::placeOf(BlockKey key, qsizetype byte) const
{
    for (const ParameterSpec &spec : m_base.parameters().all()) {
        if (spec.row->block == key.block && spec.offset <= byte
            && byte < spec.offset + wireSize(spec.row->wire))
            return (m_base.identity().profileCount > 1 ? m_base.profileName(key.profile) + u": "_s
                                                       : QString())
                + m_whole.named(spec.key);
    }
    return u"%1 profile %2, byte %3"_s.arg(QLatin1String(specOf(key).name)).arg(key.profile + 1).arg(byte);
}

Result<void> Writer::verify()
{
    QStringList different;
    for (const BlockKey key : m_keys) {
        report(u"verify-block"_s, key);
        const auto bytes
            = m_whole.isReadAgain() ? Result<QByteArray>(m_whole.storedNow().block(key)) : fetch(key);
        if (!bytes)
            return tl::unexpected(bytes.error());
        const QByteArray expected = patched(key);
        m_report.onBoard.setBlock(key, *bytes);
        if (specOf(key).isData() && bytes->size() > expected.size()) {
            different.append(u"%1 has %2 bytes, %3 were written"_s.arg(QLatin1String(specOf(key).name))
                                 .arg(bytes->size())
                                 .arg(expected.size()));
        }
        const std::vector<bool> mask = uncheckedBytes(key.block);
        for (qsizetype i = 0; i < expected.size(); ++i) {
            const bool isState = std::size_t(i) < mask.size() && mask[std::size_t(i)];
            if (!isState && (i >= bytes->size() || (*bytes)[i] != expected[i]))
                different.append(placeOf(key, i));
        }
        different.removeDuplicates();
        for (WriteLine &line : m_report.lines) {
            if (line.spec->row->block != key.block || line.profile != key.profile)
                continue;
            line.found = line.spec->read(*bytes).value_or(line.from);
            line.state = sameValue(line.found, line.to) ? WriteState::Verified : WriteState::Mismatch;
        }
        for (WriteData &data : m_report.data) {
            if (data.key == key)
                data.state = *bytes == expected ? WriteState::Verified : WriteState::Mismatch;
        }
    }
    m_whole.compare(m_keys, different, m_report);
    // The blocks that were not written also carry the new board-wide values.
    for (const ParameterChange &change : m_changes) {
        if (change.spec->row->scope == Scope::Board)
            std::ignore = m_report.onBoard.copyRaw(*change.spec, change.profile, m_edited);
    }
    if (!different.isEmpty())
        return failure(ErrorCode::VerifyFailed, different.mid(0, 8).join(u"; "_s));
    return {};
}

void Writer::finishReport(const Error &error)
{
    m_report.error = error;
    if (m_written.empty() || isLinkGone(error))
        return;
    // Perhaps only an answer was lost.
    if (error.code == ErrorCode::Timeout && !fetch(*m_written.begin()))
        return;
    const bool isBack = rollBack();
    readTruth(isBack);
}

// The board still answers: the previous values are restored. Returns whether all of that was accepted.
bool Writer::rollBack()
{
    if (m_whole.isKnown())
        return begin() && m_whole.putBack() && end();
    if (!m_bracketOpen && !restarts(m_keys.front())) {
        if (!begin())
            return false;
        m_bracketOpen = true;
    }
    for (const BlockKey key : m_keys) {
        if (!m_written.contains(key))
            continue;
        if (restarts(key) && std::exchange(m_bracketOpen, false) && !end())
            return false;
        report(u"roll-back"_s, key);
        if (!put(key, m_board.at(key)))
            return false;
    }
    if (m_bracketOpen && !end())
        return false;
    return selectActive().has_value();
}

// Whatever was confirmed or refused: what counts is what the board says that it holds.
void Writer::readTruth(bool isBack)
{
    const WriteState asBefore = isBack ? WriteState::RolledBack : WriteState::NotWritten;
    for (const BlockKey key : m_written) {
        const auto bytes = fetch(key);
        if (!bytes) {
            markBlock(key, WriteState::Unknown);
            continue;
        }
        m_report.onBoard.setBlock(key, *bytes);
        for (WriteLine &line : m_report.lines) {
            if (line.spec->row->block != key.block || line.profile != key.profile)
                continue;
            line.found = line.spec->read(*bytes).value_or(line.to);
            if (line.state != WriteState::Mismatch)  // which one the board had not taken
                line.state = line.read(asBefore);
        }
        for (WriteData &data : m_report.data) {
            if (data.key == key && data.state != WriteState::Mismatch)
                data.state = *bytes == m_board.at(key) ? asBefore
                    : *bytes == patched(key)           ? WriteState::Verified
                                                       : WriteState::Mismatch;
        }
    }
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

}  // namespace

Result<WriteReport> writeConfiguration(Channel &channel, Device &device, const Configuration &base,
                                       const Configuration &edited, const WriteOptions &options)
{
    return Writer(channel, device, base, edited, options).run();
}
