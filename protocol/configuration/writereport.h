// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/configuration.h"

/// Outcome for one changed parameter.
enum class WriteState {
    Verified,  ///< written, read back, equal
    Unknown,  ///< sent, and the board could not be asked since what it holds
    NotWritten,  ///< never sent, or not taken by the board: it holds the old value
    Mismatch,  ///< read back with another value than written
    RolledBack,  ///< written, then restored because the rest failed
};

struct WriteLine
{
    const ParameterSpec *spec = nullptr;
    int profile = 0;
    double from = 0;
    double to = 0;
    WriteState state = WriteState::NotWritten;
    double found = 0;  ///< what the board holds, as last read; of no meaning while Unknown

    /// The state that follows from what was read; asBefore where that is the old value.
    [[nodiscard]] WriteState read(WriteState asBefore) const
    {
        if (sameValue(found, from))
            return asBefore;
        return sameValue(found, to) ? WriteState::Verified : WriteState::Mismatch;
    }
};

/// The same for a block without parameters.
struct WriteData
{
    const BlockSpec *spec = nullptr;
    BlockKey key;
    WriteState state = WriteState::NotWritten;
};

/// On boards that can only store everything in use at once: what becomes of values that are in use without
/// being stored, beside those that are written.
enum class OtherValues {
    Keep,  ///< they stay in use, and what is stored stays stored
    Store,  ///< they are stored as well
    PutBack,  ///< the stored ones are put into use
};

/// Such a value, as it was found before the write.
struct OtherValue
{
    const ParameterSpec *spec = nullptr;
    double inUse = 0;
    double stored = 0;
    QString setBy;  ///< what on the board sets it: "script 2"; empty: somebody did
};

/// Result of a write, parameter by parameter. States only what is known: nothing is "probably written".
struct WriteReport
{
    std::vector<WriteLine> lines;
    std::vector<WriteData> data;
    bool namesWritten = false;
    std::vector<OtherValue> others;
    std::shared_ptr<const ParameterSet> otherParameters;  ///< which their specs are of
    QStringList otherData;  ///< blocks without parameters, likewise
    OtherValues othersWere = OtherValues::Keep;  ///< what was done with them
    std::optional<Error> othersUnknown;  ///< why nobody can tell; then all that was in use is stored
    std::optional<Error> error;  ///< why it is incomplete
    QString snapshotPath;  ///< the backup made before
    bool isSnapshotComplete = false;  ///< it holds everything that the board has
    Configuration before;  ///< what the board was expected to hold before; wanted: what it should hold after
    Configuration wanted;
    Configuration onBoard;  ///< what the board holds now, as far as it is known

    [[nodiscard]] bool isComplete() const { return !error; }
    /// The board was read again later: what was unknown is known as far as it was delivered.
    void learn(const Configuration &board)
    {
        for (WriteLine &line : lines) {
            const ParameterSpec *spec = board.parameters().find(line.spec->key);
            const auto raw = spec ? board.raw(*spec, line.profile) : std::nullopt;
            if (line.state != WriteState::Unknown || !raw)
                continue;
            line.found = *raw;
            line.state = line.read(WriteState::NotWritten);
        }
        for (WriteData &block : data) {
            const QByteArray now = board.block(block.key);
            if (block.state != WriteState::Unknown || now.isEmpty())
                continue;
            block.state = now == before.block(block.key) ? WriteState::NotWritten
                : now == wanted.block(block.key)         ? WriteState::Verified
                                                         : WriteState::Mismatch;
        }
        onBoard = board;
    }
    /// How many values the board is known to hold that it did not hold before.
    [[nodiscard]] int countOther() const
    {
        int n = 0;
        for (const WriteLine &line : lines)
            n += line.state != WriteState::Unknown && !sameValue(line.found, line.from);
        for (const WriteData &block : data)
            n += block.state != WriteState::Unknown && onBoard.block(block.key) != before.block(block.key);
        return n;
    }
    [[nodiscard]] int count(WriteState state) const
    {
        int n = 0;
        for (const WriteLine &line : lines)
            n += line.state == state;
        for (const WriteData &block : data)
            n += block.state == state;
        return n;
    }
};
