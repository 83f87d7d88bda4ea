// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/adjustables.h"

#include "protocol/simplebgc/device.h"

#include <algorithm>
#include <array>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

// clang-format off
constexpr AdjustableSpec kAdjustables[] = {
    {0, "p.roll", "P, roll", "PID", Axis::Roll, 0, 255},
    {1, "p.pitch", "P, pitch", "PID", Axis::Pitch, 0, 255},
    {2, "p.yaw", "P, yaw", "PID", Axis::Yaw, 0, 255},
    {3, "i.roll", "I, roll", "PID", Axis::Roll, 0, 255},
    {4, "i.pitch", "I, pitch", "PID", Axis::Pitch, 0, 255},
    {5, "i.yaw", "I, yaw", "PID", Axis::Yaw, 0, 255},
    {6, "d.roll", "D, roll", "PID", Axis::Roll, 0, 255},
    {7, "d.pitch", "D, pitch", "PID", Axis::Pitch, 0, 255},
    {8, "d.yaw", "D, yaw", "PID", Axis::Yaw, 0, 255},
    {9, "power.roll", "Motor power, roll", "PID", Axis::Roll, 0, 255},
    {10, "power.pitch", "Motor power, pitch", "PID", Axis::Pitch, 0, 255},
    {11, "power.yaw", "Motor power, yaw", "PID", Axis::Yaw, 0, 255},
    {12, "acc_limiter", "Acceleration limit, all axes", "Filters and limits", Axis::None, 0, 1275},
    {13, "follow_speed.roll", "Follow speed, roll", "Follow mode", Axis::Roll, 0, 255},
    {14, "follow_speed.pitch", "Follow speed, pitch", "Follow mode", Axis::Pitch, 0, 255},
    {15, "follow_speed.yaw", "Follow speed, yaw", "Follow mode", Axis::Yaw, 0, 255},
    {16, "follow_lpf.roll", "Follow low-pass, roll", "Follow mode", Axis::Roll, 0, 15},
    {17, "follow_lpf.pitch", "Follow low-pass, pitch", "Follow mode", Axis::Pitch, 0, 15},
    {18, "follow_lpf.yaw", "Follow low-pass, yaw", "Follow mode", Axis::Yaw, 0, 15},
    {19, "rc_speed.roll", "RC speed, roll", "Remote control", Axis::Roll, 0, 255},
    {20, "rc_speed.pitch", "RC speed, pitch", "Remote control", Axis::Pitch, 0, 255},
    {21, "rc_speed.yaw", "RC speed, yaw", "Remote control", Axis::Yaw, 0, 255},
    {22, "rc_lpf.roll", "RC low-pass, roll", "Remote control", Axis::Roll, 0, 255},
    {23, "rc_lpf.pitch", "RC low-pass, pitch", "Remote control", Axis::Pitch, 0, 255},
    {24, "rc_lpf.yaw", "RC low-pass, yaw", "Remote control", Axis::Yaw, 0, 255},
    {25, "rc_trim.roll", "RC trim, roll", "Remote control", Axis::Roll, -127, 127},
    {26, "rc_trim.pitch", "RC trim, pitch", "Remote control", Axis::Pitch, -127, 127},
    {27, "rc_trim.yaw", "RC trim, yaw", "Remote control", Axis::Yaw, -127, 127},
    {28, "rc_deadband", "RC dead band", "Remote control", Axis::None, 0, 255},
    {29, "rc_expo", "RC exponential curve", "Remote control", Axis::None, 0, 100},
    {30, "follow_pitch", "Follow pitch", "Follow mode", Axis::None, 0, 1},
    {31, "follow_yaw_pitch", "Follow yaw and pitch", "Follow mode", Axis::None, 0, 2},
    {32, "follow_deadband", "Follow dead band", "Follow mode", Axis::None, 0, 255},
    {33, "follow_expo", "Follow exponential curve", "Follow mode", Axis::None, 0, 100},
    {34, "follow_mix_start", "Follow roll mix, start", "Follow mode", Axis::None, 0, 90},
    {35, "follow_mix_range", "Follow roll mix, range", "Follow mode", Axis::None, 0, 90},
    {36, "gyro_trust", "Gyro trust", "Inertial sensors", Axis::None, 0, 255},
    {37, "frame_heading", "Frame heading angle (0.1°)", "Inertial sensors", Axis::None, -1800, 1800},
    {38, "gyro_heading_correction", "Gyro heading correction (0.001)", "Inertial sensors", Axis::None, -20000, 20000},
    {39, "acc_limiter.roll", "Acceleration limit, roll", "Filters and limits", Axis::Roll, 0, 10000},
    {40, "acc_limiter.pitch", "Acceleration limit, pitch", "Filters and limits", Axis::Pitch, 0, 10000},
    {41, "acc_limiter.yaw", "Acceleration limit, yaw", "Filters and limits", Axis::Yaw, 0, 10000},
    {42, "pid_gain.roll", "PID gain, roll", "PID", Axis::Roll, 0, 255},
    {43, "pid_gain.pitch", "PID gain, pitch", "PID", Axis::Pitch, 0, 255},
    {44, "pid_gain.yaw", "PID gain, yaw", "PID", Axis::Yaw, 0, 255},
    {45, "lpf.roll", "Low-pass frequency, roll", "Filters and limits", Axis::Roll, 10, 400},
    {46, "lpf.pitch", "Low-pass frequency, pitch", "Filters and limits", Axis::Pitch, 10, 400},
    {47, "lpf.yaw", "Low-pass frequency, yaw", "Filters and limits", Axis::Yaw, 10, 400},
    {48, "timelapse_time", "Time-lapse time (s)", "Other", Axis::None, 1, 3600, 2600},
    {49, "mavlink_control", "MAVLink control mode", "Other", Axis::None, 0, 2, 2600},
    {50, "h_corr_factor", "Heading correction factor", "Inertial sensors", Axis::None, 0, 255, 2687},
    {51, "software_limit.roll.lower", "Software limit, roll, lower", "Filters and limits", Axis::Roll, -3600, 3600, 2688},
    {52, "software_limit.roll.upper", "Software limit, roll, upper", "Filters and limits", Axis::Roll, -3600, 3600, 2688},
    {53, "software_limit.pitch.lower", "Software limit, pitch, lower", "Filters and limits", Axis::Pitch, -3600, 3600, 2688},
    {54, "software_limit.pitch.upper", "Software limit, pitch, upper", "Filters and limits", Axis::Pitch, -3600, 3600, 2688},
    {55, "software_limit.yaw.lower", "Software limit, yaw, lower", "Filters and limits", Axis::Yaw, -3600, 3600, 2688},
    {56, "software_limit.yaw.upper", "Software limit, yaw, upper", "Filters and limits", Axis::Yaw, -3600, 3600, 2688},
    {57, "follow_range.roll", "Follow range, roll", "Follow mode", Axis::Roll, 0, 255, 2689},
    {58, "follow_range.pitch", "Follow range, pitch", "Follow mode", Axis::Pitch, 0, 255, 2689},
    {59, "follow_range.yaw", "Follow range, yaw", "Follow mode", Axis::Yaw, 0, 255, 2689},
    {60, "auto_pid_target", "Auto PID target", "PID", Axis::None, 0, 255, 2689},
    {61, "rc_mode.roll", "RC mode, roll", "Remote control", Axis::Roll, 0, 9, 2693},
    {62, "rc_mode.pitch", "RC mode, pitch", "Remote control", Axis::Pitch, 0, 9, 2693},
    {63, "rc_mode.yaw", "RC mode, yaw", "Remote control", Axis::Yaw, 0, 9, 2693},
    {64, "euler_order", "Euler order", "Inertial sensors", Axis::None, 0, 255, 2693},
    {65, "follow_inner_deadband", "Follow inner dead band", "Follow mode", Axis::None, 0, 255, 2704},
    {66, "rc_limit.roll.lower", "RC limit, roll, lower", "Remote control", Axis::Roll, -3600, 3600, 2720},
    {67, "rc_limit.roll.upper", "RC limit, roll, upper", "Remote control", Axis::Roll, -3600, 3600, 2720},
    {68, "rc_limit.pitch.lower", "RC limit, pitch, lower", "Remote control", Axis::Pitch, -3600, 3600, 2720},
    {69, "rc_limit.pitch.upper", "RC limit, pitch, upper", "Remote control", Axis::Pitch, -3600, 3600, 2720},
    {70, "rc_limit.yaw.lower", "RC limit, yaw, lower", "Remote control", Axis::Yaw, -3600, 3600, 2720},
    {71, "rc_limit.yaw.upper", "RC limit, yaw, upper", "Remote control", Axis::Yaw, -3600, 3600, 2720},
    {72, "rc_deadband.pitch", "RC dead band, pitch", "Remote control", Axis::Pitch, 0, 255, 2720},
    {73, "rc_deadband.yaw", "RC dead band, yaw", "Remote control", Axis::Yaw, 0, 255, 2720},
    {74, "rc_expo.pitch", "RC exponential curve, pitch", "Remote control", Axis::Pitch, 0, 255, 2720},
    {75, "rc_expo.yaw", "RC exponential curve, yaw", "Remote control", Axis::Yaw, 0, 255, 2720},
    {76, "shake_amplitude.roll", "Shake amplitude, roll", "Shake generator", Axis::Roll, 0, 255, 2730},
    {77, "shake_amplitude.pitch", "Shake amplitude, pitch", "Shake generator", Axis::Pitch, 0, 255, 2730},
    {78, "shake_amplitude.yaw", "Shake amplitude, yaw", "Shake generator", Axis::Yaw, 0, 255, 2730},
    {79, "shake_frequency", "Shake frequency", "Shake generator", Axis::None, 0, 255, 2730},
    {80, "shake_frequency_range", "Shake frequency range", "Shake generator", Axis::None, 0, 100, 2730},
    {81, "shake_pause", "Shake pause (ms)", "Shake generator", Axis::None, 500, 5600, 2730},
    {82, "shake_pause_balance", "Shake pause balance", "Shake generator", Axis::None, 0, 255, 2730},
    {83, "shake_pause_randomness", "Shake pause randomness", "Shake generator", Axis::None, 0, 100, 2730},
    {84, "shake_resonance_gain.roll", "Shake resonance gain, roll", "Shake generator", Axis::Roll, 0, 255, 2730},
    {85, "shake_resonance_gain.pitch", "Shake resonance gain, pitch", "Shake generator", Axis::Pitch, 0, 255, 2730},
    {86, "shake_resonance_gain.yaw", "Shake resonance gain, yaw", "Shake generator", Axis::Yaw, 0, 255, 2730},
    {87, "shake_frequency_shift.roll", "Shake frequency shift, roll", "Shake generator", Axis::Roll, -127, 127, 2730},
    {88, "shake_frequency_shift.pitch", "Shake frequency shift, pitch", "Shake generator", Axis::Pitch, -127, 127, 2730},
    {89, "shake_frequency_shift.yaw", "Shake frequency shift, yaw", "Shake generator", Axis::Yaw, -127, 127, 2730},
    {90, "shake_gain", "Shake master gain", "Shake generator", Axis::None, 0, 255, 2730},
    {91, "outer_p.roll", "Outer P, roll", "PID", Axis::Roll, 0, 255, 2737},
    {92, "outer_p.pitch", "Outer P, pitch", "PID", Axis::Pitch, 0, 255, 2737},
    {93, "outer_p.yaw", "Outer P, yaw", "PID", Axis::Yaw, 0, 255, 2737},
    {94, "d_lpf.roll", "D low-pass frequency, roll", "Filters and limits", Axis::Roll, 0, 255, 2737},
    {95, "d_lpf.pitch", "D low-pass frequency, pitch", "Filters and limits", Axis::Pitch, 0, 255, 2737},
    {96, "d_lpf.yaw", "D low-pass frequency, yaw", "Filters and limits", Axis::Yaw, 0, 255, 2737},
    {97, "imu_correction.roll", "IMU angle correction, roll (0.01°)", "Inertial sensors", Axis::Roll, -1000, 1000, 2738},
    {98, "imu_correction.pitch", "IMU angle correction, pitch (0.01°)", "Inertial sensors", Axis::Pitch, -1000, 1000, 2738},
    {99, "software_limit_width.roll", "Software limit width, roll", "Filters and limits", Axis::Roll, 0, 255, 2738},
    {100, "software_limit_width.pitch", "Software limit width, pitch", "Filters and limits", Axis::Pitch, 0, 255, 2738},
    {101, "software_limit_width.yaw", "Software limit width, yaw", "Filters and limits", Axis::Yaw, 0, 255, 2738},
};
// clang-format on

