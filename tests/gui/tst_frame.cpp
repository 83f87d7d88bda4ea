// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/bars.h"
#include "app/mainwindow/linkbar.h"
#include "app/mainwindow/messagebar.h"
#include "app/mainwindow/startpage.h"
#include "app/mainwindow/translations.h"
#include "tests/support/patience.h"
#include "tests/support/simprocess.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/panel.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QCursor>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QToolButton>

using namespace Qt::StringLiterals;

namespace {

const QString kDemo = u"sim:simplebgc"_s;

/// Where everything that can be clicked is, in coordinates of the window.
QMap<QString, QRect> places(MainWindow &window)
{
    QMap<QString, QRect> found;
    for (const QWidget *widget : window.findChildren<QWidget *>()) {
        const bool isControl = qobject_cast<const QAbstractButton *>(widget)
            || qobject_cast<const QComboBox *>(widget) || qobject_cast<const QAbstractSpinBox *>(widget)
            || qobject_cast<const QAbstractSlider *>(widget) || qobject_cast<const QLineEdit *>(widget)
            || qobject_cast<const QAbstractItemView *>(widget);
        bool isBar = false;
        for (const QWidget *at = widget; at; at = at->parentWidget()) {
            isBar |= at == window.messageBar() || at == window.offerBar() || at == window.unsavedBar()
                || qobject_cast<const UnstoredBar *>(at);
        }
        if (!isControl || isBar || !widget->isVisible() || widget->visibleRegion().isEmpty())
            continue;
        const QRect place(widget->mapTo(&window, QPoint()), widget->size());
        found.insert(
            u"%1 %2 %3"_s.arg(QLatin1String(widget->metaObject()->className()), widget->accessibleName())
                .arg(quintptr(widget), 0, 16),
            place);
    }
    return found;
}

QString difference(const QMap<QString, QRect> &before, const QMap<QString, QRect> &after)
{
    for (auto it = before.begin(); it != before.end(); ++it) {
        if (!after.contains(it.key()))
            continue;  // hidden: it is under nobody's pointer
        const QRect now = after[it.key()];
        if (now != it.value())
            return u"%1 moved from %2,%3 %4x%5 to %6,%7 %8x%9"_s.arg(it.key())
                .arg(it->x())
                .arg(it->y())
                .arg(it->width())
                .arg(it->height())
                .arg(now.x())
                .arg(now.y())
                .arg(now.width())
                .arg(now.height());
    }
    return {};
}

}  // namespace

/// The frame around the pages: nothing in it moves what the operator is about to press, and it says what is
/// being looked at.
class TestFrame : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_rig = std::make_unique<WindowRig>(); }
    void cleanup() { m_rig.reset(); }
    void nothingMoves_data();
    void nothingMoves();
    void barsFitSideBySide();
    void bannersLeaveAloneWhatIsUsed();
    void bannersCloseWithoutTheMouse();
    void bannersDoNotSlideUnderThePointer();
    void questionsFold();
    void startingTheMotorsAsks();
    void switchingTheProfileAsks();
    void motorsButtonSaysWhatItDoes();
    void motorsButtonNeverGives();
    void badgeSaysWhatIsLookedAt();
    void recordingIsMarked();
    void boardThatCannotBeWrittenIsMarked();
    void lastAddressIsOffered();
    void latelyOpenedIsOffered();
    void valuesInUseAskBeforeQuitting();
    void problemsGoWithTheirCause();
    void readingProblemGoesWithAGoodRead();

