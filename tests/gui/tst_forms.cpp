// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/board/actionspage.h"
#include "app/pages/board/backupspage.h"
#include "app/pages/board/controlpage.h"
#include "app/pages/board/functionscard.h"
#include "app/pages/setup/parameterspage.h"
#include "app/pages/tune/tuningpage.h"
#include "tests/support/patience.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/argumentform.h"
#include "widgets/forms/flagsbutton.h"
#include "widgets/forms/liveslider.h"
#include "widgets/forms/parameterform.h"
#include "widgets/forms/reviewdialog.h"
#include "widgets/forms/valueeditor.h"
#include "widgets/models/parametermodel.h"

#include <QComboBox>
#include <QFormLayout>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QRegularExpression>
#include <QSet>
#include <QSignalSpy>
#include <QTableView>
#include <QTableWidget>
#include <QTextBrowser>
#include <QTreeWidget>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

QRect inWindow(const QWidget &widget)
{
    return {widget.mapTo(widget.window(), QPoint(0, 0)), widget.size()};
}

/// How far the middle of the label's text lies above or below the middle of its field.
int offBaseLine(const QLabel &label, const QWidget &field)
{
    return std::abs(inWindow(label).center().y() - inWindow(field).center().y());
}

}  // namespace

/// Forms as an operator sees them, on the real window with every family.
class TestForms : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_rig = std::make_unique<WindowRig>(); }
    void cleanup() { m_rig.reset(); }

    void levelsHideEmptyGroups_data() { families(); }
    void levelsHideEmptyGroups();
    void groupWithChangesStays();
    void fieldsAreEvenlySpaced();
    void flagsLookLikeFields();
    void labelsStandOnTheLineOfTheirField_data() { families(); }
    void labelsStandOnTheLineOfTheirField();
    void slidersHaveTheirLabelOnTheLine_data() { families(); }
    void slidersHaveTheirLabelOnTheLine();
    void functionsHaveLabels();
    void selectedRowHasOneShade_data();
    void selectedRowHasOneShade();
    void tableMarksChanges();
    void tableEditsChoicesByName();
    void tableTellsWhatItRefuses();
    void repliesHaveUnits_data();
    void repliesHaveUnits();
    void autoTuneSaysWhatItsColumnsAre();
    void namesAreOneLine();

private:
    void families()
    {
        QTest::addColumn<QString>("address");
        QTest::newRow("simplebgc") << u"sim:simplebgc"_s;
        QTest::newRow("storm32") << u"sim:storm32"_s;
    }
    ParametersPage *parameters() { return m_rig->page<ParametersPage>(); }
    void showTable()
    {
        for (auto *chip : parameters()->findChildren<QPushButton *>(u"chip"_s)) {
            if (chip->text() == u"Table"_s)
                chip->setChecked(true);
        }
    }
    QModelIndex cell(const QString &key, int column)
    {
        QAbstractItemModel *model = parameters()->table()->model();
        for (int row = 0; row < model->rowCount(); ++row) {
            if (model->index(row, ParameterModel::KeyColumn).data().toString() == key)
                return model->index(row, column);
        }
        return {};
    }

    std::unique_ptr<WindowRig> m_rig;
};

void TestForms::levelsHideEmptyGroups()
{
    QFETCH(QString, address);
    QVERIFY(m_rig->open(address));
    auto *page = parameters();
    auto *level = page->findChild<QComboBox *>();
    auto *groups = page->findChild<QListWidget *>();
    for (int chosen = 0; chosen < level->count(); ++chosen) {
        level->setCurrentIndex(chosen);
        int offered = 0;
        for (int i = 0; i < groups->count(); ++i) {
            if (groups->item(i)->isHidden())
                continue;
            ++offered;
            groups->setCurrentRow(i);
            QVERIFY2(!page->form()->findChildren<ValueEditor *>().isEmpty(),
                     qPrintable(level->currentText() + u": "_s + groups->item(i)->text()));
        }
        QVERIFY(offered > 0);
    }
    // A group that the level leaves nothing of is left for one that it does.
    level->setCurrentIndex(2);
    for (int i = 0; i < groups->count(); ++i) {
        groups->setCurrentRow(i);
        level->setCurrentIndex(0);
        QVERIFY(groups->currentItem() && !groups->currentItem()->isHidden());
        level->setCurrentIndex(2);
    }
}

