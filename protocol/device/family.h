// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/foreignfile.h"
#include "protocol/configuration/scriptlanguage.h"
#include "protocol/device/device.h"
#include "protocol/session/framer.h"
#include "protocol/session/linktiming.h"
#include "protocol/transport/linkaddress.h"

/// A kind of link over which a family is reached.
struct FamilyLink
{
    LinkAddress::Kind kind = LinkAddress::Kind::Serial;
    /// Probing for this family cannot harm a board of another family there. Where it might, the address has
    /// to name the family.
    bool mayAskAnybody = true;
};

/// What the boards move, in words of the tables' catalogue.
struct Nouns
{
    const char *load = "camera";  ///< "the camera stands still"
    bool flies = false;  ///< switching its motors off makes it fall: the program itself never does that
};

/// A family of controllers as the program's table of families lists it.
struct Family
{
    QString key;  ///< "simplebgc"
    QString name;  ///< "SimpleBGC 32-bit"
    QList<FamilyLink> links;
    /// Where its boards usually are, for links that cannot be searched; empty: nowhere in particular.
    QString usualAddress = {};
    LinkTiming timing;
    /// Rate and parity pairs worth trying on a serial line, most likely first.
    QList<LineSettings> lines = {};
    Nouns nouns = {};
    /// Samples per second of the control loop, if boards stream or programs export at that rate; 0: neither.
    double fullRate = 0;
    std::function<std::unique_ptr<Framer>()> makeFramer;
    std::function<std::unique_ptr<Device>()> makeDevice;
    /// The parameters of a board with this identity, to read a file without the board.
    std::function<std::shared_ptr<const ParameterSet>(const BoardIdentity &)> makeParameters;
    /// Name of the protocol if these bytes look like it; empty if they do not, or not yet.
    std::function<QString(const QByteArray &heard)> recognise = {};
    /// Language of the scripts that its boards store; null if there are none.
    std::shared_ptr<const ScriptLanguage> scripts = nullptr;
    /// Settings files of the manufacturer's own program.
    std::optional<ForeignFile> settingsFile = {};
    /// Files with a sensor calibration.
    std::optional<CalibrationFile> calibrationFile = {};

    /// Whether its boards are reached over this kind of link. Simulated boards and recordings always are.
    [[nodiscard]] bool livesOn(LinkAddress::Kind kind) const;
    /// Whether it may be probed there before it is known who is listening.
    [[nodiscard]] bool mayAskAnybody(LinkAddress::Kind kind) const;
};

/// The highest Family::fullRate among these; 0 if none has one.
[[nodiscard]] double fullRate(const QList<Family> &families);
