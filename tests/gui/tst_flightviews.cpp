// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/views/armedstate.h"
#include "widgets/views/motordiagram.h"

#include <QSignalSpy>
#include <QTest>

#include <cmath>

using namespace Qt::StringLiterals;
using State = ArmedState::State;

namespace {

const std::vector<MotorShare> kQuad{{1, -1, -1, 1}, {-1, -1, 1, 1}, {1, 1, 1, 1}, {-1, 1, -1, 1}};

int pixelsOf(const QImage &image, const QColor &colour)
{
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x)
            count += int(image.pixelColor(x, y) == colour);
    }
    return count;
}

std::optional<bool> read(int told)
{
    return told < 0 ? std::nullopt : std::optional(told > 0);
}

}  // namespace

/// What is drawn of a flying machine.
class TestFlightViews final : public QObject
{
    Q_OBJECT
private slots:
    void stateIsOne_data();
    void stateIsOne();
    void statesAreToldApart_data();
    void statesAreToldApart();
    void motorsStandWhereTheyAre();
    void motorsWithoutPlacesAreBars();
    void motorsAreChosen();
    void outputsAreDrawn_data();
    void outputsAreDrawn();
};

void TestFlightViews::stateIsOne_data()
{
    QTest::addColumn<int>("armed");  // -1 = not known
    QTest::addColumn<int>("calibrated");
    QTest::addColumn<int>("calibrating");
    QTest::addColumn<int>("outputs");
    QTest::addColumn<State>("state");
    QTest::newRow("nothing is known") << -1 << -1 << -1 << -1 << State::Unknown;
    QTest::newRow("only that it is calibrated") << -1 << 1 << 0 << 0 << State::Unknown;
    QTest::newRow("after power-up") << 0 << 0 << 0 << 0 << State::NotCalibrated;
    QTest::newRow("calibrating") << 0 << 0 << 1 << 0 << State::Calibrating;
    QTest::newRow("disarmed") << 0 << 1 << 0 << 0 << State::Disarmed;
    QTest::newRow("disarmed, outputs not told") << 0 << 1 << 0 << -1 << State::OutputsUnknown;
    QTest::newRow("armed") << 1 << 1 << 0 << 0 << State::Armed;
    QTest::newRow("armed, nothing else told") << 1 << -1 << -1 << -1 << State::Armed;
    QTest::newRow("disarmed, motors driven") << 0 << 1 << 0 << 1 << State::RunsOn;
    QTest::newRow("motors driven, nothing else told") << -1 << -1 << -1 << 1 << State::RunsOn;
}

void TestFlightViews::stateIsOne()
{
    QFETCH(int, armed);
    QFETCH(int, calibrated);
    QFETCH(int, calibrating);
    QFETCH(int, outputs);
    QTEST(ArmedState::stateOf(read(armed), read(calibrated), read(calibrating), read(outputs)), "state");
}

void TestFlightViews::statesAreToldApart_data()
{
    QTest::addColumn<bool>("dark");
    QTest::newRow("light") << false;
    QTest::newRow("dark") << true;
}

// By a word, a colour and a sign; what may turn a propeller is filled with red, and nothing else is.
void TestFlightViews::statesAreToldApart()
{
    QFETCH(bool, dark);
    Theme theme;
    theme.setMode(dark ? Theme::Mode::Dark : Theme::Mode::Light);
    QVERIFY(Theme::contrast(theme.color(ColorRole::Danger), theme.color(ColorRole::DangerText)) > 4.5);
    QSet<QString> words;
    QList<QImage> pictures;
    for (const State state : {State::Unknown, State::NotCalibrated, State::Calibrating, State::Disarmed,
                              State::OutputsUnknown, State::RunsOn, State::Armed}) {
        ArmedState tile(theme);
        tile.setState(state);
        tile.resize(360, tile.heightForWidth(360));
        const QImage picture = tile.grab().toImage();
        for (const QImage &other : pictures)
            QVERIFY(other.size() != picture.size() || other != picture);
        pictures.append(picture);
        words.insert(tile.word());
        for (int width = 220; width < 400; width += 20)
            QCOMPARE(tile.shownWord(width), tile.word());
        QVERIFY(tile.accessibleDescription().contains(tile.word()));
        const bool isRed = pixelsOf(picture, theme.color(ColorRole::Danger)) > picture.width() * 20;
        QCOMPARE(isRed, state == State::Armed || state == State::RunsOn);
    }
    QCOMPARE(words.size(), 7);
}

