// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/program/settingspage.h"
#include "app/pages/setup/parameterspage.h"
#include "tests/support/patience.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/argumentform.h"
#include "widgets/forms/latebutton.h"
#include "widgets/forms/numberbox.h"
#include "widgets/forms/parameterform.h"
#include "widgets/forms/valueeditor.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"

#include <QClipboard>
#include <QLineEdit>
#include <QSignalSpy>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr double kNothing = -12345.0;  // what is typed is no value

/// Types over what stands in a field and leaves it by Tab.
void typeInto(QWidget *field, const QString &text)
{
    field->setFocus(Qt::TabFocusReason);
    QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
    if (text.isEmpty()) {
        QTest::keyClick(field, Qt::Key_Delete);
    } else if (std::any_of(text.begin(), text.end(), [](QChar c) { return c.unicode() > 0x7F; })) {
        QGuiApplication::clipboard()->setText(text);
        QTest::keyClick(field, Qt::Key_V, Qt::ControlModifier);
    } else {
        QTest::keyClicks(field, text);
    }
    QTest::keyClick(field, Qt::Key_Tab);
}

QToolButton *hintIn(const QWidget &window)
{
    return window.findChild<QToolButton *>(u"hint"_s);
}

}  // namespace

/// What is typed into a field for a number is taken as it is meant or not at all, and never changed unsaid.
class TestNumberBox : public QObject
{
    Q_OBJECT
private slots:
    void typed_data();
    void typed();
    void enterAndEscape();
    void anEmptyFieldStaysEmpty();
    void parametersKeepWhatWasTyped();
    void actionsRefuseWhatTheyWereNotTold();
    void settingsTakeWhatIsFinished();
    void aRefusedTextStaysWhateverHappensAround();
    void argumentsMayBeLeftOut();
    void countsAndSteps_data();
    void countsAndSteps();
};

void TestNumberBox::typed_data()
{
    QTest::addColumn<double>("low");
    QTest::addColumn<double>("high");
    QTest::addColumn<int>("decimals");
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("value");  // kNothing: it is refused
    QTest::addColumn<QString>("nearest");  // then: what is offered
    const auto row = [](const char *name, double low, double high, int decimals, const QString &text,
                        double value, const QString &nearest = {}) {
        QTest::newRow(name) << low << high << decimals << text << value << nearest;
    };
    row("whole", 0, 255, 0, u"35"_s, 35);
    row("point", 0, 2.55, 2, u"0.2"_s, 0.2);
    row("comma", 0, 2.55, 2, u"0,2"_s, 0.2);
    row("comma first", 0, 2.55, 2, u",25"_s, 0.25);
    row("comma last", 0, 10, 2, u"3,"_s, 3);
    row("negative", -10, 10, 1, u"-2,5"_s, -2.5);
    row("minus sign", -10, 10, 1, u"\u22122.5"_s, -2.5);
    row("plus sign", -10, 10, 1, u"+2.5"_s, 2.5);
    row("with its unit", 0, 90, 1, u"12,5 °"_s, 12.5);
    row("unit without space", 0, 90, 1, u"12,5°"_s, 12.5);
    row("the bounds belong", 0, 255, 0, u"255"_s, 255);
    row("too large", 0, 255, 0, u"300"_s, kNothing, u"255"_s);
    row("far too large", 0, 99, 0, u"99999"_s, kNothing, u"99"_s);
    row("too small", 2, 40, 0, u"1"_s, kNothing, u"2"_s);
    row("too large with decimals", 0, 2.55, 2, u"3"_s, kNothing, u"2.55"_s);
    row("decimals in whole numbers", 0, 255, 0, u"35.6"_s, kNothing, u"36"_s);
    row("more decimals", 0, 10, 2, u"1,239"_s, kNothing, u"1.24"_s);
    row("grouped, English", 0, 9999, 1, u"1,000.5"_s, kNothing);
    row("grouped, German", 0, 9999, 1, u"1.000,5"_s, kNothing);
    row("grouped by a space", 0, 9999, 0, u"1 000"_s, kNothing);
    row("whole, could be grouped", 0, 9999, 0, u"1.000"_s, kNothing, u"1000"_s);
    row("whole, could be grouped by a comma", 0, 9999, 0, u"1,000"_s, kNothing, u"1000"_s);
    row("whole, and no such group", 0, 255, 0, u"1.000"_s, kNothing, u"1"_s);
    row("whole, with a decimal", 0, 255, 0, u"35.0"_s, kNothing, u"35"_s);
    row("whole, with a mark", 0, 255, 0, u"35."_s, 35);
    row("could be grouped", 0, 99999, 1, u"12.500"_s, kNothing, u"12500"_s);
    row("could be grouped, but is too large then", 0, 2.55, 2, u"1,000"_s, kNothing, u"1"_s);
    row("no group begins with a nought", 0, 10, 2, u"0,500"_s, 0.5);
    row("no group is that long", 0, 99999, 2, u"1000,000"_s, 1000);
    row("three decimals are wanted", 0, 10, 3, u"1.000"_s, 1);
    row("word", 0, 255, 0, u"all"_s, kNothing);
    row("exponent", 0, 255, 0, u"1e2"_s, kNothing);
    row("not a number", 0, 255, 0, u"nan"_s, kNothing);
    row("infinite", 0, 255, 0, u"inf"_s, kNothing);
    row("nothing", 0, 255, 0, QString(), kNothing);
}

