// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/bcflight/camerapage.h"

#include "app/families/bcflight/fullview.h"
#include "app/families/bcflight/picturesettings.h"
#include "app/families/bcflight/transmittercard.h"
#include "app/families/bcflight/videofiles.h"
#include "widgets/models/numbertext.h"
#include "widgets/views/card.h"
#include "widgets/views/elidedlabel.h"
#include "widgets/views/videoview.h"

#include <QDir>
#include <QFile>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QShortcut>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace {

constexpr int kSettingsWidth = 318;
constexpr auto kRefreshPeriod = 100ms;
constexpr auto kStale = 1s;
constexpr auto kPatient = 3s;  // before it is said what may be wrong

double asMs(Duration duration)
{
    return seconds(duration) * 1000;
}

}  // namespace

CameraPage::CameraPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"camera"_s, tr("Camera"), parent)
    , m_view(new VideoView)
    , m_cover(new StaleCover(workspace.theme(), *m_view))
    , m_fullView(std::make_unique<FullView>(*m_view))
    , m_settings(new PictureSettings(workspace))
    , m_transmitter(new TransmitterCard(workspace))
    , m_record(new QPushButton(tr("Record")))
    , m_still(new QPushButton(tr("Take a picture")))
    , m_full(new QPushButton(tr("Full screen")))
    , m_folder(new QLineEdit)
    , m_address(new QLineEdit)
    , m_figures(new ElidedLabel)
    , m_recording(new ElidedLabel)
{
    auto *row = new QHBoxLayout;
    row->setSpacing(12);
    body()->addLayout(row, 1);
    makeLeft();
    makeRight();
    connectAll();
    showRecording();
    refreshWhileShown(
        kRefreshPeriod, [this] { refresh(); }, [] { return false; });
}

// The picture's last frames may still be on their way, and its size changes once more.
CameraPage::~CameraPage()
{
    m_fullView.reset();
    m_video.stop();
}

void CameraPage::makeLeft()
{
    auto *holder = new QWidget;
    auto *column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_view, 1);
    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(Metric::kGap / 2);
    m_record->setToolTip(tr("Saves the video as it comes, without encoding it again (Matroska)"));
    buttons->addWidget(m_still);
    buttons->addWidget(m_full);
    buttons->addWidget(m_record);  // last: its text grows, and what is aimed at must not move
    m_recording->setAccessibleName(tr("Recording"));
    buttons->addStretch(1);
    column->addLayout(buttons);
    column->addWidget(m_recording);
    m_figures->setObjectName(u"muted"_s);
    m_figures->setWordWrap(true);
    m_figures->setAccessibleName(tr("How the video comes"));
    column->addWidget(m_figures);
    qobject_cast<QHBoxLayout *>(body()->itemAt(0)->layout())->addWidget(holder, 1);
}

void CameraPage::makeRight()
{
    auto *content = new QWidget;
    auto *column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(12);
    column->addWidget(m_settings);
    column->addWidget(m_transmitter);
    column->addWidget(makeConnection());
    column->addStretch(1);
    auto *scroll = new QScrollArea;
    scroll->setWidget(content);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFixedWidth(kSettingsWidth);
    qobject_cast<QHBoxLayout *>(body()->itemAt(0)->layout())->addWidget(scroll);
}

QWidget *CameraPage::makeConnection()
{
    auto *card = new Card(tr("Connection and files"));
    auto *form = new QFormLayout;
    m_address->setText(workspace().settings().videoAddress());
    m_address->setAccessibleName(tr("Address of the video"));
    m_address->setToolTip(
        tr("HOST:PORT, HOST or :PORT. Empty: the drone's host, port %1.").arg(VideoAddress::kPort));
    m_address->setClearButtonEnabled(true);
    form->addRow(tr("Address"), m_address);
    m_folder->setText(workspace().settings().videoFolder());
    m_folder->setPlaceholderText(defaultVideoFolder());
    m_folder->setAccessibleName(tr("Folder for pictures and recordings"));
    m_folder->setToolTip(tr("Where pictures and recordings are saved. Empty: %1").arg(defaultVideoFolder()));
    m_folder->setClearButtonEnabled(true);
    form->addRow(tr("Folder"), m_folder);
    card->content()->addLayout(form);
    auto *hint
        = new QLabel(tr("The drone sends its video to whoever asked last: a second viewer takes it away."));
    hint->setObjectName(u"muted"_s);
    hint->setWordWrap(true);
    card->content()->addWidget(hint);
    return card;
}

