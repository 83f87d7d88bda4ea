// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/writereport.h"

class Channel;
class Device;

/// The part of a write that concerns the profiles' names. A board takes all of them at once, so one that
/// nobody has read, or that somebody else has changed, would be lost.
class NamesWrite
{
public:
    NamesWrite(Channel &channel, Device &device, const Configuration &base, const Configuration &edited);

    [[nodiscard]] bool isWanted() const { return m_isWanted; }
    /// Before anything is touched. Adds to `conflicts` the names that are not as they were read. Errors:
    /// Incomplete (the names were not read), Unsupported, those of reading them again.
    Result<void> check(QStringList &conflicts) const;
    /// Writes them and reads them back. Errors: VerifyFailed, those of the channel.
    Result<void> write(WriteReport &report);
    /// After an error: the old names are written again if new ones were sent, and the report tells what the
    /// board holds.
    void undo(WriteReport &report);

private:
    Channel &m_channel;
    Device &m_device;
    const Configuration &m_base;
    const Configuration &m_edited;
    bool m_isWanted;
    bool m_isSent = false;
};
