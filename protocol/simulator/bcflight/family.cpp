// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/bcflight/family.h"

#include "protocol/base/filefault.h"
#include "protocol/bcflight/tables.h"
#include "protocol/simulator/bcflight/board.h"

#include <QFileInfo>

using namespace Qt::StringLiterals;

namespace bcflight {

namespace {

Result<void> readGeneration(SimulatorSetup &setup, const QString &text)
{
    const QString letters = u"ABCDEFG"_s;
    const qsizetype found = text.size() == 1 ? letters.indexOf(text.toUpper()) : -1;
    if (found < 0)
        return failure(ErrorCode::InvalidArgument, u"generation is A to G, not '%1'"_s.arg(text));
    setup.options.own[QLatin1String(SimulatedBoard::kGeneration)] = int(found) + 1;
    return {};
}

// A file that is not there yet gets the shipped text.
Result<void> readConfigurationFile(SimulatorSetup &setup, const QString &text)
{
    const QString path = QFileInfo(text).absoluteFilePath();
    const auto there = QFileInfo::exists(path)
        ? readWhole(path, FileKind::Other, kLargestText).map([](const QByteArray &) {})
        : writeWhole(path, SimulatedBoard::shippedConfiguration());
    if (there)
        setup.options.memoryFile = path;
    return there;
}

Result<void> readFrameRate(SimulatorSetup &setup, const QString &text)
{
    if (text != u"30"_s && text != u"60"_s)
        return failure(ErrorCode::InvalidArgument, u"frames is 30 or 60, not '%1'"_s.arg(text));
    setup.options.own[QLatin1String(SimulatedBoard::kFrameRate)] = text.toInt();
    return {};
}

SimulatedOption switchOption(const char *name, const QString &help)
{
    const QString key = QLatin1String(name);
    return {key, u"0"_s, {help}, [key](SimulatorSetup &setup, const QString &text) -> Result<void> {
                const auto number = wholeNumber(key, text, 0, 1);
                if (number)
                    setup.options.own[key] = *number;
                return number.map([](int) {});
            }};
}

// Its program carries no number that anything depends on.
Result<int> parseFirmware(const QString &text)
{
    if (text == u"1.0"_s)
        return 1;
    return failure(ErrorCode::InvalidArgument, u"firmware is 1.0, not '%1'; see generation"_s.arg(text));
}

}  // namespace

SimulatedFamily simulatedFamily()
{
    return {
        u"bcflight"_s,
        {LinkAddress::Kind::Udp, LinkAddress::Kind::Tcp},
        {u"1.0 (see generation)"_s, parseFirmware},
        {{QLatin1String(SimulatedBoard::kGeneration),
          u"G"_s,
          {u"which generation of the protocol it speaks: A to G (default)"_s},
          readGeneration},
         {u"config"_s,
          u"FILE"_s,
          {u"its configuration text lies there, and what is uploaded as well; else in memory"_s},
          readConfigurationFile},
         switchOption(SimulatedBoard::kCamera, u"0: it has no camera"_s),
         switchOption(SimulatedBoard::kVideoless,
                      u"1: its program was built without video: it tells nothing of cameras and sensors"_s),
         {QLatin1String(SimulatedBoard::kFrameRate),
          u"N"_s,
          {u"frames per second of its camera: 30 (default) or 60"_s},
          readFrameRate},
         switchOption(SimulatedBoard::kJpegs, u"1: its camera sends JPEGs instead of H.264"_s),
         switchOption(SimulatedBoard::kTransmitter, u"0: it has no video transmitter"_s),
         switchOption(SimulatedBoard::kNotch,
                      u"1: its notch filter follows the rates; it streams their spectrum"_s),
         switchOption(SimulatedBoard::kStand,
                      u"1: it turns freely in a test stand; else it stands on the ground"_s)},
        [](const SimulatorOptions &options) {
            SimulatorOptions made = options;
            const QString stand = QLatin1String(SimulatedBoard::kStand);
            made.own.insert(stand, options.own.value(stand, 0));
            return std::make_unique<SimulatedBoard>(made);
        }};
}

}  // namespace bcflight
