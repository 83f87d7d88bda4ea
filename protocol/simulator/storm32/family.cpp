// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/storm32/family.h"

#include "protocol/simulator/storm32/board.h"

using namespace Qt::StringLiterals;

namespace storm32 {

namespace {

// Firmware versions of the simulated board, each with its layout (errata 5).
Result<int> parseFirmware(const QString &text)
{
    for (const int known : {79, 90, 96}) {
        if (text == u"0.%1"_s.arg(known) || text == u"v0.%1"_s.arg(known))
            return known;
    }
    return failure(ErrorCode::InvalidArgument, u"firmware is 0.79, 0.90 or 0.96, not '%1'"_s.arg(text));
}

Result<void> readStrict(SimulatorSetup &setup, const QString &text)
{
    setup.options.own[u"strict"_s] = text != u"0"_s;
    return {};
}

}  // namespace

SimulatedFamily simulatedFamily()
{
    return {u"storm32"_s,
            {LinkAddress::Kind::Serial, LinkAddress::Kind::Tcp},
            {u"0.79, 0.90, 0.96 (default)"_s, parseFirmware},
            {{u"strict"_s,
              u"1"_s,
              {u"refuse frames that the real firmware lets pass, to test a client"_s},
              readStrict}},
            [](const SimulatorOptions &options) { return std::make_unique<SimulatedBoard>(options); }};
}

}  // namespace storm32
