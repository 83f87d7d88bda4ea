// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/messagebar.h"
#include "app/pages/watch/dashboardpage.h"
#include "protocol/base/battery.h"
#include "tests/support/patience.h"
#include "tests/support/windowrig.h"
#include "widgets/models/numbertext.h"
#include "widgets/views/axisdial.h"
#include "widgets/views/batteryview.h"
#include "widgets/views/gimbalview.h"

#include <QLabel>
#include <QScrollArea>
#include <QSignalSpy>

#include <cmath>

using namespace Qt::StringLiterals;

namespace {

const QString kDemo = u"sim:simplebgc"_s;
const QString kStorm = u"sim:storm32"_s;
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// How many pixels of a picture have nearly this colour's hue.
int pixelsLike(const QImage &image, const QColor &colour)
{
    int found = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const QColor pixel = image.pixelColor(x, y);
            found += pixel.hsvSaturationF() > 0.45F && std::abs(pixel.hsvHue() - colour.hsvHue()) < 12;
        }
    }
    return found;
}

QImage pictureOf(const Theme &theme, const GimbalView::Pose &pose)
{
    GimbalView view(theme);
    view.resize(300, 300);
    view.setPose(pose);
    return view.grab().toImage();
}

}  // namespace

/// What the dashboard shows of a board, and that it shows nothing that is not known.
class TestDashboard : public QObject
{
    Q_OBJECT
private slots:
    void bodyShowsWhatIsKnown();
    void bodyMovesWithTheCamera();
    void batteryHasCellsAndThresholds_data();
    void batteryHasCellsAndThresholds();
    void oneLimitOfTheBattery();
    void frameIsShownWhereItIsMeasured();
    void limitsAndFollowing_data();
    void limitsAndFollowing();
    void faultsAreLarge();
    void firmwareIsJudged();
    void linkIsShownBothWays();
    void noThirdIsEmpty_data();
    void noThirdIsEmpty();

private:
    template <typename W> static W *only(QWidget *page) { return page->findChild<W *>(); }
    static bool says(const QWidget *page, const QString &text)
    {
        for (const QLabel *label : page->findChildren<QLabel *>()) {
            if (label->text().contains(text))
                return true;
        }
        return false;
    }
};

void TestDashboard::bodyShowsWhatIsKnown()
{
    Theme theme;
    theme.setMode(Theme::Mode::Light);
    const GimbalView::Angles level{0, 0, 0};
    const QImage nothing = pictureOf(theme, {{kUnknown, kUnknown, kUnknown}, {}, {}});
    const QImage alone = pictureOf(theme, {level, {}, true});
    const QImage whole = pictureOf(theme, {level, level, true});
    const QImage resting = pictureOf(theme, {level, level, false});
    for (const Axis axis : kAxes)
        QCOMPARE(pixelsLike(nothing, theme.axisColor(axis)), 0);
    // Motors are there with the frame only, and in full colour while they run.
    for (const Axis axis : {Axis::Roll, Axis::Yaw}) {
        const QColor colour = theme.axisColor(axis);
        QVERIFY2(pixelsLike(whole, colour) > 2 * pixelsLike(resting, colour), axisKey(axis));
        QVERIFY2(pixelsLike(whole, colour) > pixelsLike(alone, colour), axisKey(axis));
    }
    // An axis that nobody measures has no arrow.
    QCOMPARE(pixelsLike(pictureOf(theme, {{kUnknown, 0, 0}, {}, true}), theme.axisColor(Axis::Roll)), 0);
    GimbalView view(theme);
    QVERIFY(!view.accessibleName().isEmpty());
    QCOMPARE(view.accessibleDescription(), u"No data"_s);
    view.setPose({{kUnknown, 15, -20}, {}, true});
    QVERIFY2(view.accessibleDescription().contains(u"15.0°"_s)
                 && view.accessibleDescription().contains(u"nobody measures the frame"_s),
             qPrintable(view.accessibleDescription()));
    QVERIFY(!view.accessibleDescription().contains(u"Roll"_s));
}

