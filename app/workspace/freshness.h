// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/client/deviceclient.h"
#include "protocol/telemetry/changewatch.h"
#include "widgets/views/stalecover.h"

#include <QTimer>

#include <functional>
#include <map>

/// Whether what is shown of the board is live. Data are stale after half a second or three periods without a
/// sample, whichever is longer; without a link as well, until another board is connected. Beside that there
/// may be no sensor behind them, and a board without time stamps may send the same values again and again.
class Freshness final : public QObject
{
    Q_OBJECT
public:
    explicit Freshness(DeviceClient &client);

    /// When the newest sample of these channels came, or when the board was connected if none has come at all
    /// since; empty while they are live, and for recordings. @param channels none = all
    [[nodiscard]] std::optional<QDateTime> staleSince(const QList<int> &channels = {}) const;

    /// Of the newest answer; empty while nothing comes, because it is old then.
    [[nodiscard]] std::optional<Duration> answerTime() const;

    /// A recording that was played to its end: what is shown is its last state.
    [[nodiscard]] bool hasPlayed() const;

    /// What is wrong with these channels, in words; empty while they are live.
    [[nodiscard]] QString troubleText(const QList<int> &channels = {}) const;
    /// Since when samples come and none of them differs from the one before; empty: they do.
    [[nodiscard]] std::optional<QDateTime> unchangedSince() const;
    /// When the newest value of any channel was seen to differ from the one before.
    [[nodiscard]] TimePoint changedAt() const { return m_change.changedAt(); }
    /// Since when the board repeats itself, by what is the same or by its time stamps: what it says of itself
    /// is old then; empty: it does not.
    [[nodiscard]] std::optional<QDateTime> frozenSince() const;

    /// Since when nothing has come for some seconds although nothing here keeps the line busy, or for longer
    /// than that explains: what the board does is not known; empty: it is.
    [[nodiscard]] std::optional<QDateTime> silentSince() const;

    using Channels = std::function<QList<int>()>;
    /// Shows the cover while these channels are stale. Asked each time, because boards number them
    /// differently.
    void watch(StaleCover &cover, const Channels &channels = {});

signals:
    void frozenChanged(bool frozen);
    void silentChanged(bool silent);

private:
    void look();
    void listen();
    [[nodiscard]] bool isWithoutSensor(const QList<int> &channels) const;
    [[nodiscard]] bool isRepeating() const;

    DeviceClient &m_client;
    std::map<StaleCover *, Channels> m_covers;
    ChangeWatch m_change;
    bool m_isFrozen = false;
    bool m_isSilent = false;
    bool m_isExcused = false;  // a job that may silence the board began while data came
    TimePoint m_heardAt{};  // or excused
    TimePoint m_connectedAt{};  // last
    TimePoint m_dataAt{};
    QTimer m_timer;
};
