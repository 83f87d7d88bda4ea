// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What comes in from a remote control (errata 3.23 and 4.3).
#include "protocol/session/channel.h"
#include "protocol/simplebgc/actions.h"
#include "protocol/simplebgc/choices.h"
#include "protocol/simplebgc/messages.h"
#include "protocol/simplebgc/parametertables.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr int kUndefinedInput = -32768;
constexpr double kFullSignal = 16384;
constexpr int kAskedSince = 2600;  // READ_RC_INPUTS (errata 2)
constexpr int kInitialize = 1;  // of its flags
constexpr int kLastSource = 160;  // behind it are signals that the board makes itself
constexpr int kLastInputPin = 5;
// Of REALTIME_DATA_3: as many as there are functions, and in their order.
constexpr int kReportedOffset = 20;
constexpr double kReportedMiddle = 1500;
constexpr double kReportedWay = 500;
constexpr double kLongestWay = 1.2;  // of it; beyond that it is no pulse

/// It is read by a pin that no parameter names, and its motor runs away where that is disturbed.
bool isPulseEncoder(int type)
{
    constexpr int kPulseTypes[] = {3, 12, 15};  // AS5048 PWM, AS5600 PWM, RLS Orbis PWM
    return std::find(std::begin(kPulseTypes), std::end(kPulseTypes), type) != std::end(kPulseTypes);
}

/// No servo's signal comes out of it, and no serial one goes in.
bool isFreePin(int pin, const ParameterSet &parameters, const QByteArray &block)
{
    const auto rules = valueRules();
    return std::none_of(rules.begin(), rules.end(), [&](const ValueRule &rule) {
        const ParameterSpec *other = parameters.find(QLatin1String(rule.second));
        return qstrcmp(rule.first, kSignalKeys.front()) == 0 && other && other->row->block == Params3
            && rule.isBroken(pin, other->read(block).value_or(0));
    });
}

}  // namespace

// What the board sees at the inputs that its functions are mapped to.
Result<ActionReply> Actions::readSignals(const QVariantMap &)
{
    const auto active = m_device.activeProfile(m_channel);
    const auto bytes = active ? m_device.readBlock(m_channel, {*active, Params3})
                              : Result<QByteArray>(tl::unexpected(active.error()));
    if (!bytes)
        return tl::unexpected(bytes.error());
    QStringList names;
    ByteWriter writer;
    writer.u16(0);
    for (const char *input : kSignalKeys) {
        const ParameterSpec *spec = m_device.m_parameters->find(QLatin1String(input));
        const int source = spec ? int(spec->read(*bytes).value_or(0)) : 0;
        if (source == 0)
            continue;
        names.append(QLatin1String(input));
        writer.u8(source);
    }
    if (names.isEmpty())
        return failure(ErrorCode::ConditionUnmet, u"no function of this profile has a signal"_s);
    const auto frame = askInputs(writer.take(), int(names.size()));
    if (!frame)
        return tl::unexpected(frame.error());
    ByteReader reader(frame->payload);
    ActionReply reply;
    QStringList silent;
    for (const QString &name : std::as_const(names)) {
        const int raw = reader.i16();
        if (raw == kUndefinedInput)
            silent.append(name);
        else
            reply.insert(name, 100.0 * raw / kFullSignal);
    }
    if (!silent.isEmpty())
        reply.insert(u"no_signal"_s, silent.join(u", "_s));
    return reader.ok() ? Result<ActionReply>(reply) : failure(ErrorCode::BadReply, u"READ_RC_INPUTS"_s);
}

// Whether a function uses it or not. A pin that none uses is listened to only after it was made an input.
Result<ActionReply> Actions::readInputs(const QVariantMap &arguments)
{
    if (m_device.identity().firmwareNumber < kAskedSince)
        return readReportedInputs();
    bool initializes = arguments.value(u"initialize"_s).toBool();
    QByteArray block;
    if (initializes) {
        const auto active = m_device.activeProfile(m_channel);
        const auto read = active ? m_device.readBlock(m_channel, {*active, Params3})
                                 : Result<QByteArray>(tl::unexpected(active.error()));
        const auto encoders = read ? m_device.readBlock(m_channel, {*active, ParamsExt}) : read;
        if (!encoders)
            return tl::unexpected(encoders.error());
        block = *read;
        for (const Axis axis : kAxes) {
            const ParameterSpec *type
                = m_device.m_parameters->find(u"encoder.%1.type"_s.arg(QLatin1String(axisKey(axis))));
            initializes = initializes && !(type && isPulseEncoder(int(type->read(*encoders).value_or(0))));
        }
    }
    QStringList names;
    ByteWriter writer;
    writer.u16(initializes ? kInitialize : 0);
    for (const Choice &source : kSignalSources) {
        const bool isPin = source.value <= kLastInputPin;
        if (source.value == 0 || source.value > kLastSource
            || source.since > m_device.identity().firmwareNumber
            || (isPin && initializes && !isFreePin(source.value, *m_device.m_parameters, block)))
            continue;
        names.append(QLatin1String(source.name));
        writer.u8(source.value);
    }
    const auto frame = askInputs(writer.take(), int(names.size()));
    if (!frame)
        return tl::unexpected(frame.error());
    ByteReader reader(frame->payload);
    ActionReply reply;
    for (const QString &name : std::as_const(names)) {
        if (const int raw = reader.i16(); raw != kUndefinedInput)
            reply.insert(u"input."_s + name, 100.0 * raw / kFullSignal);
    }
    return reader.ok() ? Result<ActionReply>(reply) : failure(ErrorCode::BadReply, u"READ_RC_INPUTS"_s);
}

Result<Frame> Actions::askInputs(const QByteArray &question, int count)
{
    return m_channel.transact(replyRequest(CommandId::ReadRcInputs, question, CommandId::ReadRcInputs,
                                           2 * count, Device::kVersion));
}

// Older firmware tells of those inputs alone that a function is mapped to.
Result<ActionReply> Actions::readReportedInputs()
{
    const auto status = m_channel.transact(m_device.statusRequest());
    const auto active = status ? m_device.activeProfile(m_channel) : tl::unexpected(status.error());
    const auto block = active ? m_device.readBlock(m_channel, {*active, Params3})
                              : Result<QByteArray>(tl::unexpected(active.error()));
    if (!block)
        return tl::unexpected(block.error());
    ByteReader reader(status->payload);
    reader.skip(kReportedOffset);
    ActionReply reply;
    for (const char *function : kSignalKeys) {
        const double share = (reader.i16() - kReportedMiddle) / kReportedWay;
        const ParameterSpec *spec = m_device.m_parameters->find(QLatin1String(function));
        const int source = spec ? int(spec->read(*block).value_or(0)) : 0;
        const auto name = std::find_if(kSignalSources.begin(), kSignalSources.end(),
                                       [source](const Choice &each) { return each.value == source; });
        if (source != 0 && name != kSignalSources.end() && std::abs(share) <= kLongestWay)
            reply.insert(u"input."_s + QLatin1String(name->name), 100 * share);
    }
    return reader.ok() ? Result<ActionReply>(reply) : failure(ErrorCode::BadReply, u"REALTIME_DATA_3"_s);
}

}  // namespace simplebgc
