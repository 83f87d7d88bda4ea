// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The gimbal configuration tasks (errata 9.3).
#include "protocol/storm32/orientations.h"
#include "protocol/storm32/parametertables.h"
#include "protocol/storm32/procedures.h"
#include "protocol/storm32/telemetrytables.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace storm32 {

namespace {

constexpr auto kLookPeriod = 50ms;
constexpr double kLookFactor = 0.1;
constexpr double kUpShare = 0.85;
constexpr double kTiltShare = 0.35;
constexpr double kTiltOther = 0.3;
constexpr int kHeldLooks = 20;  // consecutive readings, one second
constexpr auto kLevelLimit = 30s;
constexpr auto kTiltLimit = 80s;
constexpr auto kBatteryLimit = 60s;
constexpr auto kStartLimit = 40s;
constexpr auto kRestarting = 1s;
constexpr auto kStatusPeriod = 100ms;
constexpr auto kNormalFor = 1s;
constexpr int kMaxBusErrors = 10;
constexpr int kMaxBadAnswers = 10;
constexpr int kNormalState = 6;
constexpr int kUsageDisabled = 3;

// Word numbers, the same in all layouts with a table (errata 9.3, 11).
constexpr int kOrientationWord = 39;
constexpr int kOrientation2Word = 95;
constexpr std::array<int, 3> kUsageWords{78, 79, 80};
constexpr std::array<int, 3> kPoleWords{20, 26, 32};
constexpr std::array<int, 3> kDirectionWords{21, 27, 33};
constexpr std::array<int, 3> kStartWords{23, 29, 35};
constexpr std::array<int, 5> kYawWords{58, 59, 108, 61, 62};  // input, mode, offset, minimum, maximum
constexpr std::array<int, 5> kYawAligning{0, 0, 0, -450, 450};

constexpr int kImuPresent = 0x8000;
constexpr int kImu2Present = 0x1000;
constexpr int kBatteryLow = 0x0010;
constexpr int kBatteryConnected = 0x0008;
constexpr int kLevelFailed = 0x0004;

using Direction = std::array<int, 3>;

// Which of the sensor's axes points up, in which direction, or, with the camera tilted down, forward; empty
// while it is not clear.
Direction directionOf(const AccReading &reading, const Direction *up)
{
    const double length = std::hypot(reading[0], reading[1], reading[2]);
    Direction found{};
    int passed = 0;
    for (std::size_t axis = 0; axis < found.size(); ++axis) {
        const double share = reading[axis] / length;
        if (up && (*up)[axis] != 0)
            continue;
        if (std::abs(share) > (up ? kTiltShare : kUpShare)) {
            // When level, the axis that points up measures gravity; when tilted down, the axis that points
            // forward measures it as negative.
            found[axis] = (share > 0) == (up == nullptr) ? 1 : -1;
            ++passed;
        } else if (up && std::abs(share) >= kTiltOther) {
            return {};
        }
    }
    return passed == 1 ? found : Direction{};
}

}  // namespace

Result<Procedures::Status> Procedures::status()
{
    const auto reply = m_channel.transact(m_device.simple(Simple::Status));
    if (!reply)
        return tl::unexpected(reply.error());
    ByteReader reader(reply->payload);
    Status status;
    status.state = reader.u16();
    status.status = reader.u16();
    status.motors = reader.u16() & kMotorBits;
    status.busErrors = reader.u16();
    return status;
}

Result<void> Procedures::writeWords(const std::array<int, 3> &words, int raw)
{
    for (const int word : words) {
        if (const auto done = m_device.writeWord(m_channel, word, raw); !done)
            return done;
    }
    return {};
}

Result<void> Procedures::disableMotors()
{
    return writeWords(kUsageWords, kUsageDisabled);
}

