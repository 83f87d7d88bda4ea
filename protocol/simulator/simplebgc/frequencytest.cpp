// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// BODE_TEST: the simulated board shakes an axis of its plant and tells, sample by sample, what went in and
// what the plant answered (errata 3.23; types, systems and the report at the end after the public Python
// library that they cite). How strong a gain is no text tells: here 10000 is all of the motor's torque, or
// 100 degrees of the target.
#include "protocol/simplebgc/choices.h"
#include "protocol/simulator/simplebgc/board.h"

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr int kFrequencyTestSize = 30;
constexpr std::size_t kPairs = 20;  // in a frame
constexpr double kFullStep = 65534;
constexpr double kTorqueUnit = 1e-4;
constexpr double kAngleUnit = 0.01;  // degrees
constexpr quint32 kLongestTest = 75000;  // samples, a minute
constexpr double kSampleRate = 1 / Stabilizer::kCycle;
constexpr int kNoise = 1;
constexpr int kSweep = 2;
constexpr int kExponentialSweep = 3;
// Parts of a system.
constexpr int kController = 1;
constexpr int kOverall = 8;
constexpr int kClosed = 128;
constexpr int kOnlyController = 3;

}  // namespace

// No samples end a test that goes on: an assumption, nobody tells how it is stopped.
void SimulatedBoard::startFrequencyTest(const Frame &frame)
{
    if (!hasSize(frame, kFrequencyTestSize))
        return;
    ByteReader reader(frame.payload);
    FrequencyTest test;
    test.axis = reader.u8();
    test.type = reader.u8();
    test.gain = reader.u16();
    test.to = reader.u16();
    test.system = reader.u8();
    test.total = reader.u32();
    reader.skip(1);
    test.from = reader.u16();
    test.version = frame.version;
    if (test.total == 0) {
        confirm(frame);
        if (m_frequencyTest.axis >= 0)
            endFrequencyTest(0);
        return;
    }
    const bool isSystem = std::any_of(std::begin(kTestedSystems), std::end(kTestedSystems),
                                      [&test](const Choice &known) { return known.value == test.system; });
    if (test.axis >= int(kAxisCount) || test.type < kNoise || test.type > kExponentialSweep || !isSystem
        || test.from > test.to || test.to <= 0 || test.gain <= 0 || test.total > kLongestTest) {
        refuse(frame, kWrongParameters);
        return;
    }
    if (isBusy() || !m_stabilizer.motorsOn() || !m_stabilizer.imuPresent()) {
        refuse(frame, kWrongState);
        return;
    }
    test.upper = Biquad::lowPass(test.to, kSampleRate);
    test.lower = Biquad::lowPass(std::max(test.from, 0.5), kSampleRate);
    test.level = std::sqrt(kSampleRate / 2 / std::max(1.0, test.to - test.from));
    test.target = m_stabilizer.target(kAxes[std::size_t(test.axis)]);
    m_frequencyTest = std::move(test);
    confirm(frame);
}

/// The next value, within -1 and 1 most of the time.
double SimulatedBoard::stimulus()
{
    FrequencyTest &test = m_frequencyTest;
    if (test.type == kNoise) {
        constexpr double kSpread = 1.0 / 3;
        const double below = test.upper.process(m_sensorNoise.gauss(kSpread * test.level));
        return std::clamp(below - test.lower.process(below), -1.0, 1.0);
    }
    const double done = double(test.done) / test.total;
    const double from = std::max(test.from, 0.5);
    const double hz
        = test.type == kSweep ? from + (test.to - from) * done : from * std::pow(test.to / from, done);
    test.phase += 2 * std::numbers::pi * hz * Stabilizer::kCycle;
    return std::sin(test.phase);
}

// The plant alone is shaken at its motor; with its controller, at what it is steered to.
void SimulatedBoard::updateFrequencyTest()
{
    FrequencyTest &test = m_frequencyTest;
    if (test.axis < 0)
        return;
    const Axis axis = kAxes[std::size_t(test.axis)];
    if (!m_stabilizer.motorsOn()) {
        endFrequencyTest(kWrongState);
        return;
    }
    const double error = test.target + test.given - m_stabilizer.estimate(axis);
    const bool isSteered = test.system & kController;
    const bool isWhole = test.system & (kClosed | kOverall);
    if (isSteered) {
        const bool isController = test.system == kOnlyController;
        test.samples.push_back(
            {isWhole ? test.given : error,
             isController ? m_stabilizer.command(axis) : m_stabilizer.estimate(axis) - test.target});
    } else {
        test.samples.push_back(
            {isWhole ? test.given : m_stabilizer.command(axis) + test.given, m_stabilizer.gyro(axis)});
    }
    test.given = stimulus() * test.gain * (isSteered ? kAngleUnit : kTorqueUnit);
    if (isSteered)
        m_stabilizer.setTarget(axis, test.target + test.given);
    else
        m_stabilizer.setStimulus(axis, test.given);
    ++test.done;
    if (test.samples.size() == kPairs)
        sendFrequencySamples();
    if (test.done == test.total)
        endFrequencyTest(0);
    else if (m_options.faults.failWith != 0 && test.done > test.total / 2)
        endFrequencyTest(m_options.faults.failWith);
}

void SimulatedBoard::sendFrequencySamples()
{
    FrequencyTest &test = m_frequencyTest;
    if (test.samples.empty())
        return;
    std::array<double, 2> low = test.samples.front();
    std::array<double, 2> high = low;
    for (const auto &sample : test.samples) {
        for (std::size_t i = 0; i < low.size(); ++i) {
            low[i] = std::min(low[i], sample[i]);
            high[i] = std::max(high[i], sample[i]);
        }
    }
    ByteWriter writer;
    writer.u8(++test.counter & 0xFF).f32(float(low[0])).f32(float(low[1])).f32(float(high[0]));
    writer.f32(float(high[1]));
    for (const auto &sample : test.samples) {
        for (std::size_t i = 0; i < low.size(); ++i) {
            const double range = high[i] - low[i];
            writer.u16(range > 0 ? int(std::lround((sample[i] - low[i]) / range * kFullStep)) : 0);
        }
    }
    test.samples.clear();
    send(CommandId::BodeTestData, writer.take(), test.version);
}

void SimulatedBoard::endFrequencyTest(int code)
{
    FrequencyTest &test = m_frequencyTest;
    const Axis axis = kAxes[std::size_t(test.axis)];
    sendFrequencySamples();
    m_stabilizer.setStimulus(axis, 0);
    m_stabilizer.setTarget(axis, test.target);
    send(CommandId::BodeTestStartStop, ByteWriter().u32(test.done).u16(code).u8(0).zeros(15).take(),
         test.version);
    test = {};
}

}  // namespace simplebgc
