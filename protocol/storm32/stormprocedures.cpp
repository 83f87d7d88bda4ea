// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storm32/stormprocedures.h"

#include "protocol/storm32/parametertables.h"
#include "protocol/storm32/telemetrytables.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;
using namespace storm32;

namespace {

constexpr int kReadings = 256;               // errata 9.2
constexpr int kBatch = 16;                   // readings that are looked at together while waiting
constexpr double kStillShare = 0.012;        // of 1 g: deviation of a sensor that lies still, noise included
constexpr auto kPlaceLimit = 120s;           // for one face
constexpr auto kLookPeriod = 50ms;           // errata 9.3
constexpr double kLookFactor = 0.1;
constexpr double kLeastVector = 100;         // counts; less, and there is no sensor
constexpr double kUpShare = 0.85;
constexpr double kTiltShare = 0.35;
constexpr double kTiltOther = 0.3;
constexpr int kHeldLooks = 20;               // looks in a row, one second
constexpr auto kLevelLimit = 30s;
constexpr auto kTiltLimit = 80s;
constexpr auto kBatteryLimit = 60s;
constexpr auto kStartLimit = 40s;
constexpr auto kRestarting = 1s;
constexpr auto kStatusPeriod = 100ms;
constexpr auto kNormalFor = 1s;
constexpr int kMostBusErrors = 10;
constexpr int kMostBadAnswers = 10;
constexpr int kNormalState = 6;
constexpr int kUsageDisabled = 3;

constexpr std::array<const char *, 3> kAxisNames{"x", "y", "z"};    // of the sensor

// Words of all layouts that have a table (errata 9.3, 11).
constexpr int kOrientationWord = 39;
constexpr int kOrientation2Word = 95;
constexpr std::array<int, 3> kUsageWords{78, 79, 80};
constexpr std::array<int, 3> kPoleWords{20, 26, 32};
constexpr std::array<int, 3> kDirectionWords{21, 27, 33};
constexpr std::array<int, 3> kStartWords{23, 29, 35};
constexpr std::array<int, 5> kYawWords{58, 59, 108, 61, 62};    // input, mode, offset, least, most
constexpr std::array<int, 5> kYawAligning{0, 0, 0, -450, 450};

constexpr int kImuPresent = 0x8000;
constexpr int kImu2Present = 0x1000;
constexpr int kBatteryLow = 0x0010;
constexpr int kBatteryConnected = 0x0008;
constexpr int kLevelFailed = 0x0004;

constexpr Choice kImus[] = {{1, "Imu"}, {2, "Imu2"}};
constexpr ArgumentSpec kImu{.key = "imu", .label = "Sensor", .kind = ArgumentKind::Choice, .choices = kImus, .defaultText = "Imu"};
constexpr ArgumentSpec kAverage[] = {kImu, {.key = "readings", .label = "Readings", .min = 16, .max = 2048, .defaultText = "256"}};
constexpr ArgumentSpec kCalibrate[] = {kImu, {.key = "store", .label = "Store the result", .kind = ArgumentKind::Toggle, .defaultText = "on"}};
constexpr ArgumentSpec kWrite[] = {kImu,
    {.key = "zero.x", .label = "Zero X", .min = -32768, .max = 32767}, {.key = "zero.y", .label = "Zero Y", .min = -32768, .max = 32767},
    {.key = "zero.z", .label = "Zero Z", .min = -32768, .max = 32767}, {.key = "scale.x", .label = "Scale X", .min = 1, .max = 32767},
    {.key = "scale.y", .label = "Scale Y", .min = 1, .max = 32767}, {.key = "scale.z", .label = "Scale Z", .min = 1, .max = 32767}};
constexpr ArgumentSpec kOffset[] = {{.key = "angle", .label = "Angle", .kind = ArgumentKind::Real, .min = -45, .max = 45, .unit = "°"}};
constexpr ArgumentSpec kTake[] = {{.key = "take", .label = "Take the position over", .kind = ArgumentKind::Toggle, .defaultText = "on"}};
constexpr ArgumentSpec kTakeMotors[] = {{.key = "directions", .label = "Directions", .kind = ArgumentKind::Toggle, .defaultText = "on"},
                                        {.key = "positions", .label = "Start positions", .kind = ArgumentKind::Toggle, .defaultText = "on"}};
constexpr ArgumentSpec kPoles[] = {{.key = "pitch", .label = "Pitch", .min = 12, .max = 28, .defaultText = "14"},
                                   {.key = "roll", .label = "Roll", .min = 12, .max = 28, .defaultText = "14"},
                                   {.key = "yaw", .label = "Yaw", .min = 12, .max = 28, .defaultText = "14"}};
constexpr Choice kDirectionChoices[] = {{0, "normal"}, {1, "reversed"}, {2, "auto"}};
constexpr ArgumentSpec kDirections[] = {{.key = "direction", .label = "Direction of all motors", .kind = ArgumentKind::Choice,
                                         .choices = kDirectionChoices, .defaultText = "auto"}};

constexpr ActionSpec kActions[] = {
    {.key = "sensors.average", .label = "Average of a sensor", .help = "What an accelerometer shows over many readings, in counts.",
     .group = "Read", .arguments = kAverage, .isProcedure = true},
    {.key = "stored.compare", .label = "Compare with what is stored",
     .help = "Reloads what is stored for a moment, puts what is in use back and tells what differs.", .group = "Memory",
     .risk = ActionRisk::Writes},
    {.key = "calibrate.level", .label = "Calibrate an accelerometer, one position",
     .help = "Finds its zeros while it lies still on one face. Do it with the motors off, on USB power.", .group = "Calibration",
     .risk = ActionRisk::Writes, .arguments = kCalibrate, .isProcedure = true},
    {.key = "calibrate.six", .label = "Calibrate an accelerometer, six positions",
     .help = "Finds zeros and scales; each face has to lie up once. Do it with the motors off, on USB power.", .group = "Calibration",
     .risk = ActionRisk::Writes, .arguments = kCalibrate, .isProcedure = true},
    {.key = "calibration.write", .label = "Write a calibration", .help = "Zeros and scales of one accelerometer; stored at once.",
     .group = "Calibration", .risk = ActionRisk::Writes, .arguments = kWrite},
    {.key = "setup.motors_off", .label = "Set up: disable the motors", .help = "All three motor usages become disabled; in RAM.",
     .group = "Gimbal configuration", .risk = ActionRisk::Writes, .memory = MemoryEffect::ChangesInUse},
    {.key = "setup.orientation", .label = "Set up: find the orientation of the sensors",
     .help = "Hold the camera level, then tilt it 45° down. Sets the orientation of each sensor; in RAM.", .group = "Gimbal configuration",
     .risk = ActionRisk::Writes, .isProcedure = true, .memory = MemoryEffect::ChangesInUse},
    {.key = "setup.poles", .label = "Set up: poles of the motors", .help = "Magnets in the bells, even numbers; in RAM.",
     .group = "Gimbal configuration", .risk = ActionRisk::Writes, .arguments = kPoles, .memory = MemoryEffect::ChangesInUse},
    {.key = "setup.directions", .label = "Set up: direction of all motors", .help = "Auto lets the board find it at the next start; in RAM.",
     .group = "Gimbal configuration", .risk = ActionRisk::Writes, .arguments = kDirections, .memory = MemoryEffect::ChangesInUse},
    {.key = "setup.start", .label = "Set up: enable the motors and start",
     .help = "Waits for the battery, starts the board and waits until it works normally.", .group = "Gimbal configuration",
     .risk = ActionRisk::Writes, .isProcedure = true, .memory = MemoryEffect::ChangesInUse},
    {.key = "setup.take_motors", .label = "Set up: take directions and start positions",
     .help = "Copies what the board has found and where the motors stand; in RAM.", .group = "Gimbal configuration",
     .risk = ActionRisk::Writes, .arguments = kTakeMotors, .memory = MemoryEffect::ChangesInUse},
    {.key = "setup.yaw_begin", .label = "Set up: begin to align yaw", .help = "Steers yaw by its offset only.",
     .group = "Gimbal configuration", .risk = ActionRisk::Moves, .memory = MemoryEffect::ChangesInUse},
    {.key = "setup.yaw_move", .label = "Set up: turn yaw", .help = "Turns the camera to this angle.", .group = "Gimbal configuration",
     .risk = ActionRisk::Moves, .arguments = kOffset, .memory = MemoryEffect::ChangesInUse},
    {.key = "setup.yaw_end", .label = "Set up: end aligning yaw", .help = "Takes where yaw stands as its start position; in RAM.",
     .group = "Gimbal configuration", .risk = ActionRisk::Moves, .arguments = kTake, .memory = MemoryEffect::ChangesInUse},
};

} // namespace

