// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/clock.h"
#include "widgets/gamepad/gamepadsource.h"

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>

/// Reads gamepads on a thread of its own, a hundred times a second, and keeps the newest reading.
///
/// A driver may hang. The thread is therefore not waited for without end: whoever lets go of the poller
/// leaves a thread that hangs behind, with what it needs.
class GamepadPoller : public std::enable_shared_from_this<GamepadPoller>
{
public:
    static constexpr auto kPeriod = 10ms;
    static constexpr auto kPatience = 500ms;  ///< for the thread to end

    using Maker = std::function<Result<std::unique_ptr<GamepadSource>>()>;
    struct State
    {
        TimePoint at{};  ///< of the last poll; the epoch before the first
        std::vector<GamepadReading> pads;  ///< all that are plugged in
        std::optional<GamepadReading> used;
        std::vector<quint32> presses;  ///< of each button of the one used, since it came
        quint64 session = 0;  ///< counts those that came into use
        std::optional<Error> error;  ///< why nothing can be read
    };

    /// The thread makes the source itself; the first time that loads the module.
    [[nodiscard]] static std::shared_ptr<GamepadPoller> start(Maker maker, QByteArray preferred,
                                                              QString name = {});
    /// Tells the thread to end, and waits a moment for it.
    void stop();
    /// While it pauses nothing is read and no gamepad is in use; the driver stays open.
    void setPaused(bool paused);
    [[nodiscard]] State state() const;
    /// The kind that is used when several are plugged in; among those of a kind the one of this name. It is
    /// changed over to at once.
    void prefer(const QByteArray &guid, const QString &name = {});

private:
    GamepadPoller() = default;
    void run(const Maker &maker);
    void take(std::vector<GamepadReading> pads, TimePoint now);
    void follow(const GamepadReading *used);
    void fail(const Error &error);

    mutable std::mutex m_mutex;
    std::condition_variable m_changed;
    State m_state;
    QByteArray m_preferred;
    QString m_preferredName;
    bool m_paused = false;
    bool m_stopping = false;
    bool m_ended = false;
};