void TestNumberBox::typed()
{
    QFETCH(const double, low);
    QFETCH(const double, high);
    QFETCH(const int, decimals);
    QFETCH(const QString, text);
    QFETCH(const double, value);
    QFETCH(const QString, nearest);
    QWidget window;
    auto *box = new NumberBox(low, high, decimals, u" °"_s);
    auto *layout = new QVBoxLayout(&window);
    layout->addWidget(box);
    layout->addWidget(new QLineEdit);
    window.resize(600, 200);
    window.show();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    const double before = low + 1;
    box->setValue(before);
    const QSignalSpy changes(box, &NumberBox::valueChanged);
    typeInto(box, text);
    QVERIFY(changes.count() <= 1);  // nothing counts before it is finished
    QCOMPARE(box->isRefused(), value == kNothing);
    if (value != kNothing) {
        QCOMPARE(box->value(), value);
        QVERIFY(!hintIn(window));
        return;
    }
    // It stands there as it was typed, and the field tells what it takes.
    QCOMPARE(box->text().remove(u" °"_s), text);
    QCOMPARE(box->value(), before);
    QToolButton *hint = hintIn(window);
    QVERIFY(hint && hint->isVisible() && window.rect().contains(hint->geometry()));
    QVERIFY(hint->text().contains(box->textFromValue(high)));
    const double typed = typedNumber(text);
    const bool isAmbiguous = groupedNumber(text) && decimals < 3;
    const bool isInside = typed >= low && typed <= high && !isAmbiguous;
    QCOMPARE(hint->text().startsWith(u"Can be read as "_s), isAmbiguous);
    QCOMPARE(hint->text().startsWith(u"Whole numbers"_s), isInside && decimals == 0);
    QCOMPARE(hint->text().startsWith(u"At most %1 decimal"_s.arg(decimals)), isInside && decimals > 0);
    const double offered = nearest.isEmpty() ? box->value() : nearest.toDouble();
    hint->click();
    QCOMPARE(box->value(), offered);
    QCOMPARE(typedNumber(box->cleanText()), offered);
    QVERIFY(!box->isRefused());
    QTRY_VERIFY(!hintIn(window));
}

void TestNumberBox::enterAndEscape()
{
    QWidget window;
    auto *box = new NumberBox(0, 255, 0);
    auto *layout = new QVBoxLayout(&window);
    layout->addWidget(box);
    window.show();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    box->setValue(7);
    box->selectAll();
    QTest::keyClicks(box, u"300"_s);
    QVERIFY(!box->isRefused());  // not before it is finished
    QTest::keyClick(box, Qt::Key_Return);
    QVERIFY(box->isRefused());
    QCOMPARE(box->text(), u"300"_s);
    QTest::keyClick(box, Qt::Key_Backspace);
    QVERIFY(!box->isRefused());
    QTest::keyClick(box, Qt::Key_Return);
    QCOMPARE(box->value(), 30.0);
    // Esc brings the value back, an arrow key takes the nearest one.
    QTest::keyClicks(box, u"300"_s);
    QTest::keyClick(box, Qt::Key_Return);
    QTest::keyClick(box, Qt::Key_Escape);
    QCOMPARE(box->text(), u"30"_s);
    QTest::keyClicks(box, u"300"_s);
    QTest::keyClick(box, Qt::Key_Return);
    QTest::keyClick(box, Qt::Key_Up);
    QCOMPARE(box->value(), 255.0);
    QVERIFY(!box->isRefused());
    // What is half typed goes as well, a number or not.
    for (const char *half : {"9", "-"}) {
        box->selectAll();
        QTest::keyClicks(box, QString::fromLatin1(half));
        QTest::keyClick(box, Qt::Key_Escape);
        QCOMPARE(box->text(), u"255"_s);
        QVERIFY(box->settle());
        QCOMPARE(box->value(), 255.0);
    }
    // The value that Enter has taken is what Esc comes back to, and one from elsewhere.
    QTest::keyClicks(box, u"8"_s);
    QTest::keyClick(box, Qt::Key_Return);
    box->selectAll();
    QTest::keyClicks(box, u"9"_s);
    QTest::keyClick(box, Qt::Key_Escape);
    QCOMPARE(box->text(), u"8"_s);
    box->setValue(12);
    box->goOnTyping(u"1"_s);
    QTest::keyClick(box, Qt::Key_Escape);
    QCOMPARE(box->text(), u"12"_s);
}