std::span<const ActionSpec> StormProcedures::all()
{
    return kActions;
}

bool StormProcedures::Sensor::isPresent() const
{
    return std::hypot(acc[0], acc[1], acc[2]) >= kLeastVector;
}

double StormProcedures::oneG() const
{
    return m_device.m_firmware >= 94 ? 8192.0 : 16384.0;   // errata 3.9
}

Result<StormProcedures::Sensor> StormProcedures::sensor(int imu)
{
    const auto reply = m_channel.transact(m_device.simple(Simple::RawSensors));
    if (!reply)
        return tl::unexpected(reply.error());
    if (reply->payload.size() != 28)
        return failure(ErrorCode::BadReply, u"Cd: %1 bytes"_s.arg(reply->payload.size()));
    ByteReader reader(QByteArrayView(reply->payload).sliced(imu == 2 ? 14 : 0));
    Sensor sensor;
    for (double &axis : sensor.acc)
        axis = reader.i16();
    for (int i = 0; i < 3; ++i)
        reader.i16();   // gyroscope
    sensor.temperature = reader.i16() / 340.0 + 36.53;   // errata 3.9
    if (!sensor.isPresent())
        return failure(ErrorCode::NotSeen, u"there is no sensor Imu%1"_s.arg(imu == 2 ? u"2"_s : QString()));
    return sensor;
}