// The lens goes up and down, the body leans to both sides, and what nobody would see
// repaints nothing.
void TestDashboard::bodyMovesWithTheCamera()
{
    Theme theme;
    theme.setMode(Theme::Mode::Dark);
    const GimbalView::Angles level{0, 0, 0};
    const QImage still = pictureOf(theme, {level, {}, true});
    // The arrow ahead is roll's: its middle height on the screen.
    const auto heightOfLens = [&theme](const QImage &image) {
        double sum = 0;
        int count = 0;
        for (int y = 0; y < image.height(); ++y) {
            const int row = pixelsLike(image.copy(0, y, image.width(), 1), theme.axisColor(Axis::Roll));
            sum += double(row) * y;
            count += row;
        }
        return count > 0 ? sum / count : 0.0;
    };
    QVERIFY(heightOfLens(pictureOf(theme, {{0, 20, 0}, {}, true})) < heightOfLens(still) - 5);
    QVERIFY(heightOfLens(pictureOf(theme, {{0, -20, 0}, {}, true})) > heightOfLens(still) + 5);
    for (const GimbalView::Angles &angles : {GimbalView::Angles{15, 0, 0}, GimbalView::Angles{0, 0, 30}})
        QVERIFY(pictureOf(theme, {angles, {}, true}) != still);
    GimbalView view(theme);
    view.setPose({level, {}, true});
    view.setPose({{0.01, 0, 0}, {}, true});
    QCOMPARE(view.pose().camera[0], 0.0);
}

void TestDashboard::batteryHasCellsAndThresholds_data()
{
    QTest::addColumn<double>("volts");
    QTest::addColumn<int>("cells");
    QTest::addColumn<BatteryView::State>("state");
    QTest::addColumn<QString>("said");
    QTest::newRow("full") << 12.5 << 3 << BatteryView::State::Good << u"4.17 V each"_s;
    QTest::newRow("low") << 10.4 << 3 << BatteryView::State::Low << u"low"_s;
    QTest::newRow("empty") << 9.8 << 3 << BatteryView::State::Empty << u"motors off"_s;
    QTest::newRow("on USB") << 0.3 << 0 << BatteryView::State::Unknown << u"no battery"_s;
    QTest::newRow("not known") << kUnknown << 0 << BatteryView::State::Unknown << u"No data"_s;
}

void TestDashboard::batteryHasCellsAndThresholds()
{
    QFETCH(double, volts);
    QFETCH(int, cells);
    QFETCH(BatteryView::State, state);
    QFETCH(QString, said);
    QCOMPARE(batteryCells(volts), cells);
    Theme theme;
    BatteryView view(theme);
    view.setThresholds(10.5, 9.9, false);
    view.setVolts(volts);
    QCOMPARE(view.state(), state);
    // The figure has its colour.
    view.resize(300, 90);
    const QImage picture = view.grab().toImage();
    const auto drawn = [&picture, &theme](ColorRole role) {
        int count = 0;
        for (int y = 0; y < picture.height() / 3; ++y) {
            for (int x = 0; x < picture.width() / 2; ++x)
                count += int(picture.pixelColor(x, y) == theme.color(role));
        }
        return count;
    };
    QCOMPARE(drawn(ColorRole::Danger) > 10, state == BatteryView::State::Empty);
    QCOMPARE(drawn(ColorRole::Warning) > 10, state == BatteryView::State::Low);
    QCOMPARE(drawn(ColorRole::Ok) > 10, state == BatteryView::State::Good);
    QVERIFY2(view.accessibleDescription().contains(said), qPrintable(view.accessibleDescription()));
    // The same thresholds, told for a cell.
    BatteryView each(theme);
    each.setThresholds(3.5, 3.3, true);
    each.setVolts(volts);
    QCOMPARE(each.state(), state);
}

// What the program warns below and what the board warns below is one limit: the one that is reached first.
void TestDashboard::oneLimitOfTheBattery()
{
    Theme theme;
    BatteryView view(theme);
    view.setThresholds(8.7, {}, false);
    view.setVolts(12.3);
    QVERIFY2(view.thresholdText().contains(u"8.7"_s), qPrintable(view.thresholdText()));
    view.setLowCell(3.4);
    QVERIFY2(view.thresholdText().contains(u"10.2"_s), qPrintable(view.thresholdText()));
    view.setVolts(9.9);
    QCOMPARE(view.state(), BatteryView::State::Low);
    view.setThresholds(10.8, {}, false);
    QVERIFY2(view.thresholdText().contains(u"10.8"_s), qPrintable(view.thresholdText()));
    // Another battery's alarm makes no full one low.
    view.setThresholds(14.0, {}, false);
    view.setVolts(12.3);
    QVERIFY2(view.accessibleDescription().contains(u"below the alarm"_s),
             qPrintable(view.accessibleDescription()));

    // On the screen, beside the alarm that tells it.
    WindowRig rig;
    QVERIFY(rig.open(kDemo));
    auto *page = rig.page<DashboardPage>();
    rig.workspace().changeWorld(u"battery=10.0"_s);
    const auto *shown = only<BatteryView>(page);
    QTRY_COMPARE(shown->state(), BatteryView::State::Low);
    const auto alarmed = [&rig] {
        const auto alarms = rig.workspace().alarms().all();
        return std::any_of(alarms.begin(), alarms.end(),
                           [](const AlarmReport &report) { return report.alarm.kind == AlarmKind::Battery; });
    };
    QTRY_VERIFY(alarmed());
    for (const AlarmReport &report : rig.workspace().alarms().all()) {
        if (report.alarm.kind == AlarmKind::Battery && report.alarm.fault.isEmpty())
            QVERIFY2(shown->thresholdText().contains(numberText(report.alarm.limit, 1)),
                     qPrintable(shown->thresholdText()));
    }
}

