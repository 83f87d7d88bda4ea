// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/blackbox/device.h"
#include "protocol/record/recording.h"
#include "protocol/record/replaystore.h"
#include "protocol/telemetry/blackbox.h"
#include "protocol/telemetry/blackboxwire.h"
#include "protocol/telemetry/telemetrystore.h"
#include "protocol/telemetry/uniformsamples.h"
#include "tests/support/blackboxsample.h"

#include <QRandomGenerator>
#include <QTest>

using namespace Qt::StringLiterals;

/// The black box of a drone: read, and decoded like a recording.
class TestBlackBox final : public QObject
{
    Q_OBJECT
private slots:
    void linesAreRead();
    void headingIsNoDamage();
    void valuesBecomeNumbers_data();
    void valuesBecomeNumbers();
    void whatCannotBeReadIsLeftOut_data();
    void whatCannotBeReadIsLeftOut();
    void farTimesAreDamage();
    void threadsOfTheDroneAreSorted();
    void itIsKnownByItsBeginning();
    void itIsDecodedLikeARecording();
    void everyBreakIsSurvived();
};

void TestBlackBox::linesAreRead()
{
    const auto box
        = BlackBox::read("1000,IMU:rate,\"1.5,-2,3e1\"\r\n2000,log,a, \"b\", c\n3000,IMU:rate,\"1,2,3\"\n");
    QVERIFY(box);
    QCOMPARE(box->names(), (QList<QByteArray>{"IMU:rate", "log"}));
    QCOMPARE(box->lines().size(), 3U);
    QVERIFY(box->damage().empty());
    QCOMPARE(box->lines()[0].at, 1000);
    QCOMPARE(box->value(box->lines()[0]).toByteArray(), QByteArray("1.5,-2,3e1"));
    QCOMPARE(box->value(box->lines()[1]).toByteArray(), QByteArray("a, \"b\", c"));
    QCOMPARE(box->elements(0), 3);
    QCOMPARE(box->elements(1), 0);
}

// Words over the columns are no damage; anywhere else, or others, they are.
void TestBlackBox::headingIsNoDamage()
{
    const auto damageOf = [](const QByteArray &bytes) {
        const auto box = BlackBox::read(bytes);
        return box ? int(box->damage().size()) : -1;
    };
    QCOMPARE(damageOf("time,name,value\n1000,a,1\n2000,a,2\n"), 0);
    QCOMPARE(damageOf("\"time\",\"name\",\"value\"\r\n1000,a,1\n2000,a,2\n"), 0);
    QCOMPARE(damageOf("1000,a,1\ntime,name,value\n2000,a,2\n"), 1);
    QCOMPARE(damageOf("tim\x01,name,value\n1000,a,1\n"), 1);
    QCOMPARE(damageOf("x00,name,1\n1000,a,1\n"), 1);
    QCOMPARE(damageOf("time,name\n1000,a,1\n"), 1);
}

void TestBlackBox::valuesBecomeNumbers_data()
{
    QTest::addColumn<QByteArray>("value");
    QTest::addColumn<QList<float>>("numbers");
    QTest::newRow("one") << QByteArray("0.25") << QList<float>{0.25F};
    QTest::newRow("list") << QByteArray("1,-2.5,3e2") << QList<float>{1, -2.5F, 300};
    QTest::newRow("comma at the end") << QByteArray("1,2,") << QList<float>{1, 2};
    QTest::newRow("true") << QByteArray("true") << QList<float>{1};
    QTest::newRow("false") << QByteArray("false") << QList<float>{0};
    QTest::newRow("text") << QByteArray("Running") << QList<float>();
    QTest::newRow("text in a list") << QByteArray("1,b,3") << QList<float>();
    QTest::newRow("nothing") << QByteArray() << QList<float>();
    QTest::newRow("nothing between") << QByteArray("1,,3") << QList<float>();
    QTest::newRow("too many") << QByteArray("1,").repeated(BlackBox::kMostNumbers + 1) << QList<float>();
}

