// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/pages/tune/responsepage.h"
#include "tests/support/patience.h"

#include <QPushButton>
#include <QTest>

/// How often a measurement may be begun again. It runs in real time: where the machine stands still,
/// telemetry has a hole, the program measures nothing and says to try again.
inline constexpr int kMeasureTries = 4;

/// Arms and starts a measurement, until one was recorded.
inline bool measure(ResponsePage &page)
{
    const auto wanted = page.records().size() + 1;
    for (int i = 0; i < kMeasureTries; ++i) {
        QTest::mouseClick(page.armButton(), Qt::LeftButton);
        QTest::mouseClick(page.startButton(), Qt::LeftButton);
        if (!page.isRunning() || !QTest::qWaitFor([&page] { return !page.isRunning(); }, kPatience))
            return false;
        if (page.records().size() == wanted)
            return true;
    }
    return false;
}
