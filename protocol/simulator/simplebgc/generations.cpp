// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Commands that have grown: each firmware takes them in the form that it knows (errata 3.3, 3.17, 3.20 and
// 3.23); EXECUTE_MENU is in menu.cpp.
#include "protocol/simplebgc/messages.h"
#include "protocol/simulator/simplebgc/board.h"

#include <algorithm>
#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr int kWriteSetSince = 2704;
constexpr int kStopKindsSince = 2687;
constexpr int kSafeStop = 2;  // of MOTORS_OFF
constexpr int kSavedListSince = 2689;
constexpr int kMasksSince = 2720;
constexpr int kFollowYaw = 31;  // a variable that is no parameter of its own
constexpr int kActiveProfile = 254;  // of USE_DEFAULTS
constexpr int kAllProfiles = 255;
constexpr int kAllMemory = 253;
constexpr double kSaveTime = 0.030;  // seconds (errata 7: tens of ms)

std::vector<DebugVar> debugVariables()
{
    return {{u"ERR_ROLL"_s, DebugVar::I16, 1, true, 1},       {u"ERR_PITCH"_s, DebugVar::I16, 2, true, 1},
            {u"ERR_YAW"_s, DebugVar::I16, 3, true, 1},        {u"MOTOR_OUT"_s, DebugVar::F32, 0, false, 3},
            {u"CPU_LOAD"_s, DebugVar::U8, 0, false, 1},       {u"IMU_TEMP"_s, DebugVar::I8, 0, false, 1},
            {u"CYCLE_US"_s, DebugVar::U16, 0, false, 1},      {u"UPTIME_MS"_s, DebugVar::U32, 0, false, 1},
            {u"YAW_UNWRAPPED"_s, DebugVar::I32, 3, false, 1}, {u"SERVO_US"_s, DebugVar::I16, 0, false, 4}};
}

}  // namespace

bool SimulatedBoard::handleGrown(const Frame &frame)
{
    switch (static_cast<CommandId>(frame.id)) {
    case CommandId::DebugVarsInfo3: tellVariables(frame); return true;
    case CommandId::DebugVars3: tellValues(frame); return true;
    case CommandId::SaveParams3: saveVariables(frame); return true;
    case CommandId::UseDefaults: useDefaults(frame); return true;
    case CommandId::WriteParamsSet:
        if (m_options.firmware < kWriteSetSince)
            return false;
        bracketWrites(frame);
        return true;
    case CommandId::MotorsOff: motorsOff(frame); return true;
    case CommandId::ExecuteMenu: menu(frame); return true;
    default: return false;
    }
}

// From an index on, where the firmware has that.
void SimulatedBoard::tellVariables(const Frame &frame)
{
    const auto vars = debugVariables();
    std::size_t from = 0;
    if (m_options.firmware < kMasksSince || frame.payload.isEmpty()) {
        if (!hasSize(frame, 0))
            return;
    } else {
        if (!hasSize(frame, 1))
            return;
        from = std::min<std::size_t>(quint8(frame.payload[0]), vars.size());
    }
    reply(frame, CommandId::DebugVarsInfo3,
          encodeDebugVarsInfo(int(vars.size()), std::span(vars).subspan(from)));
}

// All, or those that masks choose.
void SimulatedBoard::tellValues(const Frame &frame)
{
    constexpr qsizetype kMask = 4;
    const auto vars = debugVariables();
    const auto values = debugValues();
    if (m_options.firmware < kMasksSince || frame.payload.size() % kMask != 0 || frame.payload.isEmpty()) {
        if (hasSize(frame, 0))
            reply(frame, CommandId::DebugVars3, encodeDebugVars(vars, values));
        return;
    }
    std::vector<DebugVar> chosen;
    std::vector<std::vector<double>> told;
    for (std::size_t i = 0; i < vars.size() && qsizetype(i / 8) < frame.payload.size(); ++i) {
        if (quint8(frame.payload[qsizetype(i / 8)]) >> (i % 8) & 1) {
            chosen.push_back(vars[i]);
            told.push_back(values[i]);
        }
    }
    reply(frame, CommandId::DebugVars3, frame.payload + encodeDebugVars(chosen, told));
}

// Everything, or the variables that are listed.
void SimulatedBoard::saveVariables(const Frame &frame)
{
    if (m_options.firmware < kSavedListSince || frame.payload.isEmpty()) {
        if (!hasSize(frame, 0))
            return;
        storeAll();
    } else {
        QStringList keys;
        for (const char byte : frame.payload) {
            const int id = quint8(byte);
            if (!adjVar(id)) {
                refuse(frame, kWrongParameters);
                return;
            }
            for (const ParameterSpec &parameter : m_parameters.all()) {
                if (parameter.adjustable == id || (id == kFollowYaw && parameter.key == u"rc.yaw.follow"_s))
                    keys.append(parameter.key);
            }
        }
        for (const QString &key : keys) {
            const ParameterSpec *parameter = spec(key);
            const auto block = parameter->row->block;
            parameter->write(m_eeprom[std::size_t(m_active)][block],
                             parameter->read(m_ram[block]).value_or(0));
        }
        shareBoardValues(m_active);
    }
    m_replies.push_back(
        {m_now + kSaveTime,
         encodeFrame(number(CommandId::Confirm), QByteArray(1, static_cast<char>(frame.id)), frame.version)});
}

void SimulatedBoard::useDefaults(const Frame &frame)
{
    if (!hasSize(frame, 1))
        return;
    const int wanted = quint8(frame.payload[0]);
    const bool isLater = m_options.firmware >= kLater;
    const bool isAll = wanted == kAllMemory || (isLater && wanted == kAllProfiles);
    const int profile = isLater && wanted == kActiveProfile ? m_active : wanted;
    if (profile >= kProfileCount && !isAll) {
        refuse(frame, kWrongParameters);
        return;
    }
    for (int i = 0; i < kProfileCount; ++i) {
        if (isAll || i == profile)
            loadDefaults(i);
    }
    confirm(frame);
    reply(frame, CommandId::Reset, {});
    restart(kResetNotice);
}

// What is written in between comes into use as one change, at its end.
void SimulatedBoard::bracketWrites(const Frame &frame)
{
    if (!hasSize(frame, 1))
        return;
    const int action = quint8(frame.payload[0]);
    if (action > 1) {
        refuse(frame, kWrongParameters);
        return;
    }
    m_isWriteSet = action == 1;
    if (const auto profile = std::exchange(m_writtenProfile, std::nullopt); profile && !m_isWriteSet)
        loadProfile(*profile);
    confirm(frame);
}

// Free, by brake or safely: what a brake does no document tells, so here it lets them go.
void SimulatedBoard::motorsOff(const Frame &frame)
{
    bool isSafe = false;
    if (m_options.firmware < kStopKindsSince || frame.payload.isEmpty()) {
        if (!hasSize(frame, 0))
            return;
    } else {
        if (!hasSize(frame, 1))
            return;
        const int kind = quint8(frame.payload[0]);
        if (kind > kSafeStop) {
            refuse(frame, kWrongParameters);
            return;
        }
        isSafe = kind == kSafeStop;
    }
    if (isSafe)
        switchMotorsSafely(SwitchOff);
    else
        stopMotors();
    m_autoPid.reset();
    stopSteering();
    // That it ends what turns the motors is an assumption: no document tells.
    if (isStepping() && !m_options.faults.runsOn) {
        m_motorCalibration = {};
        m_stabilizer.resetEstimate();
    }
    confirm(frame);
}

}  // namespace simplebgc
