// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/translations.h"
#include "app/pages/watch/monitorpage.h"
#include "app/workspace/page.h"
#include "protocol/record/configurationfile.h"
#include "tests/support/drawntexts.h"
#include "tests/support/patience.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/argumentform.h"
#include "widgets/models/framelogmodel.h"
#include "widgets/models/numbertext.h"

#include <QAbstractItemView>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPainter>
#include <QRegularExpression>

using namespace Qt::StringLiterals;

namespace {

// Not those of dates, versions, addresses and files.
const QRegularExpression &pointed()
{
    static const QRegularExpression number(u"(?<![\\w.:/])\\d+\\.\\d+(?![\\w:/]|\\.\\w)"_s);
    return number;
}

/// What can be seen of a table is drawn; this is all of it.
QStringList cellsOf(const QAbstractItemModel &model, const QModelIndex &parent = {})
{
    QStringList texts;
    for (int row = 0; row < model.rowCount(parent); ++row) {
        for (int column = 0; column < model.columnCount(parent); ++column) {
            const QModelIndex cell = model.index(row, column, parent);
            for (const int role : {int(Qt::DisplayRole), int(Qt::ToolTipRole), int(Qt::EditRole)})
                texts.append(cell.data(role).toString());
        }
        texts += cellsOf(model, model.index(row, 0, parent));
    }
    return texts;
}

QStringList textsOn(QWidget &widget)
{
    QStringList texts = drawnTexts(widget);
    for (const QWidget *each : widget.findChildren<QWidget *>()) {
        texts += {each->toolTip(), each->accessibleName(), each->accessibleDescription()};
        if (const auto *view = qobject_cast<const QAbstractItemView *>(each); view && view->model())
            texts += cellsOf(*view->model());
        if (const auto *label = qobject_cast<const QLabel *>(each))
            texts.append(label->text());
        if (const auto *line = qobject_cast<const QLineEdit *>(each))
            texts += {line->text(), line->placeholderText()};
    }
    return texts;
}

}  // namespace

/// Numbers on screen are written as the operator's language does; those in files and on the wire never.
class TestNumbers : public QObject
{
    Q_OBJECT
private slots:
    void numbersAreWrittenAsTheLanguageDoes();
    void sentencesOfTheProtocol_data();
    void sentencesOfTheProtocol();
    void everyPageShowsTheComma_data();
    void everyPageShowsTheComma();
    void whatIsSavedHasThePoint();
    void argumentsTakeTheComma();
};

void TestNumbers::numbersAreWrittenAsTheLanguageDoes()
{
    QCOMPARE(numberText(1234.5, 2), u"1234.50"_s);
    {
        const Translations german(u"de"_s);
        QCOMPARE(numberText(1234.5, 2), u"1234,50"_s);
        QCOMPARE(numberText(-0.001, 2), u"0,00"_s);
        QCOMPARE(numberText(-12.0, 0), u"-12"_s);
        QCOMPARE(shortNumberText(0.25), u"0,25"_s);
        QCOMPARE(numberText(u"0.125"_s), u"0,125"_s);
        QCOMPARE(sizeText(1536 * 1024), u"1,50 MiB"_s);
        QCOMPARE(u"%1"_s.arg(0.5), u"0.5"_s);
        QCOMPARE(QLocale().decimalPoint(), u"."_s);
    }
    QCOMPARE(numberText(1234.5, 2), u"1234.50"_s);
}

void TestNumbers::sentencesOfTheProtocol_data()
{
    QTest::addColumn<QString>("sentence");
    QTest::addColumn<QString>("shown");
    const auto same = [](const char *name, const QString &text) { QTest::newRow(name) << text << text; };
    QTest::newRow("value") << u"pid.roll.p = 0.25, allowed 0 to 25.5"_s
                           << u"pid.roll.p = 0,25, allowed 0 to 25,5"_s;
    QTest::newRow("end") << u"it turned by -1.5."_s << u"it turned by -1,5."_s;
    same("address", u"tcp:127.0.0.1:2000"_s);
    same("host", u"10.0"_s + u".0.7"_s);
    same("file", u"/home/me/gimbal 1.5.json"_s);
    same("folder", u"/home/me/2.5/x"_s);
    same("firmware", u"firmware 2.73 is unknown"_s);
    same("version", u"version 1.2 of the file"_s);
    same("letters", u"v0.96 and 2.60b4"_s);
    same("date", u"24.11.2026"_s);
    same("key", u"imu.0.1x"_s);
}

void TestNumbers::sentencesOfTheProtocol()
{
    QFETCH(const QString, sentence);
    QFETCH(const QString, shown);
    const Translations german(u"de"_s);
    QCOMPARE(withNumbers(sentence), shown);
}