Result<Procedures::Directions> Procedures::holdAxes(std::size_t count, const Directions *up,
                                                    milliseconds limit, Progress &progress)
{
    const TimePoint until = m_channel.now() + limit;
    std::array<AccReading, 2> smooth{};
    std::optional<Error> impossible;
    bool begun = false;
    int held = 0;
    Directions last{};
    while (m_channel.now() < until) {
        const auto now = sensors();
        if (!now)
            return tl::unexpected(now.error());
        Directions found{};
        bool good = true;
        impossible.reset();
        for (std::size_t imu = 0; imu < count; ++imu) {
            if (!(*now)[imu].isPresent())
                return failure(ErrorCode::NotSeen,
                               u"the sensor Imu%1 was lost"_s.arg(imu == 1 ? u"2"_s : QString()));
            for (std::size_t axis = 0; axis < 3; ++axis) {
                double &kept = smooth[imu][axis];
                kept = begun ? kept + kLookFactor * ((*now)[imu].acc[axis] - kept) : (*now)[imu].acc[axis];
            }
            found[imu] = directionOf(smooth[imu], up ? &(*up)[imu] : nullptr);
            if (!isGravity(smooth[imu], oneG()))
                impossible = notGravity(smooth[imu]);
            good = good && !impossible && found[imu] != Direction{};
        }
        begun = true;
        for (std::size_t axis = 0; axis < 3; ++axis)
            progress.values.insert(QLatin1String(kSensorAxes[axis]), smooth[0][axis] / oneG());
        held = !good ? 0 : found == last ? held + 1 : 1;
        last = found;
        progress.values.insert(u"held"_s, std::min(1.0, double(held) / kHeldLooks));
        m_channel.progress(progress);
        if (held >= kHeldLooks)
            return found;
        if (const auto slept = m_channel.sleep(kLookPeriod); !slept)
            return tl::unexpected(slept.error());
    }
    if (impossible)
        return tl::unexpected(*impossible);
    return failure(ErrorCode::NotSeen,
                   up ? u"the camera was not tilted 45° down, without roll, for one second"_s
                      : u"no axis of the sensor pointed up for one second"_s);
}

Result<ActionReply> Procedures::findOrientation()
{
    const auto before = status();
    if (!before)
        return tl::unexpected(before.error());
    if (!(before->status & kImuPresent))
        return failure(ErrorCode::NotSeen, u"there is no sensor"_s);
    if (before->busErrors > 0)
        return failure(ErrorCode::NotSeen,
                       u"%1 errors on the sensor's bus: check its cable"_s.arg(before->busErrors));
    if (before->motors != 0) {
        return failure(ErrorCode::ConditionUnmet,
                       u"the motors are running; setup.motors_off disables them first"_s);
    }
    struct Place
    {
        const char *name;
        int word;
    };
    constexpr std::array<Place, 2> kPlaces{{{"imu", kOrientationWord}, {"imu2", kOrientation2Word}}};
    // The second sensor is on the frame, which is held level and tilted together with the camera.
    const std::size_t count = before->status & kImu2Present ? 2 : 1;
    Progress progress;
    progress.total = 2;
    progress.step = u"level-camera"_s;
    const auto up = holdAxes(count, nullptr, kLevelLimit, progress);
    if (!up)
        return tl::unexpected(up.error());
    progress.step = u"tilt-camera"_s;
    progress.done = 1;
    const auto forward = holdAxes(count, &*up, kTiltLimit, progress);
    if (!forward)
        return tl::unexpected(forward.error());
    ActionReply reply;
    for (std::size_t imu = 0; imu < count; ++imu) {
        const int number = storm32::findOrientation((*up)[imu], (*forward)[imu]);
        if (number < 0)
            return failure(ErrorCode::NotSeen, u"these directions do not belong to a sensor"_s);
        reply.insert(QLatin1String(kPlaces[imu].name),
                     QString::fromUtf8(orientations()[std::size_t(number)].name));
        if (const auto done = m_device.writeWord(m_channel, kPlaces[imu].word, number); !done)
            return tl::unexpected(done.error());
    }
    return reply;
}

