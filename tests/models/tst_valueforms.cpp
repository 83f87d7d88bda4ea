// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/valuetable.h"
#include "widgets/forms/editstack.h"
#include "widgets/forms/liveslider.h"
#include "widgets/forms/parameterform.h"
#include "widgets/forms/valueeditor.h"
#include "widgets/models/changemodel.h"
#include "widgets/models/parametermodel.h"

#include <QAbstractItemModelTester>
#include <QDoubleSpinBox>
#include <QJsonDocument>
#include <QLineEdit>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>

#include <bit>
#include <cmath>

using namespace valuetable;
using namespace Qt::StringLiterals;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
const QByteArray kNoNumber = QByteArray::fromHex("efbeadff");

/// A board whose F32 is no number and whose gains have more digits than the screen shows.
Configuration oddBoard()
{
    Configuration board = configuration();
    QByteArray block = board.block({0, Numbers});
    block.replace(spec(board, "f32").offset, 4, kNoNumber);
    board.setBlock({0, Numbers}, block);
    for (int i = 1; i <= 5; ++i)
        std::ignore = board.setRaw(spec(board, qPrintable(u"gain.%1"_s.arg(i))), 0, i * 1.2345e-5);
    return board;
}

struct Rig
{
    Rig() { model.reset(oddBoard()); }
    [[nodiscard]] const ParameterSpec &spec(const char *key) const
    {
        return valuetable::spec(model.edited(), key);
    }
    [[nodiscard]] int id(const char *key) const { return spec(key).id; }
    [[nodiscard]] double value(const char *key) const { return *model.value(spec(key), 0); }
    [[nodiscard]] QByteArray numbers() const { return std::as_const(model).edited().block({0, Numbers}); }

    ConfigurationModel model;
    EditStack edits{model};
};

/// Types into the editor as an operator does, and leaves the field.
void type(ValueEditor &editor, const QString &text)
{
    auto *line = editor.control()->findChild<QLineEdit *>();
    line->selectAll();
    QTest::keyClicks(line, text);
    QTest::keyClick(line, Qt::Key_Return);
}

}  // namespace

class TestValueForms : public QObject
{
    Q_OBJECT
private slots:
    void editsAreExact();
    void editsSurviveTheJournal();
    void journalsOfEarlierVersionsOpen();
    void whatIsNoNumberCanBeGoneBackTo();
    void whatIsNoNumberIsNotSpread();
    void editorShowsDecimalsAndKeepsBits();
    void editorTakesTheNearestFloat();
    void editorShowsNoNumber();
    void oneEditLeavesTheOthersAlone();
    void tableOfParameters();
    void reviewOfChanges();
    void sliderOfAFloat();
    void sliderOfManyCounts();
    void textsOfAnyLength();
    void textsSurviveTheJournal();
};

void TestValueForms::editsAreExact()
{
    Rig rig;
    for (const auto &[key, raw] : {std::pair{"u32", 4294967295.0},
                                   {"i32", -2147483648.0},
                                   {"be.f32", 2e-6},
                                   {"gain.5", 0.1 / 3.0},
                                   {"scaled", 4294967294.0}}) {
        const double before = rig.value(key);
        QVERIFY(rig.edits.edit(rig.id(key), 0, raw));
        QCOMPARE(rig.value(key), rig.spec(key).nearest(raw));
        rig.edits.undoStack().undo();
        QCOMPARE(std::bit_cast<quint64>(rig.value(key)), std::bit_cast<quint64>(before));
        rig.edits.undoStack().redo();
        QCOMPARE(rig.value(key), rig.spec(key).nearest(raw));
    }
    QVERIFY(!rig.edits.edit(rig.id("u32"), 0, 4294967296));
    QVERIFY(!rig.edits.edit(rig.id("u32"), 0, -1));
    QVERIFY(!rig.edits.edit(rig.id("u32"), 0, kNan));
    QVERIFY(!rig.edits.edit(rig.id("be.f32"), 0, std::numeric_limits<double>::infinity()));
    // The same float again is no edit.
    const int count = rig.edits.undoStack().count();
    QVERIFY(rig.edits.edit(rig.id("be.f32"), 0, rig.value("be.f32") * (1 + 1e-12)));
    QCOMPARE(rig.edits.undoStack().count(), count);
    rig.edits.discardAll();
    QCOMPARE(rig.numbers(), oddBoard().block({0, Numbers}));
    QCOMPARE(rig.model.changeCount(), 0);
}

