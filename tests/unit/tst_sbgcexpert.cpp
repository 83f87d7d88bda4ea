// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What experts and other sensors do to a SimpleBGC board.
#include "protocol/session/controlstream.h"
#include "protocol/simplebgc/messages.h"
#include "tests/support/channelproxy.h"
#include "tests/support/sbgcrig.h"

#include <QFile>

#include <cmath>

using namespace simplebgc;
using namespace Qt::StringLiterals;

namespace {

QString written(const SbgcRig &rig, const QByteArray &text)
{
    QFile file(rig.path(u"feed.csv"_s));
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
        qFatal("no file");
    return file.fileName();
}

}  // namespace

class TestSbgcExpert : public QObject
{
    Q_OBJECT
private slots:
    void busIsSearched();
    void registersAreReadAndWritten();
    void memoryIsNotWrittenByTheBus();
    void bootLoaderIsSeenByItsSilence_data();
    void bootLoaderIsSeenByItsSilence();
    void boardThatGoesOnIsNoBootLoader();
    void attitudeIsRead();
    void slotsTellTheirSignals_data();
    void slotsTellTheirSignals();
    void channelsAreSteeredLikeSticks();
    void cancelledSignalIsTakenBack();
    void gyroscopeIsCorrected();
    void frameIsTold();
    void attitudeIsReplaced();
    void lateRowsAreLeftOut();
    void refusalEndsTheFeed();
    void filesAreCheckedFirst_data();
    void filesAreCheckedFirst();
};

void TestSbgcExpert::busIsSearched()
{
    SbgcRig rig;
    QCOMPARE(rig.perform("i2c.scan")->value(u"devices"_s).toString(), u"0x68"_s);
    QCOMPARE(rig.perform("i2c.scan", {{u"bus"_s, u"internal"_s}})->value(u"devices"_s).toString(), u"0x50"_s);
    rig.board().setFaults({.noImu = true});
    QCOMPARE(rig.perform("i2c.scan")->value(u"devices"_s).toString(), u"none"_s);
    // Firmware that answers no refusal is silent where nobody is.
    SbgcRig old(2590);
    QCOMPARE(old.perform("i2c.scan")->value(u"devices"_s).toString(), u"0x68"_s);
}

void TestSbgcExpert::registersAreReadAndWritten()
{
    SbgcRig rig;
    SbgcRig::Texts place{{u"device"_s, u"104"_s}, {u"register"_s, u"117"_s}};
    QCOMPARE(rig.perform("i2c.read", place)->value(u"data"_s).toString(), u"68"_s);
    SAYS(rig.perform("i2c.read", {{u"device"_s, u"32"_s}, {u"register"_s, u"0"_s}}), u"operation failed"_s);
    place[u"data"_s] = u"0102"_s;
    auto done = rig.perform("i2c.write", place);
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QCOMPARE(done->value(u"before"_s).toString(), u"68 00"_s);
    QCOMPARE(done->value(u"now"_s).toString(), u"68 02"_s);  // the first cannot be written
    place[u"data"_s] = u"xyz"_s;
    SAYS(rig.perform("i2c.write", place), u"hex"_s);
    place[u"data"_s] = QString(u"00"_s).repeated(65);
    SAYS(rig.perform("i2c.write", place), u"64"_s);
}

// The calibrations and the licence are there.
void TestSbgcExpert::memoryIsNotWrittenByTheBus()
{
    SbgcRig rig;
    const SbgcRig::Texts place{
        {u"bus"_s, u"internal"_s}, {u"device"_s, u"80"_s}, {u"register"_s, u"3"_s}, {u"data"_s, u"00"_s}};
    const int before = rig.board().stored(u"pid.roll.p"_s, 0);
    SAYS(rig.perform("i2c.write", place), u"memory.restore"_s);
    QCOMPARE(rig.board().stored(u"pid.roll.p"_s, 0), before);
}

void TestSbgcExpert::bootLoaderIsSeenByItsSilence_data()
{
    QTest::addColumn<bool>("isUart");
    QTest::newRow("serial line") << true;
    QTest::newRow("USB, which is gone with it") << false;
}

void TestSbgcExpert::bootLoaderIsSeenByItsSilence()
{
    QFETCH(bool, isUart);
    SbgcRig rig(2704, isUart ? std::optional(LineSettings{115200, Parity::None}) : std::nullopt);
    QVERIFY(rig.board().stabilizer().motorsOn());
    const auto done = rig.perform("bootloader");
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QVERIFY(!rig.board().stabilizer().motorsOn());
    std::ignore = rig.channel.sleep(10s);
    QVERIFY(!rig.board().isRunning());  // it does not come back by itself
    if (!isUart)
        return;
    rig.board().setFaults({.resetAfter = rig.board().now()});
    std::ignore = rig.channel.sleep(5s);
    QVERIFY(rig.identify());
}

