// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/transport/portlist.h"
#include "protocol/transport/systemtransport.h"
#include "tests/support/patience.h"

#include <QNetworkDatagram>
#include <QSignalSpy>
#include <QTcpServer>
#include <QTcpSocket>
#include <QTest>
#include <QUdpSocket>

#include <cstdlib>
#include <fcntl.h>
#include <unistd.h>

using namespace Qt::StringLiterals;

Q_DECLARE_METATYPE(LinkAddress::Kind)

namespace {

/// The other end of a serial cable.
class PseudoTerminal
{
public:
    PseudoTerminal()
        : m_handle(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK))
    {
        if (m_handle < 0 || ::grantpt(m_handle) != 0 || ::unlockpt(m_handle) != 0)
            qFatal("no pseudo-terminal");
        m_path = QString::fromLocal8Bit(::ptsname(m_handle));
    }
    ~PseudoTerminal() { hangUp(); }
    PseudoTerminal(const PseudoTerminal &) = delete;
    PseudoTerminal &operator=(const PseudoTerminal &) = delete;

    [[nodiscard]] const QString &path() const { return m_path; }
    void write(const QByteArray &bytes) const
    {
        QCOMPARE(::write(m_handle, bytes.constData(), std::size_t(bytes.size())), ssize_t(bytes.size()));
    }
    /// What has come so far.
    const QByteArray &read()
    {
        std::array<char, 4096> buffer;
        for (;;) {
            const ssize_t count = ::read(m_handle, buffer.data(), buffer.size());
            if (count <= 0)
                return m_read;
            m_read.append(buffer.data(), count);
        }
    }
    void hangUp()
    {
        if (m_handle >= 0)
            ::close(std::exchange(m_handle, -1));
    }

private:
    int m_handle;
    QString m_path;
    QByteArray m_read;
};

/// A transport and what it says.
struct Link
{
    explicit Link(const QString &address)
        : transport(std::move(makeSystemTransport(LinkAddress::parse(address).value()).value()))
        , opened(transport.get(), &Transport::opened)
        , closed(transport.get(), &Transport::closed)
    {
        QObject::connect(transport.get(), &Transport::received, transport.get(),
                         [this](QByteArrayView bytes, TimePoint at) {
                             pieces.append(bytes.toByteArray());
                             times.push_back(at);
                         });
        QObject::connect(transport.get(), &Transport::bytesWritten, transport.get(),
                         [this](qint64 count) { written += count; });
    }
    bool open()
    {
        transport->open();
        return QTest::qWaitFor([this] { return opened.count() + closed.count() > 0; }) && opened.count() == 1;
    }
    [[nodiscard]] QByteArray received() const { return pieces.join(); }
    [[nodiscard]] Error why() const { return closed.first().first().value<Error>(); }

    std::unique_ptr<Transport> transport;
    QSignalSpy opened;
    QSignalSpy closed;
    QByteArrayList pieces;
    std::vector<TimePoint> times;
    qint64 written = 0;
};

QByteArray everyByte(int times)
{
    QByteArray bytes;
    for (int i = 0; i < 256 * times; ++i)
        bytes.append(char(i));
    return bytes;
}

}  // namespace

/// Addresses and the kinds of links that carry bytes, each against a peer of the system's own.
class TestTransport : public QObject
{
    Q_OBJECT
private slots:
    void addressesThereAndBack_data();
    void addressesThereAndBack();
    void partsOfAnAddress_data();
    void partsOfAnAddress();
    void badAddressesAreExplained_data();
    void badAddressesAreExplained();
    void madeAddressesAreSpelledOut();
    void lineSettingsTellTheTime();
    void portsAreNamedWithTheirNumbers();
    void onlySystemLinksAreMade();
    void tcpCarriesBytesBothWays();
    void tcpPeerGoes();
    void tcpIsClosedByUs();
    void nobodyListens_data();
    void nobodyListens();
    void udpKeepsDatagrams();
    void udpPassesEmptyDatagramsOver();
    void udpHearsItsPeerOnly();
    void serialCarriesBytesBothWays();
    void serialPeerGoes();
    void serialIsClosedAndOpenedAgain();
    void serialPortIsMissing();
};

