// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/virtualboard.h"

#include <QTemporaryDir>
#include <QTest>

/// A simulated SimpleBGC board whose actions are carried out in virtual time.
struct SbgcRig : VirtualBoard
{
    using Texts = QMap<QString, QString>;

    explicit SbgcRig(int firmware = 2704, std::optional<LineSettings> line = {})
        : SbgcRig(withFirmware(firmware), line)
    {
    }
    explicit SbgcRig(const SimulatorOptions &options, std::optional<LineSettings> line = {})
        : VirtualBoard(options, line)
    {
        if (!identify())
            qFatal("no board");
    }
    Result<ActionReply> perform(const char *key, const Texts &texts = {})
    {
        const auto list = device.actions();
        const bool isOffered = std::any_of(list.begin(), list.end(), [key](const ActionSpec &action) {
            return qstrcmp(action.key, key) == 0;
        });
        if (!isOffered)
            return failure(ErrorCode::Unsupported, QLatin1String(key));
        return device.perform(channel, QLatin1String(key), argumentsFor(device, key, texts));
    }
    [[nodiscard]] QString path(const QString &name) const { return dir.filePath(name); }
    QTemporaryDir dir;
};

/// It fails, and its detail contains these words.
#define SAYS(outcome, words)                                                                                 \
    QVERIFY(!(outcome));                                                                                     \
    QVERIFY2((outcome).error().detail.contains(words), qPrintable((outcome).error().detail))
