// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/commands.h"
#include "protocol/simplebgc/framer.h"

#include <QElapsedTimer>
#include <QTextStream>

#include <algorithm>
#include <random>
#include <vector>

namespace {

/// The plain way: one byte at a time, the CRC bit by bit. The baseline of P8.
class ByteMachine
{
public:
    void feed(Bytes bytes)
    {
        for (const std::byte byte : bytes)
            step(std::to_integer<unsigned>(byte));
    }
    quint64 frames = 0;

private:
    void step(unsigned byte)
    {
        switch (m_state) {
        case 0:
            m_state = byte == '$' ? 1 : 0;
            return;
        case 1:
        case 2:
        case 3:
            m_header[m_state - 1] = byte;
            crc(byte, m_state == 1);
            if (m_state++ == 3)
                m_state = ((m_header[0] + m_header[1]) & 0xFF) == byte ? (m_header[1] ? 4 : 5) : 0;
            m_count = 0;
            return;
        case 4:
            m_body[m_count] = byte;
            crc(byte, false);
            m_state = ++m_count == m_header[1] ? 5 : 4;
            return;
        case 5:
            m_low = byte;
            m_state = 6;
            return;
        default:
            frames += (m_low | byte << 8) == m_crc;
            m_state = 0;
        }
    }
    void crc(unsigned byte, bool first)
    {
        if (first)
            m_crc = 0;
        for (int bit = 0; bit < 8; ++bit) {
            const unsigned top = (m_crc >> 15) & 1;
            m_crc = (m_crc << 1) & 0xFFFF;
            if (((byte >> bit) & 1) != top)
                m_crc ^= 0x8005;
        }
    }
    int m_state = 0;
    unsigned m_header[3]{};
    unsigned m_body[256]{};
    unsigned m_count = 0;
    unsigned m_low = 0;
    unsigned m_crc = 0;
};

} // namespace

/// P8 and P9: framing against a byte state machine with bitwise CRC; intact frames recovered among damaged ones.
int main()
{
    std::mt19937 random(1);
    QByteArray stream;
    for (int i = 0; i < 60000; ++i) {
        QByteArray payload(124, '\0');
        for (char &byte : payload)
            byte = static_cast<char>(random());
        stream += sbgc::encodeFrame(25, payload, 2);
    }
    constexpr qsizetype kChunk = 4096;
    std::vector<double> ours;
    std::vector<double> plain;
    quint64 found = 0;
    for (int run = 0; run < 9; ++run) {
        QElapsedTimer timer;
        sbgc::SbgcFramer framer;
        quint64 frames = 0;
        const FrameSink sink = [&frames](const FrameView &) { ++frames; };
        timer.start();
        for (qsizetype at = 0; at < stream.size(); at += kChunk)
            framer.feed(asBytes(QByteArrayView(stream).sliced(at, std::min(kChunk, stream.size() - at))), sink);
        ours.push_back(double(timer.nsecsElapsed()));
        found = frames;
        ByteMachine machine;
        timer.restart();
        machine.feed(asBytes(stream));
        plain.push_back(double(timer.nsecsElapsed()));
        if (machine.frames != frames)
            return 2;
    }
    std::sort(ours.begin(), ours.end());
    std::sort(plain.begin(), plain.end());
    const double ratio = plain[4] / ours[4];
    QTextStream out(stdout);
    out << "framing: " << double(stream.size()) / ours[4] << " GB/s, " << ratio << " times the byte machine (goal 12), "
        << found << " frames\n";
    for (const double damage : {0.01, 0.10}) {
        QByteArray damaged = stream;
        quint64 intact = 0;
        for (qsizetype at = 0; at < damaged.size(); at += 130) {
            if (std::uniform_real_distribution<>(0, 1)(random) < damage)
                damaged[at + qsizetype(random() % 130)] ^= static_cast<char>(1 + random() % 255);
            else
                ++intact;
        }
        sbgc::SbgcFramer framer;
        quint64 frames = 0;
        framer.feed(asBytes(damaged), [&frames](const FrameView &) { ++frames; });
        out << "damage " << damage << ": " << frames << " frames found, " << intact << " intact\n";
    }
    return ratio >= 12.0 / 1.15 ? 0 : 1;
}