void TestSbgcExpert::boardThatGoesOnIsNoBootLoader()
{
    SbgcRig rig;
    Altering channel(rig.channel, [&](const Request &request, const Altering::Pass &pass) -> Result<Frame> {
        return request.name == u"BOOT_MODE_3"_s ? Result<Frame>(Frame{}) : pass(request);
    });
    const auto done = rig.device.perform(channel, u"bootloader"_s, {});
    QVERIFY(!done);
    QCOMPARE(done.error().code, ErrorCode::NoEffect);
}

void TestSbgcExpert::attitudeIsRead()
{
    for (const int firmware : {2590, 2704}) {
        SbgcRig rig(firmware);
        const auto told = rig.perform("attitude");
        QVERIFY2(told, told ? "" : qPrintable(told.error().detail));
        QVERIFY(told->value(u"z.z"_s).toDouble() > 0.99);
        QVERIFY(std::abs(told->value(u"z.x"_s).toDouble()) < 0.1);
        QVERIFY(std::hypot(told->value(u"h.x"_s).toDouble(), told->value(u"h.y"_s).toDouble()) > 0.99);
    }
}

void TestSbgcExpert::slotsTellTheirSignals_data()
{
    QTest::addColumn<int>("firmware");
    QTest::newRow("by slot") << 2590;
    QTest::newRow("by source") << 2704;
}

void TestSbgcExpert::slotsTellTheirSignals()
{
    QFETCH(int, firmware);
    SbgcRig rig(firmware);
    SAYS(rig.perform("slots.read"), u"no slot"_s);
    rig.board().store(u"slot.trigger2.source"_s, 0, 130);
    rig.board().store(u"slot.trigger2.action5"_s, 0, 17);
    rig.board().store(u"slot.analog11.source"_s, 0, 130);
    rig.board().store(u"slot.analog11.variable"_s, 0, 0);
    rig.board().store(u"slot.analog11.min"_s, 0, 0);
    rig.board().store(u"slot.analog11.max"_s, 0, 153);
    auto told = rig.perform("slots.read");
    QVERIFY2(told, told ? "" : qPrintable(told.error().detail));
    QCOMPARE(told->value(u"no_signal"_s).toString(), u"trigger2, analog11"_s);
    QCOMPARE(told->value(u"trigger2.action"_s).toString(), u"No action"_s);
    QVERIFY(rig.channel.transact(silentRequest(CommandId::ApiVirtChControl, hex("F0D8F401"), 1)));
    std::ignore = rig.channel.sleep(50ms);
    told = rig.perform("slots.read");
    QVERIFY(told);
    QCOMPARE(told->value(u"trigger2.signal"_s).toDouble(), 100.0);
    QCOMPARE(told->value(u"trigger2.action"_s).toString(), u"Look down"_s);
    QCOMPARE(told->value(u"analog11.signal"_s).toDouble(), 100.0);
    QCOMPARE(told->value(u"analog11.value"_s).toDouble(), 153.0);
    QCOMPARE(told->size(), 4);
}

// With the dead-man of every other way to steer.
void TestSbgcExpert::channelsAreSteeredLikeSticks()
{
    SbgcRig rig;
    rig.board().store(u"rc.map.pitch"_s, 0, 130);  // the second channel
    const Steering &steering = *rig.device.steering();
    const SteeringMode *mode = steering.mode(256);
    QVERIFY(mode && mode->inputs.size() == 8);
    QCOMPARE(mode->inputs[1].axis, Axis::Pitch);
    const auto told = [&] {
        const auto signal = rig.perform("signals");
        return signal ? signal->value(u"rc.map.pitch"_s) : QVariant(signal.error().detail);
    };
    QVERIFY(!told().isValid());
    for (int i = 0; i < 20; ++i) {
        rig.channel.steer(steering.controlFrames({mode->id, {0, 60, 0, 0, 0, 0, 0, 0}, {}}));
        std::ignore = rig.channel.sleep(20ms);
    }
    QVERIFY2(std::abs(told().toDouble() - 60) < 0.1, qPrintable(told().toString()));
    std::ignore = rig.channel.sleep(ControlStream::kDeadMan + 200ms);  // what steers it hangs
    QVERIFY(!told().isValid());
    QCOMPARE(steering.controlFrames({mode->id, {std::nan(""), 900}, {}}).setpoint.mid(4, 6).toHex(),
             QByteArray("f0d8f401f0d8"));
}

