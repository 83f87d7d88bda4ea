// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/simplebgc/calibrationpage.h"
#include "app/mainwindow/navigation.h"
#include "app/mainwindow/translations.h"
#include "app/pages/setup/parameterspage.h"
#include "app/pages/watch/monitorpage.h"
#include "app/pages/watch/streamsdialog.h"
#include "app/workspace/page.h"
#include "tests/support/patience.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/parameterform.h"
#include "widgets/forms/reviewdialog.h"
#include "widgets/forms/valueeditor.h"
#include "widgets/views/armedstate.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAccessible>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRadioButton>
#include <QScrollArea>
#include <QSet>
#include <QStyleOptionComboBox>
#include <QToolButton>

using namespace Qt::StringLiterals;

namespace {

constexpr int kMaxTabs = 400;

QString pathOf(const QWidget *widget)
{
    QStringList parts;
    for (; widget && !widget->isWindow(); widget = widget->parentWidget())
        parts.prepend(QString::fromLatin1(widget->metaObject()->className()) + u'#' + widget->objectName());
    return parts.join(u'/');
}

// A text that does not fit where it is, unless it can be read otherwise.
QString clippedText(const QWidget *widget)
{
    if (const auto *label = qobject_cast<const QLabel *>(widget)) {
        if (label->text().isEmpty() || label->toolTip() == label->text())
            return {};
        if (label->wordWrap())
            return label->heightForWidth(label->width()) > label->height() + 1 ? label->text() : QString();
        return label->minimumSizeHint().width() > label->width() + 1 ? label->text() : QString();
    }
    if (const auto *button = qobject_cast<const QAbstractButton *>(widget)) {
        QString text = button->text();
        text.remove(u'&');
        const int room = button->width() - (qobject_cast<const QCheckBox *>(button) ? 18 : 8);
        return button->fontMetrics().horizontalAdvance(text) > room ? button->text() : QString();
    }
    if (const auto *tile = qobject_cast<const ArmedState *>(widget))
        return tile->shownWord(tile->width()) == tile->word() ? QString() : tile->word();
    if (const auto *box = qobject_cast<const QComboBox *>(widget)) {
        if (box->isEditable() || box->toolTip().contains(box->currentText()))
            return {};
        return box->fontMetrics().horizontalAdvance(box->currentText()) > box->width() - 30
                && !box->currentText().isEmpty()
                && box->sizeAdjustPolicy() != QComboBox::AdjustToMinimumContentsLengthWithIcon
            ? box->currentText()
            : QString();
    }
    return {};
}

// On a small screen the page is scrolled, and so are forms everywhere.
void scrollTo(QWidget &widget)
{
    for (QWidget *at = widget.parentWidget(); at; at = at->parentWidget()) {
        if (auto *area = qobject_cast<QScrollArea *>(at))
            area->ensureWidgetVisible(&widget);
    }
}

// An entry of an open list that cannot be read: cut off, hidden, or without contrast.
QString unreadableEntry(const QComboBox &box)
{
    const QWidget *list = box.view()->viewport();
    const QImage image = box.view()->viewport()->grab().toImage();
    if (box.view()->sizeHintForColumn(0) > list->width())
        return u"%1 px in %2"_s.arg(box.view()->sizeHintForColumn(0)).arg(list->width());
    for (int row = 0; row < box.count(); ++row) {
        const QRect place = box.view()->visualRect(box.model()->index(row, 0));
        if (!list->rect().contains(place)) {
            if (box.count() > box.maxVisibleItems())
                continue;  // scrolled to
            return u"%1 is hidden"_s.arg(box.itemText(row));
        }
        const QColor ground = image.pixelColor(place.right() - 4, place.center().y());
        double contrast = 0.0;
        for (int x = place.left(); x <= place.right(); ++x) {
            for (int y = place.top(); y <= place.bottom(); ++y)
                contrast = std::max(contrast, Theme::contrast(image.pixelColor(x, y), ground));
        }
        if (contrast < 4.5)
            return u"%1 has a contrast of %2"_s.arg(box.itemText(row)).arg(contrast);
    }
    return {};
}

// Each text that is seen fits.
void checkClipping(WindowRig &rig, const QString &where)
{
    QVERIFY(rig.isSettled());
    for (const QWidget *widget : rig.window().findChildren<QWidget *>()) {
        if (!widget->isVisible() || widget->visibleRegion().isEmpty())
            continue;
        // What cannot be scrolled to the side has to fit.
        const auto *area = qobject_cast<const QScrollArea *>(widget);
        if (area && area->horizontalScrollBarPolicy() == Qt::ScrollBarAlwaysOff) {
            QVERIFY2(area->widget()->width() <= area->viewport()->width(),
                     qPrintable(u"%1: %2 px in %3 of %4"_s.arg(where)
                                    .arg(area->widget()->width())
                                    .arg(area->viewport()->width())
                                    .arg(pathOf(area))));
        }
        const QString text = clippedText(widget);
        QVERIFY2(
            text.isEmpty(),
            qPrintable(
                u"%1: \"%2\" has %3 px in %4"_s.arg(where, text).arg(widget->width()).arg(pathOf(widget))));
    }
}

}  // namespace

