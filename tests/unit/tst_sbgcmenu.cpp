// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Every command of the menu, on a simulated board that has all that they need: what the board tells
// afterwards.
#include "protocol/simplebgc/choices.h"
#include "tests/support/sbgcrig.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <tuple>

using namespace simplebgc;
using namespace Qt::StringLiterals;

namespace {

using Told = QMap<QString, QByteArray>;
using Actions = QList<int>;

constexpr int kEvent = 102;
constexpr int kStates = 102;  // byte of REALTIME_DATA_4
constexpr int kRefused = 9;  // not supported

/// Those that this board has no more than a name for, or lacks what they need; and why.
struct Without
{
    int action;
    const char *reason;
};
constexpr Without kWithout[] = {
    {19, "there is no receiver that could be bound"},
    {44, "no document tells the path of a time-lapse"},
    {45, "no document tells how a momentum is measured"},
    {47, "no document tells the path of a time-lapse"},
    {57, "no document tells what the fixed positions are"},
    {64, "the simulated search knows no gain alone"},
    {67, "no document tells the path of a time-lapse"},
    {68, "there is no external sensor"},
};

/// What the board tells otherwise after a command, and how.
struct Row
{
    int action = 0;
    QString changes;
    QByteArray expected;
    Actions before;
    Actions then;
};

QList<Row> rows()
{
    QList<Row> all;
    const auto row = [&all](int action, const char *changes, const QByteArray &expected = {},
                            const Actions &before = {}, const Actions &then = {}) {
        all.append({action, QString::fromLatin1(changes), expected, before, then});
    };
    row(1, "profile", "00", {2});
    row(2, "profile", "01");
    row(3, "profile", "02");
    row(14, "profile", "03");
    row(15, "profile", "04");
    for (const int action : {4, 5, 8, 48, 49, 50, 51, 52, 53, 54, 55, 56, 74})
        row(action, "parameters");
    row(6, "calibration", "4");
    row(61, "calibration", "4");
    row(9, "calibration", "5");
    row(20, "calibration", "10");
    row(21, "calibration", "11");
    row(33, "calibration", "12");
    row(37, "calibration", "13");
    row(16, "calibration", "8");
    row(60, "motors", "00");
    row(66, "motors", "00");
    row(10, "motors", "00");
    row(12, "motors", "00");
    row(11, "motors", "01", {12});
    row(7, "restart", "!");
    row(62, "attitude", "0", {12});
    row(17, "target.pitch", "45");
    row(18, "target.pitch", "0");
    row(38, "target.pitch", "0");
    row(34, "target.roll", "0");
    row(46, "target.roll", "0");
    row(65, "target.pitch", "0");
    row(35, "target.yaw", "0");
    row(39, "target.yaw", "0");
    row(75, "target.roll", "0");
    row(36, "target.yaw", "20");
    row(40, "target.yaw", "290");
    row(41, "target.yaw", "90");
    row(42, "target.yaw", "0");
    row(43, "target.roll", "45");
    row(70, "target.roll", {}, {12, 18}, {18});
    row(76, "state", "10400000");
    row(13, "state", "12000000");
    row(63, "state", "10100000");
    row(69, "state", "10000000", {63});
    row(73, "state", "10200000");
    row(72, "state", "10000000", {73});
    row(78, "state", "10010000");
    row(77, "state", "10000000", {78});
    row(79, "state", "10020000");
    row(80, "state", "10000000", {79});
    row(81, "state", "10020000");
    row(22, "events", "01020000");
    row(58, "events", "04010000");
    row(59, "events", "04020000");
    for (int script = 23; script <= 32; ++script)
        row(script, "events", "0502000005010000");
    row(71, "events", "05010000", {23});
    return all;
}

SimulatorOptions everything()
{
    SimulatorOptions options = withFirmware(2740);
    options.own.insert(u"magnetometer"_s, 1);
    return options;
}

struct MenuRig : SbgcRig
{
    MenuRig()
        : SbgcRig(everything())
    {
        channel.setTap([this](const FrameView &frame, TimePoint) { heard.append(Frame(frame)); });
        for (const auto &[key, source] :
             {std::pair(u"rc.map.roll"_s, 129), {u"rc.map.pitch"_s, 130}, {u"rc.map.yaw"_s, 131}})
            board().store(key, 0, source);
        board().store(u"rc.yaw.follow"_s, 0, 0);
        board().store(u"service.button.press1"_s, 0, 73);
        for (int slot = 0; slot < 10; ++slot)
            give(CommandId::WriteFile, ByteWriter().u8(1).u8(slot).u16(3).u16(0).bytes("abc").take());
        for (int set = 1; set <= 6; ++set)
            give(CommandId::ProfileSet, ByteWriter().u8(set).u8(1).zeros(8).take());
        for (int event = 1; event <= 6; ++event)
            give(CommandId::DataStreamInterval,
                 ByteWriter().u8(kEvent).u16(1).u8(event).u8(7).zeros(16).take());
        board().store(u"pid.roll.p"_s, 0, 77);
        for (const auto &[axis, angle] :
             {std::pair(Axis::Roll, 10.0), {Axis::Pitch, 20.0}, {Axis::Yaw, 400.0}})
            board().stabilizer().setTarget(axis, angle);
    }
    void give(CommandId id, const QByteArray &payload)
    {
        std::ignore = channel.transact(silentRequest(id, payload, 1));
        listen(60ms);
    }
    void listen(milliseconds time) { std::ignore = channel.sleep(time); }
    void choose(int action) { give(CommandId::ExecuteMenu, ByteWriter().u8(action).take()); }
    /// All but what sways by itself.
    Told toldAtRest()
    {
        Told all = told();
        all.remove(u"attitude"_s);
        return all;
    }
    /// The code of an ERROR about the menu, 0 = confirmed, -1 = nothing was said.
    [[nodiscard]] int answer() const
    {
        for (const Frame &frame : heard) {
            if (frame.id == number(CommandId::Confirm)
                && quint8(frame.payload[0]) == number(CommandId::ExecuteMenu))
                return 0;
            if (frame.id == number(CommandId::Error)
                && quint8(frame.payload[0]) == number(CommandId::ExecuteMenu))
                return quint8(frame.payload[1]);
        }
        return -1;
    }
    Told told()
    {
        Told all;
        const auto status
            = channel.transact(replyRequest(CommandId::RealtimeData4, {}, CommandId::RealtimeData4, 124, 1));
        if (!status)
            return all;
        const QByteArray bytes = status->payload;
        ByteReader reader(bytes);
        reader.skip(36);
        const auto degrees = [&reader](double step) {
            return QByteArray::number(int(std::lround(reader.i16() * 360.0 / 16384.0 / step)));
        };
        all.insert(u"attitude"_s, degrees(20));
        reader.skip(6);
        for (const auto &key : {u"target.roll"_s, u"target.pitch"_s, u"target.yaw"_s})
            all.insert(key, degrees(2));
        all.insert(u"motors"_s, bytes.mid(57, 1).toHex());
        all.insert(u"profile"_s, bytes.mid(59, 1).toHex());
        all.insert(u"calibration"_s, QByteArray::number(quint8(bytes[94])));
        all.insert(u"state"_s, bytes.mid(kStates, 4).toHex());
        for (const auto &[id, size] : {std::pair(CommandId::ReadParams3, 134),
                                       {CommandId::ReadParamsExt, 104},
                                       {CommandId::ReadParamsExt2, 151},
                                       {CommandId::ReadParamsExt3, 221}}) {
            const auto block = channel.transact(replyRequest(id, QByteArray(1, '\xFF'), id, size, 1));
            if (block)
                all[u"parameters"_s] += block->payload.sliced(1, std::min(131, size - 1))
                    + block->payload.sliced(std::min(134, size));
        }
        for (const Frame &frame : heard) {
            if (frame.id == kEvent)
                all[u"events"_s] += frame.payload.toHex();
            if (frame.id == number(CommandId::Reset))
                all[u"restart"_s] += '!';
        }
        return all;
    }
    QList<Frame> heard;
};

}  // namespace

