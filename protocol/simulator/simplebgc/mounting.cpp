// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the simulated board does with what is mounted: motors that it measures, pins, what it counts (errata
// 3.19, 3.20 and 3.23).
#include "protocol/simplebgc/adjustables.h"
#include "protocol/simplebgc/messages.h"
#include "protocol/simulator/simplebgc/board.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr double kMotorCalibrationTime = 8;  // seconds
constexpr double kTurn = 15;  // degrees to either side
constexpr double kTurnPeriod = 2;
constexpr int kInputPins = 5;  // the numbers of the pulse inputs are those of their pins
constexpr double kLinkPerTorque = 0.01;

}  // namespace

bool SimulatedBoard::handleMotors(const Frame &frame)
{
    ByteReader reader(frame.payload);
    switch (static_cast<CommandId>(frame.id)) {
    case CommandId::CalibMotorMagLink:
        if (m_options.firmware < kBlocks[ParamsExt2].since)
            return false;
        startMotorCalibration(frame);
        return true;
    case CommandId::CalibPoles: startMotorCalibration(frame); return true;
    case CommandId::CalibExtGain:  // no flight controller gives a signal
    case CommandId::CalibMag:  // there is no magnetometer
        refuse(frame, kWrongState);
        return true;
    case CommandId::TriggerPin: {
        if (!hasSize(frame, 2))
            return true;
        const int pin = reader.u8();
        // Only if it really happened (document TRIGGER_PIN): an input is not set.
        for (const char *input : kSignalKeys) {
            if (pin <= kInputPins && int(value(QLatin1String(input))) == pin)
                return true;
        }
        confirm(frame);  // nothing is connected to it
        return true;
    }
    case CommandId::ServoOut: return frame.payload.size() == 16;
    case CommandId::ReadStateVars: {
        if (m_options.firmware < kLater)
            return false;
        ByteWriter writer;
        writer.zeros(6).u8(m_emergency ? 9 : 0).u8(16).u32(quint32(m_now)).u16(m_starts);
        writer.u16(int(std::lround(1000 * m_mostCurrent)))
            .i8(20)
            .i8(celsius(31))
            .i8(20)
            .i8(celsius(31))
            .zeros(4);
        const double average = m_stabilizer.current();
        writer.u32(quint32(m_now)).f32(float(average * volts() * m_now / 3600));
        reply(frame, CommandId::ReadStateVars,
              writer.u32(quint32(m_now)).f32(float(average)).zeros(152).take());
        return true;
    }
    case CommandId::WriteStateVars:
        if (m_options.firmware < kLater)
            return false;
        if (hasSize(frame, 192)) {
            m_starts = 0;
            m_mostCurrent = 0;
            confirm(frame);
        }
        return true;
    case CommandId::AdjVarsInfo: {
        if (m_options.firmware < 2700)
            return false;
        const auto all = adjustablesOf(m_options.firmware);
        ByteWriter writer;
        writer.u8(int(all.size()));
        for (std::size_t i = reader.remaining() > 0 ? reader.u8() : 0; i < all.size(); ++i) {
            const QByteArray name = QByteArray(all[i].key).toUpper().left(16);
            ByteWriter entry;
            entry.u8(all[i].id).u8(int(name.size())).bytes(name).i16(int(all[i].min)).i16(int(all[i].max));
            const QByteArray bytes = entry.i32(adjVar(all[i].id).value_or(0)).take();
            if (writer.size() + bytes.size() > 255)
                break;
            writer.bytes(bytes);
        }
        reply(frame, CommandId::AdjVarsInfo, writer.take());
        return true;
    }
    case CommandId::SetAdjVarsValF: {
        if (m_options.firmware < 2734)
            return false;
        const int count = reader.u8();
        bool isKnown = reader.remaining() == std::size_t(count) * 5;
        for (int i = 0; isKnown && i < count; ++i) {
            const int id = reader.u8();
            isKnown = setAdjVar(id, qint32(std::lround(reader.f32())));
        }
        applyParameters();
        if (isKnown)
            confirm(frame);
        else
            refuse(frame, kWrongParameters);
        return true;
    }
    case CommandId::GetAdjVarsValF: {
        if (m_options.firmware < 2734)
            return false;
        const int count = reader.u8();
        if (count < 1 || count > kAdjVarsPerCommand || reader.remaining() != std::size_t(count)) {
            refuse(frame, kWrongSize);
            return true;
        }
        ByteWriter writer;
        writer.u8(count);
        for (int i = 0; i < count; ++i) {
            const int id = reader.u8();
            writer.u8(id).f32(float(adjVar(id).value_or(0)));
        }
        reply(frame, CommandId::SetAdjVarsValF, writer.take());
        return true;
    }
    default: return false;
    }
}

void SimulatedBoard::startMotorCalibration(const Frame &frame)
{
    if (m_calibration.left > 0 || m_autoPid || m_motorCalibration.until > 0) {
        refuse(frame, kWrongState);
        return;
    }
    m_motorCalibration = {static_cast<CommandId>(frame.id), m_now + kMotorCalibrationTime, frame.version,
                          m_stabilizer.motorsOn()};
    m_stabilizer.setMotorsOn(false);  // they are stepped, not controlled
    confirm(frame);  // at reception; the end is told by another one
}

// It turns the motors to and fro, and at the end knows what they are.
void SimulatedBoard::updateMotorCalibration()
{
    if (m_motorCalibration.until < 0)
        return;
    if (m_now < m_motorCalibration.until) {
        const double phase = (m_motorCalibration.until - m_now) / kTurnPeriod * 2 * std::numbers::pi;
        for (const Axis axis : kAxes)
            m_stabilizer.plant(axis).setAngle(kTurn * std::sin(phase));
        return;
    }
    for (const Axis axis : kAxes) {
        const QString name = QLatin1String(axisKey(axis));
        if (m_motorCalibration.command == CommandId::CalibPoles) {
            store(u"motor.%1.poles"_s.arg(name), 0, m_stabilizer.plant(axis).mechanics().poles);
            store(u"motor.%1.invert"_s.arg(name), 0, 0);
        } else if (const ParameterSpec *link = spec(u"motor.%1.magnetic_link"_s.arg(name))) {
            store(link->key, 0,
                  int(link->toRaw(kLinkPerTorque * m_stabilizer.plant(axis).mechanics().fullTorque)));
        }
    }
    m_stabilizer.resetEstimate();
    m_stabilizer.setMotorsOn(m_motorCalibration.motorsWereOn && !m_emergency);
    sendEnd(m_motorCalibration.command, m_motorCalibration.version, false);
    m_motorCalibration = {};
}

}  // namespace simplebgc