void TestTransport::addressesThereAndBack_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("normal");
    QTest::newRow("serial") << u"serial:/dev/ttyUSB0?baud=115200&parity=none"_s
                            << u"serial:/dev/ttyUSB0?baud=115200&parity=none"_s;
    QTest::newRow("order of options")
        << u"serial:/dev/ttyUSB0?parity=even&baud=9600"_s << u"serial:/dev/ttyUSB0?baud=9600&parity=even"_s;
    QTest::newRow("bare path") << u"/dev/ttyACM0"_s << u"serial:/dev/ttyACM0"_s;
    QTest::newRow("bare path with rate") << u"/dev/ttyACM0?baud=9600"_s << u"serial:/dev/ttyACM0?baud=9600"_s;
    QTest::newRow("windows") << u"COM3"_s << u"serial:COM3"_s;
    QTest::newRow("tcp") << u"tcp://192.168.4.1:23"_s << u"tcp://192.168.4.1:23"_s;
    QTest::newRow("tcp6") << u"tcp://[::1]:2020"_s << u"tcp://[::1]:2020"_s;
    QTest::newRow("udp") << u"udp://drone:2020"_s << u"udp://drone:2020"_s;
    QTest::newRow("udp, usual port") << u"udp://drone"_s << u"udp://drone:2020"_s;
    QTest::newRow("udp6") << u"udp://[fe80::1]:65535"_s << u"udp://[fe80::1]:65535"_s;
    QTest::newRow("sim") << u"sim:simplebgc?seed=1"_s << u"sim:simplebgc?seed=1"_s;
    QTest::newRow("replay") << u"replay:/tmp/a flight.gimbalrec?speed=4"_s
                            << u"replay:/tmp/a flight.gimbalrec?speed=4"_s;
    QTest::newRow("replay, percent") << u"replay:50%20.gimbalrec"_s << u"replay:50%20.gimbalrec"_s;
    QTest::newRow("replay, question mark")
        << u"replay:/tmp/why?.gimbalrec?"_s << u"replay:/tmp/why?.gimbalrec?"_s;
    QTest::newRow("replay, question mark and speed")
        << u"replay:/tmp/why?.gimbalrec?speed=4"_s << u"replay:/tmp/why?.gimbalrec?speed=4"_s;
    QTest::newRow("question mark in an option")
        << u"sim:simplebgc?fault=a%3Fb"_s << u"sim:simplebgc?fault=a%3Fb"_s;
    QTest::newRow("option in code") << u"sim:simplebgc?fault=a%26b%3Dc%25d"_s
                                    << u"sim:simplebgc?fault=a%26b%3Dc%25d"_s;
    QTest::newRow("question mark alone") << u"sim:storm32?"_s << u"sim:storm32"_s;
}

void TestTransport::addressesThereAndBack()
{
    QFETCH(QString, text);
    QFETCH(QString, normal);
    const auto address = LinkAddress::parse(text);
    QVERIFY(address);
    QCOMPARE(address->toString(), normal);
    const auto again = LinkAddress::parse(normal);
    QVERIFY(again);
    QCOMPARE(*again, *address);
}

void TestTransport::partsOfAnAddress_data()
{
    using Kind = LinkAddress::Kind;
    QTest::addColumn<QString>("text");
    QTest::addColumn<Kind>("kind");
    QTest::addColumn<QString>("target");
    QTest::addColumn<int>("port");
    QTest::newRow("serial") << u"serial:COM12?baud=300"_s << Kind::Serial << u"COM12"_s << 0;
    QTest::newRow("tcp") << u"tcp://Board.local:1"_s << Kind::Tcp << u"board.local"_s << 1;
    QTest::newRow("tcp6") << u"tcp://[::1]:2020"_s << Kind::Tcp << u"::1"_s << 2020;
    QTest::newRow("udp") << u"udp://10.0.0.2:65535"_s << Kind::Udp << u"10.0.0.2"_s << 65535;
    QTest::newRow("sim") << u"sim:storm32?firmware=0.90&seed=3"_s << Kind::Simulator << u"storm32"_s << 0;
    QTest::newRow("replay") << u"replay:C:/a.gimbalrec"_s << Kind::Replay << u"C:/a.gimbalrec"_s << 0;
}

void TestTransport::partsOfAnAddress()
{
    QFETCH(QString, text);
    QFETCH(LinkAddress::Kind, kind);
    QFETCH(QString, target);
    QFETCH(int, port);
    const auto address = LinkAddress::parse(text);
    QVERIFY(address);
    QCOMPARE(address->kind(), kind);
    QCOMPARE(address->isReplay(), kind == LinkAddress::Kind::Replay);
    QCOMPARE(address->target(), target);
    QCOMPARE(int(address->port()), port);
    QCOMPARE(address->baud(), text.contains(u"baud"_s) ? std::optional(300) : std::nullopt);
    QVERIFY(!address->parity());
    QCOMPARE(address->option(u"firmware"_s), kind == LinkAddress::Kind::Simulator ? u"0.90"_s : QString());
}

