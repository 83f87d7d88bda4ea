// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/bars.h"
#include "app/mainwindow/messagebar.h"
#include "app/mainwindow/pagetable.h"
#include "app/mainwindow/translations.h"
#include "app/pages/setup/parameterspage.h"
#include "app/pages/setup/profilespage.h"
#include "app/pages/tune/tuningpage.h"
#include "app/pages/tune/variablespage.h"
#include "tests/support/named.h"
#include "tests/support/patience.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/filtertable.h"
#include "widgets/forms/liveslider.h"
#include "widgets/forms/numberbox.h"
#include "widgets/forms/parameterform.h"
#include "widgets/forms/valueeditor.h"

#include <QAbstractItemView>
#include <QComboBox>
#include <QHeaderView>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QStyledItemDelegate>
#include <QTableView>

using namespace Qt::StringLiterals;

/// What was typed and is no value is neither lost nor overlooked, wherever it was typed: in a form, whose
/// fields come and go, in the cell of a table, on another page or for another profile.
class TestRefused : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void outlivesItsField_data();
    void outlivesItsField();
    void staysWithItsProfile();
    void anotherValueTakesItsPlace();
    void aReviewLeadsToIt();
    void discardingAndLeavingCountIt();
    void survivesACrash();
    void keepsTuningFromStoring();
    void tablesHaveNoFieldsOfTheirOwn_data();
    void tablesHaveNoFieldsOfTheirOwn();
    void theTableOfParametersKeepsIt();
    void variablesTakeWhatWasMeant();
    void theFirstKeyIsKept();
    void aLateReadingIsTypedOver();
    void aReadingAfterEnterReplacesNothing();
    void otherEditsKeepWhatIsHalfTyped();
    void readingKeepsWhatIsHalfTyped();
    void variablesKeepWhatIsHalfTyped();
    void namesKeepWhatIsTyped();

private:
    ParametersPage *parameters() { return m_rig->page<ParametersPage>(); }
    RefusedTexts &refused() { return m_rig->workspace().edits().refused(); }
    NumberBox *field(const QString &key)
    {
        ValueEditor *editor = parameters()->form()->editor(m_rig->spec(key).id);
        return editor ? qobject_cast<NumberBox *>(editor->control()) : nullptr;
    }
    bool holds(const QString &key, const QString &text)
    {
        const NumberBox *box = field(key);
        return box && box->isRefused() && box->typed() == text;
    }
    static void type(QWidget *box, const QString &text, Qt::Key last)
    {
        box->setFocus();
        QTest::keyClick(box, Qt::Key_A, Qt::ControlModifier);
        QTest::keyClicks(box, text);
        QTest::keyClick(box, last);
    }
    bool readAgain()
    {
        QSignalSpy read(&m_rig->workspace(), &Workspace::boardRead);
        m_rig->workspace().readBoard();
        return QTest::qWaitFor([&read] { return read.count() > 0; }, kPatience);
    }
    /// The field in which a cell is edited.
    static NumberBox *open(QAbstractItemView *table, const QModelIndex &cell)
    {
        table->setFocus();
        table->setCurrentIndex(cell);
        table->edit(cell);
        return table->findChild<NumberBox *>();
    }
    static bool isClosed(const QAbstractItemView *table)
    {
        return QTest::qWaitFor([table] { return !table->findChild<NumberBox *>(); });
    }

    std::unique_ptr<WindowRig> m_rig;
};

void TestRefused::init()
{
    m_rig = std::make_unique<WindowRig>();
    QVERIFY(QTest::qWaitForWindowActive(&m_rig->window()));
}

void TestRefused::cleanup()
{
    m_rig.reset();
}

void TestRefused::outlivesItsField_data()
{
    QTest::addColumn<QString>("what");
    for (const char *what : {"group", "read", "search", "chip", "level", "width", "view", "page", "link"})
        QTest::newRow(what) << QString::fromLatin1(what);
}

