// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/linkbar.h"

#include "app/workspace/flightstate.h"
#include "app/workspace/question.h"
#include "widgets/models/parametermodel.h"
#include "widgets/views/elidedlabel.h"

#include <QApplication>
#include <QComboBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QSignalBlocker>
#include <QThreadPool>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kMotorsRefresh = 100ms;
// Pressed twice in a hurry, the motors stay off.
constexpr qint64 kNoOnAfterOffMs = 1500;
constexpr int kAddressWidth = 250;
constexpr int kShortAddressWidth = 110;

}  // namespace

LinkBar::LinkBar(Workspace &workspace, QWidget *parent)
    : QFrame(parent)
    , m_workspace(workspace)
    , m_linkPart(new QWidget)
    , m_linkLayout(new QHBoxLayout(m_linkPart))
    , m_address(new QComboBox)
    , m_connect(new QPushButton(tr("Connect")))
    , m_badge(new QLabel)
    , m_recording(new QLabel(tr("● REC")))
    , m_dot(new QLabel)
    , m_state(new ElidedLabel)
    , m_profileLabel(new QLabel(tr("&Profile")))
    , m_profile(new QComboBox)
    , m_motors(new QPushButton)
{
    setObjectName(u"linkBar"_s);
    m_address->setEditable(true);
    m_address->setInsertPolicy(QComboBox::NoInsert);
    m_address->setMinimumWidth(kAddressWidth);
    m_address->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    m_address->setAccessibleName(tr("Port or address of the board"));
    m_address->setToolTip(tr("Serial port, tcp://host:port, udp://host[:port], or a simulated board"));
    m_address->lineEdit()->setPlaceholderText(tr("Port or tcp://host:port"));
    m_connect->setObjectName(u"primary"_s);
    for (QLabel *badge : {m_badge, m_recording}) {
        badge->setObjectName(u"badge"_s);
        badge->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
        badge->hide();
    }
    m_recording->setProperty("kind", u"recording"_s);
    m_dot->setObjectName(u"dot"_s);
    m_state->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    m_profile->setAccessibleName(tr("Active profile"));
    m_profile->setToolTip(tr("Active profile of the board"));
    m_profile->setMinimumWidth(140);
    m_motors->setObjectName(u"motors"_s);
    m_motors->setFocusPolicy(Qt::TabFocus);  // a click leaves the keyboard where it was
    m_profileLabel->setObjectName(u"muted"_s);
    m_profileLabel->setBuddy(m_profile);

    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(Metric::kMargin, Metric::kGap, Metric::kMargin, Metric::kGap);
    layout->setSpacing(Metric::kGap);
    m_linkPart->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_linkLayout->setContentsMargins(0, 0, 0, 0);
    m_linkLayout->setSpacing(Metric::kGap);
    for (QWidget *part : std::initializer_list<QWidget *>{m_address, m_connect, m_badge, m_recording, m_dot})
        m_linkLayout->addWidget(part);
    m_linkLayout->addWidget(m_state, 1);
    m_linkLayout->addWidget(m_profileLabel);
    m_linkLayout->addWidget(m_profile);
    layout->addWidget(m_linkPart, 1);
    layout->addSpacing(Metric::kGap);
    layout->addWidget(m_motors);

    connect(m_connect, &QPushButton::clicked, this, &LinkBar::connectOrDisconnect);
    connect(m_address->lineEdit(), &QLineEdit::returnPressed, this, &LinkBar::connectOrDisconnect);
    connect(m_motors, &QPushButton::clicked, this, &LinkBar::onMotors);
    connect(m_profile, &QComboBox::activated, this, [this](int index) {
        updateProfiles();  // it shows what is in use until the board has switched
        askToUseProfile(m_workspace, index, this, [this] { updateProfiles(); });
    });
    connect(&workspace.client(), &DeviceClient::stateChanged, this, &LinkBar::updateState);
    connect(&workspace.client(), &DeviceClient::progressChanged, this, [this](const Progress &progress) {
        m_progress = describe(progress);
        updateState();
    });
    connect(&workspace.client(), &DeviceClient::busyChanged, this, [this] {
        m_progress.clear();
        updateState();
    });
    connect(&workspace, &Workspace::writeStarted, this, &LinkBar::updateState);
    ConfigurationModel &configuration = workspace.configuration();
    connect(&configuration, &ConfigurationModel::boardReset, this, &LinkBar::updateProfiles);
    connect(&workspace.live(), &LiveModel::heldChanged, this, &LinkBar::updateProfiles);
    connect(&configuration, &ConfigurationModel::profileNamesChanged, this, &LinkBar::updateProfiles);
    connect(&configuration, &ConfigurationModel::activeProfileChanged, this, &LinkBar::updateProfiles);
    connect(&configuration, &ConfigurationModel::shownProfileChanged, this, &LinkBar::updateProfiles);
    connect(&workspace.theme(), &Theme::changed, this, &LinkBar::updateState);
    connect(&configuration, &ConfigurationModel::boardReset, this, &LinkBar::updateBadges);
    connect(&workspace.recorder(), &LinkRecorder::recordingChanged, this, &LinkBar::updateBadges);
    connect(&workspace, &Workspace::videoRecordingChanged, this, &LinkBar::updateBadges);
    connect(&workspace.client(), &DeviceClient::stateChanged, this, [this](DeviceClient::State state) {
        const LinkAddress &address = m_workspace.client().address();
        const bool isKept = !address.isReplay() && address.kind() != LinkAddress::Kind::Simulator;
        if (state == DeviceClient::State::Connected && isKept)
            m_workspace.settings().addRecentAddress(address.toString());
    });
    m_refresh.setInterval(kMotorsRefresh);
    connect(&m_refresh, &QTimer::timeout, this, [this] {
        updateMotors();
        updateDot();
    });
    m_refresh.start();
    keepWidth(m_connect, {tr("Connect"), tr("Cancel"), tr("Give up"), tr("Disconnect")});
    keepWidth(m_motors, {tr("■ STOP MOTORS"), tr("▶ Start motors"), tr("■ STOP (deaf: %1 s)").arg(88)});
    showPorts({});
    updateState();
    updateProfiles();
    scanPorts();
}

