// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/bcflight/camerapage.h"
#include "app/families/bcflight/fullview.h"
#include "app/families/bcflight/picturesettings.h"
#include "app/families/bcflight/transmittercard.h"
#include "app/mainwindow/bars.h"
#include "app/mainwindow/linkbar.h"
#include "app/mainwindow/translations.h"
#include "protocol/bcflight/messages.h"
#include "protocol/bcflight/payloads.h"
#include "protocol/session/channel.h"
#include "protocol/simulator/bcflight/board.h"
#include "protocol/simulator/video/scene.h"
#include "protocol/video/videomodule.h"
#include "tests/support/boardhost.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/panel.h"
#include "widgets/views/elidedlabel.h"
#include "widgets/views/videoview.h"

#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalSpy>
#include <QUdpSocket>

using namespace Qt::StringLiterals;
using Drone = bcflight::SimulatedBoard;

/// The page with the picture of a simulated drone's camera.
class TestCameraPage final : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup()
    {
        m_rig.reset();
        m_drone.reset();
    }
    void theModuleIsLoadedOnceItIsNeeded();
    void picturesComeByThemselves();
    void lossOfThePictureIsTold();
    void recordingsAreFiles();
    void recordingsGoOnBehindOtherPages();
    void lossOfJpegsIsNotCounted();
    void stillsAreFiles();
    void fullScreenLeavesTheRedButton();
    void fullScreenEndsWithItsPage();
    void fullScreenFitsASmallScreen_data() { nothingIsClipped_data(); }
    void fullScreenFitsASmallScreen();
    void pictureIsSet();
    void whatTheDroneTellsIsShown();
    void itsOwnQuestionsWaitWithoutAWord();
    void lensShadingIsSet();
    void transmitterIsSet();
    void transmitterThatWasNotToldKeepsItsChannel();
    void transmitterIsLeftAloneInFlight();
    void whatTransmitterThereIsIsTold_data();
    void whatTransmitterThereIsIsTold();
    void addressesAreTypedAndKept();
    void foldersAreTyped();
    void dronesWithoutACameraAreTold();
    void aMissingModuleIsTold();
    void nothingIsClipped_data();
    void nothingIsClipped();

private:
    /// Connects and shows the page.
    void open(const QString &options = {});
    /// The same with a drone that can be looked into.
    void openDrone(int deafTo = -1);
    [[nodiscard]] std::pair<int, int> transmitter()
    {
        return m_drone->with<Drone>([](Drone &drone) { return drone.transmitterState(); });
    }
    [[nodiscard]] bool hasPicture() const;
    [[nodiscard]] QStringList filesIn(const QString &suffix) const;
    [[nodiscard]] QStringList texts() const;

    std::unique_ptr<DatagramBoardHost> m_drone;
    std::unique_ptr<WindowRig> m_rig;
    CameraPage *m_page = nullptr;
};

void TestCameraPage::init()
{
    m_rig = std::make_unique<WindowRig>();
    m_rig->settings().setVideoFolder(m_rig->filePath(u"pictures"_s));
}

void TestCameraPage::open(const QString &options)
{
    static int seed = 700;
    QVERIFY(m_rig->open(u"sim:bcflight?stand=1&seed=%1"_s.arg(++seed) + options));
    m_page = m_rig->page<CameraPage>();
    QVERIFY(m_page);
}

void TestCameraPage::openDrone(int deafTo)
{
    SimulatorOptions options;
    options.faults.pose = 1;
    options.faults.shake = 0;
    options.faults.deaf = deafTo;
    m_drone = std::make_unique<DatagramBoardHost>(
        std::make_unique<SimulatedPort>(std::make_unique<Drone>(options), options, std::nullopt));
    QVERIFY(m_drone->start());
    QVERIFY(m_rig->open(m_drone->address()));
    m_page = m_rig->page<CameraPage>();
    QVERIFY(m_page);
    QTRY_VERIFY(m_page->transmitter()->channelButton()->isEnabled());
}

