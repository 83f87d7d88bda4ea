// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/simplebgc/calibrationpage.h"
#include "app/families/simplebgc/magnetometercard.h"
#include "app/pages/setup/guidepage.h"
#include "protocol/guide/setupstep.h"
#include "tests/support/named.h"
#include "tests/support/patience.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/panel.h"
#include "widgets/views/fieldsphereview.h"

#include <QComboBox>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTextBrowser>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

/// Sensors that only some SimpleBGC boards have, in the window.
class TestSensors final : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_rig = std::make_unique<WindowRig>(); }
    void cleanup() { m_rig.reset(); }
    void boardWithoutMagnetometerOffersNone();
    void missingDirectionsAreTold();
    void magnetometerIsCalibrated();
    void selectedSensorIsFollowed();
    void missingSensorIsNotSelected();

private:
    Workspace &workspace() { return m_rig->workspace(); }
    /// The page, with the magnetometer's card in view, and motors off.
    MagnetometerCard *magnetometer()
    {
        if (!m_rig->open(u"sim:simplebgc?firmware=2.70.4&magnetometer=1"_s) || !m_rig->jobsAreDone())
            return nullptr;
        workspace().setMotors(false);
        if (!QTest::qWaitFor([this] { return workspace().motorsRunning() == false; }, kPatience))
            return nullptr;
        auto *page = m_rig->page<CalibrationPage>();
        QTest::mouseClick(named<QPushButton>(page, u"Magnetometer…"_s), Qt::LeftButton);
        return page->magnetometer()->isVisible() ? page->magnetometer() : nullptr;
    }
    bool isTold(const QString &text)
    {
        const auto labels = m_rig->window().findChildren<QLabel *>();
        return std::any_of(labels.begin(), labels.end(), [&text](const QLabel *label) {
            return label->isVisible() && label->text().contains(text);
        });
    }
    /// The question that is open, or opens.
    bool answer(bool isYes)
    {
        const auto box = [this] { return qobject_cast<QMessageBox *>(m_rig->window().panels()->newest()); };
        if (!QTest::qWaitFor([&box] { return box() != nullptr; }, kPatience))
            return false;
        const auto buttons = box()->buttons();
        for (QAbstractButton *button : buttons) {
            if ((box()->buttonRole(button) != QMessageBox::RejectRole) == isYes) {
                button->click();
                return true;
            }
        }
        return false;
    }

    std::unique_ptr<WindowRig> m_rig;
};

void TestSensors::boardWithoutMagnetometerOffersNone()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?firmware=2.70.4"_s));
    QVERIFY(!named<QPushButton>(m_rig->page<CalibrationPage>(), u"Magnetometer…"_s)->isVisible());
}

// What is turned about one axis only lies in a plane, and that is no sphere.
void TestSensors::missingDirectionsAreTold()
{
    MagnetometerCard *card = magnetometer();
    QVERIFY(card);
    QTRY_VERIFY_WITH_TIMEOUT(card->goButton()->isEnabled(), kPatience);
    workspace().changeWorld(u"hand=6"_s);
    QVERIFY(m_rig->boardGoesOn(4));
    QVERIFY(!card->sphere());
    QVERIFY2(card->sees().contains(u"another axis"_s), qPrintable(card->sees()));
    workspace().changeWorld(u"hand=5"_s);
    QTRY_VERIFY_WITH_TIMEOUT(card->sphere() && card->seen().count() > 3, kPatience);
    QVERIFY2(card->sees().contains(u"has not yet come from"_s), qPrintable(card->sees()));
    QTRY_VERIFY_WITH_TIMEOUT(card->seen().count() >= 24, kPatience);
    QVERIFY(std::abs(card->sphere()->radius - 400) < 15);
    QVERIFY(std::abs(card->sphere()->centre.z - 110) < 15);
    const auto *view = card->findChild<FieldSphereView *>();
    QVERIFY(view->accessibleDescription().startsWith(QString::number(card->seen().count())));
    // Back, and here again: nothing of it is left.
    workspace().changeWorld(u"hand=0"_s);
    QTest::mouseClick(card->backButton(), Qt::LeftButton);
    QVERIFY(!card->isVisible());
    m_rig->page<CalibrationPage>()->startMagnetometer();
    QVERIFY(!card->sphere());
}

