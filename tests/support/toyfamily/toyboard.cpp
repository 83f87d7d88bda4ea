// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/toyfamily/toyboard.h"

#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;
using toy::Command;

namespace {

constexpr auto kCycle = 800us;
constexpr auto kPatience = 1s;  // without a heartbeat
constexpr auto kRestart = 1500ms;
constexpr auto kLastWords = 200ms;  // the answer to what restarts it still gets out
constexpr auto kLevelling = 2500ms;  // longer than a client may take for silence
constexpr int kSamplesPerSpectrum = 10;

}  // namespace

ToyBoard::ToyBoard(const SimulatorOptions &options)
    : m_options(options)
    , m_deafHalts(options.own.value(u"deaf-halt"_s))
{
    m_blocks[toy::Settings] = toy::defaultSettings();
    m_blocks[toy::Mission] = "-- nothing yet\n";
}

void ToyBoard::receive(Bytes bytes)
{
    m_framer.feed(bytes, [this](const FrameView &frame) { onFrame(frame.id, toByteArray(frame.payload)); });
    m_framer.packetEnded({});
}

void ToyBoard::onFrame(int id, const QByteArray &payload)
{
    if (!isRunning() || m_time < m_deafUntil)
        return;
    const auto command = static_cast<Command>(id);
    ++m_heard[id];
    if (command == Command::Heartbeat)
        m_lastBeat = m_time;
    else if (m_time - m_lastBeat <= kPatience)
        obey(command, payload);
}

void ToyBoard::obey(Command command, const QByteArray &payload)
{
    const int deafness = m_options.own.value(u"deaf-stop"_s);
    switch (command) {
    case Command::Identify:
        answer(command, toy::pack([this](QDataStream &out) {
                   out << quint16(100) << quint32(0xF00D0000 + m_options.seed);
               }));
        break;
    case Command::ReadBlock: answer(command, m_blocks.value(payload.isEmpty() ? -1 : payload[0])); break;
    case Command::WriteBlock: write(payload); break;
    case Command::Telemetry: tellTelemetry(); break;
    case Command::Control: {
        quint8 arm = 0;
        std::array<float, 3> wanted{};
        if (m_locked || !toy::unpack(payload, [&](QDataStream &in) {
                in >> wanted[0] >> wanted[1] >> wanted[2] >> arm;
            }))
            break;
        m_control = wanted;
        m_armed = m_outputs = arm != 0;
        break;
    }
    case Command::Halt:
        if (m_deafHalts-- <= 0)
            stop();
        break;
    case Command::MotorsOff:
        if (deafness < 1)
            stop();
        answer(command);  // whether it has stopped or not
        break;
    case Command::Kill:
        if (deafness < 2) {
            stop();
            m_locked = true;
        }
        answer(command);
        break;
    case Command::Unlock:
        m_locked = false;
        answer(command);
        break;
    case Command::Level:
        answer(command);
        m_calibrated = true;
        m_deafUntil = m_time + kLevelling;
        break;
    case Command::Blink: answer(command); break;
    default: break;
    }
}

void ToyBoard::stop()
{
    m_control = {};
    m_armed = m_outputs = false;
}

void ToyBoard::write(const QByteArray &payload)
{
    const int block = payload.isEmpty() ? -1 : payload[0];
    if (!m_blocks.contains(block))
        return;
    m_blocks[block] = payload.mid(1);
    answer(Command::WriteBlock);
    if (block != toy::Mission)
        return;
    stop();
    ++m_restarts;
    m_downAt = m_time + kLastWords;
    m_awakeAt = m_downAt + kRestart;
    m_lastBeat = -1h;
}

void ToyBoard::cycle()
{
    m_time += kCycle;
    m_yaw = std::remainder(m_yaw + double(m_control[0]) * seconds(kCycle), 360.0);
    m_pitch = std::clamp(m_pitch + double(m_control[1]) * seconds(kCycle), -90.0, 90.0);
}

void ToyBoard::tellTelemetry()
{
    answer(Command::Telemetry, toy::pack([this](QDataStream &out) {
               out << float(m_pitch) << float(m_yaw) << m_control[1] << m_control[0];
               for (int motor = 0; motor < toy::kMotors; ++motor)
                   out << (m_outputs ? 10.0F + 90.0F * m_control[2] - float(motor) : 0.0F);
               out << float(m_armed) << float(m_calibrated) << float(m_outputs) << 12.6F;
           }));
    if (++m_samples % kSamplesPerSpectrum != 1)
        return;
    answer(Command::Spectrum, toy::pack([](QDataStream &out) {
               for (int bin = 0; bin < toy::kSpectrumBins; ++bin)
                   out << float(bin == 64 ? -10.0 : -80.0 - 0.1 * bin);
           }));
}

void ToyBoard::answer(Command command, const QByteArray &payload)
{
    m_output.push_back(toy::encode(toy::answerTo(command), payload));
}

QByteArray ToyBoard::takeOutput(qsizetype)
{
    if (m_output.empty())
        return {};
    QByteArray packet = std::move(m_output.front());
    m_output.pop_front();
    return packet;
}

SimulatedFamily simulatedToy()
{
    const auto count = [](const QString &name, int max) {
        return [name, max](SimulatorSetup &setup, const QString &text) -> Result<void> {
            const auto number = wholeNumber(name, text, 0, max);
            if (number)
                setup.options.own[name] = *number;
            return number.map([](int) {});
        };
    };
    return {
        u"toy"_s,
        {LinkAddress::Kind::Udp},
        {u"1.0"_s,
         [](const QString &text) -> Result<int> {
             if (text == u"1.0"_s)
                 return 100;
             return failure(ErrorCode::InvalidArgument, u"firmware is 1.0, not '%1'"_s.arg(text));
         }},
        {{u"deaf-stop"_s,
          u"N"_s,
          {u"answers so many ways of stopping without stopping"_s},
          count(u"deaf-stop"_s, 2)},
         {u"deaf-halt"_s, u"N"_s, {u"passes over so many stops of steering"_s}, count(u"deaf-halt"_s, 1000)}},
        [](const SimulatorOptions &options) { return std::make_unique<ToyBoard>(options); }};
}
