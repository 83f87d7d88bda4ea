// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/base/checksum.h"
#include "protocol/base/filefault.h"
#include "protocol/session/stopplan.h"
#include "tests/support/dronerig.h"
#include "tests/support/watcheddrone.h"

#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QTest>
#include <QtEndian>

using namespace Qt::StringLiterals;
using namespace bcflight;
using Drone = bcflight::SimulatedBoard;

namespace {

constexpr int kPiece = 1024;

/// A watched drone, a virtual channel to it, and what goes out to it.
struct Rig : DroneRig
{
    explicit Rig(const Faults &faults = {})
        : Rig(droneOptions(Generation::G, {}, faults))
    {
    }
    explicit Rig(const SimulatorOptions &made)
        : DroneRig(made, std::make_unique<WatchedDrone>(made))
    {
        heard = [this](const FrameView &frame) { streamed += frame.id == int(Message::Gyro) ? 1 : 0; };
        watched().onReceive = [this](QByteArray &packet) {
            const int id = idOf(packet);
            if (id >= 0x72 && id <= 0x74)
                uploads.append(packet);
            return !losesPacket || !losesPacket(packet);
        };
    }
    static int idOf(const QByteArray &packet)
    {
        return packet.size() < 2 || packet[0] != 0 ? -1 : int(std::uint8_t(packet[1]));
    }
    static int offsetOf(const QByteArray &chunk)
    {
        return int(qFromBigEndian<std::uint32_t>(chunk.constData() + 6));
    }
    WatchedDrone &watched() { return static_cast<WatchedDrone &>(port.board()); }
    Drone &drone() { return watched().drone(); }
    Result<ActionReply> upload(const QByteArray &image)
    {
        const QString path = dir.filePath(u"firmware.bin"_s);
        if (!writeWhole(path, image))
            qFatal("no file");
        return perform("firmware.upload", {{u"file"_s, path}});
    }
    /// The offsets of the pieces that went out, in their order.
    [[nodiscard]] QList<int> offsets() const
    {
        QList<int> list;
        for (const QByteArray &packet : uploads) {
            if (idOf(packet) == int(Message::UploadData))
                list.append(offsetOf(packet));
        }
        return list;
    }
    [[nodiscard]] int countOf(Message id) const
    {
        return int(std::count_if(uploads.begin(), uploads.end(),
                                 [id](const QByteArray &packet) { return idOf(packet) == int(id); }));
    }
    void armByAnother()
    {
        const QByteArray controls
            = encode(Message::Controls, Controls{.arm = true}.encode(Generation::G), Generation::G);
        drone().receive(asBytes(controls));
    }
    /// Frames of the stream in the next second.
    int streamGoesOn()
    {
        const int before = streamed;
        std::ignore = channel.sleep(1s);
        return streamed - before;
    }

    QTemporaryDir dir;
    QList<QByteArray> uploads;
    std::function<bool(const QByteArray &)> losesPacket;
    int streamed = 0;
};

// Bytes that a drone which reads them as messages would arm by.
QByteArray imageOf(int bytes, const QByteArray &version = "3.1")
{
    QByteArray image = "version " + version + '\n';
    const QByteArray arming = encode(
        Message::Controls, Controls{.thrust = 0.9, .arm = true}.encode(Generation::G), Generation::G);
    while (image.size() < bytes)
        image += arming;
    image.truncate(bytes);
    return image;
}

// A program for Linux of that type, for that processor.
QByteArray elfOf(char type, char machine)
{
    QByteArray image = imageOf(4 * kPiece);
    image.replace(0, 4,
                  "\x7F"
                  "ELF");
    image[16] = type;
    image[17] = 0;
    image[18] = machine;
    image[19] = 0;
    return image;
}

bool tellsSilence(const Error &error)
{
    return error.detail.contains(u"its stream stays silent until it is restarted"_s);
}

}  // namespace

