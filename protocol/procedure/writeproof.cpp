// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// How a write is proven, taken back where it failed, and told.
#include "protocol/procedure/inuse.h"
#include "protocol/procedure/motorsnow.h"
#include "protocol/procedure/writer.h"

#include <algorithm>
#include <tuple>

using namespace Qt::StringLiterals;

namespace {

// A board that runs answers sooner; one that starts is silent for longer.
constexpr auto kStartTime = 1s;
constexpr int kMostReads = 4;

}  // namespace

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

const ParameterSpec *Writer::specAt(int block, qsizetype byte) const
{
    for (const ParameterSpec &spec : m_base.parameters().all()) {
        if (spec.row->block == block && spec.offset <= byte && byte < spec.offset + wireSize(spec.row->wire))
            return &spec;
    }
    return nullptr;
}

// The parameter, or the byte where none is.
QString Writer::placeOf(BlockKey key, qsizetype byte) const
{
    if (const ParameterSpec *spec = specAt(key.block, byte))
        return (m_base.identity().profileCount > 1 ? m_base.profileName(key.profile) + u": "_s : QString())
            + m_whole.named(spec->key);
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
        // What the board had answered before already, because it used it, proves nothing.
        const bool isUntold = answersWithUse(m_device) && key.profile == m_base.activeProfile()
            && m_answered[key] == expected && specOf(key).effect != WriteEffect::Volatile;
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
            line.taken = line.found;
            line.state = sameValue(line.found, line.to) ? WriteState::Verified : WriteState::Mismatch;
            line.isStoreUntold = isUntold;
        }
        for (WriteData &data : m_report.data) {
            if (data.key != key)
                continue;
            data.state = *bytes == expected ? WriteState::Verified : WriteState::Mismatch;
            data.wasTaken = *bytes != m_board.at(key);
        }
    }
    m_whole.compare(m_keys, different, m_report);
    readStarted();
    // The blocks that were not written also carry the new board-wide values.
    for (const ParameterChange &change : m_changes) {
        if (change.spec->row->scope == Scope::Board)
            std::ignore = m_report.onBoard.copyRaw(*change.spec, change.profile, m_edited);
    }
    if (!different.isEmpty())
        return failure(ErrorCode::VerifyFailed, different.mid(0, 8).join(u"; "_s));
    return {};
}

// What a board has started with may be another than before, by what was written; what does not come is
// as it was.
void Writer::readStarted()
{
    const auto isRestarted
        = std::any_of(m_keys.begin(), m_keys.end(), [this](BlockKey key) { return restarts(key); });
    for (const BlockSpec &block : m_base.parameters().blocks()) {
        const BlockKey key{m_base.activeProfile(), block.id};
        if (!isRestarted || !isLost(key) || m_written.contains(key))
            continue;
        if (auto bytes = fetch(key))
            m_report.onBoard.setBlock(key, std::move(*bytes));
    }
}

void Writer::finishReport(const Error &error)
{
    m_report.error = error;
    if (!isLinkGone(error))
        m_names.undo(m_report);
    if (m_written.empty())
        return;
    // Perhaps only an answer was lost.
    if (!isLinkGone(error) && (readSent() || error.code != ErrorCode::Timeout))
        readTruth(rollBack());
    // The link went while it was taken back: what the board holds is read when it answers again.
    if (m_gone && !isLinkGone(error)) {
        m_report.error = m_gone;
        addDetail(m_report.error->detail, error.detail);
    }
    if (m_whole.isUntellable()) {
        Configuration inUse = m_base;
        for (const auto &[key, bytes] : m_board)
            inUse.setBlock(key, bytes);
        m_whole.tellUse(m_report, inUse);
    }
    settleProfile();
}

// Writing a block of another profile makes that the active one, confirmed or not: the gimbal then runs on
// its values. What the board has switched to by itself stays, and is told.
void Writer::settleProfile()
{
    ProfileAccess *profiles = m_device.profiles();
    const int wanted = m_base.activeProfile();
    const bool mayHaveMoved = std::any_of(m_written.begin(), m_written.end(),
                                          [wanted](BlockKey key) { return key.profile != wanted; });
    if (!profiles || m_written.empty())
        return;
    if (mayHaveMoved)
        m_report.strayProfile = WriteReport::kUnread;
    if (m_report.error && isLinkGone(*m_report.error))
        return;
    auto active = profiles->activeProfile(m_channel);
    if (active && *active != wanted && mayHaveMoved) {
        std::ignore = selectActive();
        active = profiles->activeProfile(m_channel);
    }
    if (active)
        m_report.learnProfile(*active);
}

