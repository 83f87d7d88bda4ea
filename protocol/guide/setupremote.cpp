// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The step that finds which input each stick of a remote control moves. The motors are off: whatever a stick
// steers by the old map, nothing turns. What was found is kept only where the board's own signal of the
// function follows the stick.
#include "protocol/device/device.h"
#include "protocol/guide/setupguide.h"
#include "protocol/procedure/trialnote.h"
#include "protocol/session/channel.h"
#include "protocol/session/stopplan.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr double kStickPatience = 60;  // seconds for each
constexpr double kRestSeconds = 1;
constexpr double kReleaseSeconds = 10;  // a stick that has not come back by then stays where it is left
constexpr double kStickHeld = 0.6;
constexpr double kFollowSeconds = 3;
constexpr auto kHeard = 3s;  // of silence, and the signal is lost
// Shares of the way from the middle to an end.
constexpr double kClear = 0.45;
constexpr double kStray = 0.25;  // of a stick that a hand only touches
constexpr double kStill = 0.08;
constexpr double kWholeWay = 1.2;  // of a stick that rests at its end
constexpr double kOffMiddle = 0.05;
constexpr double kAtAnEnd = 0.5;
constexpr double kShortWay = 1.6;  // from end to end
// What the board makes of it.
constexpr double kFollows = 0.15;  // of its channel's range
constexpr double kOthers = 4;  // times what the others do

/// Where a signal was in a while.
struct SignalSpan
{
    double low = 2, high = -2, sum = 0;
    int count = 0;
    void add(double value)
    {
        low = std::min(low, value);
        high = std::max(high, value);
        sum += value;
        ++count;
    }
};

/// Inputs that are away from where they rest, the farthest first.
QStringList movedInputs(const QMap<QString, double> &now, const QMap<QString, double> &rest)
{
    QStringList moved;
    const auto way = [&](const QString &name) { return std::abs(now.value(name) - rest.value(name)); };
    for (auto it = now.begin(); it != now.end(); ++it) {
        if (rest.contains(it.key()) && way(it.key()) > kStray)
            moved.append(it.key());
    }
    std::sort(moved.begin(), moved.end(),
              [&way](const QString &a, const QString &b) { return way(a) > way(b); });
    return moved;
}

}  // namespace

Result<SetupGuide::Inputs> SetupGuide::readInputs(bool initializes)
{
    const auto told = m_device.perform(m_channel, m_keys.readInputs, {{u"initialize"_s, initializes}});
    if (!told)
        return tl::unexpected(told.error());
    Inputs inputs;
    for (auto it = told->begin(); it != told->end(); ++it) {
        if (it.key().startsWith(u"input."_s))
            inputs.insert(it.key().section(u'.', 1), it.value().toDouble() / 100);
    }
    return inputs;
}

Result<SetupGuide::Inputs> SetupGuide::watchInputs(const QString &step, const QString &subject, double share)
{
    if (const auto passed = letPass(); !passed)
        return tl::unexpected(passed.error());
    auto inputs = readInputs(false);
    if (!inputs)
        return inputs;
    if (!inputs->isEmpty())
        m_heardAt = m_channel.now();
    else if (m_channel.now() - m_heardAt > kHeard)
        return failure(ErrorCode::ConditionUnmet,
                       u"no input has a signal: switch the transmitter on, and see that its receiver is "
                       "connected and of the kind that is set"_s);
    if (m_roles.outputs >= 0 && latest(m_roles.outputs) > 0) {
        m_channel.stopMotors(m_device.stopPlan());
        return failure(ErrorCode::ConditionUnmet,
                       u"the motors were switched on meanwhile, as a stick or a switch can command: they "
                       "are stopped"_s);
    }
    Progress progress;
    progress.step = step;
    progress.subject = subject;
    progress.done = std::clamp(int(100 * share), 0, 100);
    progress.total = 100;
    for (auto it = inputs->begin(); it != inputs->end(); ++it)
        progress.values.insert(it.key(), 100 * it.value());
    m_channel.progress(progress);
    return inputs;
}