/// What a drone does on the bench: another firmware, and stopping it while it hears nothing.
class TestBcflightBench final : public QObject
{
    Q_OBJECT
private slots:
    void firmwareIsUploaded();
    void lastPieceIsShort_data();
    void lastPieceIsShort();
    void sameVersionIsNoProof();
    void doubtIsToldOfWhatShowsNothing();
    void uploadIsRefused_data();
    void uploadIsRefused();
    void pieceIsSentAgain_data();
    void pieceIsSentAgain();
    void badNetworkDoesNotHurt_data();
    void badNetworkDoesNotHurt();
    void uploadStopsAtTheFirstRefusal_data();
    void uploadStopsAtTheFirstRefusal();
    void silenceIsBounded();
    void cancelLeavesASilentStream();
    void restartIsNotCancelled();
    void armedMeanwhileIsNotRestarted();
    void droneThatStaysIsTold();
    void droneThatDoesNotComeBackIsTold();
    void lostAnswerIsNoRestart();
    void stopIsHeardFirst_data();
    void stopIsHeardFirst();
    void deafTimeIsNotCutShort();
    void motorsBeepUntilTheyAreTold();
};

void TestBcflightBench::firmwareIsUploaded()
{
    Rig rig;
    QVERIFY(rig.calibrate());
    const QByteArray image = imageOf(20 * kPiece);
    const auto done = rig.upload(image);
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QCOMPARE(rig.drone().firmware(), image);
    QCOMPARE(done->value(u"before"_s).toString(), u"1.0"_s);
    QCOMPARE(done->value(u"firmware"_s).toString(), u"3.1"_s);
    QVERIFY(done->value(u"confirmed"_s).toBool());
    // INIT, then the pieces in order and each alone, then the end with the checksum of all.
    QCOMPARE(rig.uploads.first(), QByteArray::fromHex("0072"));
    QList<int> inOrder;
    for (int i = 0; i < 20; ++i)
        inOrder.append(i * kPiece);
    QCOMPARE(rig.offsets(), inOrder);
    for (const QByteArray &packet : rig.uploads) {
        if (Rig::idOf(packet) == int(Message::UploadData))
            QCOMPARE(packet.size(), 2 + 20 + kPiece);
    }
    QCOMPARE(rig.uploads.last(), QByteArray::fromHex("0074") + bigU32(crc32c(asBytes(image))));
    // It has started anew: its stream is there again, and it wants to be calibrated.
    QVERIFY(!rig.drone().status().calibrated && !rig.drone().isArmed());
    QVERIFY(rig.streamGoesOn() > 50);
    QCOMPARE(rig.drone().unknownMessages(), 0);
    // What was seen of it.
    QStringList steps;
    for (const Progress &progress : rig.channel.progressReports()) {
        if (progress.step.startsWith(u"firmware"_s) && !steps.contains(progress.step))
            steps.append(progress.step);
    }
    QCOMPARE(steps, (QStringList{u"firmware-upload"_s, u"firmware-restart"_s}));
}

void TestBcflightBench::lastPieceIsShort_data()
{
    QTest::addColumn<int>("bytes");
    for (const int bytes : {kPiece, kPiece + 1, 2 * kPiece - 1, 3 * kPiece + 7, int(Drone::kLargestImage)})
        QTest::newRow(qPrintable(QString::number(bytes))) << bytes;
}

void TestBcflightBench::lastPieceIsShort()
{
    QFETCH(int, bytes);
    Rig rig;
    QVERIFY(rig.identify());
    const QByteArray image = imageOf(bytes);
    const auto done = rig.upload(image);
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QCOMPARE(rig.offsets().size(), (bytes + kPiece - 1) / kPiece);
    QCOMPARE(rig.drone().firmware(), image);
}

void TestBcflightBench::sameVersionIsNoProof()
{
    Rig rig;
    QVERIFY(rig.identify());
    const auto done = rig.upload(imageOf(2 * kPiece, "1.0"));
    QVERIFY(done);
    QVERIFY(!done->value(u"confirmed"_s).toBool());
    QVERIFY(done->value(u"unproven"_s).toString().contains(u"same version"_s));
}

