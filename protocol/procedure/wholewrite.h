// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/writereport.h"
#include "protocol/device/abilities.h"

#include <map>

class Device;

/// The part of a write that concerns boards which can only store everything in use at once (WholeMemory):
/// what else is in use stays apart from what is stored. Without such a board, or where nobody can tell the
/// two apart, it knows nothing and does nothing.
class WholeWrite
{
public:
    WholeWrite(Device &device, Channel &channel, OtherValues others);

    /// Reads what is in use and what is stored, unless known already. Errors: those of
    /// WholeMemory::readBoth() but Unsupported and Unready, which the report tells; ConditionUnmet only where
    /// it matters.
    Result<void> read(WriteReport &report);
    void start(const WholeMemory::Contents &contents, WriteReport &report);
    /// What is going to be written; everything else that is in use and not stored becomes
    /// WriteReport::others.
    void setWanted(const std::vector<ParameterChange> &changes, const std::vector<DataChange> &data,
                   WriteReport &report);

    [[nodiscard]] bool isKnown() const { return m_before.has_value(); }
    [[nodiscard]] const Configuration &inUse() const { return m_before->inUse; }
    /// What is stored before.
    [[nodiscard]] const Configuration &kept() const { return m_before->stored; }
    /// What the write starts from: what is stored, or everything in use where that is to be stored.
    [[nodiscard]] const Configuration &origin() const
    {
        return m_others == OtherValues::Store ? m_before->inUse : m_before->stored;
    }
    /// The board itself changes it, and the operator does not.
    [[nodiscard]] bool isMoved(const ParameterSpec &spec) const;
    /// "pid.pitch.p, which script 2 sets".
    [[nodiscard]] QString named(const QString &key) const;

    /// Puts what is to be stored into use: these blocks, and the rest as it is stored.
    Result<void> use(const std::map<BlockKey, QByteArray> &blocks);
    /// Asks what is stored now.
    Result<void> readAgain();
    [[nodiscard]] bool isReadAgain() const { return m_after.has_value(); }
    [[nodiscard]] const Configuration &storedNow() const { return m_after->stored; }
    /// Adds to `different` what is stored otherwise than intended in blocks that were not written, and takes
    /// what is stored over into the report.
    void compare(const std::vector<BlockKey> &written, QStringList &different, WriteReport &report) const;
    /// Puts into use what was stored before.
    Result<void> putBack();
    /// What was in use beside the written values is in use again. Errors: NotRestored.
    Result<void> finish(const WriteReport &report);

private:
    WholeMemory *m_memory;
    Channel &m_channel;
    OtherValues m_others;
    std::optional<WholeMemory::Contents> m_before;
    std::optional<WholeMemory::Contents> m_after;
    std::optional<Configuration> m_used;  // what was put into use to be stored
    QMap<QString, QString> m_moved;
    std::vector<ParameterChange> m_changes;
    std::vector<DataChange> m_data;
};