Result<SetupGuide::Inputs> SetupGuide::awaitRest(const QString &step, const Inputs &before)
{
    const TimePoint began = m_channel.now();
    TimePoint since = began;
    QMap<QString, SignalSpan> seen;
    for (;;) {
        const double gone = ::seconds(m_channel.now() - began);
        const auto inputs = watchInputs(step, {}, gone / kReleaseSeconds);
        if (!inputs)
            return inputs;
        if (!movedInputs(*inputs, before).isEmpty() && gone < kReleaseSeconds) {
            since = m_channel.now();
            seen.clear();
            continue;
        }
        for (auto it = inputs->begin(); it != inputs->end(); ++it)
            seen[it.key()].add(it.value());
        if (::seconds(m_channel.now() - since) < kRestSeconds || seen.isEmpty())
            continue;
        Inputs rest;
        for (auto it = seen.begin(); it != seen.end(); ++it) {
            if (inputs->contains(it.key()) && it->high - it->low < kStill)
                rest.insert(it.key(), it->sum / it->count);
        }
        // What never comes to rest is no stick.
        if (rest.size() == seen.size() || gone > kReleaseSeconds)
            return rest;
        since = m_channel.now();
        seen.clear();
    }
}

Result<std::pair<QString, double>> SetupGuide::awaitStick(const StickWish &wish, const Inputs &rest)
{
    const TimePoint began = m_channel.now();
    TimePoint since = began;
    std::pair<QString, double> held;
    const auto askAgain = [&](const QString &step) -> Result<void> {
        const auto released = awaitRest(step, rest);
        if (!released)
            return tl::unexpected(released.error());
        since = m_channel.now();
        held = {};
        return {};
    };
    for (;;) {
        const double gone = ::seconds(m_channel.now() - began);
        if (gone > kStickPatience)
            return failure(ErrorCode::ConditionUnmet,
                           u"no input alone moved clearly for a minute: the transmitter is off, its receiver "
                           "is not connected, or the board does not look at that input"_s);
        const auto inputs = watchInputs(wish.step, wish.subject, gone / kStickPatience);
        if (!inputs)
            return tl::unexpected(inputs.error());
        const QStringList moved = movedInputs(*inputs, rest);
        const bool isTaken = !moved.isEmpty() && wish.taken.contains(moved.first());
        if (moved.size() > 1 || isTaken) {
            if (const auto again = askAgain(isTaken ? u"setup-stick-taken"_s : u"setup-stick-again"_s);
                !again)
                return tl::unexpected(again.error());
            continue;
        }
        const QString name = moved.isEmpty() ? wish.input : moved.first();
        const double value = inputs->value(name, std::nan(""));
        const bool isHeld = name == held.first && std::abs(value - held.second) < kStill
            && wish.isThere(name, value - rest.value(name));
        if (!isHeld) {
            held = {name, value};
            since = m_channel.now();
        } else if (::seconds(m_channel.now() - since) >= kStickHeld) {
            return held;
        }
    }
}

Result<SetupGuide::Stick> SetupGuide::findStick(const QString &function, const Inputs &rest,
                                                const QStringList &taken)
{
    const bool isCommand = function == m_keys.commandInput;
    const auto isClear = [](const QString &, double way) { return std::abs(way) > kClear; };
    const auto first = awaitStick(
        {isCommand ? u"setup-stick-command"_s : u"setup-stick-"_s + function, {}, {}, taken, isClear}, rest);
    if (!first)
        return tl::unexpected(first.error());
    Stick stick{function, first->first, rest.value(first->first), first->second, first->second};
    if (isCommand)
        return stick;
    const double way = stick.wanted - stick.rest;
    const auto isOpposite = [&](const QString &name, double other) {
        const bool isBack = std::abs(way) > kWholeWay && std::abs(other) < kStill;
        return name == stick.input && (isBack || (std::abs(other) > kClear && way * other < 0));
    };
    const auto second = awaitStick({u"setup-stick-back"_s, stick.input, stick.input, {}, isOpposite}, rest);
    if (!second)
        return tl::unexpected(second.error());
    stick.other = second->second;
    return stick;
}

