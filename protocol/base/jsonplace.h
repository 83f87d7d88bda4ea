// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/filefault.h"

#include <QJsonDocument>

/// Line, from 1, in which the value at this path of names begins; entries of arrays are named by their
/// number. For a text that was parsed without an error; 0 if nothing is there.
[[nodiscard]] int lineOfJson(QByteArrayView json, const QStringList &path);

/// Whether no object of a text that was parsed without an error has two entries with the same name. Errors:
/// BadFile, with both lines.
[[nodiscard]] Result<void> checkOnce(QByteArrayView json, FileKind kind);

/// What is wrong with a text that should be one JSON object, or an array if it opens with a bracket: empty,
/// cut off, something else, or damaged in a line.
[[nodiscard]] FileFault jsonFault(const QByteArray &json, const QJsonParseError &error, FileKind kind,
                                  char opening = '{');

/// The JSON object, or the array, in a file of at most so many bytes. Errors: BadFile.
[[nodiscard]] Result<QJsonDocument> readJson(const QString &path, FileKind kind, qint64 largest,
                                             char opening = '{');