/// What every page has to be whatever is on it: readable in every language at the smallest size, reachable by
/// the keyboard alone, named for those who do not see it.
class TestLooks : public QObject
{
    Q_OBJECT
private slots:
    void nothingIsClipped_data();
    void nothingIsClipped();
    void nothingIsClippedForADrone_data();
    void nothingIsClippedForADrone();
    void nothingIsClippedWhereTheProgramStarts_data() { addPages(); }
    void nothingIsClippedWhereTheProgramStarts();
    void chosenEntriesCanBeRead_data();
    void chosenEntriesCanBeRead();
    void germanIsGerman();
    void keyboardReachesEverything_data();
    void keyboardReachesEverything();
    void focusIsSeen();
    void choicesAreReadable_data();
    void choicesAreReadable();
    void accessibilityTreeHasNames();

private:
    static void addPages()
    {
        QTest::addColumn<QString>("page");
        for (const PageEntry &entry : pageTable())
            QTest::newRow(entry.key) << QString::fromLatin1(entry.key);
    }
};

void TestLooks::nothingIsClipped_data()
{
    QTest::addColumn<QString>("language");
    QTest::addColumn<QSize>("size");
    const QSize smallest(0, 0);
    for (const QSize size : {smallest, QSize(1280, 800)}) {
        QTest::addRow("English, %d", size.width()) << u"en"_s << size;
        QTest::addRow("German, %d", size.width()) << u"de"_s << size;
    }
}

void TestLooks::nothingIsClipped()
{
    QFETCH(QString, language);
    QFETCH(const QSize, size);
    const Translations translations(language);
    WindowRig rig;
    rig.window().resize(rig.window().minimumSize().expandedTo(size));
    const int width = rig.window().width();
    const auto check = [&rig](const QString &where) { checkClipping(rig, where); };
    check(u"start"_s);
    QVERIFY(rig.open());
    QVERIFY(QTest::qWaitFor([&rig] { return rig.workspace().motorsRunning().has_value(); }, kPatience));
    rig.edit(u"pid.roll.p"_s, 0, 44);
    for (const PageEntry &entry : pageTable()) {
        rig.window().showPage(QLatin1String(entry.key));
        check(QLatin1String(entry.key));
        QVERIFY2(rig.window().width() == width,
                 entry.key);  // no page forces the window wider
        const QWidget *page = rig.window().page(QLatin1String(entry.key));
        QVERIFY2(page->minimumSizeHint().width() <= page->width(),
                 qPrintable(u"%1 needs %2 px of %3"_s.arg(QLatin1String(entry.key))
                                .arg(page->minimumSizeHint().width())
                                .arg(page->width())));
    }
    for (const auto kind : {CalibrationPage::Kind::Gyroscope, CalibrationPage::Kind::Level,
                            CalibrationPage::Kind::SixPositions}) {
        rig.page<CalibrationPage>()->start(kind);
        check(u"calibration wizard"_s);
    }
    rig.page<MonitorPage>()->streamsButton()->click();
    auto *streams = rig.window().findChild<StreamsDialog *>();
    QVERIFY(streams);
    check(u"streams"_s);
    streams->byHand()->click();
    streams->check(u"realtime4"_s)->setChecked(true);
    check(u"streams by hand"_s);
    streams->reject();
    rig.window().review();
    QTRY_VERIFY(rig.window().reviewDialog());
    check(u"review"_s);
    rig.window().reviewDialog()->reject();
}

