// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// A SimpleBGC board as a whole: its memory, files and calibrations, there and back, over a line that breaks.
#include "protocol/configuration/memoryimage.h"
#include "protocol/simplebgc/parametertables.h"
#include "tests/support/channelproxy.h"
#include "tests/support/sbgcrig.h"

#include <QFile>
#include <QTest>

using namespace simplebgc;
using namespace Qt::StringLiterals;

namespace {

constexpr int kMemoryWriting = 47;
constexpr int kFileWriting = 54;

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void put(const QString &path, const QByteArray &content)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
        qFatal("no file");
}

struct WholeRig : SbgcRig
{
    WholeRig() { fill(); }
    explicit WholeRig(const SimulatorOptions &options)
        : SbgcRig(options)
    {
        fill();
    }
    /// Scripts of several lengths, one longer than a piece.
    void fill()
    {
        load("script", 0, "abc");
        load("script", 4, QByteArray(700, 'x'));
        load("look-up-table", 2, QByteArray(64, 't'));
        load("cogging", 1, "motor");
    }
    void load(const char *kind, int index, const QByteArray &content)
    {
        put(path(u"one"_s), content);
        const auto done = perform("file.load",
                                  {{u"type"_s, QLatin1String(kind)},
                                   {u"number"_s, QString::number(index)},
                                   {u"file"_s, path(u"one"_s)}});
        if (!done)
            qFatal("%s", qPrintable(done.error().detail));
    }
    void erase(const char *kind, int index)
    {
        if (!perform("file.erase", {{u"type"_s, QLatin1String(kind)}, {u"number"_s, QString::number(index)}}))
            qFatal("not erased");
    }
    Result<ActionReply> with(const char *key, const QString &name, Texts texts = {})
    {
        texts.insert(u"file"_s, path(name));
        return perform(key, texts);
    }
    /// Over a line that ends, or is answered otherwise, after so many requests of one kind.
    Result<ActionReply> cut(const char *key, const QString &name, const QString &request, int left,
                            const Error &error)
    {
        Altering line(channel, [&](const Request &each, const Altering::Pass &pass) -> Result<Frame> {
            if (each.name == request && left-- <= 0)
                return tl::unexpected(error);
            return pass(each);
        });
        return device.perform(line, QLatin1String(key), argumentsFor(device, key, {{u"file"_s, path(name)}}));
    }
    MemoryImage image(const QString &name)
    {
        const auto loaded = MemoryImage::load(path(name));
        if (!loaded)
            qFatal("%s", qPrintable(loaded.error().detail));
        return *loaded;
    }
    /// Everything is otherwise.
    void spoil()
    {
        for (int profile = 0; profile < kProfileCount; ++profile)
            board().store(u"pid.pitch.d"_s, profile, 99);
        load("script", 4, "other");
        load("script", 7, "more");
        erase("cogging", 1);
    }
};

#define WORKS(outcome)                                                                                       \
    QVERIFY2((outcome).has_value(), qPrintable((outcome) ? QString() : (outcome).error().detail))

}  // namespace

class TestSbgcWholeBoard : public QObject
{
    Q_OBJECT
private slots:
    void comesBackBitForBit();
    void brokenCopyGoesOn();
    void copyIsReadTwice();
    void brokenRestoreGoesOn_data();
    void brokenRestoreGoesOn();
    void refusedWriteIsTold();
    void otherBoardGivesItsSettingsAlone();
    void boardWithoutNumberIsNotTrusted();
    void boardWithoutFilesIsCopied();
    void differencesAreWorded();
    void filesAreErasedAfterACopy();
    void calibrationsComeBack();
    void imagesWithFilesAreChecked();
};

void TestSbgcWholeBoard::comesBackBitForBit()
{
    WholeRig rig;
    const auto saved = rig.with("memory.save", u"a"_s);
    WORKS(saved);
    QCOMPARE(saved->value(u"files"_s).toInt(), 4);
    QCOMPARE(rig.image(u"a"_s).files->value(u"script 4"_s), QByteArray(700, 'x'));
    rig.spoil();
    QVERIFY(rig.with("memory.save", u"b"_s));
    QVERIFY(contentOf(rig.path(u"b"_s)) != contentOf(rig.path(u"a"_s)));
    const auto restored = rig.with("memory.restore", u"a"_s);
    WORKS(restored);
    QCOMPARE(restored->value(u"written"_s).toInt(), 5 * 64);
    QCOMPARE(restored->value(u"files_changed"_s).toInt(), 3);
    QVERIFY(rig.with("memory.save", u"b"_s));
    QCOMPARE(contentOf(rig.path(u"b"_s)), contentOf(rig.path(u"a"_s)));
    QCOMPARE(rig.with("memory.compare", u"a"_s).value(),
             (ActionReply{{u"differing"_s, 0}, {u"files_differing"_s, 0}}));
}