void TestBlackBox::valuesBecomeNumbers()
{
    QFETCH(QByteArray, value);
    QFETCH(QList<float>, numbers);
    const auto read = BlackBox::numbers(value);
    QCOMPARE(QList<float>(read.begin(), read.end()), numbers);
    // What is no number was not measured: a gap, not a point.
    const auto broken = BlackBox::numbers("nan,1,inf");
    QVERIFY(broken.size() == 3 && std::isnan(broken[0]) && broken[1] == 1 && std::isnan(broken[2]));
}

void TestBlackBox::whatCannotBeReadIsLeftOut_data()
{
    QTest::addColumn<QByteArray>("damage");
    QTest::addColumn<bool>("isEnd");
    QTest::newRow("words") << QByteArray("no line of it\n") << false;
    QTest::newRow("two in a row") << QByteArray("no line\nnor this one\n") << false;
    QTest::newRow("no time") << QByteArray(",name,1\n") << false;
    QTest::newRow("a time with a sign") << QByteArray("-5,name,1\n") << false;
    QTest::newRow("a time of letters") << QByteArray("12x4,name,1\n") << false;
    QTest::newRow("an endless time") << QByteArray("1234567890123456,name,1\n") << false;
    QTest::newRow("no name") << QByteArray("1500,,1\n") << false;
    QTest::newRow("a name with a space") << QByteArray("1500,a b,1\n") << false;
    QTest::newRow("a name that is none") << QByteArray("1500,#a,1\n") << false;
    QTest::newRow("a long name") << "1500," + QByteArray(65, 'n') + ",1\n" << false;
    QTest::newRow("no value") << QByteArray("1500,name\n") << false;
    QTest::newRow("zeros") << QByteArray("1500,name,\0\0\0\n", 14) << false;
    QTest::newRow("a long line") << "1500,name," + QByteArray(5000, '1') + '\n' << false;
    QTest::newRow("cut off") << QByteArray("1500,name,1.2") << true;
}

void TestBlackBox::whatCannotBeReadIsLeftOut()
{
    QFETCH(QByteArray, damage);
    QFETCH(bool, isEnd);
    const QByteArray before = "1000,a,1\n";
    const auto box = BlackBox::read(before + damage + (isEnd ? "" : "2000,a,2\n"));
    QVERIFY(box);
    QCOMPARE(box->lines().size(), isEnd ? 1U : 2U);
    QCOMPARE(box->damage().size(), 1U);
    QCOMPARE(box->damage()[0].offset, qint64(before.size()));
    QCOMPARE(box->damage()[0].bytes, qint64(damage.size()));
    QCOMPARE(box->damage()[0].line, 1U);
    QCOMPARE(box->damage()[0].isEnd, isEnd);
    // A recording tells where it lies, and decoding leaves a gap there.
    const Recording recording = recordingOf(*box);
    QCOMPARE(recording.leftOut().size(), 1);
    QCOMPARE(recording.leftOut().first().from, 0.0);
    QVERIFY(isEnd ? std::isnan(recording.leftOut().first().to) : recording.leftOut().first().to == 0.001);
}

void TestBlackBox::farTimesAreDamage()
{
    QByteArray text = "1000,a,1\n999999999999999,a,2\n3000,a,3\n";
    const auto box = BlackBox::read(text);
    QVERIFY(box);
    QCOMPARE(box->lines().size(), 2U);
    // Where it stays there, it is so: the drone waited.
    for (int i = 0; i < 20; ++i)
        text += "90000000" + QByteArray::number(100 + i) + ",a,4\n";
    QVERIFY(BlackBox::read(text)->lines().size() > 12);
}

void TestBlackBox::threadsOfTheDroneAreSorted()
{
    const auto box = BlackBox::read("1000,a,1\n3000,b,2\n2000,a,3\n2000,b,4\n");
    QVERIFY(box);
    QByteArray order;
    for (const BlackBox::Line &line : box->lines())
        order += box->value(line).toByteArray();
    QCOMPARE(order, QByteArray("1342"));
}

