// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What a link to a drone is measured by: its PINGs, and what comes to us that somebody else has asked for.
#include "protocol/bcflight/decoder.h"
#include "protocol/bcflight/framer.h"
#include "protocol/bcflight/payloads.h"
#include "protocol/bcflight/pingprobe.h"
#include "protocol/bcflight/tables.h"
#include "protocol/telemetry/telemetrystore.h"

#include <QTest>

#include <cmath>
#include <map>
#include <random>

using namespace Qt::StringLiterals;
using namespace bcflight;

namespace {

constexpr milliseconds kBeat = 250ms;

/// A drone in a few lines: answers PINGs after so long, and streams a hundred packets per second.
struct Rig
{
    PingProbe probe;
    TimePoint now = TimePoint() + 1h;
    milliseconds roundTrip = 30ms;
    double streamShare = 1;  // of the packets that come here
    bool answers = true;
    bool isHeld = false;  // what is on its way comes when it is not any more, all at once
    milliseconds bunch{0};  // so often it delivers what it has, all at once
    QList<QByteArray> held;

    void arrive(const QByteArray &bytes, TimePoint at)
    {
        if (isHeld || (bunch > 0ms && at.time_since_epoch() % bunch >= 10ms)) {
            held.append(bytes);
            return;
        }
        for (const QByteArray &late : std::exchange(held, {}))
            arrive(late, at);
        bcflight::Framer framer;
        const auto sink = [&](const FrameView &frame) { probe.frameArrived(frame, at); };
        framer.feed(asBytes(bytes), sink);
        framer.packetEnded(sink);
    }
    QByteArray beat()
    {
        const QByteArray ping = probe.beat(now);
        probe.sent(asBytes(ping), now);
        return ping;
    }
    void run(milliseconds time)
    {
        const TimePoint end = now + time;
        double due = 0;
        TimePoint nextBeat = now;
        std::optional<std::pair<TimePoint, QByteArray>> reply;
        for (; now < end; now += 10ms) {
            if (reply && reply->first <= now) {
                arrive(reply->second, reply->first);
                reply.reset();
            }
            if (now >= nextBeat) {
                const QByteArray ping = beat();
                if (answers)
                    reply = {now + roundTrip, ping};
                nextBeat = now + kBeat;
            }
            due += streamShare;
            if (due >= 1) {
                due -= 1;
                arrive(QByteArray::fromHex("001b3f800000001200000000"), now);
            }
        }
    }
    [[nodiscard]] ProbedLink quality() const { return probe.quality(now); }
};

/// A drone that streams to whoever sent last, behind a network that delays, loses, doubles and reorders.
struct Network
{
    Rig rig;
    milliseconds othersPeriod{0};  // 0: nobody else is there
    milliseconds delay{10};
    double loss = 0;
    double doubled = 0;
    double stalls = 0;  // probability per 10 ms that nothing comes for 250 ms, and then all of it
    std::mt19937 random{7};
    std::multimap<TimePoint, QByteArray> under;
    TimePoint stalledUntil{};
    bool isOurs = true;
    int step = 0;

    [[nodiscard]] bool happens(double probability)
    {
        return std::uniform_real_distribution<>(0, 1)(random) < probability;
    }
    void send(const QByteArray &bytes)
    {
        const auto late = delay + 10ms * std::uniform_int_distribution<>(0, delay > 100ms ? 3 : 0)(random);
        if (!happens(loss))
            under.emplace(rig.now + late, bytes);
        if (happens(doubled))
            under.emplace(rig.now + late + 20ms, bytes);
    }
    void run(milliseconds time)
    {
        for (const TimePoint end = rig.now + time; rig.now < end; rig.now += 10ms) {
            ++step;
            if (othersPeriod > 0ms && step % (othersPeriod / 10ms) == 0)
                isOurs = false;
            if (step % 25 == 0) {
                isOurs = true;
                send(rig.beat());
            }
            if (step % 20 == 7) {
                isOurs = true;
                rig.probe.sent(asBytes(encode(Message::Status)), rig.now);
                send(QByteArray::fromHex("8500000002"));
            }
            if (isOurs)
                send(QByteArray::fromHex("001b3f800000001200000000"));
            if (happens(stalls))
                stalledUntil = rig.now + 250ms;
            if (rig.now < stalledUntil)
                continue;
            while (!under.empty() && under.begin()->first <= rig.now) {
                rig.arrive(under.begin()->second, rig.now);
                under.erase(under.begin());
            }
        }
    }
};

}  // namespace