Result<StormProcedures::Average> StormProcedures::average(int imu, int readings, Progress &progress)
{
    std::vector<Sensor> all;
    Average result;
    for (int i = 0; i < readings; ++i) {
        const auto one = sensor(imu);
        if (!one)
            return tl::unexpected(one.error());
        all.push_back(*one);
        result.temperature += one->temperature / readings;
        for (std::size_t axis = 0; axis < 3; ++axis)
            result.acc[axis] += one->acc[axis] / readings;
        progress.values.insert(u"measured"_s, readings > kBatch ? double(i + 1) / readings : 0.0);
        if (i % kBatch == kBatch - 1)
            m_channel.progress(progress);
    }
    for (const Sensor &one : all) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            result.deviation += std::abs(one.acc[axis] - result.acc[axis]) / (3.0 * readings);
    }
    result.face = faceUp(result.acc, oneG());
    return result;
}

Result<StormProcedures::Average> StormProcedures::face(int imu, unsigned wanted, Progress &progress)
{
    const TimePoint until = m_channel.now() + kPlaceLimit;
    int still = 0;
    int last = -1;
    while (m_channel.now() < until) {
        progress.step = u"place-sensor"_s;
        auto seen = average(imu, kBatch, progress);
        if (!seen)
            return seen;
        const bool moves = seen->deviation > kStillShare * oneG();
        for (std::size_t axis = 0; axis < 3; ++axis)
            progress.values.insert(QLatin1String(kAxisNames[axis]), seen->acc[axis] / oneG());
        progress.values.insert(u"deviation"_s, seen->deviation / oneG());
        progress.values.insert(u"temperature"_s, seen->temperature);
        progress.values.insert(u"face"_s, seen->face);
        progress.values.insert(u"moves"_s, moves);
        m_channel.progress(progress);
        const bool good = seen->face >= 0 && !moves && wanted >> seen->face & 1U;
        still = good && seen->face == last ? still + 1 : 0;
        last = good ? seen->face : -1;
        if (still < 3)
            continue;
        progress.step = u"calibrate"_s;
        auto measured = average(imu, kReadings, progress);
        if (!measured)
            return measured;
        if (measured->face == last && measured->deviation <= kStillShare * oneG())
            return measured;
        still = 0;   // it was moved: begin again
    }
    return failure(ErrorCode::NotSeen, u"no further face lay still for %1 s"_s.arg(seconds(kPlaceLimit)));
}

