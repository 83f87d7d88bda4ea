// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/linkbar.h"

#include "widgets/models/parametermodel.h"

#include <QApplication>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QSignalBlocker>
#include <QThreadPool>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kMotorsRefresh = 100ms;
// Pressed twice in a hurry, the motors stay off.
constexpr qint64 kNoOnAfterOffMs = 1500;

}  // namespace

LinkBar::LinkBar(Workspace &workspace, QWidget *parent)
    : QFrame(parent)
    , m_workspace(workspace)
    , m_linkPart(new QWidget)
    , m_address(new QComboBox)
    , m_connect(new QPushButton(tr("Connect")))
    , m_state(new QLabel)
    , m_profileLabel(new QLabel(tr("&Profile")))
    , m_profile(new QComboBox)
    , m_motors(new QPushButton)
{
    setObjectName(u"bar"_s);
    m_address->setEditable(true);
    m_address->setInsertPolicy(QComboBox::NoInsert);
    m_address->setMinimumWidth(250);
    m_address->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    m_address->setAccessibleName(tr("Port or address of the board"));
    m_address->setToolTip(tr("Serial port, tcp://host:port, or the simulated gimbal"));
    m_address->lineEdit()->setPlaceholderText(tr("Port or tcp://host:port"));
    m_connect->setObjectName(u"primary"_s);
    m_state->setTextFormat(Qt::RichText);
    m_state->setMinimumWidth(80);
    m_state->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_profile->setAccessibleName(tr("Active profile"));
    m_profile->setToolTip(tr("Active profile of the board"));
    m_profile->setMinimumWidth(140);
    m_motors->setObjectName(u"motors"_s);
    m_motors->setFocusPolicy(Qt::TabFocus);  // a click leaves the keyboard where it was
    m_motors->setToolTip(tr("F12 switches the motors off from anywhere"));
    m_profileLabel->setObjectName(u"muted"_s);
    m_profileLabel->setBuddy(m_profile);

    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(Metric::kMargin, Metric::kGap, Metric::kMargin, Metric::kGap);
    layout->setSpacing(Metric::kGap);
    auto *linkLayout = new QHBoxLayout(m_linkPart);
    linkLayout->setContentsMargins(0, 0, 0, 0);
    linkLayout->setSpacing(Metric::kGap);
    linkLayout->addWidget(m_address);
    linkLayout->addWidget(m_connect);
    linkLayout->addSpacing(Metric::kGap);
    linkLayout->addWidget(m_state, 1);
    linkLayout->addWidget(m_profileLabel);
    linkLayout->addWidget(m_profile);
    layout->addWidget(m_linkPart, 1);
    layout->addSpacing(Metric::kGap);
    layout->addWidget(m_motors);

    connect(m_connect, &QPushButton::clicked, this, &LinkBar::connectOrDisconnect);
    connect(m_address->lineEdit(), &QLineEdit::returnPressed, this, &LinkBar::connectOrDisconnect);
    connect(m_motors, &QPushButton::clicked, this, &LinkBar::onMotors);
    connect(m_profile, &QComboBox::activated, this, [this](int index) { m_workspace.useProfile(index); });
    connect(&workspace.client(), &DeviceClient::stateChanged, this, &LinkBar::updateState);
    connect(&workspace.client(), &DeviceClient::progressChanged, this, [this](const Progress &progress) {
        m_progress = describe(progress);
        updateState();
    });
    connect(&workspace.client(), &DeviceClient::busyChanged, this, [this] {
        m_progress.clear();
        updateState();
    });
    ConfigurationModel &configuration = workspace.configuration();
    connect(&configuration, &ConfigurationModel::boardReset, this, &LinkBar::updateProfiles);
    connect(&configuration, &ConfigurationModel::profileNamesChanged, this, &LinkBar::updateProfiles);
    connect(&configuration, &ConfigurationModel::activeProfileChanged, this, &LinkBar::updateProfiles);
    connect(&configuration, &ConfigurationModel::shownProfileChanged, this, &LinkBar::updateProfiles);
    connect(&workspace.theme(), &Theme::changed, this, &LinkBar::updateState);
    m_refresh.setInterval(kMotorsRefresh);
    connect(&m_refresh, &QTimer::timeout, this, &LinkBar::updateMotors);
    m_refresh.start();
    showPorts({});
    updateState();
    updateProfiles();
    scanPorts();
}