class TestBcflightLink : public QObject
{
    Q_OBJECT
private slots:
    void aRoundTripIsMeasuredAndTold();
    void theTickWraps();
    void aLostAnswerLowersTheShare();
    void anAbsenceOnPurposeIsNoLoss();
    void aDatagramThatComesTwiceIsOurs();
    void aForeignTickIsNoticed();
    void answersOfLongAgoAreOurs();
    void anAnswerToWhatNobodyAskedIsNoticed();
    void whatWasAskedIsOurs();
    void answersThatComeAlongAreOurs();
    void aThinStreamIsNoticed();
    void aThinStreamByOurOwnWishIsNone();
    void aDroneThatRestartsIsNobodyElse();
    void lossOnBothWaysIsNobodyElse();
    void lateInBunchesIsNobodyElse();
    void whoeverCameFirstIsToldOfTheOther();
    void badNetworkIsNobodyElse();
    void lateAnswersOfTheSearchAreOurs();
    void aPauseIsNobodyElse_data();
    void aPauseIsNobodyElse();
    void valuesThatAreNoneAreCounted();
    void theRoundTripIsAChannel();
};

void TestBcflightLink::aRoundTripIsMeasuredAndTold()
{
    Rig rig;
    QCOMPARE(rig.quality(), ProbedLink());
    const QByteArray first = rig.beat();
    QCOMPARE(first.size(), 5);
    QCOMPARE(first.right(2), QByteArray::fromHex("0000"));  // none known yet
    rig.now += 37ms;
    rig.arrive(first, rig.now);
    QCOMPARE(rig.quality().roundTrip, std::optional<Duration>(37ms));
    rig.now += kBeat;
    QCOMPARE(rig.beat().right(2), QByteArray::fromHex("0025"));
}

// Errata 3: modulo 65536; the original shows nonsense every 65.5 s.
void TestBcflightLink::theTickWraps()
{
    Rig rig;
    rig.now = TimePoint() + milliseconds(65536 * 7 - 10);
    const QByteArray before = rig.beat();
    QCOMPARE(before.mid(1, 2), QByteArray::fromHex("fff6"));
    rig.now += 25ms;
    QCOMPARE(PingProbe::tickAt(rig.now), 15);
    rig.arrive(before, rig.now);
    QCOMPARE(rig.quality().roundTrip, std::optional<Duration>(25ms));
    rig.run(140s);  // twice round
    QCOMPARE(rig.quality().roundTrip, std::optional<Duration>(30ms));
    QCOMPARE(rig.quality().foreign, 0u);
    QVERIFY(!rig.quality().isShared);
}

void TestBcflightLink::aLostAnswerLowersTheShare()
{
    Rig rig;
    rig.run(10s);
    QCOMPARE(rig.quality().answered, std::optional(1.0));
    rig.answers = false;
    rig.run(2500ms);
    QVERIFY(rig.quality().answered.value() < 0.8);
    QVERIFY(rig.quality().answered.value() > 0.4);
    rig.answers = true;
    rig.run(6s);
    QCOMPARE(rig.quality().answered, std::optional(1.0));
}

