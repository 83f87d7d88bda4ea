// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/toyfamily/toydevice.h"

#include "protocol/telemetry/streams.h"
#include "protocol/telemetry/telemetryplan.h"
#include "tests/support/toyfamily/toytables.h"
#include "tests/support/toyfamily/toywire.h"

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace Qt::StringLiterals;
using toy::Command;

namespace {

// clang-format off
constexpr Choice kArm[] = {{0, "Off"}, {1, "On"}};
constexpr SteeringSwitch kSwitches[] = {{.key = "arm", .label = "Arm", .choices = kArm, .arms = true}};
// clang-format on

class ToyDecoder final : public TelemetryDecoder
{
public:
    void decode(const FrameView &frame, TimePoint at, TelemetryStore &store) override
    {
        if (frame.id == toy::answerTo(Command::Telemetry))
            decodeValues(toByteArray(frame.payload), at, store);
        else if (frame.id == toy::answerTo(Command::Spectrum))
            decodeSpectrum(toByteArray(frame.payload), at, store);
    }

private:
    void decodeValues(const QByteArray &payload, TimePoint at, TelemetryStore &store)
    {
        std::array<float, toy::Spectrum> values{};
        if (!toy::unpack(payload, [&values](QDataStream &in) {
                for (float &value : values)
                    in >> value;
            }))
            return;
        if (!m_group) {
            QList<int> channels(toy::Spectrum);
            std::iota(channels.begin(), channels.end(), 0);
            m_group = store.defineGroup(channels, 0);
        }
        store.append(*m_group, at, values);
    }

    static void decodeSpectrum(const QByteArray &payload, TimePoint at, TelemetryStore &store)
    {
        std::vector<float> bins(toy::kSpectrumBins);
        if (toy::unpack(payload, [&bins](QDataStream &in) {
                for (float &bin : bins)
                    in >> bin;
            }))
            store.appendArray(toy::Spectrum, at, std::move(bins));
    }

    std::shared_ptr<TelemetryGroup> m_group;
};

/// The motors stand when the board says so, and says it after the stop.
Proof outputsOff(const LatestValues &latest, TimePoint since)
{
    if (latest.latestAt(toy::Outputs) <= since || std::isnan(latest.latest(toy::Outputs)))
        return Proof::Nothing;
    return latest.latest(toy::Outputs) == 0.0F ? Proof::Proven : Proof::Refuted;
}

std::shared_ptr<const ParameterSet> parametersOf(const BoardIdentity &identity)
{
    return std::make_shared<ParameterSet>(toy::parameterRows(), toy::blocks(), identity.firmwareNumber,
                                          identity.capabilities);
}

}  // namespace

Result<bool> ToyDevice::probe(Channel &channel)
{
    const auto reply = channel.transact(toy::request(Command::Identify));
    if (!reply && reply.error().code != ErrorCode::Timeout)
        return tl::unexpected(reply.error());
    return reply.has_value();
}

Result<BoardIdentity> ToyDevice::identify(Channel &channel)
{
    const auto reply = channel.transact(toy::request(Command::Identify));
    if (!reply)
        return tl::unexpected(reply.error());
    quint16 firmware = 0;
    quint32 serial = 0;
    if (!toy::unpack(reply->payload, [&](QDataStream &in) { in >> firmware >> serial; }))
        return failure(ErrorCode::BadReply, u"identity"_s);
    m_identity = {};
    m_identity.family = u"toy"_s;
    m_identity.model = u"Toy with five motors"_s;
    m_identity.firmware = u"%1.%2"_s.arg(firmware / 100).arg(firmware % 100);
    m_identity.firmwareNumber = firmware;
    m_identity.serial = QString::number(serial, 16);
    m_parameters = parametersOf(m_identity);
    return m_identity;
}

Result<Configuration> ToyDevice::readConfiguration(Channel &channel)
{
    Configuration configuration(m_identity, m_parameters);
    for (const BlockSpec &block : toy::blocks()) {
        auto bytes = readBlock(channel, {0, block.id});
        if (!bytes)
            return tl::unexpected(bytes.error());
        configuration.setBlock({0, block.id}, std::move(*bytes));
    }
    return configuration;
}

Result<QByteArray> ToyDevice::readBlock(Channel &channel, BlockKey key)
{
    return channel.transact(toy::request(Command::ReadBlock, QByteArray(1, char(key.block))))
        .map([](const Frame &frame) { return frame.payload; });
}

