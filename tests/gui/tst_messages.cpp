// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/bars.h"
#include "app/mainwindow/linkbar.h"
#include "app/mainwindow/messagebar.h"
#include "app/mainwindow/messagehistory.h"
#include "app/mainwindow/palettesource.h"
#include "protocol/telemetry/telemetryplan.h"
#include "tests/support/patience.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/clickshield.h"
#include "widgets/forms/reviewdialog.h"

#include <QClipboard>
#include <QPlainTextEdit>
#include <QRegularExpression>
#include <QToolButton>

using namespace Qt::StringLiterals;

/// What the operator is told stands until its cause is gone, however much is told meanwhile, and what is
/// copied of it is enough for a supporter.
class TestMessages : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_rig = std::make_unique<WindowRig>(); }
    void cleanup() { m_rig.reset(); }

    void problemsStandBesideEachOther();
    void aWriteLooksLikeOne();
    void aWriteThatNeverBeganSaysSo();
    void anAnswerReplacesTheOneBefore();
    void noticesHideNoProblem();
    void theNextLinkKeepsMotorsThatMayRun();
    void anUnprovenStopGoesWithItsProof();
    void aStopWithoutALinkSaysSo();
    void aBoardThatRunsOnIsTold_data();
    void aBoardThatRunsOnIsTold();
    void aStopOutlivesTheLink_data();
    void aStopOutlivesTheLink();
    void aStopEndsWithTheConnection();
    void escClosesTheNewestOnly();
    void aSecondClickClosesNothingElse();
    void whoWasNotAskedIsTold();
    void problemsComeAlongIntoAnotherLanguage();
    void aGoodLoadSettlesABadOne();
    void copiesHoldProgramLinkAndBoard_data();
    void copiesHoldProgramLinkAndBoard();
    void copiesOfFailedConnectsHoldTheAddress();
    void copiesOfFilesSayThatNoBoardIsThere();
    void commandsForMotorsAreCommands();
    void aLateStopIsTold();
    void anUnansweredStartMayComeYet();
    void anOrderedRestartIsNoBrokenLink();
    void aRestartOfItsOwnIsTold();
    void aStopThatWasKeptIsToldOnce();
    void whatWasMendedIsWithdrawn();
    void whatWasToldCanBeReadLater();

private:
    [[nodiscard]] MainWindow &window() { return m_rig->window(); }
    [[nodiscard]] Workspace &workspace() { return m_rig->workspace(); }
    [[nodiscard]] MessageBar &bar() { return *window().messageBar(); }
    [[nodiscard]] Notifications &told() { return workspace().notifications(); }
    [[nodiscard]] QList<QToolButton *> buttons(const QString &name)
    {
        QList<QToolButton *> found;
        for (auto *button : bar().findChildren<QToolButton *>()) {
            if ((button->text() == name || button->accessibleName() == name) && !button->isHidden())
                found.append(button);
        }
        return found;
    }
    QString copied()
    {
        const QList<QToolButton *> copies = buttons(u"Copy"_s);
        if (copies.isEmpty())
            return {};
        QGuiApplication::clipboard()->clear();
        copies.last()->click();
        return QGuiApplication::clipboard()->text();
    }

    /// All that the bar says from now on: the next look may be too late for what stands there for a moment.
    std::shared_ptr<QStringList> watchBar()
    {
        auto said = std::make_shared<QStringList>();
        const auto note = [shown = &bar(), said] { said->append(shown->text()); };
        connect(&told(), &Notifications::problem, &bar(), note);
        connect(&told(), &Notifications::notice, &bar(), note);
        connect(&told(), &Notifications::withdrawn, &bar(), note);
        return said;
    }

    std::unique_ptr<WindowRig> m_rig;
};

namespace {

bool anySays(const QStringList &said, const QString &words, const QString &without = {})
{
    return std::any_of(said.begin(), said.end(), [&](const QString &text) {
        return text.contains(words) && (without.isEmpty() || !text.contains(without));
    });
}

ErrorText problem(const QString &what)
{
    return {what, {}, {}, {}};
}

}  // namespace

