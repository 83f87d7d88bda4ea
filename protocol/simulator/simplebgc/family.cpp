// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/simplebgc/family.h"

#include "protocol/simplebgc/device.h"
#include "protocol/simulator/simplebgc/board.h"

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

// "2.59" is 2590; "2.70b4" is 2704; "2.73.8" is 2738 (document BOARD_INFO).
Result<int> parseFirmware(const QString &text)
{
    const QStringList parts = QString(text).replace(u'b', u'.').split(u'.');
    bool ok = false;
    const int number
        = parts.value(0).toInt(&ok) * 1000 + parts.value(1).toInt() * 10 + parts.value(2).toInt();
    const bool isVersion = ok && parts.size() >= 2 && parts.value(1).size() == 2 && parts.value(2).size() <= 1
        && parts.size() <= 3;
    // What others do, no document tells.
    if (isVersion && number >= Device::kOldestFirmware && number <= Device::kNewestFirmware)
        return number;
    return failure(ErrorCode::InvalidArgument,
                   u"firmware needs a version from 2.40 to 2.74.9, like 2.43b9, 2.59, 2.70b4 or 2.73.8, not "
                   "'%1'"_s.arg(text));
}

Result<void> readBoard(SimulatorSetup &setup, const QString &text)
{
    const auto version = wholeNumber(u"board"_s, text, 10, 99);
    if (!version)
        return tl::unexpected(version.error());
    setup.options.own[u"board"_s] = *version;
    return {};
}

// A camera is mounted, but nobody has balanced it yet.
constexpr double kUnbalanced = 500;  // %
constexpr int kPulseReceiver = 1;  // see Faults::receiver

Result<void> readCondition(SimulatorSetup &setup, const QString &text)
{
    if (text != u"new"_s && text != u"used"_s)
        return failure(ErrorCode::InvalidArgument, u"condition is new or used, not '%1'"_s.arg(text));
    if (text == u"new"_s) {
        setup.options.own[u"condition"_s] = 1;
        setup.options.faults.imbalance = kUnbalanced;
        setup.options.faults.receiver = kPulseReceiver;
    }
    return {};
}

Result<void> readNumber(SimulatorSetup &setup, const QString &text)
{
    if (text != u"00"_s && text != u"ff"_s)
        return failure(ErrorCode::InvalidArgument, u"number is 00 or ff, not '%1'"_s.arg(text));
    setup.options.own[u"number"_s] = text.toInt(nullptr, 16);
    return {};
}

// One of these words; its place is the number of the option.
Result<void> readWord(SimulatorSetup &setup, const QString &option, const QStringList &words,
                      const QString &text)
{
    const qsizetype number = words.indexOf(text);
    if (number < 0)
        return failure(ErrorCode::InvalidArgument,
                       u"%1 is %2, not '%3'"_s.arg(option, words.join(u" or "_s), text));
    setup.options.own[option] = int(number);
    return {};
}

SimulatedOption fitted(const QString &name, const QStringList &help,
                       const QStringList &words = {u"0"_s, u"1"_s})
{
    return {name, u"V"_s, help, [name, words](SimulatorSetup &setup, const QString &text) {
                return readWord(setup, name, words, text);
            }};
}

Result<void> readParity(SimulatorSetup &setup, const QString &text)
{
    if (text != u"none"_s && text != u"even"_s)
        return failure(ErrorCode::InvalidArgument, u"parity is none or even, not '%1'"_s.arg(text));
    setup.parity = text == u"even"_s ? Parity::Even : Parity::None;
    return {};
}

}  // namespace

SimulatedFamily simulatedFamily()
{
    return {
        u"simplebgc"_s,
        {LinkAddress::Kind::Serial, LinkAddress::Kind::Tcp},
        {u"2.59 (default), 2.40 ... 2.73.8"_s, parseFirmware},
        {{u"board"_s, u"N"_s, {u"board version times ten, default 30"_s}, readBoard},
         {u"condition"_s,
          u"C"_s,
          {u"used (default) or new: just unpacked, with the wrong poles and a wrong direction,"_s,
           u"a sensor that sits otherwise than it is told, uncalibrated, out of balance, with"_s,
           u"a large camera, gains and motor power of nobody, thresholds of another battery, and a"_s,
           u"remote control that is mapped otherwise than its receiver is connected"_s},
          readCondition},
         {u"number"_s, u"XX"_s, {u"00 or ff: no number of its own, but bytes of that kind"_s}, readNumber},
         {u"parity"_s,
          u"P"_s,
          {u"none or even. Firmware 2.40 knows only even, later ones take both."_s,
           u"Linux pseudo-terminals carry no parity: there it changes the timing only"_s},
          readParity},
         fitted(
             u"encoders"_s,
             {u"0, 1 or new: encoders at the motors, calibrated or never calibrated. New ones tell wrong"_s,
              u"angles, and their motors are weak or run away"_s},
             {u"0"_s, u"1"_s, u"new"_s}),
         fitted(u"frame-imu"_s,
                {u"0 or 1: a motion sensor at the frame that can be selected and calibrated"_s}),
         fitted(u"legacy"_s, {u"0 or 1: it knows only the commands of the first boards"_s}),
         fitted(u"magnetometer"_s, {u"0 or 1: a magnetometer at the camera, not calibrated"_s}),
         fitted(u"fc"_s, {u"0 or 1: a flight controller gives the frame's tilt at FC_ROLL and FC_PITCH"_s})},
        [](const SimulatorOptions &options) { return std::make_unique<SimulatedBoard>(options); }};
}

}  // namespace simplebgc
