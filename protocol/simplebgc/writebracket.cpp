// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What comes before and after blocks are written.
#include "protocol/session/channel.h"
#include "protocol/simplebgc/commands.h"
#include "protocol/simplebgc/device.h"

using namespace Qt::StringLiterals;

namespace simplebgc {

Error Device::otherIdentity(const BoardInfo &now, const QString &model, const QString &firmware)
{
    return {ErrorCode::BadReply,
            u"it says now that it is a %1 with firmware %2, and said a %3 with firmware %4 before"_s.arg(
                now.modelText(), now.firmwareText(), model, firmware),
            0};
}

// What a board with another version or firmware made of the bytes, nobody knows.
Result<void> Device::checkIdentity(Channel &channel) const
{
    const auto reply
        = channel.transact(replyRequest(CommandId::BoardInfo, {}, CommandId::BoardInfo, 18, kVersion));
    if (!reply)
        return tl::unexpected(reply.error());
    const auto info = BoardInfo::decode(asBytes(reply->payload));
    if (!info)
        return tl::unexpected(info.error());
    if (info->modelText() == m_identity.model && info->firmware == m_identity.firmwareNumber)
        return {};
    return tl::unexpected(otherIdentity(*info, m_identity.model, m_identity.firmware));
}

Result<void> Device::beginWrite(Channel &channel)
{
    if (const auto same = checkIdentity(channel); !same)
        return same;
    if (m_identity.firmwareNumber < 2704)  // WRITE_PARAMS_SET came with 2.70b4 (errata 3.3)
        return {};
    const auto reply
        = channel.transact(confirmRequest(CommandId::WriteParamsSet, ByteWriter().u8(1).take(), kVersion));
    return reply ? Result<void>() : tl::unexpected(reply.error());
}

Result<void> Device::endWrite(Channel &channel)
{
    if (m_identity.firmwareNumber < 2704)
        return {};
    const auto reply
        = channel.transact(confirmRequest(CommandId::WriteParamsSet, ByteWriter().u8(0).take(), kVersion));
    return reply ? Result<void>() : tl::unexpected(reply.error());
}

}  // namespace simplebgc
