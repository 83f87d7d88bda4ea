// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Signals from outside: virtual channels, what they steer, and the slots that they work (document
// API_VIRT_CH_CONTROL and READ_ADJ_VARS_CFG, errata 3.15 and 3.23).
#include "protocol/simplebgc/adjustables.h"
#include "protocol/simulator/simplebgc/board.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr int kFirstApiSource = 129;  // errata 4.3
constexpr int kLastApiSource = 159;
constexpr int kSerialSources = 64;  // and the number of the channel
constexpr int kToldChannels = 18;
constexpr int kLastPin = 5;
constexpr int kUndefined = -10000;
constexpr int kFineUndefined = -32768;
constexpr double kFull = 500;
constexpr double kFineFull = 16384;
constexpr double kFcSpan = 45;  // degrees at which the flight controller gives its full signal

int fine(const std::optional<double> &signal)
{
    return signal ? int(std::lround(*signal * kFineFull)) : kFineUndefined;
}

int coarse(const std::optional<double> &signal)
{
    return signal ? int(std::lround(*signal * kFull)) : kUndefined;
}

}  // namespace

void SimulatedBoard::setChannels(const Frame &frame)
{
    const bool isFine = frame.id == number(CommandId::ApiVirtChHighRes);
    ByteReader reader(frame.payload);
    for (std::size_t i = 0; i < m_signals.channels.size() && reader.remaining() >= 2; ++i) {
        const int raw = reader.i16();
        const bool isUndefined = raw == (isFine ? kFineUndefined : kUndefined);
        m_signals.channels[i] = isUndefined
            ? std::nullopt
            : std::optional(std::clamp(raw / (isFine ? kFineFull : kFull), -1.0, 1.0));
    }
    m_signals.isAny = std::any_of(m_signals.channels.begin(), m_signals.channels.end(),
                                  [](const auto &channel) { return channel.has_value(); });
}

std::optional<double> SimulatedBoard::signal(int source) const
{
    if (isFitted("fc") && (source == kFcRollPin || source == kFcPitchPin)) {
        const Axis axis = source == kFcRollPin ? Axis::Roll : Axis::Pitch;
        return std::clamp(m_stabilizer.hand().angle(axis) / kFcSpan, -1.0, 1.0);
    }
    if (source < kFirstApiSource || source > kLastApiSource)
        return m_receiver.signal(source, int(value(u"rc.input_mode"_s)));  // nothing is at the analog ones
    return m_signals.channels[std::size_t(source - kFirstApiSource)];
}

std::optional<double> SimulatedBoard::rcInput(const QString &name) const
{
    return signal(int(value(u"rc.map."_s + name)));
}

// By an angle or a speed, as the profile says.
std::optional<double> SimulatedBoard::rcTarget(Axis axis)
{
    const auto stick = isSignalled() ? rcInput(QLatin1String(axisKey(axis))) : std::nullopt;
    if (!stick)
        return {};
    const double band = value(u"rc.deadband"_s) / kFull;
    const double turned = (axisValue("rc.%a.inverted", axis) != 0.0 ? -1.0 : 1.0)
        * (*stick + axisValue("rc.%a.trim", axis) / kFull);
    const double beyond = std::abs(turned) < band ? 0.0 : turned;
    const double low = axisValue("rc.%a.min_angle", axis);
    const double high = axisValue("rc.%a.max_angle", axis);
    const double turn = axisValue("rc.%a.speed", axis);
    const double before = m_stabilizer.target(axis);
    const bool isSpeed = int(axisValue("rc.%a.mode", axis)) & 1;
    if (isSpeed && beyond == 0.0)
        return {};  // it stands, or follows the frame
    if (isSpeed)
        return std::clamp(before + beyond * turn * Stabilizer::kCycle, std::min(low, before),
                          std::max(high, before));
    const double goal = (low + high) / 2 + beyond * (high - low) / 2;
    const double step = std::max(5.0, turn) * Stabilizer::kCycle;
    return before + std::clamp(goal - before, -step, step);
}

// Three positions, a command for each (document, RC_CMD_LOW).
void SimulatedBoard::runRcCommand()
{
    const auto position = rcInput(u"cmd"_s);
    const int third = position ? std::clamp(int((*position + 1.0) * 1.5), 0, 2) + 1 : 0;
    const int before = std::exchange(m_signals.third, third);
    if (third == before || third == 0 || before == 0)
        return;
    static const std::array kCommands{u"service.rc_low"_s, u"service.rc_middle"_s, u"service.rc_high"_s};
    if (const int action = int(value(kCommands[std::size_t(third - 1)])); action != 0)
        runMenu(action);
}