void TestRefused::outlivesItsField()
{
    QFETCH(const QString, what);
    m_rig->window().resize(1280, 800);
    QVERIFY(m_rig->open());
    parameters()->showParameter(u"pid.roll.p"_s);
    type(field(u"pid.roll.p"_s), u"300"_s, Qt::Key_Tab);
    QVERIFY(holds(u"pid.roll.p"_s, u"300"_s));
    auto *groups = named<QListWidget>(parameters(), u"Groups"_s);
    const int group = groups->currentRow();
    auto *level = named<QComboBox>(parameters(), u"How much to show"_s);
    const auto chip = [this](const QString &text) {
        for (QPushButton *button : parameters()->findChildren<QPushButton *>(u"chip"_s)) {
            if (button->text() == text)
                return button;
        }
        return static_cast<QPushButton *>(nullptr);
    };
    const QPointer<NumberBox> before = field(u"pid.roll.p"_s);
    if (what == u"group"_s) {
        parameters()->showGroup(group + 1);
        QVERIFY(!field(u"pid.roll.p"_s));
        parameters()->showGroup(group);
    } else if (what == u"read"_s) {
        QVERIFY(readAgain());
    } else if (what == u"search"_s) {
        parameters()->search()->setText(u"poles"_s);
        parameters()->search()->clear();
    } else if (what == u"chip"_s) {
        chip(u"Changed"_s)->setChecked(true);
        chip(u"Changed"_s)->setChecked(false);
    } else if (what == u"level"_s) {
        level->setCurrentIndex(2);
    } else if (what == u"width"_s) {
        m_rig->window().resize(1900, 800);
        QVERIFY(m_rig->isSettled());
    } else if (what == u"view"_s) {
        chip(u"Table"_s)->setChecked(true);
        chip(u"Table"_s)->setChecked(false);
    } else if (what == u"page"_s) {
        m_rig->window().showPage(u"console"_s);
        m_rig->window().showPage(u"parameters"_s);
    } else {
        m_rig->client().disconnectFromBoard();
        QTRY_VERIFY(!m_rig->client().isConnected());
        QVERIFY(m_rig->open());
        QVERIFY(m_rig->jobsAreDone());
    }
    if (what != u"page"_s)
        QTRY_VERIFY(!before);  // another field shows it
    QVERIFY(holds(u"pid.roll.p"_s, u"300"_s));
    QCOMPARE(refused().count(), 1);
    QCOMPARE(m_rig->model().changeCount(), 0);
}

void TestRefused::staysWithItsProfile()
{
    QVERIFY(m_rig->open());
    parameters()->showParameter(u"pid.roll.p"_s);
    type(field(u"pid.roll.p"_s), u"300"_s, Qt::Key_Tab);
    // The same value in both: what tells the profiles apart is not it.
    const double value = m_rig->raw(u"pid.roll.p"_s, 0);
    m_rig->edit(u"pid.roll.p"_s, 1, value);
    m_rig->model().setShownProfile(1);
    QVERIFY(!field(u"pid.roll.p"_s)->isRefused());
    QCOMPARE(field(u"pid.roll.p"_s)->typed(), QString::number(value));
    type(field(u"pid.roll.p"_s), u"400"_s, Qt::Key_Tab);
    m_rig->model().setShownProfile(0);
    QVERIFY(holds(u"pid.roll.p"_s, u"300"_s));
    m_rig->model().setShownProfile(1);
    QVERIFY(holds(u"pid.roll.p"_s, u"400"_s));
    // What belongs to the board as a whole is the same in each.
    parameters()->showParameter(u"motor.yaw.poles"_s);
    type(field(u"motor.yaw.poles"_s), u"999"_s, Qt::Key_Tab);
    m_rig->model().setShownProfile(0);
    QVERIFY(holds(u"motor.yaw.poles"_s, u"999"_s));
    QCOMPARE(refused().count(), 3);
}

