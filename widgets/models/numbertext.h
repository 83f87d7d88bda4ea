// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QLocale>
#include <QString>

#include <optional>

/// Numbers as the operator's language writes them, for the screen alone: files, the command line and what is
/// copied as data keep the point. Digits are not grouped. All of this belongs to the GUI thread.

/// From now on numbers on screen are written so; C, with a point, until it is called.
void setNumberLocale(const QLocale &locale);
/// For what formats its numbers itself, such as the axes of charts.
[[nodiscard]] QLocale numberLocale();

/// @param decimals digits behind the decimal mark; a rounded zero has no sign
[[nodiscard]] QString numberText(double value, int decimals);
/// At most that many significant digits, and no zeros behind them.
[[nodiscard]] QString shortNumberText(double value, int digits = 6);
/// A number that was written with a point, such as ParameterSpec::rounded().
[[nodiscard]] QString numberText(const QString &plain);
/// A sentence of the protocol's floor, with every number that has decimals rewritten; versions, addresses and
/// keys stay.
[[nodiscard]] QString withNumbers(const QString &sentence);
/// Date and time of day.
[[nodiscard]] QString dateText(const QDateTime &time);
/// "1.2 MB".
[[nodiscard]] QString sizeText(qint64 bytes);
/// The number that was typed, with a comma or a point before the decimals. NaN: it is none, or there is more
/// than one way to read it.
[[nodiscard]] double typedNumber(const QString &text);
/// What was typed, if its only mark can part thousands as well as decimals: "1.000" is 1000 then.
[[nodiscard]] std::optional<double> groupedNumber(const QString &text);
