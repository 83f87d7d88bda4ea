// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/bars.h"
#include "app/mainwindow/messagebar.h"
#include "app/mainwindow/navigation.h"
#include "app/pages/board/actionspage.h"
#include "app/pages/board/backupspage.h"
#include "app/pages/board/consolepage.h"
#include "app/pages/board/sharedialog.h"
#include "app/pages/setup/parameterspage.h"
#include "app/pages/setup/scriptspage.h"
#include "app/pages/tune/gaincard.h"
#include "app/pages/tune/spectrumpage.h"
#include "app/pages/tune/tuningpage.h"
#include "tests/support/named.h"
#include "tests/support/patience.h"
#include "tests/support/stormwindow.h"
#include "widgets/forms/panel.h"
#include "widgets/forms/parameterform.h"
#include "widgets/forms/valueeditor.h"
#include "widgets/models/framelogmodel.h"
#include "widgets/views/scripteditor.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTableWidget>
#include <QTest>
#include <QTextBrowser>

using namespace Qt::StringLiterals;

/// The operator's work with the values of a STorM32 board, on the simulated one.
class TestStorm : public StormWindowTest
{
    Q_OBJECT
private slots:
    void init() { m_rig = std::make_unique<WindowRig>(); }
    void cleanup() { m_rig.reset(); }

    void onlyFittingPagesAreOffered();
    void pageOfTheCommandLineAwaitsItsBoard();
    void pageThatTheBoardLacksIsTold();
    void slidersSetThreeGains();
    void unstoredValuesStayInSight();
    void closingAsksForWhatIsNotStored();
    void valuesWithoutEffectAreGrey();
    void scriptIsTypedTakenOverAndWritten();
    void typedScriptSurvivesACrash();
    void typedScriptIsAskedForWhenQuitting();
    void scriptsAreEditedInAFile();
    void spectrumOfPolledSamples();
    void consoleLeavesPollingOut();
    void snapshotsShowWhatDiffers();
    void heartbeatIsEscapedByOneClick();
    void settingsAreShared();
    void settingsFileIsLoadedAndSaved();
    void disabledMotorsAreToldWithALostLink();
    void repliesAndProfilesBelongToTheirBoard();
};

void TestStorm::onlyFittingPagesAreOffered()
{
    const Navigation &pages = *m_rig->window().navigation();
    // Before any board, those of the first family are there.
#if GIMBAL_WITH_SIMPLEBGC
    QVERIFY(pages.isOffered(u"calibration"_s) && !pages.isOffered(u"sensor"_s));
#else
    QVERIFY(!pages.isOffered(u"calibration"_s) && pages.isOffered(u"sensor"_s));
#endif
    QVERIFY(pages.isOffered(u"response"_s) && pages.isOffered(u"control"_s));
    QVERIFY(openStorm());
    for (const char *there :
         {"dashboard", "parameters", "setup", "sensor", "scripts", "tuning", "control", "backups"})
        QVERIFY2(pages.isOffered(QLatin1String(there)), there);
    for (const char *absent : {"calibration", "autotune", "profiles", "debug"}) {
        QVERIFY2(!pages.isOffered(QLatin1String(absent)), absent);
        QVERIFY(!m_rig->window().showPage(QLatin1String(absent)));
    }
    QCOMPARE(pages.pageOfNumber(4), u"setup"_s);  // numbers count what is listed
    QCOMPARE(pages.pageOfNumber(99), QString());
#if GIMBAL_WITH_SIMPLEBGC
    m_rig->window().showPage(u"scripts"_s);
    QVERIFY(m_rig->open());
    QTRY_VERIFY(pages.isOffered(u"calibration"_s) && !pages.isOffered(u"scripts"_s));
    QCOMPARE(pages.pageOfNumber(9), u"tuning"_s);
    QCOMPARE(pages.pageOfNumber(99), QString());
    QCOMPARE(pages.currentPage(), u"scriptslots"_s);  // the one of the same title, which this family has
#endif
}

