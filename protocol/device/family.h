// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/foreignfile.h"
#include "protocol/configuration/scriptlanguage.h"
#include "protocol/device/device.h"
#include "protocol/session/framer.h"
#include "protocol/session/linktiming.h"
#include "protocol/transport/linkaddress.h"

/// A kind of link that a family lives on.
struct FamilyLink
{
    LinkAddress::Kind kind = LinkAddress::Kind::Serial;
    /// Its question harms no board of another family there. Where it might, the address has to name the
    /// family.
    bool mayAskAnybody = true;
};

/// What it moves, in the words of the tables' catalogue.
struct Nouns
{
    const char *load = "camera";  ///< "the camera stands still"
};

/// A family of controllers as the program's table of families lists it.
struct Family
{
    QString key;  ///< "simplebgc"
    QString name;  ///< "SimpleBGC 32-bit"
    QList<FamilyLink> links;
    LinkTiming timing;
    /// Rate and parity pairs worth trying on a serial line, most likely first.
    QList<LineSettings> lines = {};
    Nouns nouns = {};
    std::function<std::unique_ptr<Framer>()> makeFramer;
    std::function<std::unique_ptr<Device>()> makeDevice;
    /// The parameters that a board with this identity has, to understand a file without the board.
    std::function<std::shared_ptr<const ParameterSet>(const BoardIdentity &)> makeParameters;
    /// The name of the protocol when these bytes look like one that its boards speak; empty where they do
    /// not, or not yet.
    std::function<QString(const QByteArray &heard)> recognise = {};
    /// Programs that its boards keep; null where there are none.
    std::shared_ptr<const ScriptLanguage> scripts = nullptr;
    /// The settings files of its own original program.
    std::optional<ForeignFile> settingsFile = {};
    /// Files with the calibration of a sensor.
    std::optional<CalibrationFile> calibrationFile = {};

    /// Whether its boards are reached over such links. A simulated board and a recording are as good as any.
    [[nodiscard]] bool livesOn(LinkAddress::Kind kind) const;
    /// Whether its question may be asked there before anybody knows who is listening.
    [[nodiscard]] bool mayAskAnybody(LinkAddress::Kind kind) const;
};