bool TestCameraPage::hasPicture() const
{
    const auto picture = m_page->view()->picture();
    return picture && readNumber(*picture) && m_page->staleText().isEmpty();
}

QStringList TestCameraPage::filesIn(const QString &suffix) const
{
    const QDir folder(m_rig->filePath(u"pictures"_s));
    QStringList paths;
    for (const QString &name : folder.entryList({u"drone-*."_s + suffix}, QDir::Files))
        paths.append(folder.filePath(name));
    return paths;
}

QStringList TestCameraPage::texts() const
{
    QStringList list;
    for (const ToldMessage &message : m_rig->workspace().notifications().history())
        list.append(message.text);
    return list;
}

// It would cost every start time and memory.
void TestCameraPage::theModuleIsLoadedOnceItIsNeeded()
{
    const auto isLoaded = [] {
        QFile maps(u"/proc/self/maps"_s);
        return maps.open(QIODevice::ReadOnly) && maps.readAll().contains("libavcodec");
    };
    QVERIFY(m_rig->open(u"sim:bcflight"_s));
    QVERIFY(m_rig->window().showPage(u"monitor"_s));
    QVERIFY(!isLoaded());
    m_page = m_rig->page<CameraPage>();
    QTRY_VERIFY(hasPicture());
    QVERIFY(isLoaded());
}

void TestCameraPage::picturesComeByThemselves()
{
    open();
    QTRY_VERIFY(hasPicture());
    const auto first = *readNumber(*m_page->view()->picture());
    QTRY_VERIFY(readNumber(*m_page->view()->picture()).value_or(0) > first + 10);
    // As large as there is room for it, in its own shape.
    QTRY_COMPARE(m_page->view()->picture()->width, m_page->view()->pixels().width());
    QCOMPARE(m_page->view()->picture()->height, m_page->view()->pixels().width() * 720 / 1280);
    QTRY_VERIFY2(m_page->figures().contains(u"1280 × 720 H.264"_s)
                     && m_page->figures().contains(u"ms behind"_s)
                     && m_page->figures().contains(u"0.0 % lost"_s),
                 qPrintable(m_page->figures()));
    const quint64 shown = m_page->video().statistics().shown;
    QTRY_VERIFY(m_page->video().statistics().shown > shown + 5);
    // Who does not look needs no pictures.
    QVERIFY(m_rig->window().showPage(u"dashboard"_s));
    QVERIFY(!m_page->video().isRunning());
    QVERIFY(m_rig->page<CameraPage>());
    QTRY_VERIFY(hasPicture());
}

void TestCameraPage::lossOfThePictureIsTold()
{
    open();
    QTRY_VERIFY(hasPicture());
    m_rig->workspace().changeWorld(u"unplug=0"_s);
    QTRY_VERIFY2(m_page->staleText().startsWith(u"no picture for 1"_s), qPrintable(m_page->staleText()));
    QVERIFY(m_page->view()->picture());
    const QString before = m_page->staleText();
    QTRY_VERIFY(m_page->staleText() != before);
    QTRY_VERIFY(hasPicture());  // plugged in again
    // Without a link there is nothing to look at.
    m_rig->client().disconnectFromBoard();
    QTRY_VERIFY(!m_page->view()->picture());
    QTRY_COMPARE(m_page->view()->note(), u"Connect a drone to see its picture."_s);
    QVERIFY(!m_page->recordButton()->isEnabled() && !m_page->stillButton()->isEnabled());
}

