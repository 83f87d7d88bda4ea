// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/world/faults.h"

#include <cmath>
#include <functional>
#include <vector>

using namespace Qt::StringLiterals;

namespace {

struct Row
{
    const char *name;
    double min;
    double max;
    const char *families;  ///< keys of those whose simulators know it; empty: each
    const char *meaning;
    std::function<void(Faults &, double)> apply;
    [[nodiscard]] bool knows(const QString &family) const
    {
        const QString keys = QLatin1String(families);
        return family.isEmpty() || keys.isEmpty() || keys.split(u' ').contains(family);
    }
};

const std::vector<Row> &rows()
{
    // clang-format off
    static const std::vector<Row> table{
        {"lose", 0, 1, "", "probability that a byte, or a packet of a network, is lost", [](Faults &f, double v) { f.loseByte = v; }},
        {"flip", 0, 1, "", "probability that one bit of a byte is wrong", [](Faults &f, double v) { f.flipByte = v; }},
        {"double", 0, 1, "", "probability that a byte, or a packet, comes twice", [](Faults &f, double v) { f.doubleByte = v; }},
        {"delay", 0, 5000, "", "bytes to the host are held back for up to so many ms",
         [](Faults &f, double v) { f.delayMs = int(v); }},
        {"late", 0, 60000, "", "everything that the board sends comes so many ms late",
         [](Faults &f, double v) { f.lateMs = int(v); }},
        {"reorder", 0, 1, "", "probability that a packet of a network is overtaken by the one after it",
         [](Faults &f, double v) { f.reorder = v; }},
        {"unplug", 0, 86400, "", "seconds until the cable is pulled", [](Faults &f, double v) { f.unplugAfter = v; }},
        {"replug", -1, 86400, "", "seconds until it is plugged in again, -1 = never",
         [](Faults &f, double v) { f.replugAfter = v; }},
        {"reset", 0, 86400, "", "seconds until the board restarts by itself, without notice",
         [](Faults &f, double v) { f.resetAfter = v; }},
        {"reset-on-write", 0, 1000, "", "the n-th write of parameters from now on, or gain set, resets the board half-way",
         [](Faults &f, double v) { f.resetOnWrite = int(v); }},
        {"deaf", -1, 255, "", "number (STorM32: of its letter) of a command that is never answered, -1 = none",
         [](Faults &f, double v) { f.deaf = int(v); }},
        {"fail", 0, 255, "simplebgc", "code of the error with which a calibration or auto-tune ends half-way, 0 = none",
         [](Faults &f, double v) { f.failWith = int(v); }},
        {"late-streams", 0, 10, "simplebgc",
         "a calibration answers nothing, and streams go on so many seconds after it, 0 = normal",
         [](Faults &f, double v) { f.lateStreams = v; }},
        {"no-imu", 0, 1, "simplebgc storm32", "the motion sensor is missing", [](Faults &f, double v) { f.noImu = v != 0; }},
        {"frozen", 0, 1, "simplebgc storm32", "the same live data come again and again",
         [](Faults &f, double v) { f.frozen = v != 0; }},
        {"battery", 0, 30, "", "battery voltage", [](Faults &f, double v) { f.battery = v; }},
        {"heat", 0, 120, "simplebgc bcflight", "temperature of the board's sensor and of its motors, 0 = normal",
         [](Faults &f, double v) { f.heat = v; }},
        {"blocked", 0, 3, "", "an axis that something holds fast: 1 roll, 2 pitch, 3 yaw, 0 = none",
         [](Faults &f, double v) { f.blocked = int(v); }},
        {"runs-on", 0, 1, "", "commands that switch the motors off, or end a search of gains, are confirmed and not obeyed",
         [](Faults &f, double v) { f.runsOn = v != 0; }},
        {"unknown-firmware", 0, 1, "simplebgc storm32", "reports a version nobody knows",
         [](Faults &f, double v) { f.unknownFirmware = v != 0; }},
        {"other-client", 0, 86400, "simplebgc", "seconds until another client changes P of roll",
         [](Faults &f, double v) { f.otherClient = v; }},
        {"other-ground", 0, 1000, "bcflight", "packets per second of another ground station, which gets what is sent after them, 0 = none",
         [](Faults &f, double v) { f.otherGround = v; }},
        {"silent-armed", 0, 86400, "bcflight", "seconds for which it neither hears nor sends anything once it is armed, and flies on, 0 = none",
         [](Faults &f, double v) { f.silentArmed = v; }},
        {"shake", 0, 20, "", "strength of the hand that holds the gimbal, 0 = tripod",
         [](Faults &f, double v) { f.shake = v; }},
        {"swapped-axes", 0, 1, "simplebgc storm32", "roll and pitch motors are swapped",
         [](Faults &f, double v) { f.swappedAxes = v != 0; }},
        {"pose", 0, 7, "", "0 in the gimbal; 1-6 the camera lies still with Z, -Z, X, -X, Y, -Y up; 7 tilted 45 degrees down (a drone: 0 as it is, 1-7 in your "
         "hands: level, right side down, left, nose down, up, turned right, left)",
         [](Faults &f, double v) { f.pose = int(v); }},
        {"hand", 0, 6, "simplebgc", "what a hand does with the camera in the gimbal: 0 nothing, 1 holds it level, 2 moves it to and fro as far as it goes, "
         "3 tilts its nose down, 4 its right side; 5 turns it to all sides, 6 about its upright axis only",
         [](Faults &f, double v) { f.hand = int(v); }},
        {"imbalance", 0, 2000, "simplebgc", "how far off balance the camera is mounted, % of a usual one, 100 = usual",
         [](Faults &f, double v) { f.imbalance = v; }},
        {"mount", 0, 23, "simplebgc storm32", "how the sensor sits on the camera, as a STorM32 counts orientations; SimpleBGC: 4 times which of its "
         "axes points up (0 to 5: Z X Y -Z -X -Y), and which of the others to the right (with Z: 0 to 3: X Y -X -Y)",
         [](Faults &f, double v) { f.mount = int(v); }},
        {"receiver", 0, 4, "simplebgc", "receiver of a remote control at the board's inputs: 0 none, 1 a wire for each channel, 2 CPPM, 3 S-bus, 4 Spektrum",
         [](Faults &f, double v) { f.receiver = int(v); }},
        {"stick", 0, 9, "simplebgc", "stick of the transmitter that is held at an end: 0 none, 1 roll to the right, 2 to the left, 3 pitch down, 4 up, 5 yaw "
         "right, 6 left, 7 the switch up, 8 down, 9 roll and pitch",
         [](Faults &f, double v) { f.stick = int(v); }},
        {"rc-noise", 0, 100, "simplebgc", "noise of the pulses that a receiver gives, µs", [](Faults &f, double v) { f.rcNoise = v; }},
        {"rc-loss", 0, 1, "simplebgc", "probability that a frame of the transmitter is not received", [](Faults &f, double v) { f.rcLoss = v; }},
        {"frame-mount", 0, 23, "storm32", "how the second sensor sits on the frame",
         [](Faults &f, double v) { f.frameMount = int(v); }},
    };
    // clang-format on
    return table;
}

}  // namespace

