// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/gamepad/gamepadmapping.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

// Names in the settings.
constexpr std::array<const char *, kGamepadSticks> kStickKeys{"throttle", "roll", "pitch", "yaw", "speed"};
constexpr std::array<const char *, kGamepadButtons> kButtonKeys{"armHold", "disarm", "centre"};

double bent(double way, double expo)
{
    return (1.0 - expo) * way + expo * way * way * way;
}

/// An axis or a button of an ordinary pad: "a1~" is the second axis, upside down. Halves of axes are left
/// out.
struct Part
{
    int axis = -1;
    int button = -1;
    bool isInverted = false;
};

Part partOf(const QByteArray &layout, QByteArrayView name)
{
    for (const QByteArray &entry : layout.split(',')) {
        const qsizetype colon = entry.indexOf(':');
        if (colon < 0 || entry.left(colon) != name)
            continue;
        QByteArray place = entry.mid(colon + 1);
        const bool isInverted = place.endsWith('~');
        if (isInverted)
            place.chop(1);
        bool isNumber = false;
        const int number = place.mid(1).toInt(&isNumber);
        if (isNumber && number >= 0 && place.startsWith('a'))
            return {number, -1, isInverted};
        if (isNumber && number >= 0 && place.startsWith('b'))
            return {-1, number, false};
    }
    return {};
}

double share(const QJsonValue &value, double fallback, double max)
{
    const double number = value.toDouble(fallback);
    return std::isfinite(number) ? std::clamp(number, 0.0, max) : fallback;
}

}  // namespace

double GamepadAxisUse::shaped(double position, bool atStop) const
{
    if (!std::isfinite(position))
        return atStop ? -1.0 : 0.0;
    const double place = std::clamp(inverted ? -position : position, -1.0, 1.0);
    if (atStop) {
        const double from = fromMiddle ? std::max(0.0, place) : (place + 1.0) / 2.0;
        const double way = std::max(0.0, (from - deadBand) / (1.0 - deadBand));
        return 2.0 * bent(way, expo) - 1.0;
    }
    const double way = std::max(0.0, (std::abs(place) - deadBand) / (1.0 - deadBand));
    return std::copysign(bent(way, expo), place) + 0.0;  // never -0
}

bool GamepadMapping::isSetUp() const
{
    return std::any_of(sticks.begin(), sticks.end(), [](const GamepadAxisUse &use) { return use.axis >= 0; });
}

void GamepadMapping::assign(GamepadStick stick, int axis, bool inverted)
{
    for (GamepadAxisUse &use : sticks) {
        if (use.axis == axis)
            use.axis = -1;
    }
    (*this)[stick].axis = axis;
    (*this)[stick].inverted = inverted;
    (*this)[stick].fromMiddle = false;
}

void GamepadMapping::assign(GamepadButton button, int index)
{
    std::replace(buttons.begin(), buttons.end(), index, -1);
    (*this)[button] = index;
}

GamepadMapping GamepadMapping::standard(const QByteArray &layout, GamepadUse use)
{
    const Part leftX = partOf(layout, "leftx");
    const Part leftY = partOf(layout, "lefty");
    const Part rightX = partOf(layout, "rightx");
    const Part rightY = partOf(layout, "righty");
    GamepadMapping mapping;
    const bool flies = use == GamepadUse::Flight;
    if (rightX.axis < 0 || rightY.axis < 0 || (flies && (leftX.axis < 0 || leftY.axis < 0)))
        return mapping;
    mapping.assign(flies ? GamepadStick::Roll : GamepadStick::Yaw, rightX.axis, rightX.isInverted);
    mapping.assign(GamepadStick::Pitch, rightY.axis, !rightY.isInverted);  // up is negative there
    if (flies) {
        mapping.assign(GamepadStick::Yaw, leftX.axis, leftX.isInverted);
        mapping.assign(GamepadStick::Throttle, leftY.axis, !leftY.isInverted);
        mapping[GamepadStick::Throttle].fromMiddle = true;
    }
    const auto assign = [&](GamepadButton button, QByteArrayView name) {
        if (const Part part = partOf(layout, name); part.button >= 0)
            mapping.assign(button, part.button);
    };
    assign(GamepadButton::ArmHold, "start");
    assign(GamepadButton::Disarm, "b");
    if (!flies)
        assign(GamepadButton::Centre, "rightstick");
    return mapping;
}

QByteArray GamepadMapping::toJson() const
{
    QJsonObject all;
    for (std::size_t i = 0; i < kGamepadSticks; ++i)
        all[QLatin1String(kStickKeys[i])] = QJsonObject{{u"axis"_s, sticks[i].axis},
                                                        {u"inverted"_s, sticks[i].inverted},
                                                        {u"deadBand"_s, sticks[i].deadBand},
                                                        {u"expo"_s, sticks[i].expo},
                                                        {u"fromMiddle"_s, sticks[i].fromMiddle}};
    for (std::size_t i = 0; i < kGamepadButtons; ++i)
        all[QLatin1String(kButtonKeys[i])] = buttons[i];
    return QJsonDocument(all).toJson(QJsonDocument::Compact);
}

GamepadMapping GamepadMapping::fromJson(const QByteArray &json)
{
    GamepadMapping mapping;
    const QJsonObject all = QJsonDocument::fromJson(json).object();
    for (std::size_t i = 0; i < kGamepadSticks; ++i) {
        const QJsonObject use = all[QLatin1String(kStickKeys[i])].toObject();
        const GamepadAxisUse standard;
        if (const int axis = use[u"axis"_s].toInt(-1); axis >= 0)
            mapping.assign(GamepadStick(i), axis, use[u"inverted"_s].toBool());
        mapping.sticks[i].deadBand = share(use[u"deadBand"_s], standard.deadBand, kMaxDeadBand);
        mapping.sticks[i].expo = share(use[u"expo"_s], standard.expo, 1.0);
        mapping.sticks[i].fromMiddle = startsAtStop(GamepadStick(i)) && use[u"fromMiddle"_s].toBool();
    }
    for (std::size_t i = 0; i < kGamepadButtons; ++i) {
        if (const int button = all[QLatin1String(kButtonKeys[i])].toInt(-1); button >= 0)
            mapping.assign(GamepadButton(i), button);
    }
    return mapping;
}

void applyMapping(const GamepadMapping &mapping, const GamepadReading &reading, GamepadSnapshot &snapshot)
{
    snapshot.name = reading.name;
    snapshot.isSetUp = mapping.isSetUp();
    for (std::size_t i = 0; i < kGamepadSticks; ++i) {
        const int axis = mapping.sticks[i].axis;
        const bool atStop = startsAtStop(GamepadStick(i));
        snapshot.assigned[i] = axis >= 0 && axis < int(reading.axes.size());
        snapshot.sticks[i] = snapshot.assigned[i]
            ? mapping.sticks[i].shaped(reading.axes[std::size_t(axis)], atStop)
            : (atStop ? -1.0 : 0.0);
    }
    for (std::size_t i = 0; i < kGamepadButtons; ++i) {
        const int button = mapping.buttons[i];
        snapshot.held[i]
            = button >= 0 && button < int(reading.buttons.size()) && reading.buttons[std::size_t(button)];
    }
}
