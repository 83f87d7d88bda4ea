// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/plot/plotmarks.h"

#include <QSet>

class Workspace;

/// Puts what happens on the link beside the data: connection lost and found, profile switched, values
/// written, faults of the board, silences.
class LinkMarks final : public QObject
{
    Q_OBJECT
public:
    explicit LinkMarks(Workspace &workspace);

    /// Adds a mark at this moment.
    void add(PlotMark::Kind kind, const QString &text);

private:
    void look();
    void onLive(const QList<int> &parameters);

    Workspace &m_workspace;
    const void *m_store = nullptr;
    QSet<QString> m_faults;
    double m_profile = -1;
    quint64 m_silences = 0;
    double m_silentSeconds = 0;
};