void TestCameraPage::recordingsAreFiles()
{
    open();
    QTRY_VERIFY(hasPicture());
    QTest::mouseClick(m_page->recordButton(), Qt::LeftButton);
    QVERIFY(m_page->isUnderWay());
    QCOMPARE(m_page->recordButton()->text(), u"Stop recording"_s);
    QTRY_VERIFY(m_page->video().recordingState().length > 1s);
    QTest::mouseClick(m_page->recordButton(), Qt::LeftButton);
    QTRY_VERIFY(!m_page->isUnderWay());
    QCOMPARE(m_page->recordButton()->text(), u"Record"_s);
    QCOMPARE(filesIn(u"mkv"_s).size(), 1);
    QVERIFY2(texts().last().contains(filesIn(u"mkv"_s).first()), qPrintable(texts().last()));
    const auto reader = loadVideoCodecs().value()->openFile(filesIn(u"mkv"_s).first());
    QVERIFY(reader);
    QVERIFY((*reader)->next()->isKey);
    // The folder cannot be made.
    m_rig->settings().setVideoFolder(u"/proc/nowhere"_s);
    QTest::mouseClick(m_page->recordButton(), Qt::LeftButton);
    QVERIFY(!m_page->isUnderWay());
    QVERIFY(texts().last().contains(u"/proc/nowhere"_s));
}

void TestCameraPage::recordingsGoOnBehindOtherPages()
{
    open();
    QTRY_VERIFY(hasPicture());
    QTest::mouseClick(m_page->recordButton(), Qt::LeftButton);
    QTRY_VERIFY(m_page->video().recordingState().frames > 5);
    QVERIFY(m_rig->window().showPage(u"dashboard"_s));
    const quint64 frames = m_page->video().recordingState().frames;
    QTRY_VERIFY(m_page->video().recordingState().frames > frames + 10);
    // The window says so on every page.
    const auto isMarked = [this] {
        for (const QLabel *badge : m_rig->window().findChild<LinkBar *>()->findChildren<QLabel *>()) {
            if (badge->isVisible() && badge->toolTip().contains(filesIn(u"mkv"_s).value(0)))
                return badge->text().contains(u"REC"_s);
        }
        return false;
    };
    QCOMPARE(filesIn(u"mkv"_s).size(), 1);
    QVERIFY(isMarked());
    // The link ends, and the recording with it.
    m_rig->client().disconnectFromBoard();
    QTRY_VERIFY(!m_page->isUnderWay());
    QTRY_VERIFY2(texts().join(u' ').contains(filesIn(u"mkv"_s).first()), qPrintable(texts().join(u' ')));
    QVERIFY(!isMarked());
    QVERIFY(!m_page->video().isRunning());
    QCOMPARE(filesIn(u"mkv"_s).size(), 1);
    QVERIFY(loadVideoCodecs().value()->openFile(filesIn(u"mkv"_s).first()));
}

// They have no numbers, and neither have the datagrams: 0 % would not be true.
void TestCameraPage::lossOfJpegsIsNotCounted()
{
    open(u"&mjpeg=1"_s);
    QTRY_VERIFY(hasPicture());
    m_rig->workspace().changeWorld(u"lose=0.2"_s);
    QTRY_VERIFY2(m_page->figures().contains(u"MJPEG"_s)
                     && m_page->figures().contains(u"loss cannot be counted"_s),
                 qPrintable(m_page->figures()));
    QVERIFY2(!m_page->figures().contains(u'%'), qPrintable(m_page->figures()));
}

void TestCameraPage::stillsAreFiles()
{
    open();
    QTRY_VERIFY(hasPicture());
    for (int i = 1; i <= 2; ++i) {
        QTest::mouseClick(m_page->stillButton(), Qt::LeftButton);
        QTRY_COMPARE(filesIn(u"png"_s).size(), i);
    }
    const QImage image(filesIn(u"png"_s).first());
    QCOMPARE(image.size(), QSize(1280, 720));
    QVERIFY(texts().last().contains(u"drone-"_s));
}