void TestForms::groupWithChangesStays()
{
    QVERIFY(m_rig->open());
    auto *page = parameters();
    page->findChild<QComboBox *>()->setCurrentIndex(0);
    const QString key = u"startup.threshold_a1"_s;
    const ParameterSpec *spec = m_rig->model().edited().parameters().find(key);
    if (!spec)
        spec = m_rig->model().edited().parameters().find(u"adaptive.threshold"_s);
    for (const ParameterSpec &each : m_rig->model().edited().parameters().all()) {
        if (int(each.row->level) > 0 && each.row->kind == ValueKind::Number && !each.row->state)
            spec = &each;
    }
    QVERIFY(spec);
    auto *groups = page->findChild<QListWidget *>();
    const auto item = [&] {
        for (int i = 0; i < groups->count(); ++i) {
            if (groups->item(i)->data(Qt::UserRole).toString() == QLatin1String(spec->row->group))
                return groups->item(i);
        }
        return static_cast<QListWidgetItem *>(nullptr);
    };
    const double before = m_rig->raw(spec->key);
    m_rig->edit(spec->key, 0, before == spec->row->min ? spec->row->max : spec->row->min);
    QVERIFY(item());
    QVERIFY(!item()->isHidden());
}

void TestForms::fieldsAreEvenlySpaced()
{
    QVERIFY(m_rig->open());
    auto *page = parameters();
    page->showParameter(u"pid.roll.p"_s);
    QVERIFY(m_rig->isSettled());
    // The first column of fields: of the matrix and of the single values below it.
    QList<QRect> fields;
    for (ValueEditor *editor : page->form()->findChildren<ValueEditor *>()) {
        if (editor->spec().axis == Axis::Roll || editor->spec().axis == Axis::None)
            fields.append(inWindow(*editor->control()));
    }
    std::sort(fields.begin(), fields.end(), [](const QRect &a, const QRect &b) { return a.top() < b.top(); });
    fields.removeIf([&](const QRect &field) { return field.left() > fields.first().left() + 100; });
    QVERIFY(fields.size() > 4);
    QSet<int> gaps;
    for (qsizetype i = 1; i < fields.size(); ++i) {
        QCOMPARE(fields[i].left(), fields.first().left());
        gaps.insert(fields[i].top() - fields[i - 1].bottom());
    }
    QCOMPARE(gaps.size(), 1);
}

void TestForms::flagsLookLikeFields()
{
    QVERIFY(m_rig->open());
    auto *page = parameters();
    page->showParameter(u"service.beeper"_s);
    QVERIFY(m_rig->isSettled());
    ValueEditor *editor = page->form()->editor(m_rig->spec(u"service.beeper"_s).id);
    auto *flags = qobject_cast<FlagsButton *>(editor->control());
    QVERIFY(flags);
    // The words of what is ticked, as far as they fit; all of them where one points.
    QVERIFY2(flags->text().startsWith(u"Cal"_s), qPrintable(flags->text()));
    m_rig->edit(u"service.beeper"_s, 0, 0);
    QCOMPARE(flags->text(), u"None"_s);
    // Ground, frame and height of a choice beside it.
    auto *choice = page->form()->editor(m_rig->spec(u"service.rc_low"_s).id)->control();
    QCOMPARE(flags->height(), choice->height());
    const auto ground = [](QWidget *widget) {
        const QImage image = widget->grab().toImage();
        return image.pixelColor(image.width() / 2, 4 * image.height() / 5);
    };
    QCOMPARE(ground(flags), ground(choice));
    // The words keep off the edge as those of the choice do.
    const auto firstInk = [](QWidget *widget) {
        const QImage image = widget->grab().toImage();
        const int line = image.height() / 2;
        const QColor surface = image.pixelColor(image.width() / 2, 4 * image.height() / 5);
        for (int x = 4; x < image.width() / 2; ++x) {
            for (int y = line - 4; y < line + 4; ++y) {
                if (image.pixelColor(x, y) != surface)
                    return x;
            }
        }
        return -1;
    };
    QVERIFY(std::abs(firstInk(flags) - firstInk(choice)) <= 3);
}