void TestTransport::badAddressesAreExplained_data()
{
    QTest::addColumn<QString>("text");
    for (const char *text : {"",
                             " ",
                             "nonsense",
                             "tcp:host:99",
                             "tcp://host",
                             "tcp://:99",
                             "tcp://a:0",
                             "tcp://a:-1",
                             "tcp://a:70000",
                             "tcp://a:http",
                             "tcp://a b:99",
                             "tcp://[::1:99",
                             "tcp://host:1/path",
                             "udp://host:",
                             "udp://:1",
                             "sim:",
                             "serial:",
                             "serial:?baud=9600",
                             "replay:",
                             "serial:/dev/x?baud=fast",
                             "serial:/dev/x?baud=299",
                             "serial:/dev/x?baud=4000001",
                             "serial:/dev/x?baud=-9600",
                             "serial:/dev/x?baud=",
                             "serial:/dev/x?parity=odd",
                             "serial:/dev/x?parity=Even",
                             "sim:simplebgc?seed=",
                             "sim:simplebgc?seed",
                             "com3",
                             "ttyUSB0"})
        QTest::newRow(*text ? text : "nothing") << QString::fromLatin1(text);
}

void TestTransport::badAddressesAreExplained()
{
    QFETCH(QString, text);
    const auto address = LinkAddress::parse(text);
    QVERIFY(!address);
    QCOMPARE(address.error().code, ErrorCode::InvalidArgument);
    QVERIFY(!address.error().detail.isEmpty());
}

void TestTransport::madeAddressesAreSpelledOut()
{
    QCOMPARE(LinkAddress::serial(u"/dev/ttyUSB0"_s).toString(), u"serial:/dev/ttyUSB0"_s);
    const LinkAddress even = LinkAddress::serial(u"COM3"_s, 256000, Parity::Even);
    QCOMPARE(even.toString(), u"serial:COM3?baud=256000&parity=even"_s);
    QCOMPARE(even.baud(), std::optional(256000));
    QCOMPARE(even.parity(), std::optional(Parity::Even));
    QCOMPARE(LinkAddress::parse(even.toString()).value(), even);
    QCOMPARE(LinkAddress::serial(u"COM3"_s, {}, Parity::None).parity(), std::optional(Parity::None));
    QCOMPARE(LinkAddress::replay(u"a.gimbalrec"_s).toString(), u"replay:a.gimbalrec"_s);
    QVERIFY(LinkAddress::replay(u"a.gimbalrec"_s).isReplay());
    const LinkAddress why = LinkAddress::replay(u"/tmp/why?.gimbalrec"_s);
    QCOMPARE(LinkAddress::parse(why.toString()).value(), why);
    QCOMPARE(LinkAddress().toString(), QString());
    QCOMPARE(LinkAddress().kind(), LinkAddress::Kind::None);
}

void TestTransport::lineSettingsTellTheTime()
{
    // Start bit, eight data bits, stop bit; parity is one more.
    QCOMPARE((LineSettings{9600, Parity::None}.secondsFor(960)), 1.0);
    QCOMPARE((LineSettings{11000, Parity::Even}.secondsFor(1000)), 1.0);
    QCOMPARE((LineSettings{0, Parity::None}.secondsFor(1000)), 0.0);
    QCOMPARE(LineSettings().secondsFor(0), 0.0);
    QCOMPARE(LineSettings(), (LineSettings{115200, Parity::None}));
    QVERIFY(LineSettings() != (LineSettings{115200, Parity::Even}));
}

void TestTransport::portsAreNamedWithTheirNumbers()
{
    QCOMPARE((PortInfo{u"/dev/ttyUSB0"_s, u"CP2102"_s, 0x10C4, 0xEA60}.label()),
             u"/dev/ttyUSB0 – CP2102 – 10C4:EA60"_s);
    QCOMPARE((PortInfo{u"/dev/ttyS0"_s, {}, 0, 0}.label()), u"/dev/ttyS0"_s);
}

void TestTransport::onlySystemLinksAreMade()
{
    for (const QString &text : {u"sim:simplebgc"_s, u"replay:a.gimbalrec"_s}) {
        const auto made = makeSystemTransport(LinkAddress::parse(text).value());
        QVERIFY(!made);
        QCOMPARE(made.error().code, ErrorCode::InvalidArgument);
    }
    QVERIFY(!makeSystemTransport(LinkAddress()));
    QVERIFY(!makeSystemTransport(LinkAddress::parse(u"tcp://localhost:1"_s).value()).value()->line());
    const auto serial = makeSystemTransport(LinkAddress::serial(u"/dev/x"_s, 9600, Parity::Even));
    QCOMPARE(serial.value()->line(), std::optional(LineSettings{9600, Parity::Even}));
}

