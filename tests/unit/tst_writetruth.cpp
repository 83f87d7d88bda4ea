// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedure/writeconfiguration.h"
#include "protocol/record/boardhistory.h"
#include "tests/support/channelproxy.h"
#include "tests/support/stormrig.h"
#include "tests/support/virtualboard.h"
#include "widgets/models/errortext.h"

#include <QTemporaryDir>
#include <QTest>

#include <functional>

using namespace Qt::StringLiterals;

namespace {

/// What goes wrong with the writes of blocks, each time from one of them on.
enum class Wrong {
    AnswerLost,  // the board takes it, nobody hears that
    Refused,
    RefusedForGood,  // and so is putting back
    NotTaken,  // confirmed, and not done
    Mute,  // from then on the board is silent
};

bool isWrite(const Request &request)
{
    return request.name.startsWith(u"WRITE_PARAMS_EXT"_s) || request.name == u"WRITE_PARAMS_3"_s
        || request.name == u"p"_s;
}

class Meddler final : public ChannelProxy
{
public:
    Meddler(Channel &channel, Wrong wrong, int from)
        : ChannelProxy(channel)
        , m_wrong(wrong)
        , m_from(from)
    {
    }
    Result<Frame> transact(const Request &request) override
    {
        const Error silence{ErrorCode::Timeout, request.name, 0};
        m_writes += isWrite(request);
        if (m_writes < m_from)
            return ChannelProxy::transact(request);
        if (m_wrong == Wrong::Mute)
            return tl::unexpected(silence);
        const bool isFirst = m_writes == m_from;
        if (!isWrite(request) || (!isFirst && m_wrong != Wrong::RefusedForGood))
            return ChannelProxy::transact(request);
        if (m_wrong == Wrong::NotTaken)
            return Frame{};
        if (m_wrong == Wrong::AnswerLost) {
            std::ignore = ChannelProxy::transact(request);
            return tl::unexpected(silence);
        }
        return failure(ErrorCode::BoardError, request.name + u": wrong parameters"_s);
    }

private:
    Wrong m_wrong;
    int m_from;
    int m_writes = 0;
};

/// A board that confirms live values and does not take them, so many times.
class NotTaking final : public ChannelProxy
{
public:
    NotTaking(Channel &channel, int times)
        : ChannelProxy(channel)
        , m_times(times)
    {
    }
    Result<Frame> transact(const Request &request) override
    {
        const bool isSet = request.name == u"SET_ADJ_VARS_VAL"_s || request.name == u"SETPARAMETER"_s;
        return isSet && m_times-- > 0 ? Frame{} : ChannelProxy::transact(request);
    }

private:
    int m_times;
};

/// A board that was read, the edits, and how to look into its memory.
struct Board
{
    Channel *channel = nullptr;
    Device *device = nullptr;
    std::function<int(const ParameterSpec &, int)> stored;
    QStringList keys;
    QList<int> profiles;
};

}  // namespace

/// After a write that went wrong, the report tells for each value what the board holds.
class TestWriteTruth : public QObject
{
    Q_OBJECT
private slots:
    void everyValueIsTold_data();
    void everyValueIsTold();
    void liveValuesAreReadBack_data();
    void liveValuesAreReadBack();
};

void TestWriteTruth::everyValueIsTold_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<int>("wrong");
    QTest::addColumn<int>("from");
    const std::pair<Wrong, const char *> all[] = {{Wrong::AnswerLost, "answer lost"},
                                                  {Wrong::Refused, "refused"},
                                                  {Wrong::RefusedForGood, "refused for good"},
                                                  {Wrong::NotTaken, "not taken"},
                                                  {Wrong::Mute, "mute"}};
    for (const auto &[wrong, name] : all) {
        for (int from = 1; from <= 3; ++from)
            QTest::addRow("simplebgc, %s, write %d", name, from) << u"simplebgc"_s << int(wrong) << from;
        // The first puts back what is in use after what is stored was looked at, so does the third.
        for (int from = 2; from <= (wrong == Wrong::NotTaken ? 2 : 3); ++from)
            QTest::addRow("storm32, %s, write %d", name, from) << u"storm32"_s << int(wrong) << from;
    }
}