void TestSbgcWholeBoard::brokenCopyGoesOn()
{
    WholeRig rig;
    int asked = 0;
    const auto counted = [&](const QString &name) {
        asked = 0;
        Altering line(rig.channel, [&](const Request &each, const Altering::Pass &pass) {
            asked += each.name == u"EEPROM_READ"_s;
            return pass(each);
        });
        return rig.device.perform(line, u"memory.save"_s,
                                  argumentsFor(rig.device, "memory.save", {{u"file"_s, rig.path(name)}}));
    };
    QVERIFY(counted(u"whole"_s));
    const int all = asked;
    const Error lost{ErrorCode::LinkClosed, {}, 0};
    const auto said1 = rig.cut("memory.save", u"a"_s, u"EEPROM_READ"_s, 100, lost);
    SAYS(said1, u"19200 bytes were read before"_s);
    QVERIFY(!QFile::exists(rig.path(u"a"_s)));
    QVERIFY(counted(u"a"_s));
    QCOMPARE(asked, all - 100);
    QCOMPARE(contentOf(rig.path(u"a"_s)), contentOf(rig.path(u"whole"_s)));
    QVERIFY(!QFile::exists(rig.path(u"a.part"_s)));
    // In the middle of the files, and of a part that is not whole itself.
    const auto said2 = rig.cut("memory.save", u"a"_s, u"READ_FILE"_s, 3, lost);
    SAYS(said2, u"32768 bytes were read before"_s);
    put(rig.path(u"a.part"_s), contentOf(rig.path(u"a.part"_s)).chopped(1));
    QVERIFY(counted(u"a"_s));
    QCOMPARE(asked, all);
    QCOMPARE(contentOf(rig.path(u"a"_s)), contentOf(rig.path(u"whole"_s)));
}

void TestSbgcWholeBoard::copyIsReadTwice()
{
    WholeRig rig;
    int reads = 0;
    const auto save = [&](int firstWrong, int lastWrong) {
        reads = 0;
        Altering line(rig.channel, [&](const Request &each, const Altering::Pass &pass) {
            auto frame = pass(each);
            ++reads;
            if (frame && each.name == u"EEPROM_READ"_s && reads >= firstWrong && reads <= lastWrong)
                frame->payload[10] = char(frame->payload[10] + reads);
            return frame;
        });
        return rig.device.perform(line, u"memory.save"_s,
                                  argumentsFor(rig.device, "memory.save", {{u"file"_s, rig.path(u"a"_s)}}));
    };
    QVERIFY(save(5, 5));  // one that slipped through the checksum
    QVERIFY(rig.with("memory.compare", u"a"_s)->value(u"differing"_s) == 0);
    QFile::remove(rig.path(u"a"_s));
    const auto said3 = save(1, 99999);
    SAYS(said3, u"something else"_s);
    QVERIFY(!QFile::exists(rig.path(u"a"_s)));
}

void TestSbgcWholeBoard::brokenRestoreGoesOn_data()
{
    QTest::addColumn<QString>("request");
    QTest::addColumn<int>("left");
    QTest::addColumn<QString>("said");
    QTest::newRow("memory") << u"EEPROM_WRITE"_s << 2 << u"128 bytes were written"_s;
    QTest::newRow("first file") << u"WRITE_FILE"_s << 0 << u"0 files were changed"_s;
    QTest::newRow("middle of a file") << u"WRITE_FILE"_s << 4 << u"2 files were changed"_s;
}

