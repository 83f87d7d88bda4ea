// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QString>

#include <functional>

/// Something to decide before it goes on.
struct Question
{
    struct Answer
    {
        QString text;  ///< what the button does, in its words
        std::function<void()> chosen;
        bool loses = false;  ///< something that cannot be had back
    };
    QString title;
    QString text;
    QList<Answer> answers;
    QString stay;  ///< the way out, which is what Return and Esc do
    QString whole{};  ///< what the text cuts short, as a tooltip
};