bool SimulatedBoard::isWatched(int pin) const
{
    const QByteArray &memory = m_ram[AdjVarsCfg];
    bool isUsed = m_initialized.count(pin) > 0;
    for (const char *key : kSignalKeys)
        isUsed |= int(value(QLatin1String(key))) == pin;
    for (int i = 0; i < kTriggerSlots; ++i)
        isUsed |= quint8(memory[6 * i]) == pin;
    for (int i = 0; i < kAnalogSlots; ++i)
        isUsed |= quint8(memory[60 + 4 * i]) == pin;
    return isUsed;
}

void SimulatedBoard::updateSlots()
{
    if (!isSignalled()) {
        m_signals.fifths = {};
        m_signals.third = 0;
        return;
    }
    runRcCommand();
    const QByteArray &memory = m_ram[AdjVarsCfg];
    for (int i = 0; i < kTriggerSlots; ++i) {
        const auto stick = signal(quint8(memory[6 * i]));
        const int fifth = stick ? std::clamp(int((*stick + 1.0) / 0.4), 0, 4) + 1 : 0;
        const int before = std::exchange(m_signals.fifths[std::size_t(i)], fifth);
        const int action = fifth > 0 ? quint8(memory[6 * i + fifth]) : 0;
        if (fifth != before && action != 0)
            runMenu(action);
    }
    bool hasChanged = false;
    const auto variables = adjustablesOf(m_options.firmware);
    for (int i = 0; i < kAnalogSlots; ++i) {
        const char *slot = memory.constData() + 60 + 4 * i;
        const auto stick = signal(quint8(slot[0]));
        const int id = quint8(slot[1]) & 0x7F;
        if (!stick || id >= int(variables.size()))
            continue;
        const AdjustableSpec &variable = variables[std::size_t(id)];
        const double share = (*stick + 1.0) / 2;
        const double place = (quint8(slot[2]) + share * (quint8(slot[3]) - quint8(slot[2]))) / 255.0;
        const auto wanted = qint32(std::lround(variable.min + place * (variable.max - variable.min)));
        if (adjVar(id) != wanted)
            hasChanged |= setAdjVar(id, wanted);
    }
    if (hasChanged)
        applyParameters();
}

QByteArray SimulatedBoard::slotState(const Frame &frame) const
{
    ByteReader reader(frame.payload);
    const QByteArray &memory = m_ram[AdjVarsCfg];
    const int trigger = std::min(int(reader.u8()), kTriggerSlots - 1);
    const auto stick = signal(quint8(memory[6 * trigger]));
    const int fifth = m_signals.fifths[std::size_t(trigger)];
    const int action = fifth > 0 ? quint8(memory[6 * trigger + fifth]) : 0;
    ByteWriter writer;
    if (m_options.firmware < kSlotStateBySource) {
        const int analog = std::min(int(reader.u8()), kAnalogSlots - 1);
        const int id = quint8(memory[60 + 4 * analog + 1]) & 0x7F;
        writer.i16(coarse(stick)).u8(action).i16(coarse(signal(quint8(memory[60 + 4 * analog]))));
        return writer.i32(adjVar(id).value_or(0)).zeros(6).take();
    }
    const int source = reader.u16();
    const int id = reader.u8();
    const int table = reader.u16();
    const int tableId = reader.u8();
    writer.i16(fine(stick)).u8(action).i16(fine(signal(source))).f32(float(adjVar(id).value_or(0)));
    return writer.i16(fine(signal(table))).f32(float(adjVar(tableId).value_or(0))).take();
}

// As REALTIME_DATA_CUSTOM tells them (errata 3.9).
QByteArray SimulatedBoard::rcData() const
{
    ByteWriter writer;
    for (const char *input : {"roll", "pitch", "yaw", "cmd"})
        writer.i16(fine(rcInput(QLatin1String(input))));
    for (const int pin : {kFcRollPin, kFcPitchPin})
        writer.i16(fine(signal(pin)));
    return writer.take();
}

QByteArray SimulatedBoard::rcChannels() const
{
    ByteWriter writer;
    for (int i = 1; i <= kToldChannels; ++i)
        writer.i16(fine(signal(kSerialSources + i)));
    return writer.take();
}

QByteArray SimulatedBoard::rcInputs(const Frame &frame)
{
    ByteReader reader(frame.payload);
    const bool initializes = reader.u16() & 1;
    ByteWriter writer;
    while (reader.remaining() > 0) {
        const int source = reader.u8();
        const bool isPin = source > 0 && source <= kLastPin;
        if (isPin && initializes)
            m_initialized.insert(source);
        writer.i16(fine(isPin && !isWatched(source) ? std::nullopt : signal(source)));
    }
    return writer.take();
}

}  // namespace simplebgc
