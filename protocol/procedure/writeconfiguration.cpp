// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedure/writeconfiguration.h"

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
    {
    }

    Result<WriteReport> run();

private:
    Result<void> backUp();
    void collectBlocks();
    Result<void> readBoard();
    Result<void> checkConflicts() const;
    Result<void> writeBlocks();
    Result<void> writeNames();
    Result<void> verify();
    void rollBack();
    void finishReport(const Error &error);
    void markBlock(BlockKey key, WriteState state);
    void report(const QString &step, BlockKey key);
    [[nodiscard]] QByteArray patched(BlockKey key) const;
    [[nodiscard]] std::vector<bool> stateBytes(int block) const;

    Channel &m_channel;
    Device &m_device;
    const Configuration &m_base;
    const Configuration &m_edited;
    const WriteOptions &m_options;

    WriteReport m_report;
    std::vector<ParameterChange> m_changes;
    std::vector<DataChange> m_data;
    std::vector<BlockKey> m_keys;  // in the order of writing: the active profile last
    std::map<BlockKey, QByteArray> m_board;  // fresh from the board, before anything was written
    std::set<BlockKey> m_written;
    bool m_namesChanged = false;
    bool m_bracketOpen = false;
    int m_done = 0;
};

bool isLinkGone(const Error &error)
{
    return error.code == ErrorCode::LinkClosed || error.code == ErrorCode::Timeout
        || error.code == ErrorCode::Cancelled || error.code == ErrorCode::NotConnected;
}

Result<WriteReport> Writer::run()
{
    if (!m_device.identity().writable)
        return failure(ErrorCode::ReadOnly, m_device.identity().firmware);
    m_changes = m_base.changesTo(m_edited);
    m_data = m_base.dataChangesTo(m_edited);
    m_namesChanged = m_base.hasOtherNames(m_edited);
    m_report.onBoard = m_base;
    for (const ParameterChange &change : m_changes)
        m_report.lines.push_back(
            {change.spec, change.profile, change.from, change.to, WriteState::NotWritten, 0});
    for (const DataChange &change : m_data)
        m_report.data.push_back({change.spec, change.key, WriteState::NotWritten});
    if (m_changes.empty() && m_data.empty() && !m_namesChanged)
        return m_report;
    if (const auto saved = backUp(); !saved)
        return tl::unexpected(saved.error());
    collectBlocks();
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
    return m_report;
}

Result<void> Writer::backUp()
{
    if (m_options.backupDone)
        return {};
    if (!m_options.history)
        return failure(ErrorCode::NoBackup);
    auto fresh = m_device.readConfiguration(m_channel).map(
        [this](Configuration read) { return withoutLive(std::move(read), m_options.live); });
    if (!fresh)
        return tl::unexpected(fresh.error());
    auto path = m_options.history->save(*fresh, u"before the first write"_s);
    if (!path)
        return tl::unexpected(path.error());
    m_report.snapshotPath = *path;
    return {};
}

// Board-wide values are shared by all profiles, so one block would do; but every block that is written
// carries them, and must not carry the old ones back.
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
}

Result<void> Writer::readBoard()
{
    for (const BlockKey key : m_keys) {
        report(u"read-block"_s, key);
        auto bytes = m_device.readBlock(m_channel, key);
        if (!bytes)
            return tl::unexpected(bytes.error());
        if (key.profile == m_base.activeProfile())
            *bytes = withoutLive(std::move(*bytes), key.block, m_base.parameters(), m_options.live);
        m_board[key] = std::move(*bytes);
    }
    return {};
}

Result<void> Writer::checkConflicts() const
{
    QStringList conflicts;
    for (const ParameterChange &change : m_changes) {
        const auto now = change.spec->read(m_board.at({change.profile, change.spec->row->block}));
        if (now && *now != change.from && *now != change.to) {
            conflicts.append(u"%1: %2, read as %3, now %4"_s.arg(
                m_base.profileName(change.profile), change.spec->key, change.spec->format(change.from),
                change.spec->format(*now)));
        }
    }
    for (const DataChange &change : m_data) {
        if (const QByteArray &now = m_board.at(change.key); now != change.from && now != change.to)
            conflicts.append(u"%1 was changed meanwhile"_s.arg(QLatin1String(change.spec->data)));
    }
    if (conflicts.isEmpty())
        return {};
    return failure(ErrorCode::Conflict, conflicts.join(u"; "_s));
}

QByteArray Writer::patched(BlockKey key) const
{
    QByteArray bytes = m_board.at(key);
    for (const DataChange &change : m_data) {
        if (change.key == key)
            return change.to;
    }
    for (const ParameterChange &change : m_changes) {
        const bool concerns = change.spec->row->block == key.block
            && (change.spec->row->scope == Scope::Board || change.profile == key.profile);
        if (concerns)
            change.spec->write(bytes, change.to);
    }
    return bytes;
}