void TestCameraPage::fullScreenLeavesTheRedButton()
{
    open();
    QTRY_VERIFY(hasPicture());
    VideoView *view = m_page->view();
    const QWidget *place = view->parentWidget();
    QPushButton *motors = m_rig->window().findChild<LinkBar *>()->motorsButton();
    const auto isReached = [&](QWidget *widget) {
        const QPoint middle = widget->mapTo(&m_rig->window(), widget->rect().center());
        return m_rig->window().childAt(middle) == widget;
    };
    QTest::mouseDClick(view, Qt::LeftButton);
    QVERIFY(m_page->fullView()->isOn());
    QVERIFY(m_rig->window().isFullScreen());
    QVERIFY(m_rig->isSettled());
    QCOMPARE(view->width(), m_rig->window().width());
    QVERIFY(isReached(motors));
    QVERIFY(!isReached(m_page->recordButton()));
    QVERIFY(view->hasFocus());
    QTRY_COMPARE(view->picture()->width, view->pixels().width());
    QTest::keyClick(view, Qt::Key_Escape);
    QVERIFY(!m_page->fullView()->isOn() && !m_rig->window().isFullScreen());
    QCOMPARE(view->parentWidget(), place);
    QVERIFY(m_rig->isSettled());
    QVERIFY(isReached(m_page->recordButton()));
    // F11 both ways, the button, and another page ends it.
    QTest::keyClick(view, Qt::Key_F11);
    QVERIFY(m_page->fullView()->isOn());
    QTest::keyClick(view, Qt::Key_F11);
    QVERIFY(!m_page->fullView()->isOn());
    QTest::mouseClick(m_page->fullButton(), Qt::LeftButton);
    QVERIFY(m_page->fullView()->isOn());
    // What a stop has to say is not said behind the picture.
    QTest::mouseClick(motors, Qt::LeftButton);
    QTRY_VERIFY(!m_page->fullView()->isOn());
    QTest::mouseClick(m_page->fullButton(), Qt::LeftButton);
    QVERIFY(m_page->fullView()->isOn());
    QVERIFY(m_rig->window().showPage(u"monitor"_s));
    QVERIFY(!m_page->fullView()->isOn() && !m_rig->window().isFullScreen());
    QCOMPARE(view->parentWidget(), place);
}

// At 200 % a screen of 800 pixels has 400 of them: what does not fit goes, and nothing is cut.
// Who hides a page goes through what lies beside it: nothing of that may vanish meanwhile.
void TestCameraPage::fullScreenEndsWithItsPage()
{
    open();
    QTRY_VERIFY(hasPicture());
    m_page->fullView()->setOn(true);
    const QPointer<QWidget> cover = m_page->view()->parentWidget();
    m_page->hide();
    QVERIFY(!m_page->fullView()->isOn());
    QVERIFY(cover);
    QVERIFY(!cover->isVisible());
    QVERIFY(m_page->isAncestorOf(m_page->view()));
    QTRY_VERIFY(!cover);
    // Pages are made anew, and the program ends.
    for (int round = 0; round < 2; ++round) {
        m_page->show();
        m_page->fullView()->setOn(true);
        QVERIFY(m_page->fullView()->isOn());
        if (round == 1)
            break;
        m_rig->window().renew();
        m_page = m_rig->page<CameraPage>();
        QVERIFY(m_page);
        QVERIFY(!m_rig->window().isFullScreen());
    }
    QVERIFY(m_rig->window().isFullScreen());
    m_rig->window().close();
    m_rig->restart();
    QVERIFY(!m_rig->window().isFullScreen());
}