void TestSensors::magnetometerIsCalibrated()
{
    MagnetometerCard *card = magnetometer();
    QVERIFY(card);
    QTRY_VERIFY_WITH_TIMEOUT(card->goButton()->isEnabled(), kPatience);
    // Called off at the question, nothing has happened, and nothing is told.
    QTest::mouseClick(card->goButton(), Qt::LeftButton);
    QVERIFY(answer(false));
    QTRY_VERIFY_WITH_TIMEOUT(card->goButton()->isEnabled(), kPatience);
    QCOMPARE(card->step(), MagnetometerCard::Step::Ready);
    QTest::mouseClick(card->goButton(), Qt::LeftButton);
    QVERIFY(answer(true));
    QTRY_COMPARE_WITH_TIMEOUT(card->step(), MagnetometerCard::Step::Turning, kPatience);
    QVERIFY(m_rig->page<CalibrationPage>()->isUnderWay());
    QTRY_COMPARE_WITH_TIMEOUT(card->step(), MagnetometerCard::Step::Result, kPatience);
    QVERIFY(card->seen().count() >= 24);
    QString told;
    for (const QLabel *label : card->findChildren<QLabel *>())
        told += label->text() + u'\n';
    QVERIFY2(told.contains(u"Magnetometer: good"_s) || told.contains(u"Magnetometer: usable"_s),
             qPrintable(told));
    QVERIFY2(told.contains(u"before"_s) && told.contains(u"Error of the heading"_s), qPrintable(told));
    QTest::mouseClick(card->goButton(), Qt::LeftButton);
    QVERIFY(!card->isVisible());
}

void TestSensors::selectedSensorIsFollowed()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?firmware=2.70.4&frame-imu=1"_s) && m_rig->jobsAreDone());
    workspace().setMotors(false);
    QTRY_COMPARE_WITH_TIMEOUT(workspace().motorsRunning(), std::optional(false), kPatience);
    auto *page = m_rig->page<CalibrationPage>();
    QComboBox *box = page->sensorBox();
    QTRY_VERIFY_WITH_TIMEOUT(box->isVisible() && box->isEnabled(), kPatience);
    QCOMPARE(box->currentData().toInt(), 1);
    page->start(CalibrationPage::Kind::SixPositions);
    // Elsewhere, in the middle: what was measured is another sensor's.
    const auto select = [this](int imu) {
        std::ignore = workspace().perform(u"imu.select"_s, {{u"imu"_s, imu}});
        return m_rig->jobsAreDone();
    };
    QVERIFY(select(2));
    QTRY_COMPARE_WITH_TIMEOUT(box->currentData().toInt(), 2, kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(isTold(u"sensor shown: frame IMU"_s), kPatience);
    const int pitch = workspace().roles().gyro[1];
    QTRY_VERIFY_WITH_TIMEOUT(std::abs(workspace().latest(pitch) - 1.8) < 0.6, kPatience);
    // On every page, and a step that is about the camera is not begun.
    auto *guide = m_rig->page<GuidePage>();
    QVERIFY(isTold(u"sensor shown: frame IMU"_s));
    guide->choose(SetupStep::Sensors);
    QTRY_VERIFY_WITH_TIMEOUT(guide->beginButton()->isEnabled(), kPatience);
    QSignalSpy problems(&workspace().notifications(), &Notifications::problem);
    QTest::mouseClick(guide->beginButton(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(problems.count() > 0
                                 || guide->findings()->toPlainText().contains(u"sensor of its frame"_s),
                             kPatience);
    // The camera's again, by the page itself.
    page = m_rig->page<CalibrationPage>();
    QTRY_VERIFY_WITH_TIMEOUT(box->isEnabled() || page->isUnderWay(), kPatience);
    page->backButton()->click();
    QTRY_VERIFY_WITH_TIMEOUT(box->isEnabled(), kPatience);
    box->setCurrentIndex(0);
    emit box->activated(0);
    QTRY_VERIFY_WITH_TIMEOUT(!isTold(u"sensor shown"_s), kPatience);
    // A restart selects the camera's.
    QVERIFY(select(2));
    QTRY_VERIFY_WITH_TIMEOUT(isTold(u"sensor shown: frame IMU"_s), kPatience);
    workspace().changeWorld(u"reset=1"_s);
    QTRY_VERIFY_WITH_TIMEOUT(!isTold(u"sensor shown"_s), kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(box->currentData().toInt(), 1, kPatience);
}

// The board says nothing, and goes on with its own.
void TestSensors::missingSensorIsNotSelected()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?firmware=2.70.4"_s) && m_rig->jobsAreDone());
    auto *page = m_rig->page<CalibrationPage>();
    QComboBox *box = page->sensorBox();
    QTRY_VERIFY_WITH_TIMEOUT(box->isEnabled(), kPatience);
    QSignalSpy problems(&workspace().notifications(), &Notifications::problem);
    box->setCurrentIndex(1);
    emit box->activated(1);
    QTRY_COMPARE_WITH_TIMEOUT(problems.count(), 1, kPatience);
    QTRY_COMPARE_WITH_TIMEOUT(box->currentData().toInt(), 1, kPatience);
    QVERIFY(!isTold(u"sensor shown"_s));
}

QTEST_MAIN(TestSensors)
#include "tst_sensors.moc"
