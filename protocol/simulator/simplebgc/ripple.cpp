// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// CALIB_COGGING: the simulated board learns the ripple of the motors' magnets and takes it out (errata 3.19).
// What it has learned lies in its files, one for each axis; what is in them nobody outside knows.
#include "protocol/simulator/simplebgc/board.h"

#include <algorithm>
#include <cmath>

namespace simplebgc {

namespace {

constexpr int kRippleSize = 57;
constexpr int kRippleFile = 4;  // type (errata 3.21)
constexpr int kRun = 1;
constexpr int kDelete = 2;
constexpr int kAxisBytes = 15;
constexpr double kPassTime = 4;  // seconds, of each iteration
constexpr double kLearned = 0.5;  // of what is left, in each

int rippleFile(std::size_t axis)
{
    return kRippleFile + (int(axis) << 8);
}

}  // namespace

void SimulatedBoard::startRippleCalibration(const Frame &frame)
{
    if (!hasSize(frame, kRippleSize))
        return;
    const int action = quint8(frame.payload[0]);
    const int axes = quint8(frame.payload[1]);
    const int iterations = quint8(frame.payload[2 + int(kAxisCount) * kAxisBytes]);
    if ((action != kRun && action != kDelete) || (axes & 7) == 0 || (action == kRun && iterations < 2)) {
        refuse(frame, kWrongParameters);
        return;
    }
    if (action == kDelete) {
        for (std::size_t i = 0; i < kAxisCount; ++i) {
            if (axes >> i & 1)
                m_files.remove(rippleFile(i));
        }
        useRipple();
        confirm(frame);
        return;
    }
    if (!startMotorCalibration(frame, kPassTime * iterations))
        return;
    m_motorCalibration.iterations = iterations;
    for (std::size_t i = 0; i < kAxisCount; ++i)
        m_motorCalibration.axes[i] = axes >> i & 1;
}

void SimulatedBoard::storeRipple()
{
    const double left = std::pow(1 - kLearned, m_motorCalibration.iterations);
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        if (m_motorCalibration.axes[i])
            m_files[rippleFile(i)] = QByteArray(1, char(std::lround(100 * (1 - left))));
    }
    useRipple();
}

void SimulatedBoard::useRipple()
{
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        const QByteArray file = m_files.value(rippleFile(i));
        m_stabilizer.setRippleKnown(kAxes[i],
                                    file.size() == 1 ? std::min(100, int(quint8(file[0]))) / 100.0 : 0.0);
    }
}

}  // namespace simplebgc
