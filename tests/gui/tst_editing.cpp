// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/bars.h"
#include "app/mainwindow/messagebar.h"
#include "app/mainwindow/translations.h"
#include "app/pages/setup/parameterspage.h"
#include "app/pages/setup/profilespage.h"
#include "app/pages/setup/scriptspage.h"
#include "app/pages/tune/tuningpage.h"
#include "protocol/device/abilities.h"
#include "tests/support/drawntexts.h"
#include "tests/support/named.h"
#include "tests/support/patience.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/helpcard.h"
#include "widgets/forms/liveslider.h"
#include "widgets/forms/parameterform.h"
#include "widgets/forms/reviewdialog.h"
#include "widgets/forms/valueeditor.h"
#include "widgets/models/parametermodel.h"
#include "widgets/models/profilemodel.h"
#include "widgets/views/scripteditor.h"

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalSpy>
#include <QTableView>

using namespace Qt::StringLiterals;

/// Edits mark themselves where they stand, and are undone where it can be seen.
class TestEditing : public QObject
{
    Q_OBJECT
private slots:
    void leftoversOfMissingPartsAreKept();
    void nothingMovesWhenAValueChanges_data();
    void nothingMovesWhenAValueChanges();
    void nothingMovesForCountsAndProfiles();
    void nothingMovesUnderTheSlider();
    void onlyOwnLiveValuesAreInUseAgain();
    void liveValuesAreUndone_data();
    void liveValuesAreUndone();
    void undoLeadsToTheField();
    void contradictionIsShownAndNotWritten();
    void whatIsNotStoredAnywhereIsNotUnstored();
    void undoLeadsToAnotherProfile();
    void undoLeadsToTheName();
    void undoStaysInTheTable();
    void undoLeadsToTheScript();
    void undoLeadsToTheFirstOfSeveral();
    void redoLeadsToAnotherProfile();
    void countsNameTheirProfile();
    void countsKeepTheirProfileWhereRoomIsShort_data();
    void countsKeepTheirProfileWhereRoomIsShort();

private:
    static QMap<QString, QRect> places(const QWidget &page)
    {
        QMap<QString, QRect> all;
        for (const ValueEditor *editor : page.findChildren<ValueEditor *>()) {
            if (editor->isVisible())
                all.insert(editor->spec().key,
                           {editor->control()->mapTo(&page, QPoint()), editor->control()->size()});
        }
        return all;
    }
    static bool isSeen(const QWidget *widget)
    {
        return widget && widget->isVisible() && !widget->visibleRegion().isEmpty();
    }
};

void TestEditing::nothingMovesWhenAValueChanges_data()
{
    QTest::addColumn<QString>("address");
    QTest::newRow("SimpleBGC") << u"sim:simplebgc"_s;
    QTest::newRow("STorM32") << u"sim:storm32"_s;
}

// One value of each group and kind is changed, and all fields stay where they were.
void TestEditing::nothingMovesWhenAValueChanges()
{
    QFETCH(const QString, address);
    WindowRig rig;
    rig.window().resize(1280, 900);
    QVERIFY(rig.open(address));
    auto *page = rig.page<ParametersPage>();
    QVERIFY(page);
    auto *groups = page->findChild<QListWidget *>();
    // The bar of unsaved changes takes its room with the first edit, so there is one before.
    const auto change = [&rig](const ParameterSpec &spec) {
        const double now = rig.model().value(spec, rig.model().shownProfile()).value_or(0);
        for (const double to : {now + spec.row->step, now - spec.row->step, now + 1, now - 1, 0.0, 1.0}) {
            if (!sameValue(to, now) && rig.workspace().edits().edit(spec.id, rig.model().shownProfile(), to))
                return true;
        }
        return false;
    };
    int changed = 0;
    for (int group = 0; group < groups->count(); ++group) {
        page->showGroup(group);
        QSet<int> kinds;
        for (ValueEditor *editor : page->form()->findChildren<ValueEditor *>()) {
            const auto kind = int(editor->spec().row->kind) * 2 + (editor->spec().row->axes > 1);
            if (kinds.contains(kind))
                continue;
            QVERIFY(rig.isSettled());
            const auto before = places(*page->form());
            if (!change(editor->spec()))
                continue;
            kinds.insert(kind);
            ++changed;
            QVERIFY(rig.isSettled());
            const auto after = places(*page->form());
            for (auto each = before.begin(); each != before.end(); ++each) {
                // A longer word may be shown; the field itself stays.
                QVERIFY2(after.value(each.key()) == each.value(),
                         qPrintable(u"%1 moved %2"_s.arg(editor->spec().key, each.key())));
            }
        }
    }
    QVERIFY2(changed > 15, qPrintable(QString::number(changed)));
}

