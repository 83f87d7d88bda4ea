// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QString>

/// Times at which no samples came. Nobody counts as lost what was never sent.
class Holes
{
public:
    /// @param step seconds between two samples @param period expected of them; 0: not known
    void take(double step, double period);
    [[nodiscard]] int count() const { return m_count; }
    /// For people; empty if there are none. Starts with a comma.
    [[nodiscard]] QString words() const;
    [[nodiscard]] QJsonObject json() const;

private:
    int m_count = 0;
    double m_seconds = 0;
};
