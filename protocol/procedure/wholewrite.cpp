// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedure/wholewrite.h"

#include "protocol/device/device.h"
#include "protocol/session/channel.h"

#include <algorithm>

using namespace Qt::StringLiterals;

bool isUntold(const Error &error)
{
    return error.code == ErrorCode::Unsupported || error.code == ErrorCode::Unready
        || error.code == ErrorCode::ConditionUnmet;
}

Result<WholeMemory::Contents> readBothOnceReady(Channel &channel, WholeMemory &memory)
{
    constexpr auto kStarting = 10s;
    constexpr auto kAskingAgain = 500ms;
    const TimePoint until = channel.now() + kStarting;
    auto both = memory.readBoth(channel);
    while (!both && both.error().code == ErrorCode::Unready && channel.now() < until) {
        if (const auto slept = channel.sleep(kAskingAgain); !slept)
            return tl::unexpected(slept.error());
        both = memory.readBoth(channel);
    }
    return both;
}

void listOthers(const WholeMemory::Contents &contents, const QMap<QString, QString> &moved,
                WriteReport &report, const std::vector<ParameterChange> &wanted,
                const std::vector<DataChange> &wantedData)
{
    report.otherParameters = contents.inUse.parameterSet();
    report.others.clear();
    report.otherData.clear();
    for (const ParameterChange &other : contents.stored.changesTo(contents.inUse)) {
        const bool isWanted
            = std::any_of(wanted.begin(), wanted.end(), [&other](const ParameterChange &change) {
                  return change.spec->key == other.spec->key;
              });
        if (!isWanted)
            report.others.push_back({other.spec, other.to, other.from, moved.value(other.spec->key)});
    }
    for (const DataChange &other : contents.stored.dataChangesTo(contents.inUse)) {
        const bool isWanted
            = std::any_of(wantedData.begin(), wantedData.end(),
                          [&other](const DataChange &change) { return change.key == other.key; });
        if (!isWanted)
            report.otherData.append(QLatin1String(other.spec->data));
    }
}

WholeWrite::WholeWrite(Device &device, Channel &channel, OtherValues others)
    : m_device(device)
    , m_memory(device.wholeMemory())
    , m_channel(channel)
    , m_others(others)
{
}

Result<void> WholeWrite::read(WriteReport &report)
{
    if (!m_memory || m_before)
        return {};
    const auto both = m_memory->readBoth(m_channel);
    if (both) {
        start(*both, report);
        return {};
    }
    // Whatever is in use would be stored. Nobody may lose that way what a stop has changed, for instance.
    if (!isUntold(both.error()) || m_others != OtherValues::Store)
        return tl::unexpected(both.error());
    report.othersUnknown = both.error();
    report.othersWere = m_others;
    return {};
}

void WholeWrite::start(const WholeMemory::Contents &contents, WriteReport &report)
{
    m_before = contents;
    m_moved = m_memory->movedBy(contents.inUse);
    report.othersWere = m_others;
    listOthers(contents, m_moved, report);
}

void WholeWrite::setWanted(const std::vector<ParameterChange> &changes, const std::vector<DataChange> &data,
                           WriteReport &report)
{
    if (!m_before)
        return;
    m_changes = changes;
    m_data = data;
    listOthers(*m_before, m_moved, report, changes, data);
}

bool WholeWrite::isMoved(const ParameterSpec &spec) const
{
    return m_moved.contains(spec.key)
        && std::none_of(m_changes.begin(), m_changes.end(),
                        [&spec](const ParameterChange &change) { return change.spec->key == spec.key; });
}

QString WholeWrite::named(const QString &key) const
{
    return m_moved.contains(key) ? u"%1, which %2 sets"_s.arg(key, m_moved.value(key)) : key;
}

Result<void> WholeWrite::check(const std::map<BlockKey, QByteArray> &blocks) const
{
    Configuration used = origin();
    for (const auto &[key, bytes] : blocks)
        used.setBlock(key, bytes);
    return m_memory->checkUse(m_channel, used);
}

Result<void> WholeWrite::use(const std::map<BlockKey, QByteArray> &blocks)
{
    m_used = origin();
    for (const auto &[key, bytes] : blocks)
        m_used->setBlock(key, bytes);
    m_moved.insert(m_memory->movedBy(*m_used));  // a script may start with what is written
    return m_memory->use(m_channel, *m_used);
}

Result<void> WholeWrite::readAgain()
{
    auto both = m_memory->readBoth(m_channel);
    if (!both)
        return tl::unexpected(both.error());
    m_after = *std::move(both);
    if (!m_used)
        return {};
    for (const ParameterChange &change : m_used->changesTo(m_after->inUse)) {
        if (isMoved(*change.spec))
            m_setMeanwhile[change.spec->key] = change.to;
    }
    return {};
}