// From the first edit on, in two profiles, and when another one than the board's is shown.
void TestEditing::nothingMovesForCountsAndProfiles()
{
    WindowRig rig;
    rig.window().resize(1280, 900);
    QVERIFY(rig.open(u"sim:simplebgc"_s));
    auto *page = rig.page<ParametersPage>();
    page->showParameter(u"pid.roll.p"_s);
    QVERIFY(rig.isSettled());
    const auto globalPlaces = [page] {
        QMap<QString, QPoint> all;
        for (const ValueEditor *editor : page->findChildren<ValueEditor *>()) {
            if (editor->isVisible())
                all.insert(editor->spec().key, editor->control()->mapTo(page, QPoint()));
        }
        return all;
    };
    const auto before = globalPlaces();
    QVERIFY(before.size() > 5);
    for (int profile = 0; profile < 2; ++profile) {
        rig.edit(u"pid.roll.p"_s, profile, 77 + profile);
        QVERIFY(rig.isSettled());
        QCOMPARE(globalPlaces(), before);
    }
    rig.model().setShownProfile(1);
    QVERIFY(rig.isSettled());
    QVERIFY(page->findChild<QPushButton *>(u"otherProfile"_s)->isVisible());
    QCOMPARE(globalPlaces(), before);
    // The card tells of a field that is here.
    auto *card = page->findChild<HelpCard *>();
    card->show(rig.spec(u"pid.roll.p"_s).id);
    page->showGroup(1);
    QCOMPARE(card->parameter(), -1);
}

void TestEditing::nothingMovesUnderTheSlider()
{
    WindowRig rig;
    rig.window().resize(1280, 900);
    QVERIFY(rig.open(u"sim:simplebgc"_s));
    auto *page = rig.page<TuningPage>();
    QVERIFY(page);
    QTRY_VERIFY(page->control(u"pid.roll.p"_s));
    QTRY_VERIFY(page->control(u"pid.roll.p"_s)->isEnabled());
    const auto relative = [page] {
        QMap<QString, QRect> all;
        for (const LiveSlider *slider : page->findChildren<LiveSlider *>())
            all.insert(QString::number(quintptr(slider)), slider->geometry());
        return all;
    };
    QVERIFY(rig.isSettled());
    const auto before = relative();
    QVERIFY(before.size() >= 3);
    emit page->control(u"pid.roll.p"_s)->edited(rig.raw(u"pid.roll.p"_s) + 5);
    QTRY_COMPARE(rig.workspace().live().changeCount(), 1);
    QVERIFY(rig.isSettled());
    QCOMPARE(relative(), before);
}