void TestStorm::pageOfTheCommandLineAwaitsItsBoard()
{
    MainWindow &window = m_rig->window();
    Navigation &pages = *window.navigation();
    QVERIFY(!pages.awaitPage(u"nonsense"_s));
    QVERIFY(pages.awaitPage(u"scripts"_s));
    QVERIFY(openStorm());
    QTRY_COMPARE(pages.currentPage(), u"scripts"_s);
    QVERIFY(!window.messageBar()->text().contains(u"no page"_s));
    // Whoever goes elsewhere is not taken back by the next board.
    QVERIFY(window.showPage(u"dashboard"_s));
    QVERIFY(openStorm());
    QCOMPARE(pages.currentPage(), u"dashboard"_s);
}

// What another family has under the same title is shown; else it is said which pages there are.
void TestStorm::pageThatTheBoardLacksIsTold()
{
#if GIMBAL_WITH_SIMPLEBGC
    MainWindow &window = m_rig->window();
    const auto told = [&window] { return window.messageBar()->text(); };
    QVERIFY(window.showPage(u"calibration"_s));
    QVERIFY(openStorm());
    QTRY_COMPARE(window.navigation()->currentPage(), u"sensor"_s);
    QVERIFY2(!told().contains(u"no page"_s), qPrintable(told()));
    for (const bool isAwaited : {false, true}) {
        m_rig->restart();
        MainWindow &fresh = m_rig->window();
        QVERIFY(isAwaited ? fresh.navigation()->awaitPage(u"autotune"_s) : fresh.showPage(u"autotune"_s));
        QVERIFY(openStorm());
        QTRY_COMPARE(fresh.navigation()->currentPage(), u"dashboard"_s);
        const QString text = fresh.messageBar()->text();
        QVERIFY2(text.contains(u"This board has no page “Auto-tune”. It has: Dashboard, Monitor, "_s)
                     && text.contains(u"Gimbal setup"_s) && !text.contains(u"Profiles"_s),
                 qPrintable(text));
    }
#endif
}

void TestStorm::slidersSetThreeGains()
{
    QVERIFY(openStorm());
    auto *page = m_rig->page<TuningPage>();
    const auto gains = [page] { return page->findChild<GainCard *>(); };
    QVERIFY(gains());
    const auto slider = [&](const char *name) { return named<QSlider>(gains(), QLatin1String(name)); };
    const auto value = [&](const char *key) {
        return page->live().value(m_rig->spec(QLatin1String(key)).id).value_or(-1);
    };
    QTRY_COMPARE(value("pid.roll.p"), 400);
    const auto labels = gains()->findChildren<QLabel *>();
    const auto roll = std::find_if(labels.begin(), labels.end(),
                                   [](const QLabel *label) { return label->text() == u"Roll"_s; });
    QVERIFY(roll != labels.end() && (*std::next(roll))->text().contains(u"7.1 Hz"_s));
    slider("Damping, Roll")->setValue(50);
    slider("Stability, Roll")->setValue(20);
    // Kd 0.4, Ki 400, Kp sqrt(0.5 * 0.4 * 400) = 8.94 (errata 9.1)
    QTRY_COMPARE(value("pid.roll.d"), 4000);
    QCOMPARE(value("pid.roll.i"), 4000);
    QCOMPARE(value("pid.roll.p"), 894);
    QTRY_VERIFY(page->live().isSettled());
    QCOMPARE(inUse(8), 4000);
    QCOMPARE(inUse(6), 894);
    // The other way round: a gain moves the slider.
    page->live().setValue(m_rig->spec(u"pid.pitch.i"_s).id, 2000);
    QCOMPARE(slider("Stability, Pitch")->value(), 10);
    page->revertButton()->click();
    QTRY_COMPARE(inUse(8), 500);
    QCOMPARE(slider("Damping, Roll")->value(), 6);
}

