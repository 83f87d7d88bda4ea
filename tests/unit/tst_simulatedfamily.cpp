// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/composition/composition.h"
#include "protocol/simulator/link/simulatedgimbals.h"
#include "protocol/simulator/link/simulatorsetup.h"
#include "protocol/simulator/link/udphost.h"
#include "tests/support/patience.h"

#include <QNetworkDatagram>
#include <QSignalSpy>
#include <QTest>
#include <QUdpSocket>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

/// Answers each packet with its number and the packet, in two packets.
class EchoBoard final : public SimulatedBoard
{
public:
    [[nodiscard]] bool isPacketBased() const override { return true; }
    void receive(Bytes bytes) override
    {
        m_output.append(QByteArray::number(++m_received));
        m_output.append(toByteArray(bytes));
    }
    void cycle() override { }
    QByteArray takeOutput(qsizetype) override
    {
        return m_output.isEmpty() ? QByteArray() : m_output.takeFirst();
    }
    [[nodiscard]] bool isRunning() const override { return true; }
    void setFaults(const Faults &) override { }

private:
    int m_received = 0;
    QList<QByteArray> m_output;
};

SimulatedFamily echoFamily()
{
    return {u"echo"_s,
            {LinkAddress::Kind::Udp},
            {u"1 (default)"_s,
             [](const QString &text) -> Result<int> {
                 if (text == u"1"_s)
                     return 1;
                 return failure(ErrorCode::InvalidArgument, u"firmware is 1, not '%1'"_s.arg(text));
             }},
            {},
            [](const SimulatorOptions &) { return std::make_unique<EchoBoard>(); }};
}

std::unique_ptr<SimulatedPort> echoPort(const QStringList &faults = {})
{
    const auto setup = parseSimulatorSetup(echoFamily(), {}, faults);
    return std::make_unique<SimulatedPort>(std::make_unique<EchoBoard>(), setup->options, setup->line());
}

/// Whether the program was built with this family.
bool isBuiltIn(const QString &family)
{
    return findSimulatedFamily(allSimulatedFamilies(), family).has_value();
}

/// What comes back of so many numbered packets, one each millisecond.
QList<QByteArray> echoed(SimulatedPort &port, int packets)
{
    QList<QByteArray> all;
    for (int i = 0; i < packets; ++i) {
        port.hostWrites(asBytes("packet " + QByteArray::number(i)));
        port.advance(1ms);
        all += port.hostReads();
    }
    port.advance(1s);
    return all + port.hostReads();
}

qsizetype packetsIn(const QList<QByteArray> &all)
{
    return std::count_if(all.begin(), all.end(),
                         [](const QByteArray &each) { return each.startsWith("packet "); });
}

}  // namespace

/// The table of simulated families, and boards that work in packets.
class TestSimulatedFamily : public QObject
{
    Q_OBJECT
private slots:
    void optionsOfOtherFamiliesAreRefused_data();
    void optionsOfOtherFamiliesAreRefused();
    void faultsOfOtherFamiliesAreRefused();
    void valuesOutOfRangeAreRefused_data();
    void valuesOutOfRangeAreRefused();
    void aSetupIsUnderstood();
    void familiesAreFoundByKey();
    void packetsStayWhole();
    void packetsAreLost();
    void packetsComeTwice();
    void packetsAreLate();
    void packetsAreOvertaken();
    void aSilentNetworkIsNotGone();
    void datagramsOverLoopback();
    void receivedOncePerPacket();
};

void TestSimulatedFamily::optionsOfOtherFamiliesAreRefused_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<QString>("option");
    QTest::addColumn<QString>("list");
    if (isBuiltIn(u"simplebgc"_s))
        QTest::newRow("simplebgc")
            << u"simplebgc"_s << u"strict"_s
            << u"seed, firmware, rate, board, condition, number, parity, encoders, frame-imu, "
               "legacy, magnetometer, fc, fault"_s;
    if (isBuiltIn(u"storm32"_s))
        QTest::newRow("storm32") << u"storm32"_s << u"parity"_s << u"seed, firmware, rate, strict, fault"_s;
    QTest::newRow("a network has no rate") << u"echo"_s << u"rate"_s << u"seed, firmware, fault"_s;
}

void TestSimulatedFamily::optionsOfOtherFamiliesAreRefused()
{
    QFETCH(QString, family);
    QFETCH(QString, option);
    QFETCH(QString, list);
    const auto found = findSimulatedFamily(allSimulatedFamilies() + QList{echoFamily()}, family);
    QVERIFY(found);
    const auto setup = parseSimulatorSetup(*found, {{option, u"1"_s}}, {});
    QVERIFY(!setup);
    QCOMPARE(setup.error().code, ErrorCode::InvalidArgument);
    QCOMPARE(setup.error().detail, u"there is no option '%1'; there are: %2"_s.arg(option, list));
}

