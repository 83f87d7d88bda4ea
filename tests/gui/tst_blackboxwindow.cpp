// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/navigation.h"
#include "app/mainwindow/pagetable.h"
#include "app/pages/tune/spectrumpage.h"
#include "app/pages/tune/tuningpage.h"
#include "app/pages/watch/blackboxpage.h"
#include "app/pages/watch/monitorpage.h"
#include "protocol/client/replaycontrol.h"
#include "protocol/device/device.h"
#include "protocol/telemetry/telemetrystore.h"
#include "tests/support/blackboxsample.h"
#include "tests/support/ctlrun.h"
#include "tests/support/named.h"
#include "tests/support/patience.h"
#include "tests/support/windowrig.h"
#include "widgets/plot/plotview.h"

#include <QAbstractItemModelTester>
#include <QComboBox>
#include <QJsonArray>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>

using namespace Qt::StringLiterals;

/// A black box in the window, and on the command line.
class TestBlackBoxWindow final : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup() { m_rig.reset(); }
    void itOpensLikeARecording();
    void changesAreMarked();
    void namesAreChosen();
    void damageIsTold();
    void theCommandLineTakesItAsWell();
    void pagesOfTheBoardBeforeDrawWhatItHas();

private:
    QString save(const QString &name, const QByteArray &bytes)
    {
        QFile file(m_rig->filePath(name));
        return file.open(QFile::WriteOnly) && file.write(bytes) == bytes.size() ? file.fileName() : QString();
    }
    bool openBox(const QByteArray &bytes)
    {
        return m_rig->workspace().openFile(save(u"blackbox_000001.csv"_s, bytes)).has_value()
            && QTest::qWaitFor([this] { return m_rig->client().isConnected() && !m_rig->model().isEmpty(); },
                               kPatience);
    }
    static bool says(const QWidget *where, const QString &text)
    {
        const auto labels = where->findChildren<QLabel *>();
        return std::any_of(labels.begin(), labels.end(), [&text](const QLabel *label) {
            return label->isVisible() && label->text().contains(text);
        });
    }

    std::unique_ptr<WindowRig> m_rig;
};

void TestBlackBoxWindow::init()
{
    m_rig = std::make_unique<WindowRig>(allLinks(), allFamilies() + recordedFamilies());
}

void TestBlackBoxWindow::itOpensLikeARecording()
{
    QVERIFY(openBox(blackBoxSample()));
    QStringList offered;
    for (const PageEntry &entry : pageTable()) {
        const QString key = QLatin1String(entry.key);
        if (!m_rig->window().navigation()->isOffered(key))
            continue;
        offered.append(key);
        QVERIFY2(m_rig->window().showPage(key), entry.key);
        QVERIFY2(m_rig->window().page(key)->isVisible(), entry.key);
    }
    // What needs a board is not there.
    for (const QString &key : {u"monitor"_s, u"blackbox"_s, u"spectrum"_s})
        QVERIFY2(offered.contains(key), qPrintable(key));
    for (const QString &key :
         {u"parameters"_s, u"tuning"_s, u"actions"_s, u"backups"_s, u"documents"_s, u"control"_s})
        QVERIFY2(!offered.contains(key), qPrintable(key));
    // A heading that nothing stands beneath is not there either.
    const Navigation &list = *m_rig->window().navigation();
    bool isHeading = false;
    for (int row = 0; row < list.count(); ++row) {
        if (list.item(row)->isHidden())
            continue;
        const bool follows = std::exchange(isHeading, !(list.item(row)->flags() & Qt::ItemIsEnabled));
        QVERIFY2(!follows || !isHeading, qPrintable(list.item(row)->text()));
    }
    QVERIFY(!isHeading);
    m_rig->client().replay().seek(2.9);
    const int gyro = findChannel(m_rig->client().device()->channels(), u"IMU:gyroscope.y"_s);
    QTRY_COMPARE(m_rig->workspace().latest(gyro), 0.25);
    QTRY_VERIFY(m_rig->client().telemetry()->now() > 2.8);
    // It is no simulated board that could be connected to.
    for (const QComboBox *box : m_rig->window().findChildren<QComboBox *>())
        QVERIFY(box->findText(u"Black box"_s, Qt::MatchContains) < 0);
}

void TestBlackBoxWindow::changesAreMarked()
{
    QVERIFY(openBox(blackBoxSample()));
    auto *page = m_rig->page<BlackBoxPage>();
    BlackBoxModel &model = page->model();
    const QAbstractItemModelTester tester(&model);
    QTRY_VERIFY(model.rowCount() > 3000);
    const int thrust = model.columnOf("Stabilizer:thrust");
    const int state = model.columnOf("IMU:state");
    QVERIFY(thrust > 0 && state > 0);
    const auto cell = [&model](int row, int column, int role = Qt::DisplayRole) {
        return model.index(row, column).data(role);
    };
    QVERIFY(cell(0, thrust).isNull());  // not written yet
    // 0.00, then 0.25 after one second, then 0.50: the same again is no change.
    const int first = model.nextChange(-1, thrust);
    QCOMPARE(cell(first, thrust).toString(), u"0.25"_s);
    QVERIFY(cell(first, thrust, BlackBoxModel::ChangedRole).toBool());
    QCOMPARE(cell(first - 1, thrust).toString(), u"0.00"_s);
    QVERIFY(!cell(first - 1, thrust, BlackBoxModel::WrittenRole).toBool());
    const int second = model.nextChange(first, thrust);
    QCOMPARE(cell(second, thrust).toString(), u"0.50"_s);
    QCOMPARE(model.nextChange(second, thrust), -1);
    QVERIFY(cell(second, 0).toString().toDouble() > 1.9);
    // Texts as well; with the keys, over the end.
    page->table()->setCurrentIndex(model.index(0, state));
    QTest::keyClick(page, Qt::Key_F3);
    QCOMPARE(cell(page->table()->currentIndex().row(), state).toString(), u"Running"_s);
    const int running = page->table()->currentIndex().row();
    QTest::mouseClick(named<QPushButton>(page, u"Next change"_s), Qt::LeftButton);
    QCOMPARE(page->table()->currentIndex().row(), running);
}

