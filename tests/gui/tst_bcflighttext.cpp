// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/bars.h"
#include "app/mainwindow/messagebar.h"
#include "app/mainwindow/navigation.h"
#include "app/pages/setup/documentspage.h"
#include "app/pages/setup/parameterspage.h"
#include "app/pages/tune/tuningpage.h"
#include "protocol/bcflight/tables.h"
#include "protocol/configuration/writereport.h"
#include "tests/support/named.h"
#include "tests/support/patience.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/reviewdialog.h"
#include "widgets/forms/valueeditor.h"
#include "widgets/views/codeeditor.h"
#include "widgets/views/diffview.h"
#include "widgets/views/searchbar.h"

#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableView>
#include <QToolButton>
#include <Qsci/qscilexer.h>

using namespace Qt::StringLiterals;

/// The configuration text of a drone on the screen.
class TestBcflightText final : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup() { m_rig.reset(); }
    void mistakeIsMarkedAndReached();
    void wordsAreFound();
    void differenceIsShown();
    void onlyWhatDiffersIsReplaced();
    void everyLanguageHasItsColours();
    void refusedStoreLeadsToTheLine();
    void doubtsAreReviewed();
    void gainsAreShownAsInTheText();
    void writtenGainsAreNotStoredYet();
    void gainsAndTextAreWrittenInOneGo();

private:
    MainWindow &window() { return m_rig->window(); }
    DocumentsPage *page() { return m_rig->page<DocumentsPage>(); }
    [[nodiscard]] QByteArray held() const
    {
        return std::as_const(m_rig->model()).edited().block({0, bcflight::ConfigurationText});
    }
    static bool says(const QWidget *where, const QString &text)
    {
        const auto labels = where->findChildren<QLabel *>();
        return std::any_of(labels.begin(), labels.end(), [&text](const QLabel *label) {
            return label->isVisible() && label->text().contains(text);
        });
    }
    bool write();

    QString m_lines;  // of the last review
    QString m_counted;
    QStringList m_said;
    std::unique_ptr<WindowRig> m_rig;
};

void TestBcflightText::init()
{
    static int seed = 700;
    m_rig = std::make_unique<WindowRig>();
    QVERIFY(m_rig->open(u"sim:bcflight?seed=%1"_s.arg(++seed)));
}

bool TestBcflightText::write()
{
    QSignalSpy finished(&m_rig->workspace(), &Workspace::writeFinished);
    QTest::mouseClick(window().unsavedBar()->writeButton(), Qt::LeftButton);
    if (!QTest::qWaitFor([this] { return window().reviewDialog() != nullptr; }, kPatience))
        return false;
    const ReviewDialog *review = window().reviewDialog();
    m_lines = review->lines() ? review->lines()->toPlainText() : QString();
    m_said.clear();
    for (const QLabel *label : review->findChildren<QLabel *>())
        m_said.append(label->isVisibleTo(review) ? label->text() : QString());
    m_counted
        = review->table()->model()->index(review->table()->model()->rowCount() - 1, 3).data().toString();
    QTest::mouseClick(window().reviewDialog()->writeButton(), Qt::LeftButton);
    return QTest::qWaitFor([&] { return finished.count() > 0; }, kPatience)
        && m_rig->workspace().lastReport()->isComplete();
}