void CameraPage::connectAll()
{
    connect(&m_video, &VideoPipeline::pictureReady, this, [this] {
        const bool isFirst = m_view->picture() == nullptr;
        m_view->setPicture(m_video.picture());
        m_cover->setText({});
        if (isFirst)
            refresh();
    });
    connect(&m_video, &VideoPipeline::stillTaken, this, &CameraPage::onStill);
    connect(&m_video, &VideoPipeline::recordingEnded, this, &CameraPage::onRecordingEnded);
    connect(&m_video, &VideoPipeline::failed, this, [this](const Error &error) { m_trouble = error; });
    connect(m_view, &VideoView::painted, this,
            [this](const std::shared_ptr<const VideoPicture> &picture) { m_video.painted(*picture); });
    connect(m_view, &VideoView::pixelsChanged, this,
            [this](const QSize &pixels) { m_video.setPictureSize(pixels); });
    const auto toggleFull = [this] { m_fullView->setOn(!m_fullView->isOn()); };
    connect(m_view, &VideoView::activated, this, toggleFull);
    connect(m_view, &VideoView::escaped, this, [this] { m_fullView->setOn(false); });
    connect(m_full, &QPushButton::clicked, this, toggleFull);
    connect(new QShortcut(QKeySequence(Qt::Key_F11), this), &QShortcut::activated, this, toggleFull);
    connect(m_record, &QPushButton::clicked, this, &CameraPage::toggleRecording);
    connect(m_still, &QPushButton::clicked, &m_video, &VideoPipeline::takeStill);
    connect(m_folder, &QLineEdit::editingFinished, this, &CameraPage::takeFolder);
    connect(m_address, &QLineEdit::editingFinished, this, &CameraPage::takeAddress);
    connect(&workspace().client(), &DeviceClient::stateChanged, this, &CameraPage::follow);
    // What has to be seen is not seen behind the picture.
    connect(&workspace().client(), &DeviceClient::motorsOffBegun, this, [this] { m_fullView->setOn(false); });
    connect(&workspace().alarms(), &Alarms::changed, this, [this] {
        if (!workspace().alarms().pressing().isEmpty())
            m_fullView->setOn(false);
    });
}

Result<VideoAddress> CameraPage::wantedAddress() const
{
    const DeviceClient &client = workspace().client();
    const QString typed = workspace().settings().videoAddress();
    const LinkAddress link = client.address();
    VideoAddress usual;
    if (link.kind() == LinkAddress::Kind::Udp || link.kind() == LinkAddress::Kind::Tcp)
        usual.host = link.target();
    if (client.state() == DeviceClient::State::Disconnected || link.isReplay())
        return failure(ErrorCode::NotConnected);
    const auto &offer = workspace().links().offerVideo;
    if (link.kind() == LinkAddress::Kind::Simulator && typed.isEmpty() && offer) {
        const auto port = offer(link);
        if (!port)
            return tl::unexpected(port.error());
        return VideoAddress{u"127.0.0.1"_s, *port};
    }
    return VideoAddress::parse(typed, usual);
}

void CameraPage::follow()
{
    const bool isOfUse = (isVisible() || m_video.isRecording())
        && workspace().client().state() != DeviceClient::State::Disconnected;
    m_video.setPaused(!isVisible());
    if (isVisible())
        m_transmitter->ask();
    if (!isOfUse) {
        m_video.stop();
        if (!workspace().client().isConnected())
            m_view->setPicture(nullptr);
        return;
    }
    const auto address = wantedAddress();
    if (!address) {
        m_video.stop();
        m_trouble = address.error();
        return;
    }
    if (!m_video.isRunning() || m_video.address() != *address)
        restart();
}