void TestRefused::anotherValueTakesItsPlace()
{
    QVERIFY(m_rig->open());
    parameters()->showParameter(u"pid.roll.p"_s);
    const auto typeAgain = [this] {
        type(field(u"pid.roll.p"_s), u"300"_s, Qt::Key_Tab);
        return refused().count() == 1;
    };
    QVERIFY(typeAgain());
    type(field(u"pid.roll.p"_s), u"44"_s, Qt::Key_Tab);
    QCOMPARE(refused().count(), 0);
    QVERIFY(typeAgain());
    m_rig->workspace().edits().undo();
    QCOMPARE(refused().count(), 0);
    QCOMPARE(field(u"pid.roll.p"_s)->typed(), QString::number(m_rig->raw(u"pid.roll.p"_s)));
    QVERIFY(typeAgain());
    field(u"pid.roll.p"_s)->setFocus();
    QTest::keyClick(field(u"pid.roll.p"_s), Qt::Key_Escape);
    QCOMPARE(refused().count(), 0);
    // Its field is not there while the value comes from elsewhere.
    QVERIFY(typeAgain());
    parameters()->showParameter(u"motor.yaw.poles"_s);
    m_rig->edit(u"pid.roll.p"_s, 0, 44);
    QCOMPARE(refused().count(), 0);
    // Another board has nothing of it.
    parameters()->showParameter(u"pid.roll.p"_s);
    QVERIFY(typeAgain());
    m_rig->client().disconnectFromBoard();
    QTRY_VERIFY(!m_rig->client().isConnected());
    QVERIFY(m_rig->open(u"sim:storm32"_s));
    QTRY_COMPARE(m_rig->model().board().identity().family, u"storm32"_s);
    QCOMPARE(refused().count(), 0);
}

void TestRefused::aReviewLeadsToIt()
{
    QVERIFY(m_rig->open());
    parameters()->showParameter(u"pid.roll.p"_s);
    m_rig->model().setShownProfile(2);
    type(field(u"pid.roll.p"_s), u"300"_s, Qt::Key_Tab);
    m_rig->model().setShownProfile(0);
    type(field(u"pid.pitch.p"_s), u"31"_s, Qt::Key_Tab);
    QCOMPARE(m_rig->model().changeCount(), 1);
    m_rig->window().showPage(u"dashboard"_s);
    QSignalSpy told(&m_rig->workspace().notifications(), &Notifications::notice);
    QTest::keyClick(&m_rig->window(), Qt::Key_S, Qt::ControlModifier);
    QVERIFY(!m_rig->window().reviewDialog());
    QCOMPARE(m_rig->window().navigation()->currentPage(), u"parameters"_s);
    QCOMPARE(m_rig->model().shownProfile(), 2);
    QTRY_VERIFY(field(u"pid.roll.p"_s)->hasFocus());
    QVERIFY(holds(u"pid.roll.p"_s, u"300"_s));
    QCOMPARE(told.count(), 1);
    const QString text = told.first().first().toString();
    QVERIFY2(text.contains(u"P · Roll"_s) && text.contains(profileLabel(m_rig->model().edited(), 2))
                 && text.contains(u"300"_s) && text.contains(u"0 to 255"_s),
             qPrintable(text));
    // The same page: it is said again.
    QTest::keyClick(field(u"pid.roll.p"_s), Qt::Key_S, Qt::ControlModifier);
    QVERIFY(!m_rig->window().reviewDialog());
    QCOMPARE(told.count(), 2);
    // In range, and yet no value.
    type(field(u"pid.roll.p"_s), u"31.5"_s, Qt::Key_Tab);
    m_rig->window().review();
    QCOMPARE(told.count(), 3);
    QVERIFY2(told.last().first().toString().contains(u"Whole numbers, 0 to 255"_s),
             qPrintable(told.last().first().toString()));
    QTest::keyClick(field(u"pid.roll.p"_s), Qt::Key_Escape);
    m_rig->window().review();
    QTRY_VERIFY(m_rig->window().reviewDialog());
}