// It says now this and now that, and nothing beside it moves.
void LinkBar::keepWidth(QPushButton *button, const QStringList &texts)
{
    const QString before = button->text();
    button->ensurePolished();
    int width = 0;
    for (const QString &text : texts) {
        button->setText(text);
        width = std::max(width, button->sizeHint().width());
    }
    button->setText(before);
    button->setMinimumWidth(width);
}

void LinkBar::resizeEvent(QResizeEvent *event)
{
    QFrame::resizeEvent(event);
    giveWay();
}

// What can be seen elsewhere goes first; the motors button never does.
void LinkBar::giveWay()
{
    const QMargins around = layout()->contentsMargins();
    const int room
        = width() - around.left() - around.right() - m_motors->minimumWidth() - 3 * layout()->spacing();
    m_state->show();
    m_profileLabel->setVisible(m_hasProfiles);
    m_profile->setVisible(m_hasProfiles);
    m_address->setMinimumWidth(kAddressWidth);
    m_address->show();
    m_connect->show();
    const auto isTight = [this, room] { return m_linkLayout->minimumSize().width() > room; };
    for (QWidget *part : std::initializer_list<QWidget *>{m_state, m_profileLabel}) {
        if (isTight())
            part->hide();
    }
    if (isTight())
        m_address->setMinimumWidth(kShortAddressWidth);
    if (isTight())
        m_profile->hide();
    // What is looked at must be read in full; where it is can be asked for again.
    if (isTight() && m_workspace.client().state() != DeviceClient::State::Disconnected)
        m_address->hide();
    // Only a picture on the whole of a small screen leaves less room.
    if (isTight() && m_workspace.client().isConnected())
        m_connect->hide();
}

void LinkBar::setAddress(const QString &address)
{
    const int known = m_address->findData(address);
    if (known >= 0)
        m_address->setCurrentIndex(known);
    else
        m_address->setEditText(address);
    m_address->lineEdit()->home(false);  // of what is too long, the beginning says more
}

void LinkBar::scanPorts()
{
    QThreadPool::globalInstance()->start([self = QPointer<LinkBar>(this)] {
        const QList<PortInfo> ports = listSerialPorts();
        QMetaObject::invokeMethod(
            qApp,
            [self, ports] {
                if (self)
                    self->showPorts(ports);
            },
            Qt::QueuedConnection);
    });
}

void LinkBar::showPorts(const QList<PortInfo> &ports)
{
    const QString before = typedAddress();
    const bool isFirst = m_address->count() == 0;
    const QStringList recent = m_workspace.settings().recentAddresses();
    QList<std::pair<QString, QString>> present;
    for (const PortInfo &port : ports)
        present.append({u"serial:"_s + port.path, port.label()});
    m_address->clear();
    for (const QString &address : recent) {
        const auto port = std::find_if(present.begin(), present.end(),
                                       [&address](const auto &each) { return each.first == address; });
        m_address->addItem(port == present.end() ? address : port->second, address);
    }
    for (const auto &[address, label] : std::as_const(present)) {
        if (!recent.contains(address))
            m_address->addItem(label, address);
    }
    for (const Family &family : m_workspace.client().families()) {
        if (!family.usualAddress.isEmpty() && !recent.contains(family.usualAddress))
            m_address->addItem(tr("%1 at %2").arg(family.name, family.usualAddress), family.usualAddress);
    }
    for (const Family &family : m_workspace.client().families()) {
        if (!family.links.isEmpty())
            m_address->addItem(tr("Simulated %1").arg(family.name), u"sim:"_s + family.key);
    }
    // The last one used, else a port that is there; never a simulated board that nobody asked for.
    const QString first = !recent.isEmpty() ? recent.first()
        : present.isEmpty()                 ? QString()
                                            : present.first().first;
    m_address->setCurrentIndex(-1);
    setAddress(isFirst || before.isEmpty() ? first : before);
}