void TestForms::labelsStandOnTheLineOfTheirField()
{
    QFETCH(QString, address);
    QVERIFY(m_rig->open(address));
    auto *page = m_rig->page<ActionsPage>();
    int seen = 0;
    for (const ActionSpec &action : m_rig->client().device()->actions()) {
        QVERIFY(page->showAction(QString::fromLatin1(action.key)));
        QVERIFY(m_rig->isSettled());
        for (const ArgumentSpec &argument : action.arguments) {
            QWidget *field = page->form()->field(QString::fromLatin1(argument.key));
            auto *layout = static_cast<QFormLayout *>(page->form()->layout());
            auto *label = qobject_cast<QLabel *>(layout->labelForField(field));
            QVERIFY(label);
            QVERIFY2(offBaseLine(*label, *field) <= 1, argument.key);
            ++seen;
        }
    }
    QVERIFY(seen > 10);
}

// Of the field, whatever lies beneath it; and axes stand above what has axes only.
void TestForms::slidersHaveTheirLabelOnTheLine()
{
    QFETCH(QString, address);
    QVERIFY(m_rig->open(address));
    auto *page = m_rig->page<TuningPage>();
    QVERIFY(m_rig->isSettled());
    int seen = 0;
    for (LiveSlider *control : page->findChildren<LiveSlider *>()) {
        const auto grids = control->parentWidget()->findChildren<QGridLayout *>();
        const auto found = std::find_if(grids.begin(), grids.end(),
                                        [control](QGridLayout *each) { return each->indexOf(control) >= 0; });
        QVERIFY(found != grids.end());
        int row = 0;
        int column = 0;
        int rows = 0;
        int columns = 0;
        (*found)->getItemPosition((*found)->indexOf(control), &row, &column, &rows, &columns);
        const auto labelAt = [&](int atRow, int atColumn) {
            const QLayoutItem *item = (*found)->itemAtPosition(atRow, atColumn);
            return item ? qobject_cast<const QLabel *>(item->widget()) : nullptr;
        };
        const QLabel *label = labelAt(row, 0);
        if (!label)
            continue;  // it stands above
        const int line
            = inWindow(*label).top() + label->contentsMargins().top() + label->fontMetrics().height() / 2;
        const int middle = inWindow(*control->editor()->control()).center().y();
        QVERIFY2(std::abs(line - middle) <= 1,
                 qPrintable(u"%1: %2, %3"_s.arg(label->text()).arg(line).arg(middle)));
        QVERIFY2(columns == 1 || !labelAt(row - 1, 2), qPrintable(label->text()));
        ++seen;
    }
    QVERIFY(seen > 8);
}

void TestForms::functionsHaveLabels()
{
    QVERIFY(m_rig->open(u"sim:storm32"_s));
    auto *page = m_rig->page<ControlPage>();
    QVERIFY(m_rig->isSettled());
    auto *card = page->findChild<FunctionsCard *>();
    const auto forms = card->findChildren<ArgumentForm *>();
    QVERIFY(forms.size() > 3);
    for (ArgumentForm *form : forms) {
        for (QLabel *label : form->findChildren<QLabel *>())
            QVERIFY2(label->isVisible(), qPrintable(label->text()));
    }
}