void TestRefused::discardingAndLeavingCountIt()
{
    QVERIFY(m_rig->open());
    parameters()->showParameter(u"pid.roll.p"_s);
    QVERIFY(!m_rig->window().unsavedBar()->isVisible());
    type(field(u"pid.roll.p"_s), u"300"_s, Qt::Key_Tab);
    QCOMPARE(m_rig->workspace().unsavedCount(), 1);
    QTRY_VERIFY(m_rig->window().unsavedBar()->isVisible());
    named<QPushButton>(m_rig->window().unsavedBar(), u"Discard"_s)->click();
    QCOMPARE(m_rig->workspace().unsavedCount(), 0);
    QVERIFY(!m_rig->window().unsavedBar()->isVisible());
    QVERIFY(!field(u"pid.roll.p"_s)->isRefused());
    QCOMPARE(field(u"pid.roll.p"_s)->typed(), QString::number(m_rig->raw(u"pid.roll.p"_s)));
}

void TestRefused::survivesACrash()
{
    QVERIFY(m_rig->open());
    parameters()->showParameter(u"pid.roll.p"_s);
    type(field(u"pid.roll.p"_s), u"300"_s, Qt::Key_Tab);
    m_rig->workspace().journal().flush();
    m_rig->crash();
    m_rig->restart();
    QSignalSpy found(&m_rig->workspace().journal(), &EditJournal::leftoverFound);
    QVERIFY(m_rig->open());
    QTRY_COMPARE(found.count(), 1);
    QCOMPARE(found.first().at(1).toInt(), 1);
    QVERIFY(m_rig->workspace().journal().restoreLeftover().any);
    parameters()->showParameter(u"pid.roll.p"_s);
    QVERIFY(holds(u"pid.roll.p"_s, u"300"_s));
}

void TestRefused::keepsTuningFromStoring()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<TuningPage>();
    QTRY_VERIFY(page->control(u"pid.roll.p"_s) && page->control(u"pid.roll.p"_s)->isEnabled());
    const auto box = [page](const QString &key) {
        return qobject_cast<NumberBox *>(page->control(key)->editor()->control());
    };
    emit page->control(u"pid.yaw.p"_s)->edited(m_rig->raw(u"pid.yaw.p"_s) + 5);
    QTRY_COMPARE(m_rig->workspace().live().changeCount(), 1);
    QTRY_VERIFY(box(u"pid.roll.p"_s)->isEnabled());
    type(box(u"pid.roll.p"_s), u"300"_s, Qt::Key_Tab);
    QVERIFY(box(u"pid.roll.p"_s)->isRefused());
    QVERIFY(readAgain());
    QCOMPARE(box(u"pid.roll.p"_s)->typed(), u"300"_s);
    QVERIFY(box(u"pid.roll.p"_s)->isRefused());
    // Connected again, the controls are others.
    const QPointer<NumberBox> before = box(u"pid.roll.p"_s);
    m_rig->client().disconnectFromBoard();
    QTRY_VERIFY(!m_rig->client().isConnected());
    QVERIFY(m_rig->open());
    QVERIFY(m_rig->jobsAreDone());
    QTRY_VERIFY(!before);
    QTRY_VERIFY(box(u"pid.roll.p"_s)->isEnabled());
    QCOMPARE(box(u"pid.roll.p"_s)->typed(), u"300"_s);
    QVERIFY(box(u"pid.roll.p"_s)->isRefused());
    emit page->control(u"pid.yaw.p"_s)->edited(m_rig->raw(u"pid.yaw.p"_s) + 5);
    QTRY_COMPARE(m_rig->workspace().live().changeCount(), 1);
    QSignalSpy taken(&m_rig->workspace(), &Workspace::snapshotTaken);
    for (QPushButton *button : m_rig->window().findChildren<QPushButton *>()) {
        if (button->isVisible() && button->isEnabled() && button->text().startsWith(u"Store"_s))
            button->click();
    }
    QVERIFY(box(u"pid.roll.p"_s)->hasFocus());
    QVERIFY(m_rig->jobsAreDone());
    QCOMPARE(m_rig->workspace().live().changeCount(), 1);
}

void TestRefused::tablesHaveNoFieldsOfTheirOwn_data()
{
    QTest::addColumn<QString>("address");
    QTest::newRow("SimpleBGC") << u"sim:simplebgc"_s;
    QTest::newRow("STorM32") << u"sim:storm32"_s;
}

