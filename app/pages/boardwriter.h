// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/configuration.h"
#include "protocol/device/writereport.h"
#include "widgets/models/livemodel.h"

#include <QObject>

class Workspace;

/// Writes edits to the board, tells the operator how it went, and mends what a broken link left half done.
class BoardWriter final : public QObject
{
    Q_OBJECT
public:
    explicit BoardWriter(Workspace &workspace);

    /// Writes what differs between the board and this, verified, with a snapshot before the first write on this link.
    void write(const Configuration &wanted);
    [[nodiscard]] bool isWriting() const { return m_writing; }
    [[nodiscard]] const std::optional<WriteReport> &lastReport() const { return m_lastReport; }
    /// Another board, or one that may have been changed meanwhile: the next write makes its own safety copy.
    void beginLink() { m_backupDone = false; }
    /// The board was read: if a write had broken off before, asks what to do about it.
    void offerRepair();

signals:
    /// Everything that was wanted is on the board, and stored.
    void completed();

private:
    void onReport(const Result<WriteReport> &result);
    void restoreLive(const LiveValues &before);

    Workspace &m_workspace;
    std::optional<WriteReport> m_lastReport;
    std::optional<Configuration> m_wantedAgain;   // becomes edits once an interrupted write is undone
    bool m_backupDone = false;
    bool m_writing = false;
    bool m_interrupted = false;   // the link broke during a write; told again once the board can be read
};