void TestMessages::problemsStandBesideEachOther()
{
    told().report(problem(u"One"_s), Concern::Reading);
    told().report(problem(u"Two"_s), Concern::LiveData);
    told().report(problem(u"Three"_s), Concern::Reading);
    told().report(problem(u"Three"_s), Concern::Reading);
    QCOMPARE(bar().text(), u"One\nTwo\nThree"_s);
    told().settle(Concern::LiveData);
    QCOMPARE(bar().text(), u"One\nThree"_s);
    told().settle(Concern::Reading);
    QVERIFY(!bar().isVisible());
}

void TestMessages::anAnswerReplacesTheOneBefore()
{
    told().report(problem(u"Stands"_s), Concern::Journal);
    told().report(problem(u"First"_s));
    told().report(problem(u"Second"_s));
    QCOMPARE(bar().text(), u"Stands\nSecond"_s);
    told().notify(u"Done"_s);
    QCOMPARE(bar().text(), u"Stands\nSecond\nDone"_s);
}

void TestMessages::noticesHideNoProblem()
{
    told().reportMotorsMayRun(u"Nobody knows."_s);
    for (const Notice kind : {Notice::Attention, Notice::Done, Notice::Hint}) {
        told().notify(u"Something else"_s, kind);
        QVERIFY(bar().text().contains(u"Nobody knows."_s));
        QVERIFY(bar().text().contains(u"Something else"_s));
        QVERIFY(bar().property("severe").toBool());
    }
    // What asks for attention does not go with the next notice either.
    told().notify(u"Left out"_s, Notice::Attention);
    told().notify(u"Saved"_s);
    QVERIFY(bar().text().contains(u"Left out"_s));
    // Nor does the frame turn to the colour of success.
    told().settle(Concern::Motors);
    QVERIFY(!bar().property("severe").toBool() && bar().property("warns").toBool());
}

void TestMessages::theNextLinkKeepsMotorsThatMayRun()
{
    told().reportMotorsMayRun(u"Nobody knows."_s);
    told().report(problem(u"A matter of the last link"_s), Concern::LiveData);
    QVERIFY(m_rig->open());
    QVERIFY(bar().text().contains(u"Nobody knows."_s));
    QVERIFY(!bar().text().contains(u"last link"_s));
}

// The board ignores the command for half a minute, or for ever; it is repeated, and what is said stays true.
void TestMessages::anUnprovenStopGoesWithItsProof()
{
    QVERIFY(m_rig->open());
    QVERIFY(
        QTest::qWaitFor([this] { return workspace().motorsRunning() == std::optional(true); }, kPatience));
    const auto said = watchBar();
    workspace().changeWorld(u"deaf=109"_s);
    workspace().setMotors(false);
    QTRY_VERIFY(anySays(*said, u"did not confirm"_s));
    QVERIFY(m_rig->client().isStopUnproven());
    workspace().changeWorld(u"deaf=-1"_s);
    QTRY_COMPARE(workspace().motorsRunning(), std::optional(false));
    QTRY_VERIFY(!bar().text().contains(u"did not confirm"_s));
    QTRY_VERIFY(!m_rig->client().isStopUnproven());
}

void TestMessages::aStopWithoutALinkSaysSo()
{
    QTest::keyClick(&window(), Qt::Key_F12);
    QTRY_VERIFY(bar().text().contains(u"There is no connection: nothing was sent"_s));
    QVERIFY2(!bar().text().contains(u"did not confirm"_s), qPrintable(bar().text()));
    QVERIFY(m_rig->open());
    QVERIFY2(!bar().text().contains(u"nothing was sent"_s), qPrintable(bar().text()));
}

void TestMessages::aBoardThatRunsOnIsTold_data()
{
    QTest::addColumn<QString>("address");
    QTest::newRow("SimpleBGC") << u"sim:simplebgc"_s;
    QTest::newRow("STorM32") << u"sim:storm32"_s;
}