void TestBlackBoxWindow::namesAreChosen()
{
    QVERIFY(openBox(blackBoxSample()));
    auto *page = m_rig->page<BlackBoxPage>();
    BlackBoxModel &model = page->model();
    const QAbstractItemModelTester tester(&model);
    QTRY_VERIFY(model.rowCount() > 3000);
    QTest::keyClick(page, Qt::Key_F, Qt::ControlModifier);
    auto *filter = named<QLineEdit>(page, u"Show only names that hold these words"_s);
    QTRY_VERIFY(filter->hasFocus());
    QTest::keyClicks(filter, u"imu state"_s);
    QCOMPARE(model.columnCount(), 2);
    QCOMPARE(model.rowCount(), 2);
    QCOMPARE(model.headerData(1, Qt::Horizontal, Qt::DisplayRole).toString(), u"IMU:state"_s);
    filter->setText(u"nothing"_s);
    QCOMPARE(model.rowCount(), 0);
    QCOMPARE(model.nextChange(-1), -1);
    filter->clear();
    QVERIFY(model.rowCount() > 3000);
}

void TestBlackBoxWindow::damageIsTold()
{
    QVERIFY(openBox(blackBoxSample() + "no line\n84000000,IMU:state,Of"));
    auto *page = m_rig->page<BlackBoxPage>();
    QTRY_VERIFY(says(page, u"could not be read"_s));
    QTRY_VERIFY(m_rig->client().replay().state());
    QCOMPARE(m_rig->client().replay().state()->gaps.size(), 1);
}

void TestBlackBoxWindow::theCommandLineTakesItAsWell()
{
    const QString box = save(u"box.csv"_s, blackBoxSample());
    const QString csv = m_rig->filePath(u"samples.csv"_s);
    const QString folder = m_rig->filePath(u"."_s);
    const Run exported
        = Running(folder, {u"export"_s, box, u"--csv"_s, csv, u"--channels"_s, u"IMU:gyroscope.x"_s})
              .finish();
    QVERIFY2(exported.exitCode == 0, qPrintable(exported.err));
    QFile samples(csv);
    QVERIFY(samples.open(QFile::ReadOnly));
    const QByteArrayList lines = samples.readAll().split('\n');
    QCOMPARE(lines.first(), QByteArray("time_s,IMU:gyroscope.x [°/s]"));
    QCOMPARE(lines.size(), 1502);
    const Run measured
        = Running(folder,
                  {u"--json"_s, u"analyze"_s, u"spectrum"_s, box, u"--channels"_s, u"IMU:gyroscope.x"_s})
              .finish();
    QVERIFY2(measured.exitCode == 0, qPrintable(measured.err));
    const double peak = measured.json()
                            .value(u"IMU:gyroscope.x"_s)
                            .toObject()
                            .value(u"peaks"_s)
                            .toArray()
                            .first()
                            .toObject()
                            .value(u"hz"_s)
                            .toDouble();
    QVERIFY2(std::abs(peak - 40) < 1, qPrintable(QString::number(peak)));
    // Damage is told, and no success unless that is wanted.
    const QString cut = save(u"cut.csv"_s, blackBoxSample().chopped(5));
    const Run part = Running(folder, {u"export"_s, cut, u"--csv"_s, csv}).finish();
    QCOMPARE(part.exitCode, 1);
    QCOMPARE(Running(folder, {u"export"_s, cut, u"--csv"_s, csv, u"--partial"_s}).finish().exitCode, 0);
    const Run help = Running(folder, {u"--help"_s}).finish();
    QVERIFY(!help.out.contains(u"or blackbox"_s));
}

// It may have no angles and no rates, and the page that draws them is there already.
void TestBlackBoxWindow::pagesOfTheBoardBeforeDrawWhatItHas()
{
    QVERIFY(m_rig->open(u"sim:bcflight?seed=77"_s));
    const TuningPage &page = *m_rig->page<TuningPage>();
    m_rig->client().disconnectFromBoard();
    QTRY_VERIFY(!m_rig->client().isConnected());
    QVERIFY(openBox(blackBoxSample()));
    QVERIFY(m_rig->workspace().roles().gyro[0] < 0 || m_rig->workspace().roles().angle[0] < 0);
    const auto plots = page.findChildren<PlotView *>();
    QVERIFY(!plots.isEmpty());
    for (const PlotView *plot : plots) {
        for (const Curve &curve : plot->curves())
            QVERIFY(curve.channel >= 0
                    && std::size_t(curve.channel) < m_rig->client().device()->channels().size());
    }
}

QTEST_MAIN(TestBlackBoxWindow)
#include "tst_blackboxwindow.moc"
