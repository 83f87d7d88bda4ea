// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/configuration.h"

/// Outcome for one changed parameter.
enum class WriteState {
    Verified,  ///< written, read back, equal
    Unknown,  ///< sent, but the link broke before it could be read back
    NotWritten,  ///< never sent, or refused by the board; the old value remains
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
    double found = 0;  ///< value read back, for Mismatch
};

/// The same for a block without parameters.
struct WriteData
{
    const BlockSpec *spec = nullptr;
    BlockKey key;
    WriteState state = WriteState::NotWritten;
};

/// Result of a write, parameter by parameter. States only what is known: nothing is "probably written".
struct WriteReport
{
    std::vector<WriteLine> lines;
    std::vector<WriteData> data;
    bool namesWritten = false;
    std::optional<Error> error;  ///< why it is incomplete
    QString snapshotPath;  ///< the backup made before
    bool isSnapshotComplete = false;  ///< it holds everything that the board has
    Configuration before;  ///< what the board was expected to hold before; wanted: what it should hold after
    Configuration wanted;
    Configuration onBoard;  ///< what the board holds now, as far as it is known

    [[nodiscard]] bool isComplete() const { return !error; }
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