void TestStorm::unstoredValuesStayInSight()
{
    QVERIFY(openStorm());
    UnstoredBar *bar = m_rig->window().findChild<UnstoredBar *>();
    QVERIFY(!bar->isVisible());
    auto *page = m_rig->page<TuningPage>();
    QTRY_VERIFY(page->live().value(m_rig->spec(u"pid.yaw.p"_s).id));
    page->live().setValue(m_rig->spec(u"pid.yaw.p"_s).id, 421);
    QTRY_VERIFY(bar->isVisible());
    m_rig->window().showPage(u"dashboard"_s);
    QVERIFY(bar->isVisible());  // on every page
    bar->storeButton()->click();
    QTRY_VERIFY(!bar->isVisible());
    QTRY_COMPARE(m_rig->raw(u"pid.yaw.p"_s), 421);
    workspace().perform(u"restart"_s, {});
    QTRY_COMPARE(inUse(12), 421);

    // A restart that was asked for elsewhere takes live values with it; the pages know.
    page->live().setValue(m_rig->spec(u"pid.yaw.p"_s).id, 433);
    QTRY_VERIFY(bar->isVisible());
    QTRY_COMPARE(inUse(12), 433);
    workspace().perform(u"restart"_s, {});
    QTRY_VERIFY(!bar->isVisible());
    QTRY_COMPARE(page->live().value(m_rig->spec(u"pid.yaw.p"_s).id), std::optional(421));

    // An action that changes what is in use says so as well, and there is a way back.
    workspace().perform(u"defaults"_s, {});
    QTRY_VERIFY(workspace().isUnstored() && bar->isVisible());
    QTRY_COMPARE(inUse(12), 400);
    // The board starts anew with it, and so may its motors: that is asked.
    bar->backButton()->click();
    QCOMPARE(inUse(12), 400);
    QVERIFY(workspace().isUnstored());
    auto *question = m_rig->window().panels()->findChild<QDialog *>();
    QVERIFY(question);
    named<QPushButton>(question, u"Revert all"_s)->click();
    QTRY_VERIFY(!workspace().isUnstored() && !bar->isVisible());
    QTRY_COMPARE(inUse(12), 421);
}

void TestStorm::closingAsksForWhatIsNotStored()
{
    QVERIFY(openStorm());
    workspace().perform(u"directions.take"_s, {});  // they are stored already: nothing to ask about
    QVERIFY(m_rig->jobsAreDone() && m_rig->jobsAreDone());
    QVERIFY(!workspace().isUnstored());
    workspace().perform(u"setup.poles"_s, {{u"pitch"_s, 16}, {u"roll"_s, 14}, {u"yaw"_s, 14}});
    QTRY_VERIFY(workspace().isUnstored());
    m_rig->window().close();
    auto *box = m_rig->window().findChild<QMessageBox *>();
    QVERIFY(box && m_rig->window().isVisible());
    for (QAbstractButton *button : box->buttons()) {
        if (box->buttonRole(button) == QMessageBox::AcceptRole)
            button->click();
    }
    QTRY_VERIFY(!m_rig->window().isVisible());
    QVERIFY(!workspace().isUnstored());
}

void TestStorm::valuesWithoutEffectAreGrey()
{
    QVERIFY(openStorm());
    auto *page = m_rig->page<ParametersPage>();
    page->showParameter(u"pan.mode.setting1"_s);
    auto *form = page->findChild<ParameterForm *>();
    ValueEditor *editor = form->editor(m_rig->spec(u"pan.mode.setting1"_s).id);
    QVERIFY(editor);
    QVERIFY(editor->control()->property("inactive").toBool());
    QVERIFY2(editor->control()->toolTip().contains(u"No effect while"_s),
             qPrintable(editor->control()->toolTip()));
    QVERIFY(editor->control()->isEnabled());  // it can be prepared all the same
    m_rig->edit(u"pan.mode.input"_s, 0, 1);
    QVERIFY(!editor->control()->property("inactive").toBool());
    QVERIFY(!editor->control()->toolTip().contains(u"No effect while"_s));
    workspace().edits().undoStack().undo();
    QVERIFY(editor->control()->property("inactive").toBool());
}

