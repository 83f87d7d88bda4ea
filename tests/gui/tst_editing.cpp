// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/bars.h"
#include "app/pages/setup/parameterspage.h"
#include "app/pages/setup/profilespage.h"
#include "app/pages/tune/tuningpage.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/liveslider.h"
#include "widgets/forms/parameterform.h"
#include "widgets/forms/valueeditor.h"

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QTableView>

using namespace Qt::StringLiterals;

/// Edits mark themselves where they stand, and are undone where it can be seen.
class TestEditing : public QObject
{
    Q_OBJECT
private slots:
    void nothingMovesWhenAValueChanges_data();
    void nothingMovesWhenAValueChanges();
    void nothingMovesUnderTheSlider();
    void undoLeadsToTheField();
    void undoLeadsToAnotherProfile();
    void undoLeadsToTheName();
    void undoStaysInTheTable();
    void countsNameTheirProfile();

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
}

// The board goes on with the profile that it uses.
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

QTEST_MAIN(TestEditing)
#include "tst_editing.moc"