private:
    MainWindow &window() { return m_rig->window(); }
    Workspace &workspace() { return m_rig->workspace(); }
    LinkBar *bar() { return window().findChild<LinkBar *>(); }
    QPushButton *motors() { return window().findChild<QPushButton *>(u"motors"_s); }
    /// The one that is open; null if there is none.
    QMessageBox *question()
    {
        for (QMessageBox *box : window().panels()->findChildren<QMessageBox *>()) {
            if (box->isVisible())
                return box;
        }
        return nullptr;
    }
    bool motorsAre(bool running)
    {
        return QTest::qWaitFor([&] { return workspace().motorsRunning() == running; }, kPatience);
    }
    bool canStart() { return motors()->isEnabled() && motors()->text().startsWith(u'▶'); }
    bool answer(const QString &text)
    {
        if (!question())
            return false;
        for (QAbstractButton *button : question()->buttons()) {
            if (button->text().remove(u'&') == text) {
                button->click();
                return true;
            }
        }
        return false;
    }
    /// What the badges in the frame say, those that are seen.
    QStringList badges()
    {
        QStringList texts;
        for (const QLabel *badge : bar()->findChildren<QLabel *>(u"badge"_s)) {
            if (badge->isVisible() && badge->visibleRegion().boundingRect().size() == badge->size())
                texts.append(badge->text());
        }
        return texts;
    }

    std::unique_ptr<WindowRig> m_rig;
};

void TestFrame::nothingMoves_data()
{
    QTest::addColumn<QString>("page");
    QTest::addColumn<QSize>("size");
    for (const char *page : {"dashboard", "parameters", "tuning", "monitor", "settings", "actions"}) {
        QTest::addRow("%s, small", page) << QString::fromLatin1(page) << QSize(1024, 640);
        QTest::addRow("%s, large", page) << QString::fromLatin1(page) << QSize(1280, 800);
    }
}

void TestFrame::nothingMoves()
{
    QFETCH(QString, page);
    QFETCH(QSize, size);
    window().resize(size);
    QVERIFY(m_rig->open(kDemo));
    QVERIFY(motorsAre(true));
    QVERIFY(m_rig->jobsAreDone());
    QVERIFY(window().showPage(page));
    window().messageBar()->hide();
    window().offerBar()->clear();
    QVERIFY(m_rig->isSettled());
    QVERIFY(!places(window()).isEmpty());
    const auto moved = [this](const auto &happens) {
        const auto before = places(window());
        happens();
        if (!m_rig->isSettled())
            return u"it does not settle"_s;
        return difference(before, places(window()));
    };
    Notifications &told = workspace().notifications();
    QString wrong = moved([&] {
        told.report(ErrorText{u"What"_s, u"Meaning. "_s.repeated(40), u"Cure."_s, u"Detail."_s});
        QVERIFY(window().messageBar()->isVisible());
    });
    QVERIFY2(wrong.isEmpty(), qPrintable(u"problem: "_s + wrong));
    wrong = moved([&] { told.notify(u"Done."_s); });
    QVERIFY2(wrong.isEmpty(), qPrintable(u"notice: "_s + wrong));
    wrong = moved([&] {
        told.ask({u"Which?"_s, {{u"This"_s, [] {}}, {u"That"_s, [] {}}}});
        QVERIFY(window().offerBar()->isVisible());
    });
    QVERIFY2(wrong.isEmpty(), qPrintable(u"question: "_s + wrong));
    wrong = moved([&] { window().messageBar()->hide(); });
    QVERIFY2(wrong.isEmpty(), qPrintable(u"closed: "_s + wrong));
    wrong = moved([&] {
        // A parameter of no page: what a changed field does is its own business.
        m_rig->edit(u"battery.alarm"_s, 0, 1100);
        QVERIFY(window().unsavedBar()->isVisible());
    });
    QVERIFY2(wrong.isEmpty(), qPrintable(u"unsaved: "_s + wrong));
    // How a slider of that page marks its own change is its own business.
    const bool isLive = page == u"tuning"_s;
    wrong = isLive ? QString() : moved([&] {
        LiveModel &live = workspace().live();
        const int id = m_rig->spec(u"pid.yaw.p"_s).id;
        live.read();
        QTRY_VERIFY(live.value(id));
        live.setValue(id, *live.value(id) + 1);
        QTRY_VERIFY(window().findChild<UnstoredBar *>()->isVisible());
    });
    QVERIFY2(wrong.isEmpty(), qPrintable(u"in use: "_s + wrong));
    wrong = moved([&] { workspace().edits().discardAll(); });
    QVERIFY2(wrong.isEmpty(), qPrintable(u"discarded: "_s + wrong));
    wrong = moved([&] {
        workspace().setMotors(false);
        QVERIFY(motorsAre(false));
        QTRY_VERIFY(!motors()->property("running").toBool());
    });
    QVERIFY2(wrong.isEmpty(), qPrintable(u"motors off: "_s + wrong));
}