// A write makes the board load what is stored. What was set live here is in use again afterwards; what
// somebody else had set is named before and after, and is nobody's live change.
void TestEditing::onlyOwnLiveValuesAreInUseAgain()
{
    WindowRig rig;
    QVERIFY(rig.open(u"sim:simplebgc"_s));
    LiveModel &live = rig.workspace().live();
    const int own = rig.spec(u"pid.yaw.p"_s).id;
    const int foreign = rig.spec(u"pid.pitch.p"_s).id;
    const double stored = rig.raw(u"pid.pitch.p"_s);
    QTRY_VERIFY(live.value(foreign));
    auto set = rig.client().submit<bool>([variable = rig.spec(u"pid.pitch.p"_s).adjustable,
                                          value = stored + 7](Channel &channel, Device &device) {
        return device.live()->restoreAdjustables(channel, {{variable, value}}).map([] { return true; });
    });
    QTRY_VERIFY(set.isFinished() && set.result());
    live.read();
    QTRY_COMPARE(live.value(foreign), std::optional(stored + 7));
    live.setValue(own, rig.raw(u"pid.yaw.p"_s) + 5);
    QTRY_VERIFY(live.isSettled() && live.changeCount() == 2);
    QCOMPARE(live.ownUnsaved().size(), 1U);
    QCOMPARE(live.ownUnsaved().front().key, u"pid.yaw.p"_s);
    const auto replaced = rig.workspace().replacedByAWrite();
    QCOMPARE(replaced.size(), 1U);
    QCOMPARE(replaced.front().key, u"pid.pitch.p"_s);
    const auto change = rig.client().device()->live()->lastChange();
    QVERIFY(change);

    QStringList notices;
    QObject::connect(&rig.workspace().notifications(), &Notifications::notice, &rig.window(),
                     [&notices](const QString &text) { notices.append(text); });
    rig.edit(u"pid.roll.p"_s, 0, rig.raw(u"pid.roll.p"_s) + 4);
    rig.window().review();
    auto *review = rig.window().findChild<ReviewDialog *>();
    QVERIFY(review);
    const auto labels = review->findChildren<QLabel *>();
    QVERIFY(std::any_of(labels.begin(), labels.end(), [&rig](const QLabel *label) {
        return label->isVisible() && label->text().contains(parameterLabel(rig.spec(u"pid.pitch.p"_s)));
    }));
    QVERIFY(!review->othersChoice()->isVisible());
    review->accept();
    QTRY_VERIFY(rig.workspace().lastReport() && rig.workspace().lastReport()->isComplete());
    QTRY_VERIFY(rig.jobsAreDone() && live.isSettled() && live.value(foreign) == stored);
    QCOMPARE(live.value(own), std::optional(rig.raw(u"pid.yaw.p"_s) + 5));
    const QString told = notices.join(u'\n');
    QVERIFY2(told.contains(u"pid.pitch.p="_s) && !told.contains(u"pid.yaw.p="_s), qPrintable(told));
    // Putting back is no live change of the operator.
    QCOMPARE(rig.client().device()->live()->lastChange()->until, change->until);
}

void TestEditing::liveValuesAreUndone_data()
{
    QTest::addColumn<QString>("family");
    for (const Family &family : allFamilies()) {
        if (!family.links.isEmpty())
            QTest::newRow(family.key.toUtf8().constData()) << family.key;
    }
}

