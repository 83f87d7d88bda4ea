// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/parameterspec.h"

#include <QVariantMap>

/// Identity and capabilities of a board, found at identification.
struct BoardIdentity
{
    QString family;  ///< "simplebgc"
    QString model;  ///< "SimpleBGC 3.0"
    QString firmware;  ///< "2.59b0"
    int firmwareNumber = 0;  ///< as the family numbers it, 2590
    QString serial;  ///< unique number of this board, hexadecimal; names its history
    Capabilities capabilities;
    int profileCount = 1;
    bool usb = false;  ///< native USB: rate and parity do not matter
    bool writable = true;  ///< false: unknown firmware, everything is shown and nothing is written
    QVariantMap extra;  ///< further facts specific to the family, by key

    /// Key in `extra`, true: the serial number is only a look that other boards may share.
    static inline const QString kUnnumbered = QStringLiteral("unnumbered");

    /// It has a number of its own; without one, `serial` is a look at most.
    [[nodiscard]] bool isNumbered() const { return !serial.isEmpty() && !extra.value(kUnnumbered).toBool(); }

    friend bool operator==(const BoardIdentity &, const BoardIdentity &) = default;
};