void TestDashboard::frameIsShownWhereItIsMeasured()
{
    WindowRig rig;
    QVERIFY(rig.open(kDemo + u"?frame-imu=1"_s));
    auto *page = rig.page<DashboardPage>();
    auto *gimbal = only<GimbalView>(page);
    QTRY_VERIFY(!std::isnan(gimbal->pose().camera[0]));
    QTRY_VERIFY(gimbal->pose().frame);
    QSignalSpy finished(&rig.workspace(), &Workspace::writeFinished);
    rig.edit(u"imu.frame.position"_s, 0, 0);
    rig.workspace().write(rig.model().edited());
    QTRY_COMPARE(finished.count(), 1);
    QTRY_VERIFY(!gimbal->pose().frame);
    rig.edit(u"imu.frame.position"_s, 0, 2);
    rig.workspace().write(rig.model().edited());
    QTRY_COMPARE(finished.count(), 2);
    QTRY_VERIFY(gimbal->pose().frame);
    QTRY_COMPARE(gimbal->pose().running, std::optional(true));
    // It costs nothing while it is not seen.
    rig.window().showPage(u"settings"_s);
    const GimbalView::Pose before = gimbal->pose();
    rig.workspace().setMotors(false);
    QVERIFY(rig.boardGoesOn(1.5));
    QCOMPARE(gimbal->pose().running, before.running);
    rig.window().showPage(u"dashboard"_s);
    QTRY_COMPARE(gimbal->pose().running, std::optional(false));
}

void TestDashboard::limitsAndFollowing_data()
{
    QTest::addColumn<QString>("address");
    QTest::addColumn<QString>("low");
    QTest::addColumn<QString>("high");
    QTest::addColumn<bool>("yawFollows");
    QTest::newRow("simplebgc") << kDemo << u"rc.pitch.min_angle"_s << u"rc.pitch.max_angle"_s << false;
    QTest::newRow("storm32") << kStorm << u"rc.pitch.min"_s << u"rc.pitch.max"_s << true;
}

void TestDashboard::limitsAndFollowing()
{
    QFETCH(QString, address);
    QFETCH(QString, low);
    QFETCH(QString, high);
    QFETCH(bool, yawFollows);
    WindowRig rig;
    QVERIFY(rig.open(address));
    const auto dials = rig.page<DashboardPage>()->findChildren<AxisDial *>();
    QCOMPARE(dials.size(), 3);
    const auto shown = [&rig](const QString &key) { return rig.spec(key).toDisplay(rig.raw(key)); };
    const std::pair limits(shown(low), shown(high));
    QVERIFY(limits.first < limits.second);
    QTRY_COMPARE(dials[1]->limits(), std::optional(limits));
    QTRY_COMPARE(dials[2]->follows(), std::optional(yawFollows));
    QTRY_COMPARE(dials[0]->follows(), std::optional(false));
    QTRY_COMPARE(dials[0]->guideText(), u"holds"_s);
    QVERIFY(dials[0]->accessibleDescription().contains(u"holds"_s));
    // Without its motor it holds nothing.
    rig.client().motorsOff();
    QTRY_COMPARE(dials[0]->guideText(), u"motor off"_s);
}