// No document says how such a file looks: what it does not show is told before it is confirmed.
void TestBcflightBench::doubtIsToldOfWhatShowsNothing()
{
    Rig rig;
    QVERIFY(rig.identify());
    const auto doubt = [&rig](const QByteArray &image) {
        const QString path = rig.dir.filePath(u"any.bin"_s);
        return writeWhole(path, image)
            ? QString::fromUtf8(rig.device.doubt(u"firmware.upload"_s, {{u"file"_s, path}}))
            : u"no file"_s;
    };
    QVERIFY(doubt(imageOf(4 * kPiece)).contains(u"Nothing in the file shows"_s));
    QCOMPARE(doubt(elfOf(2, 40)), QString());
    QCOMPARE(doubt(elfOf(3, char(183))), QString());
    QVERIFY(!doubt(elfOf(2, char(243))).isEmpty());  // a processor that no such drone has been seen with
    QCOMPARE(doubt("{"), QString());  // it is refused
    QVERIFY(rig.calibrate());
    const QByteArray program = elfOf(2, 40);
    QVERIFY(rig.upload(program));
    QCOMPARE(rig.drone().firmware(), program);
}

void TestBcflightBench::uploadIsRefused_data()
{
    QTest::addColumn<QString>("why");
    QTest::addColumn<ErrorCode>("code");
    QTest::newRow("armed") << u"armed"_s << ErrorCode::ConditionUnmet;
    QTest::newRow("calibrating") << u"calibrating"_s << ErrorCode::ConditionUnmet;
    QTest::newRow("a stream") << u"stream"_s << ErrorCode::Unsupported;
    QTest::newRow("too large") << u"large"_s << ErrorCode::BadFile;
    QTest::newRow("empty") << u"empty"_s << ErrorCode::BadFile;
    QTest::newRow("not there") << u"missing"_s << ErrorCode::BadFile;
    QTest::newRow("packed") << u"packed"_s << ErrorCode::BadFile;
    QTest::newRow("a configuration") << u"text"_s << ErrorCode::BadFile;
    QTest::newRow("too small") << u"small"_s << ErrorCode::BadFile;
    QTest::newRow("words") << u"words"_s << ErrorCode::BadFile;
    QTest::newRow("a tar archive") << u"tar"_s << ErrorCode::BadFile;
    QTest::newRow("a program of this computer") << u"desktop"_s << ErrorCode::BadFile;
    QTest::newRow("an object file") << u"object"_s << ErrorCode::BadFile;
}

// Before anything of it goes out.
void TestBcflightBench::uploadIsRefused()
{
    QFETCH(QString, why);
    QFETCH(ErrorCode, code);
    Rig rig;
    QVERIFY(rig.calibrate());
    QByteArray image = imageOf(4 * kPiece);
    if (why == u"armed"_s) {
        rig.armByAnother();
        std::ignore = rig.channel.sleep(20ms);
        QVERIFY(rig.drone().isArmed());
    } else if (why == u"calibrating"_s) {
        rig.drone().receive(asBytes(encode(Message::Calibrate, bigU32(0) + bigF32(0), Generation::G)));
    } else if (why == u"large"_s) {
        image = QByteArray(Drone::kLargestImage + 1, 'x');
    } else if (why == u"empty"_s) {
        image.clear();
    } else if (why == u"packed"_s) {
        image.replace(0, 4, "PK\x03\x04");
    } else if (why == u"text"_s) {
        image = QByteArray("--- Frame\nframe = Multicopter{}\n").repeated(40);
    } else if (why == u"small"_s) {
        image.truncate(kPiece - 1);
    } else if (why == u"words"_s) {
        image = QString(kPiece, u'ü').toUtf8();
    } else if (why == u"tar"_s) {
        image.replace(257, 5, "ustar");
    } else if (why == u"desktop"_s) {
        image = elfOf(2, 62);
    } else if (why == u"object"_s) {
        image = elfOf(1, 40);
    }
    SimulatorOptions options;
    auto stream = std::make_unique<WatchedDrone>(options);
    stream->packetBased = false;
    SimulatedPort line(std::move(stream), options, {});
    VirtualChannel overTcp(line, rig.family.makeFramer(), rig.family.timing);
    const QString whole = rig.dir.filePath(u"whole.bin"_s);
    QVERIFY(writeWhole(whole, imageOf(4 * kPiece)));
    const auto done = why == u"stream"_s
        ? rig.device.perform(overTcp, u"firmware.upload"_s, {{u"file"_s, whole}})
        : why == u"missing"_s ? rig.perform("firmware.upload", {{u"file"_s, rig.dir.filePath(u"none"_s)}})
                              : rig.upload(image);
    QVERIFY(!done);
    QCOMPARE(done.error().code, code);
    QVERIFY(!tellsSilence(done.error()));
    QVERIFY(rig.uploads.isEmpty());
    QVERIFY(!rig.drone().isStreamPaused());
}

