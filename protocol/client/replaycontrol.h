// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <optional>

class Replay;
struct ReplayState;

/// The screen's side of a recorded link: stands still, runs at another speed, goes to a place. What was
/// chosen is kept while the recording is opened anew.
class ReplayControl
{
public:
    using Job = std::function<void(Replay &)>;

    /// @param onLink runs a job on the I/O thread, if the open link is a recording; may be called at any time
    /// @param reopen opens the same recording again, from its beginning
    ReplayControl(std::function<void(Job)> onLink, std::function<void()> reopen);
    ~ReplayControl();

    /// Where it stands, as last told; empty for a living link.
    [[nodiscard]] const std::optional<ReplayState> &state() const;
    void setPaused(bool paused);
    /// @param speed times real time, 0.05 to 100
    void setSpeed(double speed);
    /// Seconds since the recording's first byte. Going back opens it anew and plays up to there at once, so
    /// that everything before is there to look at.
    void seek(double seconds);

    // For the client:
    /// Another address: nothing of what was chosen holds.
    void forget();
    /// The recording is open and its data can be taken.
    void begin();
    void setState(std::optional<ReplayState> state);

private:
    std::function<void(Job)> m_onLink;
    std::function<void()> m_reopen;
    std::unique_ptr<std::optional<ReplayState>> m_state;
    double m_from = 0;  // go there as soon as the recording is open
    std::optional<double> m_speed;
    bool m_paused = false;
    bool m_begun = false;
};
