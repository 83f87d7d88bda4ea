// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Boards that know nothing newer than the first commands, whose numbers are letters: READ_PARAMS,
// WRITE_PARAMS and REALTIME_DATA (document, errata 2). Parameters other than PARAMS_3 they do not have.
#include "protocol/session/channel.h"
#include "protocol/simplebgc/device.h"
#include "protocol/simplebgc/framer.h"
#include "protocol/simplebgc/parametertables.h"
#include "protocol/simplebgc/telemetrytables.h"

namespace simplebgc {

namespace {

struct BlockCommands
{
    CommandId read;
    CommandId write;
};
// clang-format off
constexpr std::array<BlockCommands, BlockCount> kBlockCommands{{
    {CommandId::ReadParams3, CommandId::WriteParams3},
    {CommandId::ReadParamsExt, CommandId::WriteParamsExt},
    {CommandId::ReadParamsExt2, CommandId::WriteParamsExt2},
    {CommandId::ReadParamsExt3, CommandId::WriteParamsExt3},
    {CommandId::ReadAdjVarsCfg, CommandId::WriteAdjVarsCfg},
}};
// clang-format on

}  // namespace

// Asked only where BOARD_INFO_3 has no answer: whoever knows READ_PARAMS_3 is no such board.
Result<bool> Device::isOfTheFirst(Channel &channel) const
{
    constexpr int kActive = 255;
    for (const CommandId id : {CommandId::ReadParams3, CommandId::ReadParams}) {
        const auto reply = channel.transact(
            replyRequest(id, ByteWriter().u8(kActive).take(), id, kBlocks[Params3].size, kVersion));
        if (reply)
            return id == CommandId::ReadParams;
        if (reply.error().code != ErrorCode::Timeout && reply.error().code != ErrorCode::BoardError)
            return tl::unexpected(reply.error());
    }
    return false;
}

CommandId Device::readCommand(int block) const
{
    return m_isFirst && block == Params3 ? CommandId::ReadParams : kBlockCommands[std::size_t(block)].read;
}

CommandId Device::writeCommand(int block) const
{
    return m_isFirst && block == Params3 ? CommandId::WriteParams : kBlockCommands[std::size_t(block)].write;
}

// Both are answered by REALTIME_DATA_3.
Request Device::statusRequest() const
{
    const CommandId id = m_isFirst ? CommandId::RealtimeData : CommandId::RealtimeData3;
    return replyRequest(id, {}, CommandId::RealtimeData3, kRealtime3Size, kVersion);
}

}  // namespace simplebgc