Result<void> Faults::set(const QString &assignment, const QString &family)
{
    const QString name = assignment.section(u'=', 0, 0);
    QStringList names;
    for (const Row &row : rows()) {
        const bool isKnown = row.knows(family);
        if (isKnown)
            names.append(QLatin1String(row.name));
        if (name != QLatin1String(row.name))
            continue;
        if (!isKnown)
            return failure(ErrorCode::InvalidArgument,
                           u"a simulated board of %1 has no fault '%2'"_s.arg(family, name));
        bool ok = false;
        const double value = assignment.section(u'=', 1).toDouble(&ok);
        if (!ok || !std::isfinite(value) || value < row.min || value > row.max) {
            return failure(
                ErrorCode::InvalidArgument,
                u"%1 needs a number from %2 to %3, not '%4'"_s.arg(name).arg(row.min).arg(row.max).arg(
                    assignment.section(u'=', 1)));
        }
        row.apply(*this, value);
        return {};
    }
    return failure(ErrorCode::InvalidArgument,
                   u"there is no fault '%1'; there are: %2"_s.arg(name, names.join(u", "_s)));
}

QStringList Faults::help()
{
    QStringList lines;
    for (const Row &row : rows()) {
        const QString keys = QLatin1String(row.families);
        lines.append(u"%1=%2..%3"_s.arg(QLatin1String(row.name)).arg(row.min).arg(row.max).leftJustified(28)
                     + (keys.isEmpty() ? QString() : QString(keys).replace(u" "_s, u", "_s) + u": "_s)
                     + QLatin1String(row.meaning));
    }
    return lines;
}