void TestLooks::nothingIsClippedForADrone_data()
{
    QTest::addColumn<QString>("language");
    QTest::newRow("English") << u"en"_s;
    QTest::newRow("German") << u"de"_s;
}

// Its pages are others, and so is what the common ones show.
void TestLooks::nothingIsClippedForADrone()
{
    QFETCH(QString, language);
    const Translations translations(language);
    WindowRig rig;
    rig.window().resize(1280, 800);
    QVERIFY(rig.open(u"sim:bcflight?notch=1"_s));
    const auto calibrated = rig.workspace().perform(u"calibrate.all"_s, {});
    QTRY_VERIFY_WITH_TIMEOUT(calibrated.isFinished(), kPatience);
    for (const PageEntry &entry : pageTable()) {
        const QString key = QLatin1String(entry.key);
        if (!rig.window().navigation()->isOffered(key))
            continue;
        QVERIFY(rig.window().showPage(key));
        checkClipping(rig, key);
        for (auto *tile : rig.window().page(key)->findChildren<ArmedState *>()) {
            for (int state = 0; state <= int(ArmedState::State::Armed); ++state) {
                tile->setState(ArmedState::State(state));
                QCOMPARE(tile->shownWord(tile->width()), tile->word());
            }
        }
    }
}

// The page that is seen while the board is read fills itself in several steps.
void TestLooks::nothingIsClippedWhereTheProgramStarts()
{
    QFETCH(const QString, page);
    for (const auto &[language, size] : {std::pair(u"de"_s, QSize(1280, 800)), {u"en"_s, QSize(1024, 640)}}) {
        const Translations translations(language);
        WindowRig rig;
        rig.window().resize(size);
        rig.window().navigation()->setCurrentPage(page);
        QVERIFY(rig.open());
        QVERIFY(rig.jobsAreDone());
        checkClipping(rig, page);
    }
}

void TestLooks::chosenEntriesCanBeRead_data()
{
    QTest::addColumn<QString>("language");
    QTest::addColumn<QString>("address");
    for (const char *language : {"en", "de"}) {
        for (const char *address : {"sim:simplebgc", "sim:storm32"})
            QTest::addRow("%s, %s", language, address)
                << QString::fromLatin1(language) << QString::fromLatin1(address);
    }
}

// What a field of the form shows as chosen can be read, in a hint at least where the axes leave no room.
void TestLooks::chosenEntriesCanBeRead()
{
    QFETCH(const QString, language);
    QFETCH(const QString, address);
    const Translations translations(language);
    WindowRig rig;
    rig.window().resize(1280, 800);
    QVERIFY(rig.open(address));
    rig.window().showPage(u"parameters"_s);
    auto *page = rig.page<ParametersPage>();
    QStringList cut;
    for (const ParameterSpec &spec : std::as_const(rig.model()).board().parameters().all()) {
        if (spec.row->kind != ValueKind::Choice)
            continue;
        page->showParameter(spec.key);
        const ValueEditor *editor = page->form()->editor(spec.id);
        const auto *box = editor ? qobject_cast<const QComboBox *>(editor->control()) : nullptr;
        if (!box)
            continue;
        QVERIFY(rig.isSettled());
        QStyleOptionComboBox option;
        option.initFrom(box);
        option.editable = false;
        const int room = box->style()
                             ->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, box)
                             .width();
        const bool isCut = box->fontMetrics().horizontalAdvance(box->currentText()) > room;
        if (isCut && (spec.key.endsWith(u".output"_s) || !box->toolTip().startsWith(box->currentText())))
            cut.append(u"%1: %2"_s.arg(spec.key, box->currentText()));
    }
    QVERIFY2(cut.isEmpty(), qPrintable(cut.join(u'\n')));
}