void TestValueForms::editsSurviveTheJournal()
{
    Rig rig;
    rig.edits.edit(rig.id("u32"), 0, 4294967295);
    rig.edits.edit(rig.id("i32"), 0, -2147483648.0);
    rig.edits.edit(rig.id("gain.2"), 0, 2e-6);
    rig.edits.edit(rig.id("f32"), 0, 1.0 / 3.0);
    const QByteArray journal = QJsonDocument(rig.edits.toJson()).toJson();
    Rig again;
    QVERIFY(again.edits.restore(QJsonDocument::fromJson(journal).object()).any);
    QCOMPARE(again.numbers(), rig.numbers());
    QCOMPARE(again.model.changeCount(), 4);
    while (again.edits.undoStack().canUndo())
        again.edits.undoStack().undo();
    QCOMPARE(again.numbers(), oddBoard().block({0, Numbers}));
}

void TestValueForms::journalsOfEarlierVersionsOpen()
{
    Rig rig;
    const QByteArray journal = R"({"done": 1, "steps": [{"text": "U8",
        "edits": [{"key": "u8", "profile": 0, "from": 0, "to": 44}]}]})";
    QVERIFY(rig.edits.restore(QJsonDocument::fromJson(journal).object()).any);
    QCOMPARE(rig.value("u8"), 44.0);
}

void TestValueForms::whatIsNoNumberCanBeGoneBackTo()
{
    Rig rig;
    QVERIFY(std::isnan(rig.value("f32")));
    QVERIFY(rig.edits.edit(rig.id("f32"), 0, 7));
    QCOMPARE(rig.model.changeCount(), 1);
    rig.edits.undoStack().undo();
    QCOMPARE(rig.numbers(), oddBoard().block({0, Numbers}));
    QCOMPARE(rig.model.changeCount(), 0);
    rig.edits.undoStack().redo();
    QCOMPARE(rig.value("f32"), 7.0);
    QVERIFY(rig.edits.edit(rig.id("f32"), 0, kNan));  // the button that goes back to the board's value
    QCOMPARE(rig.numbers(), oddBoard().block({0, Numbers}));
    QVERIFY(rig.edits.edit(rig.id("f32"), 0, 8));
    rig.edits.discardAll();
    QCOMPARE(rig.numbers(), oddBoard().block({0, Numbers}));
    // After the write the board holds a number, and nothing leads back.
    Configuration written = oddBoard();
    QVERIFY(written.setRaw(spec(written, "f32"), 0, 9));
    rig.model.setBoard(written);
    QVERIFY(!rig.edits.edit(rig.id("f32"), 0, kNan));
    QCOMPARE(rig.value("f32"), 9.0);
}

void TestValueForms::whatIsNoNumberIsNotSpread()
{
    Rig rig;
    rig.model.reset(configuration());
    rig.edits.apply(oddBoard(), u"A file"_s);
    QCOMPARE(rig.value("f32"), 0.0);
    QCOMPARE(rig.value("gain.3"), double(float(3 * 1.2345e-5)));
    rig.edits.undoStack().undo();
    QCOMPARE(rig.model.changeCount(), 0);
}

void TestValueForms::editorShowsDecimalsAndKeepsBits()
{
    Rig rig;
    ValueEditor editor(rig.spec("gain.4"), 1);
    QSignalSpy edited(&editor, &ValueEditor::edited);
    const double exact = rig.value("gain.4");
    editor.show(exact, exact);
    auto *box = qobject_cast<QDoubleSpinBox *>(editor.control());
    QCOMPARE(box->text(), box->locale().toString(0.0, 'f', 4));
    QCOMPARE(edited.count(), 0);
    // To look at it, to confirm what stands there, to leave it: no edit.
    editor.QWidget::show();
    box->setFocus();
    type(editor, box->text());
    box->interpretText();
    box->clearFocus();
    QCOMPARE(edited.count(), 0);
    box->stepUp();
    QCOMPARE(edited.count(), 1);
    QCOMPARE(edited.takeFirst().first().toDouble(), double(0.0001F));
}

void TestValueForms::editorTakesTheNearestFloat()
{
    Rig rig;
    ValueEditor editor(rig.spec("be.f32"), 1);
    editor.show(0.0, 0.0);
    QSignalSpy edited(&editor, &ValueEditor::edited);
    auto *box = qobject_cast<QDoubleSpinBox *>(editor.control());
    type(editor, box->locale().toString(0.125, 'f', 3));
    QCOMPARE(edited.takeFirst().first().toDouble(), 0.125);
    type(editor, box->locale().toString(0.1, 'f', 1));
    QCOMPARE(edited.takeFirst().first().toDouble(), double(0.1F));
    // U32 to its last count.
    ValueEditor counts(rig.spec("u32"), 1);
    counts.show(4294967294.0, 4294967294.0);
    QSignalSpy stepped(&counts, &ValueEditor::edited);
    auto *countBox = qobject_cast<QDoubleSpinBox *>(counts.control());
    countBox->stepUp();
    QCOMPARE(stepped.takeFirst().first().toDouble(), 4294967295.0);
    countBox->stepUp();
    QCOMPARE(stepped.count(), 0);
}

