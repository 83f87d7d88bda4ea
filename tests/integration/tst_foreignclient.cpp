// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/patience.h"
#include "tests/support/simprocess.h"

#include <QElapsedTimer>
#include <QFileInfo>
#include <QTemporaryDir>

#include <cmath>
#include <fcntl.h>
#include <functional>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

using namespace Qt::StringLiterals;

namespace {

/// A program that knows nothing of our code: opens the terminal, speaks the document's bytes by hand.
class Foreigner
{
public:
    explicit Foreigner(const QString &path, speed_t speed = B115200)
        : m_fd(::open(path.toLocal8Bit().constData(), O_RDWR | O_NOCTTY))
    {
        termios settings{};
        ::tcgetattr(m_fd, &settings);
        ::cfmakeraw(&settings);
        ::cfsetspeed(&settings, speed);
        settings.c_cc[VMIN] = 0;
        settings.c_cc[VTIME] = 0;
        ::tcsetattr(m_fd, TCSANOW, &settings);
    }
    ~Foreigner() { ::close(m_fd); }
    Foreigner(const Foreigner &) = delete;
    Foreigner &operator=(const Foreigner &) = delete;
    [[nodiscard]] bool isOpen() const { return m_fd >= 0; }

    void send(const QByteArray &bytes)
    {
        [[maybe_unused]] const auto n = ::write(m_fd, bytes.constData(), size_t(bytes.size()));
    }

    /// Version 1 frame: '>' id size sum, body, sum of the body (document "Message format").
    void command(int id, const QByteArray &body = {})
    {
        QByteArray frame;
        frame.append('>')
            .append(char(id))
            .append(char(body.size()))
            .append(char((id + body.size()) & 0xFF))
            .append(body);
        unsigned sum = 0;
        for (const char byte : body)
            sum += quint8(byte);
        send(frame.append(char(sum & 0xFF)));
    }

    /// The next bytes, not more than so many; fewer when no more come within that time. What came with
    /// them stays for the next call: a board that talks unasked may send in the same moment.
    QByteArray receive(int ms, qsizetype most = 1 << 20)
    {
        fill(ms, most);
        const QByteArray bytes = m_pending.left(most);
        m_pending.remove(0, bytes.size());
        return bytes;
    }

    /// Body of the next frame with that id.
    QByteArray reply(int id, int ms = kPatience)
    {
        QElapsedTimer timer;
        timer.start();
        while (timer.elapsed() < ms) {
            fill(20, m_pending.size() + 1);
            for (qsizetype at = m_pending.indexOf('>'); at >= 0 && at + 4 < m_pending.size();
                 at = m_pending.indexOf('>', at + 1)) {
                const int length = quint8(m_pending[at + 2]);
                if (quint8(m_pending[at + 3]) != ((quint8(m_pending[at + 1]) + length) & 0xFF)
                    || m_pending.size() < at + 5 + length)
                    continue;
                const int found = quint8(m_pending[at + 1]);
                const QByteArray body = m_pending.mid(at + 4, length);
                m_pending.remove(0, at + 5 + length);
                if (found == id)
                    return body;
                at = -1;
            }
        }
        return {};
    }

private:
    void fill(int ms, qsizetype enough)
    {
        QElapsedTimer timer;
        timer.start();
        while (timer.elapsed() < ms && m_pending.size() < enough) {
            pollfd port{m_fd, POLLIN, 0};
            if (::poll(&port, 1, 10) <= 0)
                continue;
            char buffer[4096];
            const ssize_t count = ::read(m_fd, buffer, sizeof buffer);
            if (count > 0)
                m_pending.append(buffer, count);
        }
    }

