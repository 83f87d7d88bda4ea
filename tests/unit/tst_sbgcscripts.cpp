// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/record/keptscripts.h"
#include "protocol/simplebgc/messages.h"
#include "tests/support/sbgcrig.h"

using namespace Qt::StringLiterals;
using namespace simplebgc;

namespace {

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

#define DONE(outcome) QVERIFY2((outcome), (outcome) ? "" : qPrintable((outcome).error().detail))

/// Compiled scripts in the slots of a SimpleBGC board.
class TestSbgcScripts final : public QObject
{
    Q_OBJECT
private slots:
    void everySlotTellsItsSize();
    void olderFirmwareHasFiveSlots();
    void scriptsComeBack();
    void whatWasInTheSlotIsKept();
    void whatIsRefusedLeavesTheSlotAsItWas();
    void cancelledUploadIsTakenBack();
    void halfAnUploadIsKnown();
    void wrongFilesAreRefusedFirst();
    void scriptsRun();
    void anotherOneTakesItsPlace();
    void stopIsProvenByAnEvent();
    void scriptIsFollowed();
    void followedScriptIsStopped();
    void scriptThatIsTakenAwayEndsWithItsReason();

private:
    static QString put(SbgcRig &rig, const QString &name, const QByteArray &content)
    {
        QFile file(rig.path(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
            qFatal("no file");
        return file.fileName();
    }
    /// Loads a script past all that the program does for one.
    static bool place(SbgcRig &rig, int slot, const QByteArray &content)
    {
        return rig
            .perform("file.load",
                     {{u"type"_s, u"script"_s},
                      {u"number"_s, QString::number(slot - 1)},
                      {u"file"_s, put(rig, u"placed"_s, content)}})
            .has_value();
    }
    static Result<ActionReply> load(SbgcRig &rig, int slot, const QByteArray &content,
                                    const QString &keep = u"kept"_s)
    {
        return rig.perform("script.load",
                           {{u"slot"_s, QString::number(slot)},
                            {u"file"_s, put(rig, u"new"_s, content)},
                            {u"keep"_s, rig.path(keep)}});
    }
    static QByteArray inSlot(SbgcRig &rig, int slot)
    {
        const QString path = rig.path(u"back"_s);
        QFile::remove(path);
        const auto saved
            = rig.perform("script.save", {{u"slot"_s, QString::number(slot)}, {u"file"_s, path}});
        return saved ? contentOf(path) : QByteArray();
    }
};

void TestSbgcScripts::everySlotTellsItsSize()
{
    SbgcRig rig;
    auto told = rig.perform("script.list");
    DONE(told);
    QCOMPARE(told->size(), 10);
    QCOMPARE(told->value(u"script7.bytes"_s).toInt(), 0);
    QVERIFY(place(rig, 3, "abc"));
    QVERIFY(place(rig, 7, QByteArray(300, 'x')));
    told = rig.perform("script.list");
    DONE(told);
    QCOMPARE(told->value(u"script3.bytes"_s).toInt(), 3);
    QCOMPARE(told->value(u"script7.bytes"_s).toInt(), 300);
    // BOARD_INFO_3 tells the same, the later slots at offset 40 (errata 3.2).
    const auto info
        = rig.channel.transact(replyRequest(CommandId::BoardInfo3, {}, CommandId::BoardInfo3, 69, 1));
    QVERIFY(info);
    QCOMPARE(int(BoardInfo3::decode(asBytes(info->payload))->scriptSizes[2]), 3);
    QCOMPARE(info->payload.mid(40, 10).toHex(), QByteArray("00002c01000000000000"));
}

void TestSbgcScripts::olderFirmwareHasFiveSlots()
{
    SbgcRig rig(2590);
    const auto told = rig.perform("script.list");
    DONE(told);
    QCOMPARE(told->size(), 5);
    SAYS(load(rig, 6, "abc"), u"slots 1 to 5"_s);
    SAYS(rig.perform("script", {{u"slot"_s, u"6"_s}}), u"slots 1 to 5"_s);
    DONE(load(rig, 5, "abc"));
    QCOMPARE(inSlot(rig, 5), QByteArray("abc"));
}

void TestSbgcScripts::scriptsComeBack()
{
    SbgcRig rig;
    const QByteArray script = ramp(200) + QByteArray(7, '\xff');
    const auto loaded = load(rig, 10, script);
    DONE(loaded);
    QCOMPARE(loaded->value(u"bytes"_s).toInt(), 207);
    QVERIFY(!loaded->contains(u"kept"_s));  // there was none
    QVERIFY(!QFile::exists(rig.path(u"kept"_s)) && !QFile::exists(rig.path(u"kept.part"_s)));
    QCOMPARE(inSlot(rig, 10), script);
}

void TestSbgcScripts::whatWasInTheSlotIsKept()
{
    SbgcRig rig;
    QVERIFY(place(rig, 2, QByteArray(500, 'a')));
    const auto loaded = load(rig, 2, "new");
    DONE(loaded);
    QCOMPARE(loaded->value(u"kept"_s).toString(), rig.path(u"kept"_s));
    QCOMPARE(contentOf(rig.path(u"kept"_s)), QByteArray(500, 'a'));
    // A copy is never written over.
    SAYS(load(rig, 2, "newer"), u"is there already"_s);
    QCOMPARE(inSlot(rig, 2), QByteArray("new"));
    const auto erased
        = rig.perform("script.erase", {{u"slot"_s, u"2"_s}, {u"keep"_s, rig.path(u"erased"_s)}});
    DONE(erased);
    QCOMPARE(contentOf(rig.path(u"erased"_s)), QByteArray("new"));
    QCOMPARE(rig.perform("script.list")->value(u"script2.bytes"_s).toInt(), 0);
    SAYS(rig.perform("script.erase", {{u"slot"_s, u"2"_s}, {u"keep"_s, rig.path(u"more"_s)}}),
         u"slot 2 holds no script"_s);
    SAYS(rig.perform("script.save", {{u"slot"_s, u"2"_s}, {u"file"_s, rig.path(u"more"_s)}}),
         u"slot 2 holds no script"_s);
    // What was kept goes back.
    DONE(rig.perform(
        "script.load",
        {{u"slot"_s, u"2"_s}, {u"file"_s, rig.path(u"kept"_s)}, {u"keep"_s, rig.path(u"more"_s)}}));
    QCOMPARE(inSlot(rig, 2), QByteArray(500, 'a'));
    // The same once more changes nothing.
    const auto same = rig.perform(
        "script.load",
        {{u"slot"_s, u"2"_s}, {u"file"_s, rig.path(u"kept"_s)}, {u"keep"_s, rig.path(u"more"_s)}});
    DONE(same);
    QVERIFY(same->value(u"unchanged"_s).toBool() && !QFile::exists(rig.path(u"more"_s)));
}

void TestSbgcScripts::whatIsRefusedLeavesTheSlotAsItWas()
{
    SbgcRig rig;
    QVERIFY(place(rig, 1, QByteArray(60000, 'a')));
    QVERIFY(place(rig, 2, "old"));
    const auto refused = load(rig, 2, QByteArray(20000, 'b'));
    SAYS(refused, u"no free space"_s);
    QVERIFY2(refused.error().detail.contains(u"slot 2 holds again what it held before"_s),
             qPrintable(refused.error().detail));
    QCOMPARE(inSlot(rig, 2), QByteArray("old"));
    QVERIFY(!QFile::exists(rig.path(u"kept"_s)) && !QFile::exists(rig.path(u"kept.part"_s)));
}

void TestSbgcScripts::cancelledUploadIsTakenBack()
{
    SbgcRig rig;
    QVERIFY(place(rig, 2, "old"));
    rig.channel.cancelAfter(400ms);
    const auto cancelled = load(rig, 2, QByteArray(60000, 'b'));
    QVERIFY(!cancelled);
    QCOMPARE(cancelled.error().code, ErrorCode::Cancelled);
    rig.channel.cancelAfter(100s);
    QCOMPARE(inSlot(rig, 2), QByteArray("old"));
}

// The link is gone for good: what the slot held is in the copy, whose name tells of it.
void TestSbgcScripts::halfAnUploadIsKnown()
{
    SbgcRig rig;
    const BoardHistory history(rig.path(u"history"_s));
    const KeptScripts kept(history, u"0102"_s);
    QVERIFY(place(rig, 2, "old"));
    const QString keep = kept.next(2);
    Faults faults;
    faults.deaf = number(CommandId::WriteFile);
    rig.board().setFaults(faults);
    const auto broken = rig.perform(
        "script.load",
        {{u"slot"_s, u"2"_s}, {u"file"_s, put(rig, u"new"_s, QByteArray(900, 'b'))}, {u"keep"_s, keep}});
    SAYS(broken, u"what slot 2 holds now is not known"_s);
    QVERIFY(kept.isUnfinished(2) && !kept.isUnfinished(1));
    QCOMPARE(kept.copies(2).size(), 1);
    QCOMPARE(contentOf(kept.copies(2).first().path), QByteArray("old"));
    kept.settle(2);
    QVERIFY(!kept.isUnfinished(2));
    QCOMPARE(contentOf(keep), QByteArray("old"));
    QCOMPARE(kept.copies(2).first().bytes, 3);
    QVERIFY(kept.copies(2).first().time.secsTo(QDateTime::currentDateTimeUtc()) < 3600);
}

void TestSbgcScripts::wrongFilesAreRefusedFirst()
{
    SbgcRig rig;
    QVERIFY(place(rig, 1, "old"));
    QVERIFY(!load(rig, 1, {}));
    QVERIFY(!load(rig, 1, QByteArray(65536, 'a')));
    QVERIFY(!rig.perform(
        "script.load",
        {{u"slot"_s, u"1"_s}, {u"file"_s, rig.path(u"missing"_s)}, {u"keep"_s, rig.path(u"kept"_s)}}));
    QCOMPARE(inSlot(rig, 1), QByteArray("old"));
}

void TestSbgcScripts::scriptsRun()
{
    SbgcRig rig;
    SAYS(rig.perform("script", {{u"slot"_s, u"3"_s}}), u"slot 3 holds no script"_s);
    // The board refuses it too.
    SAYS(rig.channel.transact(
             confirmRequest(CommandId::RunScript, ByteWriter().u8(1).u8(2).zeros(32).take(), 1)),
         u"wrong parameters"_s);
    QVERIFY(place(rig, 3, "abc"));
    const auto lines = rig.channel.listen(
        [](const FrameView &frame) { return frame.id == number(CommandId::ScriptDebug); });
    const auto begun = rig.perform("script", {{u"slot"_s, u"3"_s}, {u"mode"_s, u"debug"_s}});
    DONE(begun);
    QVERIFY(begun->value(u"running"_s).toBool());
    for (int line = 1; line <= 3; ++line) {
        const auto told = lines->next(1s);
        QVERIFY(told);
        QCOMPARE(told->payload.toHex(), QByteArray("0") + QByteArray::number(line) + "0000");
    }
    QVERIFY(!lines->next(1s));
    // Without being asked for it tells nothing.
    DONE(rig.perform("script", {{u"slot"_s, u"3"_s}}));
    QVERIFY(!lines->next(1s));
}

void TestSbgcScripts::anotherOneTakesItsPlace()
{
    SbgcRig rig;
    QVERIFY(place(rig, 1, QByteArray(100, 'a')));
    QVERIFY(place(rig, 2, "abc"));
    DONE(rig.perform("script", {{u"slot"_s, u"1"_s}, {u"mode"_s, u"debug"_s}}));
    const auto second = rig.perform("script.follow", {{u"slot"_s, u"2"_s}});
    DONE(second);
    QCOMPARE(second->value(u"command"_s).toInt(), 3);
    QVERIFY(second->value(u"ended"_s).toBool());
}

void TestSbgcScripts::stopIsProvenByAnEvent()
{
    SbgcRig rig;
    QVERIFY(place(rig, 1, QByteArray(100, 'a')));
    DONE(rig.perform("script", {{u"slot"_s, u"1"_s}}));
    auto stopped = rig.perform("script.stop");
    DONE(stopped);
    QVERIFY(stopped->value(u"stopped"_s).toBool());
    // Nothing ran, so nothing shows that it stopped.
    stopped = rig.perform("script.stop");
    DONE(stopped);
    QVERIFY(!stopped->contains(u"stopped"_s));
    // Firmware without events proves nothing either way.
    SbgcRig older(2590);
    QVERIFY(place(older, 1, QByteArray(100, 'a')));
    const auto begun = older.perform("script", {{u"slot"_s, u"1"_s}});
    DONE(begun);
    QVERIFY(!begun->contains(u"running"_s));
    stopped = older.perform("script", {{u"slot"_s, u"1"_s}, {u"mode"_s, u"stop"_s}});
    DONE(stopped);
    QVERIFY(!stopped->contains(u"stopped"_s));
}

void TestSbgcScripts::scriptIsFollowed()
{
    for (const int firmware : {2590, 2704}) {
        SbgcRig rig(firmware);
        SAYS(rig.perform("script.follow", {{u"slot"_s, u"2"_s}}), u"slot 2 holds no script"_s);
        QVERIFY(place(rig, 2, QByteArray(30, 'x')));
        const TimePoint begin = rig.channel.now();
        const auto done = rig.perform("script.follow", {{u"slot"_s, u"2"_s}});
        DONE(done);
        QCOMPARE(done->value(u"command"_s).toInt(), 30);
        QVERIFY(rig.channel.now() - begin >= 3s);
        // Only events tell the end from a script that waits.
        QCOMPARE(done->contains(u"ended"_s), firmware == 2704);
        QCOMPARE(rig.channel.now() - begin < 5s, firmware == 2704);
    }
}

// Who does not want to wait stops it on the board too.
void TestSbgcScripts::followedScriptIsStopped()
{
    SbgcRig rig;
    QVERIFY(place(rig, 2, QByteArray(300, 'x')));
    rig.channel.cancelAfter(1s);
    const auto cancelled = rig.perform("script.follow", {{u"slot"_s, u"2"_s}});
    QVERIFY(!cancelled);
    QCOMPARE(cancelled.error().code, ErrorCode::Cancelled);
    QVERIFY2(cancelled.error().detail.contains(u"stopped at command "_s),
             qPrintable(cancelled.error().detail));
    int more = 0;
    rig.channel.setTap([&more](const FrameView &frame, TimePoint) {
        more += frame.id == number(CommandId::ScriptDebug) ? 1 : 0;
    });
    rig.channel.cancelAfter(100s);
    std::ignore = rig.channel.sleep(2s);
    QCOMPARE(more, 0);
}

void TestSbgcScripts::scriptThatIsTakenAwayEndsWithItsReason()
{
    SbgcRig rig;
    QVERIFY(place(rig, 2, QByteArray(30, 'x')));
    const auto lines = rig.channel.listen(
        [](const FrameView &frame) { return frame.id == number(CommandId::ScriptDebug); });
    DONE(rig.perform("script", {{u"slot"_s, u"2"_s}, {u"mode"_s, u"debug"_s}}));
    DONE(rig.perform("file.erase", {{u"type"_s, u"script"_s}, {u"number"_s, u"1"_s}}));
    int code = 0;
    while (const auto told = lines->next(1s))
        code = quint8(told->payload[2]);
    QCOMPARE(code, 2);
}

QTEST_GUILESS_MAIN(TestSbgcScripts)
#include "tst_sbgcscripts.moc"