void TestValueForms::editorShowsNoNumber()
{
    Rig rig;
    for (const char *key : {"f32", "gain.1"}) {
        ValueEditor editor(rig.spec(key), 1);
        QSignalSpy edited(&editor, &ValueEditor::edited);
        editor.show(kNan, kNan);
        auto *box = qobject_cast<QDoubleSpinBox *>(editor.control());
        QCOMPARE(box->text(), u"no number"_s);
        type(editor, u"no number"_s);
        box->interpretText();
        QCOMPARE(edited.count(), 0);
        type(editor, box->locale().toString(0.05, 'f', 2));
        QCOMPARE(edited.count(), 1);
        QCOMPARE(edited.takeFirst().first().toDouble(), double(0.05F));
        // Edited: the board's own is offered.
        editor.show(0.05, kNan);
        QVERIFY(box->text() != u"no number"_s);
        auto *reset = editor.findChild<QToolButton *>(u"reset"_s);
        QVERIFY(!reset->isHidden());
        QVERIFY2(reset->toolTip().contains(u"no number"_s), qPrintable(reset->toolTip()));
        QVERIFY(reset->accessibleName().contains(u"no number"_s));
        reset->click();
        QVERIFY(std::isnan(edited.takeFirst().first().toDouble()));
        editor.show(kNan, kNan);
        QVERIFY(reset->isHidden());
        QCOMPARE(box->text(), u"no number"_s);
    }
}

void TestValueForms::oneEditLeavesTheOthersAlone()
{
    Rig rig;
    ParameterForm form(rig.model, rig.edits);
    QList<int> all;
    for (const ParameterSpec &parameter : rig.model.edited().parameters().all())
        all.append(parameter.id);
    form.setParameters(all);
    form.show();
    QByteArray expected = rig.numbers();
    type(*form.editor(rig.id("gain.3")), QLocale().toString(0.05, 'f', 2));
    QVERIFY(rig.spec("gain.3").write(expected, 0.05));
    QCOMPARE(rig.numbers(), expected);
    // Walking through all fields changes nothing.
    for (const int id : all) {
        form.editor(id)->control()->setFocus(Qt::TabFocusReason);
        QTest::keyClick(form.editor(id)->control(), Qt::Key_Return);
    }
    QCOMPARE(rig.numbers(), expected);
    QCOMPARE(rig.edits.undoStack().count(), 1);
}

void TestValueForms::tableOfParameters()
{
    Rig rig;
    ParameterModel model(rig.model);
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    const auto cell = [&](const char *key, int column, int role = Qt::DisplayRole) {
        return model.index(rig.id(key), column).data(role);
    };
    QCOMPARE(cell("f32", ParameterModel::ValueColumn).toString(), u"no number"_s);
    QCOMPARE(cell("gain.2", ParameterModel::ValueColumn).toString(), u"0.0000"_s);
    QCOMPARE(cell("gain.2", ParameterModel::ValueColumn, Qt::EditRole).toString(), u"2.469e-05"_s);
    QCOMPARE(cell("u32", ParameterModel::RangeColumn).toString(), u"0 to 4294967295"_s);
    QSignalSpy edits(&model, &ParameterModel::editRequested);
    const auto enter = [&](const char *key, const QString &text) {
        return model.setData(model.index(rig.id(key), ParameterModel::ValueColumn), text);
    };
    for (const QString &nonsense : {u"nan"_s, u"inf"_s, u"1e999"_s, u"1e39"_s, u"no number"_s})
        QVERIFY(!enter("f32", nonsense));
    QVERIFY(enter("gain.2", u"2e-6"_s));
    QCOMPARE(edits.takeFirst().at(1).toDouble(), double(2e-6F));
    QVERIFY(enter("u32", u"4294967295"_s));
    QCOMPARE(edits.takeFirst().at(1).toDouble(), 4294967295.0);
}

void TestValueForms::reviewOfChanges()
{
    Rig rig;
    rig.edits.edit(rig.id("f32"), 0, 2.5);
    rig.edits.edit(rig.id("gain.1"), 0, 2e-6);
    const ChangeModel review(rig.model.board(), rig.model.edited());
    QCOMPARE(review.rowCount(), 2);
    QCOMPARE(review.index(0, ChangeModel::BoardColumn).data().toString(), u"no number"_s);
    QCOMPARE(review.index(0, ChangeModel::EditedColumn).data().toString(), u"2.500"_s);
    QVERIFY(review.hasTicked(WriteEffect::Permanent) && !review.hasTicked(WriteEffect::Restarts));
    QVERIFY(review.ticked().blocks() == rig.model.edited().blocks());
    // Back to what is no number, as after an undone write.
    const ChangeModel back(rig.model.edited(), oddBoard());
    QVERIFY(back.ticked().blocks() == oddBoard().blocks());
}

