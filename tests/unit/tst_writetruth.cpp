// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedure/inuse.h"
#include "protocol/procedure/writeconfiguration.h"
#include "protocol/record/boardhistory.h"
#include "protocol/simplebgc/commands.h"
#include "protocol/simplebgc/framer.h"
#include "tests/support/channelproxy.h"
#include "tests/support/stormrig.h"
#include "tests/support/virtualboard.h"
#include "widgets/models/errortext.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
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

/// Live values arrive, but their answers get lost, so many times.
class AnswersLost final : public ChannelProxy
{
public:
    AnswersLost(Channel &channel, int times)
        : ChannelProxy(channel)
        , m_times(times)
    {
    }
    Result<Frame> transact(const Request &request) override
    {
        const auto answer = ChannelProxy::transact(request);
        const bool isSet = request.name == u"SET_ADJ_VARS_VAL"_s || request.name == u"SETPARAMETER"_s;
        return isSet && m_times-- > 0 ? failure(ErrorCode::Timeout, request.name) : answer;
    }

private:
    int m_times;
};

/// Commands of the menu are confirmed and not carried out; answers to live values get lost.
class Idle final : public ChannelProxy
{
public:
    using ChannelProxy::ChannelProxy;
    Result<Frame> transact(const Request &request) override
    {
        if (request.name == u"EXECUTE_MENU"_s)
            return Frame{};
        const auto answer = ChannelProxy::transact(request);
        if (request.name == u"SET_ADJ_VARS_VAL"_s)
            return failure(ErrorCode::Timeout, request.name);
        return answer;
    }
};

/// The same request with other bytes in its payload.
Request withPayload(Request request, const std::function<void(QByteArray &)> &alter)
{
    simplebgc::Framer framer;
    QByteArray bytes;
    framer.feed(asBytes(request.bytes), [&](const FrameView &frame) {
        QByteArray payload = Frame(frame).payload;
        alter(payload);
        bytes = simplebgc::encodeFrame(frame.id, payload);
    });
    request.bytes = bytes;
    return request;
}

/// A SimpleBGC board that was read; one value of it is edited.
struct OneEdit
{
    OneEdit()
        : history(dir.path())
    {
        if (!bench.identify())
            qFatal("not identified");
        base = *bench.device.readConfiguration(bench.channel);
    }
    double value(const QString &key) const { return *base.raw(*base.parameters().find(key), 0); }
    Result<WriteReport> write(Channel &channel, const QString &key, double raw)
    {
        Configuration edited = base;
        if (!edited.setRaw(*base.parameters().find(key), 0, raw))
            qFatal("not set");
        WriteOptions options;
        options.history = &history;
        return writeConfiguration(channel, bench.device, base, edited, options);
    }

    VirtualBoard bench;
    QTemporaryDir dir;
    BoardHistory history;
    Configuration base;
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
    void liveValuesCountWithoutAnswer_data();
    void liveValuesCountWithoutAnswer();
    void otherActiveProfileIsTold();
    void confirmedIsNotDone();
    void whatElseIsOtherwiseIsTold();
    void whatTheBoardMadeOfItIsTold();
    void unconfirmedIsPutBack();
    void restartIsTold_data();
    void restartIsTold();
    void replacedInUseIsTold();
    void passingRefusalsAreAskedAgain_data();
    void passingRefusalsAreAskedAgain();
    void identityIsCheckedBefore();
    void puttingBackIsNoChange();
    void steeredCameraIsThereOrIsNot();
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
        // The first puts back what is in use after what is stored was looked at. So does the third; what
        // becomes of its answer matters as little, since what is in use is read.
        for (int from = 2; from <= (wrong == Wrong::Mute ? 3 : 2); ++from)
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
    if (family == u"storm32"_s) {
        QVERIFY(report->use);
        for (const ParameterSpec &spec : base->parameters().all()) {
            const int before = int(base->raw(spec, 0).value()) & 0xFFFF;
            const bool isAsBefore = before == storm.board().inUse(spec.offset / 2);
            QVERIFY2(isAsBefore || !text.meaning.contains(u"it holds the old values"_s),
                     qPrintable(spec.key));
        }
    }
    if (report->count(WriteState::Unknown) == 0)
        QCOMPARE(text.meaning.contains(u"old values"_s), other == 0);
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

void TestWriteTruth::liveValuesCountWithoutAnswer_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<QList<int>>("ids");
    QTest::newRow("simplebgc") << u"simplebgc"_s << QList<int>{0, 1};
    QTest::newRow("storm32") << u"storm32"_s << QList<int>{0, 1};
    QTest::newRow("storm32, heartbeat") << u"storm32"_s << QList<int>{112};
}