void TestCameraPage::fullScreenFitsASmallScreen()
{
    QFETCH(const QString, language);
    const Translations translations(language);
    m_rig->restart();
    open();
    QTRY_VERIFY(hasPicture());
    m_page->fullView()->setOn(true);
    auto *bar = m_rig->window().findChild<LinkBar *>();
    auto *strip = m_rig->window().findChild<StatusStrip *>();
    for (QWidget *narrow : std::initializer_list<QWidget *>{bar, strip})
        narrow->setFixedWidth(400);
    QVERIFY(m_rig->boardGoesOn(1));
    QVERIFY(m_rig->isSettled());
    QVERIFY(bar->motorsButton()->isVisible());
    for (const QWidget *narrow : std::initializer_list<const QWidget *>{bar, strip}) {
        QCOMPARE(narrow->width(), 400);
        for (const QLabel *label : narrow->findChildren<QLabel *>()) {
            if (label->isVisible() && !qobject_cast<const ElidedLabel *>(label))
                QVERIFY2(label->width() >= label->sizeHint().width(), qPrintable(label->text()));
        }
        for (const QPushButton *button : narrow->findChildren<QPushButton *>()) {
            if (button->isVisible())
                QVERIFY2(button->width() >= button->minimumSizeHint().width(), qPrintable(button->text()));
        }
    }
}

// What is done on the drone is seen in the picture.
void TestCameraPage::pictureIsSet()
{
    open();
    QTRY_VERIFY(hasPicture());
    const auto sky = [this] {
        const auto picture = m_page->view()->picture();
        return int(picture->pixels[std::size_t(picture->stride()) * std::size_t(picture->height / 3)
                                   + std::size_t(picture->width * 3 / 4 + 3) * 4]);
    };
    const int before = sky();
    for (int i = 0; i < 3; ++i)
        QTest::mouseClick(m_page->settings()->button(u"brightness.down"_s), Qt::LeftButton);
    QTRY_VERIFY2(sky() < before - 20, qPrintable(QString::number(before)));
    // Nothing of it is a change of what is stored: no snapshots are taken for it.
    QVERIFY(m_rig->jobsAreDone());
    QVERIFY(m_rig->workspace().history().snapshots(m_rig->client().identity().serial).isEmpty());
}

void TestCameraPage::whatTheDroneTellsIsShown()
{
    open();
    PictureSettings *settings = m_page->settings();
    QTRY_COMPARE(settings->told(u"iso"_s), u"auto"_s);
    QCOMPARE(settings->told(u"shutter"_s), u"200"_s);
    QVERIFY(settings->told(u"brightness"_s).isEmpty());
    QTest::mouseClick(settings->button(u"camera.white_balance"_s), Qt::LeftButton);
    QTRY_COMPARE(settings->told(u"white_balance"_s), u"incandescent"_s);
    QTest::mouseClick(settings->button(u"camera.lock"_s), Qt::LeftButton);
    QTRY_COMPARE(settings->told(u"white_balance"_s), u"R1.50B2.25"_s);
    QTest::mouseClick(settings->button(u"camera.exposure"_s), Qt::LeftButton);
    QTRY_COMPARE(settings->told(u"exposure"_s), u"not told"_s);
    for (const QString &key : {u"night.on"_s, u"night.off"_s, u"record.on"_s, u"record.off"_s,
                               u"camera.picture"_s, u"iso.up"_s, u"contrast.up"_s, u"saturation.down"_s})
        QTest::mouseClick(settings->button(key), Qt::LeftButton);
    QVERIFY(m_rig->jobsAreDone());
    m_rig->client().disconnectFromBoard();
    QTRY_VERIFY(!settings->button(u"night.on"_s)->isEnabled());
}

// Shown while something runs, e.g. the storing of gains with its restart: nobody has ordered anything.
void TestCameraPage::itsOwnQuestionsWaitWithoutAWord()
{
    open();
    PictureSettings *settings = m_page->settings();
    QTRY_COMPARE(settings->told(u"iso"_s), u"auto"_s);
    m_rig->client().submit<void>([](Channel &channel, Device &device) -> Result<void> {
        constexpr int kIsoUp = 6;
        return device.perform(channel, u"camera.step"_s, {{u"step"_s, kIsoUp}}).map([](const ActionReply &) {
        });
    });
    QVERIFY(m_rig->jobsAreDone());
    const qsizetype said = texts().size();
    m_rig->workspace().live().hold();
    settings->ask();
    QVERIFY(m_rig->jobsAreDone());
    QCOMPARE(texts().mid(said), QStringList());
    QCOMPARE(settings->told(u"iso"_s), u"auto"_s);
    m_rig->workspace().live().release();
    QTRY_COMPARE(settings->told(u"iso"_s), u"100"_s);
    QCOMPARE(texts().mid(said), QStringList());
}