ActionReply StormProcedures::replyOf(const AccCalibration &calibration, double oneG, double temperature)
{
    ActionReply reply;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        reply.insert(u"zero.%1"_s.arg(QLatin1String(kAxisNames[axis])), calibration.zero[axis]);
        reply.insert(u"scale.%1"_s.arg(QLatin1String(kAxisNames[axis])), calibration.scale[axis]);
    }
    reply.insert(u"quality"_s, calibration.quality / oneG);
    reply.insert(u"plausible"_s, isPlausible(calibration, oneG));
    reply.insert(u"one_g"_s, oneG);
    reply.insert(u"temperature"_s, temperature);
    return reply;
}

Result<ActionReply> StormProcedures::averaged(int imu, int readings)
{
    Progress progress;
    progress.step = u"calibrate"_s;
    progress.total = 1;
    const auto result = average(imu, readings, progress);
    if (!result)
        return tl::unexpected(result.error());
    return ActionReply{{u"x"_s, result->acc[0]}, {u"y"_s, result->acc[1]}, {u"z"_s, result->acc[2]}, {u"deviation"_s, result->deviation},
                       {u"temperature"_s, result->temperature}, {u"one_g"_s, oneG()}, {u"face"_s, result->face}};
}

Result<ActionReply> StormProcedures::calibrate(int imu, bool six, bool store)
{
    Progress progress;
    progress.total = six ? kAccFaces : 1;
    std::array<AccReading, kAccFaces> readings{};
    unsigned missing = (1U << kAccFaces) - 1;
    AccCalibration calibration;
    double temperature = 0;
    while (progress.done < progress.total) {
        const auto measured = face(imu, missing, progress);
        if (!measured)
            return tl::unexpected(measured.error());
        readings[std::size_t(measured->face)] = measured->acc;
        missing &= ~(1U << measured->face);
        ++progress.done;
        progress.values.insert(u"missing"_s, missing);
        m_channel.progress(progress);
        temperature = measured->temperature;
        calibration = onePointCalibration(measured->acc, oneG());
    }
    if (six)
        calibration = sixPointCalibration(readings);
    ActionReply reply = replyOf(calibration, oneG(), temperature);
    if (!store)
        return reply;
    if (!isPlausible(calibration, oneG())) {
        return failure(ErrorCode::OutOfRange, u"no sensor is like that: zeros %1 %2 %3, scales %4 %5 %6"_s.arg(calibration.zero[0])
                           .arg(calibration.zero[1]).arg(calibration.zero[2]).arg(calibration.scale[0]).arg(calibration.scale[1]).arg(calibration.scale[2]));
    }
    if (const auto written = writeCalibration(imu, calibration); !written)
        return tl::unexpected(written.error());
    reply.insert(u"stored"_s, true);
    return reply;
}

// Words of the sensor only, by its selector; read back and compared.
Result<void> StormProcedures::writeCalibration(int imu, const AccCalibration &calibration)
{
    const int first = imu == 2 ? 9 : 0;
    ByteWriter writer;
    writer.u16(imu == 2 ? 3 : 1).zeros(2 * first);
    for (const auto *values : {&calibration.zero, &calibration.scale}) {
        for (const int value : *values)
            writer.i16(value);
    }
    writer.zeros(36 - 2 * first - 12);
    if (const auto written = m_channel.transact(m_device.simple(Simple::WriteCalibration, writer.take())); !written)
        return tl::unexpected(written.error());
    const auto now = m_channel.transact(m_device.simple(Simple::ReadCalibration));
    if (!now)
        return tl::unexpected(now.error());
    ByteReader reader(QByteArrayView(now->payload).sliced(2 * first));
    for (const auto *values : {&calibration.zero, &calibration.scale}) {
        for (const int value : *values) {
            if (const int found = reader.i16(); found != value)
                return failure(ErrorCode::VerifyFailed, u"%1 was written, %2 read"_s.arg(value).arg(found));
        }
    }
    return {};
}