void TestDashboard::faultsAreLarge()
{
    WindowRig rig;
    QVERIFY(rig.open(kDemo));
    auto *page = rig.page<DashboardPage>();
    QVERIFY(!page->findChild<QFrame *>(u"fault"_s));
    rig.workspace().changeWorld(u"battery=9.6"_s);
    QTRY_VERIFY(says(page, u"Battery below its cut-off"_s));
    for (const QFrame *fault : page->findChildren<QFrame *>(u"fault"_s)) {
        const auto words = fault->findChildren<QLabel *>();
        QCOMPARE(words.size(), 3);  // what, what it means, what to do
        QVERIFY(words[0]->font().pointSizeF() > words[1]->font().pointSizeF() + 2);
        QVERIFY(!words[1]->text().isEmpty() && !words[2]->text().isEmpty());
    }
    QCOMPARE(only<BatteryView>(page)->state(), BatteryView::State::Empty);
    rig.workspace().changeWorld(u"battery=12.3"_s);
    QTRY_VERIFY(!page->findChild<QFrame *>(u"fault"_s));
}

void TestDashboard::firmwareIsJudged()
{
    WindowRig rig;
    QVERIFY(rig.open(u"sim:simplebgc?firmware=2.54"_s));
    auto *page = rig.page<DashboardPage>();
    QTRY_VERIFY(says(page, u"This program knows this firmware"_s));
    QVERIFY(says(page, u"It streams no live data"_s));
    const QLabel *gain = nullptr;
    for (const QLabel *label : page->findChildren<QLabel *>()) {
        if (label->text().startsWith(u"Newer firmware would bring: "_s))
            gain = label;
    }
    QVERIFY(gain);
    QVERIFY2(gain->toolTip().contains(u"\n2.59b0: 1 action"_s), qPrintable(gain->toolTip()));
    // Other families are not judged by a number.
    QVERIFY(rig.open(kStorm));
    QTRY_VERIFY(!says(page, u"This program knows this firmware"_s));
}

void TestDashboard::linkIsShownBothWays()
{
    WindowRig rig;
    QVERIFY(rig.open(kDemo));
    auto *page = rig.page<DashboardPage>();
    const QLabel *link = nullptr;
    for (const QLabel *label : page->findChildren<QLabel *>()) {
        if (label->text().contains(u"Unanswered"_s))
            link = label;
    }
    QVERIFY(link);
    const auto rates = [link] { return link->text().count(u"kB/s"_s); };
    QTRY_COMPARE(rates(), 2);
    // Figures of a link that is gone are gone with it.
    rig.client().disconnectFromBoard();
    QTRY_COMPARE(rates(), 0);
    QVERIFY(!link->text().contains(u"per second"_s));
}

void TestDashboard::noThirdIsEmpty_data()
{
    QTest::addColumn<QString>("address");
    QTest::addColumn<QSize>("size");
    for (const QString &address : {kDemo, kStorm}) {
        for (const QSize size : {QSize(1024, 640), QSize(1280, 800), QSize(1920, 1080)})
            QTest::addRow("%s, %d", qPrintable(address), size.width()) << address << size;
    }
}

// Neither of the pictures nor of what is told beside them.
void TestDashboard::noThirdIsEmpty()
{
    QFETCH(const QString, address);
    QFETCH(const QSize, size);
    WindowRig rig;
    rig.window().resize(size);
    QVERIFY(rig.open(address));
    auto *page = rig.page<DashboardPage>();
    QVERIFY(rig.boardGoesOn(1.0));
    rig.window().messageBar()->hide();
    QVERIFY(rig.isSettled());
    const auto *facts = only<QScrollArea>(page);
    const auto emptyRows = [page](const QRect &part) {
        const QImage image = page->grab(part).toImage();
        int longest = 0;
        int run = 0;
        for (int y = 0; y < image.height(); ++y) {
            bool isEmpty = true;
            for (int x = 20; x < image.width() - 30 && isEmpty; ++x)  // without the frames of cards
                isEmpty = image.pixel(x, y) == image.pixel(20, y);
            run = isEmpty ? run + 1 : 0;
            longest = std::max(longest, run);
        }
        return longest;
    };
    const QRect right(facts->mapTo(page, QPoint()), facts->size());
    QTRY_VERIFY2(emptyRows(right) < page->height() / 3,
                 qPrintable(u"%1 of %2 rows"_s.arg(emptyRows(right)).arg(page->height())));
    const QRect left(0, right.top(), right.left(), right.height());
    QVERIFY(emptyRows(left) < page->height() / 3);
}

QTEST_MAIN(TestDashboard)
#include "tst_dashboard.moc"
