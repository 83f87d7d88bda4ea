// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QtTest>

/// How long a test waits for a condition before it counts as missed, in milliseconds: a net, and no
/// requirement. A loaded machine under sanitizers takes ten times as long as one that is free.
inline constexpr int kPatience = 60000;

/// Looks every 50 ms, as Qt's macros do, but once it was yes it is not asked again: what swings, or is told
/// for a moment, may be gone by then.
template <typename Condition> bool comesTrue(Condition &&condition, int timeout)
{
    QElapsedTimer timer;
    timer.start();
    while (!condition()) {
        if (timer.elapsed() >= timeout)
            return condition();
        QTest::qWait(50);
    }
    return true;
}

// Qt's own wait 5 s.
#undef QTRY_VERIFY_WITH_TIMEOUT
#undef QTRY_VERIFY2_WITH_TIMEOUT
#undef QTRY_COMPARE_WITH_TIMEOUT
#undef QTRY_VERIFY
#undef QTRY_VERIFY2
#undef QTRY_COMPARE
#define QTRY_VERIFY2_WITH_TIMEOUT(expression, message, timeout)                                              \
    QVERIFY2(comesTrue([&] { return bool(expression); }, timeout), message)
#define QTRY_VERIFY_WITH_TIMEOUT(expression, timeout)                                                        \
    QTRY_VERIFY2_WITH_TIMEOUT(expression, "never: " #expression, timeout)
#define QTRY_COMPARE_WITH_TIMEOUT(actual, expected, timeout)                                                 \
    do {                                                                                                     \
        if (!comesTrue([&] { return (actual) == (expected); }, timeout))                                     \
            QCOMPARE(actual, expected);                                                                      \
    } while (false)
#define QTRY_VERIFY(expression) QTRY_VERIFY_WITH_TIMEOUT((expression), kPatience)
#define QTRY_VERIFY2(expression, message) QTRY_VERIFY2_WITH_TIMEOUT((expression), (message), kPatience)
#define QTRY_COMPARE(actual, expected) QTRY_COMPARE_WITH_TIMEOUT((actual), expected, kPatience)