// What is in use tells.
void TestWriteTruth::liveValuesCountWithoutAnswer()
{
    QFETCH(const QString, family);
    QFETCH(const QList<int>, ids);
    for (const int lost : {1, 100}) {
        VirtualBoard sbgc;
        StormRig storm(stormOptions(96, false), LineSettings{115200, Parity::None});
        QVERIFY(storm.channel.setLine({115200, Parity::None}));
        Device &device = family == u"simplebgc"_s ? static_cast<Device &>(sbgc.device) : storm.device;
        AnswersLost channel(family == u"simplebgc"_s ? static_cast<Channel &>(sbgc.channel) : storm.channel,
                            lost);
        QVERIFY(device.identify(channel));
        std::vector<AdjustableValue> wanted = device.live()->readAdjustables(channel, ids).value();
        for (AdjustableValue &value : wanted)
            value.value += 1;
        const auto done = device.live()->writeAdjustables(channel, wanted);
        QVERIFY2(done, done ? "" : qPrintable(done.error().detail));
        const auto after = device.live()->readAdjustables(channel, ids);
        QVERIFY(after);
        for (std::size_t i = 0; i < after->size(); ++i)
            QCOMPARE((*after)[i].value, wanted[i].value);
    }
}

// Writing another profile makes it the active one; it does not help that going back is confirmed.
void TestWriteTruth::otherActiveProfileIsTold()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    const auto base = bench.device.readConfiguration(bench.channel);
    QVERIFY(base);
    Configuration edited = *base;
    QVERIFY(edited.setRaw(*base->parameters().find(u"pid.roll.p"_s), 2, 77));
    const QTemporaryDir dir;
    const BoardHistory history(dir.path());
    WriteOptions options;
    options.history = &history;
    Idle idle(bench.channel);
    const auto report = writeConfiguration(idle, bench.device, *base, edited, options);
    QVERIFY(report);
    QVERIFY(!report->isComplete());
    QCOMPARE(bench.board().activeProfile(), 2);
    QCOMPARE(report->strayProfile, std::optional(2));
    const ErrorText text = describe(*report);
    QVERIFY2(text.meaning.contains(u"active profile"_s), qPrintable(text.meaning));
    // Where it can go back, it does, whatever else fails.
    bench.board().store(u"pid.roll.p"_s, 2, 40);
    QVERIFY(bench.device.selectProfile(bench.channel, 0));
    const auto again = bench.device.readConfiguration(bench.channel);
    Meddler meddler(bench.channel, Wrong::RefusedForGood, 2);
    edited = *again;
    for (const int profile : {2, 3})
        QVERIFY(edited.setRaw(*again->parameters().find(u"pid.roll.p"_s), profile, 78));
    const auto second = writeConfiguration(meddler, bench.device, *again, edited, options);
    QVERIFY(second);
    QVERIFY(!second->isComplete());
    QCOMPARE(bench.board().activeProfile(), 0);
    QVERIFY(!second->strayProfile);
}

void TestWriteTruth::confirmedIsNotDone()
{
    VirtualBoard bench;
    QVERIFY(bench.identify());
    Idle idle(bench.channel);
    const auto menu = [&](const QString &entry) {
        return bench.device.perform(idle, u"menu"_s,
                                    argumentsFor(bench.device, "menu", {{u"command"_s, entry}}));
    };
    const auto profile = menu(u"Use profile 2"_s);
    QVERIFY(!profile);
    QCOMPARE(profile.error().code, ErrorCode::NoEffect);
    // A stop goes on by other means.
    for (const QString &entry : {u"Motors off"_s, u"Motors on/off"_s}) {
        bench.board().stabilizer().setMotorsOn(true);
        QVERIFY(menu(entry));
        QVERIFY(!bench.board().stabilizer().motorsOn());
    }
    const auto started = menu(u"Motors on"_s);
    QVERIFY(!started);
    QCOMPARE(started.error().code, ErrorCode::NoEffect);
    bench.board().stabilizer().setMotorsOn(true);
    QVERIFY(menu(u"Motors on"_s));  // they are
    // Where only the answer is lost, what is in use tells.
    QVERIFY(bench.device.writeAdjustables(idle, {{0, 41}}));
    QCOMPARE(bench.board().inUse(u"pid.roll.p"_s), 41);
    bench.board().stabilizer().setMotorsOn(false);
    const auto steered = bench.device.perform(bench.channel, u"steer"_s,
                                              argumentsFor(bench.device, "steer", {{u"yaw"_s, u"5"_s}}));
    QVERIFY(!steered);
    QCOMPARE(steered.error().code, ErrorCode::ConditionUnmet);
}