// Qt's own delegate would make a QSpinBox of a number, which takes a German comma for a group of digits.
void TestRefused::tablesHaveNoFieldsOfTheirOwn()
{
    QFETCH(const QString, address);
    QVERIFY(m_rig->open(address));
    QVERIFY(QTest::qWaitFor(
        [this] {
            auto *page = m_rig->page<VariablesPage>();
            return page
                && page->model()
                       .index(0, AdjustableModel::ValueColumn)
                       .data(TableModel::NumberRole)
                       .isValid();
        },
        kPatience));
    // Of all groups and levels, not only what is shown first.
    named<QComboBox>(parameters(), u"How much to show"_s)->setCurrentIndex(2);
    for (QPushButton *chip : parameters()->findChildren<QPushButton *>(u"chip"_s)) {
        if (chip->text() == u"Table"_s)
            chip->setChecked(true);
    }
    parameters()->search()->setText(u"e"_s);
    int numbers = 0;
    int others = 0;
    for (const PageEntry &entry : pageTable()) {
        const QString key = QString::fromLatin1(entry.key);
        if (!m_rig->window().showPage(key))
            continue;
        for (QAbstractItemView *view : m_rig->window().page(key)->findChildren<QAbstractItemView *>()) {
            const QAbstractItemModel *model = view->model();
            const bool isHeader = qobject_cast<QHeaderView *>(view);
            if (!model || isHeader || view->editTriggers() == QAbstractItemView::NoEditTriggers)
                continue;
            for (int row = 0; row < model->rowCount(); ++row) {
                for (int column = 0; column < model->columnCount(); ++column) {
                    const QModelIndex cell = model->index(row, column);
                    if (!(cell.flags() & Qt::ItemIsEditable))
                        continue;
                    const std::unique_ptr<QWidget> editor(
                        view->itemDelegateForIndex(cell)->createEditor(view->viewport(), {}, cell));
                    const bool isNumber = cell.data(TableModel::NumberRole).isValid();
                    const bool isBox = qobject_cast<NumberBox *>(editor.get());
                    const bool isQts = qobject_cast<QAbstractSpinBox *>(editor.get()) && !isBox;
                    QVERIFY2(isNumber == isBox && !isQts,
                             qPrintable(u"%1, row %2, column %3"_s.arg(key).arg(row).arg(column)));
                    ++(isNumber ? numbers : others);
                }
            }
        }
    }
    QVERIFY2(numbers > 60 && others > 20, qPrintable(u"%1, %2"_s.arg(numbers).arg(others)));
}

void TestRefused::theTableOfParametersKeepsIt()
{
    const Translations german(u"de"_s);
    QVERIFY(m_rig->open());
    QTableView *table = parameters()->table();
    for (QPushButton *chip : parameters()->findChildren<QPushButton *>(u"chip"_s)) {
        if (chip->isCheckable() && chip == parameters()->findChildren<QPushButton *>(u"chip"_s).last())
            chip->setChecked(true);
    }
    QTRY_VERIFY(table->isVisible());
    const auto cell = [&](const QString &key) {
        const auto found = table->model()->match(table->model()->index(0, 0), ParameterModel::IdRole,
                                                 m_rig->spec(key).id, 1, Qt::MatchExactly);
        return found.isEmpty() ? QModelIndex() : found.first().siblingAtColumn(ParameterModel::ValueColumn);
    };
    const auto value = [this](const QString &key) {
        return m_rig->spec(key).toDisplay(*m_rig->model().value(m_rig->spec(key), 0));
    };
    const QString key = u"pid.roll.i"_s;  // two decimals
    NumberBox *box = open(table, cell(key));
    QVERIFY(box);
    type(box, u"0,2"_s, Qt::Key_Return);
    QVERIFY(isClosed(table));
    QCOMPARE(value(key), 0.2);
    // Enter leaves it open; another cell leaves it where it was typed.
    box = open(table, cell(u"pid.roll.p"_s));
    type(box, u"300"_s, Qt::Key_Return);
    QCOMPARE(table->findChild<NumberBox *>(), box);
    QVERIFY(box->isRefused() && box->advice().contains(u"255"_s));
    table->setCurrentIndex(cell(key));
    QVERIFY(isClosed(table));
    QCOMPARE(cell(u"pid.roll.p"_s).data(TableModel::RefusedRole).toString(), u"300"_s);
    QCOMPARE(refused().count(), 1);
    QCOMPARE(value(u"pid.roll.p"_s), m_rig->raw(u"pid.roll.p"_s));
    // It is the same text in the form, and there again when the cell is opened.
    box = open(table, cell(u"pid.roll.p"_s));
    QVERIFY(box->isRefused());
    QCOMPARE(box->typed(), u"300"_s);
    QTest::keyClick(box, Qt::Key_Escape);
    QVERIFY(isClosed(table));
    QCOMPARE(refused().count(), 0);
    // Opened and closed again, nothing has changed.
    const int changes = m_rig->model().changeCount();
    for (const QString &each : {u"pid.roll.p"_s, key}) {
        box = open(table, cell(each));
        QTest::keyClick(box, Qt::Key_Return);
        QVERIFY(isClosed(table));
    }
    QCOMPARE(m_rig->model().changeCount(), changes);
}

