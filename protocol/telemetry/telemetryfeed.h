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
    using ResetDetector = std::function<bool(const FrameView &)>;

    /// @param onFrame called for every frame, for those that are not telemetry
    TelemetryFeed(std::shared_ptr<TelemetryStore> store, ResetDetector isReset, std::function<void()> onReset,
                  std::function<void(const FrameView &)> onFrame)
        : m_store(std::move(store))
        , m_isReset(std::move(isReset))
        , m_onReset(std::move(onReset))
        , m_onFrame(std::move(onFrame))
    {
    }

    void setDecoder(std::shared_ptr<TelemetryDecoder> decoder) { m_decoder = std::move(decoder); }

    void frameReceived(const FrameView &frame, TimePoint at, bool) override
    {
        if (m_decoder)
            m_decoder->decode(frame, at, *m_store);
        if (m_isReset && m_isReset(frame))
            m_onReset();
        m_onFrame(frame);
    }

    void bytesSent(QByteArrayView bytes, TimePoint) override
    {
        if (m_decoder)
            m_decoder->sent(bytes);
    }

private:
    std::shared_ptr<TelemetryStore> m_store;
    std::shared_ptr<TelemetryDecoder> m_decoder;
    ResetDetector m_isReset;
    std::function<void()> m_onReset;
    std::function<void(const FrameView &)> m_onFrame;
};
