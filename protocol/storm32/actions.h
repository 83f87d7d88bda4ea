// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/storm32/device.h"

namespace storm32 {

/// The actions of the family: simple and RC commands that are neither a parameter nor telemetry (document,
/// errata 3.9 and 4).
class Actions
{
public:
    Actions(Device &device, Channel &channel)
        : m_device(device)
        , m_channel(channel)
    {
    }

    [[nodiscard]] static std::span<const ActionSpec> all();

    Result<ActionReply> perform(const QString &key, const QVariantMap &arguments);

private:
    Result<ActionReply> simple(Simple id, QByteArrayView arguments = {});
    Result<ActionReply> setName(const QByteArray &name);
    /// @param values of the command's fields, see RcCommand
    Result<ActionReply> rc(Rc id, const QVariantMap &values);
    std::optional<Result<ActionReply>> performSimple(const QString &key);
    Result<ActionReply> hasRestarted();
    Result<ActionReply> useDefaults();
    Result<ActionReply> haveDirections();
    Result<ActionReply> restoreWord(int word);
    Result<ActionReply> status();
    Result<ActionReply> calibration();
    Result<ActionReply> rawSensors();
    Result<ActionReply> setHeartbeat(int mode);
    /// Steers to angles, and waits until the camera is there where that can be told.
    /// Errors: ConditionUnmet, NotSeen, those of the link.
    Result<ActionReply> angle(const QVariantMap &arguments);
    struct Place
    {
        std::array<double, 3> angles{};  ///< pitch, roll, yaw
        std::array<bool, 3> isPlain{};  ///< counts from level, and no stick adds to it
        int state = 0;
        bool motorsRun = false;
    };
    Result<Place> place();
    Result<ActionReply> sticks(const QVariantMap &arguments);
    Result<ActionReply> runScript(int script, int chosen);

    Device &m_device;
    Channel &m_channel;
};

}  // namespace storm32