// The board's own signal of the function follows, and no other function's does.
Result<void> SetupGuide::checkStick(const Stick &stick, const std::vector<Stick> &all, const Inputs &before)
{
    const auto rest = awaitRest(u"setup-stick-rest"_s, before);
    if (!rest)
        return tl::unexpected(rest.error());
    const auto channels = m_device.channels();
    const auto channelOf = [&](const Stick &each) {
        const QString key = m_keys.inputChannel.arg(each.function);
        const auto it = std::find_if(channels.begin(), channels.end(), [&key](const ChannelSpec &channel) {
            return key == QLatin1String(channel.key);
        });
        return it == channels.end() ? -1 : int(it - channels.begin());
    };
    const int own = channelOf(stick);
    if (own < 0)
        return failure(ErrorCode::Unsupported, m_keys.inputChannel.arg(stick.function));
    if (const auto news = awaitNews({own}); !news)
        return news;
    std::map<int, double> start;
    for (const Stick &each : all)
        start[channelOf(each)] = latest(channelOf(each));
    const auto isThere
        = [&stick](const QString &name, double way) { return name == stick.input && std::abs(way) > kClear; };
    const auto held = awaitStick({u"setup-stick-check"_s, stick.function, {}, {}, isThere}, *rest);
    if (!held)
        return tl::unexpected(held.error());
    const ChannelSpec &spec = channels[std::size_t(own)];
    const TimePoint began = m_channel.now();
    while (::seconds(m_channel.now() - began) < kFollowSeconds) {
        double follows = 0, others = 0;
        for (const auto &[channel, from] : start) {
            double &most = channel == own ? follows : others;
            most = std::max(most, std::abs(latest(channel) - from));
        }
        if (follows > kFollows * (spec.max - spec.min) && follows > kOthers * others)
            return {};
        const auto inputs = watchInputs(u"setup-stick-check"_s, stick.function, 1);
        if (!inputs)
            return tl::unexpected(inputs.error());
    }
    return failure(ErrorCode::NotSeen,
                   u"the board's own signal of %1 does not follow the stick"_s.arg(stick.function));
}

Result<void> SetupGuide::mapSticks(const std::vector<Stick> &sticks, Configuration &edited) const
{
    const int profile = edited.activeProfile();
    for (const Stick &stick : sticks) {
        const ParameterSpec *map = m_device.parameters()->find(m_keys.inputMap.arg(stick.function));
        const auto source = map ? map->parse(stick.input) : std::nullopt;
        if (!source)
            return failure(ErrorCode::Unsupported, stick.input);
        if (const auto set = edited.setRaw(*map, profile, *source); !set)
            return set;
        const ParameterSpec *inverted = m_device.parameters()->find(m_keys.inputInverted.arg(stick.function));
        if (const auto set = inverted ? edited.setRaw(*inverted, profile, stick.wanted < stick.other ? 1 : 0)
                                      : Result<void>();
            !set)
            return set;
    }
    return {};
}