Result<void> ToyDevice::writeBlock(Channel &channel, BlockKey key, const QByteArray &bytes)
{
    Request request = toy::request(Command::WriteBlock, QByteArray(1, char(key.block)) + bytes);
    request.idempotent = false;  // the first one may have restarted it
    return channel.transact(request).map([](const Frame &) {});
}

std::span<const ActionSpec> ToyDevice::actions() const
{
    return toy::actions();
}

Result<ActionReply> ToyDevice::perform(Channel &channel, const QString &key, const QVariantMap &arguments)
{
    if (key == u"calibrate.level"_s)
        return channel.transact(toy::request(Command::Level)).map([](const Frame &) {
            return ActionReply{{u"level"_s, true}};
        });
    const int light = arguments.value(u"light"_s).toInt();
    const int times = key == u"home"_s ? 1 : arguments.value(u"times"_s).toInt();
    const auto done = channel.transact(toy::request(
        Command::Blink, toy::pack([&](QDataStream &out) { out << quint8(light) << quint8(times); })));
    return done.map([times](const Frame &) { return ActionReply{{u"times"_s, times}}; });
}

ChannelTable ToyDevice::channels() const
{
    return toy::channels();
}

Result<TelemetryPlan> ToyDevice::subscribe(Channel &, const Subscription &, std::optional<LineSettings>)
{
    TelemetryPlan plan;
    plan.decoder = std::make_shared<ToyDecoder>();
    plan.poll = toy::request(Command::Telemetry);
    plan.poll->retries = 0;
    plan.pollInterval = 25ms;
    plan.rate = 40;
    return plan;
}

std::shared_ptr<TelemetryDecoder> ToyDevice::replayDecoder() const
{
    return std::make_shared<ToyDecoder>();
}

StopPlan ToyDevice::stopPlan() const
{
    StopPlan plan;
    plan.means = {{{toy::request(Command::MotorsOff)}, 100ms, 3}, {{toy::request(Command::Kill)}, 100ms, 3}};
    plan.fromTelemetry = outputsOff;
    plan.restore = [](int round) {
        return round == 0 ? std::vector<Request>{toy::request(Command::Unlock)} : std::vector<Request>();
    };
    return plan;
}

std::span<const SteeringMode> ToyDevice::modes() const
{
    // clang-format off
    static const std::vector<SteeringMode> modes{{1, "fly", "Fly", {
        {.key = "pan", .label = "Pan", .axis = Axis::Yaw, .unit = "°/s", .min = -90, .max = 90},
        {.key = "tilt", .label = "Tilt", .axis = Axis::Pitch, .unit = "°/s", .min = -60, .max = 60},
        {.key = "throttle", .label = "Throttle", .min = 0, .max = 1, .springsBack = false},
    }}};
    // clang-format on
    return modes;
}

std::span<const SteeringSwitch> ToyDevice::switches() const
{
    return kSwitches;
}

SteeringSetpoint ToyDevice::holdingSetpoint(int mode, const LatestValues &, SteeredBefore) const
{
    return {mode, {0, 0, 0}, {0}};
}

ControlFrames ToyDevice::controlFrames(const SteeringSetpoint &setpoint) const
{
    ControlFrames frames;
    frames.setpoint = toy::encode(
        Command::Control, toy::pack([&](QDataStream &out) {
            for (std::size_t i = 0; i < modes().front().inputs.size(); ++i) {
                const SteeringInput &input = modes().front().inputs[i];
                const double wanted = i < setpoint.inputs.size() ? setpoint.inputs[i] : input.centre;
                out << float(std::clamp(std::isnan(wanted) ? input.centre : wanted, input.min, input.max));
            }
            out << quint8(setpoint.switches.empty() ? 0 : setpoint.switches.front());
        }));
    frames.stop = toy::encode(Command::Halt);
    frames.release = toy::encode(Command::Release);
    frames.stopped = outputsOff;
    return frames;
}

Family toyFamily()
{
    Family family;
    family.key = u"toy"_s;
    family.name = u"Toy"_s;
    family.links = {{LinkAddress::Kind::Udp, false}};
    family.timing.controlPeriod = 25ms;
    family.timing.heartbeatPeriod = 200ms;
    family.timing.heartbeat = [] { return toy::encode(Command::Heartbeat); };
    family.timing.silenceLimit = 1000ms;
    family.nouns.load = "drone";
    family.nouns.flies = true;
    family.makeFramer = [] { return std::make_unique<toy::ToyFramer>(); };
    family.makeDevice = [] { return std::make_unique<ToyDevice>(); };
    family.makeParameters = parametersOf;
    return family;
}
