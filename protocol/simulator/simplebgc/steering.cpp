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
        const double unit = wanted.mode & ControlHighResSpeed ? kFineSpeedUnit : kControlSpeedUnit;
        steerAxis(i, wanted, wanted.speed * unit,
                  mode == Rc              ? wanted.angle / 500.0 * axisValue("rc.%a.max_angle", kAxes[i])
                      : mode == RcHighRes ? wanted.angle / 16384.0 * axisValue("rc.%a.max_angle", kAxes[i])
                                          : wanted.angle * kDegreesPerCount);
    }
    if (!m_steeringLimits.isSilent)
        confirm(frame);
}

}  // namespace simplebgc