Result<StormProcedures::Status> StormProcedures::status()
{
    const auto reply = m_channel.transact(m_device.simple(Simple::Status));
    if (!reply)
        return tl::unexpected(reply.error());
    ByteReader reader(reply->payload);
    Status status;
    status.state = reader.u16();
    status.status = reader.u16();
    reader.u16();
    status.busErrors = reader.u16();
    return status;
}

Result<void> StormProcedures::setUsage(int usage)
{
    for (const int word : kUsageWords) {
        if (const auto done = m_device.writeWord(m_channel, word, usage); !done)
            return done;
    }
    return {};
}

Result<std::array<int, 3>> StormProcedures::holdAxis(int imu, const std::array<int, 3> *up, milliseconds limit, Progress &progress)
{
    const TimePoint until = m_channel.now() + limit;
    AccReading smooth{};
    bool begun = false;
    int held = 0;
    std::array<int, 3> last{};
    while (m_channel.now() < until) {
        const auto now = sensor(imu);
        if (!now)
            return tl::unexpected(now.error());
        for (std::size_t axis = 0; axis < 3; ++axis)
            smooth[axis] = begun ? smooth[axis] + kLookFactor * (now->acc[axis] - smooth[axis]) : now->acc[axis];
        begun = true;
        const double length = std::hypot(smooth[0], smooth[1], smooth[2]);
        std::array<int, 3> found{};
        int passed = 0;
        bool clear = true;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double share = smooth[axis] / length;
            progress.values.insert(QLatin1String(kAxisNames[axis]), smooth[axis] / oneG());
            if (up && (*up)[axis] != 0)
                continue;
            if (std::abs(share) > (up ? kTiltShare : kUpShare)) {
                // Level, the axis that points up shows gravity; tilted down, the one that points forward shows it negative.
                found[axis] = (share > 0) == (up == nullptr) ? 1 : -1;
                ++passed;
            } else if (up && std::abs(share) >= kTiltOther) {
                clear = false;
            }
        }
        const bool good = passed == 1 && clear;
        held = good && found == last ? held + 1 : 0;
        last = good ? found : std::array<int, 3>{};
        progress.values.insert(u"held"_s, std::min(1.0, double(held) / kHeldLooks));
        m_channel.progress(progress);
        if (held >= kHeldLooks)
            return found;
        if (const auto slept = m_channel.sleep(kLookPeriod); !slept)
            return tl::unexpected(slept.error());
    }
    return failure(ErrorCode::NotSeen, up ? u"the camera was not tilted 45° down, without roll, for one second"_s
                                          : u"no axis of the sensor pointed up for one second"_s);
}

Result<ActionReply> StormProcedures::findOrientation()
{
    const auto before = status();
    if (!before)
        return tl::unexpected(before.error());
    if (!(before->status & kImuPresent))
        return failure(ErrorCode::NotSeen, u"there is no sensor"_s);
    if (before->busErrors > 0)
        return failure(ErrorCode::NotSeen, u"%1 errors on the sensor's bus: check its cable"_s.arg(before->busErrors));
    const bool second = before->status & kImu2Present;
    Progress progress;
    progress.total = 2;
    progress.step = u"level-camera"_s;
    const auto up = holdAxis(1, nullptr, kLevelLimit, progress);
    if (!up)
        return tl::unexpected(up.error());
    // The second sensor sits at the frame, which is held level with the camera and tilted with it.
    const auto up2 = second ? holdAxis(2, nullptr, kLevelLimit, progress) : Result<std::array<int, 3>>(std::array<int, 3>{});
    if (!up2)
        return tl::unexpected(up2.error());
    progress.step = u"tilt-camera"_s;
    progress.done = 1;
    const auto forward = holdAxis(1, &*up, kTiltLimit, progress);
    if (!forward)
        return tl::unexpected(forward.error());
    const auto forward2 = second ? holdAxis(2, &*up2, kTiltLimit, progress) : Result<std::array<int, 3>>(std::array<int, 3>{});
    if (!forward2)
        return tl::unexpected(forward2.error());
    ActionReply reply;
    const auto set = [&](const QString &name, int word, const std::array<int, 3> &z, const std::array<int, 3> &x) -> Result<void> {
        const int number = storm32::findOrientation(z, x);
        if (number < 0)
            return failure(ErrorCode::NotSeen, u"these directions do not belong to a sensor"_s);
        reply.insert(name, QString::fromUtf8(orientations()[std::size_t(number)].name));
        return m_device.writeWord(m_channel, word, number);
    };
    if (const auto done = set(u"imu"_s, kOrientationWord, *up, *forward); !done)
        return tl::unexpected(done.error());
    if (second) {
        if (const auto done = set(u"imu2"_s, kOrientation2Word, *up2, *forward2); !done)
            return tl::unexpected(done.error());
    }
    return reply;
}

