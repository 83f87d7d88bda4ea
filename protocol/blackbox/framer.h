// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/session/framer.h"

namespace blackbox {

/// Lines of text; what is longer than any line of a black box is none.
class Framer final : public ::Framer
{
public:
    enum Id { RowFrame = 1, NamesFrame };

    void feed(Bytes bytes, const FrameSink &sink) override;
    void packetEnded(const FrameSink &) override { }
    void flush(const FrameSink &sink) override;
    [[nodiscard]] bool isWaiting() const override { return !m_line.isEmpty(); }
    [[nodiscard]] const FramerStatistics &statistics() const override { return m_statistics; }

private:
    QByteArray m_line;
    bool m_isTooLong = false;
    FramerStatistics m_statistics;
};

}  // namespace blackbox