void TestTransport::tcpCarriesBytesBothWays()
{
    QTcpServer server;
    QVERIFY(server.listen(QHostAddress::LocalHost));
    Link link(u"tcp://127.0.0.1:%1"_s.arg(server.serverPort()));
    QVERIFY(link.open());
    QTRY_VERIFY(server.hasPendingConnections());
    QTcpSocket *peer = server.nextPendingConnection();
    const QByteArray sent = everyByte(1000);
    link.transport->write(sent);
    QTRY_COMPARE(peer->bytesAvailable(), sent.size());
    QCOMPARE(peer->readAll(), sent);
    QTRY_COMPARE(link.written, qint64(sent.size()));
    const TimePoint before = Clock::now();
    peer->write(sent);
    QTRY_COMPARE(link.received().size(), sent.size());
    QCOMPARE(link.received(), sent);
    // Each piece bears the time at which it arrived.
    QVERIFY(std::is_sorted(link.times.begin(), link.times.end()));
    QVERIFY(link.times.front() >= before && link.times.back() <= Clock::now());
    QVERIFY(link.transport->setLine({9600, Parity::Even}));  // makes no difference here
    QCOMPARE(link.closed.count(), 0);
}

void TestTransport::tcpPeerGoes()
{
    QTcpServer server;
    QVERIFY(server.listen(QHostAddress::LocalHost));
    Link link(u"tcp://localhost:%1"_s.arg(server.serverPort()));
    QVERIFY(link.open());
    QTRY_VERIFY(server.hasPendingConnections());
    QTcpSocket *peer = server.nextPendingConnection();
    peer->write("last words");
    peer->disconnectFromHost();
    QTRY_COMPARE(link.closed.count(), 1);
    QCOMPARE(link.received(), QByteArray("last words"));
    QCOMPARE(link.why().code, ErrorCode::LinkClosed);
    QVERIFY(!link.why().detail.isEmpty());
    link.transport->write("too late");
    link.transport->close();
    QCOMPARE(link.closed.count(), 1);
}

void TestTransport::tcpIsClosedByUs()
{
    QTcpServer server;
    QVERIFY(server.listen(QHostAddress::LocalHost));
    Link link(u"tcp://127.0.0.1:%1"_s.arg(server.serverPort()));
    QVERIFY(link.open());
    QTRY_VERIFY(server.hasPendingConnections());
    QTcpSocket *peer = server.nextPendingConnection();
    link.transport->write("motors off");
    link.transport->close();
    // What was written last still arrives, and nobody is told what he did himself.
    QTRY_COMPARE(peer->state(), QAbstractSocket::UnconnectedState);
    QCOMPARE(peer->readAll(), QByteArray("motors off"));
    QCOMPARE(link.closed.count(), 0);
}

void TestTransport::nobodyListens_data()
{
    QTest::addColumn<QString>("address");
    QTcpServer server;
    QVERIFY(server.listen(QHostAddress::LocalHost));
    QTest::newRow("refused") << u"tcp://127.0.0.1:%1"_s.arg(server.serverPort());
    QTest::newRow("no such host") << u"tcp://no-such-host.invalid:1"_s;
}

void TestTransport::nobodyListens()
{
    QFETCH(QString, address);
    Link link(address);
    link.transport->open();
    QTRY_COMPARE(link.closed.count(), 1);
    QCOMPARE(link.why().code, ErrorCode::HostUnreachable);
    QVERIFY(!link.why().detail.isEmpty());
    QCOMPARE(link.opened.count(), 0);
}

void TestTransport::udpKeepsDatagrams()
{
    QUdpSocket peer;
    QVERIFY(peer.bind(QHostAddress::LocalHost, 0));
    Link link(u"udp://127.0.0.1:%1"_s.arg(peer.localPort()));
    QVERIFY(link.open());
    link.transport->write("one");
    link.transport->write("two");
    QTRY_VERIFY(peer.hasPendingDatagrams());
    const QNetworkDatagram first = peer.receiveDatagram();
    QCOMPARE(first.data(), QByteArray("one"));
    QTRY_VERIFY(peer.hasPendingDatagrams());
    QCOMPARE(peer.receiveDatagram().data(), QByteArray("two"));
    const QByteArrayList sent{"a", everyByte(1), everyByte(200), "end"};
    for (const QByteArray &datagram : sent)
        QCOMPARE(peer.writeDatagram(first.makeReply(datagram)), datagram.size());
    QTRY_COMPARE(link.pieces.size(), sent.size());
    QCOMPARE(link.pieces, sent);
    link.transport->close();
    QCOMPARE(link.closed.count(), 0);
}