void TestStorm::scriptIsTypedTakenOverAndWritten()
{
    QVERIFY(openStorm());
    auto *page = m_rig->page<ScriptsPage>();
    QTRY_VERIFY(page->editor()->isEnabled());
    QCOMPARE(named<QListWidget>(page, u"Scripts"_s)->count(), 4);
    page->editor()->setFocus();
    QTest::keyClicks(page->editor(), u"WAIT 5"_s);
    QTest::keyClick(page->editor(), Qt::Key_Escape);  // completion
    QTest::keyClick(page->editor(), Qt::Key_Return);
    QTest::keyClicks(page->editor(), u"FLY"_s);
    QTRY_VERIFY2(page->message().contains(u"line 2"_s), qPrintable(page->message()));
    QVERIFY(!page->takeButton()->isEnabled());
    QVERIFY(page->hasChanges() && isMarked(m_rig->window(), u"Scripts"_s));
    page->editor()->setText(u"; a while\nWAIT 5\nDORECENTER\n"_s);
    QTRY_VERIFY(page->takeButton()->isEnabled());
    QCOMPARE(page->listing()->count(), 3);  // and the STOP that was put behind
    QVERIFY(page->listing()->item(0)->text().contains(u"WAIT 5"_s));
    QCOMPARE(m_rig->model().changeCount(), 0);
    page->takeButton()->click();
    QCOMPARE(m_rig->model().changeCount(), 1);
    QVERIFY(page->editor()->text().contains(u"a while"_s));  // as it was typed
    // An edit like any other: undone, done again, written, read back.
    workspace().edits().undoStack().undo();
    QCOMPARE(m_rig->model().changeCount(), 0);
    QVERIFY(page->editor()->text().isEmpty());
    workspace().edits().undoStack().redo();
    QVERIFY(page->editor()->text().contains(u"DORECENTER"_s));
    QVERIFY(writeAll());
    QCOMPARE(m_rig->model().changeCount(), 0);
    QVERIFY(!page->hasChanges());
    QSignalSpy read(&workspace(), &Workspace::boardRead);
    workspace().readBoard();
    QTRY_COMPARE(read.count(), 1);
    QVERIFY(workspace()
                .family()
                ->scripts->text(std::as_const(m_rig->model()).board(), 0)
                .contains(u"DORECENTER"_s));
    // Tab leaves the editor.
    page->editor()->setFocus();
    QVERIFY(page->editor()->hasFocus());
    QTest::keyClick(page->editor(), Qt::Key_Tab);
    QVERIFY(!page->editor()->hasFocus() && page->isAncestorOf(QApplication::focusWidget()));
}

// A text that does not compile is no edit, and is there again all the same.
void TestStorm::typedScriptSurvivesACrash()
{
    QVERIFY(openStorm());
    auto *page = m_rig->page<ScriptsPage>();
    QTRY_VERIFY(page->editor()->isEnabled());
    page->showScript(1);
    page->editor()->setText(u"WAIT 5\nFLY\n"_s);
    m_rig->edit(u"pid.roll.p"_s, 0, 433);
    QTRY_VERIFY2(page->message().contains(u"line 2"_s), qPrintable(page->message()));
    const BoardHistory history(BoardHistory::defaultRoot());
    const QString serial = m_rig->client().identity().serial;
    QTRY_VERIFY(history.unsaved(serial) && !history.unsaved(serial)->value(u"drafts"_s).toObject().isEmpty());
    m_rig->crash();
    m_rig->restart();
    QVERIFY(openStorm());
    OfferBar *bar = m_rig->window().offerBar();
    QTRY_VERIFY(bar->isVisible());
    QVERIFY2(bar->text().contains(u"1 unwritten step"_s) && bar->text().contains(u"1 unfinished text"_s),
             qPrintable(bar->text()));
    page = m_rig->page<ScriptsPage>();
    QVERIFY(page->editor()->text().isEmpty());
    bar->buttons().first()->click();
    QCOMPARE(m_rig->model().changeCount(), 1);
    page->showScript(1);
    QCOMPARE(page->editor()->text(), u"WAIT 5\nFLY\n"_s);
    QVERIFY(page->hasChanges() && isMarked(m_rig->window(), u"Scripts"_s));
    QTRY_VERIFY(page->message().contains(u"line 2"_s));
    // Reading the board again, and a write of something else, leave it alone.
    QVERIFY(writeAll());
    QCOMPARE(page->editor()->text(), u"WAIT 5\nFLY\n"_s);
    page->revertButton()->click();
    QVERIFY(page->editor()->text().isEmpty());
    QTRY_VERIFY(!history.unsaved(serial));
}

