// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What a CONTROL and a menu command move.
#include "protocol/simplebgc/choices.h"
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

void SimulatedBoard::menu(int action, const Frame &frame)
{
    const bool known
        = std::any_of(std::begin(kMenuActions), std::end(kMenuActions), [&](const Choice &choice) {
              return choice.value == action && m_options.firmware >= choice.since;
          });
    if (!known) {
        refuse(frame, kWrongParameters);
        return;
    }
    confirm(frame);
    runMenu(action, frame.version);
}

void SimulatedBoard::runMenu(int action, int version)
{
    static const QMap<int, int> profiles{{1, 0}, {2, 1}, {3, 2}, {14, 3}, {15, 4}};
    if (profiles.contains(action)) {
        loadProfile(profiles.value(action));
        return;
    }
    switch (action) {
    case 6:
    case 9: {
        startCalibration(
            Frame(number(action == 9 ? CommandId::CalibGyro : CommandId::CalibAcc), {}, version));
        break;
    }
    case 33:
        if (isFitted("magnetometer"))
            startMagCalibration(Frame(number(CommandId::CalibMag), {}, version));
        break;
    case 7:
        send(CommandId::Reset, {}, version);
        restart(kResetNotice);
        break;
    case 10:
        m_stabilizer.setMotorsOn(!m_emergency && (!m_stabilizer.motorsOn() || m_options.faults.runsOn));
        break;
    case 11: m_stabilizer.setMotorsOn(!m_emergency); break;
    case 12: m_stabilizer.setMotorsOn(m_options.faults.runsOn && m_stabilizer.motorsOn()); break;
    case 17: m_stabilizer.setTarget(Axis::Pitch, 90.0); break;
    case 18:
        for (const Axis axis : kAxes)
            m_stabilizer.setTarget(axis, 0.0);
        break;
    case 34:
        m_stabilizer.setTarget(Axis::Roll, 0.0);
        m_stabilizer.setTarget(Axis::Pitch, 0.0);
        break;
    case 35: m_stabilizer.setTarget(Axis::Yaw, m_stabilizer.hand().angle(Axis::Yaw)); break;
    default: break;
    }
}

}  // namespace simplebgc
