// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/patience.h"
#include "widgets/gamepad/gamepadpoller.h"

#include <QTest>

#include <algorithm>

/// Gamepads of a test's own: plugged, moved and hung as the test says. Outlives the source that reads it.
class FakeGamepads
{
public:
    static constexpr int kAxes = 6;
    static constexpr int kButtons = 8;

    /// @return its id
    /// @param layout GamepadReading::layout
    int plug(const QByteArray &guid = "pad", const QString &name = QStringLiteral("Test pad"),
             const QByteArray &layout = {})
    {
        const std::lock_guard lock(m_mutex);
        m_pads.push_back(
            {m_nextId, guid, name, std::vector<double>(kAxes), std::vector<bool>(kButtons), layout});
        return m_nextId++;
    }
    void unplug(int id)
    {
        const std::lock_guard lock(m_mutex);
        std::erase_if(m_pads, [id](const GamepadReading &pad) { return pad.id == id; });
    }
    void move(int axis, double position, std::size_t pad = 0)
    {
        const std::lock_guard lock(m_mutex);
        m_pads.at(pad).axes.at(std::size_t(axis)) = position;
    }
    void press(int button, bool down, std::size_t pad = 0)
    {
        const std::lock_guard lock(m_mutex);
        m_pads.at(pad).buttons.at(std::size_t(button)) = down;
    }
    /// While it hangs, a poll does not return.
    void setHanging(bool hangs)
    {
        const std::lock_guard lock(m_mutex);
        m_hangs = hangs;
        m_changed.notify_all();
    }
    void setError(std::optional<Error> error)
    {
        const std::lock_guard lock(m_mutex);
        m_error = std::move(error);
    }
    [[nodiscard]] quint64 polls() const
    {
        const std::lock_guard lock(m_mutex);
        return m_polls;
    }

    /// Sources that read them.
    [[nodiscard]] int readers() const
    {
        const std::lock_guard lock(m_mutex);
        return m_readers;
    }
    /// Waits until they have been read so many more times.
    [[nodiscard]] bool arePolled(quint64 times) const
    {
        const quint64 before = polls();
        return QTest::qWaitFor([this, before, times] { return polls() >= before + times; }, kPatience);
    }

    [[nodiscard]] GamepadPoller::Maker maker()
    {
        return [this]() -> Result<std::unique_ptr<GamepadSource>> { return std::make_unique<Source>(*this); };
    }

private:
    class Source final : public GamepadSource
    {
    public:
        explicit Source(FakeGamepads &pads)
            : m_of(pads)
        {
            const std::lock_guard lock(m_of.m_mutex);
            ++m_of.m_readers;
        }
        ~Source() override
        {
            const std::lock_guard lock(m_of.m_mutex);
            --m_of.m_readers;
        }
        Result<void> open() override
        {
            const std::lock_guard lock(m_of.m_mutex);
            if (m_of.m_error)
                return tl::unexpected(*m_of.m_error);
            return {};
        }
        std::vector<GamepadReading> poll() override
        {
            std::unique_lock lock(m_of.m_mutex);
            m_of.m_changed.wait(lock, [this] { return !m_of.m_hangs; });
            ++m_of.m_polls;
            return m_of.m_pads;
        }

    private:
        FakeGamepads &m_of;
    };

    mutable std::mutex m_mutex;
    std::condition_variable m_changed;
    std::vector<GamepadReading> m_pads;
    std::optional<Error> m_error;
    bool m_hangs = false;
    quint64 m_polls = 0;
    int m_readers = 0;
    int m_nextId = 1;
};