void TestValueForms::sliderOfAFloat()
{
    Rig rig;
    LiveSlider slider(rig.spec("gain.1"), {0.0, 0.1}, 1);
    QSignalSpy edited(&slider, &LiveSlider::edited);
    slider.show(double(0.05F), double(0.05F));
    QCOMPARE(slider.slider()->value(), 500);
    slider.show(2e-6, 2e-6);
    QCOMPARE(edited.count(), 0);  // it has shown it, and not rounded it
    // It spans three times what is stored, not the range that is thousands of times that.
    slider.slider()->setValue(1000);
    QCOMPARE(edited.takeFirst().first().toDouble(), double(6e-6F));
    slider.slider()->setValue(500);
    QCOMPARE(edited.takeFirst().first().toDouble(), double(3e-6F));
    slider.show(0.03, 2e-6);  // in use, further away
    QCOMPARE(slider.slider()->value(), slider.slider()->maximum());
    slider.show(0.0, 0.0);
    slider.slider()->setValue(500);
    QCOMPARE(edited.takeLast().first().toDouble(), double(0.00005F));
    slider.show(kNan, kNan);
    QCOMPARE(edited.count(), 0);
}

void TestValueForms::sliderOfManyCounts()
{
    Rig rig;
    LiveSlider slider(rig.spec("u32"), {0.0, 4294967295.0}, 1);
    QSignalSpy edited(&slider, &LiveSlider::edited);
    slider.show(4294967295.0, 0.0);
    QCOMPARE(slider.slider()->value(), slider.slider()->maximum());
    slider.slider()->setValue(0);
    QCOMPARE(edited.takeFirst().first().toDouble(), 0.0);
    LiveSlider counts(rig.spec("i16"), {-300.0, 300.0}, 1);
    counts.show(-20.0, 0.0);
    QCOMPARE(counts.slider()->value(), -20);  // a position is a count
}

void TestValueForms::textsOfAnyLength()
{
    Rig rig;
    const BlockKey key{0, Document};
    const QByteArray longer = "a = 1\nb = \"ä\"\n" + QByteArray(2000, 'x');
    for (const QByteArray &text : {longer, QByteArray("a"), QByteArray()}) {
        rig.edits.editData(key, text);
        QCOMPARE(std::as_const(rig.model).edited().block(key), text);
        const auto changes = rig.model.dataChanges();
        QCOMPARE(changes.size(), std::size_t(1));
        QCOMPARE(changes[0].to, text);
        const ChangeModel review(rig.model.board(), rig.model.edited());
        QCOMPARE(review.rowCount(), 1);
        QVERIFY(review.ticked().blocks() == rig.model.edited().blocks());
        QVERIFY(review.hasTicked(WriteEffect::Restarts) && !review.hasTicked(WriteEffect::Volatile));
    }
    rig.edits.undoStack().undo();
    rig.edits.undoStack().undo();
    QCOMPARE(std::as_const(rig.model).edited().block(key), longer);
    rig.edits.discardAll();
    QCOMPARE(rig.model.changeCount(), 0);
    // Longer than the board takes, or a block that it has not: refused.
    rig.edits.editData(key, QByteArray(4097, 'x'));
    QCOMPARE(rig.model.changeCount(), 0);
    QCOMPARE(rig.model.setData(key, QByteArray(4097, 'x')).error().code, ErrorCode::OutOfRange);
    QCOMPARE(rig.model.setData({1, Document}, "x").error().code, ErrorCode::Unsupported);
    rig.edits.editData({0, Numbers}, QByteArray(kNumbersSize, 'x'));  // parameters are edited one by one
    QCOMPARE(rig.model.changeCount(), 0);
}

void TestValueForms::textsSurviveTheJournal()
{
    Rig rig;
    const BlockKey key{0, Document};
    rig.edits.editData(key, "much more than there was before\n");
    rig.edits.editData(key, {});
    const QByteArray journal = QJsonDocument(rig.edits.toJson()).toJson();
    Rig again;
    QVERIFY(again.edits.restore(QJsonDocument::fromJson(journal).object()).any);
    QVERIFY(std::as_const(again.model).edited().block(key).isEmpty());
    again.edits.undoStack().undo();
    QCOMPARE(std::as_const(again.model).edited().block(key), "much more than there was before\n");
    again.edits.undoStack().undo();
    QCOMPARE(std::as_const(again.model).edited().block(key), "a = 1\n");
    // A board whose text may not be so long takes none of it.
    QByteArray tooLong = journal;
    tooLong.replace(QByteArray("much more").toHex(), QByteArray(5000, 'x').toHex());
    Rig other;
    other.edits.restore(QJsonDocument::fromJson(tooLong).object());
    QVERIFY(std::as_const(other.model).edited().block(key).size() <= 4096);
}

QTEST_MAIN(TestValueForms)
#include "tst_valueforms.moc"