// The board confirms, and loses a value that nobody wrote; also when the old bytes are put back.
void TestWriteTruth::whatElseIsOtherwiseIsTold()
{
    constexpr int kYawPower = 16;  // of PARAMS_3
    OneEdit edit;
    edit.bench.board().store(u"motor.yaw.power"_s, 0, 120);
    edit.base = *edit.bench.device.readConfiguration(edit.bench.channel);
    Altering losing(edit.bench.channel, [](const Request &request, const Altering::Pass &pass) {
        return request.name == u"WRITE_PARAMS_3"_s
            ? pass(withPayload(request, [](QByteArray &payload) { payload[kYawPower] = 0; }))
            : pass(request);
    });
    const auto report = edit.write(losing, u"pid.roll.p"_s, edit.value(u"pid.roll.p"_s) + 4);
    QVERIFY(report && !report->isComplete());
    QCOMPARE(edit.bench.board().stored(u"motor.yaw.power"_s, 0), 0);
    QCOMPARE(report->strays.size(), 1U);
    QCOMPARE(report->strays.front().spec->key, u"motor.yaw.power"_s);
    QCOMPARE(report->strays.front().from, 120.0);
    QCOMPARE(report->strays.front().to, 0.0);
    QCOMPARE(report->countOther(), 1);
    const ErrorText text = describe(*report);
    QVERIFY2(!text.meaning.contains(u"old values"_s), qPrintable(text.meaning));
    QVERIFY2(text.detail.contains(u"motor.yaw.power 120 -> 0"_s), qPrintable(text.detail));
    // The same where the link broke, and the board is read later.
    WriteReport later = *report;
    later.strays.clear();
    later.learn(*edit.bench.device.readConfiguration(edit.bench.channel));
    QCOMPARE(later.strays.size(), 1U);
}

void TestWriteTruth::whatTheBoardMadeOfItIsTold()
{
    OneEdit edit;
    const double before = edit.value(u"pid.roll.p"_s);
    Altering clamping(edit.bench.channel, [](const Request &request, const Altering::Pass &pass) {
        return request.name == u"WRITE_PARAMS_3"_s ? pass(withPayload(request,
                                                                      [](QByteArray &payload) {
                                                                          if (quint8(payload[1]) > 50)
                                                                              payload[1] = 50;
                                                                      }))
                                                   : pass(request);
    });
    const auto report = edit.write(clamping, u"pid.roll.p"_s, 90);
    QVERIFY(report && !report->isComplete());
    const WriteLine &line = report->lines.front();
    QCOMPARE(line.taken, std::optional(50.0));
    QCOMPARE(line.found, before);
    QVERIFY(line.wasTakenOtherwise());
    QVERIFY(report->strays.empty());
}

// It was written, and put back: nobody may say that it was not written.
void TestWriteTruth::unconfirmedIsPutBack()
{
    OneEdit edit;
    const double wanted = edit.value(u"pid.roll.p"_s) + 4;
    Altering mute(edit.bench.channel,
                  [](const Request &request, const Altering::Pass &pass) -> Result<Frame> {
                      const auto answer = pass(request);
                      return isWrite(request) ? failure(ErrorCode::Timeout, request.name) : answer;
                  });
    const auto report = edit.write(mute, u"pid.roll.p"_s, wanted);
    QVERIFY(report && !report->isComplete());
    QCOMPARE(report->lines.front().state, WriteState::RolledBack);
    QCOMPARE(report->lines.front().taken, std::optional(wanted));
    QCOMPARE(double(edit.bench.board().stored(u"pid.roll.p"_s, 0)), edit.value(u"pid.roll.p"_s));
}