void TestStorm::typedScriptIsAskedForWhenQuitting()
{
    QVERIFY(openStorm());
    auto *page = m_rig->page<ScriptsPage>();
    QTRY_VERIFY(page->editor()->isEnabled());
    page->editor()->setText(u"FLY\n"_s);
    const auto quit = [this](QMessageBox::ButtonRole role) {
        m_rig->window().close();
        auto *box = m_rig->window().findChild<QMessageBox *>();
        if (!box || !m_rig->window().isVisible())
            return false;
        for (QAbstractButton *button : box->buttons()) {
            if (box->buttonRole(button) == role)
                button->click();
        }
        return QTest::qWaitFor([this] { return !m_rig->window().isVisible(); }, kPatience);
    };
    QVERIFY(quit(QMessageBox::AcceptRole));
    const BoardHistory history(BoardHistory::defaultRoot());
    m_rig->restart();
    QVERIFY(openStorm());
    QTRY_VERIFY(m_rig->window().offerBar()->isVisible());  // kept for next time
    m_rig->window().offerBar()->buttons().first()->click();
    page = m_rig->page<ScriptsPage>();
    QTRY_COMPARE(page->editor()->text(), u"FLY\n"_s);
    QVERIFY(quit(QMessageBox::DestructiveRole));
    QVERIFY(!history.unsaved(u"storm32-4f6c6c6957203332334247432076312e333020463130335243"_s));
}

void TestStorm::scriptsAreEditedInAFile()
{
    QVERIFY(openStorm());
    const QString path = m_rig->filePath(u"board.json"_s);
    QVERIFY(workspace().saveFile(path));
    m_rig->client().disconnectFromBoard();
    QTRY_VERIFY(!m_rig->client().isConnected());
    QVERIFY(workspace().openFile(path));
    auto *page = m_rig->page<ScriptsPage>();
    QVERIFY(page->editor()->isEnabled());
    page->showScript(2);
    page->editor()->setText(u"STOP\n"_s);
    QTRY_VERIFY(page->takeButton()->isEnabled());
    page->takeButton()->click();
    QVERIFY(workspace().saveFile(path));
    const auto file = workspace().loadFile(path);
    QVERIFY(file);
    QVERIFY(workspace().family()->scripts->text(file->configuration, 2).contains(u"STOP"_s));
}

void TestStorm::spectrumOfPolledSamples()
{
    QVERIFY(openStorm());
    auto *page = m_rig->page<SpectrumPage>();
    QTRY_COMPARE(page->chart()->curves().size(), qsizetype(3));
    QTRY_VERIFY(page->bands()->item(0, 1) && page->bands()->item(0, 1)->text().contains(u'°'));
    const auto labels = page->findChildren<QLabel *>();
    QTRY_VERIFY(std::any_of(labels.begin(), labels.end(),
                            [](QLabel *label) { return label->text().contains(u"shows up lower"_s); }));
    // The highest band ends where the samples do.
    const auto end = [page] {
        return page->bands()->item(2, 0)->text().section(u'–', 1).section(u' ', 0, 0).toDouble();
    };
    QTRY_VERIFY2(end() > 30 && end() < 60, qPrintable(page->bands()->item(2, 0)->text()));
    QVERIFY(!named<QPushButton>(page, u"Try a notch here…"_s)
                 ->isVisible());  // such a board has no filter to put there
}

void TestStorm::consoleLeavesPollingOut()
{
    QVERIFY(openStorm());
    auto *page = m_rig->page<ConsolePage>();
    FrameLogModel &model = page->model();
    const auto count = [&model](const QString &name) {
        int found = 0;
        for (int row = 0; row < model.rowCount(); ++row)
            found += model.index(row, FrameLogModel::NameColumn).data().toString() == name ? 1 : 0;
        return found;
    };
    QTRY_VERIFY(!m_rig->client().isBusy());  // the values in use are asked for one by one
    // The console asks once: on a machine that stands still for a moment the answer may come too late,
    // which is told; then it is asked again.
    const auto &told = m_rig->workspace().notifications().history();
    bool isAnswered = false;
    for (int tries = 0; tries < 5 && !isAnswered; ++tries) {
        QTRY_VERIFY(!m_rig->client().isBusy());
        model.clear();
        const qsizetype before = told.size();
        page->input()->setText(u"getparameter index=0"_s);
        page->send();
        QTRY_VERIFY(count(u"GETPARAMETER"_s) == 2 || told.size() > before);
        isAnswered = told.size() == before;
    }
    QCOMPARE(count(u"GETPARAMETER"_s), 2);  // the question and its answer
    QVERIFY(QTest::qWaitFor([&] { return m_rig->client().telemetry()->rows() > 200; }, kPatience));
    QCOMPARE(count(u"d"_s), 0);
    for (QCheckBox *box : page->findChildren<QCheckBox *>()) {
        if (box->text().contains(u"Live data"_s))
            box->setChecked(true);
    }
    QTRY_VERIFY(count(u"d"_s) > 10);
}