// Whoever restarts a drone knows that it is away, and the link is none the weaker for it.
void TestBcflightLink::anAbsenceOnPurposeIsNoLoss()
{
    for (const bool isTold : {false, true}) {
        Rig rig;
        rig.run(5s);
        if (isTold)
            rig.probe.expectSilence(rig.now + 20s);
        rig.answers = false;
        rig.run(4s);
        rig.answers = true;
        rig.run(2s);
        QCOMPARE(rig.quality().answered == std::optional(1.0), isTold);
        rig.answers = false;  // one that is lost later is lost
        rig.run(kBeat);
        rig.answers = true;
        rig.run(2s);
        QVERIFY(rig.quality().answered < 1.0);
    }
}

void TestBcflightLink::aDatagramThatComesTwiceIsOurs()
{
    Rig rig;
    const QByteArray ping = rig.beat();
    rig.now += 20ms;
    rig.arrive(ping, rig.now);
    rig.now += 100ms;
    rig.arrive(ping, rig.now);
    QCOMPARE(rig.quality().roundTrip, std::optional<Duration>(20ms));
    QCOMPARE(rig.quality().foreign, 0u);
}

void TestBcflightLink::aForeignTickIsNoticed()
{
    Rig rig;
    rig.run(3s);
    rig.arrive(QByteArray::fromHex("81123400ff"), rig.now);
    QCOMPARE(rig.quality().foreign, 1u);
    QVERIFY(rig.quality().isShared);
    QCOMPARE(rig.quality().roundTrip, std::optional<Duration>(30ms));  // not by that answer
    rig.run(PingProbe::kShareMemory + 1s);
    QVERIFY(!rig.quality().isShared);
}

// Deaf for longer than PINGs are counted, it answers all of them at once.
void TestBcflightLink::answersOfLongAgoAreOurs()
{
    Rig rig;
    rig.run(3s);
    const QByteArray first = rig.beat();
    rig.isHeld = true;
    rig.run(kBeat * int(PingProbe::kRemembered) + 10s);
    rig.isHeld = false;
    rig.arrive(first, rig.now);
    rig.run(1s);
    QCOMPARE(rig.quality().foreign, 0u);
    QVERIFY(!rig.quality().isShared);
}

void TestBcflightLink::anAnswerToWhatNobodyAskedIsNoticed()
{
    Rig rig;
    rig.run(1s);
    rig.arrive(QByteArray::fromHex("0027") + QByteArray(8, '\0'), rig.now);  // HORIZON_OFFSET
    QVERIFY(rig.quality().isShared);
}

void TestBcflightLink::whatWasAskedIsOurs()
{
    Rig rig;
    rig.run(1s);
    rig.probe.sent(asBytes(encode(Message::HorizonOffset)), rig.now);
    rig.probe.sent(asBytes(encode(Message::Status)), rig.now);
    rig.now += 50ms;
    rig.arrive(QByteArray::fromHex("0027") + QByteArray(8, '\0'), rig.now);
    rig.arrive(QByteArray::fromHex("8500000002"), rig.now);
    QCOMPARE(rig.quality().foreign, 0u);
    QVERIFY(!rig.quality().isShared);
}

// TELEMETRY of the older generations is followed by STATUS, CALIBRATE by CALIBRATING (errata 1, 7.1).
void TestBcflightLink::answersThatComeAlongAreOurs()
{
    Rig rig;
    rig.run(1s);
    rig.probe.sent(asBytes(encode(Message::Telemetry, {}, Generation::D)), rig.now);
    rig.arrive(QByteArray::fromHex("82") + QByteArray(10, '\0') + QByteArray::fromHex("8000000001"), rig.now);
    rig.probe.sent(asBytes(encode(Message::Calibrate, QByteArray(8, '\0'))), rig.now);
    rig.arrive(QByteArray::fromHex("006000000003006100000001"), rig.now);
    QCOMPARE(rig.quality().foreign, 0u);
}