void TestSbgcWholeBoard::brokenRestoreGoesOn()
{
    QFETCH(QString, request);
    QFETCH(int, left);
    QFETCH(QString, said);
    WholeRig rig;
    QVERIFY(rig.with("memory.save", u"a"_s));
    rig.spoil();
    const auto said4 = rig.cut("memory.restore", u"a"_s, request, left, {ErrorCode::LinkClosed, {}, 0});
    SAYS(said4, said);
    WORKS(rig.with("memory.restore", u"a"_s));
    QVERIFY(rig.with("memory.save", u"b"_s));
    QCOMPARE(contentOf(rig.path(u"b"_s)), contentOf(rig.path(u"a"_s)));
}

void TestSbgcWholeBoard::refusedWriteIsTold()
{
    WholeRig rig;
    QVERIFY(rig.with("memory.save", u"a"_s));
    rig.spoil();
    const QByteArray fault = hex("2F0100000000");
    const auto memory = rig.cut("memory.restore", u"a"_s, u"EEPROM_WRITE"_s, 1,
                                *refusalOf(FrameView{255, asBytes(fault), 1}, kMemoryWriting));
    SAYS(memory, u"EEPROM fault"_s);
    SAYS(memory, u"64 bytes were written before"_s);
    // Of files the board itself has too little room for.
    MemoryImage image = rig.image(u"a"_s);
    image.files->insert(u"script 8"_s, QByteArray(60000, 'y'));
    image.files->insert(u"script 9"_s, QByteArray(60000, 'y'));
    put(rig.path(u"large"_s), image.encode());
    const auto files = rig.with("memory.restore", u"large"_s);
    SAYS(files, u"no free space"_s);
    SAYS(files, u"script 9"_s);
    // Nothing is said to be there that is not.
    QVERIFY(rig.with("memory.compare", u"a"_s)->value(u"files_differing"_s).toInt() > 0);
    // A write that is confirmed and not done.
    rig.board().store(u"pid.pitch.d"_s, 0, 98);
    Altering line(rig.channel, [&](const Request &each, const Altering::Pass &pass) -> Result<Frame> {
        return each.name == u"EEPROM_WRITE"_s ? Frame(67, QByteArray(1, char(kMemoryWriting)), 1)
                                              : pass(each);
    });
    const auto said5
        = rig.device.perform(line, u"memory.restore"_s,
                             argumentsFor(rig.device, "memory.restore", {{u"file"_s, rig.path(u"a"_s)}}));
    SAYS(said5, u"other bytes than were written"_s);
}

// What is calibrated or licensed stays this board's own, and so does what nobody can name.
void TestSbgcWholeBoard::otherBoardGivesItsSettingsAlone()
{
    WholeRig from;
    from.board().store(u"pid.pitch.d"_s, 3, 77);
    from.load("script", 4, "theirs");
    from.load("cogging", 1, "their motor");
    QVERIFY(from.perform("external.write", {{u"data"_s, u"aa"_s}}));
    QVERIFY(from.with("memory.save", u"a"_s));
    SimulatorOptions options = withFirmware(2704);
    options.seed = 99;
    WholeRig to(options);
    QVERIFY(to.perform("external.write", {{u"data"_s, u"55"_s}}));
    put(to.path(u"a"_s), contentOf(from.path(u"a"_s)));
    const auto said6 = to.with("memory.restore", u"a"_s);
    SAYS(said6, u"another board"_s);
    const auto done = to.with("memory.restore", u"a"_s, {{u"part"_s, u"settings"_s}});
    WORKS(done);
    QCOMPARE(to.board().stored(u"pid.pitch.d"_s, 3), 77);
    QVERIFY(to.perform("external.read")->value(u"data"_s).toString().startsWith(u"55"_s));
    QVERIFY(to.with("memory.save", u"b"_s));
    const MemoryImage now = to.image(u"b"_s);
    QCOMPARE(now.files->value(u"script 4"_s), QByteArray("theirs"));
    QCOMPARE(now.files->value(u"cogging 1"_s), QByteArray("motor"));
    // Whoever means it takes all.
    WORKS(to.with("memory.restore", u"a"_s, {{u"other"_s, u"on"_s}}));
    QVERIFY(to.perform("external.read")->value(u"data"_s).toString().startsWith(u"aa"_s));
}