// A fault that does nothing would be taken for a program that does not notice it.
void TestSimulatedFamily::faultsOfOtherFamiliesAreRefused()
{
    const auto setup = parseSimulatorSetup(echoFamily(), {}, {u"no-imu=1"_s});
    QVERIFY(!setup);
    QCOMPARE(setup.error().code, ErrorCode::InvalidArgument);
    QCOMPARE(setup.error().detail, u"a simulated board of echo has no fault 'no-imu'"_s);
    QVERIFY(parseSimulatorSetup(echoFamily(), {}, {u"lose=0.1"_s}));
}

void TestSimulatedFamily::valuesOutOfRangeAreRefused_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<QString>("option");
    QTest::addColumn<QString>("value");
    QTest::addColumn<QString>("told");
    const auto row = [](const char *family, const char *option, const char *value, const char *told) {
        if (!isBuiltIn(QString::fromLatin1(family)))
            return;
        QTest::addRow("%s %s=%s", family, option, value)
            << QString::fromLatin1(family) << QString::fromLatin1(option) << QString::fromLatin1(value)
            << QString::fromLatin1(told);
    };
    row("simplebgc", "firmware", "1.20", "2.59, 2.70b4 or 2.73.8");
    row("simplebgc", "firmware", "2.80", "2.40 to 2.74.9");
    row("simplebgc", "firmware", "2.59b10", "2.40 to 2.74.9");
    row("simplebgc", "firmware", "new", "2.59, 2.70b4 or 2.73.8");
    row("storm32", "firmware", "0.50", "0.79, 0.90 or 0.96");
    row("simplebgc", "board", "200", "from 10 to 99");
    row("simplebgc", "parity", "odd", "none or even");
    row("simplebgc", "seed", "-1", "from 0 to 1000000000");
    row("storm32", "rate", "9", "from 1200 to 4000000");
    row("storm32", "rate", "fast", "from 1200 to 4000000");
}

void TestSimulatedFamily::valuesOutOfRangeAreRefused()
{
    QFETCH(QString, family);
    QFETCH(QString, option);
    QFETCH(QString, value);
    QFETCH(QString, told);
    const auto setup
        = parseSimulatorSetup(*findSimulatedFamily(allSimulatedFamilies(), family), {{option, value}}, {});
    QVERIFY(!setup);
    QVERIFY2(setup.error().detail.contains(told), qPrintable(setup.error().detail));
}

void TestSimulatedFamily::aSetupIsUnderstood()
{
#if GIMBAL_WITH_SIMPLEBGC
    const auto sbgc = parseSimulatorSetup(*findSimulatedFamily(allSimulatedFamilies(), u"simplebgc"_s),
                                          {{u"firmware"_s, u"2.73.8"_s},
                                           {u"board"_s, u"36"_s},
                                           {u"parity"_s, u"even"_s},
                                           {u"rate"_s, u"57600"_s}},
                                          {u"shake=0"_s});
    QVERIFY(sbgc);
    QCOMPARE(sbgc->options.firmware, 2738);
    QCOMPARE(sbgc->options.own.value(u"board"_s), 36);
    QCOMPARE(sbgc->options.faults.shake, 0.0);
    QVERIFY(!sbgc->options.usb);
    QVERIFY(sbgc->line() == (LineSettings{57600, Parity::Even}));
#endif
#if GIMBAL_WITH_STORM32
    const auto storm = parseSimulatorSetup(*findSimulatedFamily(allSimulatedFamilies(), u"storm32"_s),
                                           {{u"firmware"_s, u"v0.79"_s}}, {});
    QVERIFY(storm && storm->options.usb && !storm->line());
    QCOMPARE(storm->options.firmware, 79);
#endif
}

void TestSimulatedFamily::familiesAreFoundByKey()
{
    const auto none = findSimulatedFamily(allSimulatedFamilies(), u"toaster"_s);
    QVERIFY(!none);
    QStringList keys;
    for (const QString &key : {u"simplebgc"_s, u"storm32"_s, u"bcflight"_s}) {
        if (isBuiltIn(key))
            keys.append(key);
    }
    QCOMPARE(keys.size(), allSimulatedFamilies().size());
    QVERIFY(none.error().detail.endsWith(u"there are: "_s + keys.join(u", "_s)));
}

void TestSimulatedFamily::packetsStayWhole()
{
    const auto port = echoPort();
    port->hostWrites(asBytes(QByteArray("one")));
    port->hostWrites(asBytes(QByteArray("two")));
    port->advance(1ms);
    QCOMPARE(port->hostReads(), (QList<QByteArray>{"1", "one", "2", "two"}));
    QVERIFY(port->hostReads().isEmpty());
}