void TestMessages::aBoardThatRunsOnIsTold()
{
    QFETCH(const QString, address);
    QVERIFY(m_rig->open(address));
    QTRY_COMPARE(workspace().motorsRunning(), std::optional(true));
    QTRY_VERIFY(!workspace().isStarting());
    workspace().changeWorld(u"runs-on=1"_s);
    workspace().setMotors(false);
    QTRY_VERIFY2(bar().text().contains(u"The motors run on although"_s), qPrintable(bar().text()));
    QVERIFY2(!bar().text().contains(u"may still be running"_s), qPrintable(bar().text()));
    workspace().changeWorld(u"runs-on=0"_s);
    QTRY_COMPARE(workspace().motorsRunning(), std::optional(false));
    QTRY_VERIFY(!bar().text().contains(u"The motors run on"_s));
}

// A stop that has not worked yet is not forgotten with the link; what is told of it is true all the time.
void TestMessages::aStopOutlivesTheLink_data()
{
    QTest::addColumn<QString>("address");
    QTest::addColumn<QString>("breaks");
    QTest::addColumn<bool>("waits");
    for (const QString &family : {u"simplebgc"_s, u"storm32"_s}) {
        QTest::addRow("%s, the link, repeated", qPrintable(family))
            << u"sim:"_s + family << u"unplug=0"_s << true;
        QTest::addRow("%s, the link, at once", qPrintable(family))
            << u"sim:"_s + family << u"unplug=0"_s << false;
        QTest::addRow("%s, the board", qPrintable(family)) << u"sim:"_s + family << u"reset=0.1"_s << true;
    }
}

void TestMessages::aStopOutlivesTheLink()
{
    QFETCH(const QString, address);
    QFETCH(const QString, breaks);
    QFETCH(const bool, waits);
    QVERIFY(m_rig->open(address));
    QTRY_COMPARE(workspace().motorsRunning(), std::optional(true));
    QTRY_VERIFY(!workspace().isStarting());
    workspace().changeWorld(u"runs-on=1"_s);
    workspace().changeWorld(u"replug=1"_s);
    workspace().setMotors(false);
    if (waits)
        QTRY_VERIFY2(bar().text().contains(u"stopping them is repeated"_s), qPrintable(bar().text()));
    QList<DeviceClient::State> states;
    QObject watching;
    connect(&m_rig->client(), &DeviceClient::stateChanged, &watching,
            [this, &states] { states.append(m_rig->client().state()); });
    const auto said = watchBar();
    workspace().changeWorld(breaks);
    QTRY_VERIFY(states.contains(DeviceClient::State::Reconnecting));
    QTRY_VERIFY2(anySays(*said, u"switched off as soon as"_s, u"is repeated"_s), qPrintable(bar().text()));
    QTRY_VERIFY(m_rig->client().isConnected());
    workspace().changeWorld(u"runs-on=0"_s);
    QTRY_COMPARE(workspace().motorsRunning(), std::optional(false));
    QTRY_VERIFY(!bar().text().contains(u"run on"_s) && !bar().text().contains(u"as soon as"_s));
}

// The operator has ended the connection: nothing is repeated any more.
void TestMessages::aStopEndsWithTheConnection()
{
    QVERIFY(m_rig->open());
    QTRY_COMPARE(workspace().motorsRunning(), std::optional(true));
    workspace().changeWorld(u"runs-on=1"_s);
    workspace().setMotors(false);
    QTRY_VERIFY2(bar().text().contains(u"stopping them is repeated"_s), qPrintable(bar().text()));
    m_rig->client().disconnectFromBoard();
    QTRY_VERIFY(m_rig->client().state() == DeviceClient::State::Disconnected);
    QVERIFY2(!bar().text().contains(u"is repeated"_s), qPrintable(bar().text()));
    QVERIFY2(bar().text().contains(u"ended before the motors were seen to stop"_s), qPrintable(bar().text()));
    // It stays until they are seen to be off.
    QVERIFY(m_rig->open());
    workspace().setMotors(false);
    QTRY_VERIFY2(!bar().text().contains(u"were seen to stop"_s), qPrintable(bar().text()));
}