// The camera would turn on and on.
void TestSbgcExpert::cancelledSignalIsTakenBack()
{
    SbgcRig rig;
    rig.board().store(u"rc.map.pitch"_s, 0, 130);
    rig.channel.cancelAfter(500ms);
    const auto cancelled
        = rig.perform("channel", {{u"channel"_s, u"2"_s}, {u"value"_s, u"80"_s}, {u"seconds"_s, u"60"_s}});
    QVERIFY(!cancelled);
    QCOMPARE(cancelled.error().code, ErrorCode::Cancelled);
    rig.channel.cancelAfter(100s);
    std::ignore = rig.channel.sleep(500ms);
    const auto told = rig.perform("signals");
    QVERIFY(told);
    QVERIFY(!told->contains(u"rc.map.pitch"_s));
}

void TestSbgcExpert::gyroscopeIsCorrected()
{
    SbgcRig rig;
    const auto correction = [&] { return rig.board().stabilizer().imu().gyroCorrection[2]; };
    const double before = correction();
    const QString path
        = written(rig, "time,imu,zero.x,zero.y,zero.z,heading\n0,0,0,0,8,0\n0.5,main,0,0,4,2\n");
    const TimePoint begin = rig.channel.now();
    const auto done = rig.perform("feed", {{u"what"_s, u"gyro"_s}, {u"file"_s, path}});
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QCOMPARE(done->value(u"rows"_s).toInt(), 2);
    QVERIFY(rig.channel.now() - begin >= 500ms);
    std::ignore = rig.channel.sleep(50ms);
    // 6 units of the sensor's 0.061 degrees per second; the second row replaces the first.
    QVERIFY2(std::abs(correction() - before - 6 * 0.06103701895) < 1e-6,
             qPrintable(QString::number(correction())));
}

void TestSbgcExpert::frameIsTold()
{
    SbgcRig rig;
    const QString path = written(
        rig, "# from a flight controller\ntime, acc.x, acc.y, acc.z, roll, pitch\n0, 0, 0, 1, 12, -7\n");
    const auto done = rig.perform("feed", {{u"what"_s, u"helper"_s}, {u"file"_s, path}});
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    const auto frameRoll = [&] {
        const auto status = rig.channel.transact(rig.device.statusRequest());
        const QByteArray payload = status ? status->payload : QByteArray();
        ByteReader reader(payload);
        reader.skip(38);
        return reader.i16() * 360.0 / 16384;
    };
    std::ignore = rig.channel.sleep(20ms);
    QVERIFY2(std::abs(frameRoll() - 12) < 0.05, qPrintable(QString::number(frameRoll())));
    std::ignore = rig.channel.sleep(1s);  // nobody tells it any more
    QVERIFY2(std::abs(frameRoll()) < 5, qPrintable(QString::number(frameRoll())));
    // Old firmware knows the short form alone.
    SbgcRig old(2550);
    const QString extended = written(
        old,
        "time,acc.x,acc.y,acc.z,roll,pitch,system,speed.x,speed.y,speed.z,heading\n0,0,0,1,0,0,1,0,0,0,0\n");
    SAYS(old.perform("feed", {{u"what"_s, u"helper"_s}, {u"file"_s, extended}}), u"1 = system"_s);
}

void TestSbgcExpert::attitudeIsReplaced()
{
    for (const int firmware : {2590, 2704}) {
        SbgcRig rig(firmware);
        rig.board().stabilizer().setMotorsOn(false);
        // 5 degrees of roll, north straight ahead.
        const QString path
            = written(rig, "time,mode,z.x,z.y,z.z,h.x,h.y,h.z\n0,1,0.0871557,0,0.9962,0,1,0\n");
        const auto done = rig.perform("feed", {{u"what"_s, u"attitude"_s}, {u"file"_s, path}});
        QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
        std::ignore = rig.channel.sleep(5ms);
        const double roll = rig.board().stabilizer().estimate(Axis::Roll);
        QVERIFY2(std::abs(roll - 5) < 0.5, qPrintable(QString::number(roll)));
        const QString asks = written(rig, "time,mode,z.x,z.y,z.z,h.x,h.y,h.z\n0,0,0,0,1,0,1,0\n");
        SAYS(rig.perform("feed", {{u"what"_s, u"attitude"_s}, {u"file"_s, asks}}), u"sets none"_s);
    }
}