void TestSbgcWholeBoard::boardWithoutNumberIsNotTrusted()
{
    SimulatorOptions options = withFirmware(2704);
    options.own.insert(u"number"_s, 0);
    WholeRig rig(options);
    QVERIFY(!rig.device.identity().isNumbered());
    QVERIFY(rig.with("memory.save", u"a"_s));
    const auto said7 = rig.with("memory.restore", u"a"_s);
    SAYS(said7, u"has no number"_s);
    WORKS(rig.with("memory.restore", u"a"_s, {{u"part"_s, u"settings"_s}}));
    WORKS(rig.with("memory.restore", u"a"_s, {{u"other"_s, u"on"_s}}));
}

void TestSbgcWholeBoard::boardWithoutFilesIsCopied()
{
    SbgcRig rig;
    Altering line(rig.channel, [&](const Request &each, const Altering::Pass &pass) -> Result<Frame> {
        if (each.name != u"READ_FILE"_s)
            return pass(each);
        return failure(ErrorCode::BoardError, u"READ_FILE: unknown command"_s, 6);
    });
    const auto saved = rig.device.perform(
        line, u"memory.save"_s, argumentsFor(rig.device, "memory.save", {{u"file"_s, rig.path(u"a"_s)}}));
    WORKS(saved);
    QVERIFY(!saved->contains(u"files"_s));
    QVERIFY(!MemoryImage::load(rig.path(u"a"_s))->files);
    // The files of a board that has some stay where a copy has none.
    WholeRig full;
    QVERIFY(full.with("memory.save", u"a"_s, {{u"files"_s, u"off"_s}}));
    QVERIFY(!full.with("memory.restore", u"a"_s)->contains(u"files_changed"_s));
    QVERIFY(full.with("memory.save", u"b"_s));
    QCOMPARE(full.image(u"b"_s).files->size(), 4);
    const auto said8
        = rig.device.perform(line, u"file.erase_all"_s,
                             argumentsFor(rig.device, "file.erase_all", {{u"file"_s, rig.path(u"c"_s)}}));
    SAYS(said8, u"keeps no files"_s);
}

void TestSbgcWholeBoard::differencesAreWorded()
{
    WholeRig rig;
    QVERIFY(rig.with("memory.save", u"a"_s));
    const int before = rig.board().stored(u"pid.pitch.d"_s, 0);
    rig.spoil();
    const auto told = rig.with("memory.compare", u"a"_s);
    WORKS(told);
    QCOMPARE(told->value(u"profile 1: pid.pitch.d"_s).toString(), u"%1 -> 99"_s.arg(before));
    QCOMPARE(told->value(u"files_differing"_s).toInt(), 3);
    QCOMPARE(told->value(u"script 4"_s).toString(), u"700 bytes -> 5 bytes"_s);
    QCOMPARE(told->value(u"script 7"_s).toString(), u"none -> 4 bytes"_s);
    QCOMPARE(told->value(u"cogging 1"_s).toString(), u"5 bytes -> none"_s);
}

void TestSbgcWholeBoard::filesAreErasedAfterACopy()
{
    WholeRig rig;
    // No copy, no erasing.
    const auto said9 = rig.cut("file.erase_all", u"a"_s, u"READ_FILE"_s, 20, {ErrorCode::Timeout, {}, 0});
    SAYS(said9, u"read before"_s);
    const auto said10 = rig.with("file.erase_all", u"none/a"_s);
    SAYS(said10, u"none/a"_s);
    QVERIFY(rig.with("memory.save", u"old"_s));
    QCOMPARE(rig.image(u"old"_s).files->size(), 4);
    const auto said11 = rig.with("file.erase_all", u"old"_s);
    SAYS(said11, u"there already"_s);
    // Refused by the board, in words.
    Altering line(rig.channel, [&](const Request &each, const Altering::Pass &pass) -> Result<Frame> {
        return each.name == u"FS_CLEAR_ALL"_s ? Frame(67, hex("3703"), 1) : pass(each);
    });
    const auto said12
        = rig.device.perform(line, u"file.erase_all"_s,
                             argumentsFor(rig.device, "file.erase_all", {{u"file"_s, rig.path(u"c"_s)}}));
    SAYS(said12, u"FAT damaged"_s);
    const auto done = rig.with("file.erase_all", u"b"_s);
    WORKS(done);
    QCOMPARE(done->value(u"files_changed"_s).toInt(), 4);
    QVERIFY(rig.with("memory.save", u"now"_s));
    QVERIFY(rig.image(u"now"_s).files->isEmpty());
    QCOMPARE(contentOf(rig.path(u"b"_s)), contentOf(rig.path(u"old"_s)));
    QVERIFY(rig.with("memory.restore", u"b"_s));
    QCOMPARE(rig.with("memory.compare", u"old"_s)->value(u"files_differing"_s).toInt(), 0);
}