QString LinkBar::typedAddress() const
{
    const QString text = m_address->currentText().trimmed();
    const int known = m_address->findText(text);
    return known < 0 ? text : m_address->itemData(known).toString();
}

void LinkBar::connectOrDisconnect()
{
    DeviceClient &client = m_workspace.client();
    if (client.isConnected()) {
        emit disconnectRequested();
        return;
    }
    if (client.state() != DeviceClient::State::Disconnected) {
        client.disconnectFromBoard();
        return;
    }
    const auto address = LinkAddress::parse(typedAddress());
    if (!address) {
        m_workspace.notifications().report(address.error());
        return;
    }
    m_workspace.connectTo(*address);
}

QString LinkBar::stateText() const
{
    return m_state->fullText();
}

void LinkBar::updateState()
{
    const DeviceClient &client = m_workspace.client();
    QString text;
    switch (client.state()) {
    case DeviceClient::State::Disconnected:
        text = tr("Not connected");
        m_connect->setText(tr("Connect"));
        break;
    case DeviceClient::State::Connecting:
        text = m_progress.isEmpty() ? tr("Connecting…") : m_progress + u'…';
        m_connect->setText(tr("Cancel"));
        break;
    case DeviceClient::State::Reconnecting:
        text = client.loss() == DeviceClient::Loss::Link ? tr("Link lost, connecting again…")
                                                         : tr("Board restarts, connecting again…");
        m_connect->setText(tr("Give up"));
        break;
    case DeviceClient::State::Connected:
        // A write begins with reading, which is no other work.
        text = m_workspace.isWriting()
            ? (m_progress.isEmpty() ? tr("Writing…") : tr("Writing: %1…").arg(m_progress))
            : client.isBusy() && !m_progress.isEmpty()
            ? m_progress + u'…'
            : tr("%1 · firmware %2").arg(client.identity().model, client.identity().firmware);
        m_connect->setText(tr("Disconnect"));
        break;
    }
    m_state->setFullText(text);
    showUsed();
    m_connect->setObjectName(client.state() == DeviceClient::State::Disconnected ? u"primary"_s : QString());
    repolish(m_connect);
    m_address->setEnabled(client.state() == DeviceClient::State::Disconnected);
    m_profile->setEnabled(!m_workspace.configuration().isEmpty());
    updateDot();
    updateMotors();
    updateBadges();
}

// What is looked at, wherever it was opened; afterwards a recording is no address to connect to again.
void LinkBar::showUsed()
{
    const DeviceClient &client = m_workspace.client();
    const bool isPlayed = client.state() != DeviceClient::State::Disconnected && client.address().isReplay();
    if (isPlayed && !m_typed) {
        m_typed = typedAddress();
        const QString file = QFileInfo(client.address().target()).fileName();
        m_address->setCurrentIndex(-1);
        m_address->setEditText(tr("Recording %1").arg(file));
        m_address->lineEdit()->home(false);
    } else if (!isPlayed && m_typed) {
        setAddress(*std::exchange(m_typed, std::nullopt));
    }
}

// Green is what is alive, not what is connected.
void LinkBar::updateDot()
{
    const Freshness &freshness = m_workspace.freshness();
    const DeviceClient::State state = m_workspace.client().state();
    const bool isAlive = state == DeviceClient::State::Connected && !freshness.staleSince()
        && !freshness.frozenSince() && !freshness.hasPlayed();
    const ColorRole role = isAlive                   ? ColorRole::Ok
        : state == DeviceClient::State::Disconnected ? ColorRole::Muted
                                                     : ColorRole::Warning;
    m_dot->setText(u"<span style='color:%1'>●</span>"_s.arg(m_workspace.theme().color(role).name()));
}

