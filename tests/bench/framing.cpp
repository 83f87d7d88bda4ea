// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/commands.h"
#include "protocol/simplebgc/framer.h"
#include "tests/bench/report.h"

#include <QElapsedTimer>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

using namespace Qt::StringLiterals;

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
        case 0: m_state = byte == '$' ? 1 : 0; return;
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
        default: frames += (m_low | byte << 8) == m_crc; m_state = 0;
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

}  // namespace

/// P8 and P9: framing against a byte state machine with bitwise CRC; intact frames recovered among damaged
/// ones.
void benchFraming(Report &report)
{
    std::mt19937 random(1);
    QByteArray stream;
    for (int i = 0; i < 60000; ++i) {
        QByteArray payload(124, '\0');
        for (char &byte : payload)
            byte = static_cast<char>(random());
        stream += simplebgc::encodeFrame(25, payload, 2);
    }
    constexpr qsizetype kChunk = 4096;
    constexpr qsizetype kFrame = 130;
    std::vector<double> ours;
    std::vector<double> plain;
    for (int run = 0; run < 9; ++run) {
        QElapsedTimer timer;
        simplebgc::Framer framer;
        quint64 frames = 0;
        const FrameSink sink = [&frames](const FrameView &) { ++frames; };
        timer.start();
        for (qsizetype at = 0; at < stream.size(); at += kChunk)
            framer.feed(asBytes(QByteArrayView(stream).sliced(at, std::min(kChunk, stream.size() - at))),
                        sink);
        ours.push_back(double(timer.nsecsElapsed()));
        ByteMachine machine;
        timer.restart();
        machine.feed(asBytes(stream));
        plain.push_back(double(timer.nsecsElapsed()));
        if (machine.frames != frames)
            qFatal("the two framers do not agree");
    }
    report.atLeast(u"P8"_s, u"framing / byte state machine with bitwise CRC"_s, median(plain) / median(ours),
                   12, u"times"_s,
                   u"%1 and %2 GB/s"_s.arg(double(stream.size()) / median(ours), 0, 'f', 2)
                       .arg(double(stream.size()) / median(plain), 0, 'f', 2));
    for (const double damage : {0.01, 0.10}) {
        QByteArray damaged = stream;
        quint64 intact = 0;
        std::vector<bool> whole;
        for (qsizetype at = 0; at < damaged.size(); at += kFrame) {
            whole.push_back(std::uniform_real_distribution<>(0, 1)(random) >= damage);
            if (whole.back())
                ++intact;
            else
                damaged[at + qsizetype(random() % quint64(kFrame))] ^= static_cast<char>(1 + random() % 255);
        }
        simplebgc::Framer framer;
        quint64 found = 0;
        quint64 wrong = 0;
        qsizetype next = 0;
        framer.feed(asBytes(damaged), [&](const FrameView &frame) {
            // A frame that was sent, or one that only looks like it?
            const QByteArray raw = toByteArray(frame.raw);
            const qsizetype at = damaged.indexOf(raw, next);
            const bool sent
                = raw.size() == kFrame && at >= 0 && at % kFrame == 0 && whole[std::size_t(at / kFrame)];
            next = sent ? at + kFrame : next;
            (sent ? found : wrong) += 1;
        });
        report.atLeast(u"P9"_s, u"intact frames recovered at %1 % damage"_s.arg(damage * 100),
                       100.0 * double(found) / double(intact), 100, u"%"_s,
                       u"%1 intact frames"_s.arg(intact));
        // A 16-bit CRC lets one in 65536 pass by chance.
        const double chance = double(whole.size() - intact) / 65536.0;
        report.atMost(u"P9"_s, u"damaged frames accepted at %1 %"_s.arg(damage * 100), double(wrong),
                      std::ceil(chance + 3 * std::sqrt(chance)), u""_s,
                      u"chance alone lets %1 pass"_s.arg(chance, 0, 'f', 2));
    }
}
