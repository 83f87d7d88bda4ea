// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The step that finds how far the camera may move.
#include "protocol/device/device.h"
#include "protocol/guide/setupguide.h"
#include "protocol/session/channel.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr double kLeastRange = 10;  // degrees, or the axis was not meant

bool isMoved(const std::pair<double, double> &reached, double margin)
{
    return reached.second - reached.first - 2 * margin >= kLeastRange;
}

}  // namespace

Result<SetupGuide::Motion> SetupGuide::watchHand(double seconds)
{
    if (const auto news = awaitNews(ChannelRoles::present({m_roles.angle})); !news)
        return tl::unexpected(news.error());
    Motion motion;
    bool isFirst = true;
    const auto look = [&]() -> Result<void> {
        for (const auto &[channels, reached] :
             {std::pair(&m_roles.angle, &motion.angle), std::pair(&m_roles.joint, &motion.joint)}) {
            for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
                const int channel = (*channels)[axis];
                const double now = channel < 0 ? 0.0 : latest(channel);
                auto &[low, high] = (*reached)[axis];
                low = isFirst ? now : std::min(low, now);
                high = isFirst ? now : std::max(high, now);
            }
        }
        isFirst = false;
        return {};
    };
    if (const auto moved = watch(seconds, look, u"setup-move"_s); !moved)
        return tl::unexpected(moved.error());
    return motion;
}

// Where no encoder tells the angle of a motor, it is that of the camera, as the frame stands level.
Result<void> SetupGuide::setRanges(Axis axis, const Motion &motion, double margin, Configuration &edited,
                                   SetupResult &result) const
{
    using enum SetupRange::Of;
    const auto at = std::size_t(axis);
    const int profile = edited.activeProfile();
    const bool hasJoint = isMoved(motion.joint[at], margin);
    for (const SetupRange &range : m_keys.ranges) {
        if (range.of == Encoder && !hasJoint)
            continue;
        const bool isSteering = range.of == Steering;
        const auto [low, high] = isSteering || !hasJoint ? motion.angle[at] : motion.joint[at];
        const double off = isSteering ? margin : margin / 2;
        for (const auto &[pattern, value, figure] :
             {std::tuple(range.lowest, std::ceil(low + off), isSteering ? "lowest" : "stopslow"),
              std::tuple(range.highest, std::floor(high - off), isSteering ? "highest" : "stopshigh")}) {
            const ParameterSpec *spec = find(pattern, axis);
            const auto before = spec ? edited.raw(*spec, profile) : std::nullopt;
            if (!before)
                continue;
            const double raw = spec->clamped(spec->toRaw(value));
            if (const auto set = edited.setRaw(*spec, profile, raw); !set)
                return set;
            result.figures.append(
                {setupFigureKey(figure, axis), spec->toDisplay(raw), spec->toDisplay(*before)});
            if (!isSteering && !result.remarks.contains(u"limits.joint"_s))
                result.remarks.append(u"limits.joint"_s);
        }
    }
    return {};
}

Result<SetupResult> SetupGuide::limits(const QVariantMap &answers)
{
    if (const auto off = switchOff(); !off)
        return tl::unexpected(off.error());
    const auto motion = watchHand(answers.value(u"seconds"_s).toDouble());
    if (!motion)
        return tl::unexpected(motion.error());
    const auto base = m_device.readConfiguration(m_channel);
    if (!base)
        return tl::unexpected(base.error());
    SetupResult result;
    Configuration edited = *base;
    const double margin = answers.value(u"margin"_s).toDouble();
    int moved = 0;
    for (const Axis axis : kAxes) {
        if (!isMoved(motion->angle[std::size_t(axis)], margin))
            continue;
        ++moved;
        if (const auto set = setRanges(axis, *motion, margin, edited, result); !set)
            return tl::unexpected(set.error());
    }
    if (moved == 0)
        return failure(
            ErrorCode::ConditionUnmet,
            u"the camera was not moved by more than some degrees: move it by hand as far as it may "
            "go"_s);
    if (!base->changesTo(edited).empty()) {
        if (const auto written = write(*base, edited, result); !written)
            return tl::unexpected(written.error());
    }
    result.remarks.prepend(u"limits.set"_s);
    if (moved < int(kAxisCount))
        result.remarks.append(u"limits.kept"_s);
    return result;
}