void TestCameraPage::lensShadingIsSet()
{
    open();
    QTest::mouseClick(m_page->settings()->button(u"camera.lens.set"_s), Qt::LeftButton);
    QTRY_VERIFY(m_rig->window().panels()->isOpen());
    QDialog *dialog = m_rig->window().panels()->newest();
    QPushButton *set = nullptr;
    for (QPushButton *button : dialog->findChildren<QPushButton *>()) {
        if (button->text() == u"Set"_s)
            set = button;
    }
    QVERIFY(set);
    QTest::mouseClick(set, Qt::LeftButton);
    QTRY_VERIFY(!m_rig->window().panels()->isOpen());
    QVERIFY(m_rig->jobsAreDone());
}

// By mouse and keyboard, and seen on the drone.
void TestCameraPage::transmitterIsSet()
{
    openDrone();
    TransmitterCard &card = *m_page->transmitter();
    QCOMPARE(card.told(),
             u"Sends in the band RaceBand on channel 5, at 5806 MHz, with 14 dBm (step 1 of 3)."_s);
    QCOMPARE(card.band()->currentText(), u"RaceBand"_s);
    QCOMPARE(card.channel()->currentText(), u"5: 5806 MHz"_s);
    QCOMPARE(card.power()->count(), 3);
    QCOMPARE(card.power()->currentText(), u"1: 14 dBm"_s);
    QTest::keyClick(card.band(), Qt::Key_F);
    QCOMPARE(card.band()->currentText(), u"FatShark"_s);
    QCOMPARE(card.channel()->currentText(), u"5: 5820 MHz"_s);
    QTest::keyClick(card.channel(), Qt::Key_Home);
    QCOMPARE(card.channel()->currentText(), u"1: 5740 MHz"_s);
    QCOMPARE(transmitter(), std::pair(37, 0));
    QTest::mouseClick(card.channelButton(), Qt::LeftButton);
    QVERIFY(!card.channelButton()->isEnabled());
    QTRY_COMPARE(transmitter(), std::pair(25, 0));
    QTRY_COMPARE(card.told(),
                 u"Sends in the band FatShark on channel 1, at 5740 MHz, with 14 dBm (step 1 of 3)."_s);
    QVERIFY2(card.said().startsWith(u'✓'), qPrintable(card.said()));
    QTest::keyClick(card.power(), Qt::Key_End);
    QCOMPARE(card.power()->currentText(), u"3: 26 dBm"_s);
    QTest::keyClick(card.powerButton(), Qt::Key_Space);
    QTRY_COMPARE(transmitter(), std::pair(25, 2));
    QTRY_VERIFY2(card.told().contains(u"with 26 dBm (step 3 of 3)"_s), qPrintable(card.told()));
    // What another hand has changed is seen when one comes back.
    QVERIFY(m_rig->window().showPage(u"monitor"_s));
    m_rig->client().submit<void>([](Channel &channel, Device &device) -> Result<void> {
        return device.perform(channel, u"vtx.power"_s, {{u"power"_s, 2}}).map([](const ActionReply &) {});
    });
    QVERIFY(m_rig->jobsAreDone());
    QVERIFY(m_rig->window().showPage(u"camera"_s));
    QTRY_VERIFY2(card.told().contains(u"with 20 dBm (step 2 of 3)"_s), qPrintable(card.told()));
    QCOMPARE(card.power()->currentText(), u"2: 20 dBm"_s);
    m_rig->client().disconnectFromBoard();
    QTRY_VERIFY(!card.channelButton()->isEnabled());
    QCOMPARE(card.obstacle(), u"Not connected."_s);
    QVERIFY2(card.told().contains(u"not known"_s), qPrintable(card.told()));
}