void TestFrame::barsFitSideBySide()
{
    const Translations german(u"de"_s);
    m_rig = std::make_unique<WindowRig>();
    window().resize(window().minimumSize());
    QVERIFY(m_rig->open(kDemo));
    m_rig->edit(u"battery.alarm"_s, 0, 1100);
    m_rig->edit(u"pid.roll.p"_s, 1, 44);
    LiveModel &live = workspace().live();
    const int id = m_rig->spec(u"pid.yaw.p"_s).id;
    live.read();
    QTRY_VERIFY(live.value(id));
    live.setValue(id, *live.value(id) + 1);
    auto *unstored = window().findChild<UnstoredBar *>();
    QTRY_VERIFY(unstored->isVisible() && window().unsavedBar()->isVisible());
    QVERIFY(m_rig->isSettled());
    for (const QWidget *bar : std::initializer_list<QWidget *>{unstored, window().unsavedBar()}) {
        for (QAbstractButton *button : bar->findChildren<QAbstractButton *>()) {
            QVERIFY2(!button->isVisible() || bar->rect().contains(button->geometry()),
                     qPrintable(u"%1 ends at %2 of %3"_s.arg(button->text())
                                    .arg(button->geometry().right())
                                    .arg(bar->width())));
            QVERIFY2(!button->isVisible() || button->width() >= button->sizeHint().width(),
                     qPrintable(u"%1 has %2 of %3 px"_s.arg(button->text())
                                    .arg(button->width())
                                    .arg(button->sizeHint().width())));
        }
    }
    QVERIFY(!unstored->geometry().intersects(window().unsavedBar()->geometry()));
}

// At the lower edge where pointer or keyboard are at the upper one.
void TestFrame::bannersLeaveAloneWhatIsUsed()
{
    QVERIFY(m_rig->open(kDemo));
    QVERIFY(m_rig->jobsAreDone());
    QVERIFY(window().showPage(u"parameters"_s));
    window().messageBar()->hide();
    window().offerBar()->clear();
    QVERIFY(m_rig->isSettled());
    QVERIFY(QTest::qWaitForWindowActive(&window()));
    Page *page = window().page(u"parameters"_s);
    auto *search = page->findChild<QLineEdit *>();
    const auto placeOf
        = [this](QWidget *widget) { return QRect(widget->mapTo(&window(), QPoint()), widget->size()); };
    Notifications &told = workspace().notifications();
    QCursor::setPos(window().mapToGlobal(QPoint(40, 400)));
    window().navigation()->setFocus();
    QVERIFY(window().showPage(u"help"_s));
    told.notify(u"Upper."_s);
    QVERIFY(placeOf(window().messageBar()).bottom() < window().height() / 2);
    window().messageBar()->hide();
    // Where the page has headings it goes out of their way.
    QVERIFY(window().showPage(u"parameters"_s));
    QVERIFY(m_rig->isSettled());
    told.notify(u"Lower."_s);
    QVERIFY(placeOf(window().messageBar()).top() > window().height() / 2);
    // Title and controls of the page stay in sight.
    for (QWidget *widget : page->findChildren<QWidget *>(Qt::FindDirectChildrenOnly)) {
        const bool isHead = widget->objectName() == u"title"_s || widget->objectName() == u"chip"_s;
        QVERIFY2(!isHead || !placeOf(window().messageBar()).intersects(placeOf(widget)),
                 qPrintable(widget->objectName()));
    }
    // A field that gets the keyboard later is not hidden either.
    search->setFocus();
    QVERIFY(!placeOf(window().messageBar()).intersects(placeOf(search)));
    window().messageBar()->hide();
    told.notify(u"Another."_s);
    QVERIFY(!placeOf(window().messageBar()).intersects(placeOf(search)));
    window().messageBar()->hide();
    window().navigation()->setFocus();
    QCursor::setPos(search->mapToGlobal(search->rect().center()));
    told.ask({u"Which?"_s, {{u"This"_s, [] {}}}});
    QVERIFY(!placeOf(window().offerBar()).intersects(placeOf(search)));
}