void CameraPage::restart()
{
    const auto address = wantedAddress();
    if (m_shown != (address ? std::optional(*address) : std::nullopt))
        m_view->setPicture(nullptr);
    m_trouble.reset();
    m_startedAt = Clock::now();
    const auto started = address ? m_video.start(*address) : tl::unexpected(address.error());
    if (!started) {
        m_trouble = started.error();
        return;
    }
    m_shown = *address;
    m_video.setPictureSize(m_view->pixels());
    if (workspace().client().isConnected())
        m_settings->ask();
}

// An address that is none stays as it was typed, and the one before counts.
void CameraPage::takeAddress()
{
    const QString typed = m_address->text().trimmed();
    const auto parsed = VideoAddress::parse(typed, {u"host"_s});
    m_address->setProperty("refused", !parsed);
    repolish(m_address);
    if (!parsed) {
        workspace().notifications().report(parsed.error(), Concern::Entry);
        return;
    }
    workspace().notifications().settle(Concern::Entry);
    if (typed == workspace().settings().videoAddress())
        return;
    workspace().settings().setVideoAddress(typed);
    follow();
}

QString CameraPage::waitingText(const VideoStatistics &statistics) const
{
    if (m_trouble && m_trouble->code == ErrorCode::Unsupported)
        return tr(
            "There is no video: the module libgimbaldesk-video is missing beside this program. Install it "
            "again.");
    if (m_trouble && m_trouble->code == ErrorCode::HostUnreachable)
        return tr("The address %1 is not known in this network. Check it at the right.")
            .arg(m_video.address().toString());
    if (m_trouble || !m_video.isRunning())
        return tr("Connect a drone to see its picture.");
    const QString from = m_video.address().toString();
    if (Clock::now() - m_startedAt < kPatient)
        return tr("Waiting for video from %1 …").arg(from);
    if (statistics.datagrams == 0)
        return tr("No video comes from %1. The drone has no camera, the port is another one, or another "
                  "viewer "
                  "asked for it later.")
            .arg(from);
    if (statistics.frames == 0)
        return tr("What comes from %1 is no video that is known here (H.264, MJPEG).").arg(from);
    return tr("Video comes from %1, and no picture could be decoded so far.").arg(from);
}

QString CameraPage::figuresText(const VideoStatistics &statistics) const
{
    if (statistics.size.isEmpty())
        return {};
    QStringList parts{tr("%1 × %2 %3")
                          .arg(statistics.size.width())
                          .arg(statistics.size.height())
                          .arg(statistics.format == VideoFormat::Mjpeg ? u"MJPEG"_s : u"H.264"_s),
                      tr("%1 frames/s").arg(numberText(statistics.frameRate, 0)),
                      tr("%1 Mbit/s").arg(numberText(statistics.bitRate / 1e6, 1)),
                      statistics.countsLoss() ? tr("%1 % lost").arg(numberText(statistics.lossPercent, 1))
                                              : tr("loss cannot be counted")};
    if (statistics.latency)
        parts.append(tr("%1 ms behind").arg(numberText(asMs(*statistics.latency), 0)));
    return parts.join(u" · "_s);
}

QString CameraPage::figures() const
{
    return m_figures->fullText();
}

void CameraPage::refresh()
{
    m_transmitter->refresh();
    const VideoStatistics statistics = m_video.statistics();
    m_view->setNote(waitingText(statistics));
    const bool hasPicture = m_view->picture() != nullptr;
    const bool isStale = hasPicture && (!statistics.silence || *statistics.silence > kStale);
    m_cover->setText(!isStale ? QString()
                         : statistics.silence
                         ? tr("no picture for %1 s").arg(numberText(seconds(*statistics.silence), 1))
                         : tr("an old picture"));
    QString details = statistics.countsLoss()
        ? tr("%n frame(s) lost", nullptr, int(statistics.lost))
        : tr("Frames of MJPEG have no numbers: how many were lost nobody can tell");
    details += u'\n' + tr("%n damaged picture(s)", nullptr, int(statistics.damaged));
    details += u'\n' + tr("%n frame(s) that could not be decoded", nullptr, int(statistics.undecoded));
    if (statistics.worstLatency)
        details += u'\n'
            + tr("From a frame's first datagram to the screen; at most %1 ms lately")
                  .arg(numberText(asMs(*statistics.worstLatency), 0));
    m_figures->setFullText(figuresText(statistics), details);
    m_still->setEnabled(hasPicture && m_video.isRunning());
    m_still->setToolTip(m_still->isEnabled() ? tr("Saves the picture in its full size (PNG)")
                                             : tr("There is no picture yet."));
    m_record->setEnabled(m_video.isRunning());
    m_full->setEnabled(hasPicture);
    m_full->setToolTip(hasPicture ? tr("F11, or a double click on the picture; Esc leaves it")
                                  : tr("There is no picture yet."));
    const QString usual
        = wantedAddress().map([](const VideoAddress &a) { return a.toString(); }).value_or(QString());
    if (m_address->text().isEmpty())
        m_address->setPlaceholderText(usual);
    showRecording();
}

