// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/framelistener.h"
#include "protocol/telemetry/streams.h"

/// Receives frames on the I/O thread and puts them into the store. The decoder may only be changed on the I/O
/// thread.
class TelemetryFeed final : public FrameListener
{
public:
    /// What else wants to know of the frames.
    struct Hooks
    {
        /// Every frame, once it is in the store. @param claimed it answered a request
        std::function<void(const FrameView &, TimePoint at, bool claimed)> received;
        std::function<void(QByteArrayView, TimePoint at)> sent;
    };

    TelemetryFeed(std::shared_ptr<TelemetryStore> store, Hooks hooks)
        : m_store(std::move(store))
        , m_hooks(std::move(hooks))
    {
    }

    void setDecoder(std::shared_ptr<TelemetryDecoder> decoder) { m_decoder = std::move(decoder); }

    void frameReceived(const FrameView &frame, TimePoint at, bool claimed) override
    {
        if (m_decoder)
            m_decoder->decode(frame, at, *m_store);
        m_hooks.received(frame, at, claimed);
    }

    void bytesSent(QByteArrayView bytes, TimePoint at) override
    {
        if (m_decoder)
            m_decoder->sent(bytes, *m_store);
        m_hooks.sent(bytes, at);
    }

private:
    std::shared_ptr<TelemetryStore> m_store;
    std::shared_ptr<TelemetryDecoder> m_decoder;
    Hooks m_hooks;
};