void LinkBar::updateBadges()
{
    const DeviceClient &client = m_workspace.client();
    const bool linked = client.state() != DeviceClient::State::Disconnected;
    const QString file = m_workspace.offlineFile();
    QString text;
    QString meaning;
    QString kind;
    if (linked && client.address().isReplay()) {
        text = tr("REPLAY");
        meaning = tr("A recording is played: nothing here happens now, and nothing can be changed.");
    } else if (linked && client.address().kind() == LinkAddress::Kind::Simulator) {
        text = tr("SIMULATED");
        meaning = client.isConnected() && client.device()->flight()
            ? tr("A simulated drone: no real motor turns.")
            : tr("A simulated gimbal: no real motor moves.");
    } else if (client.isConnected() && !client.identity().writable) {
        text = tr("READ ONLY");
        meaning = tr("Nothing can be written to this board.");
        kind = u"readonly"_s;
    } else if (!linked && !m_workspace.configuration().isEmpty()) {
        text = tr("OFFLINE");
        meaning = file.isEmpty() ? tr("No board is connected: what is shown was read before.")
                                 : tr("No board is connected: what is shown is the file %1.").arg(file);
    }
    m_badge->setText(text);
    m_badge->setAccessibleName(meaning);
    m_badge->setToolTip(meaning);
    m_badge->setProperty("kind", kind);
    repolish(m_badge);
    m_badge->setVisible(!text.isEmpty());
    const LinkRecorder &recorder = m_workspace.recorder();
    QStringList recorded;
    if (recorder.isRecording())
        recorded.append(tr("The link is being recorded to %1").arg(recorder.path()));
    if (const QString &video = m_workspace.videoRecording(); !video.isEmpty())
        recorded.append(tr("The video is being recorded to %1").arg(video));
    m_recording->setVisible(!recorded.isEmpty());
    m_recording->setToolTip(recorded.join(u'\n'));
    m_recording->setAccessibleName(m_recording->toolTip());
    setProperty("marked", !text.isEmpty() && kind.isEmpty());
    repolish(this);
    giveWay();
}

void LinkBar::updateProfiles()
{
    const QSignalBlocker blocker(m_profile);
    m_profile->clear();
    const ConfigurationModel &model = m_workspace.configuration();
    m_hasProfiles = model.isEmpty() || model.board().identity().profileCount >= 2;
    giveWay();
    if (model.isEmpty())
        return;
    for (int profile = 0; profile < model.board().identity().profileCount; ++profile)
        m_profile->addItem(u"%1  %2"_s.arg(profile + 1).arg(profileLabel(model.edited(), profile)));
    const bool onBoard = m_workspace.client().isConnected() && !m_workspace.client().address().isReplay();
    m_profile->setCurrentIndex(onBoard ? model.board().activeProfile() : model.shownProfile());
    m_profile->setEnabled(!m_workspace.live().isHeld());
}

void LinkBar::updateMotors()
{
    // There are no motors in a recording. While the link is down, a stop is kept for when it is back.
    const bool linked = m_workspace.client().state() != DeviceClient::State::Disconnected
        && !m_workspace.client().address().isReplay();
    const auto running = m_workspace.motorsRunning();
    // An unknown state counts as running: the button must be able to stop them.
    // So does a board without a command to switch them on: there the button can only stop.
    const Device *device = m_workspace.client().device();
    const bool canSwitchOn = linked && device && device->motorSwitch();
    // And a board that starts: its motors run soon.
    const bool mayRun = !running || *running || m_workspace.isStarting() || m_workspace.isDeaf();
    m_offNext = mayRun || !canSwitchOn;
    const bool tooSoon = !m_offNext && m_pressedOff.isValid() && m_pressedOff.elapsed() < kNoOnAfterOffMs;
    const bool isItsStep = !m_offNext && m_workspace.isGuided();
    // Beneath a panel it only stops.
    m_motors->setEnabled(linked && !tooSoon && !isItsStep && (m_offNext || m_linkPart->isEnabled()));
    const double deaf = seconds(m_workspace.client().deafUntil() - Clock::now());
    const QString text = !m_offNext ? tr("▶ Start motors")
        : deaf > 0                  ? tr("■ STOP (deaf: %1 s)").arg(int(std::ceil(deaf)))
                                    : tr("■ STOP MOTORS");
    if (m_motors->text() != text) {
        m_motors->setText(text);
        m_motors->setAccessibleName(m_offNext ? tr("Stop motors") : tr("Start motors"));
    }
    // What is armed, or does not say that it is not, may run at any moment.
    const int armed = m_workspace.roles().armed;
    const QString tip = armed < 0 ? tr("F12 stops the motors from anywhere")
                                  : tr("F12 stops the motors from anywhere, in flight as well: it falls");
    if (m_motors->toolTip() != tip)
        m_motors->setToolTip(tip);
    const bool mayBeArmed = armed >= 0 && freshlyTold(m_workspace, armed).value_or(true);
    const bool red = linked && (mayRun || mayBeArmed);
    if (m_motors->property("running").toBool() != red) {
        m_motors->setProperty("running", red);
        repolish(m_motors);
    }
}

void LinkBar::onMotors()
{
    if (!m_offNext) {
        askToStartMotors(m_workspace, this);
        return;
    }
    m_pressedOff.start();
    m_workspace.setMotors(false);
}