void TestBcflightBench::pieceIsSentAgain_data()
{
    QTest::addColumn<QString>("what");
    QTest::newRow("the piece is lost") << u"piece"_s;
    QTest::newRow("its answer is lost") << u"answer"_s;
    QTest::newRow("it is damaged") << u"damage"_s;
    QTest::newRow("its answer is late") << u"late"_s;
}

// The first piece empties what was received: again only as long as no later one was sent.
void TestBcflightBench::pieceIsSentAgain()
{
    QFETCH(QString, what);
    Rig rig;
    QVERIFY(rig.identify());
    const QSet<int> hit{0, 3 * kPiece, 7 * kPiece};
    QSet<int> done;
    int answered = -1;
    QByteArray late;
    rig.watched().onReceive = [&](QByteArray &packet) {
        if (Rig::idOf(packet) != int(Message::UploadData))
            return true;
        rig.uploads.append(packet);
        const int offset = Rig::offsetOf(packet);
        answered = offset;
        if (!hit.contains(offset) || done.contains(offset))
            return true;
        if (what == u"piece"_s || what == u"damage"_s)
            done.insert(offset);
        if (what == u"damage"_s)
            packet[packet.size() - 1] = char(packet[packet.size() - 1] ^ 1);
        return what != u"piece"_s;
    };
    rig.watched().onSend = [&](QByteArray &packet) {
        if (Rig::idOf(packet) != int(Message::UploadData) || (what != u"answer"_s && what != u"late"_s)
            || !hit.contains(answered) || done.contains(answered))
            return true;
        done.insert(answered);
        late = packet;
        return false;
    };
    // The answer that came late must not be taken for that to the next piece.
    rig.channel.setOperator([&](const Progress &) {
        if (what == u"late"_s && !late.isEmpty()) {
            rig.watched().onSend = nullptr;
            late.clear();
        }
    });
    const QByteArray image = imageOf(10 * kPiece);
    const auto uploaded = rig.upload(image);
    QVERIFY2(uploaded, uploaded ? "" : qPrintable(uploaded.error().detail));
    QCOMPARE(rig.drone().firmware(), image);
    QList<int> offsets = rig.offsets();
    QVERIFY(offsets.size() > 10);
    QVERIFY(std::is_sorted(offsets.begin(), offsets.end()));
    QCOMPARE(offsets.count(0), 2);
    QCOMPARE(offsets.count(kPiece), 1);
}

void TestBcflightBench::badNetworkDoesNotHurt_data()
{
    QTest::addColumn<QStringList>("faults");
    QTest::newRow("lossy") << QStringList{u"lose=0.05"_s};
    QTest::newRow("doubling") << QStringList{u"double=0.2"_s};
    QTest::newRow("slow") << QStringList{u"late=150"_s};
    QTest::newRow("all at once") << QStringList{u"lose=0.05"_s, u"double=0.05"_s, u"delay=120"_s,
                                                u"reorder=0.05"_s};
}