void TestNumberBox::anEmptyFieldStaysEmpty()
{
    QWidget window;
    auto *box = new NumberBox(-180, 180, 1, u"°"_s);
    box->setEmptyAllowed(true);
    auto *layout = new QVBoxLayout(&window);
    layout->addWidget(box);
    layout->addWidget(new QLineEdit);
    window.show();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    box->clear();
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Tab);
    QVERIFY(!box->isRefused());
    QVERIFY(typedNumber(box->cleanText()) != 0.0);  // no zero that nobody typed
    typeInto(box, u"0"_s);
    QCOMPARE(box->text(), u"0.0°"_s);
    // Emptied by the program, and typed into again.
    for (const Qt::Key last : {Qt::Key_Tab, Qt::Key_Return}) {
        box->setValue(5);
        box->clear();
        box->setFocus();
        QTest::keyClicks(box, u"7"_s);
        QTest::keyClick(box, last);
        QCOMPARE(box->value(), 7.0);
    }
    // What was refused is gone as well.
    typeInto(box, u"500"_s);
    QVERIFY(box->isRefused() && hintIn(window));
    box->clear();
    QVERIFY(!box->isRefused());
    QTRY_VERIFY(!hintIn(window));
}

void TestNumberBox::parametersKeepWhatWasTyped()
{
    WindowRig rig;
    QVERIFY(rig.open());
    rig.window().showPage(u"parameters"_s);
    auto *page = rig.page<ParametersPage>();
    page->showParameter(u"pid.roll.p"_s);
    const auto field = [&rig, page](const QString &key) {
        return qobject_cast<NumberBox *>(page->form()->editor(rig.spec(key).id)->control());
    };
    NumberBox *p = field(u"pid.roll.p"_s);
    QVERIFY(p);
    const double before = p->value();
    typeInto(p, u"300"_s);
    QVERIFY(p->isRefused());
    QCOMPARE(rig.model().changeCount(), 0);
    // One hint at a time; the field with the focus has it.
    NumberBox *yaw = field(u"pid.yaw.p"_s);
    typeInto(yaw, u"999"_s);
    QVERIFY(yaw->isRefused() && p->isRefused());
    const auto hints = [page] { return page->findChildren<QToolButton *>(u"hint"_s).size(); };
    QCOMPARE(hints(), 1);
    p->setFocus();
    QCOMPARE(hints(), 1);
    QVERIFY(hintIn(*page)->text().contains(u"255"_s));
    // A double click that was meant for what it lies over takes nothing.
    auto *hint = qobject_cast<LateButton *>(hintIn(*page));
    QVERIFY(hint);
    QTest::mouseClick(hint, Qt::LeftButton);
    QTest::mouseDClick(hint, Qt::LeftButton);
    QVERIFY(p->isRefused() && p->text() == u"300"_s);
    QTRY_VERIFY(hint->takesClicks());
    QTest::mouseClick(hint, Qt::LeftButton);
    QVERIFY(!p->isRefused() && p->value() == 255);
    rig.workspace().edits().undoStack().undo();
    typeInto(p, u"300"_s);
    p->setFocus();
    typeInto(yaw, u"40"_s);
    QVERIFY(!yaw->isRefused());
    // What was typed would be missed in a review.
    rig.edit(u"pid.yaw.p"_s, 0, 44);
    rig.window().review();
    QVERIFY(!rig.window().reviewDialog());
    QVERIFY(p->hasFocus());
    rig.workspace().edits().undoStack().undo();
    // Another field is edited, another page shown: it stands there still.
    typeInto(field(u"pid.roll.i"_s), u"0,2"_s);
    QCOMPARE(rig.model().changeCount(), 1);
    QCOMPARE(rig.spec(u"pid.roll.i"_s).toDisplay(*rig.model().value(rig.spec(u"pid.roll.i"_s), 0)), 0.2);
    rig.window().showPage(u"console"_s);
    rig.window().showPage(u"parameters"_s);
    QCOMPARE(p->text(), u"300"_s);
    QVERIFY(p->isRefused());
    // A value from elsewhere takes its place.
    rig.edit(u"pid.roll.p"_s, 0, 44);
    QCOMPARE(p->text(), u"44"_s);
    QVERIFY(!p->isRefused());
    rig.workspace().edits().undoStack().undo();
    QCOMPARE(p->value(), before);
}