Result<void> WholeWrite::readAfterAll(WriteReport &report)
{
    auto both = readBothOnceReady(m_channel, *m_memory);
    if (both) {
        m_after = *std::move(both);
        return {};
    }
    // A motor's usage is not stored as it is in use.
    if (both.error().code == ErrorCode::ConditionUnmet)
        return failure(ErrorCode::NotStored, both.error().detail);
    if (!isUntold(both.error()))
        return tl::unexpected(both.error());
    report.storedUntold = both.error();
    return {};
}

Result<Configuration> WholeWrite::askStored()
{
    const auto read = m_after ? Result<void>() : readAgain();
    if (read)
        return m_after->stored;
    if (auto stored = m_memory->lastStored())
        return *std::move(stored);
    return tl::unexpected(read.error());
}

bool WholeWrite::isDisturbed() const
{
    const auto changes = m_used->changesTo(m_after->stored);
    return std::any_of(changes.begin(), changes.end(),
                       [this](const ParameterChange &change) { return m_moved.contains(change.spec->key); });
}

void WholeWrite::compare(const std::vector<BlockKey> &written, QStringList &different,
                         WriteReport &report) const
{
    if (!m_after)
        return;
    report.onBoard = m_after->stored;
    if (!m_used)
        return;
    for (const ParameterChange &change : m_used->changesTo(m_after->stored)) {
        const bool isWritten
            = std::find(written.begin(), written.end(), BlockKey{change.profile, change.spec->row->block})
            != written.end();
        if (!isWritten && !isMoved(*change.spec))
            different.append(change.spec->key);
    }
    tellMeanwhile(report);
}

// It is not among what was left or put back.
void WholeWrite::tellMeanwhile(WriteReport &report) const
{
    report.storedMeanwhile.clear();
    if (!m_after)
        return;
    for (const ParameterChange &change : m_used->changesTo(m_after->stored)) {
        if (!m_moved.contains(change.spec->key))
            continue;
        const double before = m_before->stored.raw(*change.spec, 0).value_or(change.from);
        report.storedMeanwhile.push_back({change.spec, before, change.to, setter(change.spec->key)});
        std::erase_if(report.others,
                      [&change](const OtherValue &other) { return other.spec->key == change.spec->key; });
    }
}

Result<void> WholeWrite::putBack()
{
    m_after.reset();
    m_used = m_before->stored;
    return m_memory->use(m_channel, *m_used);
}

Result<void> WholeWrite::finish(WriteReport &report)
{
    if (!m_used)
        return {};
    const bool isKept = m_others == OtherValues::Keep || report.error;
    const bool hasOthers = !report.others.empty() || !report.otherData.isEmpty() || report.error;
    if ((!isKept || !hasOthers) && m_setMeanwhile.isEmpty())
        return {};
    Configuration wanted = isKept ? m_before->inUse : *m_used;
    // Storing once more has undone what a script had set.
    for (auto it = m_setMeanwhile.begin(); it != m_setMeanwhile.end(); ++it)
        std::ignore = wanted.restoreRaw(*wanted.parameters().find(it.key()), 0, it.value());
    if (!report.error) {
        for (const ParameterChange &change : m_changes)
            std::ignore = wanted.copyRaw(*change.spec, change.profile, *m_used);
        for (const DataChange &change : m_data)
            wanted.setBlock(change.key, change.to);
    }
    const auto used = m_memory->use(m_channel, wanted);
    if (!used || report.error)
        tellUse(report, m_before->inUse);
    if (used)
        return used;
    const auto &now = report.use->now;
    // Whatever was answered: it is there.
    if (now && report.use->changes().empty() && report.use->dataChanges().empty())
        return {};
    QStringList values;
    for (OtherValue &other : report.others) {
        if (now)
            other.now = now->raw(*other.spec, 0);
        if (!sameValue(other.now, other.inUse))
            values.append(u"%1=%2"_s.arg(other.spec->key, other.spec->format(other.inUse)));
    }
    if (!values.isEmpty())
        values = {values.join(u' ')};
    return failure(ErrorCode::NotRestored, (values + QStringList{used.error().detail}).join(u"; "_s));
}

// Whatever was confirmed: the board is asked.
void WholeWrite::tellUse(WriteReport &report, const Configuration &inUse) const
{
    report.use = UseReport{inUse, m_moved.keys()};
    if (auto now = m_device.readConfiguration(m_channel))
        report.use->now = *std::move(now);
    if (report.error || !report.use->now)
        return;
    Configuration &before = report.use->before;
    for (const ParameterChange &change : m_changes) {
        const auto raw = report.use->now->raw(*change.spec, change.profile);
        if (sameValue(raw, change.to))
            std::ignore = before.copyRaw(*change.spec, change.profile, *report.use->now);
    }
    for (const DataChange &change : m_data) {
        if (report.use->now->block(change.key) == change.to)
            before.setBlock(change.key, change.to);
    }
}