// Ctrl+Z on the page where they are set; elsewhere it is about edits.
void TestEditing::liveValuesAreUndone()
{
    QFETCH(QString, family);
    WindowRig rig;
    QVERIFY(rig.open(u"sim:"_s + family));
    LiveModel &live = rig.workspace().live();
    QVERIFY(rig.page<TuningPage>());
    const int gain = rig.spec(u"pid.roll.p"_s).id;
    const int other = rig.spec(u"pid.pitch.p"_s).id;
    QTRY_VERIFY(live.value(gain) && live.value(other));
    const double before = *live.value(gain);
    const double beside = *live.value(other);
    const auto inUse = [&rig](const QString &key) {
        const ParameterSpec spec = rig.spec(key);
        auto read = rig.client().submit<std::vector<AdjustableValue>>(
            [variable = spec.adjustable](Channel &channel, Device &device) {
                return device.live()->readAdjustables(channel, {variable});
            });
        const bool isThere = QTest::qWaitFor([&read] { return read.isFinished(); }, kPatience);
        return isThere && read.result() ? spec.rawOf(read.result()->front().value) : std::nan("");
    };
    // Changes that follow each other are one step.
    for (const double part : {1.1, 1.2, 1.3})
        live.setValue(gain, before * part);
    const double after = *live.value(gain);
    QVERIFY(after != before);
    QTRY_VERIFY(live.isSettled());
    QVERIFY(sameValue(inUse(u"pid.roll.p"_s), after));
    QTest::keyClick(&rig.window(), Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY(live.isSettled());
    QCOMPARE(*live.value(gain), before);
    QVERIFY(sameValue(inUse(u"pid.roll.p"_s), before));
    QVERIFY(!live.canUndo());
    QTest::keyClick(&rig.window(), Qt::Key_Y, Qt::ControlModifier);
    QTRY_VERIFY(live.isSettled());
    QVERIFY(sameValue(inUse(u"pid.roll.p"_s), after));
    // There and back is no step, and what was found otherwise is not undone.
    live.setValue(other, beside * 1.2);
    live.setValue(other, beside);
    QTRY_VERIFY(live.isSettled());
    live.setValues({{gain, before}});
    QTRY_VERIFY(live.isSettled());
    QVERIFY(!live.canUndo());
    // Elsewhere it is about edits.
    live.setValue(other, beside * 1.2);
    QTRY_VERIFY(live.isSettled());
    QVERIFY(live.canUndo());
    QVERIFY(rig.window().showPage(u"parameters"_s));
    QTest::keyClick(&rig.window(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(rig.jobsAreDone() && live.isSettled());
    QVERIFY(*live.value(other) != beside);
}

void TestEditing::undoLeadsToTheField()
{
    WindowRig rig;
    QVERIFY(rig.open(u"sim:simplebgc"_s));
    auto *page = rig.page<ParametersPage>();
    page->showParameter(u"rc.map.roll"_s);
    rig.edit(u"pid.roll.p"_s, 0, 44);
    rig.edit(u"motor.yaw.poles"_s, 0, 24);
    rig.window().showPage(u"dashboard"_s);
    QVERIFY(QTest::qWaitForWindowActive(&rig.window()));
    const auto isAt = [&](const QString &key) {
        ValueEditor *editor = page->form()->editor(rig.spec(key).id);
        return rig.window().navigation()->currentPage() == u"parameters"_s && isSeen(editor)
            && editor->control()->hasFocus();
    };
    QTest::keyClick(&rig.window(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(rig.model().changeCount(), 1);
    QTRY_VERIFY(isAt(u"motor.yaw.poles"_s));
    rig.window().showPage(u"dashboard"_s);
    QTest::keyClick(&rig.window(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(rig.model().changeCount(), 0);
    QTRY_VERIFY(isAt(u"pid.roll.p"_s));
    rig.window().showPage(u"dashboard"_s);
    QTest::keySequence(&rig.window(), QKeySequence(QKeySequence::Redo));
    QCOMPARE(rig.model().changeCount(), 1);
    QTRY_VERIFY(isAt(u"pid.roll.p"_s));
    // By either of the usual keys.
    for (const auto &[key, modifiers] : {std::pair(Qt::Key_Y, Qt::KeyboardModifiers(Qt::ControlModifier)),
                                         std::pair(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier)}) {
        rig.workspace().edits().undo();
        QCOMPARE(rig.model().changeCount(), 0);
        QTest::keyClick(&rig.window(), key, modifiers);
        QCOMPARE(rig.model().changeCount(), 1);
    }
}

// The board goes on with the profile that it uses.
// A pin that puts out a servo's signal is no input: shown at both fields, and not written.
void TestEditing::contradictionIsShownAndNotWritten()
{
    WindowRig rig;
    QVERIFY(rig.open(u"sim:simplebgc"_s));
    auto *page = rig.page<ParametersPage>();
    const ParameterSpec &source = rig.spec(u"rc.map.yaw"_s);
    const ParameterSpec &servo = rig.spec(u"service.servo1.source"_s);
    page->reveal(source);
    const auto isMarked = [page](const ParameterSpec &spec) {
        ValueEditor *editor = page->form()->editor(spec.id);
        return editor && editor->control()->property("conflict").toBool()
            && editor->control()->toolTip().contains(u"servo's signal"_s);
    };
    QVERIFY(rig.workspace().edits().edit(source.id, 0, 3));
    QVERIFY(!isMarked(source));
    QVERIFY(rig.workspace().edits().edit(servo.id, 0, 1));
    QVERIFY(isMarked(source));
    page->reveal(servo);
    QVERIFY(isMarked(servo));
    QStringList told;
    connect(&rig.workspace().notifications(), &Notifications::problem, this,
            [&told](const ErrorText &text) { told.append(text.oneLine()); });
    rig.window().review();
    QVERIFY(!rig.window().findChild<ReviewDialog *>());
    QTRY_COMPARE(told.size(), 1);
    QVERIFY2(told.first().contains(u"Contradicts"_s) && told.first().contains(u"servo's signal"_s),
             qPrintable(told.first()));
    QVERIFY(rig.workspace().edits().edit(servo.id, 0, 0));
    QVERIFY(!isMarked(servo));
    rig.window().review();
    QTRY_VERIFY(rig.window().findChild<ReviewDialog *>());
}

// Firmware before 2.56 has no PARAMS_EXT2 and live variables of it all the same: nobody has set them.
void TestEditing::whatIsNotStoredAnywhereIsNotUnstored()
{
    WindowRig rig;
    QVERIFY(rig.open(u"sim:simplebgc?firmware=2.43b9"_s));
    rig.workspace().live().read();
    QTRY_VERIFY(rig.workspace().live().value(rig.spec(u"pid.roll.p"_s).id));
    QVERIFY(rig.isSettled());
    QVERIFY(rig.workspace().live().unsaved().empty());
    QVERIFY(!rig.workspace().isUnstored());
}

void TestEditing::undoLeadsToAnotherProfile()
{
    WindowRig rig;
    QVERIFY(rig.open(u"sim:simplebgc"_s));
    auto *page = rig.page<ParametersPage>();
    rig.edit(u"pid.roll.p"_s, 2, 44);
    QComboBox *chooser = nullptr;
    for (QComboBox *box : rig.window().findChildren<QComboBox *>()) {
        if (box->accessibleName() == u"Active profile"_s)
            chooser = box;
    }
    rig.workspace().edits().undo();
    QCOMPARE(rig.model().shownProfile(), 2);
    QTRY_VERIFY(isSeen(page->form()->editor(rig.spec(u"pid.roll.p"_s).id)));
    QCOMPARE(rig.model().board().activeProfile(), 0);
    QVERIFY(rig.boardGoesOn(0.5));
    QCOMPARE(rig.workspace().latest(rig.workspace().roles().activeProfile), 0.0);
    QVERIFY(chooser);
    QCOMPARE(chooser->currentIndex(), 0);
    // It is said, and one click leads back.
    auto *back = page->findChild<QPushButton *>(u"otherProfile"_s);
    QVERIFY(isSeen(back));
    back->click();
    QCOMPARE(rig.model().shownProfile(), 0);
    QVERIFY(!back->isVisible());
}

void TestEditing::undoLeadsToTheName()
{
    WindowRig rig;
    QVERIFY(rig.open(u"sim:simplebgc"_s));
    auto *page = rig.page<ProfilesPage>();
    rig.workspace().edits().rename(1, u"Boat"_s);
    rig.window().showPage(u"dashboard"_s);
    rig.workspace().edits().undo();
    QCOMPARE(rig.window().navigation()->currentPage(), u"profiles"_s);
    QCOMPARE(page->table()->currentIndex().row(), 1);
    QCOMPARE(page->table()->currentIndex().column(), int(ProfileModel::NameColumn));
    QTRY_VERIFY(page->table()->hasFocus());
}

void TestEditing::undoStaysInTheTable()
{
    WindowRig rig;
    QVERIFY(rig.open(u"sim:simplebgc"_s));
    auto *page = rig.page<ParametersPage>();
    for (QPushButton *chip : page->findChildren<QPushButton *>()) {
        if (chip->text() == u"Table"_s)
            chip->setChecked(true);
    }
    QVERIFY(page->table()->isVisible());
    rig.edit(u"pid.roll.p"_s, 0, 44);
    rig.workspace().edits().undo();
    QVERIFY(page->table()->isVisible());
    QCOMPARE(page->table()->currentIndex().data(ParameterModel::IdRole).toInt(),
             rig.spec(u"pid.roll.p"_s).id);
}

void TestEditing::undoLeadsToTheScript()
{
    WindowRig rig;
    QVERIFY(rig.open(u"sim:storm32"_s));
    auto *page = rig.page<ScriptsPage>();
    QTRY_VERIFY(page->editor()->isEnabled());
    auto *list = named<QListWidget>(page, u"Scripts"_s);
    page->showScript(2);
    page->editor()->setText(u"WAIT 5\n"_s);
    QTRY_VERIFY(page->takeButton()->isEnabled());
    page->takeButton()->click();
    QCOMPARE(rig.model().changeCount(), 1);
    const auto leads = [&](const auto &step) {
        page->showScript(0);
        rig.window().showPage(u"dashboard"_s);
        step();
        return rig.window().navigation()->currentPage() == u"scripts"_s && list->currentRow() == 2
            && QTest::qWaitFor([page] { return page->editor()->hasFocus(); });
    };
    QVERIFY(QTest::qWaitForWindowActive(&rig.window()));
    QVERIFY(leads([&rig] { rig.workspace().edits().undo(); }));
    QVERIFY(page->editor()->text().isEmpty());
    QVERIFY(leads([&rig] { rig.workspace().edits().redo(); }));
    QVERIFY(page->editor()->text().contains(u"WAIT 5"_s));
}

void TestEditing::undoLeadsToTheFirstOfSeveral()
{
    WindowRig rig;
    QVERIFY(rig.open(u"sim:simplebgc"_s));
    auto *page = rig.page<ParametersPage>();
    rig.edit(u"pid.pitch.d"_s, 0, 44);
    rig.edit(u"pid.yaw.d"_s, 0, 45);
    rig.workspace().edits().copyProfile(0, 3);
    const auto changes = rig.model().changes();
    const auto first = std::find_if(changes.begin(), changes.end(),
                                    [](const ParameterChange &change) { return change.profile == 3; });
    QVERIFY(first != changes.end());
    const int count = rig.model().changeCount();
    page->showParameter(u"motor.yaw.poles"_s);
    rig.window().showPage(u"dashboard"_s);
    rig.workspace().edits().undo();
    QVERIFY(rig.model().changeCount() <= count - 2);
    QCOMPARE(rig.window().navigation()->currentPage(), u"parameters"_s);
    QCOMPARE(rig.model().shownProfile(), 3);
    QTRY_VERIFY(isSeen(page->form()->editor(first->spec->id)));
    rig.model().setShownProfile(0);
    rig.window().showPage(u"dashboard"_s);
    rig.workspace().edits().redo();
    QCOMPARE(rig.model().changeCount(), count);
    QCOMPARE(rig.model().shownProfile(), 3);
    QTRY_VERIFY(isSeen(page->form()->editor(first->spec->id)));
}

void TestEditing::redoLeadsToAnotherProfile()
{
    WindowRig rig;
    QVERIFY(rig.open(u"sim:simplebgc"_s));
    auto *page = rig.page<ParametersPage>();
    rig.edit(u"pid.roll.p"_s, 2, 44);
    rig.workspace().edits().undo();
    rig.model().setShownProfile(0);
    rig.window().showPage(u"dashboard"_s);
    rig.workspace().edits().redo();
    QCOMPARE(rig.window().navigation()->currentPage(), u"parameters"_s);
    QCOMPARE(rig.model().shownProfile(), 2);
    QTRY_VERIFY(isSeen(page->form()->editor(rig.spec(u"pid.roll.p"_s).id)));
    QCOMPARE(rig.model().board().activeProfile(), 0);
}

void TestEditing::countsKeepTheirProfileWhereRoomIsShort_data()
{
    QTest::addColumn<int>("width");
    QTest::addColumn<bool>("named");  // else its number must do
    QTest::newRow("usual") << 1280 << true;
    QTest::newRow("smallest") << 1024 << false;
}

// Both bars at the foot, in the language with the longer words: what is drawn counts.
void TestEditing::countsKeepTheirProfileWhereRoomIsShort()
{
    QFETCH(const int, width);
    QFETCH(const bool, named);
    const Translations german(u"de"_s);
    WindowRig rig;
    rig.window().resize(width, 700);
    QVERIFY(rig.open(u"sim:simplebgc"_s));
    auto *tuning = rig.page<TuningPage>();
    QTRY_VERIFY(tuning->control(u"pid.yaw.p"_s) && tuning->control(u"pid.yaw.p"_s)->isEnabled());
    emit tuning->control(u"pid.yaw.p"_s)->edited(rig.raw(u"pid.yaw.p"_s) + 5);
    QTRY_COMPARE(rig.workspace().live().changeCount(), 1);
    rig.edit(u"pid.roll.p"_s, 1, 44);
    QVERIFY(rig.isSettled());
    QCOMPARE(rig.window().width(), width);
    UnsavedBar *bar = rig.window().unsavedBar();
    QVERIFY(isSeen(bar) && isSeen(rig.window().findChild<UnstoredBar *>()));
    const QString drawn = drawnTexts(*bar).join(QString());
    const QString profile = profileLabel(rig.model().edited(), 1) + u": 1"_s;
    QVERIFY2(drawn.contains(profile) || (!named && drawn.contains(u"P2: 1"_s)), qPrintable(drawn));
    for (const QPushButton *button : bar->findChildren<QPushButton *>()) {
        if (button->isVisible())
            QVERIFY2(button->width() >= button->minimumSizeHint().width(), qPrintable(button->text()));
    }
}

void TestEditing::countsNameTheirProfile()
{
    WindowRig rig;
    QVERIFY(rig.open(u"sim:simplebgc"_s));
    auto *page = rig.page<ParametersPage>();
    rig.edit(u"pid.roll.p"_s, 0, 44);
    rig.edit(u"pid.roll.i"_s, 1, 44);
    rig.edit(u"pid.pitch.i"_s, 1, 44);
    rig.edit(u"motor.yaw.poles"_s, 0, 24);
    QStringList bar;
    for (const QLabel *label : rig.window().unsavedBar()->findChildren<QLabel *>())
        bar.append(label->toolTip() + label->text());
    const QString all = bar.join(u'\n');
    const auto named = [&rig](int profile) { return profileLabel(rig.model().edited(), profile); };
    QVERIFY2(all.contains(named(0) + u": 1"_s), qPrintable(all));
    QVERIFY2(all.contains(named(1) + u": 2"_s), qPrintable(all));
    QVERIFY2(all.contains(u"all profiles: 1"_s), qPrintable(all));
    QStringList tree;
    auto *groups = page->findChild<QListWidget *>();
    for (int row = 0; row < groups->count(); ++row)
        tree.append(groups->item(row)->text());
    QCOMPARE(tree.filter(u"•"_s).size(), 2);
    QCOMPARE(tree.filter(u"• P1: 1, P2: 2"_s).size(), 1);
    QCOMPARE(tree.filter(u"• 1"_s).size(), 1);
}

// An edit of an earlier run whose part did not come this time is neither lost nor taken for restored.
void TestEditing::leftoversOfMissingPartsAreKept()
{
    WindowRig rig;
    QVERIFY(rig.open());
    const QString key = u"motion.roll.acc_limit"_s;  // of PARAMS_EXT2
    const double wanted = rig.raw(key) + 1;
    rig.edit(key, 0, wanted);
    rig.edit(u"pid.roll.p"_s, 0, 44);
    rig.workspace().journal().flush();
    rig.crash();
    rig.restart();
    QSignalSpy found(&rig.workspace().journal(), &EditJournal::leftoverFound);
    QVERIFY(rig.open(u"sim:simplebgc?fault=deaf%3D62"_s));  // READ_PARAMS_EXT2
    QTRY_COMPARE(found.count(), 1);
    QVERIFY(rig.workspace().journal().leftoverWaits());
    rig.window().offerBar()->buttons().first()->click();
    QCOMPARE(rig.model().changeCount(), 0);
    QVERIFY(rig.window().messageBar()->text().contains(u"could not be read"_s));
    rig.workspace().changeWorld(u"deaf=-1"_s);
    rig.workspace().readBoard();
    QTRY_COMPARE(found.count(), 2);
    rig.window().offerBar()->buttons().first()->click();
    QCOMPARE(rig.model().changeCount(), 2);
    QCOMPARE(rig.model().value(rig.spec(key), 0).value(), wanted);
}

QTEST_MAIN(TestEditing)
#include "tst_editing.moc"
