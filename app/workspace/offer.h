// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>

#include <functional>

/// What a question is about: a newer one of the same topic takes its place.
enum class Topic { None, Write, Leftover, Naming, WayOut, Board, Steering, Text };

/// A question to the operator with answers to choose from; it blocks nothing.
struct Offer
{
    struct Choice
    {
        QString text;
        std::function<void()> chosen;
        bool loses = false;  ///< something that cannot be had back
    };
    QString text;
    QList<Choice> choices;  ///< the first one is what is usually wanted
    Topic topic = Topic::None;
    bool isUrgent = false;  ///< comes before those that wait already: something moves, or is written
};