void TestMessages::escClosesTheNewestOnly()
{
    QVERIFY(m_rig->open());
    QVERIFY(window().showPage(u"parameters"_s));
    QVERIFY(QTest::qWaitForWindowActive(&window()));
    bar().hide();
    told().report(problem(u"One"_s), Concern::Reading);
    told().report(problem(u"Two"_s), Concern::Saving);
    window().page(u"parameters"_s)->findChild<QWidget *>(u"pid.roll.p"_s)->setFocus();
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    QCOMPARE(bar().text(), u"One"_s);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    QVERIFY(!bar().isVisible());
}

void TestMessages::aSecondClickClosesNothingElse()
{
    told().report(problem(u"One"_s), Concern::Reading);
    told().report(problem(u"Two"_s), Concern::Saving);
    QVERIFY(m_rig->isSettled());
    QTRY_VERIFY(!window().findChild<ClickShield *>());
    const auto click = [this](const QWidget *button) {
        QTest::mouseClick(window().windowHandle(), Qt::LeftButton, {},
                          button->mapTo(&window(), button->rect().center()));
    };
    click(buttons(u"Close message"_s).first());
    QCOMPARE(bar().text(), u"Two"_s);
    QVERIFY(m_rig->isSettled());
    click(buttons(u"Close message"_s).first());
    QCOMPARE(bar().text(), u"Two"_s);
    QTRY_VERIFY((click(buttons(u"Close message"_s).first()), !bar().isVisible()));
}

// Who is not asked there unless the address names it, and who is elsewhere.
void TestMessages::whoWasNotAskedIsTold()
{
    Family shy = allFamilies().first();
    QVERIFY(shy.livesOn(LinkAddress::Kind::Tcp));
    shy.key = u"shy"_s;
    shy.name = u"Shy"_s;
    for (FamilyLink &link : shy.links)
        link.mayAskAnybody = false;
    Family away = shy;
    away.key = u"away"_s;
    away.name = u"Away"_s;
    away.links = {{LinkAddress::Kind::Udp}};
    away.usualAddress = u"udp://192.0.2.1:2020"_s;
    m_rig = std::make_unique<WindowRig>(allLinks(), allFamilies() + QList<Family>{shy, away});
    window().openLink(u"tcp://127.0.0.1:9"_s);
    QTRY_VERIFY(bar().text().contains(u"Nothing answers"_s));
    QVERIFY2(!bar().text().contains(u"?family="_s), qPrintable(bar().text()));
    emit m_rig->client().connectionFailed({ErrorCode::SilentPeer, {}, 0});
    QVERIFY2(bar().text().contains(u"add ?family=shy to the address"_s), qPrintable(bar().text()));
    QVERIFY2(bar().text().contains(u"Away is not reached this way; it is usually at udp://192.0.2.1:2020"_s),
             qPrintable(bar().text()));
}

void TestMessages::problemsComeAlongIntoAnotherLanguage()
{
    told().report(problem(u"One"_s), Concern::Reading);
    told().report(problem(u"Two"_s), Concern::LiveData);
    told().notify(u"Three"_s, Notice::Attention);
    window().renew();
    QCOMPARE(bar().text(), u"One\nTwo\nThree"_s);
    QTRY_VERIFY(bar().isVisible());
    told().settle(Concern::Reading);
    QCOMPARE(bar().text(), u"Two\nThree"_s);
    told().settle(Concern::LiveData);
    QCOMPARE(bar().text(), u"Three"_s);
}

