// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What a CONTROL moves.
#include "protocol/simplebgc/units.h"
#include "protocol/simulator/simplebgc/board.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace simplebgc {

void SimulatedBoard::control(const Frame &frame)
{
    const auto command = decodeControl(asBytes(frame.payload));
    if (!command) {
        refuse(frame, kWrongSize);
        return;
    }
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        const ControlAxis &wanted = (*command)[i];
        const int mode = wanted.mode & 0x0F;
        if (mode == Ignore)
            continue;
        m_control[i] = wanted;
        const double unit = wanted.mode & ControlHighResSpeed ? kFineSpeedUnit : kControlSpeedUnit;
        const double speed = wanted.speed * unit;
        m_moveSpeed[i]
            = mode == Speed || wanted.speed != 0 ? speed : std::max(5.0, axisValue("rc.%a.speed", kAxes[i]));
        m_destination[i] = mode == Rc ? wanted.angle / 500.0 * axisValue("rc.%a.max_angle", kAxes[i])
            : mode == RcHighRes       ? wanted.angle / 16384.0 * axisValue("rc.%a.max_angle", kAxes[i])
                                      : wanted.angle * kDegreesPerCount;
        m_taskRunning |= (wanted.mode & ControlAutoTask) && (mode == Angle || mode == AngleRelFrame);
    }
    confirm(frame);
}

}  // namespace simplebgc