void TestStorm::snapshotsShowWhatDiffers()
{
    QVERIFY(openStorm());
    auto *page = m_rig->page<BackupsPage>();
    page->takeButton()->click();
    const auto says = [page](const QString &words) {
        const auto labels = page->findChildren<QLabel *>();
        return std::any_of(labels.begin(), labels.end(),
                           [&words](QLabel *label) { return label->text().startsWith(words); });
    };
    QTRY_VERIFY(says(u"All values are the same."_s));
    QVERIFY(!named<QPushButton>(page, u"Restore as edits"_s)
                 ->isEnabled());  // this board's one profile has no name that could differ
    m_rig->edit(u"pid.roll.p"_s, 0, 555);
    workspace().perform(u"directions.take"_s, {});
    m_rig->page<ParametersPage>();
    QVERIFY(m_rig->jobsAreDone());
    m_rig->page<BackupsPage>();
    // A snapshot says before what it was taken, by the name that the operator knows.
    const QTableWidget *whys = page->table();
    const auto named = [whys] {
        for (int row = 0; row < whys->rowCount(); ++row) {
            if (whys->item(row, 1)->text() == u"before “Take motor directions”"_s)
                return true;
        }
        return false;
    };
    QTRY_VERIFY(named());
    // What is only an edit yet is no difference between the snapshot and the board.
    QTRY_VERIFY(says(u"All values are the same. Compared with what the board holds; 1 unwritten"_s));
}

void TestStorm::heartbeatIsEscapedByOneClick()
{
    QVERIFY(openStorm(u"?rate=115200"_s));
    m_rig->edit(u"mavlink.heartbeat"_s, 0, 1);
    QVERIFY2(writeAll(), "a write that switches the heartbeat on is read back through MAVLink");
    QTRY_VERIFY(m_rig->raw(u"mavlink.heartbeat"_s) == 1);
    m_rig->edit(u"pid.roll.p"_s, 0, 433);
    QVERIFY(writeAll());
    m_rig->client().disconnectFromBoard();
    QTRY_VERIFY(!m_rig->client().isConnected());
    m_rig->window().openLink(u"sim:storm32?rate=115200"_s);
    QTRY_VERIFY(m_rig->client().isConnected());
    QTRY_VERIFY(m_rig->window().offerBar()->text().contains(u"MAVLink"_s));
    QVERIFY(ready());  // live data comes all the same
    QTRY_COMPARE(m_rig->raw(u"pid.roll.p"_s), 433);
    auto *page = m_rig->page<ScriptsPage>();
    QVERIFY(!page->editor()->isEnabled() && !page->message().isEmpty());
    m_rig->window().offerBar()->buttons().first()->click();
    const int heartbeat = m_rig->spec(u"mavlink.heartbeat"_s).id;
    QTRY_COMPARE(workspace().live().value(heartbeat), std::optional(0.0));
    QTRY_VERIFY(page->editor()->isEnabled());
    QCOMPARE(m_rig->raw(u"mavlink.heartbeat"_s), 1.0);  // where it is stored
    QVERIFY(workspace().isUnstored());  // it would be back after a restart, and that is said
    QVERIFY(ready());
}

