// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include <cmath>

/// A black box as a drone writes it (errata 10): 3 s at 500 rows per second, with a vibration of 40 Hz about
/// the roll axis, outputs of four motors with the comma that its program leaves behind the last one, states,
/// and a log with commas.
inline QByteArray blackBoxSample()
{
    constexpr int kRows = 1500;
    constexpr qint64 kBegin = 81000000;  // µs since the drone's start
    constexpr qint64 kPeriod = 2000;
    QByteArray text = QByteArray::number(kBegin - 500) + ",log,Starting up, please wait\n"
        + QByteArray::number(kBegin - 400) + ",IMU:state,Off\n";
    for (int row = 0; row < kRows; ++row) {
        const qint64 at = kBegin + row * kPeriod;
        const double seconds = double(row * kPeriod) * 1e-6;
        const auto line = [&text](qint64 time, const char *name, const QByteArray &value) {
            text += QByteArray::number(time) + ',' + name + ',' + value + '\n';
        };
        line(at, "IMU:gyroscope",
             '"' + QByteArray::number(12 * std::sin(2 * M_PI * 40 * seconds), 'f', 4) + ",0.2500,-0.1250\"");
        line(at + 100, "Stabilizer:thrust", QByteArray::number(row / 500 * 0.25, 'f', 2));
        if (row % 10 == 0)
            line(at + 200, "Multicopter:motors", "\"0.1000,0.2000,0.3000,0.4000,\"");
        if (row == 500)
            line(at + 300, "IMU:state", "Running");
        if (row % 250 == 0)
            line(at + 400, "Controller:connected", row < 1000 ? "true" : "false");
    }
    return text;
}