    int m_fd;
    QByteArray m_pending;
};

int word(const QByteArray &bytes, int at)
{
    return qint16(quint8(bytes[at]) | quint8(bytes[at + 1]) << 8);
}

/// X.25 as the STorM32 document's supplement has it (section 2), worked out here once more.
QByteArray withChecksum(const QByteArray &bytes)
{
    unsigned crc = 0xFFFF;
    for (const char byte : bytes) {
        crc ^= quint8(byte);
        for (int bit = 0; bit < 8; ++bit)
            crc = crc & 1 ? crc >> 1 ^ 0x8408 : crc >> 1;
    }
    return bytes + char(crc & 0xFF) + char(crc >> 8);
}

bool isChecked(const QByteArray &data)
{
    return data.size() > 2 && withChecksum(data.chopped(2)) == data;
}

/// How much comes per second. A machine that stands still for a moment has windows that are too full and too
/// empty, a wrong rate has only wrong ones: the first window between the two is taken, else the last.
double rate(const std::function<double()> &window, double lowest, double highest)
{
    double found = 0;
    for (int i = 0; i < 10 && (found < lowest || found > highest); ++i) {
        QElapsedTimer timer;
        timer.start();
        const double count = window();
        found = count / (double(timer.elapsed()) / 1000.0);
    }
    return found;
}

}  // namespace

class TestForeignClient : public QObject
{
    Q_OBJECT
private slots:
    void connectsReadsWritesStreamsAndMoves();
    void oldBoardKnowsNothingLater();
    void tooMuchOfCustomIsRefused();
    void speaksStorm_data();
    void speaksStorm();
    void fullRateOnNativeUsb();
    void uartIsThrottled();
    void wrongRateIsNotUnderstood();
    void badArguments_data();
    void badArguments();
    void pathIsRemovedAtTheEnd();
};

void TestForeignClient::connectsReadsWritesStreamsAndMoves()
{
    QTemporaryDir dir;
    const QString path = dir.filePath(u"gimbal"_s);
    SimProcess simulator({u"--pty"_s, path});
    QVERIFY(!simulator.address().isEmpty());
    Foreigner client(path);
    QVERIFY(client.isOpen());

    // Errata section 8, to the byte: BOARD_INFO.
    client.send(QByteArray::fromHex("3E56005600"));
    const QByteArray info = client.reply(86);
    QCOMPARE(info.size(), 18);
    QCOMPARE(int(quint8(info[0])), 30);
    QCOMPARE(word(info, 1), 2590);

    client.command(21, QByteArray(1, '\xFF'));
    QByteArray params = client.reply(21);
    QCOMPARE(params.size(), 134);
    QCOMPARE(int(params[1]), 35);
    params[1] = 47;
    client.command(22, params);
    QCOMPARE(client.reply(67), QByteArray(1, char(22)));
    client.command(21, QByteArray(1, '\x00'));
    QCOMPARE(int(client.reply(21)[1]), 47);

    // REALTIME_DATA_4 each 20 ms: the errata's example frame.
    client.send(QByteArray::fromHex("3E55156A191400") + QByteArray(18, '\0') + QByteArray::fromHex("2D"));
    QCOMPARE(client.reply(67), QByteArray(1, char(85)));
    const auto frames = [&client] {
        QElapsedTimer timer;
        timer.start();
        int count = 0;
        while (timer.elapsed() < 1000)
            count += client.reply(25, 100).size() == 124;
        return count;
    };
    const double each = rate(frames, 44, 54);
    QVERIFY2(each >= 44 && each <= 54, qPrintable(QString::number(each)));
    client.command(85, QByteArray::fromHex("190000") + QByteArray(18, '\0'));

    // CONTROL, 13-byte form: mode 2, yaw -45° at 30 °/s.
    client.send(QByteArray::fromHex("3E430D500200000000F6008E03F60000F877"));
    QVERIFY(!client.reply(67).isEmpty());
    QByteArray angles;
    double fastest = 0;  // the speed of yaw's target, while it is on its way
    const auto isThere = [&] {
        client.command(73);
        angles = client.reply(73);
        if (angles.size() == 18)
            fastest = std::max(fastest, std::abs(word(angles, 16) * 0.1220740379));
        return angles.size() == 18 && std::abs(word(angles, 12) * 0.02197265625 + 45.0) < 1.0
            && std::abs(word(angles, 6) * 0.02197265625 - 20.0) < 1.0;
    };
    QTRY_VERIFY(isThere());
    QVERIFY2(std::abs(fastest - 30.0) < 2.0, qPrintable(QString::number(fastest)));
    QTRY_VERIFY(isThere() && word(angles, 16) == 0);
    const double yaw = word(angles, 12) * 0.02197265625;
    QVERIFY2(std::abs(yaw + 45.0) < 3.0, qPrintable(QString::number(yaw)));
    const double pitch = word(angles, 6) * 0.02197265625;
    QVERIFY2(std::abs(pitch - 20.0) < 3.0, qPrintable(QString::number(pitch)));

    // A damaged frame is not answered, the next one is.
    client.send(QByteArray::fromHex("3E56005700"));
    client.command(73);
    QCOMPARE(client.reply(73).size(), 18);
}

