// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>

class Replay;
struct ReplayState;

/// Playback control of a recorded link for the GUI: pause, speed, position. The settings are kept when the
/// recording is reopened.
class ReplayControl
{
public:
    using Job = std::function<void(Replay &)>;

    /// @param onLink runs a job on the I/O thread, if the open link is a recording; may be called at any time
    /// @param reopen opens the same recording again, from its beginning
    ReplayControl(std::function<void(Job)> onLink, std::function<void()> reopen);
    ~ReplayControl();

    /// Playback state as last reported; empty for a live link.
    [[nodiscard]] const std::optional<ReplayState> &state() const;
    void setPaused(bool paused);
    /// @param speed multiple of real time, 0.05 to 100
    void setSpeed(double speed);
    /// Seconds since the recording's first byte. Going back reopens it and plays up to that point at once, so
    /// that everything before it is available.
    void seek(double seconds);

    // For the client:
    /// The address has changed: all settings are dropped.
    void forget();
    /// The recording is open and ready to deliver data.
    void begin();
    void setState(std::optional<ReplayState> state);

private:
    std::function<void(Job)> m_onLink;
    std::function<void()> m_reopen;
    std::unique_ptr<std::optional<ReplayState>> m_state;
    double m_from = 0;  // position to go to as soon as the recording is open
    std::optional<double> m_speed;
    bool m_paused = false;
    bool m_begun = false;
};