void TestFrame::bannersCloseWithoutTheMouse()
{
    QVERIFY(m_rig->open(kDemo));
    QVERIFY(window().showPage(u"parameters"_s));
    QVERIFY(m_rig->isSettled());
    QVERIFY(QTest::qWaitForWindowActive(&window()));
    QWidget *field = window().page(u"parameters"_s)->findChild<QWidget *>(u"pid.roll.p"_s);
    QVERIFY(field);
    field->setFocus();
    workspace().notifications().notify(u"Esc closes it from the page."_s, Notice::Attention);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    QVERIFY(!window().messageBar()->isVisible());
    workspace().notifications().notify(u"Ctrl+F6 leads there."_s, Notice::Attention);
    QTest::keyClick(&window(), Qt::Key_F6, Qt::ControlModifier);
    QVERIFY(window().messageBar()->isAncestorOf(QApplication::focusWidget()));
    QTest::keyClick(&window(), Qt::Key_F6, Qt::ControlModifier);
    QCOMPARE(QApplication::focusWidget(), field);
    QTest::keyClick(&window(), Qt::Key_F6, Qt::ControlModifier);
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
    QVERIFY(!window().messageBar()->isVisible());
    QCOMPARE(QApplication::focusWidget(), field);
}

// A second click in a hurry finds nothing new.
void TestFrame::bannersDoNotSlideUnderThePointer()
{
    Notifications &told = workspace().notifications();
    told.notify(u"First."_s, Notice::Attention);
    told.ask({u"Which?"_s, {{u"This"_s, [] {}}}});
    QVERIFY(m_rig->isSettled());
    const QRect message = window().messageBar()->geometry();
    const QRect offer = window().offerBar()->geometry();
    QVERIFY(!message.intersects(offer));
    window().messageBar()->hide();
    QVERIFY(m_rig->isSettled());
    QCOMPARE(window().offerBar()->geometry(), offer);
    told.notify(u"Another."_s, Notice::Attention);
    QVERIFY(m_rig->isSettled());
    QCOMPARE(window().offerBar()->geometry(), offer);
    QVERIFY(!window().messageBar()->geometry().intersects(offer));
}

void TestFrame::questionsFold()
{
    bool chosen = false;
    workspace().notifications().ask({u"Which?"_s, {{u"This"_s, [&chosen] { chosen = true; }}}});
    QVERIFY(m_rig->isSettled());
    const int wide = window().offerBar()->width();
    auto *fold = window().offerBar()->findChild<QToolButton *>();
    QTest::mouseClick(fold, Qt::LeftButton);
    QVERIFY(m_rig->isSettled());
    QVERIFY(window().offerBar()->isVisible());
    QVERIFY2(window().offerBar()->width() < wide / 3,
             qPrintable(u"%1 of %2 px"_s.arg(window().offerBar()->width()).arg(wide)));
    QVERIFY2(fold->text().contains(u"1 open question"_s), qPrintable(fold->text()));
    QVERIFY(!window().offerBar()->buttons().first()->isVisible());
    QTest::mouseClick(fold, Qt::LeftButton);
    QVERIFY(m_rig->isSettled());
    QCOMPARE(window().offerBar()->width(), wide);
    QTest::mouseClick(window().offerBar()->buttons().first(), Qt::LeftButton);
    QVERIFY(chosen && !window().offerBar()->isVisible());
}

