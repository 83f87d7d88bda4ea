// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/configuration.h"

/// What became of one changed parameter.
enum class WriteState {
    Verified,  ///< written, read back, equal
    Unknown,  ///< sent, but the link broke before it could be read back
    NotWritten,  ///< never sent, or the board refused; the old value stands
    Mismatch,  ///< read back with another value than written
    RolledBack,  ///< was written, then taken back because the rest failed
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

/// The true story of a write, parameter by parameter. Nothing is "probably written".
struct WriteReport
{
    std::vector<WriteLine> lines;
    std::vector<WriteData> data;
    bool namesWritten = false;
    std::optional<Error> error;  ///< why it is not complete
    QString snapshotPath;  ///< the backup taken before
    Configuration before;  ///< what was believed to be on the board, and what was to be there
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