Result<ActionReply> Procedures::restartAndWait()
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
            return failure(ErrorCode::NotSeen,
                           now->status & kBatteryConnected ? u"the battery is low"_s
                                                           : u"no battery was connected"_s);
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
    // It is not documented whether a restart keeps the values in use (errata 3.9): those set before are
    // checked.
    QByteArray wanted = *before;
    for (const int word : kUsageWords)
        wanted.replace(2 * word, 2, QByteArray(2, '\0'));
    int bad = 0;
    const TimePoint until = m_channel.now() + kStartLimit;
    TimePoint normalSince = TimePoint::max();
    bool restored = false;
    bool hasStarted = false;  // its answer to the command says nothing
    while (m_channel.now() < until) {
        const auto now = status();
        const bool tolerable = now || now.error().code == ErrorCode::Timeout
            || now.error().code == ErrorCode::Damaged || now.error().code == ErrorCode::BoardError;
        if (!tolerable || (!now && ++bad > kMaxBadAnswers))
            return tl::unexpected(now.error());
        if (now) {
            if (now->status & kLevelFailed)
                return failure(ErrorCode::NotSeen, u"the board could not level: hold the camera still"_s);
            if (!(now->status & kImuPresent))
                return failure(ErrorCode::NotSeen, u"the sensor was lost"_s);
            if (now->busErrors > kMaxBusErrors)
                return failure(ErrorCode::NotSeen, u"%1 errors on the sensor's bus"_s.arg(now->busErrors));
            if (!std::exchange(restored, true)) {
                const auto after = m_device.readStream(m_channel);
                if (!after)
                    return tl::unexpected(after.error());
                if (*after != wanted && !m_device.isEmbedded()) {
                    if (const auto put = m_channel.transact(m_device.simple(Simple::PutParameters, wanted));
                        !put)
                        return tl::unexpected(put.error());
                    const auto found = m_device.readStream(m_channel);
                    if (!found)
                        return tl::unexpected(found.error());
                    if (*found != wanted)
                        return failure(ErrorCode::NotInUse, u"what was set up before the restart"_s);
                }
            }
            hasStarted |= now->state < kMotorsTurn;
            if (now->state != kNormalState)
                normalSince = TimePoint::max();
            else if (normalSince == TimePoint::max())
                normalSince = m_channel.now();
            else if (m_channel.now() - normalSince >= kNormalFor && !hasStarted)
                return failure(ErrorCode::NoEffect, u"the board works normally, but has not restarted"_s);
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

Result<ActionReply> Procedures::takeMotors(bool directions, bool positions)
{
    for (const auto &[id, wanted] :
         {std::pair{Simple::TakeDirections, directions}, {Simple::TakeStartPositions, positions}}) {
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
        reply.insert(u"direction.%1"_s.arg(QLatin1String(kNames[axis])),
                     *direction == 0       ? u"normal"_s
                         : *direction == 1 ? u"reversed"_s
                                           : u"auto"_s);
        if (directions && *direction == kAutoDirection)
            return failure(ErrorCode::NoEffect,
                           u"the direction of %1 is still on auto"_s.arg(QLatin1String(kNames[axis])));
        if (axis == 2)
            break;  // the start position of yaw is aligned by hand
        const auto position = m_device.readWord(m_channel, kStartWords[axis]);
        if (!position)
            return tl::unexpected(position.error());
        reply.insert(u"start.%1"_s.arg(QLatin1String(kNames[axis])), *position);
    }
    return reply;
}

Result<void> Procedures::setDirections(int direction)
{
    return writeWords(kDirectionWords, direction);
}

Result<ActionReply> Procedures::setPoles(const std::array<int, 3> &poles)
{
    for (std::size_t axis = 0; axis < poles.size(); ++axis) {
        if (poles[axis] % 2 != 0)
            return failure(ErrorCode::InvalidArgument,
                           u"magnets come in pairs: %1 is odd"_s.arg(poles[axis]));
    }
    for (std::size_t axis = 0; axis < poles.size(); ++axis) {
        if (const auto done = m_device.writeWord(m_channel, kPoleWords[axis], poles[axis]); !done)
            return tl::unexpected(done.error());
    }
    return ActionReply{};
}

Result<ActionReply> Procedures::beginYaw()
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

Result<ActionReply> Procedures::moveYaw(double degrees)
{
    if (!m_device.m_yawBefore)
        return failure(ErrorCode::InvalidArgument, u"begin to align yaw first"_s);
    const int steps = int(std::lround(degrees * 10.0));
    const auto done = m_device.writeWord(m_channel, kYawWords[2], steps);
    if (!done)
        return tl::unexpected(done.error());
    return ActionReply{{u"angle"_s, steps / 10.0}};
}

Result<ActionReply> Procedures::endYaw(bool take)
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

}  // namespace storm32