void TestRefused::variablesTakeWhatWasMeant()
{
    const Translations german(u"de"_s);
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<VariablesPage>();
    FilterTable *table = page->table();
    const auto cell = [page, table](int row) {
        return table->fromSource(page->model().index(row, AdjustableModel::ValueColumn));
    };
    QTRY_VERIFY(cell(3).data(TableModel::NumberRole).isValid());
    const QString before = cell(3).data().toString();
    QSignalSpy written(&page->model(), &AdjustableModel::written);
    for (const QString &text : {u"3,5"_s, u"300"_s, u"1.000"_s}) {
        NumberBox *box = open(table, cell(3));
        QVERIFY(box);
        type(box, text, Qt::Key_Return);
        QVERIFY(box->isRefused());
        QCOMPARE(box->typed(), text);
        QVERIFY(box->advice().contains(u"255"_s));
        // Another cell is chosen: it stays where it was typed.
        table->setCurrentIndex(cell(5));
        QVERIFY(isClosed(table));
        QCOMPARE(cell(3).data(TableModel::RefusedRole).toString(), text);
    }
    QVERIFY(m_rig->jobsAreDone());
    QCOMPARE(written.count(), 0);
    QCOMPARE(cell(3).data().toString(), before);
    // It is not in use, and nothing is stored before it is settled.
    NumberBox *box = nullptr;
    for (QPushButton *button : page->findChildren<QPushButton *>()) {
        if (button->isVisible() && !button->isCheckable()) {
            button->click();
            box = table->findChild<NumberBox *>();
        }
    }
    QVERIFY(box && box->isRefused());
    type(box, u"35"_s, Qt::Key_Return);
    QVERIFY(isClosed(table));
    QTRY_COMPARE(written.count(), before == u"35"_s ? 0 : 1);
    QVERIFY(!cell(3).data(TableModel::RefusedRole).isValid());
    // With the first key, as it is typed.
    table->setCurrentIndex(cell(3));
    QTest::keyClicks(table, u"4"_s);
    QTRY_VERIFY(table->findChild<NumberBox *>());
    QCoreApplication::processEvents();
    QTest::keyClicks(table->findChild<NumberBox *>(), u"1"_s);
    QTest::keyClick(table->findChild<NumberBox *>(), Qt::Key_Return);
    QVERIFY(isClosed(table));
    QTRY_VERIFY(written.last().at(1).toDouble() == 41.0);
}