// What was right already is named as well: it was found, not assumed.
void SetupGuide::describeSticks(const std::vector<Stick> &sticks, const Configuration &board,
                                SetupResult &result) const
{
    const int profile = board.activeProfile();
    const auto name = [&](const QString &key) {
        const ParameterSpec *spec = m_device.parameters()->find(key);
        const auto raw = spec ? board.raw(*spec, profile) : std::nullopt;
        const bool isNamed = std::any_of(result.changes.begin(), result.changes.end(),
                                         [&key](const SetupChange &change) { return change.key == key; });
        if (raw && !isNamed)
            result.changes.append({key, profile, spec->format(*raw), spec->format(*raw)});
        return raw;
    };
    QStringList remarks;
    QSet<double> sources;
    QStringList functions;
    for (const Stick &stick : sticks) {
        if (const auto source = name(m_keys.inputMap.arg(stick.function)))
            sources.insert(*source);
        functions.append(stick.function);
        if (stick.function == m_keys.commandInput)
            continue;
        std::ignore = name(m_keys.inputInverted.arg(stick.function));
        for (const auto &[figure, value] : {std::pair("stick.low", std::min(stick.wanted, stick.other)),
                                            {"stick.rest", stick.rest},
                                            {"stick.high", std::max(stick.wanted, stick.other)}})
            result.figures.append(
                {QLatin1String(figure) + QLatin1Char('.') + stick.function, 100 * value, std::nullopt});
        if (std::abs(stick.wanted - stick.other) < kShortWay)
            remarks.append(u"remote.short"_s);
        if (std::abs(stick.rest) > kOffMiddle && std::abs(stick.rest) < kAtAnEnd)
            remarks.append(u"remote.offset"_s);
    }
    for (const QString &function : stickFunctions()) {
        const ParameterSpec *map = m_device.parameters()->find(m_keys.inputMap.arg(function));
        const auto source = map ? board.raw(*map, profile) : std::nullopt;
        if (source && *source != 0 && !functions.contains(function) && sources.contains(*source)) {
            remarks.append(u"remote.shared"_s);
            result.state = SetupResult::State::Poor;
        }
    }
    remarks.removeDuplicates();
    result.remarks += remarks;
}

QStringList SetupGuide::stickFunctions() const
{
    QStringList all;
    for (const Axis axis : kAxes)
        all.append(QLatin1String(axisKey(axis)));
    return all << m_keys.commandInput;
}

Result<SetupResult> SetupGuide::remote(const QVariantMap &answers)
{
    QStringList wanted = stickFunctions();
    wanted.removeIf([&](const QString &function) {
        return !answers.value(function == m_keys.commandInput ? u"command"_s : function).toBool();
    });
    if (wanted.isEmpty())
        return failure(ErrorCode::InvalidArgument, u"every stick is left out: choose one at least"_s);
    if (const auto off = switchOff(); !off)
        return tl::unexpected(off.error());
    if (const auto news = awaitNews({m_roles.outputs}); !news)
        return tl::unexpected(news.error());
    if (const auto opened = readInputs(true); !opened)
        return tl::unexpected(opened.error());
    m_heardAt = m_channel.now();
    std::vector<Stick> sticks;
    QStringList taken;
    Inputs rest;
    for (const QString &function : std::as_const(wanted)) {
        const auto released = awaitRest(u"setup-stick-rest"_s, rest);
        if (!released)
            return tl::unexpected(released.error());
        rest = *released;
        const auto stick = findStick(function, rest, taken);
        if (!stick)
            return tl::unexpected(stick.error());
        sticks.push_back(*stick);
        taken.append(stick->input);
    }
    const auto base = m_device.readConfiguration(m_channel);
    if (!base)
        return tl::unexpected(base.error());
    Configuration edited = *base;
    if (const auto mapped = mapSticks(sticks, edited); !mapped)
        return tl::unexpected(mapped.error());
    SetupResult result;
    const bool isOther = !base->changesTo(edited).empty();
    auto done = isOther ? writeOnTrial(*base, edited, result) : Result<void>();
    for (auto stick = sticks.begin(); done && stick != sticks.end(); ++stick)
        done = checkStick(*stick, sticks, rest);
    if (!done)
        return tl::unexpected(isOther ? takenBack(done.error()) : done.error());
    if (isOther)
        dropTrial(m_history, m_device.identity());
    result.remarks = QStringList{isOther ? u"remote.set"_s : u"remote.fits"_s};
    describeSticks(sticks, edited, result);
    result.remarks.append(u"remote.off"_s);
    return result;
}