void TestNumbers::everyPageShowsTheComma_data()
{
    QTest::addColumn<QString>("address");
    QTest::newRow("SimpleBGC") << u"sim:simplebgc"_s;
    QTest::newRow("STorM32") << u"sim:storm32"_s;
}

void TestNumbers::everyPageShowsTheComma()
{
    QFETCH(const QString, address);
    const Translations german(u"de"_s);
    WindowRig rig;
    rig.window().resize(1600, 1200);
    QVERIFY(rig.open(address));
    QVERIFY(QTest::qWaitFor([&rig] { return rig.workspace().motorsRunning().has_value(); }, kPatience));
    rig.window().showPage(u"monitor"_s);
    QVERIFY(rig.boardGoesOn(1.0));
    rig.edit(u"pid.roll.p"_s, 0, 44);
    qsizetype seen = 0;
    qsizetype commas = 0;
    const QString firmware = rig.client().identity().firmware;
    const auto check = [&](const QString &where) {
        static const QRegularExpression comma(u"\\d,\\d"_s);
        const QStringList texts = textsOn(rig.window());
        for (QString text : texts) {
            ++seen;
            commas += comma.match(text).hasMatch();
            text.remove(firmware);
            text.remove(QStringLiteral(GIMBAL_VERSION));
            text.remove(rig.client().identity().model);
            text.remove(u"GPL 3.0"_s);
            const auto found = pointed().match(text);
            QVERIFY2(!found.hasMatch(), qPrintable(where + u": "_s + text));
        }
    };
    for (const PageEntry &entry : pageTable()) {
        if (!rig.window().showPage(QLatin1String(entry.key)) || QLatin1String(entry.key) == "help"_L1)
            continue;
        QVERIFY(rig.isSettled());
        QVERIFY(rig.boardGoesOn(0.3));
        check(QLatin1String(entry.key));
        if (QTest::currentTestFailed())
            return;
    }
    rig.window().review();
    QTRY_VERIFY(rig.window().reviewDialog());
    check(u"review"_s);
    rig.window().reviewDialog()->reject();
    QVERIFY(seen > 1000);
    QVERIFY(commas > 100);
}

// The same board gives the same files in both languages.
void TestNumbers::whatIsSavedHasThePoint()
{
    QList<QByteArray> saved;
    for (const QString &language : {u"en"_s, u"de"_s}) {
        const Translations translations(language);
        WindowRig rig;
        QVERIFY(rig.open(u"sim:simplebgc"_s));
        rig.edit(u"pid.roll.p"_s, 0, 44);
        saved.append(ConfigurationFile::toJson(std::as_const(rig.model()).edited(), u"test"_s,
                                               QDateTime::fromSecsSinceEpoch(0)));
        auto *monitor = rig.page<MonitorPage>();
        QVERIFY(rig.boardGoesOn(0.5));
        const QString csv = rig.filePath(u"data.csv"_s);
        const auto lines = monitor->exportCsv(csv);
        QVERIFY(lines && *lines > 5);
        QFile file(csv);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QList<QByteArray> rows = file.readAll().split('\n');
        const qsizetype columns = rows[1].count(',');
        for (qsizetype i = 2; i + 1 < rows.size(); ++i)
            QCOMPARE(rows[i].count(','), columns);
        FrameLogModel log(rig.client());
        log.refresh();
        static const QRegularExpression first(u"^ *\\d+\\.\\d{4} "_s);
        QVERIFY2(log.text().isEmpty() || first.match(log.text()).hasMatch(), qPrintable(log.text().left(80)));
    }
    QCOMPARE(saved[1], saved[0]);
}

void TestNumbers::argumentsTakeTheComma()
{
    // clang-format off
    static constexpr std::array kArguments{
        ArgumentSpec{"angle", "Angle", ArgumentKind::Real, -90, 90, "°", {}, "nan"},
        ArgumentSpec{"time", "Time", ArgumentKind::Real, 0, 9, "s", {}, "0.5"}};
    // clang-format on
    ActionSpec action;
    action.key = "turn";
    action.arguments = kArguments;
    const Translations german(u"de"_s);
    ArgumentForm form(action);
    QVERIFY(form.arguments());
    QCOMPARE(form.arguments()->value(u"time"_s).toDouble(), 0.5);
    form.setText(u"angle"_s, u"12,5"_s);
    const auto given = form.arguments();
    QVERIFY(given);
    QCOMPARE(given->value(u"angle"_s).toDouble(), 12.5);
}

QTEST_MAIN(TestNumbers)
#include "tst_numbers.moc"
