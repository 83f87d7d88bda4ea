// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedure/wholewrite.h"

#include "protocol/device/device.h"

#include <algorithm>

using namespace Qt::StringLiterals;

WholeWrite::WholeWrite(Device &device, Channel &channel, OtherValues others)
    : m_memory(device.wholeMemory())
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
    const ErrorCode code = both.error().code;
    const bool isUntold = code == ErrorCode::Unsupported || code == ErrorCode::Unready
        || (code == ErrorCode::ConditionUnmet && m_others == OtherValues::Store);
    if (!isUntold)
        return tl::unexpected(both.error());
    report.othersUnknown = both.error();
    return {};
}

void WholeWrite::start(const WholeMemory::Contents &contents, WriteReport &report)
{
    m_before = contents;
    m_moved = m_memory->movedBy(contents.inUse);
    report.othersWere = m_others;
    report.otherParameters = contents.inUse.parameterSet();
}

void WholeWrite::setWanted(const std::vector<ParameterChange> &changes, const std::vector<DataChange> &data,
                           WriteReport &report)
{
    if (!m_before)
        return;
    m_changes = changes;
    m_data = data;
    report.others.clear();
    report.otherData.clear();
    for (const ParameterChange &other : m_before->stored.changesTo(m_before->inUse)) {
        const bool isWanted
            = std::any_of(changes.begin(), changes.end(), [&other](const ParameterChange &change) {
                  return change.spec->key == other.spec->key;
              });
        if (!isWanted)
            report.others.push_back({other.spec, other.to, other.from, m_moved.value(other.spec->key)});
    }
    for (const DataChange &other : m_before->stored.dataChangesTo(m_before->inUse)) {
        const bool isWanted = std::any_of(
            data.begin(), data.end(), [&other](const DataChange &change) { return change.key == other.key; });
        if (!isWanted)
            report.otherData.append(QLatin1String(other.spec->data));
    }
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
    // A heartbeat that was just stored hides what else is; then what is in use has to do.
    if (!both && both.error().code != ErrorCode::Unsupported && both.error().code != ErrorCode::Unready)
        return tl::unexpected(both.error());
    if (both)
        m_after = *std::move(both);
    return {};
}

void WholeWrite::compare(const std::vector<BlockKey> &written, QStringList &different,
                         WriteReport &report) const
{
    if (!m_after)
        return;
    for (const ParameterChange &change : m_used->changesTo(m_after->stored)) {
        const bool isWritten
            = std::find(written.begin(), written.end(), BlockKey{change.profile, change.spec->row->block})
            != written.end();
        if (!isWritten && !isMoved(*change.spec))
            different.append(change.spec->key);
    }
    report.onBoard = m_after->stored;
    // What a script has set meanwhile is stored as well.
    for (const ParameterChange &change : m_before->stored.changesTo(m_after->stored)) {
        const bool isTold
            = std::any_of(report.others.begin(), report.others.end(),
                          [&change](const OtherValue &other) { return other.spec->key == change.spec->key; });
        if (isMoved(*change.spec) && !isTold)
            report.others.push_back({change.spec, change.to, change.to, m_moved.value(change.spec->key)});
    }
    for (OtherValue &other : report.others) {
        if (m_others == OtherValues::Keep)
            other.stored = m_after->stored.raw(*other.spec, 0).value_or(other.stored);
    }
}

Result<void> WholeWrite::putBack()
{
    return m_memory->use(m_channel, m_before->stored);
}

Result<void> WholeWrite::finish(const WriteReport &report)
{
    if (!m_used)
        return {};
    const bool isKept = m_others == OtherValues::Keep || report.error;
    if (!isKept || (report.others.empty() && report.otherData.isEmpty() && !report.error))
        return {};
    Configuration wanted = m_before->inUse;
    if (!report.error) {
        for (const ParameterChange &change : m_changes)
            std::ignore = wanted.copyRaw(*change.spec, change.profile, *m_used);
        for (const DataChange &change : m_data)
            wanted.setBlock(change.key, change.to);
    }
    auto used = m_memory->use(m_channel, wanted);
    if (used)
        return used;
    QStringList values;
    for (const OtherValue &other : report.others)
        values.append(u"%1=%2"_s.arg(other.spec->key, other.spec->format(other.inUse)));
    return failure(ErrorCode::NotRestored, values.join(u' ') + u"; "_s + used.error().detail);
}