void CameraPage::showRecording()
{
    const bool isOn = m_video.isRecording();
    workspace().setVideoRecording(isOn ? m_video.recordingState().path : QString());
    m_record->setText(isOn ? tr("Stop recording") : tr("Record"));
    m_record->setObjectName(isOn ? u"danger"_s : QString());
    if (m_record->property("on") != isOn) {
        m_record->setProperty("on", isOn);
        repolish(m_record);
    }
    if (!isOn) {
        m_recording->setFullText({});
        return;
    }
    const VideoRecordingState state = m_video.recordingState();
    if (state.isWaiting) {
        m_recording->setFullText(tr("● waiting for a key frame"));
        return;
    }
    const auto whole = std::chrono::duration_cast<std::chrono::seconds>(state.length).count();
    m_recording->setFullText(
        u"● %1:%2 · %3"_s.arg(whole / 60).arg(whole % 60, 2, 10, QChar(u'0')).arg(sizeText(state.bytes)),
        state.path);
}

void CameraPage::showEvent(QShowEvent *event)
{
    Page::showEvent(event);
    follow();
    refresh();
}

void CameraPage::hideEvent(QHideEvent *event)
{
    Page::hideEvent(event);
    m_fullView->setOn(false);
    follow();
}

QString CameraPage::folder() const
{
    const QString chosen = workspace().settings().videoFolder();
    return chosen.isEmpty() ? defaultVideoFolder() : chosen;
}

// "~" is what a shell would make of it. A folder that cannot be made is told when something is saved.
void CameraPage::takeFolder()
{
    QString typed = m_folder->text().trimmed();
    if (typed == u'~' || typed.startsWith(u"~/"_s))
        typed.replace(0, 1, QDir::homePath());
    m_folder->setText(typed);
    workspace().settings().setVideoFolder(typed);
}

void CameraPage::onStill(const std::shared_ptr<const VideoPicture> &picture)
{
    if (!picture)
        return;
    const auto path = newVideoFile(folder(), u"png"_s);
    const auto saved = path ? saveStill(*picture, *path) : tl::unexpected(path.error());
    workspace().notifications().reportSaved(saved, path.value_or(folder()));
}

void CameraPage::toggleRecording()
{
    if (m_video.isRecording()) {
        m_video.endRecording();
        return;
    }
    const auto path = newVideoFile(folder(), u"mkv"_s);
    const auto started = path ? m_video.startRecording(*path) : tl::unexpected(path.error());
    if (!started)
        workspace().notifications().report(started.error(), Concern::Saving);
    else
        workspace().notifications().settle(Concern::Saving);
    showRecording();
}

void CameraPage::onRecordingEnded(const VideoRecordingState &state)
{
    if (state.frames == 0) {
        QFile::remove(state.path);
        if (state.error)
            workspace().notifications().report(*state.error, Concern::Saving);
        else
            workspace().notifications().notify(
                tr("Nothing was recorded: no frame came that decoding can begin with."), Notice::Attention,
                Concern::Saving);
    } else if (state.error) {
        workspace().notifications().report(*state.error, Concern::Saving);
    } else {
        workspace().notifications().reportSaved({}, state.path);
    }
    showRecording();
    follow();
}