// A field that opens with the key that is its value already; the next key comes in the same moment.
void TestRefused::theFirstKeyIsKept()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<VariablesPage>();
    FilterTable *table = page->table();
    const QModelIndex cell = table->fromSource(page->model().index(3, AdjustableModel::ValueColumn));
    QTRY_VERIFY(cell.data(TableModel::NumberRole).isValid());
    QSignalSpy written(&page->model(), &AdjustableModel::written);
    for (const QString &keys : {u"4"_s, u"41"_s}) {
        table->setFocus();
        table->setCurrentIndex(cell);
        QTest::keyClicks(table, keys.first(1));
        auto *box = table->findChild<NumberBox *>();
        QVERIFY(box);
        for (const QChar key : keys.sliced(1)) {
            QCoreApplication::processEvents();
            QTest::keyClick(box, key.toLatin1());
        }
        QCOMPARE(box->typed(), keys);
        QTest::keyClick(box, Qt::Key_Return);
        QVERIFY(isClosed(table));
        QTRY_COMPARE(cell.data(Qt::EditRole).toDouble(), keys.toDouble());
    }
}

void TestRefused::aLateReadingIsTypedOver()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<VariablesPage>();
    FilterTable *table = page->table();
    const QModelIndex cell = table->fromSource(page->model().index(3, AdjustableModel::ValueColumn));
    QTRY_VERIFY(cell.data(TableModel::NumberRole).isValid());
    NumberBox *box = open(table, cell);
    QVERIFY(box);
    // Meanwhile the radio changes it.
    page->model().setData(page->model().index(3, AdjustableModel::ValueColumn), 123.0);
    QTRY_COMPARE(box->typed(), u"123"_s);
    QTest::keyClicks(box, u"7"_s);
    QCOMPARE(box->typed(), u"7"_s);
    QTest::keyClick(box, Qt::Key_Return);
    QVERIFY(isClosed(table));
    QTRY_COMPARE(cell.data(Qt::EditRole).toDouble(), 7.0);
}

// A reading that arrives in the moment between the key and the closing of the field, and one before it that
// makes what was typed the same as what was there.
void TestRefused::aReadingAfterEnterReplacesNothing()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<VariablesPage>();
    FilterTable *table = page->table();
    const QModelIndex source = page->model().index(3, AdjustableModel::ValueColumn);
    const QModelIndex cell = table->fromSource(source);
    QTRY_VERIFY(cell.data(TableModel::NumberRole).isValid());
    const double before = cell.data(Qt::EditRole).toDouble();
    NumberBox *box = open(table, cell);
    QTest::keyClicks(box, u"41"_s);
    QTest::keyClick(box, Qt::Key_Return);
    emit page->model().dataChanged(source, source);
    QVERIFY(isClosed(table));
    QVERIFY(m_rig->jobsAreDone());
    QTRY_COMPARE(cell.data(Qt::EditRole).toDouble(), 41.0);
    box = open(table, cell);
    QTest::keyClicks(box, u"41"_s);
    page->model().setData(source, before);
    QTRY_COMPARE(cell.data(Qt::EditRole).toDouble(), before);
    QTest::keyClick(box, Qt::Key_Return);
    QVERIFY(isClosed(table));
    QTRY_COMPARE(cell.data(Qt::EditRole).toDouble(), 41.0);
}