// The board identifies them by number, and each firmware has all numbers up to its last one.
constexpr bool isOrdered()
{
    for (std::size_t i = 0; i < std::size(kAdjustables); ++i) {
        if (kAdjustables[i].id != int(i) || kAdjustables[i].min >= kAdjustables[i].max
            || (i > 0 && kAdjustables[i].since < kAdjustables[i - 1].since))
            return false;
    }
    return true;
}
static_assert(isOrdered());

// As the document of 2.5x has them (errata 5 and 6, rows 4, 12 and 13).
constexpr auto kOldAdjustables = [] {
    std::array<AdjustableSpec, 48> old{};
    std::copy(std::begin(kAdjustables), std::begin(kAdjustables) + old.size(), old.begin());
    for (const std::size_t rcLpf : {22U, 23U, 24U})
        old[rcLpf].max = 15;
    old[30] = {30, "follow_mode", "Follow mode", "Follow mode", Axis::None, 0, 2};
    old[31] = {31, "follow_yaw", "Follow yaw", "Follow mode", Axis::None, 0, 1};
    for (const std::size_t limiter : {39U, 40U, 41U})
        old[limiter].max = 1275;
    return old;
}();

}  // namespace

std::span<const AdjustableSpec> adjustablesOf(int firmware)
{
    if (firmware < 2600)
        return kOldAdjustables;
    const auto end = std::find_if(std::begin(kAdjustables), std::end(kAdjustables),
                                  [firmware](const AdjustableSpec &spec) { return spec.since > firmware; });
    return {std::begin(kAdjustables), end};
}