void TestBcflightBench::badNetworkDoesNotHurt()
{
    QFETCH(QStringList, faults);
    Rig rig;
    QVERIFY(rig.identify());
    for (const QString &fault : faults)
        QVERIFY(rig.port.change(fault));
    const QByteArray image = imageOf(200 * kPiece + 13);
    const TimePoint begin = rig.channel.now();
    const auto done = rig.upload(image);
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QCOMPARE(rig.drone().firmware(), image);
    QVERIFY(done->value(u"confirmed"_s).toBool());
    QVERIFY(!rig.drone().isArmed());
    const QList<int> offsets = rig.offsets();
    if (!faults.contains(u"reorder=0.05"_s))
        QVERIFY(std::is_sorted(offsets.begin(), offsets.end()));
    qInfo("200 kB took %.1f s, %lld pieces", seconds(rig.channel.now() - begin), qint64(offsets.size()));
}

void TestBcflightBench::uploadStopsAtTheFirstRefusal_data()
{
    QTest::addColumn<int>("code");
    QTest::newRow("size") << 3;
    QTest::newRow("offset") << 4;
}

// Each further piece could be taken for commands.
void TestBcflightBench::uploadStopsAtTheFirstRefusal()
{
    QFETCH(int, code);
    Rig rig;
    QVERIFY(rig.calibrate());
    rig.watched().onSend = [&](QByteArray &packet) {
        if (Rig::idOf(packet) == int(Message::UploadData) && rig.offsets().last() == 5 * kPiece)
            packet[packet.size() - 1] = char(code);
        return true;
    };
    const auto done = rig.upload(imageOf(20 * kPiece));
    QVERIFY(!done);
    QCOMPARE(done.error().code, ErrorCode::BoardError);
    QCOMPARE(done.error().boardCode, code);
    QVERIFY2(tellsSilence(done.error()), qPrintable(done.error().detail));
    QCOMPARE(rig.offsets().last(), 5 * kPiece);
    QCOMPARE(rig.offsets().count(5 * kPiece), 1);
    std::ignore = rig.channel.sleep(2s);
    QCOMPARE(rig.offsets().size(), 6);
    QCOMPARE(rig.countOf(Message::UploadProcess), 0);
}

void TestBcflightBench::silenceIsBounded()
{
    Rig rig;
    QVERIFY(rig.identify());
    rig.losesPacket = [](const QByteArray &packet) {
        return Rig::idOf(packet) == int(Message::UploadData) && Rig::offsetOf(packet) >= 4 * kPiece;
    };
    const TimePoint begin = rig.channel.now();
    const auto done = rig.upload(imageOf(20 * kPiece));
    QVERIFY(!done);
    QCOMPARE(done.error().code, ErrorCode::Timeout);
    QVERIFY(tellsSilence(done.error()));
    QVERIFY(rig.channel.now() - begin < 6s);
    QCOMPARE(rig.offsets().last(), 4 * kPiece);
    QCOMPARE(rig.countOf(Message::UploadProcess), 0);
}

void TestBcflightBench::cancelLeavesASilentStream()
{
    Rig rig;
    QVERIFY(rig.identify());
    QVERIFY(rig.streamGoesOn() > 50);
    rig.channel.setOperator([&](const Progress &progress) {
        if (progress.done > 0 && progress.step == u"firmware-upload"_s)
            rig.channel.cancelAfter(0s);
    });
    const QByteArray before = rig.drone().firmware();
    const auto done = rig.upload(imageOf(300 * kPiece));
    QVERIFY(!done);
    QCOMPARE(done.error().code, ErrorCode::Cancelled);
    QVERIFY2(tellsSilence(done.error()), qPrintable(done.error().detail));
    QVERIFY(rig.offsets().size() < 300);
    QCOMPARE(rig.drone().firmware(), before);
    // What was told is so: it answers, and streams nothing until it restarts.
    rig.channel.cancelAfter(1h);
    QCOMPARE(rig.streamGoesOn(), 0);
    QVERIFY(rig.perform("status"));
    QVERIFY(rig.port.change(u"reset=0.1"_s));
    rig.channel.expectSilence(10s);
    std::ignore = rig.channel.sleep(milliseconds(int(1000 * Drone::kRestartTime) + 2000));
    QVERIFY(rig.streamGoesOn() > 50);
}