void TestMessages::aGoodLoadSettlesABadOne()
{
    QVERIFY(m_rig->open());
    const QString good = m_rig->filePath(u"good.json"_s);
    QVERIFY(workspace().saveFile(good));
    m_rig->client().disconnectFromBoard();
    QTRY_COMPARE(m_rig->client().state(), DeviceClient::State::Disconnected);
    window().openFile(m_rig->filePath(u"missing.json"_s));
    QVERIFY(bar().text().contains(u"missing.json"_s));
    told().report(problem(u"Another matter"_s), Concern::Journal);
    window().openFile(good);
    QVERIFY(!bar().text().contains(u"missing.json"_s));
    QVERIFY(bar().text().contains(u"Another matter"_s));
}

void TestMessages::copiesHoldProgramLinkAndBoard_data()
{
    QTest::addColumn<QString>("address");
    QTest::newRow("simplebgc") << u"sim:simplebgc"_s;
    QTest::newRow("storm32") << u"sim:storm32"_s;
}

void TestMessages::copiesHoldProgramLinkAndBoard()
{
    QFETCH(QString, address);
    QVERIFY(m_rig->open(address));
    told().report(problem(u"It broke."_s));
    const QString text = copied();
    const BoardIdentity &board = m_rig->client().identity();
    for (const QString &part :
         {u"It broke."_s, u"GimbalDesk " GIMBAL_VERSION ""_s, QSysInfo::prettyProductName(), address,
          u"connected"_s, board.model, board.firmware,
          board.isNumbered() ? board.serial : board.extra.value(u"name"_s).toString()})
        QVERIFY2(text.contains(part), qPrintable(part + u" is not in: "_s + text));
}

void TestMessages::copiesOfFailedConnectsHoldTheAddress()
{
    window().openLink(u"serial:/dev/nonexistent"_s);
    QTRY_VERIFY(bar().text().contains(u"no such port"_s));
    const QString text = copied();
    QVERIFY2(text.contains(u"Link: serial:/dev/nonexistent, not connected"_s), qPrintable(text));
    QVERIFY2(text.contains(u"Board: none"_s), qPrintable(text));
}

void TestMessages::copiesOfFilesSayThatNoBoardIsThere()
{
    QVERIFY(m_rig->open());
    const QString firmware = m_rig->client().identity().firmware;
    m_rig->client().disconnectFromBoard();
    QTRY_COMPARE(m_rig->client().state(), DeviceClient::State::Disconnected);
    told().report(problem(u"It broke."_s));
    const QString text = copied();
    QVERIFY2(text.contains(firmware) && text.contains(u"not connected"_s)
                 && text.contains(u"read before, or from a file"_s),
             qPrintable(text));
}

void TestMessages::commandsForMotorsAreCommands()
{
    QVERIFY(m_rig->open());
    QStringList names;
    for (const PaletteEntry &entry : paletteEntries(workspace(), *window().navigation(), {}))
        names.append(entry.text);
    QVERIFY(names.contains(u"Stop motors"_s));
    QVERIFY(names.contains(u"Start motors"_s));
    QVERIFY2(names.filter(QRegularExpression(u"^Motors (on|off)$"_s)).isEmpty(),
             qPrintable(names.join(u", "_s)));
}

// Until the board has shown that it obeys, the operator is not left alone with a button that seems dead.
void TestMessages::aLateStopIsTold()
{
    QVERIFY(m_rig->open(u"sim:storm32"_s));
    QTRY_VERIFY(workspace().motorsRunning() == true);
    workspace().changeWorld(u"runs-on=1"_s);
    const QString late = u"does not confirm yet that the motors are off"_s;
    QElapsedTimer since;
    since.start();
    workspace().setMotors(false);
    QTRY_VERIFY(bar().text().contains(late));
    QVERIFY(since.elapsed() >= 900);
    // What is known then takes its place.
    QTRY_VERIFY(!bar().text().contains(late));
    QVERIFY2(bar().text().contains(u"motors"_s), qPrintable(bar().text()));
    workspace().changeWorld(u"runs-on=0"_s);
    QTRY_COMPARE(workspace().motorsRunning(), std::optional(false));
}

