// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The simulated board's search of gains: how it begins, what it reports, what it leaves.
#include "protocol/simulator/simplebgc/board.h"

#include <cmath>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr int kAutoPidAxes = AutoPidRoll | AutoPidPitch | AutoPidYaw;
constexpr int kLowPass = 8;  // of FILTERS_EN
constexpr int kWidestFilter = 400;  // Hz, of the variable (errata, LPF_FREQ)

}  // namespace

void SimulatedBoard::autoPid(const Frame &frame)
{
    if (!hasSize(frame, 19))
        return;
    const int flags = quint8(frame.payload[1]);
    confirm(frame);
    if (!(flags & kAutoPidAxes)) {
        if (!m_options.faults.runsOn)
            m_autoPid.reset();
        return;
    }
    if (quint8(frame.payload[0]) < kProfileCount)
        loadProfile(quint8(frame.payload[0]));
    const int strength = quint8(frame.payload[2]);
    startAutoPid(CommandId::AutoPid, flags, flags & AutoPidTuneLpf ? kAutoPidAxes : 0,
                 {strength, strength, strength});
}

/// @param flags of AUTO_PID
/// @param filters bits of the axes whose low-pass filters are tuned, where they are in use
/// @param gainVsStability 0 (stable) to 255 (strong), of each axis
void SimulatedBoard::startAutoPid(CommandId command, int flags, int filters,
                                  const std::array<int, kAxisCount> &gainVsStability)
{
    std::array<bool, kAxisCount> axes{};
    std::array<AutoPidSearch::AxisResult, kAxisCount> start;
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        const QString axis = QLatin1String(axisKey(kAxes[i]));
        axes[i] = flags & (1 << i);
        const auto gain = [&](const QString &key) {
            const QString name = u"pid.%1.%2"_s.arg(axis, key);
            return isLogarithmic() ? int(std::lround(value(name))) : inUse(name);
        };
        start[i] = {gain(u"p"_s), gain(u"i"_s), gain(u"d"_s), 0.0};
        if (axes[i] && !(flags & AutoPidKeepCurrent))
            start[i] = {8, 2, 8, 0.0};
        if (axes[i] && filters & (1 << i) && inUse(u"filter.%1.enabled"_s.arg(axis)) & kLowPass)
            start[i].lpf = flags & AutoPidKeepCurrent ? inUse(u"filter.%1.lpf"_s.arg(axis)) : kWidestFilter;
    }
    m_autoPid = std::make_unique<AutoPidSearch>(axes, start, gainVsStability);
    m_autoPidReports = flags & AutoPidReport;
    m_autoPidStores = false;
    m_autoPidCommand = command;
    m_autoPidVersion = m_lastVersion;
    m_stabilizer.setMotorsOn(true);
}

void SimulatedBoard::updateAutoPid()
{
    if (!m_autoPid)
        return;
    for (std::size_t i = 0; i < kAxisCount; ++i)
        m_stabilizer.setTarget(kAxes[i],
                               m_autoPid->isSelected(kAxes[i]) ? m_autoPid->stimulus(kAxes[i])
                                                               : m_stabilizer.target(kAxes[i]));
    if (!m_autoPid->observe(m_stabilizer))
        return;
    AutoPidProgress progress;
    progress.iteration = m_autoPid->iteration();
    for (std::size_t i = 0; i < kAxisCount; ++i) {
        const QString axis = QLatin1String(axisKey(kAxes[i]));
        const AutoPidSearch::AxisResult &result = m_autoPid->results()[i];
        if (m_autoPid->isSelected(kAxes[i])) {
            for (const auto &[key, raw] :
                 {std::pair(u"p"_s, result.p), {u"i"_s, result.i}, {u"d"_s, result.d}}) {
                const ParameterSpec *parameter = spec(u"pid.%1.%2"_s.arg(axis, key));
                parameter->write(m_ram[parameter->row->block], isLogarithmic() ? parameter->toRaw(raw) : raw);
            }
            const ParameterSpec *filter = spec(u"filter.%1.lpf"_s.arg(axis));
            if (result.lpf > 0)
                filter->write(m_ram[filter->row->block], result.lpf);
        }
        progress.p[i] = inUse(u"pid.%1.p"_s.arg(axis));
        progress.i[i] = inUse(u"pid.%1.i"_s.arg(axis));
        progress.d[i] = inUse(u"pid.%1.d"_s.arg(axis));
        progress.lpf[i] = inUse(u"filter.%1.lpf"_s.arg(axis));
        progress.trackingError[i] = float(result.trackingError);
    }
    applyParameters();
    if (m_autoPidReports)
        send(CommandId::AutoPid, progress.encode(), m_autoPidVersion);
    const bool fails = m_options.faults.failWith != 0 && progress.iteration > 2;
    if (!m_autoPid->isFinished() && !fails)
        return;
    m_autoPid.reset();
    if (m_autoPidStores && !fails)
        storeAll();
    for (const Axis axis : kAxes)
        m_stabilizer.setTarget(axis, 0.0);
    sendEnd(m_autoPidCommand, m_autoPidVersion, fails ? m_options.faults.failWith : 0);
}

}  // namespace simplebgc