namespace {

/// Variables that are a whole word of parameters, with several of them in it.
constexpr std::pair<int, const char *> kWords[]
    = {{61, "rc.roll.mode"}, {62, "rc.pitch.mode"}, {63, "rc.yaw.mode"}, {64, "imu.euler_order"}};

Result<void> refused(const QString &key, const QString &value, const QString &allowed)
{
    return failure(ErrorCode::OutOfRange, u"%1 = %2, allowed %3"_s.arg(key, value, allowed));
}

// Each of its parts has to be one that an operator may set.
Result<void> checkWord(const ParameterSet &parameters, const ParameterSpec &word, double value)
{
    const auto bits = static_cast<quint32>(static_cast<qint64>(value));
    quint32 known = 0;
    for (const ParameterSpec &part : parameters.all()) {
        if (part.row->block != word.row->block || part.offset != word.offset || !part.row->bitCount)
            continue;
        const quint32 mask = (1U << part.row->bitCount) - 1;
        const quint32 raw = (bits >> part.row->bitShift) & mask;
        if (!part.row->state)
            known |= mask << part.row->bitShift;
        if (!part.row->state && !part.accepts(raw))
            return refused(part.key, part.format(raw), part.allowedText());
    }
    if (bits & ~known)
        return refused(word.key, plainNumber(value), u"no bits without a meaning"_s);
    return {};
}

}  // namespace

// The board checks nothing. Of variables that no table has, only the board knows what they may be.
Result<void> Device::checkAdjustable(const AdjustableValue &wanted) const
{
    for (const AdjustableSpec &spec : adjustables()) {
        if (spec.id == wanted.id && !(wanted.value >= spec.min && wanted.value <= spec.max))
            return refused(QLatin1String(spec.key), plainNumber(wanted.value),
                           u"%1 to %2"_s.arg(spec.min).arg(spec.max));
    }
    for (const auto &[id, key] : kWords) {
        const ParameterSpec *word = m_parameters->find(QLatin1String(key));
        if (id == wanted.id && word)
            return checkWord(*m_parameters, *word, wanted.value);
    }
    for (const ParameterSpec &spec : m_parameters->all()) {
        const double raw = wanted.value / spec.row->adjustableScale;
        if (spec.adjustable == wanted.id && spec.row->kind != ValueKind::Number && !spec.accepts(raw))
            return refused(spec.key, spec.format(raw), spec.allowedText());
    }
    return {};
}

}  // namespace simplebgc