void TestWriteTruth::restartIsTold_data()
{
    QTest::addColumn<bool>("ranBefore");
    QTest::addColumn<bool>("isSilent");
    QTest::newRow("motors off, silent") << false << true;
    QTest::newRow("motors off, at once") << false << false;
    QTest::newRow("motors on, silent") << true << true;
    QTest::newRow("nothing") << true << false;
}

// A board that starts anew in the middle of a write takes it when it is back; its motors run again.
void TestWriteTruth::restartIsTold()
{
    QFETCH(bool, ranBefore);
    QFETCH(bool, isSilent);
    OneEdit edit;
    edit.bench.board().stabilizer().setMotorsOn(ranBefore);
    Altering restarting(edit.bench.channel, [&](const Request &request, const Altering::Pass &pass) {
        if (request.name == u"WRITE_PARAMS_3"_s) {
            if (isSilent)
                std::ignore = edit.bench.channel.sleep(2s);
            edit.bench.board().stabilizer().setMotorsOn(true);
        }
        return pass(request);
    });
    const auto report = edit.write(restarting, u"pid.roll.p"_s, edit.value(u"pid.roll.p"_s) + 4);
    QVERIFY(report && report->isComplete());
    QCOMPARE(report->restart.motorsStarted, !ranBefore);
    QCOMPARE(report->restart.silentSeconds >= 2.0, isSilent);
    QCOMPARE(report->restart.areProof(), !ranBefore && isSilent);
    const QString text = restartText(*report);
    QCOMPARE(text.isEmpty(), ranBefore && !isSilent);
    QCOMPARE(text.contains(u": it has restarted"_s), report->restart.areProof());
    QCOMPARE(text.contains(u"motors run now"_s), !ranBefore);
}

// The board tells apart what is stored and what is in use, and loads what is written.
void TestWriteTruth::replacedInUseIsTold()
{
    OneEdit edit;
    const double stored = edit.value(u"pid.pitch.p"_s);
    QVERIFY(edit.bench.device.writeAdjustables(edit.bench.channel, {{1, stored + 25}}));
    Altering apart(edit.bench.channel, [stored](const Request &request, const Altering::Pass &pass) {
        auto answer = pass(request);
        if (answer && request.name == u"READ_PARAMS_3"_s && answer->payload[0] == 0)
            answer->payload[7] = char(stored);  // pid.pitch.p
        return answer;
    });
    const auto before = readReplaceable(apart, edit.bench.device, edit.base);
    QCOMPARE(before.size(), 1U);
    QCOMPARE(before.front().spec->key, u"pid.pitch.p"_s);
    const auto report = edit.write(apart, u"pid.roll.p"_s, edit.value(u"pid.roll.p"_s) + 4);
    QVERIFY(report && report->isComplete());
    QCOMPARE(report->othersLost, QStringList{u"pid.pitch.p=%1"_s.arg(stored + 25)});
    QCOMPARE(double(edit.bench.board().inUse(u"pid.pitch.p"_s)), stored);
    // Whoever writes it himself is told of it as a change.
    QVERIFY(edit.bench.device.writeAdjustables(edit.bench.channel, {{1, stored + 25}}));
    edit.base = *edit.bench.device.readConfiguration(apart);
    const auto own = edit.write(apart, u"pid.pitch.p"_s, stored + 1);
    QVERIFY(own && own->othersLost.isEmpty());
}

void TestWriteTruth::passingRefusalsAreAskedAgain_data()
{
    QTest::addColumn<int>("code");
    QTest::addColumn<int>("times");
    QTest::addColumn<bool>("isRead");
    for (const int code : {10, 11}) {
        QTest::addRow("error %d, once", code) << code << 1 << true;
        QTest::addRow("error %d, three times", code) << code << 3 << true;
        QTest::addRow("error %d, for good", code) << code << 1000 << false;
    }
    QTest::newRow("not supported, once") << 9 << 1 << false;
}