// The stream goes to whoever sent last: a ground that sends a hundred packets per second gets most of it.
void TestBcflightLink::aThinStreamIsNoticed()
{
    Rig rig;
    rig.run(10s);
    QVERIFY(!rig.quality().isShared);
    rig.streamShare = 0.1;
    rig.run(4s);
    QVERIFY(rig.quality().isShared);
    QCOMPARE(rig.quality().foreign, 0u);
    rig.streamShare = 1;
    rig.run(PingProbe::kShareMemory + 2s);
    QVERIFY(!rig.quality().isShared);
}

void TestBcflightLink::aThinStreamByOurOwnWishIsNone()
{
    Rig rig;
    rig.run(10s);
    rig.probe.sent(asBytes(encode(Message::SetFullTelemetry, bigU32(0))), rig.now);
    rig.streamShare = 0.2;
    rig.run(10s);
    QVERIFY(!rig.quality().isShared);
}

void TestBcflightLink::aDroneThatRestartsIsNobodyElse()
{
    Rig rig;
    rig.run(10s);
    rig.answers = false;
    rig.streamShare = 0;
    rig.run(6s);
    rig.answers = true;
    rig.streamShare = 0.2;  // another configuration
    rig.run(15s);
    QVERIFY(!rig.quality().isShared);
}

void TestBcflightLink::lossOnBothWaysIsNobodyElse()
{
    Rig rig;
    rig.run(10s);
    rig.streamShare = 0.7;
    rig.run(10s);
    QVERIFY(!rig.quality().isShared);
}

// A network that holds packets back delivers several at one time.
void TestBcflightLink::lateInBunchesIsNobodyElse()
{
    Rig rig;
    rig.roundTrip = 220ms;
    rig.run(10s);
    rig.bunch = 100ms;
    for (int i = 0; i < 600; ++i) {
        rig.run(1s);
        QVERIFY2(!rig.quality().isShared, qPrintable(QString::number(i)));
    }
    QCOMPARE(rig.quality().answered, std::optional(1.0));
    QCOMPARE(rig.quality().foreign, 0u);
    // In bunches, too, what another one gets is missing.
    rig.streamShare = 0.3;
    rig.run(6s);
    QVERIFY(rig.quality().isShared);
}

// Errata 2.1: answers and stream go to whoever sent last. Here is the window that came second: it has never
// seen the whole stream.
void TestBcflightLink::whoeverCameFirstIsToldOfTheOther()
{
    Network network;
    network.othersPeriod = 130ms;
    network.run(6s);
    QVERIFY(network.rig.quality().isShared);
    for (int i = 0; i < 60; ++i) {
        network.run(1s);
        QVERIFY2(network.rig.quality().isShared, qPrintable(QString::number(i)));  // as long as it is there
    }
    network.othersPeriod = 0ms;
    network.run(PingProbe::kShareMemory + 3s);
    QVERIFY(!network.rig.quality().isShared);
}

void TestBcflightLink::badNetworkIsNobodyElse()
{
    Network network;
    network.delay = 300ms;
    network.loss = 0.05;
    network.doubled = 0.02;
    network.stalls = 0.004;
    for (int i = 0; i < 1200; ++i) {
        network.run(1s);
        QVERIFY2(!network.rig.quality().isShared, qPrintable(QString::number(i)));
    }
    QCOMPARE(network.rig.quality().foreign, 0u);
    QVERIFY(network.rig.quality().answered > 0.8);
}

void TestBcflightLink::lateAnswersOfTheSearchAreOurs()
{
    Rig rig;
    PingProbe search;
    const QByteArray early = search.beat(rig.now);
    rig.now += 250ms;
    const QByteArray own = rig.beat();
    rig.now += 300ms;
    rig.arrive(early, rig.now);
    rig.arrive(own, rig.now);
    QCOMPARE(rig.quality().foreign, 0u);
    QVERIFY(!rig.quality().isShared);
    // Sent since the first of ours, and not by us.
    rig.arrive(search.beat(rig.now - 100ms), rig.now);
    QCOMPARE(rig.quality().foreign, 1u);
}