// The board still answers: the previous values are restored. Returns whether all of that was accepted.
bool Writer::rollBack()
{
    if (m_whole.isKnown()) {
        const bool isBack = begin() && storeWhole([this] { return m_whole.putBack(); });
        m_whole.tellMeanwhile(m_report);
        return isBack;
    }
    if (!m_bracketOpen && !restarts(m_keys.front())) {
        if (!begin())
            return false;
        m_bracketOpen = true;
    }
    for (const BlockKey key : m_keys) {
        if (!m_written.contains(key))
            continue;
        // What was not taken is not put back: the board would restart for nothing.
        if (restarts(key) && holdsAsBefore(key))
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

bool Writer::holdsAsBefore(BlockKey key)
{
    const auto now = fetchSettled(key);
    return now && *now == m_board.at(key);
}

// What has become of what was sent, before it is taken back. Returns whether the board answers.
bool Writer::readSent()
{
    if (m_device.wholeMemory())
        return fetch(*m_written.begin()).has_value();
    for (const BlockKey key : m_written) {
        const auto bytes = fetchStored(key);
        if (!bytes)
            return false;
        for (WriteLine &line : m_report.lines) {
            if (line.spec->row->block == key.block && line.profile == key.profile)
                line.taken = line.spec->read(*bytes);
        }
        for (WriteData &data : m_report.data) {
            if (data.key == key)
                data.wasTaken = *bytes != m_board.at(key);
        }
    }
    return true;
}

Result<QByteArray> Writer::fetchStored(BlockKey key)
{
    // Of what is written itself nobody could tell the two apart.
    LiveValues live = m_options.live;
    std::erase_if(live, [this](const LiveValue &value) {
        return std::any_of(m_changes.begin(), m_changes.end(),
                           [&value](const ParameterChange &change) { return change.spec->key == value.key; });
    });
    return fetch(key).map(
        [this, key, &live](QByteArray bytes) { return asStored(key, std::move(bytes), live); });
}

// After a failure an answer may be the one to an earlier question: two in a row that agree are believed.
Result<QByteArray> Writer::fetchSettled(BlockKey key)
{
    const std::vector<bool> mask = uncheckedBytes(key.block);
    const auto settled = [&mask](QByteArray bytes) {
        for (std::size_t i = 0; i < std::min(mask.size(), std::size_t(bytes.size())); ++i) {
            if (mask[i])
                bytes[qsizetype(i)] = 0;
        }
        return bytes;
    };
    auto last = fetchStored(key);
    for (int tries = 0; tries < kMostReads && last; ++tries) {
        auto again = fetchStored(key);
        if (!again || settled(*again) == settled(*last))
            return again;
        last = std::move(again);
    }
    return last
        ? failure(ErrorCode::BadReply, u"%1: each answer is another"_s.arg(QLatin1String(specOf(key).name)))
        : last;
}

// What the board holds now, in its permanent memory where that can differ from what is in use.
Result<QByteArray> Writer::truthOf(BlockKey key)
{
    if (!m_device.wholeMemory())
        return fetchSettled(key);
    return m_whole.askStored().map([key](const Configuration &stored) { return stored.block(key); });
}

// Whatever was confirmed or refused: what counts is what the board says that it holds.
void Writer::readTruth(bool isBack)
{
    const auto asBefore = [isBack](std::optional<bool> wasTaken) {
        return wasTaken.value_or(isBack) ? WriteState::RolledBack : WriteState::NotWritten;
    };
    std::set<BlockKey> read;
    for (const BlockKey key : m_written) {
        const auto bytes = truthOf(key);
        if (!bytes) {
            markBlock(key, WriteState::Unknown);
            continue;
        }
        read.insert(key);
        m_report.onBoard.setBlock(key, *bytes);
        for (WriteLine &line : m_report.lines) {
            if (line.spec->row->block != key.block || line.profile != key.profile)
                continue;
            line.found = line.spec->read(*bytes).value_or(line.to);
            // Which one the board had not taken; but nothing that it holds is said to differ.
            if (line.state != WriteState::Mismatch || sameValue(line.found, line.to))
                line.state = line.read(
                    asBefore(line.taken ? std::optional(!sameValue(*line.taken, line.from)) : std::nullopt));
        }
        for (WriteData &data : m_report.data) {
            if (data.key == key && data.state != WriteState::Mismatch)
                data.state = *bytes == m_board.at(key) ? asBefore(data.wasTaken)
                    : *bytes == patched(key)           ? WriteState::Verified
                                                       : WriteState::Mismatch;
        }
    }
    findStrays(read);
}

// What a block holds otherwise than before beside what was to be written.
void Writer::findStrays(const std::set<BlockKey> &read)
{
    if (m_whole.isUntellable())
        return;
    Configuration before = m_base;
    Configuration now = m_base;
    for (const BlockKey key : read) {
        const QByteArray was = boardNow(key);
        const QByteArray is = m_report.onBoard.block(key);
        before.setBlock(key, was);
        now.setBlock(key, is);
        if (specOf(key).isData())
            continue;
        for (qsizetype i = 0; i < std::min(was.size(), is.size()); ++i) {
            if (was[i] != is[i] && !specAt(key.block, i))
                m_report.strayPlaces.append(placeOf(key, i));
        }
    }
    auto changes = before.changesTo(now);
    std::erase_if(changes, [this](const ParameterChange &change) { return m_whole.isMoved(*change.spec); });
    m_report.learnStrays(std::move(changes));
}

void Writer::noteSilence(TimePoint since)
{
    // An answer that is lost while other data come is no silence of the board.
    const LinkObservation seen = m_channel.observation();
    if (seen.silenceEnd <= since)
        return;
    const Duration lasted = std::min(seen.lastSilence, m_channel.now() - since);
    if (lasted >= kStartTime)
        m_report.restart.silentSeconds = std::max(m_report.restart.silentSeconds, seconds(lasted));
}

// A board that has started anew answers as if nothing had happened.
void Writer::lookForRestart()
{
    const auto run = findMotorsChanged(m_channel, m_device, m_ranBefore);
    m_report.restart.motorsStarted = run == true;
    m_report.restart.motorsStopped = run == false;
}

// The board loads what is written: what was in use instead is not any more.
void Writer::readOthers()
{
    Configuration stored = m_base;
    for (const auto &[key, bytes] : m_board)
        stored.setBlock(key, bytes);
    m_others = readReplaceable(m_channel, m_device, stored);
    std::erase_if(m_others, [this](const OtherValue &value) {
        return std::any_of(m_changes.begin(), m_changes.end(), [&value](const ParameterChange &change) {
            return change.spec->key == value.spec->key;
        });
    });
}

void Writer::tellReplaced()
{
    for (const OtherValue &value : findReplaced(m_channel, m_device, m_others))
        m_report.othersLost.append(value.spec->key + u'=' + value.spec->format(value.inUse));
}