void TestFrame::startingTheMotorsAsks()
{
    QVERIFY(m_rig->open(kDemo));
    QVERIFY(motorsAre(true));
    QTRY_VERIFY(motors()->property("running").toBool());
    QTest::mouseClick(motors(), Qt::LeftButton);
    QVERIFY(!window().panels()->isOpen());  // a stop never asks
    QVERIFY(motorsAre(false));
    QTRY_VERIFY(canStart());
    QTest::mouseClick(motors(), Qt::LeftButton);
    QVERIFY(question());
    QVERIFY(m_rig->boardGoesOn(1.0));
    QCOMPARE(workspace().motorsRunning(), false);
    QTRY_VERIFY(!motors()->isEnabled());  // beneath the question it starts nothing
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);  // which stays
    QTRY_VERIFY(!window().panels()->isOpen());
    QVERIFY(m_rig->boardGoesOn(1.0));
    QCOMPARE(workspace().motorsRunning(), false);
    QTRY_VERIFY(canStart());
    QTest::mouseClick(motors(), Qt::LeftButton);
    QVERIFY(answer(u"Start motors"_s));
    QVERIFY(motorsAre(true));
    QTRY_VERIFY(motors()->text().startsWith(u'■'));
    // What was asked belongs to this link.
    QTest::mouseClick(motors(), Qt::LeftButton);
    QVERIFY(motorsAre(false));
    QTRY_VERIFY(canStart());
    QTest::mouseClick(motors(), Qt::LeftButton);
    QVERIFY(question());
    m_rig->client().disconnectFromBoard();
    QTRY_VERIFY(!window().panels()->isOpen());
}

void TestFrame::switchingTheProfileAsks()
{
    QVERIFY(m_rig->open(kDemo));
    QVERIFY(motorsAre(true));
    QComboBox *box = nullptr;
    for (QComboBox *each : bar()->findChildren<QComboBox *>()) {
        if (each->accessibleName() == u"Active profile"_s)
            box = each;
    }
    QVERIFY(box);
    const auto active = [this] { return std::as_const(m_rig->model()).board().activeProfile(); };
    const auto choose = [box] { QTest::keyClick(box, Qt::Key_Down); };
    choose();
    QVERIFY(question());
    question()->reject();
    QTRY_COMPARE(box->currentIndex(), 0);
    QVERIFY(m_rig->jobsAreDone());
    QCOMPARE(active(), 0);
    choose();
    QVERIFY(answer(u"Switch profile"_s));
    QTRY_COMPARE(active(), 1);
    QCOMPARE(box->currentIndex(), 1);
    workspace().setMotors(false);
    QVERIFY(motorsAre(false));
    choose();
    QVERIFY(!window().panels()->isOpen());
    QTRY_COMPARE(active(), 2);
}

// In words that are no states.
void TestFrame::motorsButtonSaysWhatItDoes()
{
    QVERIFY(m_rig->open(kDemo));
    QVERIFY(motorsAre(true));
    QTRY_COMPARE(motors()->text(), u"■ STOP MOTORS"_s);
    workspace().setMotors(false);
    QTRY_COMPARE(motors()->text(), u"▶ Start motors"_s);
}

void TestFrame::motorsButtonNeverGives()
{
    QVERIFY(m_rig->open(kDemo));
    QVERIFY(motorsAre(true));
    for (const int width : {1024, 800, 683, 512, 420}) {
        window().setMinimumSize(200, 200);
        window().resize(width, 400);
        QVERIFY(m_rig->isSettled());
        QCOMPARE(window().width(), width);
        const QRect place(motors()->mapTo(&window(), QPoint()), motors()->size());
        QVERIFY2(window().rect().contains(place), qPrintable(QString::number(width)));
        QVERIFY2(motors()->visibleRegion().boundingRect() == motors()->rect(),
                 qPrintable(QString::number(width)));
        QVERIFY(motors()->width() >= motors()->sizeHint().width());
        // What is left beside it lies beside it.
        for (QWidget *other : std::initializer_list<QWidget *>{bar()->connectButton(), bar()->addressBox()}) {
            const QRect beside(other->mapTo(&window(), QPoint()), other->size());
            QVERIFY2(!other->isVisible() || !beside.intersects(place), qPrintable(QString::number(width)));
        }
        const QStringList told = badges();
        QVERIFY2(told.contains(u"SIMULATED"_s), qPrintable(QString::number(width)));
    }
}