Q_DECLARE_METATYPE(Row)

class TestSbgcMenu : public QObject
{
    Q_OBJECT
private slots:
    void eachHasItsEffect_data();
    void eachHasItsEffect();
    void othersAreRefused();
    void noneIsForgotten();
    void unknownOnesAreRefused();
    void eventsOnlyForThoseWhoAsk();
};

void TestSbgcMenu::eachHasItsEffect_data()
{
    QTest::addColumn<Row>("row");
    for (const Row &row : rows())
        QTest::addRow("%d", row.action) << row;
}

void TestSbgcMenu::eachHasItsEffect()
{
    QFETCH(Row, row);
    const auto &[action, changes, expected, before, then] = row;
    MenuRig rig;
    if (action == 74)
        rig.give(CommandId::ApiVirtChControl, ByteWriter().i16(100).i16(0).i16(0).take());
    for (const int each : before)
        rig.choose(each);
    if (action == 62 || action == 70) {
        rig.board().stabilizer().setEstimate(Axis::Yaw, 90);
        rig.board().stabilizer().setEstimate(Axis::Roll, 30);
    }
    const Told was = rig.told();
    rig.heard.clear();
    rig.choose(action);
    for (const int each : then)
        rig.choose(each);
    rig.listen(700ms);
    const Told soon = rig.told();
    rig.listen(4s);
    const Told late = rig.told();
    QCOMPARE(rig.answer(), 0);
    QVERIFY(soon.value(changes) != was.value(changes) || late.value(changes) != was.value(changes));
    if (!expected.isEmpty())
        QVERIFY2(soon.value(changes) == expected || late.value(changes) == expected,
                 soon.value(changes) + ' ' + late.value(changes));
}