void TestSbgcWholeBoard::calibrationsComeBack()
{
    WholeRig rig;
    QVERIFY(rig.perform("calibrate.gyro"));
    const auto saved = rig.with("calibration.save", u"a"_s);
    WORKS(saved);
    QCOMPARE(saved->value(u"files"_s).toInt(), 2);  // that of a motor as well
    QCOMPARE(rig.with("calibration.compare", u"a"_s).value(), (ActionReply{{u"files_differing"_s, 0}}));
    const double good = rig.board().stabilizer().imu().gyroCorrection[0];
    rig.board().stabilizer().imu().gyroBias[0] += 1;
    QVERIFY(rig.perform("calibrate.gyro"));
    rig.load("script", 4, "other");
    QVERIFY(rig.board().stabilizer().imu().gyroCorrection[0] > good + 0.9);
    const auto told = rig.with("calibration.compare", u"a"_s);
    WORKS(told);
    QCOMPARE(told->value(u"files_differing"_s).toInt(), 1);
    QCOMPARE(told->value(u"imu-calibration 0"_s).toString(), u"36 bytes -> 36 bytes"_s);
    WORKS(rig.with("calibration.restore", u"a"_s));
    // Another board's are not taken unasked, and a copy without any is none.
    MemoryImage image = rig.image(u"a"_s);
    image.serial = u"0102"_s;
    put(rig.path(u"x"_s), image.encode());
    const auto said13 = rig.with("calibration.restore", u"x"_s);
    SAYS(said13, u"another board"_s);
    image = rig.image(u"a"_s);
    image.files->remove(u"imu-calibration 0"_s);
    image.files->remove(u"cogging 1"_s);
    put(rig.path(u"x"_s), image.encode());
    const auto said14 = rig.with("calibration.restore", u"x"_s);
    SAYS(said14, u"no calibration"_s);
    const auto said15
        = rig.cut("calibration.restore", u"a"_s, u"READ_FILE"_s, 2, {ErrorCode::LinkClosed, u"cut"_s, 0});
    SAYS(said15, u"cut"_s);
    // What the board tells of its sensors is compared in words.
    image = rig.image(u"a"_s);
    QByteArray status = image.files->value(u"status main"_s);
    QVERIFY(status.size() == 33);
    status[11] = 3;
    image.files->insert(u"status main"_s, status);
    put(rig.path(u"x"_s), image.encode());
    QCOMPARE(rig.with("calibration.compare", u"x"_s)->value(u"main.limits"_s).toString(), u"3 -> 0"_s);
    QVERIFY(rig.perform("reset"));
    std::ignore = rig.channel.sleep(3s);
    rig.port.advance(2s);
    QVERIFY(std::abs(rig.board().stabilizer().imu().gyroCorrection[0] - good) < 1e-3);
}

void TestSbgcWholeBoard::imagesWithFilesAreChecked()
{
    MemoryImage image{u"s"_s, u"m"_s, u"2.70b4"_s, QByteArray(128, 'x')};
    image.files = MemoryImage::Files{{u"script 1"_s, "abc"}, {u"script 2"_s, "de"}};
    const QByteArray good = image.encode();
    QCOMPARE(MemoryImage::decode(good).value(), image);
    QVERIFY(!MemoryImage::decode(good.chopped(1)));
    QVERIFY(!MemoryImage::decode(good + 'x'));
    QByteArray flipped = good;
    flipped.back() = 'y';
    QVERIFY(!MemoryImage::decode(flipped));
    image.files.reset();
    QVERIFY(image.encode().startsWith("GIMBALDESK-EEPROM 1\n"));
    QVERIFY(!MemoryImage::decode("GIMBALDESK-EEPROM 3\n{}\nabc"));
}

QTEST_GUILESS_MAIN(TestSbgcWholeBoard)
#include "tst_sbgcwholeboard.moc"