void TestSbgcExpert::lateRowsAreLeftOut()
{
    SbgcRig rig;
    QByteArray text = "time,acc.x,acc.y,acc.z,roll,pitch\n";
    for (int i = 0; i < 100; ++i)
        text += QByteArray::number(0.01 * i) + ",0,0,1,0,0\n";
    int sent = 0;
    Altering channel(rig.channel, [&](const Request &request, const Altering::Pass &pass) {
        if (++sent == 10)
            std::ignore = rig.channel.sleep(600ms);  // the computer was busy
        return pass(request);
    });
    const auto done = rig.device.perform(
        channel, u"feed"_s,
        argumentsFor(rig.device, "feed", {{u"what"_s, u"helper"_s}, {u"file"_s, written(rig, text)}}));
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QCOMPARE(done->value(u"rows"_s).toInt(), sent);
    QCOMPARE(done->value(u"late"_s).toInt(), 100 - sent);
    QVERIFY2(sent > 50 && sent < 70, qPrintable(QString::number(sent)));
}

void TestSbgcExpert::refusalEndsTheFeed()
{
    SbgcRig rig;
    int sent = 0;
    Altering channel(rig.channel, [&](Request request, const Altering::Pass &pass) {
        if (++sent == 2)
            request.bytes = encodeFrame(number(CommandId::HelperData), "short");
        return pass(request);
    });
    QByteArray text = "time,acc.x,acc.y,acc.z,roll,pitch\n";
    for (int i = 0; i < 50; ++i)
        text += QByteArray::number(0.02 * i) + ",0,0,1,0,0\n";
    const auto done = rig.device.perform(
        channel, u"feed"_s,
        argumentsFor(rig.device, "feed", {{u"what"_s, u"helper"_s}, {u"file"_s, written(rig, text)}}));
    SAYS(done, u"wrong payload size"_s);
    QVERIFY(sent < 6);
}

void TestSbgcExpert::filesAreCheckedFirst_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("says");
    QTest::newRow("empty") << QByteArray() << u""_s;
    QTest::newRow("names alone") << QByteArray("time,roll\n") << u""_s;
    QTest::newRow("no time") << QByteArray("roll,pitch\n1,2\n") << u"time"_s;
    QTest::newRow("unknown") << QByteArray("time,acc.x,acc.y,acc.z,roll,pitch,rolll\n0,0,0,1,2,3,4\n")
                             << u"rolll"_s;
    QTest::newRow("too few") << QByteArray("time,acc.x,acc.y,acc.z,roll,pitch\n0,0,0,1,2\n") << u"columns"_s;
    QTest::newRow("no number") << QByteArray("time,acc.x,acc.y,acc.z,roll,pitch\n0,0,0,1,2,3\n1,0,0,1,a,3\n")
                               << u"line 3"_s;
    QTest::newRow("out of range") << QByteArray("time,acc.x,acc.y,acc.z,roll,pitch\n0,99,0,1,2,3\n")
                                  << u"acc.x"_s;
    QTest::newRow("not a number") << QByteArray("time,acc.x,acc.y,acc.z,roll,pitch\n0,nan,0,1,2,3\n")
                                  << u"acc.x"_s;
    QTest::newRow("backwards") << QByteArray("time,acc.x,acc.y,acc.z,roll,pitch\n1,0,0,1,2,3\n0,0,0,1,2,3\n")
                               << u"time"_s;
    QTest::newRow("time is none") << QByteArray("time,acc.x,acc.y,acc.z,roll,pitch\ninf,0,0,1,2,3\n")
                                  << u"time"_s;
    QTest::newRow("bytes") << QByteArray("\x00\xff\xfe\n\x01", 5) << u"time"_s;
}

void TestSbgcExpert::filesAreCheckedFirst()
{
    QFETCH(QByteArray, text);
    QFETCH(QString, says);
    SbgcRig rig;
    int sent = 0;
    Altering channel(rig.channel, [&](const Request &request, const Altering::Pass &pass) {
        ++sent;
        return pass(request);
    });
    const auto done = rig.device.perform(
        channel, u"feed"_s,
        argumentsFor(rig.device, "feed", {{u"what"_s, u"helper"_s}, {u"file"_s, written(rig, text)}}));
    SAYS(done, says);
    QCOMPARE(sent, 0);
}

QTEST_GUILESS_MAIN(TestSbgcExpert)
#include "tst_sbgcexpert.moc"