void TestBcflightText::mistakeIsMarkedAndReached()
{
    DocumentsPage *documents = page();
    TextEditor *editor = documents->editor();
    QVERIFY(says(documents, u"Valid Lua"_s));
    QVERIFY(says(documents, u"does not prove that the board starts"_s));
    editor->setFocus();
    editor->setCursorPosition(2, 0);
    QTest::keyClicks(editor, u"= "_s);
    QTRY_VERIFY(says(documents, u"Line 3: "_s));
    QVERIFY(documents->findChild<QLabel *>(u"error"_s));
    QVERIFY(editor->markersAtLine(2) != 0U);
    QVERIFY(!editor->annotation(2).isEmpty());
    // From elsewhere the button leads there.
    editor->goToLine(editor->lines());
    auto *there = named<QPushButton>(documents, u"Go to line 3"_s);
    QVERIFY(there->isVisible());
    QTest::mouseClick(there, Qt::LeftButton);
    int line = -1;
    int column = -1;
    editor->getCursorPosition(&line, &column);
    QCOMPARE(line, 2);
    QVERIFY(editor->hasFocus());
    // It is not even reviewed.
    m_rig->window().review();
    QVERIFY(!m_rig->window().reviewDialog());
    QTRY_VERIFY(m_rig->window().messageBar()->text().contains(u"line 3"_s));
    // Undone as one step; the mark goes with it.
    QTest::keyClick(editor, Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY(says(documents, u"Valid Lua"_s));
    QCOMPARE(editor->markersAtLine(2), 0U);
    QVERIFY(!there->isVisible());
}

void TestBcflightText::wordsAreFound()
{
    DocumentsPage *documents = page();
    TextEditor *editor = documents->editor();
    QTest::keyClick(documents, Qt::Key_F, Qt::ControlModifier);
    auto *bar = documents->findChild<SearchBar *>();
    auto *field = named<QLineEdit>(documents, u"Search in the text"_s);
    QTRY_VERIFY(bar->isVisible() && field->hasFocus());
    QTest::keyClicks(field, u"pid_"_s);
    const int all = int(held().toLower().count("pid_"));
    QVERIFY(all >= 4);
    QCOMPARE(bar->count(), all);
    QVERIFY(says(bar, u"1 of %1"_s.arg(all)));
    QCOMPARE(editor->selectedText(), u"pid_"_s);
    QTest::keyClick(field, Qt::Key_Return);
    QVERIFY(says(bar, u"2 of %1"_s.arg(all)));
    QTest::keyClick(documents, Qt::Key_F3, Qt::ShiftModifier);
    QVERIFY(says(bar, u"1 of %1"_s.arg(all)));
    QTest::keyClick(documents, Qt::Key_F3, Qt::ShiftModifier);  // over the beginning
    QVERIFY(says(bar, u"%1 of %1"_s.arg(all)));
    QTest::keyClick(documents, Qt::Key_F3);
    QVERIFY(says(bar, u"1 of %1"_s.arg(all)));
    // A capital counts.
    field->setText(u"PID_"_s);
    QVERIFY(says(bar, u"Not found"_s));
    QVERIFY(!named<QToolButton>(bar, u"Next place"_s)->isEnabled());
    QTest::keyClick(field, Qt::Key_Escape);
    QVERIFY(!bar->isVisible() && editor->hasFocus());
    QVERIFY(!documents->hasChanges());
}

void TestBcflightText::differenceIsShown()
{
    DocumentsPage *documents = page();
    TextEditor *editor = documents->editor();
    auto *difference = named<QPushButton>(documents, u"Difference"_s);
    auto *view = documents->findChild<DiffView *>();
    difference->click();
    QVERIFY(view->isVisible() && says(documents, u"No difference"_s));
    difference->click();
    QVERIFY(editor->isVisible());
    QByteArray text = held();
    QVERIFY(text.contains("rate_speed = 300"));
    text.replace("rate_speed = 300", "rate_speed = 250");
    m_rig->workspace().edits().editData({0, bcflight::ConfigurationText}, text);
    QCOMPARE(editor->bytes(), text);
    difference->click();
    QVERIFY(says(documents, u"1 line(s) added, 1 line(s) removed"_s)
            || says(documents, u"1 line added, 1 line removed"_s));
    const QString shown = view->text();
    QVERIFY2(shown.contains(u"− \trate_speed = 300"_s) && shown.contains(u"+ \trate_speed = 250"_s),
             qPrintable(shown));
    QVERIFY(shown.count(u'\n') < 12);  // only what is around it
    // From the changed line to the same one in the text.
    const int row = int(shown.left(shown.indexOf(u"+ \t"_s)).count(u'\n'));
    view->setCursorPosition(row, 0);
    QVERIFY(view->markersAtLine(row) != 0U);
    QTest::mouseClick(named<QPushButton>(documents, u"Show in the text"_s), Qt::LeftButton);
    int line = -1;
    int column = -1;
    editor->getCursorPosition(&line, &column);
    QVERIFY(editor->isVisible());
    QVERIFY(editor->text(line).contains(u"rate_speed"_s));
    QVERIFY(!difference->isChecked());
}

// The place that is seen stays where it is when a step is undone.
void TestBcflightText::onlyWhatDiffersIsReplaced()
{
    Theme theme;
    TextEditor editor(theme);
    const QList<QByteArray> texts{"a\nb\nc\n",         "",      "a\r\nb\r\n", "ä\nö\nü\n",
                                  "ä\nß\nü\n",         "é",     "a\nb\nc",    QByteArray("a\0b", 3),
                                  "\xff\xfe broken\n", "€\n₤\n"};
    for (const QByteArray &from : texts) {
        for (const QByteArray &to : texts) {
            editor.setBytes(from);
            QCOMPARE(editor.bytes(), from);
            editor.setBytes(to);
            QCOMPARE(editor.bytes(), to);
        }
    }
    QByteArray many;
    for (int i = 0; i < 300; ++i)
        many += "line " + QByteArray::number(i) + '\n';
    editor.resize(300, 200);
    editor.setBytes(many);
    editor.goToLine(200);
    const int first = editor.firstVisibleLine();
    QVERIFY(first > 100);
    editor.setBytes(many.replace("line 250", "line two hundred and fifty"));
    QCOMPARE(editor.firstVisibleLine(), first);
    int line = 0;
    int column = 0;
    editor.getCursorPosition(&line, &column);
    QCOMPARE(line, 199);
}

// Words, numbers, strings and comments can be told apart, and read, in light and dark.
void TestBcflightText::everyLanguageHasItsColours()
{
    Theme theme;
    TextEditor editor(theme);
    editor.setLanguage(u"lua"_s);
    for (const auto mode : {Theme::Mode::Light, Theme::Mode::Dark}) {
        theme.setMode(mode);
        QSet<QRgb> seen;
        for (const int style : {5, 4, 6, 2, 0}) {  // keyword, number, string, comment, anything else
            const QColor color = editor.lexer()->color(style);
            QVERIFY(Theme::contrast(color, editor.lexer()->paper(style)) >= 4.5);
            seen.insert(color.rgb());
        }
        QCOMPARE(seen.size(), 5);
    }
    editor.setLanguage({});
    QVERIFY(!editor.lexer());
}

// Errata 7.2: a name that is set twice is left to the operator, who is led there.
void TestBcflightText::refusedStoreLeadsToTheLine()
{
    page();
    QByteArray text = held();
    const QByteArray gains = "pid_yaw = PID( 180, 40, 0 ),";
    QVERIFY(text.contains(gains));
    text.replace(gains, gains + "\n\t" + gains);
    m_rig->workspace().edits().editData({0, bcflight::ConfigurationText}, text);
    QVERIFY(write());
    QTRY_VERIFY(m_rig->jobsAreDone());
    const auto done = m_rig->workspace().perform(u"gains.store"_s, {});
    QTRY_VERIFY(done.isFinished());
    QVERIFY(!done.result());
    window().showPage(u"dashboard"_s);
    const int second = int(text.left(text.lastIndexOf("pid_yaw")).count('\n'));
    auto *open = named<QPushButton>(&window(), u"Open the text at line %1"_s.arg(second + 1));
    QTRY_VERIFY(open->isVisible());
    QTest::mouseClick(open, Qt::LeftButton);
    QCOMPARE(window().navigation()->currentPage(), u"documents"_s);
    int line = -1;
    int column = -1;
    page()->editor()->getCursorPosition(&line, &column);
    QCOMPARE(line, second);
}

// Errata 7.2: the text has 90 where 0.00144 is in use.
void TestBcflightText::doubtsAreReviewed()
{
    const auto reviewed = [this](const QByteArray &before, const QByteArray &after) {
        QByteArray text = held();
        QTest::qVerify(text.contains(before), "contains", before, __FILE__, __LINE__);
        m_rig->workspace().edits().editData({0, bcflight::ConfigurationText}, text.replace(before, after));
        window().review();
        return window().reviewDialog();
    };
    ReviewDialog *review = reviewed("rate_speed = 300", "rate_speed = 250");
    QVERIFY(review);
    QVERIFY2(review->doubts().contains(u"does not prove"_s), qPrintable(review->doubts()));
    QVERIFY(says(review, review->doubts()));
    QCOMPARE(review->writeButton()->objectName(), u"danger"_s);  // gains stand in it
    review->reject();
    QTRY_VERIFY(!window().reviewDialog());
    review = reviewed("Vector( 1.0, -1.0, -1.0, 1.0 )", "Vector( -1.0, -1.0, -1.0, 1.0 )");
    QVERIFY(review);
    QVERIFY2(review->doubts().contains(u"roll add up to -2"_s), qPrintable(review->doubts()));
    QVERIFY(says(review, review->doubts()));
    QCOMPARE(review->writeButton()->objectName(), u"danger"_s);
    // Not ticked, it is not written.
    const QModelIndex text = review->table()->model()->index(0, 0);
    QVERIFY(review->table()->model()->setData(text, Qt::Unchecked, Qt::CheckStateRole));
    QVERIFY(!says(review, review->doubts()));
}

void TestBcflightText::gainsAreShownAsInTheText()
{
    auto *parameters = m_rig->page<ParametersPage>();
    const auto figure = [](const QWidget *where) {
        for (const ValueEditor *editor : where->findChildren<ValueEditor *>()) {
            if (editor->spec().key == u"pid.roll.p"_s)
                return editor->findChild<QLabel *>()->text();
        }
        return QString();
    };
    QTRY_COMPARE(figure(parameters), u"≙ 90 in the text"_s);
    m_rig->edit(u"pid.roll.p"_s, 0, double(float(m_rig->raw(u"pid.roll.p"_s) * 1.1)));
    QTRY_COMPARE(figure(parameters), u"≙ 99 in the text"_s);
    m_rig->workspace().edits().undo();
    QTRY_COMPARE(figure(m_rig->page<TuningPage>()), u"≙ 90 in the text"_s);
}

// In use is not stored: the text says what the drone starts with.
void TestBcflightText::writtenGainsAreNotStoredYet()
{
    QVERIFY(!m_rig->workspace().isUnstored());
    m_rig->edit(u"pid.yaw.p"_s, 0, double(float(m_rig->raw(u"pid.yaw.p"_s) * 1.1)));
    QVERIFY(write());
    QTRY_VERIFY(m_rig->jobsAreDone());
    QVERIFY(m_rig->workspace().isUnstored());
    auto *bar = window().findChild<UnstoredBar *>();
    QTRY_VERIFY(bar->isVisibleTo(&window()));
    auto *tuning = m_rig->page<TuningPage>();
    QVERIFY(window().showPage(u"tuning"_s));
    QTRY_VERIFY(tuning->stateText().contains(u"not stored"_s));
    const auto done = m_rig->workspace().perform(u"gains.store"_s, {});
    QTRY_VERIFY(done.isFinished());
    QVERIFY(done.result());
    QTRY_VERIFY(held().contains("pid_yaw = PID( 198"));
    QTRY_VERIFY(!m_rig->workspace().isUnstored());
    QTRY_VERIFY(!bar->isVisibleTo(&window()));
    QTRY_COMPARE(tuning->stateText(), u"In use: as in the board's text"_s);
}

// The drone restarts after the text; the gains are in use all the same, and the page knows those of the text.
void TestBcflightText::gainsAndTextAreWrittenInOneGo()
{
    const double roll = double(float(m_rig->raw(u"pid.roll.p"_s) * 1.1));
    const double yaw = m_rig->raw(u"pid.yaw.p"_s);
    m_rig->edit(u"pid.roll.p"_s, 0, roll);
    QByteArray text = held();
    QVERIFY(text.contains("pid_yaw = PID( 180,"));
    text.replace("pid_yaw = PID( 180,", "pid_yaw = PID( 360,");
    m_rig->workspace().edits().editData({0, bcflight::ConfigurationText}, text);
    QVERIFY(write());
    QCOMPARE(m_counted, u"+1 −1 lines"_s);
    QVERIFY2(m_lines.contains(u"− \tpid_yaw = PID( 180,"_s) && m_lines.contains(u"+ \tpid_yaw = PID( 360,"_s),
             qPrintable(m_lines));
    QVERIFY(m_lines.count(u'\n') < 10);  // only what is around it
    // Nobody holds what flies.
    QVERIFY2(m_said.join(u' ').contains(u"propellers off"_s) && !m_said.join(u' ').contains(u"camera"_s),
             qPrintable(m_said.join(u' ')));
    QTRY_VERIFY(m_rig->jobsAreDone());
    QCOMPARE(held(), text);
    QCOMPARE(m_rig->raw(u"pid.roll.p"_s), roll);
    QVERIFY(std::abs(m_rig->raw(u"pid.yaw.p"_s) / yaw - 2) < 0.01);
    // Where the text alone is written, the gains that the drone has started with are known too.
    text.replace("pid_yaw = PID( 360,", "pid_yaw = PID( 180,");
    m_rig->workspace().edits().editData({0, bcflight::ConfigurationText}, text);
    QVERIFY(write());
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(m_rig->raw(u"pid.yaw.p"_s) / yaw - 1) < 0.01, kPatience);
}

QTEST_MAIN(TestBcflightText)
#include "tst_bcflighttext.moc"