void TestBcflightLink::aPauseIsNobodyElse_data()
{
    QTest::addColumn<bool>("isLost");
    QTest::addColumn<int>("ms");
    for (const int ms : {700, 1000, 1500, 2200}) {
        QTest::addRow("%d ms are lost", ms) << true << ms;
        QTest::addRow("%d ms come late", ms) << false << ms;
        QTest::addRow("%d ms in which the program stood still", ms) << true << -ms;
    }
}

// Wherever it falls into the windows in which the stream is counted.
void TestBcflightLink::aPauseIsNobodyElse()
{
    QFETCH(bool, isLost);
    QFETCH(int, ms);
    for (auto offset = 0ms; offset < 1s; offset += 100ms) {
        Rig rig;
        rig.run(10s + offset);
        rig.isHeld = true;
        if (ms > 0)
            rig.run(milliseconds(ms));
        else
            rig.now += milliseconds(-ms);
        rig.isHeld = false;
        if (isLost)
            rig.held.clear();
        for (int i = 0; i < 30; ++i) {
            rig.run(100ms);
            QVERIFY2(!rig.quality().isShared, qPrintable(u"begun at %1 ms"_s.arg(offset.count())));
        }
    }
}

// Errata 8.2: THRUST before the first arming may be any bit pattern.
void TestBcflightLink::valuesThatAreNoneAreCounted()
{
    TelemetryStore store(ChannelCount);
    Decoder decoder;
    const auto decode = [&](const QByteArray &bytes) {
        bcflight::Framer framer;
        const auto sink = [&](const FrameView &frame) { decoder.decode(frame, TimePoint() + 1h, store); };
        framer.feed(asBytes(bytes), sink);
        framer.packetEnded(sink);
    };
    decode(QByteArray::fromHex("00437fc00000"));  // NaN
    decode(QByteArray::fromHex("00437149f2ca"));  // 1e30
    decode(QByteArray::fromHex("0043c0000000"));  // -2
    QCOMPARE(store.invalid(Thrust), 3u);
    QVERIFY(std::isnan(store.latest(Thrust)));
    decode(QByteArray::fromHex("00433f000000"));
    QCOMPARE(store.invalid(Thrust), 3u);
    QCOMPARE(store.latest(Thrust), 0.5F);
    decode(QByteArray::fromHex("8500000002"));  // its attitude unit runs
    decode(QByteArray::fromHex("0016")
           + QByteArray::fromHex("3f8000007f800000ffc00000"));  // 1, infinite, NaN
    QCOMPARE(store.latest(AttitudeRoll), 1.0F);
    QCOMPARE(store.invalid(AttitudeRoll), 0u);
    QCOMPARE(store.invalid(AttitudeRoll + 1), 1u);
    QCOMPARE(store.invalid(AttitudeRoll + 2), 1u);
    decode(QByteArray::fromHex("001a00000002") + QByteArray::fromHex("3f0000007fc00000"));  // motors
    QCOMPARE(store.invalid(Motor1), 0u);
    QCOMPARE(store.invalid(Motor1 + 1), 1u);
}

void TestBcflightLink::theRoundTripIsAChannel()
{
    TelemetryStore store(ChannelCount);
    Decoder decoder;
    bcflight::Framer framer;
    const auto sink = [&](const FrameView &frame) { decoder.decode(frame, TimePoint() + 1h, store); };
    framer.feed(asBytes(QByteArray::fromHex("8112340025")), sink);
    framer.packetEnded(sink);
    QCOMPARE(store.latest(RoundTrip), 37.0F);
    QCOMPARE(QByteArray(channels()[RoundTrip].key), QByteArray("link.round_trip"));
}

QTEST_GUILESS_MAIN(TestBcflightLink)
#include "tst_bcflightlink.moc"