void TestCameraPage::transmitterThatWasNotToldKeepsItsChannel()
{
    openDrone(int(bcflight::Message::VtxSetChannel));
    TransmitterCard &card = *m_page->transmitter();
    const QString before = card.told();
    QTest::keyClick(card.channel(), Qt::Key_Home);
    QTest::mouseClick(card.channelButton(), Qt::LeftButton);
    QTRY_VERIFY2_WITH_TIMEOUT(card.said().startsWith(u'✖'), qPrintable(card.said()), kPatience);
    QTRY_COMPARE(card.told(), before);
    QCOMPARE(transmitter(), std::pair(37, 0));
    QCOMPARE(card.channel()->currentText(), u"1: 5658 MHz"_s);  // to be tried again
    QTRY_VERIFY(card.channelButton()->isEnabled());
}

// Who looks through its camera must not lose the picture.
void TestCameraPage::transmitterIsLeftAloneInFlight()
{
    openDrone();
    const TransmitterCard &card = *m_page->transmitter();
    const auto calibrated = m_rig->workspace().perform(u"calibrate.all"_s, {});
    QTRY_VERIFY_WITH_TIMEOUT(calibrated.isFinished(), kPatience);
    m_rig->client().submit<bool>([](Channel &channel, Device &) -> Result<bool> {
        Request request;
        const bcflight::Controls wanted{.thrust = 0.3, .arm = true};
        request.bytes = bcflight::encode(bcflight::Message::Controls, wanted.encode(bcflight::Generation::G));
        channel.post(request);
        return true;
    });
    QTRY_COMPARE(card.obstacle(), u"The drone is armed."_s);
    QTRY_VERIFY(!card.channelButton()->isEnabled() && !card.powerButton()->isEnabled());
    // Neither does the page of all actions do it.
    const auto refused = m_rig->workspace().perform(u"vtx.power"_s, {{u"power"_s, 2}});
    QTRY_VERIFY_WITH_TIMEOUT(refused.isFinished(), kPatience);
    QCOMPARE(refused.result().error().code, ErrorCode::ConditionUnmet);
    QCOMPARE(transmitter(), std::pair(37, 0));
}

void TestCameraPage::whatTransmitterThereIsIsTold_data()
{
    QTest::addColumn<QString>("options");
    QTest::addColumn<QString>("told");
    QTest::addColumn<QString>("obstacle");
    QTest::newRow("none") << u"&vtx=0"_s << u"no video transmitter"_s << QString();
    QTest::newRow("before it could be told") << u"&generation=E"_s << u"not known"_s << u"only looked at"_s;
}

void TestCameraPage::whatTransmitterThereIsIsTold()
{
    QFETCH(const QString, options);
    QFETCH(const QString, told);
    QFETCH(const QString, obstacle);
    open(options);
    const TransmitterCard &card = *m_page->transmitter();
    QTRY_VERIFY2(card.told().contains(told), qPrintable(card.told()));
    QTRY_VERIFY2(obstacle.isEmpty() ? card.obstacle().isEmpty() : card.obstacle().contains(obstacle),
                 qPrintable(card.obstacle()));
    QVERIFY(m_rig->boardGoesOn(0.5));
    QVERIFY(!card.channelButton()->isEnabled() && !card.powerButton()->isEnabled());
}