void TestStorm::settingsAreShared()
{
    QVERIFY(openStorm());
    auto *page = m_rig->page<BackupsPage>();
    page->findChild<QPushButton *>(u"share"_s)->click();
    auto *dialog = m_rig->window().findChild<ShareDialog *>();
    QVERIFY(dialog);
    QVERIFY(dialog->image().width() > 1000 && dialog->image().height() > 500);
    for (const QLabel *label : dialog->findChildren<QLabel *>()) {
        if (!label->pixmap().isNull())  // all of it can be seen, however small the screen
            QCOMPARE(label->size(), label->pixmap().deviceIndependentSize().toSize());
    }
    const QString path = m_rig->filePath(u"settings.png"_s);
    QVERIFY(dialog->save(path));
    QCOMPARE(QImage(path).size(), dialog->image().size());
    QVERIFY(!dialog->save(u"/nowhere/settings.png"_s));
    // What is on it changes with the values.
    const QImage before = dialog->image();
    dialog->reject();
    m_rig->edit(u"pid.roll.p"_s, 0, 1234);
    const ShareDialog again(workspace());
    QVERIFY(again.image() != before);
}

void TestStorm::settingsFileIsLoadedAndSaved()
{
    QVERIFY(openStorm());
    m_rig->edit(u"pid.roll.p"_s, 0, 777);
    const QString path = m_rig->filePath(u"mine.cfg"_s);
    QVERIFY(workspace().saveFile(path));
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly) && file.readAll().contains("'Roll P' => [ 777 , '7.77' ],"));
    workspace().edits().discardAll();
    QVERIFY(workspace().applyFile(path));
    QCOMPARE(m_rig->model().value(m_rig->spec(u"pid.roll.p"_s), 0), 777);
    QCOMPARE(m_rig->model().changeCount(), 1);
    // Without a board it opens by itself.
    workspace().edits().discardAll();
    m_rig->client().disconnectFromBoard();
    QTRY_VERIFY(!m_rig->client().isConnected());
    m_rig->window().openFile(path);
    QCOMPARE(workspace().offlineFile(), path);
    QCOMPARE(m_rig->raw(u"pid.roll.p"_s), 777);
}

// The board was starting when it was stopped: its motors are disabled until it is in standby. What is told
// last stands on the screen.
void TestStorm::disabledMotorsAreToldWithALostLink()
{
    QVERIFY(openStorm());
    workspace().perform(u"reset"_s, {});
    QTRY_VERIFY(!workspace().motorsRunning().value_or(true));
    QSignalSpy stopped(&m_rig->client(), &DeviceClient::motorsOffFinished);
    QSignalSpy settled(&m_rig->client(), &DeviceClient::motorsOffSettled);
    m_rig->client().motorsOff();
    QTRY_COMPARE(stopped.size(), 1);
    QVERIFY(stopped.first().first().toBool());
    QVERIFY(settled.isEmpty());
    QStringList told;
    connect(&workspace().notifications(), &Notifications::problem, this,
            [&told](const ErrorText &text) { told.append(text.oneLine()); });
    workspace().changeWorld(u"unplug=0"_s);
    const auto lost = [&told] { return told.filter(u"The link to the board broke"_s); };
    QTRY_VERIFY(!lost().isEmpty());
    QVERIFY2(lost().first().contains(u"may stay so until it restarts"_s), qPrintable(told.join(u'\n')));
}

void TestStorm::repliesAndProfilesBelongToTheirBoard()
{
    const QComboBox *profiles = named<QComboBox>(&m_rig->window(), u"Active profile"_s);
    QVERIFY(openStorm());
    auto *page = m_rig->page<ActionsPage>();
    QVERIFY(page->showAction(u"status"_s));
    page->runButton()->click();
    QTRY_VERIFY(page->reply()->toPlainText().contains(u"done"_s));
    QVERIFY(!profiles->isVisible());  // there is nothing to choose
    // The same board again: what it said still holds.
    QVERIFY(openStorm());
    QVERIFY(page->reply()->toPlainText().contains(u"done"_s));
#if GIMBAL_WITH_SIMPLEBGC
    QVERIFY(m_rig->open());
    QVERIFY2(page->reply()->toPlainText().isEmpty(), qPrintable(page->reply()->toPlainText()));
    QTRY_VERIFY(profiles->isVisible());
#endif
}

QTEST_MAIN(TestStorm)
#include "tst_storm.moc"
