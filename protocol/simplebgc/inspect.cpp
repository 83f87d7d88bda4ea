// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/session/channel.h"
#include "protocol/simplebgc/adjustables.h"
#include "protocol/simplebgc/device.h"
#include "protocol/simplebgc/framer.h"
#include "protocol/simplebgc/frametext.h"

#include <array>

using namespace Qt::StringLiterals;

namespace simplebgc {

// Inspection: adjustable variables, notch filters, debug variables, frames in readable form.

std::span<const AdjustableSpec> Device::adjustables() const
{
    return m_isFirst ? std::span<const AdjustableSpec>() : adjustablesOf(m_identity.firmwareNumber);
}

std::vector<NotchFilter> Device::notchesOf(Axis axis) const
{
    std::vector<NotchFilter> filters;
    const QString prefix = u"filter.%1."_s.arg(QLatin1String(axisKey(axis)));
    for (int n = 0; n < 3; ++n) {
        const QString notch = prefix + u"notch%1."_s.arg(n + 1);
        if (m_parameters && m_parameters->find(notch + u"frequency"_s))
            filters.push_back(
                {notch + u"frequency"_s, notch + u"width"_s, notch + u"gain"_s, prefix + u"enabled"_s, n});
    }
    return filters;
}

Result<std::vector<DebugVariable>> Device::debugVariables(Channel &channel)
{
    std::vector<DebugVar> vars;
    for (;;) {
        // From 2.72b0 a long list comes in parts, requested by start index (errata 3.17).
        const QByteArray payload = vars.empty() ? QByteArray() : ByteWriter().u8(int(vars.size())).take();
        const auto reply = channel.transact(
            replyRequest(CommandId::DebugVarsInfo3, payload, CommandId::DebugVarsInfo3, 255, kVersion));
        if (!reply)
            return tl::unexpected(reply.error());
        const auto part = decodeDebugVarsInfo(asBytes(reply->payload));
        if (!part)
            return tl::unexpected(part.error());
        vars.insert(vars.end(), part->vars.begin(), part->vars.end());
        if (int(vars.size()) >= part->total || part->vars.empty() || m_identity.firmwareNumber < 2720)
            break;
    }
    m_debugVars = vars;
    constexpr std::array<const char *, 8> types{"?", "u8", "i8", "u16", "i16", "u32", "i32", "f32"};
    constexpr std::array<Axis, 4> axes{Axis::None, Axis::Roll, Axis::Pitch, Axis::Yaw};
    std::vector<DebugVariable> list;
    for (const DebugVar &var : vars) {
        DebugVariable variable;
        variable.name = var.name;
        variable.type
            = QLatin1String(types[std::size_t(var.type) < types.size() ? std::size_t(var.type) : 0]);
        variable.elements = std::max(1, var.count);
        if (variable.elements > 1)
            variable.type += u"[%1]"_s.arg(variable.elements);
        variable.axis = axes[std::size_t(var.axis) < axes.size() ? std::size_t(var.axis) : 0];
        list.push_back(std::move(variable));
    }
    return list;
}

Result<std::vector<std::vector<double>>> Device::readDebugVariables(Channel &channel)
{
    if (m_debugVars.empty()) {
        if (const auto known = debugVariables(channel); !known)
            return tl::unexpected(known.error());
    }
    const auto frame
        = channel.transact(replyRequest(CommandId::DebugVars3, {}, CommandId::DebugVars3, 255, kVersion));
    if (!frame)
        return tl::unexpected(frame.error());
    return decodeDebugVars(m_debugVars, asBytes(frame->payload));
}

FrameText Device::describeFrame(const FrameView &frame, bool fromBoard) const
{
    return simplebgc::describeFrame(frame, fromBoard, m_parameters.get(), m_identity.firmwareNumber);
}

// Both directions use the same frames.
FrameText Device::describeSent(QByteArrayView bytes) const
{
    Framer framer;
    return describeFrames(bytes, framer);
}

bool Device::isTelemetryFrame(int id) const
{
    return id == number(CommandId::RealtimeData3) || id == number(CommandId::RealtimeData4)
        || id == number(CommandId::RealtimeDataCustom) || id == number(CommandId::AhrsHelper);
}

Result<RawCommand> Device::parseCommand(const QString &text) const
{
    return simplebgc::parseCommand(text, kVersion, m_identity.firmwareNumber);
}

QStringList Device::commandNames() const
{
    return simplebgc::commandNames();
}

}  // namespace simplebgc