void LinkBar::setAddress(const QString &address)
{
    const int known = m_address->findData(address);
    if (known >= 0)
        m_address->setCurrentIndex(known);
    else
        m_address->setEditText(address);
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
    const QString typed = m_address->currentText();
    const bool chosen = m_address->count() > 0;
    m_address->clear();
    for (const PortInfo &port : ports)
        m_address->addItem(port.label(), u"serial:"_s + port.path);
    for (const Family &family : m_workspace.client().families())
        m_address->addItem(tr("Simulated %1").arg(family.name), u"sim:"_s + family.key);
    if (chosen)
        m_address->setEditText(typed);
}

void LinkBar::connectOrDisconnect()
{
    DeviceClient &client = m_workspace.client();
    if (client.state() != DeviceClient::State::Disconnected) {
        client.disconnectFromBoard();
        return;
    }
    QString text = m_address->currentText().trimmed();
    const int known = m_address->findText(text);
    if (known >= 0)
        text = m_address->itemData(known).toString();
    const auto address = LinkAddress::parse(text);
    if (!address) {
        m_workspace.notifications().report(address.error());
        return;
    }
    m_workspace.connectTo(*address);
}

void LinkBar::updateState()
{
    const DeviceClient &client = m_workspace.client();
    const Theme &theme = m_workspace.theme();
    QString dot = theme.color(ColorRole::Muted).name();
    QString text;
    switch (client.state()) {
    case DeviceClient::State::Disconnected:
        text = tr("Not connected");
        m_connect->setText(tr("Connect"));
        break;
    case DeviceClient::State::Connecting:
        dot = theme.color(ColorRole::Warning).name();
        text = m_progress.isEmpty() ? tr("Connecting…") : m_progress + u'…';
        m_connect->setText(tr("Cancel"));
        break;
    case DeviceClient::State::Reconnecting:
        dot = theme.color(ColorRole::Warning).name();
        text = tr("Link lost, connecting again…");
        m_connect->setText(tr("Give up"));
        break;
    case DeviceClient::State::Connected:
        dot = theme.color(ColorRole::Ok).name();
        text = client.isBusy() && !m_progress.isEmpty()
            ? m_progress + u'…'
            : tr("%1 · firmware %2").arg(client.identity().model, client.identity().firmware);
        m_connect->setText(tr("Disconnect"));
        break;
    }
    m_state->setText(u"<span style='color:%1'>●</span> %2"_s.arg(dot, text.toHtmlEscaped()));
    m_state->setToolTip(text);
    m_connect->setObjectName(client.state() == DeviceClient::State::Disconnected ? u"primary"_s : QString());
    repolish(m_connect);
    m_address->setEnabled(client.state() == DeviceClient::State::Disconnected);
    m_profile->setEnabled(!m_workspace.configuration().isEmpty());
    updateMotors();
}

void LinkBar::updateProfiles()
{
    const QSignalBlocker blocker(m_profile);
    m_profile->clear();
    const ConfigurationModel &model = m_workspace.configuration();
    const bool isOnlyOne = !model.isEmpty() && model.board().identity().profileCount < 2;
    m_profileLabel->setVisible(!isOnlyOne);
    m_profile->setVisible(!isOnlyOne);
    if (model.isEmpty())
        return;
    for (int profile = 0; profile < model.board().identity().profileCount; ++profile)
        m_profile->addItem(u"%1  %2"_s.arg(profile + 1).arg(profileLabel(model.edited(), profile)));
    m_profile->setCurrentIndex(model.shownProfile());
    m_profile->setEnabled(true);
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
    const bool canSwitchOn = !linked || (device && device->motorSwitch());
    m_offNext = !running || *running || !canSwitchOn;
    const bool tooSoon = !m_offNext && m_pressedOff.isValid() && m_pressedOff.elapsed() < kNoOnAfterOffMs;
    const bool isItsStep = !m_offNext && m_workspace.isGuided();
    m_motors->setEnabled(linked && !tooSoon && !isItsStep);
    const QString text = m_offNext ? tr("■ MOTORS OFF") : tr("▶ Motors on");
    if (m_motors->text() != text) {
        m_motors->setText(text);
        m_motors->setAccessibleName(m_offNext ? tr("Switch motors off") : tr("Switch motors on"));
    }
    const bool red = linked && (!running || *running);
    if (m_motors->property("running").toBool() != red) {
        m_motors->setProperty("running", red);
        repolish(m_motors);
    }
}

void LinkBar::onMotors()
{
    if (m_offNext)
        m_pressedOff.start();
    m_workspace.setMotors(!m_offNext);
}