// What has begun to replace the program is seen through.
void TestBcflightBench::restartIsNotCancelled()
{
    Rig rig;
    QVERIFY(rig.identify());
    rig.channel.setOperator([&](const Progress &progress) {
        if (progress.step == u"firmware-restart"_s)
            rig.channel.cancelAfter(200ms);
    });
    const auto done = rig.upload(imageOf(4 * kPiece));
    QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
    QCOMPARE(done->value(u"firmware"_s).toString(), u"3.1"_s);
}

void TestBcflightBench::armedMeanwhileIsNotRestarted()
{
    Rig rig;
    QVERIFY(rig.calibrate());
    rig.channel.setOperator([&](const Progress &progress) {
        if (progress.step == u"firmware-upload"_s)
            rig.armByAnother();
    });
    const auto done = rig.upload(imageOf(4 * kPiece));
    QVERIFY(!done);
    QCOMPARE(done.error().code, ErrorCode::ConditionUnmet);
    QVERIFY2(done.error().detail.contains(u"armed"_s) && tellsSilence(done.error()),
             qPrintable(done.error().detail));
    QCOMPARE(rig.countOf(Message::UploadProcess), 0);
    QVERIFY(rig.drone().isArmed());
}

void TestBcflightBench::droneThatStaysIsTold()
{
    Rig rig;
    QVERIFY(rig.identify());
    rig.losesPacket
        = [](const QByteArray &packet) { return Rig::idOf(packet) == int(Message::UploadProcess); };
    const auto done = rig.upload(imageOf(4 * kPiece));
    QVERIFY(!done);
    QCOMPARE(done.error().code, ErrorCode::NotSeen);
    QVERIFY2(done.error().detail.contains(u"has not restarted"_s) && tellsSilence(done.error()),
             qPrintable(done.error().detail));
}

void TestBcflightBench::droneThatDoesNotComeBackIsTold()
{
    Rig rig;
    QVERIFY(rig.identify());
    bool isGone = false;
    rig.losesPacket = [&](const QByteArray &packet) {
        const bool lost = isGone;
        isGone |= Rig::idOf(packet) == int(Message::UploadProcess);
        return lost;
    };
    const TimePoint begin = rig.channel.now();
    const auto done = rig.upload(imageOf(4 * kPiece));
    QVERIFY(!done);
    QCOMPARE(done.error().code, ErrorCode::NotSeen);
    QVERIFY2(done.error().detail.contains(u"has not come back"_s) && !tellsSilence(done.error()),
             qPrintable(done.error().detail));
    QVERIFY(rig.channel.now() - begin > 60s);
}

// Packets get lost: a drone that leaves one question unanswered has not gone.
void TestBcflightBench::lostAnswerIsNoRestart()
{
    Rig rig;
    QVERIFY(rig.identify());
    QRandomGenerator random(7);
    rig.losesPacket = [&random](const QByteArray &packet) {
        return Rig::idOf(packet) == int(Message::UploadProcess) || random.bounded(5) == 0;
    };
    const auto done = rig.upload(imageOf(4 * kPiece));
    QVERIFY(!done);
    QVERIFY2(done.error().detail.contains(u"has not restarted"_s), qPrintable(done.error().detail));
}