// The document dates GET_ANGLES_EXT and PARAMS_EXT2; old firmware does not answer what it does not know.
void TestForeignClient::oldBoardKnowsNothingLater()
{
    QTemporaryDir dir;
    const QString path = dir.filePath(u"old"_s);
    SimProcess simulator({u"--pty"_s, path, u"--firmware"_s, u"2.43b9"_s});
    QVERIFY(!simulator.address().isEmpty());
    Foreigner client(path);
    for (const int id : {61, 62}) {
        client.command(id, id == 62 ? QByteArray(1, '\0') : QByteArray());
        client.command(73);
        QCOMPARE(client.reply(73).size(), 18);
        QVERIFY(client.reply(id, 300).isEmpty());
    }
}

// What no frame can carry is refused, not sent damaged.
void TestForeignClient::tooMuchOfCustomIsRefused()
{
    QTemporaryDir dir;
    const QString path = dir.filePath(u"later"_s);
    SimProcess simulator({u"--pty"_s, path, u"--firmware"_s, u"2.73.8"_s});
    QVERIFY(!simulator.address().isEmpty());
    Foreigner client(path);
    client.command(88, QByteArray::fromHex("FFFFFF3F") + QByteArray(6, '\0'));
    QCOMPARE(client.reply(255).left(2), QByteArray::fromHex("5802"));
    client.command(88, QByteArray::fromHex("01000000") + QByteArray(6, '\0'));
    QCOMPARE(client.reply(88).size(), 8);
}

void TestForeignClient::speaksStorm_data()
{
    QTest::addColumn<QString>("firmware");
    QTest::addColumn<int>("layout");
    QTest::addColumn<int>("words");
    QTest::newRow("0.79") << u"0.79"_s << 78 << 124;
    QTest::newRow("0.90") << u"0.90"_s << 89 << 125;
    QTest::newRow("0.96") << u"0.96"_s << 95 << 125;
}