void TestLooks::germanIsGerman()
{
    const Translations translations(u"de"_s);
    WindowRig rig;
    QVERIFY(rig.open());
    QCOMPARE(rig.window().page(u"tuning"_s)->title(), u"Abstimmen"_s);
    rig.window().showPage(u"tuning"_s);
    // Words of the tables as well, and plurals by number.
    QStringList texts;
    for (const QLabel *label : rig.window().page(u"tuning"_s)->findChildren<QLabel *>())
        texts.append(label->text());
    QVERIFY(texts.contains(u"Stabilisierung"_s));
    rig.edit(u"pid.roll.p"_s, 0, 44);
    const auto unsaved = [&rig] {
        QStringList list;
        for (const QLabel *label : rig.window().findChildren<QLabel *>())
            list.append(label->text());
        return list;
    };
    QTRY_VERIFY(unsaved().contains(u"1 ungeschriebene Änderung"_s));
    rig.edit(u"pid.roll.d"_s, 0, 44);
    QTRY_VERIFY(unsaved().contains(u"2 ungeschriebene Änderungen"_s));
    QVERIFY(describe({ErrorCode::Timeout, {}, 0}).what.contains(u"Board"_s));
    QVERIFY(!describe({ErrorCode::Timeout, {}, 0}).what.contains(u"The "_s));
}

void TestLooks::keyboardReachesEverything_data()
{
    addPages();
}

// Tab goes through everything that takes the focus and comes back to where it began: no trap, nothing left
// out.
void TestLooks::keyboardReachesEverything()
{
    QFETCH(QString, page);
    WindowRig rig;
    QVERIFY(rig.open());
    rig.window().showPage(page);
    QVERIFY(rig.isSettled());
    QVERIFY(QTest::qWaitForWindowActive(&rig.window()));
    rig.window().navigation()->setFocus();
    QSet<QWidget *> visited;
    QWidget *first = QApplication::focusWidget();
    QVERIFY(first);
    for (int i = 0; i < kMaxTabs; ++i) {
        QWidget *focus = QApplication::focusWidget();
        QVERIFY2(focus, "the focus went nowhere");
        visited.insert(focus);
        QTest::keyClick(focus, Qt::Key_Tab);
        QVERIFY2(QApplication::focusWidget() != focus, qPrintable(u"trapped in "_s + pathOf(focus)));
        if (QApplication::focusWidget() == first)
            break;
    }
    QCOMPARE(QApplication::focusWidget(), first);
    for (QWidget *widget : rig.window().findChildren<QWidget *>()) {
        if (!(widget->focusPolicy() & Qt::TabFocus) || !widget->isVisible() || !widget->isEnabled()
            || widget->focusProxy() || widget->objectName().startsWith(u"qt_"_s)
            || qobject_cast<QScrollArea *>(widget))
            continue;
        // The line inside an editable box or a number box is reached with its box.
        bool inside = false;
        for (const QWidget *parent = widget; parent; parent = parent->parentWidget())
            inside |= visited.contains(const_cast<QWidget *>(parent));
        QVERIFY2(inside, qPrintable(u"not reached: "_s + pathOf(widget)));
    }
}

// With the focus a control looks different from without.
void TestLooks::focusIsSeen()
{
    WindowRig rig;
    QVERIFY(rig.open());
    QSet<QString> kinds;
    for (const PageEntry &entry : pageTable()) {
        rig.window().showPage(QLatin1String(entry.key));
        QVERIFY(rig.isSettled());
        QVERIFY(QTest::qWaitForWindowActive(&rig.window()));
        for (QWidget *widget : rig.window().page(QLatin1String(entry.key))->findChildren<QWidget *>()) {
            const QString kind = QString::fromLatin1(widget->metaObject()->className());
            if (!(widget->focusPolicy() & Qt::TabFocus) || !widget->isVisible() || !widget->isEnabled()
                || widget->visibleRegion().isEmpty() || kinds.contains(kind)
                || qobject_cast<QScrollArea *>(widget) || widget->objectName().startsWith(u"qt_"_s))
                continue;
            kinds.insert(kind);
            rig.window().navigation()->setFocus();
            const QImage without = widget->grab().toImage();
            widget->setFocus(Qt::TabFocusReason);
            if (QApplication::focusWidget() != widget)
                continue;  // a box hands it on to its line
            QVERIFY2(widget->grab().toImage() != without, qPrintable(kind + u" in "_s + pathOf(widget)));
        }
    }
    QVERIFY(kinds.size() >= 8);
}