void TestBlackBox::itIsKnownByItsBeginning()
{
    QVERIFY(BlackBox::isBegunBy("81000,IMU:rate,\"1,2,3\"\n"));
    QVERIFY(BlackBox::isBegunBy("x\n81000,IMU:rate,1\n"));  // its head may be damaged
    for (const char *other : {"", "81000", "81000,IMU:rate,1", "time_s,gyro.x\n0.001,2\n", "1;2\n3;4\n",
                              "{\n\"gimbaldesk-configuration\": 1,\n\"a\": 2,\n}\n", "GIMBALREC 1\n"})
        QVERIFY2(!BlackBox::isBegunBy(other), other);
    QVERIFY(!BlackBox::read(""));
    QVERIFY(!BlackBox::read("nothing of the kind\n"));
    QVERIFY(!Recording::fromBytes("nothing of the kind\n"));
}

// At the time when it was written, with a channel for each number.
void TestBlackBox::itIsDecodedLikeARecording()
{
    const auto recording = Recording::fromBytes(blackBoxSample());
    QVERIFY(recording);
    QVERIFY(recording->leftOut().isEmpty());
    const Family family = blackbox::family();
    blackbox::Device device;
    const auto store = readTelemetry(*recording, family, device);
    QVERIFY(store);
    const ChannelTable table = device.channels();
    const int gyro = findChannel(table, u"IMU:gyroscope.x"_s);
    QVERIFY(gyro >= 0);
    QCOMPARE(QByteArray(table[std::size_t(gyro)].unit), QByteArray("°/s"));
    QCOMPARE(rolesOf(device).gyro[0], gyro);  // no filtered rate was written
    QVERIFY(findChannel(table, u"Multicopter:motors.4"_s) >= 0);
    QVERIFY(findChannel(table, u"Multicopter:motors.5"_s) < 0);
    QVERIFY(findChannel(table, u"Stabilizer:thrust"_s) >= 0);  // by its name
    QVERIFY(findChannel(table, u"log"_s) < 0 && findChannel(table, u"IMU:state"_s) < 0);  // texts
    const int connected = findChannel(table, u"Controller:connected"_s);
    QCOMPARE((*store)->latest(connected), 0.0F);
    const auto samples = uniformSamples(**store, gyro, -1, -1e9, 1e9);
    QVERIFY(samples);
    QVERIFY(std::abs(samples->rate - 500) < 0.5);
    QVERIFY(samples->values.size() >= 1499U && samples->values.size() <= 1500U);
    QVERIFY(std::abs((*store)->tracks(gyro).front().time(1) - (*store)->tracks(gyro).front().time(0) - 0.002)
            < 1e-9);
    QVERIFY(!device.identity().writable && device.actions().empty());
}

// Cut anywhere, and with any byte changed: what is left is read, and what is not is told.
void TestBlackBox::everyBreakIsSurvived()
{
    const QByteArray whole = blackBoxSample().first(20000);
    QRandomGenerator random(3);
    for (int round = 0; round < 500; ++round) {
        QByteArray broken = round % 2 ? whole.first(random.bounded(int(whole.size()))) : whole;
        for (int flips = random.bounded(6); flips > 0 && !broken.isEmpty(); --flips)
            broken[random.bounded(int(broken.size()))] = char(random.bounded(256));
        const auto box = BlackBox::read(broken);
        if (!box)
            continue;
        const Recording recording = recordingOf(*box);
        const Family family = blackbox::family();
        blackbox::Device device;
        const auto store = readTelemetry(recording, family, device);
        QVERIFY(store);
        QCOMPARE((*store)->channelCount(), int(device.channels().size()));
    }
}

QTEST_GUILESS_MAIN(TestBlackBox)
#include "tst_blackbox.moc"