void TestForms::selectedRowHasOneShade_data()
{
    QTest::addColumn<Theme::Mode>("mode");
    QTest::addColumn<QString>("where");
    for (const char *where : {"review", "table", "backups", "actions"}) {
        QTest::addRow("%s, light", where) << Theme::Mode::Light << QString::fromLatin1(where);
        QTest::addRow("%s, dark", where) << Theme::Mode::Dark << QString::fromLatin1(where);
    }
}

// Whichever cell the keyboard is in.
void TestForms::selectedRowHasOneShade()
{
    QFETCH(Theme::Mode, mode);
    QFETCH(QString, where);
    m_rig->theme().setMode(mode);
    m_rig->theme().apply();
    QVERIFY(m_rig->open());
    QAbstractItemView *view = nullptr;
    if (where == u"review"_s) {
        m_rig->edit(u"pid.roll.p"_s, 0, 44);
        m_rig->edit(u"pid.roll.d"_s, 0, 44);
        m_rig->window().review();
        view = m_rig->window().reviewDialog()->table();
    } else if (where == u"table"_s) {
        showTable();
        view = parameters()->table();
    } else if (where == u"backups"_s) {
        m_rig->workspace().takeSnapshot();
        view = m_rig->page<BackupsPage>()->table();
    } else {
        view = m_rig->page<ActionsPage>()->findChild<QTreeWidget *>();
    }
    QVERIFY(view && view->model()->rowCount() > 0);
    QTRY_VERIFY(view->isVisible());
    QModelIndex place = view->model()->index(0, 0);
    if (view->model()->hasChildren(place))
        place = view->model()->index(0, 0, place);
    view->setCurrentIndex(place);
    view->setFocus();
    QVERIFY(m_rig->isSettled());
    const QImage image = view->viewport()->grab().toImage();
    const QRect row = view->visualRect(place);
    QSet<QRgb> shades;
    for (int x = row.left() + 6; x < image.width() - 6; ++x) {
        for (const int y : {row.top() + 2, row.bottom() - 2})
            shades.insert(image.pixel(int(x * image.devicePixelRatio()), int(y * image.devicePixelRatio())));
    }
    QCOMPARE(shades.size(), 1);
}

void TestForms::tableMarksChanges()
{
    QVERIFY(m_rig->open());
    QTableView *table = parameters()->table();
    showTable();
    const auto picture = [&](int column) {
        return table->viewport()->grab(table->visualRect(cell(u"pid.roll.p"_s, column))).toImage();
    };
    table->scrollTo(cell(u"pid.roll.p"_s, 0));
    QVERIFY(m_rig->isSettled());
    const QImage before = picture(ParameterModel::NameColumn);
    m_rig->edit(u"pid.roll.p"_s, 0, m_rig->raw(u"pid.roll.p"_s) + 1);
    QVERIFY(m_rig->isSettled());
    const QImage after = picture(ParameterModel::NameColumn);
    const QColor mark = m_rig->theme().color(ColorRole::Changed);
    QVERIFY(before.pixelColor(1, before.height() / 2) != mark);
    QCOMPARE(after.pixelColor(1, after.height() / 2), mark);
    m_rig->workspace().edits().undoStack().undo();
    QVERIFY(m_rig->isSettled());
    QCOMPARE(picture(ParameterModel::NameColumn), before);
}

void TestForms::tableEditsChoicesByName()
{
    QVERIFY(m_rig->open());
    QTableView *table = parameters()->table();
    showTable();
    const QString key = u"service.servo1.source"_s;
    parameters()->search()->setText(key);
    table->scrollTo(cell(key, 0));
    table->edit(cell(key, ParameterModel::ValueColumn));
    auto *box = table->findChild<QComboBox *>();
    QVERIFY(box);
    QCOMPARE(box->currentText(), u"Off"_s);
    QCOMPARE(box->itemText(3), u"Virtual channel 3"_s);
    box->setCurrentIndex(3);
    emit box->activated(3);
    QCOMPARE(cell(key, ParameterModel::ValueColumn).data().toString(), u"Virtual channel 3"_s);
}