void TestTransport::udpPassesEmptyDatagramsOver()
{
    QUdpSocket peer;
    QVERIFY(peer.bind(QHostAddress::LocalHost, 0));
    Link link(u"udp://127.0.0.1:%1"_s.arg(peer.localPort()));
    QVERIFY(link.open());
    link.transport->write("hello");
    QTRY_VERIFY(peer.hasPendingDatagrams());
    const QNetworkDatagram hello = peer.receiveDatagram();
    // All of them are there before the first one is read.
    for (const QByteArray &datagram :
         {QByteArray("a"), QByteArray(), QByteArray("b"), QByteArray(), QByteArray("c")})
        QCOMPARE(peer.writeDatagram(hello.makeReply(datagram)), datagram.size());
    QTRY_COMPARE(link.received(), QByteArray("abc"));
    peer.writeDatagram(hello.makeReply({}));
    peer.writeDatagram(hello.makeReply("d"));
    QTRY_COMPARE(link.received(), QByteArray("abcd"));
}

void TestTransport::udpHearsItsPeerOnly()
{
    QUdpSocket peer;
    QUdpSocket stranger;
    QVERIFY(peer.bind(QHostAddress::LocalHost, 0) && stranger.bind(QHostAddress::LocalHost, 0));
    Link link(u"udp://127.0.0.1:%1"_s.arg(peer.localPort()));
    QVERIFY(link.open());
    link.transport->write("hello");
    QTRY_VERIFY(peer.hasPendingDatagrams());
    const QNetworkDatagram hello = peer.receiveDatagram();
    stranger.writeDatagram("not for you", hello.senderAddress(), quint16(hello.senderPort()));
    peer.writeDatagram(hello.makeReply("for you"));
    QTRY_COMPARE(link.received(), QByteArray("for you"));
}

void TestTransport::serialCarriesBytesBothWays()
{
    PseudoTerminal peer;
    Link link(u"serial:%1?baud=115200&parity=none"_s.arg(peer.path()));
    QVERIFY(link.open());
    // Every byte arrives as it is: nothing is taken for an end of line or a flow control character.
    const QByteArray sent = everyByte(8);
    link.transport->write(sent);
    QTRY_COMPARE(peer.read().size(), sent.size());
    QCOMPARE(peer.read(), sent);
    QTRY_COMPARE(link.written, qint64(sent.size()));
    peer.write(sent);
    QTRY_COMPARE(link.received().size(), sent.size());
    QCOMPARE(link.received(), sent);
    QVERIFY(link.transport->setLine({9600, Parity::None}));
    QCOMPARE(link.transport->line(), std::optional(LineSettings{9600, Parity::None}));
    link.transport->write("!");
    QTRY_COMPARE(peer.read(), sent + '!');
    QCOMPARE(link.closed.count(), 0);
}

void TestTransport::serialPeerGoes()
{
    PseudoTerminal peer;
    Link link(u"serial:"_s + peer.path());
    QVERIFY(link.open());
    peer.write("last words");
    QTRY_COMPARE(link.received(), QByteArray("last words"));
    peer.hangUp();
    QTRY_COMPARE(link.closed.count(), 1);
    QCOMPARE(link.why().code, ErrorCode::LinkClosed);
    link.transport->write("too late");
    link.transport->close();
    QCOMPARE(link.closed.count(), 1);
}

void TestTransport::serialIsClosedAndOpenedAgain()
{
    PseudoTerminal peer;
    Link link(u"serial:"_s + peer.path());
    link.transport->write("nobody there");  // not open yet
    QVERIFY(link.open());
    link.transport->close();
    QCOMPARE(link.closed.count(), 0);
    link.transport->open();
    QTRY_COMPARE(link.opened.count(), 2);
    link.transport->write("again");
    QTRY_COMPARE(peer.read(), QByteArray("again"));
}

void TestTransport::serialPortIsMissing()
{
    Link link(u"serial:/dev/no-such-port"_s);
    QVERIFY(!link.open());
    QCOMPARE(link.why().code, ErrorCode::PortNotFound);
    QVERIFY(!link.why().detail.isEmpty());
}

QTEST_GUILESS_MAIN(TestTransport)
#include "tst_transport.moc"