void TestBcflightBench::stopIsHeardFirst_data()
{
    QTest::addColumn<QString>("action");
    QTest::addColumn<double>("deaf");
    QTest::addColumn<double>("pressedAt");
    QTest::addColumn<QString>("fault");
    QTest::newRow("motor test") << u"motor.test"_s << Drone::kMotorTestTime << 3.0 << QString();
    QTest::newRow("motor test, late") << u"motor.test"_s << Drone::kMotorTestTime << 7.8 << QString();
    QTest::newRow("motor test, packets lost")
        << u"motor.test"_s << Drone::kMotorTestTime << 3.0 << u"lose=0.3"_s;
    QTest::newRow("motor controllers")
        << u"escs.calibrate"_s << Drone::kEscCalibrationTime << 12.0 << QString();
}

// Whoever presses the red button while the drone is deaf: of all that has queued up, it carries out the stop
// first, and nothing but the stop is there.
void TestBcflightBench::stopIsHeardFirst()
{
    QFETCH(QString, action);
    QFETCH(double, deaf);
    QFETCH(double, pressedAt);
    QFETCH(QString, fault);
    Rig rig;
    QVERIFY(rig.calibrate());
    TimePoint begin{};
    double deafSince = 0;
    bool isPressed = false;
    int outside = 0;
    rig.channel.setOperator([&](const Progress &progress) {
        if (progress.step == u"calibrate-drone"_s)
            return;
        if (begin == TimePoint{}) {
            begin = rig.channel.now();
            deafSince = rig.drone().now();
        }
        if (!isPressed && seconds(rig.channel.now() - begin) >= pressedAt - 0.2) {
            isPressed = true;
            if (!fault.isEmpty())
                QVERIFY(rig.port.change(fault));
            rig.watched().onReceive = [&](QByteArray &packet) {
                const bool isDeaf = rig.drone().now() < deafSince + deaf - 0.1;
                outside += isDeaf && packet != QByteArray::fromHex("0047") ? 1 : 0;
                return true;
            };
            rig.channel.stopMotors(rig.device.stopPlan());
        }
    });
    std::ignore = rig.perform(qPrintable(action), {{u"motor"_s, 1}});
    QVERIFY(isPressed);
    QCOMPARE(outside, 0);
    const auto &handled = rig.drone().handled();
    const auto first = std::find_if(handled.begin(), handled.end(), [&](const Drone::Handled &each) {
        return each.at > deafSince + deaf - 0.1;
    });
    QVERIFY(first != handled.end());
    QVERIFY2(first->id == Message::ResetMotors, findMessage(first->id)->name);
    QVERIFY2(first->at < deafSince + deaf + 0.1, qPrintable(QString::number(first->at - deafSince)));
    // And it is proven then.
    QVERIFY(rig.port.change(u"lose=0"_s));
    std::ignore = rig.channel.sleep(2s);
    QVERIFY(rig.channel.stopResult() && *rig.channel.stopResult());
    QVERIFY(!rig.drone().isLost());
}

// Cancelled, it would be deaf all the same, and what comes next would queue up behind the test.
void TestBcflightBench::deafTimeIsNotCutShort()
{
    Rig rig;
    QVERIFY(rig.calibrate());
    rig.channel.setOperator([&](const Progress &progress) {
        if (progress.step == u"motor-test"_s)
            rig.channel.cancelAfter(0s);
    });
    const TimePoint begin = rig.channel.now();
    const auto done = rig.perform("motor.test", {{u"motor"_s, 1}});
    QVERIFY(!done);
    QCOMPARE(done.error().code, ErrorCode::Cancelled);
    QVERIFY(rig.channel.now() - begin >= 8s);
}

void TestBcflightBench::motorsBeepUntilTheyAreTold()
{
    Rig rig;
    QVERIFY(rig.identify());
    QVERIFY(rig.perform("motors.beep", {{u"on"_s, true}}));
    std::ignore = rig.channel.sleep(3s);
    QVERIFY(rig.drone().isBeeping());
    QVERIFY(rig.perform("motors.beep", {{u"on"_s, false}}));
    std::ignore = rig.channel.sleep(20ms);
    QVERIFY(!rig.drone().isBeeping());
}

QTEST_GUILESS_MAIN(TestBcflightBench)
#include "tst_bcflightbench.moc"