void TestCameraPage::addressesAreTypedAndKept()
{
    open();
    QTRY_VERIFY(hasPicture());
    QVERIFY(m_page->addressField()->placeholderText().startsWith(u"127.0.0.1:"_s));
    const auto type = [this](const QString &text) {
        m_page->addressField()->setFocus();
        m_page->addressField()->setText(text);
        QTest::keyClick(m_page->addressField(), Qt::Key_Return);
    };
    type(u"udp://drone"_s);
    QVERIFY(m_page->addressField()->property("refused").toBool());
    QCOMPARE(m_rig->settings().videoAddress(), QString());
    QCOMPARE(m_page->addressField()->text(), u"udp://drone"_s);
    QVERIFY(hasPicture());  // the one before counts
    QUdpSocket drone;
    QVERIFY(drone.bind(QHostAddress::LocalHost, 0));
    type(u"127.0.0.1:%1"_s.arg(drone.localPort()));
    QVERIFY(!m_page->addressField()->property("refused").toBool());
    QTRY_VERIFY(drone.hasPendingDatagrams());
    QVERIFY(!m_page->view()->picture());  // another camera's
    QTRY_VERIFY2(m_page->view()->note().startsWith(u"No video comes from 127.0.0.1"_s),
                 qPrintable(m_page->view()->note()));
    QCOMPARE(m_rig->settings().videoAddress(), u"127.0.0.1:%1"_s.arg(drone.localPort()));
    type({});
    QTRY_VERIFY(hasPicture());
}

void TestCameraPage::foldersAreTyped()
{
    open();
    m_page->folderField()->setFocus();
    m_page->folderField()->setText(u"~/drone"_s);
    QTest::keyClick(m_page->folderField(), Qt::Key_Return);
    QCOMPARE(m_rig->settings().videoFolder(), QDir::homePath() + u"/drone"_s);
}

void TestCameraPage::dronesWithoutACameraAreTold()
{
    open(u"&camera=0"_s);
    QTRY_VERIFY2(m_page->view()->note().startsWith(u"No video comes from"_s),
                 qPrintable(m_page->view()->note()));
    QTest::mouseClick(m_page->settings()->button(u"camera.white_balance"_s), Qt::LeftButton);
    QTRY_VERIFY(!texts().isEmpty());
    QVERIFY(m_page->settings()->told(u"white_balance"_s).isEmpty());
}

void TestCameraPage::aMissingModuleIsTold()
{
    qputenv(kVideoModuleFolder, m_rig->filePath(u"nothing"_s).toLocal8Bit());
    open();
    const QString note = m_page->view()->note();
    qunsetenv(kVideoModuleFolder);
    QVERIFY2(note.contains(u"libgimbaldesk-video"_s), qPrintable(note));
    QVERIFY(!m_page->recordButton()->isEnabled());
    // It is there again.
    QVERIFY(m_rig->window().showPage(u"monitor"_s));
    QVERIFY(m_rig->page<CameraPage>());
    QTRY_VERIFY(hasPicture());
}

void TestCameraPage::nothingIsClipped_data()
{
    QTest::addColumn<QString>("language");
    QTest::newRow("English") << u"en"_s;
    QTest::newRow("German") << u"de"_s;
}

// In the smallest window.
void TestCameraPage::nothingIsClipped()
{
    QFETCH(const QString, language);
    const Translations translations(language);
    m_rig->restart();
    m_rig->window().resize(1024, 640);
    open();
    QTRY_VERIFY(hasPicture());
    QVERIFY(m_rig->isSettled());
    for (const QPushButton *button : m_page->findChildren<QPushButton *>())
        QVERIFY2(button->width() >= button->sizeHint().width(), qPrintable(button->text()));
    for (const QLabel *label : m_page->findChildren<QLabel *>()) {
        if (label->isVisible() && !label->wordWrap() && !qobject_cast<const ElidedLabel *>(label))
            QVERIFY2(label->width() >= label->sizeHint().width(), qPrintable(label->text()));
    }
    const auto *scroll = m_page->findChild<QScrollArea *>();
    QVERIFY(scroll->widget()->width() <= scroll->viewport()->width());
    QVERIFY(m_page->view()->width() >= 400);
}

QTEST_MAIN(TestCameraPage)
#include "tst_camerapage.moc"
