// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/deviceclient.h"
#include "protocol/device/writereport.h"
#include "protocol/record/boardhistory.h"
#include "widgets/forms/editstack.h"
#include "widgets/models/errortext.h"
#include "widgets/theme/theme.h"

/// What all pages share: the client, the configuration with its edits, the history of snapshots, the theme. Turns wishes of
/// the operator into jobs, and their results into model changes and messages.
class Workspace final : public QObject
{
    Q_OBJECT
public:
    Workspace(TransportFactory transports, QList<Family> families, Theme &theme, QObject *parent = nullptr);

    [[nodiscard]] DeviceClient &client() { return m_client; }
    [[nodiscard]] ConfigurationModel &configuration() { return m_configuration; }
    [[nodiscard]] EditStack &edits() { return m_edits; }
    [[nodiscard]] Theme &theme() { return m_theme; }
    [[nodiscard]] BoardHistory &history() { return m_history; }

    void connectTo(const LinkAddress &address, const QString &family);
    /// Reads everything; edits are kept where the board is the same one.
    void readBoard();
    /// Writes what differs between the board and this, verified, with a snapshot before the first write.
    void write(const Configuration &wanted);
    void useProfile(int profile);
    void setMotors(bool on);
    /// Fast channels that somebody wants to see; each page has its own wish.
    void wishTelemetry(const QObject *who, const QList<int> &channels);

    /// The channel's newest value, NaN without one.
    [[nodiscard]] double latest(int channel) const;
    [[nodiscard]] ChannelRoles roles() const;
    /// True, false, or nothing while telemetry is missing or old.
    [[nodiscard]] std::optional<bool> motorsRunning() const;
    [[nodiscard]] std::vector<BoardFault> faults() const;
    [[nodiscard]] const std::optional<WriteReport> &lastReport() const { return m_lastReport; }
    [[nodiscard]] bool isWriting() const { return m_writing; }

signals:
    /// Something the operator must know.
    void problem(const ErrorText &text);
    /// Something that went well.
    void notice(const QString &text);
    void boardRead();
    void writeFinished();

private:
    void onState(DeviceClient::State state);
    void onReport(const Result<WriteReport> &result);
    void tellInterruptedWrite();
    void updateWish();
    void followActiveProfile();

    Theme &m_theme;
    DeviceClient m_client;
    ConfigurationModel m_configuration;
    EditStack m_edits;
    BoardHistory m_history;
    QHash<const QObject *, QList<int>> m_wishes;
    std::optional<WriteReport> m_lastReport;
    bool m_backupDone = false;
    bool m_writing = false;
    bool m_writeInterrupted = false;   // the link broke during a write; told again once the board can be read
    bool m_wasLost = false;
    bool m_reading = false;
    bool m_switchingProfile = false;
    mutable quint64 m_lastRows = 0;
    mutable TimePoint m_lastRowsAt{};
};