// "Temporarily impossible" says nothing of the board's memory.
void TestWriteTruth::passingRefusalsAreAskedAgain()
{
    QFETCH(int, code);
    QFETCH(int, times);
    QFETCH(bool, isRead);
    OneEdit edit;
    Altering refusing(edit.bench.channel, [&](const Request &request, const Altering::Pass &pass) {
        const bool isMeant = request.name == u"READ_PARAMS_3"_s && request.bytes[4] == 2;
        if (isMeant && times-- > 0)
            return Result<Frame>(failure(ErrorCode::BoardError, request.name, code));
        return pass(request);
    });
    const auto read = edit.bench.device.readConfiguration(refusing);
    QVERIFY(read);
    QCOMPARE(read->missing().empty(), isRead);
    if (!isRead)
        QCOMPARE(read->missingNames(), QStringList{u"PARAMS_3 of profile 3"_s});
}

// What another firmware makes of the bytes, nobody knows.
void TestWriteTruth::identityIsCheckedBefore()
{
    OneEdit edit;
    const double before = edit.value(u"pid.roll.p"_s);
    Altering other(edit.bench.channel, [](const Request &request, const Altering::Pass &pass) {
        auto answer = pass(request);
        if (answer && request.name == u"BOARD_INFO"_s)
            answer->payload[0] = 36;  // BOARD_VER
        return answer;
    });
    const auto report = edit.write(other, u"pid.roll.p"_s, before + 4);
    QVERIFY(!report || !report->isComplete());
    QCOMPARE((report ? *report->error : report.error()).code, ErrorCode::BadReply);
    // So is what the board said when it was looked for.
    simplebgc::Device device;
    QVERIFY(*device.probe(edit.bench.channel));
    const auto identified = device.identify(other);
    QVERIFY(!identified);
    QCOMPARE(identified.error().code, ErrorCode::BadReply);
    QVERIFY(device.identify(edit.bench.channel));
    QCOMPARE(double(edit.bench.board().stored(u"pid.roll.p"_s, 0)), before);
}

void TestWriteTruth::puttingBackIsNoChange()
{
    OneEdit edit;
    LiveAccess &live = edit.bench.device;
    const double used = live.readAdjustables(edit.bench.channel, {0})->front().value;
    QVERIFY(live.writeAdjustables(edit.bench.channel, {{0, used}}));
    QVERIFY(!live.lastChange());
    QVERIFY(live.restoreAdjustables(edit.bench.channel, {{0, used + 5}}));
    QVERIFY(!live.lastChange());
    QVERIFY(live.writeAdjustables(edit.bench.channel, {{0, used + 6}, {1, 30}}));
    QVERIFY(live.lastChange());
    QCOMPARE(live.lastChange()->before.front().value, used + 5);
}

void TestWriteTruth::steeredCameraIsThereOrIsNot()
{
    SimulatorOptions options;
    VirtualBoard bench(options);
    QVERIFY(bench.identify());
    const auto steer = [&](const QMap<QString, QString> &texts) {
        return bench.device.perform(bench.channel, u"steer"_s, argumentsFor(bench.device, "steer", texts));
    };
    const auto there = steer({{u"pitch"_s, u"20"_s}});
    QVERIFY2(there, there ? "" : qPrintable(there.error().detail));
    QVERIFY(std::abs(there->value(u"imu.pitch"_s).toDouble() - 20) < 3);
    QVERIFY(!there->contains(u"confirmed"_s));
    const QMap<QString, QString> slow{{u"pitch"_s, u"-20"_s}, {u"speed"_s, u"2"_s}};
    const auto givenBack = steer(slow);
    QVERIFY(!givenBack);
    QVERIFY2(givenBack.error().detail.contains(u"pitch: target -20.0°, camera at 1"_s),
             qPrintable(givenBack.error().detail));
    QMap<QString, QString> goesOn = slow;
    goesOn.insert(u"release"_s, u"off"_s);
    const auto underWay = steer(goesOn);
    QVERIFY(underWay && !underWay->value(u"confirmed"_s, true).toBool());
    options.faults.blocked = 2;
    bench.board().setFaults(options.faults);
    const auto blocked = steer({{u"pitch"_s, u"-30"_s}, {u"speed"_s, u"60"_s}});
    QVERIFY(!blocked);
    QCOMPARE(blocked.error().code, ErrorCode::NotSeen);
    QVERIFY2(blocked.error().detail.contains(u"pitch: target -30.0°"_s), qPrintable(blocked.error().detail));
}

QTEST_GUILESS_MAIN(TestWriteTruth)
#include "tst_writetruth.moc"