// Whoever puts his hands on the gimbal because the start has "failed" is hurt by it.
void TestMessages::anUnansweredStartMayComeYet()
{
    QVERIFY(m_rig->open());
    QTRY_VERIFY(workspace().motorsRunning().has_value());
    workspace().setMotors(false);
    QTRY_COMPARE(workspace().motorsRunning(), false);
    QVERIFY(m_rig->jobsAreDone());
    workspace().changeWorld(u"late=5000"_s);
    workspace().setMotors(true);
    QTRY_VERIFY_WITH_TIMEOUT(bar().text().contains(u"They may start yet"_s), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(bar().text().contains(u"has carried out the start"_s), kPatience);
    QVERIFY(!bar().text().contains(u"They may start yet"_s));
    QCOMPARE(workspace().motorsRunning(), true);
}

void TestMessages::anOrderedRestartIsNoBrokenLink()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?rate=115200"_s));
    QSignalSpy problems(&told(), &Notifications::problem);
    QStringList notices;
    connect(&told(), &Notifications::notice, &window(),
            [&notices](const QString &text, Notice) { notices.append(text); });
    workspace().perform(u"reset"_s, {{u"delay"_s, 500}});
    QTRY_VERIFY(notices.contains(u"The board has restarted and is back."_s));
    QVERIFY(notices.filter(u"restarts, as it was told to"_s).size() == 1);
    QCOMPARE(problems.count(), 0);
    QVERIFY(!notices.contains(u"Connected again."_s));
    // That it is back is no news once it is gone.
    QTRY_VERIFY(bar().text().contains(u"is back"_s));
    m_rig->client().disconnectFromBoard();
    QTRY_VERIFY(!m_rig->client().isConnected());
    QVERIFY2(!bar().text().contains(u"is back"_s), qPrintable(bar().text()));
}

void TestMessages::aWriteThatNeverBeganSaysSo()
{
    QVERIFY(m_rig->open());
    m_rig->edit(u"pid.roll.p"_s, 0, 44);
    workspace().changeWorld(u"deaf=21"_s);  // READ_PARAMS_3: no backup, nothing to compare with
    workspace().write(std::as_const(workspace().configuration()).edited());
    QTRY_VERIFY_WITH_TIMEOUT(bar().text().contains(u"Nothing was written."_s), kPatience);
}

// From the first moment, also while it still reads.
void TestMessages::aWriteLooksLikeOne()
{
    QVERIFY(m_rig->open(u"sim:simplebgc"_s));
    QVERIFY(m_rig->jobsAreDone());
    m_rig->edit(u"pid.roll.p"_s, 0, 55);
    auto *link = window().findChild<LinkBar *>();
    const auto *button = window().findChild<UnsavedBar *>()->writeButton();
    QVERIFY(button->isEnabled());
    QSignalSpy finished(&workspace(), &Workspace::writeFinished);
    window().review();
    QVERIFY(window().reviewDialog());
    window().reviewDialog()->accept();
    QVERIFY(workspace().isWriting());
    QVERIFY(!button->isEnabled());
    QVERIFY2(link->stateText().startsWith(u"Writing"_s), qPrintable(link->stateText()));
    QTRY_COMPARE(finished.count(), 1);
    QTRY_VERIFY(!link->stateText().startsWith(u"Writing"_s));
}

