// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Actions on the rest of a SimpleBGC board, and what they do to a simulated one.
#include "protocol/configuration/memoryimage.h"
#include "protocol/simplebgc/memoryplaces.h"
#include "protocol/simplebgc/messages.h"
#include "protocol/simplebgc/parametertables.h"
#include "tests/support/channelproxy.h"
#include "tests/support/sbgcrig.h"

#include <QFile>
#include <QTest>

#include <cmath>

using namespace simplebgc;
using namespace Qt::StringLiterals;

namespace {

/// A line that is cut after so many commands of one kind.
class CutLine final : public ChannelProxy
{
public:
    using ChannelProxy::ChannelProxy;
    Result<Frame> transact(const Request &request) override
    {
        if (request.name == cut && left-- <= 0)
            return failure(ErrorCode::LinkClosed, request.name);
        return ChannelProxy::transact(request);
    }
    QString cut = u"EEPROM_WRITE"_s;
    int left = 99999;
};

QByteArray fileBytes(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

class TestSbgcActions : public QObject
{
    Q_OBJECT
private slots:
    void polesAndDirectionAreFound();
    void calibrationThatIsRefusedIsTold();
    void magneticLinkIsMeasured();
    void sensorThatIsNotThereIsNotSelected();
    void pinsAreSetWhereTheyAreOutputs();
    void signalSteersTheCamera();
    void signalSetsAVariable();
    void signalRunsAMenuCommand();
    void signalsAreRead();
    void slotsAreStateOfTheBoard_data();
    void slotsAreStateOfTheBoard();
    void statisticsAreRead();
    void profileSetsKeepProfiles();
    void externalDataComeBack();
    void memoryComesBackBitForBit();
    void brokenRestoreGoesOn();
    void otherMemoryIsRefused();
    void memoryIsComparedInWords();
    void placesAreOnlyThoseFound();
    void differencesAreRanges();
    void imagesAreChecked_data();
    void imagesAreChecked();
    void filesComeBack();
    void variablesTellAboutThemselves();
    void calibrationsThatRestartAreKnown();
};

void TestSbgcActions::polesAndDirectionAreFound()
{
    SbgcRig rig;
    rig.board().store(u"motor.roll.poles"_s, 0, 22);
    rig.board().store(u"motor.yaw.invert"_s, 0, 1);
    const auto done = rig.perform("calibrate.poles");
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QCOMPARE(done->value(u"motor.roll.poles"_s).toInt(), 14);
    QCOMPARE(done->value(u"motor.roll.poles.before"_s).toInt(), 22);
    QCOMPARE(done->value(u"motor.yaw.invert"_s).toInt(), 0);
    QVERIFY(!done->contains(u"motor.pitch.poles.before"_s));
    QVERIFY(done->value(u"confirmed"_s).toBool());
    QCOMPARE(rig.board().stored(u"motor.roll.poles"_s, 3), 14);
    // It stands as before, with motors that hold it.
    std::ignore = rig.channel.sleep(3s);
    QVERIFY(std::abs(rig.board().stabilizer().estimate(Axis::Roll)) < 3);
    QVERIFY(rig.board().stabilizer().motorsOn());
}

void TestSbgcActions::calibrationThatIsRefusedIsTold()
{
    SbgcRig rig;
    rig.board().setFaults({.noImu = true});
    SAYS(rig.perform("calibrate.poles"), u"sensor"_s);
    rig.board().setFaults({.deaf = number(CommandId::CalibPoles)});
    const auto silent = rig.perform("calibrate.poles");
    QVERIFY(!silent);
    QCOMPARE(silent.error().code, ErrorCode::Timeout);
}

void TestSbgcActions::magneticLinkIsMeasured()
{
    SbgcRig rig;
    const auto done = rig.perform("calibrate.magnetic_link");
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    for (const Axis axis : kAxes) {
        const QString key = u"motor.%1.magnetic_link"_s.arg(QLatin1String(axisKey(axis)));
        QVERIFY(done->value(key).toDouble() > 10);
        QVERIFY(rig.board().stored(key, 0) > 1000);
    }
    QCOMPARE(SbgcRig(2439).perform("calibrate.magnetic_link").error().code, ErrorCode::Unsupported);
}

void TestSbgcActions::sensorThatIsNotThereIsNotSelected()
{
    SbgcRig rig;
    const auto frame = rig.perform("imu.select", {{u"imu"_s, u"frame"_s}});
    QVERIFY(!frame);
    QCOMPARE(frame.error().code, ErrorCode::NoEffect);
    QVERIFY(rig.perform("imu.select", {{u"imu"_s, u"main"_s}}));
}

void TestSbgcActions::pinsAreSetWhereTheyAreOutputs()
{
    SbgcRig rig;
    QVERIFY(rig.perform("pin", {{u"pin"_s, u"AUX1"_s}, {u"state"_s, u"high"_s}}));
    rig.board().store(u"rc.map.roll"_s, 0, 1);
    const auto input = rig.perform("pin", {{u"pin"_s, u"RC_ROLL"_s}, {u"state"_s, u"low"_s}});
    QVERIFY(!input);
    QCOMPARE(input.error().code, ErrorCode::Timeout);
    QVERIFY(rig.perform("servo", {{u"servo1"_s, u"1500"_s}}));
}

void TestSbgcActions::signalSteersTheCamera()
{
    SbgcRig rig;
    rig.board().store(u"rc.map.pitch"_s, 0, 129 + 4);
    rig.board().store(u"rc.pitch.mode"_s, 0, 1);
    rig.board().store(u"rc.pitch.speed"_s, 0, 20);
    const double before = rig.board().stabilizer().target(Axis::Pitch);
    QVERIFY(rig.perform("channel", {{u"channel"_s, u"5"_s}, {u"value"_s, u"100"_s}, {u"seconds"_s, u"1"_s}}));
    const double turned = rig.board().stabilizer().target(Axis::Pitch) - before;
    QVERIFY2(turned > 15 && turned < 25, qPrintable(QString::number(turned)));
    // Nobody gives it any more: it stands still.
    std::ignore = rig.channel.sleep(1s);
    QVERIFY(std::abs(rig.board().stabilizer().target(Axis::Pitch) - before - turned) < 0.5);
}

void TestSbgcActions::signalSetsAVariable()
{
    SbgcRig rig;
    rig.board().store(u"slot.analog1.source"_s, 0, 131);
    rig.board().store(u"slot.analog1.variable"_s, 0, 0);  // P of roll
    rig.board().store(u"slot.analog1.min"_s, 0, 51);
    rig.board().store(u"slot.analog1.max"_s, 0, 153);
    QVERIFY(
        rig.perform("channel", {{u"channel"_s, u"3"_s}, {u"value"_s, u"-100"_s}, {u"seconds"_s, u"0.2"_s}}));
    QCOMPARE(rig.board().inUse(u"pid.roll.p"_s), 51);
    QVERIFY(rig.perform("channel", {{u"channel"_s, u"3"_s}, {u"value"_s, u"0"_s}, {u"seconds"_s, u"0.2"_s}}));
    QCOMPARE(rig.board().inUse(u"pid.roll.p"_s), 102);
    QVERIFY(rig.board().stored(u"pid.roll.p"_s, 0) != 102);
}

void TestSbgcActions::signalRunsAMenuCommand()
{
    SbgcRig rig;
    rig.board().store(u"slot.trigger2.source"_s, 0, 130);
    rig.board().store(u"slot.trigger2.action5"_s, 0, 12);  // motors off
    rig.board().store(u"slot.trigger2.action1"_s, 0, 2);  // profile 2
    QVERIFY(rig.perform("channel", {{u"channel"_s, u"2"_s}, {u"value"_s, u"0"_s}, {u"seconds"_s, u"0.2"_s}}));
    QVERIFY(rig.board().stabilizer().motorsOn());
    QVERIFY(
        rig.perform("channel", {{u"channel"_s, u"2"_s}, {u"value"_s, u"90"_s}, {u"seconds"_s, u"0.2"_s}}));
    QVERIFY(!rig.board().stabilizer().motorsOn());
    QVERIFY(
        rig.perform("channel", {{u"channel"_s, u"2"_s}, {u"value"_s, u"-90"_s}, {u"seconds"_s, u"0.2"_s}}));
    QCOMPARE(rig.board().activeProfile(), 1);
}

void TestSbgcActions::signalsAreRead()
{
    SbgcRig rig;
    rig.board().store(u"rc.map.roll"_s, 0, 129);
    const auto nothing = rig.perform("signals");
    QVERIFY2(nothing, nothing ? "" : qPrintable(nothing.error().detail));
    QVERIFY(nothing->value(u"no_signal"_s).toString().contains(u"rc.map.roll"_s));
    QVERIFY(!nothing->contains(u"rc.map.roll"_s));
    QVERIFY(rig.channel.transact(silentRequest(CommandId::ApiVirtChControl, hex("FA00"), 1)));
    std::ignore = rig.channel.sleep(50ms);
    QCOMPARE(rig.perform("signals")->value(u"rc.map.roll"_s).toDouble(), 50.0);
}

void TestSbgcActions::slotsAreStateOfTheBoard_data()
{
    QTest::addColumn<int>("firmware");
    QTest::addColumn<QByteArray>("asked");
    QTest::addColumn<QByteArray>("told");
    // Trigger slot 2 in its highest fifth runs "look down" (17); slot 1 sets P of roll to 153.
    QTest::newRow("by slot") << 2590 << hex("0100") << hex("F40111F40199000000000000000000");
    QTest::newRow("by source") << 2704 << hex("01820000820000")
                               << hex("0040110040000019430040") + hex("00001943");
}

void TestSbgcActions::slotsAreStateOfTheBoard()
{
    QFETCH(int, firmware);
    QFETCH(QByteArray, asked);
    QFETCH(QByteArray, told);
    SbgcRig rig(firmware);
    rig.board().store(u"slot.trigger2.source"_s, 0, 130);
    rig.board().store(u"slot.trigger2.action5"_s, 0, 17);
    rig.board().store(u"slot.analog1.source"_s, 0, 130);
    rig.board().store(u"slot.analog1.variable"_s, 0, 0);
    rig.board().store(u"slot.analog1.min"_s, 0, 0);
    rig.board().store(u"slot.analog1.max"_s, 0, 153);
    QVERIFY(rig.channel.transact(silentRequest(CommandId::ApiVirtChControl, hex("F0D8F401"), 1)));
    std::ignore = rig.channel.sleep(50ms);
    const auto state
        = rig.channel.transact(replyRequest(CommandId::AdjVarsState, asked, CommandId::AdjVarsState, 15, 1));
    QVERIFY(state);
    QCOMPARE(state->payload.toHex(), told.toHex());
}

void TestSbgcActions::statisticsAreRead()
{
    SbgcRig rig;
    std::ignore = rig.channel.sleep(5s);
    const auto told = rig.perform("statistics");
    QVERIFY2(told, told ? "" : qPrintable(told.error().detail));
    QVERIFY(told->value(u"work"_s).toInt() >= 5);
    QCOMPARE(told->value(u"starts"_s).toInt(), 1);
    QVERIFY(told->value(u"current.max"_s).toInt() > 0);
    QCOMPARE(SbgcRig(2590).perform("statistics").error().code, ErrorCode::Unsupported);
}

void TestSbgcActions::profileSetsKeepProfiles()
{
    SbgcRig rig;
    const auto set = [&](const char *action, const char *slot) {
        return rig.perform("profile_set",
                           {{u"action"_s, QLatin1String(action)}, {u"slot"_s, QLatin1String(slot)}});
    };
    QVERIFY(!set("load", "2"));
    const int before = rig.board().stored(u"pid.roll.p"_s, 0);
    QVERIFY(set("store", "2"));
    rig.board().store(u"pid.roll.p"_s, 0, before + 20);
    QVERIFY(set("load", "2"));
    QCOMPARE(rig.board().stored(u"pid.roll.p"_s, 0), before);
    QCOMPARE(rig.board().inUse(u"pid.roll.p"_s), before);
    QVERIFY(set("clear", "2"));
    QVERIFY(!set("load", "2"));
    QVERIFY(set("store", "backup"));
}

void TestSbgcActions::externalDataComeBack()
{
    SbgcRig rig;
    QVERIFY(rig.perform("external.write", {{u"data"_s, u"01 02 ff"_s}}));
    const auto read = rig.perform("external.read");
    QVERIFY(read);
    QVERIFY(read->value(u"data"_s).toString().startsWith(u"01 02 ff 00"_s));
    SAYS(rig.perform("external.write", {{u"data"_s, QString(258, u'a')}}), u"128"_s);
    SAYS(rig.perform("external.write", {{u"data"_s, u"xy"_s}}), u"hex"_s);
}

void TestSbgcActions::memoryComesBackBitForBit()
{
    SbgcRig rig;
    const auto saved = rig.perform("memory.save", {{u"file"_s, rig.path(u"a"_s)}});
    QVERIFY2(saved, saved ? "" : qPrintable(saved.error().detail));
    QCOMPARE(saved->value(u"bytes"_s).toInt(), kMemorySize);
    const int before = rig.board().stored(u"pid.pitch.d"_s, 4);
    rig.board().store(u"pid.pitch.d"_s, 4, before + 1);
    rig.board().store(u"slot.trigger3.action2"_s, 0, 18);
    QVERIFY(rig.perform("external.write", {{u"data"_s, u"55"_s}}));
    const auto restored = rig.perform("memory.restore", {{u"file"_s, rig.path(u"a"_s)}});
    QVERIFY2(restored, restored ? "" : qPrintable(restored.error().detail));
    QCOMPARE(restored->value(u"written"_s).toInt(), 3 * 64);
    QCOMPARE(rig.board().stored(u"pid.pitch.d"_s, 4), before);
    QVERIFY(rig.perform("memory.save", {{u"file"_s, rig.path(u"b"_s)}}));
    QCOMPARE(fileBytes(rig.path(u"b"_s)), fileBytes(rig.path(u"a"_s)));
    QCOMPARE(rig.perform("memory.restore", {{u"file"_s, rig.path(u"a"_s)}})->value(u"written"_s).toInt(), 0);
}

void TestSbgcActions::brokenRestoreGoesOn()
{
    SbgcRig rig;
    QVERIFY(rig.perform("memory.save", {{u"file"_s, rig.path(u"a"_s)}}));
    for (int profile = 0; profile < kProfileCount; ++profile)
        rig.board().store(u"pid.pitch.d"_s, profile, 99);
    CutLine line(rig.channel);
    line.left = 2;
    const QVariantMap arguments = argumentsFor(rig.device, "memory.restore", {{u"file"_s, rig.path(u"a"_s)}});
    const auto cut = rig.device.perform(line, u"memory.restore"_s, arguments);
    SAYS(cut, u"128 bytes were written"_s);
    line.left = 99999;
    const auto rest = rig.device.perform(line, u"memory.restore"_s, arguments);
    QVERIFY(rest);
    QCOMPARE(rest->value(u"written"_s).toInt(), 3 * 64);
}

void TestSbgcActions::otherMemoryIsRefused()
{
    SbgcRig rig;
    QVERIFY(rig.perform("memory.save", {{u"file"_s, rig.path(u"a"_s)}}));
    auto image = MemoryImage::decode(fileBytes(rig.path(u"a"_s)));
    QVERIFY(image);
    const auto restore = [&](const QString &serial, const QString &firmware, bool other) {
        MemoryImage changed = *image;
        changed.serial = serial.isEmpty() ? image->serial : serial;
        changed.firmware = firmware.isEmpty() ? image->firmware : firmware;
        QFile file(rig.path(u"x"_s));
        if (!file.open(QIODevice::WriteOnly))
            qFatal("no file");
        file.write(changed.encode());
        file.close();
        return rig.perform("memory.restore",
                           {{u"file"_s, rig.path(u"x"_s)}, {u"other"_s, other ? u"on"_s : u"off"_s}});
    };
    SAYS(restore(u"0102"_s, {}, false), u"another board (0102"_s);
    QVERIFY(restore(u"0102"_s, {}, true));
    SAYS(restore({}, u"2.59b0"_s, true), u"2.59b0"_s);
}

void TestSbgcActions::memoryIsComparedInWords()
{
    SbgcRig rig;
    const SbgcRig::Texts file{{u"file"_s, rig.path(u"a"_s)}};
    QVERIFY(rig.perform("memory.save", file));
    const auto same = rig.perform("memory.compare", file);
    QVERIFY2(same, same ? "" : qPrintable(same.error().detail));
    QCOMPARE(*same, (ActionReply{{u"differing"_s, 0}, {u"files_differing"_s, 0}}));
    const int before = rig.board().stored(u"pid.pitch.d"_s, 4);
    rig.board().store(u"pid.pitch.d"_s, 4, before + 1);
    QVERIFY(rig.perform("external.write", {{u"data"_s, u"55"_s}}));
    const auto other = rig.perform("memory.compare", file);
    QVERIFY2(other, other ? "" : qPrintable(other.error().detail));
    QCOMPARE(other->value(u"differing"_s).toInt(), 2);
    QCOMPARE(other->value(u"profile 5: pid.pitch.d"_s).toString(), u"%1 -> %2"_s.arg(before).arg(before + 1));
    // What is no part of the configuration stays a range of addresses, and is said to be no more.
    QCOMPARE(other->value(u"0x1800"_s).toString(), u"00 -> 55"_s);
    QCOMPARE(other->value(u"unnamed"_s).toInt(), 1);
    QCOMPARE(other->size(), 6);
    // Of another firmware nothing is named.
    auto image = MemoryImage::load(rig.path(u"a"_s));
    QVERIFY(image);
    image->firmware = u"2.59b0"_s;
    image->serial = u"0102"_s;
    QFile changed(rig.path(u"a"_s));
    QVERIFY(changed.open(QIODevice::WriteOnly));
    changed.write(image->encode());
    changed.close();
    const auto foreign = rig.perform("memory.compare", file);
    QVERIFY(foreign);
    QVERIFY(!foreign->contains(u"found"_s));
    QCOMPARE(foreign->value(u"other_board"_s).toString(), u"0102"_s);
    QCOMPARE(foreign->value(u"other_firmware"_s).toString(), u"2.59b0"_s);
    QCOMPARE(foreign->value(u"unnamed"_s).toInt(), 2);
    QCOMPARE(foreign->size(), 7);
    image->bytes.chop(64);
    QVERIFY(changed.open(QIODevice::WriteOnly));
    changed.write(image->encode());
    changed.close();
    SAYS(rig.perform("memory.compare", file), u"the board's memory has 32768"_s);
    SAYS(rig.perform("memory.compare", {{u"file"_s, rig.path(u"none"_s)}}), u"none"_s);
}

// A block that stands in the memory twice could be either.
void TestSbgcActions::placesAreOnlyThoseFound()
{
    SbgcRig rig;
    const auto board = rig.device.readConfiguration(rig.channel);
    QVERIFY(board);
    const QByteArray block = board->block({1, Params3});
    const auto isFound = [&](const QByteArray &memory) {
        const auto places = findPlaces(memory, *board);
        return std::any_of(places.begin(), places.end(), [](const MemoryPlace &place) {
            return place.key == BlockKey{1, Params3} && place.at == 100;
        });
    };
    QVERIFY(isFound(QByteArray(100, '\0') + block));
    QVERIFY(isFound(QByteArray(100, '\0') + 'x' + block.mid(1)));  // it need not hold its profile's number
    QVERIFY(!isFound(QByteArray(100, '\0') + block + block));
    QVERIFY(
        isFound(QByteArray(100, '\0') + block.chopped(2)));  // which sensor is in use it need not hold either
    QVERIFY(!isFound(QByteArray(100, '\0') + block.chopped(3)));
    QVERIFY(findPlaces({}, *board).empty());
}

void TestSbgcActions::differencesAreRanges()
{
    QByteArray from(64, '\0');
    QByteArray to = from;
    QVERIFY(memoryDifferences(from, to).empty());
    to[0] = 1;
    to[8] = 2;  // 7 equal ones between
    to[30] = 3;
    to[63] = 4;
    const auto found = memoryDifferences(from, to);
    QCOMPARE(found.size(), std::size_t(3));
    QCOMPARE(found[0].place(), u"0x0000-0x0008"_s);
    QCOMPARE(found[0].changed(), 2);
    QCOMPARE(found[0].text(), u"00 00 00 00 00 00 00 00 00 -> 01 00 00 00 00 00 00 00 02"_s);
    QCOMPARE(found[1].place(), u"0x001e"_s);
    QCOMPARE(found[2].at, qsizetype(63));
}

void TestSbgcActions::imagesAreChecked_data()
{
    QTest::addColumn<QByteArray>("file");
    const QByteArray good = MemoryImage{u"s"_s, u"m"_s, u"2.70b4"_s, QByteArray(128, 'x')}.encode();
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("another kind") << QByteArray("{}\n");
    QTest::newRow("heading alone") << good.left(20);
    QTest::newRow("cut off") << good.left(good.size() - 1);
    QTest::newRow("too long") << good + 'x';
    QByteArray flipped = good;
    flipped.back() = 'y';
    QTest::newRow("damaged") << flipped;
    QTest::newRow("no description") << QByteArray("GIMBALDESK-EEPROM 1\nnothing\nabc");
}

void TestSbgcActions::imagesAreChecked()
{
    QFETCH(QByteArray, file);
    const auto image = MemoryImage::decode(file);
    QVERIFY(!image);
    QCOMPARE(image.error().code, ErrorCode::BadFile);
}

void TestSbgcActions::filesComeBack()
{
    SbgcRig rig;
    QByteArray content(700, 's');
    for (int i = 0; i < content.size(); ++i)
        content[i] = char(i * 31);
    QFile file(rig.path(u"script"_s));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(content);
    file.close();
    const SbgcRig::Texts one{
        {u"type"_s, u"script"_s}, {u"number"_s, u"1"_s}, {u"file"_s, rig.path(u"script"_s)}};
    const SbgcRig::Texts back{
        {u"type"_s, u"script"_s}, {u"number"_s, u"1"_s}, {u"file"_s, rig.path(u"back"_s)}};
    SAYS(rig.perform("file.save", back), u"file not found"_s);
    const auto loaded = rig.perform("file.load", one);
    QVERIFY2(loaded, loaded ? "" : qPrintable(loaded.error().detail));
    QVERIFY(rig.perform("file.save", back));
    QCOMPARE(fileBytes(rig.path(u"back"_s)), content);
    // Whoever cannot look does not say that it is gone.
    CutLine line(rig.channel);
    line.cut = u"READ_FILE"_s;
    line.left = 0;
    const auto unseen = rig.device.perform(
        line, u"file.erase"_s,
        argumentsFor(rig.device, "file.erase", {{u"type"_s, u"script"_s}, {u"number"_s, u"1"_s}}));
    QVERIFY(!unseen);
    QCOMPARE(unseen.error().code, ErrorCode::LinkClosed);
    QVERIFY(rig.perform("file.load", one));
    QVERIFY(rig.perform("file.erase", {{u"type"_s, u"script"_s}, {u"number"_s, u"1"_s}}));
    SAYS(rig.perform("file.save", back), u"file not found"_s);
    // More than there is room for.
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(QByteArray(65000, 'x'));
    file.close();
    QVERIFY(rig.perform("file.load", one));
    SAYS(rig.perform("file.load",
                     {{u"type"_s, u"script"_s}, {u"number"_s, u"2"_s}, {u"file"_s, rig.path(u"script"_s)}}),
         u"no free space"_s);
}

void TestSbgcActions::variablesTellAboutThemselves()
{
    SbgcRig rig(2738);
    int total = 1;
    int told = 0;
    for (int first = 0; first < total;) {
        const auto frame = rig.channel.transact(
            replyRequest(CommandId::AdjVarsInfo, QByteArray(1, char(first)), CommandId::AdjVarsInfo, 255, 1));
        QVERIFY(frame);
        for (const FieldValue &value :
             decodeFields(*findMessage(number(CommandId::AdjVarsInfo))->fromBoard, asBytes(frame->payload))) {
            if (value.name == u"total"_s)
                total = int(value.number);
            if (value.name.endsWith(u".id"_s)) {
                QCOMPARE(int(value.number), told);
                ++told;
            }
        }
        QVERIFY(told > first);
        first = told;
    }
    QCOMPARE(total, 102);
    QVERIFY(rig.channel.transact(confirmRequest(CommandId::SetAdjVarsValF, hex("010000001042"), 1)));
    const auto value = rig.channel.transact(
        replyRequest(CommandId::GetAdjVarsValF, hex("0100"), CommandId::SetAdjVarsValF, 6, 1));
    QVERIFY(value);
    QCOMPARE(value->payload.toHex(), QByteArray("010000001042"));
}

// By hand as well: whoever sends them is told that what the motors hold falls.
void TestSbgcActions::calibrationsThatRestartAreKnown()
{
    SbgcRig rig;
    for (const CommandId id : {CommandId::CalibMag, CommandId::CalibAcc, CommandId::CalibGyro}) {
        for (int action = 1; action <= 7; ++action) {
            const QByteArray payload = ByteWriter().u8(1).u8(action).zeros(10).take();
            const bool restarts = action == 2 || action == 4 || action == 5;
            QCOMPARE(rig.device.restartNotice()->ordersReset(encodeFrame(number(id), payload)).has_value(),
                     restarts);
        }
    }
}

QTEST_GUILESS_MAIN(TestSbgcActions)
#include "tst_sbgcactions.moc"