void TestFrame::badgeSaysWhatIsLookedAt()
{
    QVERIFY(badges().isEmpty());
    QVERIFY(m_rig->open(kDemo));
    for (const PageEntry &entry : pageTable()) {
        window().showPage(QLatin1String(entry.key));
        QCOMPARE(badges(), QStringList{u"SIMULATED"_s});
    }
    // A simulated board stays one while its link is down.
    workspace().changeWorld(u"unplug=0"_s);
    QTRY_COMPARE(m_rig->client().state(), DeviceClient::State::Reconnecting);
    QCOMPARE(badges(), QStringList{u"SIMULATED"_s});
    m_rig->client().disconnectFromBoard();
    QTRY_COMPARE(badges(), QStringList{u"OFFLINE"_s});
    const QString file = m_rig->filePath(u"saved.json"_s);
    QVERIFY(workspace().saveFile(file));
    m_rig->restart();
    window().openFile(file);
    QCOMPARE(badges(), QStringList{u"OFFLINE"_s});
    const QLabel *badge = bar()->findChild<QLabel *>(u"badge"_s);
    QVERIFY(badge->toolTip().contains(file) && badge->accessibleName().contains(file));
    QVERIFY(bar()->property("marked").toBool());
}

void TestFrame::recordingIsMarked()
{
    QVERIFY(m_rig->open(kDemo));
    const QString path = m_rig->filePath(u"link.gimbalrec"_s);
    QVERIFY(workspace().recorder().start(path));
    QTRY_COMPARE(badges(), (QStringList{u"SIMULATED"_s, u"● REC"_s}));
    QVERIFY(m_rig->boardGoesOn(0.5));
    QSignalSpy finished(&workspace().recorder(), &LinkRecorder::finished);
    workspace().recorder().stop();
    QTRY_COMPARE(finished.count(), 1);
    QCOMPARE(badges(), QStringList{u"SIMULATED"_s});
    m_rig->client().disconnectFromBoard();
    QTRY_COMPARE(m_rig->client().state(), DeviceClient::State::Disconnected);
    window().openFile(path);
    QTRY_VERIFY(m_rig->client().isConnected());
    QCOMPARE(badges(), QStringList{u"REPLAY"_s});
}

void TestFrame::boardThatCannotBeWrittenIsMarked()
{
    SimProcess board({u"--tcp"_s, u"0"_s, u"--fault"_s, u"unknown-firmware=1"_s});
    QVERIFY(m_rig->open(board.address()));
    QVERIFY(!m_rig->client().identity().writable);
    QCOMPARE(badges(), QStringList{u"READ ONLY"_s});
    m_rig->client().disconnectFromBoard();
    QTRY_COMPARE(badges(), QStringList{u"OFFLINE"_s});
    QCOMPARE(board.stop(), 0);
    SimProcess other({u"--tcp"_s, u"0"_s});
    QVERIFY(m_rig->open(other.address()));
    QVERIFY(badges().isEmpty());  // a real link to a board like any
    QVERIFY(!bar()->property("marked").toBool());
}

void TestFrame::lastAddressIsOffered()
{
    const auto shown = [this] { return bar()->addressBox()->currentText(); };
    // Nobody asked for a simulated board.
    QVERIFY2(!shown().contains(u"Simulated"_s), qPrintable(shown()));
    QVERIFY(m_rig->open(kDemo));
    m_rig->restart();
    QVERIFY2(!shown().contains(u"Simulated"_s), qPrintable(shown()));
    SimProcess board({u"--tcp"_s, u"0"_s});
    const QString address = board.address();
    QVERIFY(m_rig->open(address));
    m_rig->client().disconnectFromBoard();
    QTRY_COMPARE(m_rig->client().state(), DeviceClient::State::Disconnected);
    QVERIFY(m_rig->open(kDemo));
    m_rig->restart();
    QCOMPARE(shown(), address);
    // The list of ports comes a moment later, and changes nothing of that.
    QTRY_VERIFY(bar()->addressBox()->findData(u"sim:simplebgc"_s) > 0);
    QCOMPARE(shown(), address);
    QPushButton *lately = nullptr;
    for (QPushButton *button : window().findChild<StartPage *>()->findChildren<QPushButton *>()) {
        if (button->toolTip() == address)
            lately = button;
    }
    QVERIFY(lately && lately->isVisible());
    lately->click();
    QTRY_VERIFY(m_rig->client().isConnected());
}