void TestMessages::aRestartOfItsOwnIsTold()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?rate=115200"_s));
    QTRY_VERIFY(m_rig->client().telemetryPlan().streaming);
    LiveModel &live = workspace().live();
    const int p = m_rig->spec(u"pid.roll.p"_s).id;
    live.setValue(p, 61);
    QTRY_VERIFY(live.isSettled() && live.changeCount() == 1);
    QSignalSpy problems(&told(), &Notifications::problem);
    QMap<QString, Notice> notices;
    connect(&told(), &Notifications::notice, &window(),
            [&notices](const QString &text, Notice kind) { notices.insert(text, kind); });
    workspace().changeWorld(u"reset=0"_s);
    QTRY_COMPARE(problems.count(), 1);
    QCOMPARE(problems.first().first().value<ErrorText>().what, u"The board restarted by itself."_s);
    QTRY_VERIFY(m_rig->client().isConnected());
    const QString back = u"The board restarted by itself and is back. It uses the stored values."_s;
    QTRY_VERIFY(notices.contains(back));
    QVERIFY(notices.value(back) == Notice::Attention);
    const QString told
        = QStringList(notices.keys()).filter(u"the board restarted. In use before: "_s).join(u'\n');
    QVERIFY2(told.startsWith(u"1 value"_s) && told.endsWith(u" 61"_s), qPrintable(told));
    QTRY_VERIFY(live.value(p) && *live.value(p) == m_rig->raw(u"pid.roll.p"_s));
    QCOMPARE(live.changeCount(), 0);
    // Until they are proven off.
    QVERIFY2(bar().text().contains(back + u" Its motors may run."_s), qPrintable(bar().text()));
    workspace().setMotors(false);
    QTRY_VERIFY(!bar().text().contains(u"may run"_s));
    QTRY_COMPARE(workspace().motorsRunning(), std::optional(false));
    QVERIFY2(bar().text().contains(back), qPrintable(bar().text()));
}

void TestMessages::aStopThatWasKeptIsToldOnce()
{
    QVERIFY(m_rig->open());
    workspace().changeWorld(u"replug=1"_s);
    workspace().changeWorld(u"unplug=0"_s);
    QTRY_COMPARE(m_rig->client().state(), DeviceClient::State::Reconnecting);
    workspace().setMotors(false);
    QVERIFY(bar().text().contains(u"There is no link yet."_s));
    QTRY_COMPARE(workspace().motorsRunning(), std::optional(false));
    QTRY_VERIFY2(!bar().text().contains(u"There is no link yet."_s), qPrintable(bar().text()));
}

void TestMessages::whatWasMendedIsWithdrawn()
{
    QVERIFY(m_rig->open());
    RefusedTexts &refused = workspace().edits().refused();
    for (const bool isLater : {false, true}) {
        refused.set(m_rig->spec(u"pid.pitch.p"_s), 0, u"300"_s);
        window().review();
        QVERIFY2(bar().text().contains(u"“300” is no value"_s), qPrintable(bar().text()));
        refused.set(m_rig->spec(u"pid.yaw.p"_s), 0, u"400"_s);
        QVERIFY(bar().text().contains(u"“300” is no value"_s));
        if (isLater)
            window().showPage(u"dashboard"_s);
        refused.set(m_rig->spec(u"pid.pitch.p"_s), 0, std::nullopt);
        QVERIFY2(!bar().text().contains(u"is no value"_s), qPrintable(bar().text()));
        refused.clear();
    }
}

void TestMessages::whatWasToldCanBeReadLater()
{
    told().report(problem(u"One"_s), Concern::Reading);
    told().settle(Concern::Reading);
    told().notify(u"Two"_s);
    const auto entries = paletteEntries(workspace(), *window().navigation(), {});
    QVERIFY(std::any_of(entries.begin(), entries.end(),
                        [](const PaletteEntry &entry) { return entry.text == u"Messages so far"_s; }));
    const MessageHistory history(told());
    const QStringList lines = history.findChild<QPlainTextEdit *>()->toPlainText().split(u'\n');
    QVERIFY2(lines[0].endsWith(u"✓ Two"_s) && lines[1].endsWith(u"✖ One"_s), qPrintable(lines.join(u'|')));
    for (int i = 0; i < 1000; ++i)
        told().notify(u"Again"_s);
    QVERIFY(told().history().size() < 1000);
}

QTEST_MAIN(TestMessages)
#include "tst_messages.moc"
