// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedure/writeconfiguration.h"
#include "tests/support/channelproxy.h"
#include "tests/support/stormrig.h"
#include "widgets/models/errortext.h"

#include <QTemporaryDir>
#include <QTest>

#include <functional>

namespace {

/// From one writing of all values in use on, the board takes another stream than it was given, and confirms
/// that.
class Bending final : public ChannelProxy
{
public:
    using Bend = std::function<std::optional<QByteArray>(const QByteArray &stream)>;
    Bending(Channel &channel, int from, Bend bend)
        : ChannelProxy(channel)
        , m_left(from)
        , m_bend(std::move(bend))
    {
    }
    Result<Frame> transact(const Request &request) override
    {
        if (request.name != u"p"_s || --m_left > 0)
            return ChannelProxy::transact(request);
        const auto bent = m_bend(request.bytes.mid(1, request.bytes.size() - 3));
        if (!bent)
            return Frame{};
        Request other = request;
        other.bytes = storm32::encodeSimple(storm32::Simple::PutParameters, *bent);
        return ChannelProxy::transact(other);
    }

private:
    int m_left;
    Bend m_bend;
};

std::optional<QByteArray> clamped(const QByteArray &stream)
{
    const int raw = ByteReader(QByteArrayView(stream).first(2)).u16();
    return QByteArray(stream).replace(0, 2, ByteWriter().u16(std::min(raw, 425)).take());
}

std::optional<QByteArray> stuck(const QByteArray &stream)
{
    return QByteArray(stream).replace(0, 2, ByteWriter().u16(425).take());
}

std::optional<QByteArray> withoutScripts(const QByteArray &stream)
{
    return QByteArray(stream).replace(stream.size() - 128, 128, QByteArray(128, '\xFF'));
}

std::optional<QByteArray> untaken(const QByteArray &)
{
    return {};
}

}  // namespace

/// A board that confirms values and uses others: what is said of what is in use is what it says itself.
class TestStormInUse : public QObject
{
    Q_OBJECT
private slots:
    void saysWhatIsInUse_data();
    void saysWhatIsInUse();

private:
    QTemporaryDir m_dir;
};

void TestStormInUse::saysWhatIsInUse_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("others");
    for (const OtherValues others : {OtherValues::Keep, OtherValues::Store, OtherValues::PutBack}) {
        const char *words = others == OtherValues::Keep ? "keep"
            : others == OtherValues::Store              ? "store"
                                                        : "put back";
        QTest::addRow("clamps, %s", words) << 0 << int(others);
        QTest::addRow("has one value, %s", words) << 1 << int(others);
        QTest::addRow("takes nothing, %s", words) << 2 << int(others);
        QTest::addRow("takes no scripts, %s", words) << 3 << int(others);
    }
}

void TestStormInUse::saysWhatIsInUse()
{
    QFETCH(int, kind);
    QFETCH(int, others);
    static const std::array<Bending::Bend, 4> kBends{clamped, stuck, untaken, withoutScripts};
    int failed = 0;
    for (int from = 1; from < 9; ++from) {
        for (const int rollBefore : {400, 500}) {
            StormRig rig;
            QVERIFY(rig.device.identify(rig.channel));
            auto board = rig.device.readConfiguration(rig.channel).value();
            const auto code = rig.family.scripts->compile(board, {u"CASE#DEFAULT\nWAIT 1"_s, {}, {}, {}});
            QVERIFY(code);
            board.setBlock({0, storm32::Scripts}, *code);
            QVERIFY(rig.device.use(rig.channel, board));
            QVERIFY(rig.device.perform(rig.channel, u"store"_s, {}));
            rig.board().set(6, rollBefore);  // somebody, by RC command 4
            Bending channel(rig.channel, from, kBends[std::size_t(kind)]);
            const BoardHistory history(m_dir.path());
            const auto base = rig.device.readConfiguration(rig.channel);
            Configuration edited = *base;
            QVERIFY(edited.setRaw(*edited.parameters().find(u"pid.pitch.p"_s), 0, 450));
            WriteOptions options;
            options.history = &history;
            options.others = OtherValues(others);
            options.named = {u"pid.pitch.p"_s};
            const auto report = writeConfiguration(channel, rig.device, *base, edited, options);
            const Configuration now = rig.device.readConfiguration(rig.channel).value();
            const bool isAsBefore = base->changesTo(now).empty() && base->dataChangesTo(now).empty()
                && now.blocks() == base->blocks();
            if (!report) {
                ++failed;
                // It ends before anything is written; what is lost all the same is told.
                QVERIFY2(isAsBefore || report.error().code == ErrorCode::NotRestored,
                         qPrintable(describe(report.error()).oneLine()));
                continue;
            }
            for (const WriteLine &line : report->lines)
                QVERIFY(line.state == WriteState::Unknown || int(line.found) == rig.board().stored(0));
            if (report->isComplete()) {
                QCOMPARE(rig.board().inUse(0), 450);
                QCOMPARE(rig.board().inUse(6),
                         OtherValues(others) == OtherValues::PutBack ? 400 : rollBefore);
                QCOMPARE(now.block({0, storm32::Scripts}), *code);
                continue;
            }
            ++failed;
            const QString told = describe(*report).oneLine();
            QVERIFY2(isAsBefore || !told.contains(u"it holds the old values"_s), qPrintable(told));
            QVERIFY2(report->use && report->use->now, qPrintable(told));
            QCOMPARE(report->use->now->blocks(), now.blocks());
            for (const ParameterChange &change : report->use->changes())
                QVERIFY2(told.contains(u"%1 in use: %2, before %3"_s.arg(change.spec->key,
                                                                         change.spec->format(change.to),
                                                                         change.spec->format(change.from))),
                         qPrintable(told));
        }
    }
    QVERIFY(failed > 0);
}

QTEST_GUILESS_MAIN(TestStormInUse)
#include "tst_storminuse.moc"
