// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/telemetry/roles.h"

namespace {

constexpr std::array<const char *, 3> kAxisNames{"roll", "pitch", "yaw"};
constexpr std::array<const char *, 3> kDirections{"x", "y", "z"};

}  // namespace

int findRole(ChannelTable table, const QSet<QString> &capabilities, const QByteArray &role)
{
    for (std::size_t i = 0; i < table.size(); ++i) {
        const ChannelSpec &spec = table[i];
        if (QByteArray::fromRawData(spec.role, qsizetype(qstrlen(spec.role))).split(' ').contains(role)
            && (!*spec.capability || capabilities.contains(QLatin1String(spec.capability))))
            return int(i);
    }
    return -1;
}

ChannelRoles::ChannelRoles(ChannelTable table, const QSet<QString> &capabilities)
{
    const auto find = [&](const QByteArray &role) { return findRole(table, capabilities, role); };
    for (std::size_t i = 0; i < angle.size(); ++i) {
        const QByteArray axis(kAxisNames[i]);
        angle[i] = find("attitude." + axis);
        target[i] = find("target." + axis);
        gyro[i] = find("rate." + axis);
        acc[i] = find("acceleration." + QByteArray(kDirections[i]));
        frameAngle[i] = find("frame." + axis);
        input[i] = find("input." + axis);
        motorPower[i] = find("motor." + axis + ".output");
        motorTemperature[i] = find("motor." + axis + ".temperature");
        joint[i] = find("joint." + axis);
        spectrum[i] = find("spectrum." + axis);
    }
    for (int n = 1, motor = 0; (motor = find("motor." + QByteArray::number(n) + ".output")) >= 0; ++n)
        motors.append(motor);
    battery = find("battery");
    temperature = find("temperature");
    current = find("current");
    outputs = find("outputs");
    armed = find("armed");
    calibrated = find("calibrated");
    calibrating = find("calibrating");
    faults = find("faults");
    faultDetail = find("fault_detail");
    activeProfile = find("profile");
    cycleTime = find("cycle_time");
    busErrors = find("bus_errors");
    state = find("state");
    charge = find("battery.charge");
    batteryLevel = find("battery.level");
    batteryCells = find("battery.cells");
    cpuLoad = find("cpu.load");
    cpuTemperature = find("cpu.temperature");
    loops = find("loops");
    receiveQuality = find("rx.quality");
    receiveLevel = find("rx.level");
}

QList<int> ChannelRoles::present(std::initializer_list<std::array<int, 3>> triples)
{
    QList<int> channels;
    for (const auto &each : triples) {
        for (const int channel : each) {
            if (channel >= 0)
                channels.append(channel);
        }
    }
    return channels;
}
