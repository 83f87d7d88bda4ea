// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/clock.h"

#include <QString>

#include <optional>

class QTextStream;

/// What is so at this moment, on stderr: on a terminal one line that is rewritten, elsewhere a line a second
/// at most.
class LiveLine
{
public:
    explicit LiveLine(QTextStream &err);

    void show(const QString &text);
    /// Something else is written next.
    void clear();

private:
    QTextStream &m_err;
    bool m_isTerminal;
    bool m_isShown = false;
    QString m_text;
    std::optional<TimePoint> m_writtenAt;
};