Result<ActionReply> StormProcedures::restartAndWait()
{
    Progress progress;
    progress.total = 2;
    progress.step = u"wait-battery"_s;
    const TimePoint batteryUntil = m_channel.now() + kBatteryLimit;
    for (;;) {
        const auto now = status();
        if (!now)
            return tl::unexpected(now.error());
        if ((now->status & kBatteryConnected) && !(now->status & kBatteryLow))
            break;
        if (m_channel.now() >= batteryUntil)
            return failure(ErrorCode::NotSeen, now->status & kBatteryConnected ? u"the battery is low"_s : u"no battery was connected"_s);
        m_channel.progress(progress);
        if (const auto slept = m_channel.sleep(kStatusPeriod); !slept)
            return tl::unexpected(slept.error());
    }
    const auto before = m_device.readStream(m_channel);
    if (!before)
        return tl::unexpected(before.error());
    if (const auto started = m_channel.transact(m_device.simple(Simple::NormalMotors)); !started)
        return tl::unexpected(started.error());
    progress.step = u"wait-start"_s;
    progress.done = 1;
    m_channel.progress(progress);
    if (const auto slept = m_channel.sleep(kRestarting); !slept)
        return tl::unexpected(slept.error());
    // Whether a restart keeps what is in use is not told (errata 3.9): what was set before is looked after.
    QByteArray wanted = *before;
    for (const int word : kUsageWords)
        wanted.replace(2 * word, 2, QByteArray(2, '\0'));
    int bad = 0;
    const TimePoint until = m_channel.now() + kStartLimit;
    TimePoint normalSince = TimePoint::max();
    bool restored = false;
    while (m_channel.now() < until) {
        const auto now = status();
        if (!now && (now.error().code != ErrorCode::Timeout && now.error().code != ErrorCode::BoardError))
            return tl::unexpected(now.error());
        if (!now && ++bad > kMostBadAnswers)
            return tl::unexpected(now.error());
        if (now) {
            if (now->status & kLevelFailed)
                return failure(ErrorCode::NotSeen, u"the board could not level: hold the camera still"_s);
            if (!(now->status & kImuPresent))
                return failure(ErrorCode::NotSeen, u"the sensor was lost"_s);
            if (now->busErrors > kMostBusErrors)
                return failure(ErrorCode::NotSeen, u"%1 errors on the sensor's bus"_s.arg(now->busErrors));
            if (!std::exchange(restored, true)) {
                const auto after = m_device.readStream(m_channel);
                if (!after)
                    return tl::unexpected(after.error());
                if (*after != wanted && !m_device.isEmbedded()) {
                    if (const auto put = m_channel.transact(m_device.simple(Simple::PutParameters, wanted)); !put)
                        return tl::unexpected(put.error());
                }
            }
            if (now->state != kNormalState)
                normalSince = TimePoint::max();
            else if (normalSince == TimePoint::max())
                normalSince = m_channel.now();
            else if (m_channel.now() - normalSince >= kNormalFor)
                return ActionReply{{u"state"_s, stateName(now->state, m_device.m_firmware)}};
            progress.values.insert(u"state"_s, now->state);
            m_channel.progress(progress);
        }
        if (const auto slept = m_channel.sleep(kStatusPeriod); !slept)
            return tl::unexpected(slept.error());
    }
    return failure(ErrorCode::NotSeen, u"the board did not reach normal working"_s);
}