Result<void> Writer::writeBlocks()
{
    if (m_keys.empty())
        return {};
    if (const auto begun = m_device.beginWrite(m_channel); !begun)
        return begun;
    m_bracketOpen = true;
    for (const BlockKey key : m_keys) {
        report(u"write-block"_s, key);
        // From here on, until it is read back, nobody knows what the board holds.
        markBlock(key, WriteState::Unknown);
        m_written.insert(key);
        if (const auto written = m_device.writeBlock(m_channel, key, patched(key)); !written)
            return written;
    }
    if (const auto ended = m_device.endWrite(m_channel); !ended)
        return ended;
    m_bracketOpen = false;
    if (m_keys.back().profile != m_base.activeProfile())
        return m_device.selectProfile(m_channel, m_base.activeProfile());
    return {};
}

Result<void> Writer::writeNames()
{
    if (!m_namesChanged)
        return {};
    if (const auto written = m_device.writeProfileNames(m_channel, m_edited.profileNames()); !written)
        return written;
    const auto again = m_device.readProfileNames(m_channel);
    if (!again)
        return tl::unexpected(again.error());
    m_report.onBoard.setProfileNames(*again);
    if (m_report.onBoard.hasOtherNames(m_edited))
        return failure(ErrorCode::VerifyFailed, again->join(u", "_s));
    m_report.namesWritten = true;
    return {};
}

std::vector<bool> Writer::stateBytes(int block) const
{
    std::vector<bool> mask;
    for (const ParameterSpec &spec : m_base.parameters().all()) {
        if (spec.row->block != block || !spec.row->state || spec.row->bitCount)
            continue;
        const auto end = static_cast<std::size_t>(spec.offset + wireSize(spec.row->wire));
        if (mask.size() < end)
            mask.resize(end);
        std::fill(mask.begin() + spec.offset, mask.begin() + std::ptrdiff_t(end), true);
    }
    return mask;
}

Result<void> Writer::verify()
{
    QStringList different;
    for (const BlockKey key : m_keys) {
        report(u"verify-block"_s, key);
        const auto bytes = m_device.readBlock(m_channel, key);
        if (!bytes)
            return tl::unexpected(bytes.error());
        const QByteArray expected = patched(key);
        m_report.onBoard.setBlock(key, *bytes);
        const std::vector<bool> mask = stateBytes(key.block);
        for (qsizetype i = 0; i < expected.size(); ++i) {
            const bool isState = std::size_t(i) < mask.size() && mask[std::size_t(i)];
            if (!isState && (i >= bytes->size() || (*bytes)[i] != expected[i]))
                different.append(
                    u"%1 profile %2, byte %3"_s.arg(QLatin1String(m_base.parameters().block(key.block)->name))
                        .arg(key.profile + 1)
                        .arg(i));
        }
        for (WriteLine &line : m_report.lines) {
            if (line.spec->row->block != key.block || line.profile != key.profile)
                continue;
            line.found = line.spec->read(*bytes).value_or(line.from);
            line.state = line.found == line.to ? WriteState::Verified : WriteState::Mismatch;
        }
        for (WriteData &data : m_report.data) {
            if (data.key == key)
                data.state = *bytes == expected ? WriteState::Verified : WriteState::Mismatch;
        }
    }
    // The blocks that were not written carry the new board-wide values as well.
    for (const ParameterChange &change : m_changes) {
        if (change.spec->row->scope == Scope::Board)
            std::ignore = m_report.onBoard.setRaw(*change.spec, change.profile, change.to);
    }
    if (!different.isEmpty())
        return failure(ErrorCode::VerifyFailed, different.mid(0, 8).join(u"; "_s));
    return {};
}

void Writer::finishReport(const Error &error)
{
    m_report.error = error;
    if (isLinkGone(error) || m_written.empty())
        return;
    rollBack();
}

// The board still answers: put back what was there before, and look whether it is.
void Writer::rollBack()
{
    if (!m_bracketOpen && !m_device.beginWrite(m_channel))
        return;
    for (const BlockKey key : m_keys) {
        if (!m_written.contains(key))
            continue;
        report(u"roll-back"_s, key);
        if (!m_device.writeBlock(m_channel, key, m_board.at(key)))
            return;
    }
    if (!m_device.endWrite(m_channel))
        return;
    std::ignore = m_device.selectProfile(m_channel, m_base.activeProfile());
    for (const BlockKey key : m_keys) {
        if (!m_written.contains(key))
            continue;
        const auto bytes = m_device.readBlock(m_channel, key);
        if (!bytes)
            return;
        m_report.onBoard.setBlock(key, *bytes);
        for (WriteLine &line : m_report.lines) {
            if (line.spec->row->block != key.block || line.profile != key.profile
                || line.state == WriteState::Mismatch)
                continue;
            line.found = line.spec->read(*bytes).value_or(line.to);
            line.state = line.found == line.from ? WriteState::RolledBack : WriteState::Mismatch;
        }
        for (WriteData &data : m_report.data) {
            if (data.key == key && data.state != WriteState::Mismatch)
                data.state = *bytes == m_board.at(key) ? WriteState::RolledBack : WriteState::Mismatch;
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
    progress.total = 3 * int(m_keys.size());
    progress.step = step;
    progress.subject = u"%1, profile %2"_s.arg(QLatin1String(m_base.parameters().block(key.block)->name))
                           .arg(key.profile + 1);
    m_channel.progress(progress);
}

}  // namespace

Result<WriteReport> writeConfiguration(Channel &channel, Device &device, const Configuration &base,
                                       const Configuration &edited, const WriteOptions &options)
{
    return Writer(channel, device, base, edited, options).run();
}
