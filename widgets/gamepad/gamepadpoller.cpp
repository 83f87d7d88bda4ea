// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/gamepad/gamepadpoller.h"

#include <algorithm>
#include <thread>

std::shared_ptr<GamepadPoller> GamepadPoller::start(Maker maker, QByteArray preferred, QString name)
{
    std::shared_ptr<GamepadPoller> poller(new GamepadPoller);
    poller->m_preferred = std::move(preferred);
    poller->m_preferredName = std::move(name);
    std::thread([poller, maker = std::move(maker)] { poller->run(maker); }).detach();
    return poller;
}

void GamepadPoller::stop()
{
    std::unique_lock lock(m_mutex);
    m_stopping = true;
    m_changed.notify_all();
    m_changed.wait_for(lock, kPatience, [this] { return m_ended; });
}

void GamepadPoller::setPaused(bool paused)
{
    const std::lock_guard lock(m_mutex);
    m_paused = paused;
    if (paused) {
        m_state.used.reset();
        m_state.pads.clear();
        m_state.at = {};
    }
    m_changed.notify_all();
}

GamepadPoller::State GamepadPoller::state() const
{
    const std::lock_guard lock(m_mutex);
    return m_state;
}

void GamepadPoller::prefer(const QByteArray &guid, const QString &name)
{
    const std::lock_guard lock(m_mutex);
    m_preferred = guid;
    m_preferredName = name;
    const auto isMeant
        = [&](const GamepadReading &pad) { return pad.guid == guid && (name.isEmpty() || pad.name == name); };
    // The other is taken at the next poll, as one that came.
    if (m_state.used && !isMeant(*m_state.used)
        && std::any_of(m_state.pads.begin(), m_state.pads.end(), isMeant))
        m_state.used.reset();
}

void GamepadPoller::run(const Maker &maker)
{
    {
        auto source = maker();
        if (!source) {
            fail(source.error());
        } else if (const auto opened = (*source)->open(); !opened) {
            fail(opened.error());
        } else {
            std::unique_lock lock(m_mutex);
            while (!m_stopping) {
                lock.unlock();
                auto pads = (*source)->poll();
                lock.lock();
                if (!m_paused)
                    take(std::move(pads), Clock::now());
                m_changed.wait_for(lock, kPeriod, [this] { return m_stopping; });
                m_changed.wait(lock, [this] { return m_stopping || !m_paused; });
            }
        }
    }  // the source ends on the thread that has read it
    const std::lock_guard lock(m_mutex);
    m_ended = true;
    m_changed.notify_all();
}

void GamepadPoller::fail(const Error &error)
{
    const std::lock_guard lock(m_mutex);
    m_state.error = error;
}

void GamepadPoller::take(std::vector<GamepadReading> pads, TimePoint now)
{
    m_state.at = now;
    m_state.pads = std::move(pads);
    const auto find = [this](auto &&isWanted) -> const GamepadReading * {
        const auto found = std::find_if(m_state.pads.begin(), m_state.pads.end(), isWanted);
        return found == m_state.pads.end() ? nullptr : &*found;
    };
    const GamepadReading *used = nullptr;
    if (m_state.used)
        used = find([id = m_state.used->id](const GamepadReading &pad) { return pad.id == id; });
    // One that went is seen as gone at least once before another takes its place.
    const bool hasGone = m_state.used && !used;
    if (!used && !hasGone)
        used = find([this](const GamepadReading &pad) {
            return pad.guid == m_preferred && pad.name == m_preferredName;
        });
    if (!used && !hasGone)
        used = find([this](const GamepadReading &pad) { return pad.guid == m_preferred; });
    if (!used && !hasGone && !m_state.pads.empty())
        used = &m_state.pads.front();
    follow(used);
}

void GamepadPoller::follow(const GamepadReading *used)
{
    if (!used) {
        m_state.used.reset();
        return;
    }
    if (!m_state.used) {
        ++m_state.session;
        m_state.presses.assign(used->buttons.size(), 0);
    } else {
        const std::vector<bool> &before = m_state.used->buttons;
        for (std::size_t i = 0; i < std::min(used->buttons.size(), before.size()); ++i)
            m_state.presses[i] += used->buttons[i] && !before[i] ? 1 : 0;
    }
    m_state.used = *used;
}