void TestWriteTruth::everyValueIsTold()
{
    QFETCH(QString, family);
    QFETCH(int, wrong);
    QFETCH(int, from);
    VirtualBoard sbgc;
    StormRig storm;
    Board board;
    if (family == u"simplebgc"_s) {
        board
            = {&sbgc.channel,
               &sbgc.device,
               [&](const ParameterSpec &spec, int profile) { return sbgc.board().stored(spec.key, profile); },
               {u"pid.roll.p"_s, u"filter.pitch.lpf"_s, u"follow.yaw.lpf"_s},
               {0, 1, 2}};
    } else {
        board = {&storm.channel,
                 &storm.device,
                 [&](const ParameterSpec &spec, int) { return storm.board().stored(spec.offset / 2); },
                 {u"pid.pitch.p"_s, u"pid.yaw.d"_s},
                 {0}};
    }
    QVERIFY(board.device->identify(*board.channel));
    const auto base = board.device->readConfiguration(*board.channel);
    QVERIFY(base);
    Configuration edited = *base;
    for (const QString &key : board.keys) {
        const ParameterSpec *spec = base->parameters().find(key);
        QVERIFY2(spec, qPrintable(key));
        for (const int profile : board.profiles)
            QVERIFY(edited.setRaw(*spec, profile, *base->raw(*spec, profile) + 3 + profile));
    }
    const QTemporaryDir dir;
    const BoardHistory history(dir.path());
    WriteOptions options;
    options.history = &history;
    Meddler meddler(*board.channel, Wrong(wrong), from);
    const auto report = writeConfiguration(meddler, *board.device, *base, edited, options);
    QVERIFY(report);
    QVERIFY(!report->isComplete());
    QVERIFY(!report->snapshotPath.isEmpty());

    int other = 0;
    for (const WriteLine &line : report->lines) {
        const double stored = board.stored(*line.spec, line.profile);
        const QByteArray place
            = u"%1 %2: %3"_s.arg(line.spec->key).arg(line.profile).arg(int(line.state)).toUtf8();
        if (line.state == WriteState::Unknown) {
            QVERIFY2(Wrong(wrong) == Wrong::Mute, place);
            continue;
        }
        QVERIFY2(line.found == stored, place);
        QVERIFY2(line.state != WriteState::Verified || stored == line.to, place);
        QVERIFY2((line.state != WriteState::RolledBack && line.state != WriteState::NotWritten)
                     || stored == line.from,
                 place);
        other += stored != line.from;
    }
    QCOMPARE(report->count(WriteState::Unknown) > 0, Wrong(wrong) == Wrong::Mute);
    QCOMPARE(report->countOther(), other);
    const ErrorText text = describe(*report);
    QVERIFY2(!text.oneLine().contains(u"Nothing was changed"_s), qPrintable(text.oneLine()));
    if (report->count(WriteState::Unknown) == 0)
        QCOMPARE(text.meaning.contains(u"it holds the old values"_s), other == 0);
    else
        QVERIFY2(text.meaning.contains(u"could not be read"_s), qPrintable(text.meaning));
}

void TestWriteTruth::liveValuesAreReadBack_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<int>("lost");
    for (const QString &family : {u"simplebgc"_s, u"storm32"_s}) {
        for (const int lost : {0, 1, 100})
            QTest::addRow("%s, %d times not taken", qPrintable(family), lost) << family << lost;
    }
}

// A live value counts as changed when the board reports it, not when it confirms it.
void TestWriteTruth::liveValuesAreReadBack()
{
    QFETCH(const QString, family);
    QFETCH(const int, lost);
    VirtualBoard sbgc;
    StormRig storm;
    Device &device = family == u"simplebgc"_s ? static_cast<Device &>(sbgc.device) : storm.device;
    NotTaking channel(family == u"simplebgc"_s ? static_cast<Channel &>(sbgc.channel) : storm.channel, lost);
    QVERIFY(device.identify(channel));
    const QList<int> ids{0, 1};
    const auto before = device.live()->readAdjustables(channel, ids);
    QVERIFY(before);
    std::vector<AdjustableValue> wanted = *before;
    for (AdjustableValue &value : wanted)
        value.value += 7;
    const auto done = device.live()->writeAdjustables(channel, wanted);
    const bool isTaken = lost < 2;
    QCOMPARE(done.has_value(), isTaken);
    if (!isTaken) {
        QCOMPARE(done.error().code, ErrorCode::NotInUse);
        const QString told = u"%1 was written, %2 read"_s.arg(wanted[0].value).arg((*before)[0].value);
        QVERIFY2(done.error().detail.contains(told), qPrintable(done.error().detail));
    }
    const auto after = device.live()->readAdjustables(channel, ids);
    QVERIFY(after);
    for (std::size_t i = 0; i < after->size(); ++i)
        QCOMPARE((*after)[i].value, isTaken ? wanted[i].value : (*before)[i].value);
}

QTEST_GUILESS_MAIN(TestWriteTruth)
#include "tst_writetruth.moc"
