// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The step that says which sensors the board tells of, and whether they measure.
#include "protocol/device/bearings.h"
#include "protocol/device/device.h"
#include "protocol/guide/setupguide.h"
#include "protocol/guide/setuplive.h"
#include "protocol/session/channel.h"
#include "protocol/telemetry/uniformsamples.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr double kListeningSeconds = 3;
constexpr QLatin1String kNoSensor("no-sensor");

}  // namespace

Result<SetupResult> SetupGuide::sensors()
{
    const auto base = m_device.readConfiguration(m_channel);
    if (!base)
        return tl::unexpected(base.error());
    if (const auto news = awaitNews(ChannelRoles::present({m_roles.gyro})); !news)
        return tl::unexpected(news.error());
    const auto span = measure(kListeningSeconds);
    if (!span)
        return tl::unexpected(span.error());
    SetupResult result;
    // What measures is never quite still.
    bool measures = !hasFault(kNoSensor);
    for (const Axis axis : kAxes) {
        const int channel = m_roles.gyro[std::size_t(axis)];
        if (channel < 0)
            continue;
        const auto samples = uniformSamples(m_telemetry, channel, -1, span->first, span->second);
        if (!samples && samples.error().code != ErrorCode::TooFewSamples)
            return tl::unexpected(samples.error());
        const double spread = samples ? spreadOf(samples->values) : 0.0;
        result.figures.append({setupFigureKey("spread", axis), spread});
        measures = measures && spread > 0;
    }
    result.remarks = QStringList{measures ? u"sensors.imu"_s : u"sensors.noimu"_s, frameSensor(*base)};
    const auto &has = m_device.identity().capabilities;
    result.remarks.append(has.contains(m_keys.magnetometer) ? u"sensors.magnetometer"_s
                                                            : u"sensors.nomagnetometer"_s);
    int motors = 0;
    int encoders = 0;
    for (const Axis axis : kAxes) {
        const ParameterSpec *output = find(m_keys.motorOutput, axis);
        const ParameterSpec *type = find(m_keys.encoderType, axis);
        const int profile = base->activeProfile();
        motors += output && base->raw(*output, profile).value_or(0) != 0.0;
        encoders += type && base->raw(*type, profile).value_or(0) != 0.0;
    }
    result.remarks.append(!has.contains(m_keys.encoders) ? u"sensors.noencoders"_s
                              : encoders == 0            ? u"sensors.unsetencoders"_s
                              : encoders < motors        ? u"sensors.someencoders"_s
                                                         : u"sensors.encoders"_s);
    const bool isPoor = std::any_of(result.remarks.begin(), result.remarks.end(),
                                    [](const QString &remark) { return !findSetupRemark(remark)->isGood; });
    result.state = isPoor ? SetupResult::State::Poor : SetupResult::State::Done;
    return result;
}

bool SetupGuide::hasFault(QLatin1String key) const
{
    const FaultWords *words = m_device.faultWords();
    if (!words || m_roles.faults < 0 || std::isnan(latest(m_roles.faults)))
        return false;
    const double detail = m_roles.faultDetail >= 0 ? latest(m_roles.faultDetail) : 0.0;
    const auto faults
        = words->faults(unsigned(latest(m_roles.faults)), std::isnan(detail) ? 0U : unsigned(detail));
    return std::ranges::any_of(faults, [key](const BoardFault &fault) { return fault.key == key; });
}

// One that is set up and sends zeros alone does not measure.
QString SetupGuide::frameSensor(const Configuration &base) const
{
    const Bearings *bearings = m_device.bearings();
    const auto isSet = bearings
        ? bearings->isFrameMeasured(base, [this](int channel) { return latest(channel); })
        : std::nullopt;
    if (!isSet.value_or(false))
        return u"sensors.noframe"_s;
    const bool measures = std::ranges::any_of(m_roles.frameAngle, [this](int channel) {
        return channel >= 0 && !std::isnan(latest(channel)) && latest(channel) != 0.0;
    });
    return measures ? u"sensors.frame"_s : u"sensors.deadframe"_s;
}
