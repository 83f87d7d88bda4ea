// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

#include <vector>

/// What this program gains, and loses, from one firmware on.
struct FirmwareStep
{
    QString firmware;  ///< "2.68b0"
    bool isAbout = false;  ///< some firmware at about that one: no document names it
    QStringList actions;  ///< keys, as all of these
    QStringList parameters;
    QStringList variables;  ///< that can be changed live
    QStringList modes;  ///< of steering
    QStringList streams;
    QStringList channels;  ///< of live data
    QStringList commands;  ///< by name, in the console
    QStringList gone;  ///< parameters that it no longer has

    [[nodiscard]] bool isEmpty() const
    {
        return actions.isEmpty() && parameters.isEmpty() && variables.isEmpty() && modes.isEmpty()
            && streams.isEmpty() && channels.isEmpty() && commands.isEmpty() && gone.isEmpty();
    }
};

/// A sentence about a firmware, in the tables' catalogue.
struct FirmwareRemark
{
    const char *text = "";
    bool isCaution = false;
};

/// Boards whose firmware can be judged by its number. Nothing here changes it.
class FirmwareAdvice
{
public:
    virtual ~FirmwareAdvice() = default;
    /// The first one says whether this program knows it; others, what is wrong or missing with it.
    [[nodiscard]] virtual std::vector<FirmwareRemark> firmwareRemarks() const = 0;
    /// What newer ones bring, up to the newest that this program knows, the oldest first.
    [[nodiscard]] virtual std::vector<FirmwareStep> firmwareSteps() const = 0;
};