// A write that ends, or an edit elsewhere, changes the count of changes, and each field is looked at.
void TestRefused::otherEditsKeepWhatIsHalfTyped()
{
    QVERIFY(m_rig->open());
    parameters()->showParameter(u"pid.roll.p"_s);
    NumberBox *box = field(u"pid.roll.p"_s);
    QVERIFY(box);
    box->setFocus();
    QTest::keyClick(box, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(box, u"12"_s);
    m_rig->edit(u"pid.roll.i"_s, 0, m_rig->raw(u"pid.roll.i"_s) + 1);
    QCOMPARE(box->typed(), u"12"_s);
    QTest::keyClicks(box, u"3"_s);
    QTest::keyClick(box, Qt::Key_Return);
    QCOMPARE(*m_rig->model().value(m_rig->spec(u"pid.roll.p"_s), 0), 123.0);
}

void TestRefused::readingKeepsWhatIsHalfTyped()
{
    QVERIFY(m_rig->open());
    QTableView *table = parameters()->table();
    for (QPushButton *chip : parameters()->findChildren<QPushButton *>(u"chip"_s)) {
        if (chip->text() == u"Table"_s)
            chip->setChecked(true);
    }
    QTRY_VERIFY(table->isVisible());
    const ParameterSpec &spec = m_rig->spec(u"pid.roll.p"_s);
    const auto cell = [&] {
        return table->model()
            ->match(table->model()->index(0, 0), ParameterModel::IdRole, spec.id, 1, Qt::MatchExactly)
            .first()
            .siblingAtColumn(ParameterModel::ValueColumn);
    };
    NumberBox *box = open(table, cell());
    QVERIFY(box);
    QTest::keyClicks(box, u"12"_s);
    QVERIFY(readAgain());
    box = nullptr;
    for (NumberBox *each : table->findChildren<NumberBox *>())
        box = each->isVisible() ? each : box;
    QVERIFY(box);
    QCOMPARE(box->typed(), u"12"_s);
    QTest::keyClicks(box, u"3"_s);
    QTest::keyClick(box, Qt::Key_Return);
    QVERIFY(isClosed(table));
    QCOMPARE(*m_rig->model().value(spec, 0), 123.0);
}

// The link breaks and comes back while a number is being typed.
void TestRefused::variablesKeepWhatIsHalfTyped()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<VariablesPage>();
    FilterTable *table = page->table();
    const auto cell
        = [page, table] { return table->fromSource(page->model().index(3, AdjustableModel::ValueColumn)); };
    QTRY_VERIFY(cell().data(TableModel::NumberRole).isValid());
    NumberBox *box = open(table, cell());
    QTest::keyClicks(box, u"12"_s);
    m_rig->workspace().changeWorld(u"replug=1"_s);
    m_rig->workspace().changeWorld(u"unplug=0"_s);
    QTRY_VERIFY(!m_rig->client().isConnected());
    QTRY_VERIFY(m_rig->client().isConnected());
    QVERIFY(m_rig->jobsAreDone());
    QTRY_VERIFY(cell().data(TableModel::NumberRole).isValid());
    box = nullptr;
    for (NumberBox *each : table->findChildren<NumberBox *>())
        box = each->isVisible() ? each : box;
    QVERIFY(box);
    QCOMPARE(box->typed(), u"12"_s);
    QTest::keyClick(box, Qt::Key_Return);
    QVERIFY(isClosed(table));
    QTRY_COMPARE(cell().data(Qt::EditRole).toDouble(), 12.0);
}

void TestRefused::namesKeepWhatIsTyped()
{
    QVERIFY(m_rig->open());
    QTableView *table = m_rig->page<ProfilesPage>()->table();
    const auto field = [table]() -> QLineEdit * {
        for (auto *line : table->viewport()->findChildren<QLineEdit *>()) {
            if (line->isVisible())
                return line;
        }
        return nullptr;
    };
    table->setFocus();
    table->setCurrentIndex(table->model()->index(0, ProfileModel::NameColumn));
    table->edit(table->currentIndex());
    QVERIFY(field());
    QTest::keyClicks(field(), u"half a na"_s);
    // Values change and the board is read meanwhile.
    m_rig->edit(u"pid.roll.p"_s, 0, m_rig->raw(u"pid.roll.p"_s) + 1);
    QCOMPARE(field()->text(), u"half a na"_s);
    QVERIFY(readAgain());
    QVERIFY(field());
    QCOMPARE(field()->text(), u"half a na"_s);
    const QString tooLong = u"me"_s + QString(60, u'x');
    QTest::keyClicks(field(), tooLong);
    QTest::keyClick(field(), Qt::Key_Return);
    QTRY_VERIFY(m_rig->window().messageBar()->text().contains(u"too long"_s));
    QTRY_VERIFY(field() && field()->text() == u"half a na"_s + tooLong);
    QTest::keyClick(field(), Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(field(), u"short"_s);
    QTest::keyClick(field(), Qt::Key_Return);
    QTRY_COMPARE(std::as_const(m_rig->model()).edited().profileNames().value(0), u"short"_s);
}

QTEST_MAIN(TestRefused)
#include "tst_refused.moc"