// Simple, RC and MAVLink commands, what is refused and how, the lock-out and the way out (errata 2, 3, 4, 6).
void TestForeignClient::speaksStorm()
{
    QFETCH(QString, firmware);
    QFETCH(int, layout);
    QFETCH(int, words);
    QTemporaryDir dir;
    const QString path = dir.filePath(u"gimbal"_s);
    SimProcess simulator({u"--pty"_s, path, u"--firmware"_s, firmware, u"--rate"_s, u"115200"_s},
                         u"storm32"_s);
    QVERIFY(!simulator.address().isEmpty());
    Foreigner client(path);
    QVERIFY(client.isOpen());
    const auto ask = [&client](const QByteArray &bytes, qsizetype size, int ms = kPatience) {
        client.send(bytes);
        return client.receive(ms, size);
    };
    const auto hex = [](const char *text) { return QByteArray::fromHex(text); };

    QCOMPARE(ask("t", 1), "o");
    const QByteArray version = ask("v", 57);
    QCOMPARE(version.size(), 57);
    QVERIFY(version.endsWith('o') && isChecked(version.left(56)));
    QCOMPARE(word(version, 50), layout);
    const QByteArray stream = ask("g", 2 * words + 128 + 3);
    QCOMPARE(stream.size(), 2 * words + 128 + 3);
    QVERIFY(stream.endsWith('o') && isChecked(stream.chopped(1)));
    QCOMPARE(word(stream, 2 * 82), 25);  // nobody's word, kept as read
    const QByteArray live = ask("d", 67);
    QVERIFY(live.size() == 67 && live.endsWith('o') && isChecked(live.left(66)));
    QCOMPARE(word(live, 12), 1500);
    const QByteArray status = ask("s", 13);
    QVERIFY(status.size() == 13 && status.endsWith('o') && isChecked(status.left(12)));

    // Writing: accepted whole, refused when damaged, given up when cut off.
    QByteArray changed = stream.left(2 * words + 128);
    changed[0] = char(0x9A);
    QCOMPARE(ask("p" + withChecksum(changed), 1), "o");
    QCOMPARE(ask(hex("fa0203000000001234").left(7), 9).left(7),
             hex("fb0403") + hex("0000") + hex("9a01"));  // any checksum will do
    QByteArray damaged = withChecksum(changed);
    damaged[4] = char(damaged[4] ^ 1);
    QCOMPARE(ask("p" + damaged, 1), "c");
    QCOMPARE(ask("p" + changed.left(10), 1), "t");
    QCOMPARE(ask("xZ", 2, 400), "e");
    QCOMPARE(ask("UUUUU", 5), "eeeee");
    QCOMPARE(ask(hex("fa02"), 1), "t");

    // The examples of section 2, byte by byte.
    QCOMPARE(ask(hex("fa000131e1"), 11).left(3), hex("fb0601"));
    QCOMPARE(ask(hex("fa020ae803ef5c"), 6), hex("fb019600622e"));
    QCOMPARE(ask(hex("fa0211e8030000"), 6), hex("fb019698a336"));
    QCOMPARE(ask(hex("fa014d000000"), 6), hex("fb019603f91c"));

    // The heartbeat locks plain commands out of the UART, and embedding is the way back (section 6).
    QCOMPARE(ask(hex("fa0404") + hex("70000100") + hex("0000"), 6), hex("fb019600622e"));
    client.send("t");
    QByteArray beats = client.receive(2500);
    QVERIFY2(beats.contains(hex("fe09")), beats.toHex().constData());
    while (beats.startsWith(char(0xFE)))  // the last one may be cut off
        beats.remove(0, beats.size() > 1 ? 8 + quint8(beats[1]) : 1);
    QVERIFY2(beats.isEmpty(), beats.toHex().constData());  // and no answer between them
    client.send(hex("fe03005243ea4743746893"));  // embedded t
    QVERIFY(client.receive(2000).contains(hex("4743eb52436f")));
    // Embedded RC command 4: FA 04, parameter 112, value 0; its checksum ends with the message's own byte,
    // 152.
    const QByteArray inner = hex("08005243ea4743") + hex("fa0470000000");
    const QByteArray checked = withChecksum(inner + char(152));
    client.send(QByteArray(1, char(0xFE)) + inner + checked.right(2));
    QVERIFY(client.receive(2000).contains(hex("fb9600")));
    QCOMPARE(ask("t", 1), "o");
}

void TestForeignClient::fullRateOnNativeUsb()
{
    QTemporaryDir dir;
    const QString path = dir.filePath(u"gimbal"_s);
    SimProcess simulator({u"--pty"_s, path});
    Foreigner client(path);
    // REALTIME_DATA_CUSTOM with gyro, each cycle: 2 + 6 bytes and 5 around them.
    client.command(85,
                   QByteArray::fromHex("580100") + QByteArray::fromHex("10000000") + QByteArray(14, '\0'));
    client.receive(300);
    const double each = rate([&client] { return double(client.receive(2000).size()) / 13.0; }, 1190, 1310);
    QVERIFY2(std::abs(each - 1250.0) < 60.0, qPrintable(QString::number(each)));
}

