// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/writereport.h"
#include "protocol/device/abilities.h"

#include <map>

class Device;

/// An error of WholeMemory::readBoth() that is due to the state the board is in, not to the link: what is
/// stored cannot be told now.
[[nodiscard]] bool isUntold(const Error &error);

/// WholeMemory::readBoth(); a board that starts gets some time until it can tell.
Result<WholeMemory::Contents> readBothOnceReady(Channel &channel, WholeMemory &memory);

/// Lists in the report what is in use without being stored, but for what is wanted anyway.
/// @param moved WholeMemory::movedBy() what is in use
void listOthers(const WholeMemory::Contents &contents, const QMap<QString, QString> &moved,
                WriteReport &report, const std::vector<ParameterChange> &wanted = {},
                const std::vector<DataChange> &wantedData = {});

/// The part of a write that concerns boards which can only store everything in use at once (WholeMemory):
/// what else is in use stays apart from what is stored. Without such a board, or where nobody can tell the
/// two apart, it knows nothing and does nothing.
class WholeWrite
{
public:
    WholeWrite(Device &device, Channel &channel, OtherValues others);

    /// Reads what is in use and what is stored, unless known already. Where the board cannot tell, that goes
    /// into the report if everything in use is to be stored anyway. Errors: those of WholeMemory::readBoth().
    Result<void> read(WriteReport &report);
    void start(const WholeMemory::Contents &contents, WriteReport &report);
    /// What is going to be written; everything else that is in use and not stored becomes
    /// WriteReport::others.
    void setWanted(const std::vector<ParameterChange> &changes, const std::vector<DataChange> &data,
                   WriteReport &report);

    [[nodiscard]] bool isKnown() const { return m_before.has_value(); }
    /// Such a board, of which nobody can tell the two apart.
    [[nodiscard]] bool isUntellable() const { return m_memory && !m_before; }
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
    /// What on the board sets a parameter: "script 2".
    [[nodiscard]] QString setter(const QString &key) const { return m_moved.value(key); }
    /// "pid.pitch.p, which script 2 sets".
    [[nodiscard]] QString named(const QString &key) const;
    /// After readAgain(): what runs on the board has set a value between use() and the storing, so another
    /// one is stored than intended.
    [[nodiscard]] bool isDisturbed() const;

    /// Whether what is stored could still be told with these blocks in use. Errors: Unready, those of the
    /// link.
    [[nodiscard]] Result<void> check(const std::map<BlockKey, QByteArray> &blocks) const;
    /// Puts what is to be stored into use: these blocks, and the rest as it is stored.
    Result<void> use(const std::map<BlockKey, QByteArray> &blocks);
    /// Asks what is stored now.
    Result<void> readAgain();
    /// The same after everything in use was stored without knowing what had been stored before. Errors:
    /// NotStored; where nobody can tell, that goes into the report instead.
    Result<void> readAfterAll(WriteReport &report);
    /// The same, as far as it can be known: also where asking has left other values in use.
    Result<Configuration> askStored();
    [[nodiscard]] bool isReadAgain() const { return m_after.has_value(); }
    [[nodiscard]] const Configuration &storedNow() const { return m_after->stored; }
    /// Adds to `different` what is stored otherwise than intended in blocks that were not written, and takes
    /// what is stored over into the report.
    void compare(const std::vector<BlockKey> &written, QStringList &different, WriteReport &report) const;
    /// Tells what runs on the board has had stored, as read again.
    void tellMeanwhile(WriteReport &report) const;
    /// Puts into use what was stored before.
    Result<void> putBack();
    /// What was in use beside the written values is in use again. Errors: NotRestored.
    /// Then, and after a write that failed, the report says what is in use now, as far as that can be read.
    Result<void> finish(WriteReport &report);
    /// The same after a write that failed without anybody knowing what had been stored before.
    /// @param inUse what was in use before it
    void tellUse(WriteReport &report, const Configuration &inUse) const;

private:
    Device &m_device;
    WholeMemory *m_memory;
    Channel &m_channel;
    OtherValues m_others;
    std::optional<WholeMemory::Contents> m_before;
    std::optional<WholeMemory::Contents> m_after;
    std::optional<Configuration> m_used;  // what was put into use to be stored
    QMap<QString, QString> m_moved;
    QMap<QString, double> m_setMeanwhile;  // by what runs on the board, as last seen
    std::vector<ParameterChange> m_changes;
    std::vector<DataChange> m_data;
};