void TestLooks::choicesAreReadable_data()
{
    QTest::addColumn<Theme::Mode>("mode");
    QTest::newRow("light") << Theme::Mode::Light;
    QTest::newRow("dark") << Theme::Mode::Dark;
}

// A list that drops down shows all of its entries, the chosen one too.
void TestLooks::choicesAreReadable()
{
    QFETCH(Theme::Mode, mode);
    WindowRig rig;
    rig.theme().setMode(mode);
    rig.theme().apply();
    QVERIFY(rig.open());
    int seen = 0;
    for (const PageEntry &entry : pageTable()) {
        rig.window().showPage(QLatin1String(entry.key));
        QVERIFY(rig.isSettled());
        for (QComboBox *box : rig.window().findChildren<QComboBox *>()) {
            scrollTo(*box);
            if (!box->isVisible() || !box->isEnabled() || box->visibleRegion().isEmpty() || box->count() == 0)
                continue;
            ++seen;
            box->showPopup();
            QTRY_VERIFY(box->view()->isVisible());
            const QString wrong = unreadableEntry(*box);
            QVERIFY2(wrong.isEmpty(),
                     qPrintable(u"%1, %2: %3"_s.arg(QLatin1String(entry.key), pathOf(box), wrong)));
            box->hidePopup();
        }
    }
    QVERIFY(seen > 20);
}

void TestLooks::accessibilityTreeHasNames()
{
    WindowRig rig;
    QVERIFY(rig.open());
    int seen = 0;
    for (const PageEntry &entry : pageTable()) {
        rig.window().showPage(QLatin1String(entry.key));
        QVERIFY(rig.isSettled());
        QList<QAccessibleInterface *> queue{QAccessible::queryAccessibleInterface(&rig.window())};
        while (!queue.isEmpty()) {
            QAccessibleInterface *item = queue.takeFirst();
            if (!item || !item->isValid())
                continue;
            const QAccessible::State state = item->state();
            const auto role = item->role();
            const bool isControl = role == QAccessible::Button || role == QAccessible::CheckBox
                || role == QAccessible::ComboBox || role == QAccessible::EditableText
                || role == QAccessible::SpinBox || role == QAccessible::Slider || role == QAccessible::List
                || role == QAccessible::Table || role == QAccessible::Tree;
            if (isControl && !state.invisible && state.focusable) {
                ++seen;
                const auto *widget = qobject_cast<QWidget *>(item->object());
                const bool inner = widget && widget->objectName().startsWith(u"qt_"_s);
                // The line of a box takes its name from the box.
                const QAccessibleInterface *parent = item->parent();
                const QString name = item->text(QAccessible::Name)
                    + (parent
                               && (parent->role() == QAccessible::ComboBox
                                   || parent->role() == QAccessible::SpinBox)
                           ? parent->text(QAccessible::Name)
                           : QString());
                QVERIFY2(inner || !name.isEmpty(),
                         qPrintable(u"%1, role %2, in %3"_s.arg(QLatin1String(entry.key))
                                        .arg(int(role))
                                        .arg(widget ? pathOf(widget) : QString())));
            }
            // Rows of tables are many; their names are their texts.
            if (role == QAccessible::Table || role == QAccessible::Tree || role == QAccessible::List)
                continue;
            for (int i = 0; i < item->childCount(); ++i)
                queue.append(item->child(i));
        }
    }
    QVERIFY(seen > 60);
}

QTEST_MAIN(TestLooks)
#include "tst_looks.moc"