void TestFlightViews::motorsStandWhereTheyAre()
{
    Theme theme;
    MotorDiagram diagram(theme);
    diagram.setMotors(4, kQuad);
    QVERIFY(diagram.hasPlaces());
    for (const int side : {40, 80, diagram.minimumWidth(), 300}) {  // wherever front is, it stays
        diagram.resize(side, side);
        const QPointF middle(diagram.width() / 2.0, diagram.height() / 2.0);
        for (int motor = 1; motor <= 4; ++motor) {
            const MotorShare &share = kQuad[std::size_t(motor - 1)];
            const QPointF away = diagram.placeOf(motor) - middle;
            QCOMPARE(away.x() > 0, share.roll > 0);
            QCOMPARE(away.y() < 0, share.pitch > 0);
        }
    }
    diagram.resize(300, 300);
    // One above the other: both are seen.
    diagram.setMotors(2, {{1, 0, 1, 1}, {1, 0, -1, 1}});
    QVERIFY(QLineF(diagram.placeOf(1), diagram.placeOf(2)).length() > 20);
    // The direction of each is the sign of its yaw.
    const auto picture = [&theme](double yaw) {
        MotorDiagram one(theme);
        one.resize(300, 300);
        one.setMotors(1, {{1, 1, yaw, 1}});
        return one.grab().toImage();
    };
    QVERIFY(picture(1) != picture(-1));
    QVERIFY(!diagram.toolTip().isEmpty());  // that nobody knows which way is which
}

void TestFlightViews::motorsWithoutPlacesAreBars()
{
    Theme theme;
    MotorDiagram diagram(theme);
    diagram.resize(300, 200);
    for (const std::vector<MotorShare> &shares :
         {std::vector<MotorShare>(), std::vector<MotorShare>(3), std::vector<MotorShare>(6)}) {
        diagram.setMotors(6, shares);  // none; too few; none with a place
        QVERIFY(!diagram.hasPlaces());
        QCOMPARE(diagram.count(), 6);
        for (int motor = 1; motor < 6; ++motor) {
            QCOMPARE(diagram.placeOf(motor).y(), diagram.placeOf(motor + 1).y());
            QVERIFY(diagram.placeOf(motor).x() < diagram.placeOf(motor + 1).x());
        }
    }
    diagram.setMotors(0, {});
    QCOMPARE(diagram.accessibleDescription(), u"No data"_s);
    QVERIFY(!diagram.grab().isNull());
}

void TestFlightViews::motorsAreChosen()
{
    Theme theme;
    MotorDiagram diagram(theme);
    diagram.resize(300, 300);
    diagram.setMotors(4, kQuad);
    QSignalSpy chosen(&diagram, &MotorDiagram::selectedChanged);
    QTest::mouseClick(&diagram, Qt::LeftButton, {}, diagram.placeOf(3).toPoint());
    QCOMPARE(chosen.count(), 0);  // it only shows them
    diagram.setSelectable(true);
    QTest::mouseClick(&diagram, Qt::LeftButton, {}, diagram.placeOf(3).toPoint());
    QCOMPARE(diagram.selected(), 3);
    QTest::mouseClick(&diagram, Qt::LeftButton, {}, QPoint(150, 150));
    QCOMPARE(diagram.selected(), 3);  // between them
    for (const int next : {4, 1, 2}) {
        QTest::keyClick(&diagram, Qt::Key_Right);
        QCOMPARE(diagram.selected(), next);
    }
    QTest::keyClick(&diagram, Qt::Key_Left);
    QCOMPARE(diagram.selected(), 1);
    QVERIFY2(diagram.accessibleDescription().contains(u"chosen"_s),
             qPrintable(diagram.accessibleDescription()));
    diagram.setMotors(0, {});
    QCOMPARE(diagram.selected(), 0);
}

void TestFlightViews::outputsAreDrawn_data()
{
    QTest::addColumn<bool>("places");
    QTest::newRow("diagram") << true;
    QTest::newRow("bars") << false;
}

void TestFlightViews::outputsAreDrawn()
{
    QFETCH(bool, places);
    Theme theme;
    MotorDiagram diagram(theme);
    diagram.resize(300, 300);
    diagram.setMotors(4, places ? kQuad : std::vector<MotorShare>());
    const auto filled = [&](const std::vector<double> &outputs, ColorRole role) {
        diagram.setOutputs(outputs);
        return pixelsOf(diagram.grab().toImage(), theme.color(role));
    };
    const double none = qQNaN();
    QCOMPARE(filled({none, none, none, none}, ColorRole::Accent), 0);
    QCOMPARE(diagram.outputText(1), u"–"_s);
    QCOMPARE(filled({0, 0, 0, 0}, ColorRole::Accent), 0);
    QCOMPARE(diagram.outputText(1), u"stands"_s);
    const int some = filled({10, 0, 0, 0}, ColorRole::Accent);
    const int more = filled({60, 0, 0, 0}, ColorRole::Accent);
    QVERIFY2(some > 20 && more > 2 * some, qPrintable(u"%1 %2"_s.arg(some).arg(more)));
    QCOMPARE(diagram.outputText(1), u"60 %"_s);
    QVERIFY(diagram.accessibleDescription().contains(u"motor 1: 60 %"_s));
    // More than all is told as more than all, and the one under test has another colour.
    QVERIFY(filled({140, 0, 0, 0}, ColorRole::Warning) > more);
    QCOMPARE(diagram.outputText(1), u"> 100 %"_s);
    QCOMPARE(filled({5, 0, 0, 0}, ColorRole::Warning), 0);
    diagram.setTested(1);
    QVERIFY(filled({5, 0, 0, 0}, ColorRole::Warning) > 20);
}

QTEST_MAIN(TestFlightViews)
#include "tst_flightviews.moc"