void TestSbgcMenu::othersAreRefused()
{
    for (const Without &each : kWithout) {
        MenuRig rig;
        const Told was = rig.toldAtRest();
        rig.heard.clear();
        rig.choose(each.action);
        QVERIFY2(rig.answer() == kRefused, each.reason);
        QCOMPARE(rig.toldAtRest(), was);
    }
    MenuRig rig;
    const Told was = rig.toldAtRest();
    rig.heard.clear();
    rig.choose(0);  // a ping
    QCOMPARE(rig.answer(), 0);
    QCOMPARE(rig.toldAtRest(), was);
}

void TestSbgcMenu::noneIsForgotten()
{
    QList<int> seen{0};
    for (const Row &row : rows())
        seen.append(row.action);
    for (const Without &each : kWithout)
        seen.append(each.action);
    QList<int> all;
    for (const Choice &choice : kMenuActions)
        all.append(choice.value);
    std::sort(seen.begin(), seen.end());
    std::sort(all.begin(), all.end());
    QCOMPARE(seen, all);
}

void TestSbgcMenu::unknownOnesAreRefused()
{
    MenuRig rig;
    rig.heard.clear();
    rig.choose(200);
    QCOMPARE(rig.answer(), 2);
    // What came later an older board does not know.
    SbgcRig old(2590);
    QVERIFY(!old.channel.transact(confirmRequest(CommandId::ExecuteMenu, hex("3C"), 1)));
    // With flags it confirms only if it is told to.
    rig.heard.clear();
    rig.give(CommandId::ExecuteMenu, hex("0C00"));
    QCOMPARE(rig.answer(), -1);
    QVERIFY(!rig.board().stabilizer().motorsOn());
    rig.give(CommandId::ExecuteMenu, hex("0B01"));
    QCOMPARE(rig.answer(), 0);
}

void TestSbgcMenu::eventsOnlyForThoseWhoAsk()
{
    MenuRig rig;
    rig.give(CommandId::DataStreamInterval, ByteWriter().u8(kEvent).u16(0).u8(2).u8(7).zeros(16).take());
    rig.heard.clear();
    rig.choose(12);
    QVERIFY(std::none_of(rig.heard.begin(), rig.heard.end(),
                         [](const Frame &frame) { return frame.id == kEvent; }));
}

QTEST_GUILESS_MAIN(TestSbgcMenu)
#include "tst_sbgcmenu.moc"