void TestSimulatedFamily::packetsAreLost()
{
    const auto port = echoPort({u"lose=0.2"_s});
    const QList<QByteArray> all = echoed(*port, 1000);
    // A fifth of them on their way to the board, and a fifth of its answers.
    const qsizetype count = packetsIn(all);
    QVERIFY2(count > 580 && count < 700, qPrintable(QString::number(count)));
}

void TestSimulatedFamily::packetsComeTwice()
{
    const auto port = echoPort({u"double=1"_s});
    port->hostWrites(asBytes(QByteArray("one")));
    port->advance(1ms);
    QCOMPARE(port->hostReads(), (QList<QByteArray>{"1", "1", "one", "one", "2", "2", "one", "one"}));
}

void TestSimulatedFamily::packetsAreLate()
{
    const auto port = echoPort({u"delay=100"_s});
    port->hostWrites(asBytes(QByteArray("one")));
    QList<QByteArray> all;
    int waited = 0;
    for (; waited < 200 && all.size() < 2; ++waited) {
        port->advance(1ms);
        all += port->hostReads();
    }
    QCOMPARE(all, (QList<QByteArray>{"1", "one"}));  // late, but in order
    QVERIFY(waited > 2 && waited <= 102);
}

void TestSimulatedFamily::packetsAreOvertaken()
{
    const auto port = echoPort({u"reorder=0.2"_s});
    const QList<QByteArray> all = echoed(*port, 500);
    QCOMPARE(packetsIn(all), 500);  // none is lost
    QList<int> numbers;
    for (const QByteArray &each : all) {
        if (each.startsWith("packet "))
            numbers.append(each.mid(7).toInt());
    }
    QVERIFY(!std::is_sorted(numbers.begin(), numbers.end()));
    std::sort(numbers.begin(), numbers.end());
    for (int i = 0; i < 500; ++i)
        QCOMPARE(numbers[i], i);
}

void TestSimulatedFamily::aSilentNetworkIsNotGone()
{
    const auto port = echoPort();
    QVERIFY(port->change(u"unplug=0"_s));
    port->hostWrites(asBytes(QByteArray("one")));
    port->advance(10ms);
    QVERIFY(port->hostReads().isEmpty());
    QVERIFY(!port->isPlugged() && !port->isGone());
}

void TestSimulatedFamily::datagramsOverLoopback()
{
    UdpHost host(echoPort(), 0);
    QVERIFY(host.start());
    const auto address = LinkAddress::parse(host.address());
    QVERIFY(address && address->kind() == LinkAddress::Kind::Udp);
    QUdpSocket first;
    QUdpSocket second;
    const auto ask = [&address](QUdpSocket &socket, const QByteArray &packet) {
        socket.writeDatagram(packet, QHostAddress(address->target()), address->port());
        QList<QByteArray> heard;
        const bool answered = QTest::qWaitFor(
            [&socket, &heard] {
                while (socket.hasPendingDatagrams())
                    heard.append(socket.receiveDatagram().data());
                return heard.size() >= 2;
            },
            kPatience);
        return answered ? heard : QList<QByteArray>();
    };
    QCOMPARE(ask(first, "one"), (QList<QByteArray>{"1", "one"}));
    QCOMPARE(ask(second, "two"), (QList<QByteArray>{"2", "two"}));  // whoever sent last is answered
    QVERIFY(!first.hasPendingDatagrams());
}

void TestSimulatedFamily::receivedOncePerPacket()
{
    const SimulatedGimbals simulated({echoFamily()});
    const auto transport = simulated.connectTo(*LinkAddress::parse(u"sim:echo"_s));
    QVERIFY(transport);
    QList<QByteArray> heard;
    connect(transport->get(), &Transport::received, this,
            [&heard](QByteArrayView bytes) { heard.append(bytes.toByteArray()); });
    QSignalSpy opened(transport->get(), &Transport::opened);
    QSignalSpy closed(transport->get(), &Transport::closed);
    transport->get()->open();
    QCOMPARE(opened.size(), 1);
    transport->get()->write("one");
    transport->get()->write("two");
    QTRY_COMPARE(heard, (QList<QByteArray>{"1", "one", "2", "two"}));
    // Nobody is told of a cable that is out, and the board is still the same one.
    QVERIFY(simulated.change(*LinkAddress::parse(u"sim:echo"_s), u"replug=0.05"_s));
    QVERIFY(simulated.change(*LinkAddress::parse(u"sim:echo"_s), u"unplug=0"_s));
    QTRY_VERIFY([&] {
        transport->get()->write("again");
        return heard.last() == "again";
    }());
    QCOMPARE(closed.size(), 0);
    QVERIFY(!simulated.connectTo(*LinkAddress::parse(u"sim:toaster"_s)));
}

QTEST_GUILESS_MAIN(TestSimulatedFamily)
#include "tst_simulatedfamily.moc"
