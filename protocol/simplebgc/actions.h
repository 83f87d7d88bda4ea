// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simplebgc/device.h"

namespace simplebgc {

/// The actions of the family, as table and code: everything in the serial API that is neither a parameter nor
/// telemetry.
class Actions
{
public:
    Actions(Device &device, Channel &channel)
        : m_device(device)
        , m_channel(channel)
    {
    }

    Result<ActionReply> perform(const QString &key, const QVariantMap &arguments);

private:
    using Handler = Result<ActionReply> (Actions::*)(const QVariantMap &);
    struct Entry
    {
        const char *key;
        Handler handler;
    };
    static const Entry kHandlers[];

    Result<ActionReply> confirm(CommandId id, const QByteArray &payload = {});

    Result<ActionReply> readAngles(const QVariantMap &arguments);
    Result<ActionReply> listDebugVariables(const QVariantMap &arguments);
    Result<ActionReply> readDebugVariables(const QVariantMap &arguments);
    Result<ActionReply> motorsOn(const QVariantMap &arguments);
    Result<ActionReply> motorsOff(const QVariantMap &arguments);
    Result<ActionReply> menu(const QVariantMap &arguments);
    Result<ActionReply> selectProfile(const QVariantMap &arguments);
    Result<ActionReply> steer(const QVariantMap &arguments);
    Result<ActionReply> beep(const QVariantMap &arguments);
    Result<ActionReply> readVariables(const QVariantMap &arguments);
    Result<ActionReply> writeVariable(const QVariantMap &arguments);
    Result<ActionReply> saveVariables(const QVariantMap &arguments);
    Result<ActionReply> calibrateGyro(const QVariantMap &arguments);
    Result<ActionReply> calibrateAcc(const QVariantMap &arguments);
    Result<ActionReply> calibrateBattery(const QVariantMap &arguments);
    Result<ActionReply> calibrateOffset(const QVariantMap &arguments);
    Result<ActionReply> autoTune(const QVariantMap &arguments);
    Result<ActionReply> reset(const QVariantMap &arguments);
    Result<ActionReply> useDefaults(const QVariantMap &arguments);

    Result<ActionReply> calibrate(CommandId id, const QVariantMap &arguments);
    struct Stillness
    {
        double gyroBias = 0;
        double gyroNoise = 0;
        double accError = 0;
    };
    Result<Stillness> measureStillness();

    Device &m_device;
    Channel &m_channel;
};

}  // namespace simplebgc