void TestForms::tableTellsWhatItRefuses()
{
    QVERIFY(m_rig->open());
    showTable();
    QSignalSpy told(&m_rig->workspace().notifications(), &Notifications::notice);
    QAbstractItemModel *model = parameters()->table()->model();
    const double before = m_rig->raw(u"pid.roll.p"_s);
    for (const QString &typed : {u"300"_s, u"many"_s, u""_s, u"-1"_s, QString(5000, u'9'), u"４２x"_s}) {
        told.clear();
        QVERIFY(!model->setData(cell(u"pid.roll.p"_s, ParameterModel::ValueColumn), typed));
        QCOMPARE(told.count(), 1);
        const QString text = told.first().first().toString();
        QVERIFY2(text.contains(u"P · Roll"_s) && text.contains(u"0 to 255"_s) && text.size() < 200,
                 qPrintable(text));
    }
    QCOMPARE(*m_rig->model().value(m_rig->spec(u"pid.roll.p"_s), 0), before);
}

void TestForms::repliesHaveUnits_data()
{
    QTest::addColumn<QString>("address");
    QTest::addColumn<QString>("action");
    QTest::addColumn<QString>("pattern");
    QTest::newRow("angles") << u"sim:simplebgc"_s << u"angles"_s << uR"(imu\.roll\s+-?[\d.e-]+ °\s)"_s;
    QTest::newRow("speeds") << u"sim:simplebgc"_s << u"angles"_s << uR"(speed\.yaw\s+-?[\d.e-]+ °/s\s)"_s;
    QTest::newRow("voltage") << u"sim:storm32"_s << u"status"_s << uR"(Voltage\s+[\d.]+ V)"_s;
    QTest::newRow("temperature") << u"sim:storm32"_s << u"sensors.raw"_s
                                 << uR"(imu\.temperature\s+[\d.]+ °C)"_s;
}

void TestForms::repliesHaveUnits()
{
    QFETCH(QString, address);
    QFETCH(QString, action);
    QFETCH(QString, pattern);
    QVERIFY(m_rig->open(address));
    auto *page = m_rig->page<ActionsPage>();
    QVERIFY(page->showAction(action));
    QTest::mouseClick(page->runButton(), Qt::LeftButton);
    QTRY_VERIFY2(page->reply()->toPlainText().contains(QRegularExpression(pattern)),
                 qPrintable(page->reply()->toPlainText()));
}

void TestForms::autoTuneSaysWhatItsColumnsAre()
{
    QVERIFY(m_rig->open());
    QVERIFY(m_rig->window().showPage(u"autotune"_s));
    auto *table = m_rig->window().page(u"autotune"_s)->findChild<QTableWidget *>();
    QCOMPARE(table->horizontalHeaderItem(2)->text(), u"In use now"_s);
    for (int column = 1; column < table->columnCount(); ++column) {
        // A heading stands over its figures.
        QCOMPARE(table->horizontalHeaderItem(column)->textAlignment(),
                 table->item(0, column)->textAlignment());
    }
    QVERIFY(!table->horizontalHeaderItem(1)->toolTip().isEmpty());
    QVERIFY(!table->horizontalHeaderItem(2)->toolTip().isEmpty());
}

void TestForms::namesAreOneLine()
{
    QVERIFY(m_rig->open());
    QVERIFY(m_rig->window().showPage(u"profiles"_s));
    QAbstractItemModel *model = m_rig->window().page(u"profiles"_s)->findChild<QTableView *>()->model();
    QVERIFY(model->setData(model->index(0, 1), u" first\nand\tsecond\x07 "_s));
    QCOMPARE(m_rig->model().edited().profileNames().value(0), u"first and second"_s);
}

QTEST_MAIN(TestForms)
#include "tst_forms.moc"