Result<ActionReply> StormProcedures::takeMotors(bool directions, bool positions)
{
    for (const auto &[id, wanted] : {std::pair{Simple::TakeDirections, directions}, {Simple::TakeStartPositions, positions}}) {
        if (!wanted)
            continue;
        if (const auto done = m_channel.transact(m_device.simple(id)); !done)
            return tl::unexpected(done.error());
    }
    ActionReply reply;
    static constexpr std::array<const char *, 3> kNames{"pitch", "roll", "yaw"};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto direction = m_device.readWord(m_channel, kDirectionWords[axis]);
        if (!direction)
            return tl::unexpected(direction.error());
        reply.insert(u"direction.%1"_s.arg(QLatin1String(kNames[axis])), *direction == 0 ? u"normal"_s : *direction == 1 ? u"reversed"_s : u"auto"_s);
        if (axis == 2)
            break;   // where yaw begins is aligned by hand
        const auto position = m_device.readWord(m_channel, kStartWords[axis]);
        if (!position)
            return tl::unexpected(position.error());
        reply.insert(u"start.%1"_s.arg(QLatin1String(kNames[axis])), *position);
    }
    return reply;
}

Result<ActionReply> StormProcedures::setPoles(const std::array<int, 3> &poles)
{
    for (std::size_t axis = 0; axis < poles.size(); ++axis) {
        if (poles[axis] % 2 != 0)
            return failure(ErrorCode::InvalidArgument, u"magnets come in pairs: %1 is odd"_s.arg(poles[axis]));
    }
    for (std::size_t axis = 0; axis < poles.size(); ++axis) {
        if (const auto done = m_device.writeWord(m_channel, kPoleWords[axis], poles[axis]); !done)
            return tl::unexpected(done.error());
    }
    return ActionReply{};
}

Result<ActionReply> StormProcedures::beginYaw()
{
    if (!m_device.m_yawBefore) {
        std::array<int, 5> before{};
        for (std::size_t i = 0; i < kYawWords.size(); ++i) {
            const auto word = m_device.readWord(m_channel, kYawWords[i]);
            if (!word)
                return tl::unexpected(word.error());
            before[i] = *word;
        }
        m_device.m_yawBefore = before;
    }
    for (std::size_t i = 0; i < kYawWords.size(); ++i) {
        if (const auto done = m_device.writeWord(m_channel, kYawWords[i], kYawAligning[i]); !done)
            return tl::unexpected(done.error());
    }
    return ActionReply{};
}

Result<ActionReply> StormProcedures::moveYaw(double degrees)
{
    if (!m_device.m_yawBefore)
        return failure(ErrorCode::InvalidArgument, u"begin to align yaw first"_s);
    const auto done = m_device.writeWord(m_channel, kYawWords[2], int(std::lround(degrees * 10.0)));
    if (!done)
        return tl::unexpected(done.error());
    return ActionReply{};
}

Result<ActionReply> StormProcedures::endYaw(bool take)
{
    if (!m_device.m_yawBefore)
        return failure(ErrorCode::InvalidArgument, u"begin to align yaw first"_s);
    ActionReply reply;
    if (take) {
        if (const auto taken = m_channel.transact(m_device.simple(Simple::TakeYawStartPosition)); !taken)
            return tl::unexpected(taken.error());
        const auto position = m_device.readWord(m_channel, kStartWords[2]);
        if (!position)
            return tl::unexpected(position.error());
        reply.insert(u"start.yaw"_s, *position);
    }
    for (std::size_t i = 0; i < kYawWords.size(); ++i) {
        if (const auto done = m_device.writeWord(m_channel, kYawWords[i], (*m_device.m_yawBefore)[i]); !done)
            return tl::unexpected(done.error());
    }
    m_device.m_yawBefore.reset();
    return reply;
}