// Nothing is done with the value from before while another one stands in the field.
void TestNumberBox::actionsRefuseWhatTheyWereNotTold()
{
    WindowRig rig;
    QVERIFY(rig.open(u"sim:storm32"_s));
    const auto actions = rig.client().device()->actions();
    const auto output = std::find_if(actions.begin(), actions.end(),
                                     [](const ActionSpec &spec) { return qstrcmp(spec.key, "pwm") == 0; });
    QVERIFY(output != actions.end());
    ArgumentForm form(*output);
    form.show();
    QVERIFY(QTest::qWaitForWindowActive(&form));
    auto *box = form.findChild<NumberBox *>();
    QVERIFY(box);
    typeInto(box, u"99999"_s);
    QVERIFY(!form.arguments());
    QCOMPARE(form.arguments().error().code, ErrorCode::OutOfRange);
    typeInto(box, u"1600"_s);
    QVERIFY(form.arguments());
    // Typed, and not even left.
    box->setFocus();
    QTest::keyClick(box, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(box, u"5"_s);
    QVERIFY(!form.arguments());
    QVERIFY(box->isRefused());
}

// 30 on the way to 300 is no setting.
void TestNumberBox::settingsTakeWhatIsFinished()
{
    WindowRig rig;
    auto *page = rig.page<SettingsPage>();
    QVERIFY(page && QTest::qWaitForWindowActive(&rig.window()));
    const auto settings = [&rig] {
        const SupervisorRules rules = rig.settings().supervisorRules();
        return QList<double>{double(rig.settings().retentionMinutes()),
                             double(rig.settings().escapeHoldMs()),
                             double(rig.settings().controlSpeedLimit()),
                             double(rig.settings().disarmSeconds()),
                             rules.runawayDeg,
                             rules.oscillation,
                             rules.cellVolts,
                             rules.hotCelsius};
    };
    const auto before = settings();
    const auto boxes = page->findChildren<NumberBox *>();
    QCOMPARE(boxes.size(), before.size());
    for (NumberBox *box : boxes) {
        typeInto(box, u"30000"_s);
        QVERIFY2(box->isRefused(), qPrintable(box->accessibleName()));
        QCOMPARE(settings(), before);
        QTest::keyClick(box, Qt::Key_Escape);
    }
    const auto retention = std::find_if(boxes.begin(), boxes.end(),
                                        [](const NumberBox *box) { return box->suffix() == u" min"_s; });
    QVERIFY(retention != boxes.end());
    typeInto(*retention, u"45"_s);
    QCOMPARE(rig.settings().retentionMinutes(), 45);
}

// Another window, another look, another language: the base class would show the value again.
void TestNumberBox::aRefusedTextStaysWhateverHappensAround()
{
    WindowRig rig;
    QVERIFY(rig.open());
    auto *page = rig.page<ParametersPage>();
    page->showParameter(u"pid.roll.p"_s);
    const auto field = [&rig, page](const QString &key) {
        return qobject_cast<NumberBox *>(page->form()->editor(rig.spec(key).id)->control());
    };
    NumberBox *left = field(u"pid.roll.p"_s);
    typeInto(left, u"300"_s);
    NumberBox *unfinished = field(u"pid.pitch.p"_s);
    unfinished->setFocus();
    unfinished->selectAll();
    QTest::keyClicks(unfinished, u"400"_s);
    QWidget other;
    other.show();
    other.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&other));
    QTRY_VERIFY(!rig.window().isActiveWindow());
    rig.theme().setMode(Theme::Mode::Dark);
    rig.theme().apply();
    for (NumberBox *box : {left, unfinished}) {
        QEvent language(QEvent::LocaleChange);
        QCoreApplication::sendEvent(box, &language);
    }
    rig.window().activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&rig.window()));
    QCOMPARE(left->text(), u"300"_s);
    QCOMPARE(unfinished->text(), u"400"_s);
    QVERIFY(left->isRefused() && unfinished->isRefused());
    QCOMPARE(rig.workspace().edits().refused().count(), 2);
    // Each says what it takes when it has the focus.
    for (NumberBox *box : {left, unfinished}) {
        box->setFocus();
        QVERIFY(hintIn(*page) && hintIn(*page)->isVisible());
        const QRect hint(hintIn(*page)->mapToGlobal(QPoint()), hintIn(*page)->size());
        const QRect place(box->mapToGlobal(QPoint()), box->size());
        QVERIFY(hint.intersects(place.adjusted(-4, -4, 4, 4)));
    }
}