void TestFrame::latelyOpenedIsOffered()
{
    QVERIFY(m_rig->open(kDemo));
    const QString file = m_rig->filePath(u"saved.json"_s);
    QVERIFY(workspace().saveFile(file));
    m_rig->restart();
    window().openFile(m_rig->filePath(u"none.json"_s));
    window().openFile(file);
    m_rig->restart();
    QCOMPARE(m_rig->settings().recentFiles(), QStringList{file});
    for (QPushButton *button : window().findChild<StartPage *>()->findChildren<QPushButton *>()) {
        if (button->toolTip() == file)
            button->click();
    }
    QCOMPARE(workspace().offlineFile(), file);
}

void TestFrame::valuesInUseAskBeforeQuitting()
{
    QVERIFY(m_rig->open(kDemo));
    LiveModel &live = workspace().live();
    const int id = m_rig->spec(u"pid.yaw.p"_s).id;
    QTRY_VERIFY(!live.parameters().isEmpty());
    live.read();
    QTRY_VERIFY(live.value(id));
    live.setValue(id, *live.value(id) + 1);
    QTRY_COMPARE(live.changeCount(), 1);
    QVERIFY(!workspace().isUnstored());
    window().close();
    QVERIFY(window().isVisible());
    QVERIFY(question());
    question()->reject();
    QVERIFY(window().isVisible());
}

void TestFrame::problemsGoWithTheirCause()
{
    Notifications &told = workspace().notifications();
    const auto shown = [this] { return window().messageBar()->isVisible(); };
    for (const Concern concern : {Concern::Link, Concern::Reading, Concern::LiveData, Concern::Motors}) {
        told.report(ErrorText{u"What"_s, {}, {}, {}}, concern);
        QVERIFY(shown());
        told.settle(concern == Concern::Link ? Concern::Reading : Concern::Link);
        QVERIFY(shown());
        told.settle(concern);
        QVERIFY(!shown());
    }
    // What is told since is not taken away with it.
    told.report(ErrorText{u"Old"_s, {}, {}, {}}, Concern::Reading);
    told.report(ErrorText{u"New"_s, {}, {}, {}});
    told.settle(Concern::Reading);
    QVERIFY(shown());
    QCOMPARE(window().messageBar()->text(), u"New"_s);
    window().messageBar()->hide();
    // Motors of which nobody knew are off after all.
    QVERIFY(m_rig->open(kDemo));
    QVERIFY(motorsAre(true));
    told.reportMotorsMayRun(u"Nobody knows."_s);
    QVERIFY(window().messageBar()->text().contains(u"Hold the camera"_s));
    workspace().setMotors(false);
    QTRY_VERIFY(!window().messageBar()->text().contains(u"Nobody knows"_s));
}

void TestFrame::readingProblemGoesWithAGoodRead()
{
    const auto told
        = [this] { return window().messageBar()->isVisible() ? window().messageBar()->text() : QString(); };
    QVERIFY(m_rig->open(kDemo + u"?fault=deaf%3D62"_s));  // READ_PARAMS_EXT2
    QTRY_VERIFY(told().contains(u"PARAMS_EXT2"_s));
    workspace().changeWorld(u"deaf=-1"_s);
    QSignalSpy read(&workspace(), &Workspace::boardRead);
    workspace().readBoard();
    QTRY_COMPARE(read.count(), 1);
    QCOMPARE(told(), QString());
    // And with the link.
    workspace().changeWorld(u"deaf=62"_s);
    workspace().readBoard();
    QTRY_VERIFY(told().contains(u"PARAMS_EXT2"_s));
    m_rig->client().disconnectFromBoard();
    QTRY_COMPARE(told(), QString());
}

QTEST_MAIN(TestFrame)
#include "tst_frame.moc"