void TestForeignClient::uartIsThrottled()
{
    QTemporaryDir dir;
    const QString path = dir.filePath(u"gimbal"_s);
    SimProcess simulator({u"--pty"_s, path, u"--rate"_s, u"115200"_s});
    Foreigner client(path);
    client.command(85, QByteArray::fromHex("190100") + QByteArray(18, '\0'));
    client.receive(300);
    // 11520 bytes per second at 8N1, whatever is streamed.
    const double perSecond
        = rate([&client] { return double(client.receive(2000).size()); }, 11520 * 0.85, 11520 * 1.06);
    QVERIFY2(perSecond < 11520 * 1.06 && perSecond > 11520 * 0.85, qPrintable(QString::number(perSecond)));
}

void TestForeignClient::wrongRateIsNotUnderstood()
{
    QTemporaryDir dir;
    const QString path = dir.filePath(u"gimbal"_s);
    SimProcess simulator({u"--pty"_s, path, u"--rate"_s, u"57600"_s});
    {
        Foreigner wrong(path, B115200);
        wrong.command(86);
        QVERIFY(wrong.reply(86, 500).isEmpty());
    }
    Foreigner right(path, B57600);
    right.command(86);
    QCOMPARE(right.reply(86, 1000).size(), 18);
}

void TestForeignClient::badArguments_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<QString>("says");
    const QStringList family{u"--family"_s, u"simplebgc"_s};
    QTest::newRow("nothing") << QStringList() << u"--family"_s;
    QTest::newRow("no place") << family << u"--pty"_s;
    QTest::newRow("two places") << family + QStringList{u"--pty"_s, u"/tmp/x"_s, u"--tcp"_s, u"1"_s}
                                << u"one of"_s;
    QTest::newRow("family") << QStringList{u"--family"_s, u"toaster"_s, u"--tcp"_s, u"0"_s} << u"toaster"_s;
    QTest::newRow("port") << family + QStringList{u"--tcp"_s, u"99999"_s} << u"65535"_s;
    QTest::newRow("firmware") << family + QStringList{u"--tcp"_s, u"0"_s, u"--firmware"_s, u"new"_s}
                              << u"2.59"_s;
    QTest::newRow("fault name") << family + QStringList{u"--tcp"_s, u"0"_s, u"--fault"_s, u"magic=1"_s}
                                << u"unplug"_s;
    QTest::newRow("fault value") << family + QStringList{u"--tcp"_s, u"0"_s, u"--fault"_s, u"lose=2"_s}
                                 << u"0 to 1"_s;
    QTest::newRow("parity alone") << family + QStringList{u"--tcp"_s, u"0"_s, u"--parity"_s, u"even"_s}
                                  << u"--rate"_s;
    QTest::newRow("option") << family + QStringList{u"--tcp"_s, u"0"_s, u"--colour"_s} << u"colour"_s;
    QTest::newRow("word") << family + QStringList{u"--tcp"_s, u"0"_s, u"please"_s} << u"please"_s;
}

void TestForeignClient::badArguments()
{
    QFETCH(QStringList, arguments);
    QFETCH(QString, says);
    QProcess process;
    process.start(QStringLiteral(GIMBAL_BIN_DIR "/gimbalsim"), arguments);
    QVERIFY(QTest::qWaitFor([&process] { return process.state() == QProcess::NotRunning; }, kPatience));
    QCOMPARE(process.exitCode(), 2);
    const QString error = QString::fromUtf8(process.readAllStandardError());
    QVERIFY2(error.contains(says), qPrintable(error));
    QVERIFY(process.readAllStandardOutput().isEmpty());
}

void TestForeignClient::pathIsRemovedAtTheEnd()
{
    QTemporaryDir dir;
    const QString path = dir.filePath(u"gimbal"_s);
    {
        SimProcess simulator({u"--pty"_s, path});
        QVERIFY(QFileInfo(path).isSymLink());
        // A second one does not take the path away.
        SimProcess second({u"--pty"_s, path});
        QVERIFY(second.address().isEmpty());
        QCOMPARE(second.process().exitCode(), 1);
        QVERIFY(QFileInfo(path).isSymLink());
        QCOMPARE(simulator.stop(), 0);
    }
    QVERIFY(!QFileInfo(path).isSymLink());
}

QTEST_GUILESS_MAIN(TestForeignClient)
#include "tst_foreignclient.moc"