void TestNumberBox::argumentsMayBeLeftOut()
{
    // clang-format off
    static constexpr std::array kArguments{
        ArgumentSpec{"pitch", "Pitch", ArgumentKind::Integer, 0, 2300, "µs", {}, "nan"}};
    // clang-format on
    ActionSpec action;
    action.key = "sticks";
    action.arguments = kArguments;
    QWidget window;
    auto *layout = new QVBoxLayout(&window);
    auto *fields = new ArgumentForm(action);
    layout->addWidget(fields);
    layout->addWidget(new QLineEdit);
    const ArgumentForm &form = *fields;
    window.show();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    auto *box = qobject_cast<NumberBox *>(form.field(u"pitch"_s));
    QVERIFY(box && box->isEmpty());
    QVERIFY(box->findChild<QLineEdit *>()->placeholderText().contains(u"2300"_s));
    QVERIFY(form.arguments() && form.arguments()->isEmpty());
    typeInto(box, u"1400"_s);
    QCOMPARE(form.arguments()->value(u"pitch"_s).toInt(), 1400);
    box->clear();
    fields->setText(u"pitch"_s, u"1300"_s);
    QCOMPARE(form.arguments()->value(u"pitch"_s).toInt(), 1300);
    typeInto(box, u"9000"_s);
    QVERIFY(box->isRefused());
    QVERIFY(!form.arguments());
    QVERIFY(box->advice().endsWith(u"Take 2300"_s));
    typeInto(box, u"1500"_s);
    QCOMPARE(form.arguments()->value(u"pitch"_s).toInt(), 1500);
    typeInto(box, {});
    QVERIFY(form.arguments() && form.arguments()->isEmpty());
}

void TestNumberBox::countsAndSteps_data()
{
    QTest::addColumn<QString>("address");
    QTest::newRow("SimpleBGC") << u"sim:simplebgc"_s;
    QTest::newRow("STorM32") << u"sim:storm32"_s;
}

// Registers hold counts: the nearest one stands for what was typed where it is coarser than what is shown,
// but a value that its declaration has no step for is refused.
void TestNumberBox::countsAndSteps()
{
    QFETCH(const QString, address);
    WindowRig rig;
    QVERIFY(rig.open(address));
    int coarse = 0;
    int stepped = 0;
    for (const ParameterSpec &spec : std::as_const(rig.model()).edited().parameters().all()) {
        if (spec.row->kind != ValueKind::Number || spec.row->state)
            continue;
        QWidget window;
        auto *editor = new ValueEditor(spec, rig.client().identity().firmwareNumber);
        auto *layout = new QVBoxLayout(&window);
        layout->addWidget(editor);
        layout->addWidget(new QLineEdit);
        window.show();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        auto *box = qobject_cast<NumberBox *>(editor->control());
        QVERIFY(box);
        editor->show(spec.row->min, spec.row->min);
        std::optional<double> edited;
        connect(editor, &ValueEditor::edited, this, [&edited](double raw) { edited = raw; });
        // The text of each value is that value.
        const double raw = spec.clamped((spec.row->min + spec.row->max) / 2 + 1);
        const QString text = box->textFromValue(spec.toDisplay(raw));
        typeInto(box, text);
        QVERIFY2(!box->isRefused(), qPrintable(spec.key + u": "_s + text));
        if (raw != spec.row->min) {
            QVERIFY2(edited, qPrintable(spec.key));
            QVERIFY2(std::abs(*edited - raw) <= 1, qPrintable(spec.key));
        }
        const double unit = std::pow(10.0, -box->decimals());
        coarse += std::abs(spec.row->scale) > 1.001 * unit;
        if (spec.row->step > 1 && spec.row->wire != WireType::F32) {
            ++stepped;
            edited.reset();
            typeInto(box, box->textFromValue(spec.toDisplay(spec.row->min + 1)));
            QVERIFY2(box->isRefused() && !edited, qPrintable(spec.key));
        }
    }
    QVERIFY(address.contains(u"storm32"_s) ? stepped > 0 : coarse > 0);
}

QTEST_MAIN(TestNumberBox)
#include "tst_numberbox.moc"