// No command reads the EEPROM beside the RAM: what is stored is put into use, read, and what was in use put back.
Result<ActionReply> StormProcedures::compareStored()
{
    if (m_device.isEmbedded())
        return failure(ErrorCode::Unsupported, u"switch the heartbeat off first"_s);
    const auto inUse = m_device.readStream(m_channel);
    if (!inUse)
        return tl::unexpected(inUse.error());
    if (const auto loaded = m_channel.transact(m_device.simple(Simple::Retrieve)); !loaded)
        return tl::unexpected(loaded.error());
    const auto stored = m_device.readStream(m_channel);
    const auto put = m_channel.transact(m_device.simple(Simple::PutParameters, *inUse));
    if (!stored)
        return tl::unexpected(stored.error());
    if (!put)
        return tl::unexpected(put.error());
    ActionReply reply{{u"unstored"_s, *stored != *inUse}};
    Configuration use(m_device.identity(), m_device.parameters());
    Configuration kept = use;
    for (const auto &[block, bytes] : splitStream(*inUse, m_device.m_words))
        use.setBlock({0, block}, bytes);
    for (const auto &[block, bytes] : splitStream(*stored, m_device.m_words))
        kept.setBlock({0, block}, bytes);
    for (const ParameterChange &change : kept.changesTo(use))
        reply.insert(change.spec->key, u"%1 in use, %2 stored"_s.arg(change.spec->format(change.to), change.spec->format(change.from)));
    for (const DataChange &change : kept.dataChangesTo(use))
        reply.insert(QLatin1String(change.spec->data), u"not stored"_s);
    return reply;
}

Result<ActionReply> StormProcedures::perform(const QString &key, const QVariantMap &arguments)
{
    const int imu = arguments.value(u"imu"_s).toInt();
    const auto nothing = [](const Result<void> &done) { return done ? Result<ActionReply>(ActionReply()) : tl::unexpected(done.error()); };
    if (key == u"sensors.average"_s)
        return averaged(imu, arguments.value(u"readings"_s).toInt());
    if (key == u"stored.compare"_s)
        return compareStored();
    if (key == u"calibrate.level"_s || key == u"calibrate.six"_s)
        return calibrate(imu, key == u"calibrate.six"_s, arguments.value(u"store"_s).toBool());
    if (key == u"calibration.write"_s) {
        AccCalibration calibration;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            calibration.zero[axis] = arguments.value(u"zero.%1"_s.arg(QLatin1String(kAxisNames[axis]))).toInt();
            calibration.scale[axis] = arguments.value(u"scale.%1"_s.arg(QLatin1String(kAxisNames[axis]))).toInt();
        }
        return nothing(writeCalibration(imu, calibration));
    }
    if (key == u"setup.motors_off"_s)
        return nothing(setUsage(kUsageDisabled));
    if (key == u"setup.orientation"_s)
        return findOrientation();
    if (key == u"setup.directions"_s) {
        for (const int word : kDirectionWords) {
            if (const auto done = m_device.writeWord(m_channel, word, arguments.value(u"direction"_s).toInt()); !done)
                return tl::unexpected(done.error());
        }
        return ActionReply{};
    }
    if (key == u"setup.poles"_s)
        return setPoles({arguments.value(u"pitch"_s).toInt(), arguments.value(u"roll"_s).toInt(), arguments.value(u"yaw"_s).toInt()});
    if (key == u"setup.start"_s)
        return restartAndWait();
    if (key == u"setup.take_motors"_s)
        return takeMotors(arguments.value(u"directions"_s).toBool(), arguments.value(u"positions"_s).toBool());
    if (key == u"setup.yaw_begin"_s)
        return beginYaw();
    if (key == u"setup.yaw_move"_s)
        return moveYaw(arguments.value(u"angle"_s).toDouble());
    if (key == u"setup.yaw_end"_s)
        return endYaw(arguments.value(u"take"_s).toBool());
    return failure(ErrorCode::Unsupported, key);
}
