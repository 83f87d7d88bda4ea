// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The step that finds which way the sensor sits on the camera. Acceleration is sent as the sensor measures it
// (document, CMD_REALTIME_DATA_3: "raw data from sensors"), angles as those of the camera: the first tells
// how the sensor sits, the second whether the board now takes it so.
#include "protocol/base/angles.h"
#include "protocol/device/device.h"
#include "protocol/guide/setupguide.h"
#include "protocol/procedure/trialnote.h"
#include "protocol/session/channel.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr double kPosePatience = 60;  // seconds for each
constexpr double kPoseSeconds = 1;
constexpr double kFirstSeconds = 3;  // a camera that hangs still is not held level
constexpr double kSteady = 4;  // degrees
constexpr double kLeastTilt = 25;
constexpr double kMostTilt = 65;
constexpr double kAskew = 20;  // degrees off an axis of the sensor
constexpr double kAgrees = 15;  // degrees: the accelerometer is not calibrated yet
constexpr double kSettles = 10;  // seconds in which the board's angles have to follow

double dot(const Vector3 &a, const Vector3 &b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

Vector3 cross(const Vector3 &a, const Vector3 &b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double degreesBetween(const Vector3 &a, const Vector3 &b)
{
    return degrees(std::acos(std::clamp(dot(a, b) / (a.norm() * b.norm()), -1.0, 1.0)));
}

/// The sensor's axis that points most nearly that way.
Vector3 nearestAxis(const Vector3 &direction)
{
    std::size_t most = 0;
    for (std::size_t i = 1; i < 3; ++i) {
        if (std::abs(direction[i]) > std::abs(direction[most]))
            most = i;
    }
    Vector3 axis;
    axis[most] = direction[most] < 0 ? -1 : 1;
    return axis;
}

bool isAlongAxis(const Vector3 &direction)
{
    return degreesBetween(direction, nearestAxis(direction)) < kAskew;
}

/// Where "up" has gone, level, by tilting.
Vector3 tiltOf(const Vector3 &up, const Vector3 &level)
{
    return up - level * (dot(up, level) / dot(level, level));
}

bool isTilted(const Vector3 &up, const Vector3 &level)
{
    const double angle = degreesBetween(up, level);
    return angle > kLeastTilt && angle < kMostTilt && isAlongAxis(tiltOf(up, level));
}

/// 1 to 3, negative for the opposite.
int numberOf(const Vector3 &axis)
{
    return int(axis.x + 2 * axis.y + 3 * axis.z);
}

/// "x", "-x"
QString nameOf(const Vector3 &axis)
{
    const int number = numberOf(axis);
    return (number < 0 ? u"-"_s : QString()) + QChar(u'w' + std::abs(number));
}

}  // namespace

Vector3 SetupGuide::upward() const
{
    return {latest(m_roles.acc[0]), latest(m_roles.acc[1]), latest(m_roles.acc[2])};
}

Result<Vector3> SetupGuide::awaitPose(const QString &step,
                                      const std::function<bool(const Vector3 &)> &isThere, double seconds)
{
    const TimePoint began = m_channel.now();
    TimePoint since = began;
    Vector3 first, sum;
    for (;;) {
        const double gone = ::seconds(m_channel.now() - began);
        if (gone > kPosePatience)
            return failure(
                ErrorCode::ConditionUnmet,
                u"the camera was not held as asked for a minute, or its sensor sits at no right angle to "
                "it"_s);
        const Vector3 up = upward();
        const bool isHeld = up.norm() > 0 && isThere(up) && degreesBetween(up, first) < kSteady;
        sum += up;
        if (!isHeld) {
            since = m_channel.now();
            first = sum = up;
        } else if (::seconds(m_channel.now() - since) >= seconds) {
            return sum / sum.norm();
        }
        tell(step, gone / kPosePatience);
        if (const auto passed = letPass(); !passed)
            return tl::unexpected(passed.error());
    }
}

Result<void> SetupGuide::awaitAngles(const QString &step, const Vector3 &level, bool isDown)
{
    const auto isThere = [&](const Vector3 &up) {
        return isDown ? isTilted(up, level) : degreesBetween(up, level) < kAskew / 2;
    };
    const auto pose = awaitPose(step, isThere, kPoseSeconds);
    if (!pose)
        return tl::unexpected(pose.error());
    const TimePoint began = m_channel.now();
    TimePoint since = began;
    while (::seconds(m_channel.now() - began) < kSettles) {
        const Vector3 up = upward();
        const double wanted = isDown ? degreesBetween(up, level) : 0.0;
        const bool isSo = isThere(up) && turnBetween(latest(m_roles.angle[1]), wanted) < kAgrees
            && turnBetween(latest(m_roles.angle[0]), 0) < kAgrees;
        if (!isSo)
            since = m_channel.now();
        else if (::seconds(m_channel.now() - since) >= kPoseSeconds)
            return {};
        tell(step, ::seconds(m_channel.now() - began) / kSettles);
        if (const auto passed = letPass(); !passed)
            return tl::unexpected(passed.error());
    }
    return failure(ErrorCode::NotSeen, u"the board's angles do not follow the camera"_s);
}

Result<void> SetupGuide::awaitFollowing(const Vector3 &level)
{
    const auto down = awaitAngles(u"setup-tilt-down"_s, level, true);
    return down ? awaitAngles(u"setup-tilt-level"_s, level, false) : down;
}

Result<SetupResult> SetupGuide::orientation()
{
    if (const auto off = switchOff(); !off)
        return tl::unexpected(off.error());
    if (const auto news = awaitNews(ChannelRoles::present({m_roles.acc, m_roles.angle})); !news)
        return tl::unexpected(news.error());
    const auto level = awaitPose(u"setup-tilt-level"_s, isAlongAxis, kFirstSeconds);
    if (!level)
        return tl::unexpected(level.error());
    const auto isSide = [&level](const Vector3 &up) { return isTilted(up, *level); };
    const auto rightDown = awaitPose(u"setup-tilt-right"_s, isSide, kPoseSeconds);
    if (!rightDown)
        return tl::unexpected(rightDown.error());
    const Vector3 up = nearestAxis(*level);
    const Vector3 right = nearestAxis(tiltOf(*rightDown, *level)) * -1;
    const auto isNose = [&](const Vector3 &now) {
        return isTilted(now, *level) && dot(nearestAxis(tiltOf(now, *level)), right) == 0;
    };
    const auto noseDown = awaitPose(u"setup-tilt-down"_s, isNose, kPoseSeconds);
    if (!noseDown)
        return tl::unexpected(noseDown.error());
    if (nearestAxis(tiltOf(*noseDown, *level)) * -1 != cross(up, right))
        return failure(ErrorCode::ConditionUnmet,
                       u"one of the two tilts went the other way: the right side down, seen from behind the "
                       "camera, then its nose"_s);
    const auto base = m_device.readConfiguration(m_channel);
    if (!base)
        return tl::unexpected(base.error());
    SetupResult result;
    result.figures = {SetupFigure{u"askew"_s, degreesBetween(*level, up)}};
    result.remarks = QStringList{u"up."_s + nameOf(up), u"right."_s + nameOf(right)};
    Configuration edited = *base;
    for (const auto &[key, axis] : {std::pair(m_keys.axisUp, up), {m_keys.axisRight, right}}) {
        const ParameterSpec *spec = find(key);
        if (!spec)
            return failure(ErrorCode::Unsupported, key);
        if (const auto set = edited.setRaw(*spec, base->activeProfile(), numberOf(axis)); !set)
            return tl::unexpected(set.error());
    }
    const bool isOther = !base->changesTo(edited).empty();
    if (!isOther) {
        if (const auto follow = awaitFollowing(*level); !follow)
            return tl::unexpected(follow.error());
        result.remarks.append(u"orientation.fits"_s);
        return result;
    }
    auto done = writeOnTrial(*base, edited, result);
    if (done)
        done = awaitFollowing(*level);
    if (!done)
        return tl::unexpected(takenBack(done.error()));
    dropTrial(m_history, m_device.identity());
    result.remarks.append(u"orientation.set"_s);
    return result;
}
