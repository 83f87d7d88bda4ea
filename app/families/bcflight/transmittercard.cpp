// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/bcflight/transmittercard.h"

#include "app/families/bcflight/cardlabels.h"
#include "app/families/bcflight/droneobstacle.h"
#include "app/families/bcflight/quietquestion.h"
#include "protocol/bcflight/transmitter.h"
#include "protocol/client/whendone.h"
#include "widgets/models/errortext.h"
#include "widgets/models/parametermodel.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

TransmitterCard::TransmitterCard(Workspace &workspace, QWidget *parent)
    : Card(tr("Video transmitter"), parent)
    , m_workspace(workspace)
    , m_question(new QuietQuestion(
          workspace, u"vtx"_s, [this](const Result<ActionOutcome> &outcome) { onTold(outcome); }, this))
    , m_told(wrappedLabel())
    , m_band(new QComboBox)
    , m_channel(new QComboBox)
    , m_power(new QComboBox)
    , m_setChannel(new QPushButton(tr("Set")))
    , m_setPower(new QPushButton(tr("Set")))
    , m_why(wrappedLabel({}, "muted"))
    , m_said(wrappedLabel())
{
    for (const bcflight::TransmitterBand &band : bcflight::kTransmitterBands)
        m_band->addItem(tableText(band.name), QLatin1String(band.name));
    m_band->setCurrentIndex(-1);  // before anything is known
    m_setChannel->setAccessibleName(tr("Set band and channel"));
    m_setPower->setAccessibleName(tr("Set the power"));
    auto *grid = new QGridLayout;
    grid->setColumnStretch(1, 1);
    addRow(*grid, tr("Band"), m_band);
    addRow(*grid, tr("Channel"), m_channel, m_setChannel);
    addRow(*grid, tr("Power"), m_power, m_setPower);
    content()->addWidget(m_told);
    content()->addLayout(grid);
    content()->addWidget(m_why);
    content()->addWidget(m_said);
    connect(m_band, &QComboBox::currentIndexChanged, this, &TransmitterCard::fillChannels);
    connect(m_setChannel, &QPushButton::clicked, this, [this] {
        set(u"vtx.channel"_s,
            {{u"band"_s, m_band->currentIndex()}, {u"channel"_s, m_channel->currentIndex() + 1}});
    });
    connect(m_setPower, &QPushButton::clicked, this, [this] {
        set(u"vtx.power"_s, {{u"power"_s, m_power->currentIndex() + 1}});
    });
    connect(&workspace.client(), &DeviceClient::stateChanged, this, [this] {
        if (!m_workspace.client().isConnected())
            forget();
        refresh();
    });
    m_said->hide();
    forget();
    refresh();
}

void TransmitterCard::addRow(QGridLayout &grid, const QString &name, QComboBox *field, QPushButton *button)
{
    const int row = grid.rowCount();
    auto *label = new QLabel(name);
    label->setBuddy(field);
    field->setAccessibleName(name);
    field->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    grid.addWidget(label, row, 0);
    grid.addWidget(field, row, 1);
    if (button)
        grid.addWidget(button, row, 2);
}

void TransmitterCard::fillChannels()
{
    const int chosen = m_channel->currentIndex();
    m_channel->clear();
    const auto &frequencies = bcflight::kTransmitterBands.at(std::size_t(m_band->currentIndex())).mhz;
    for (int i = 0; i < bcflight::kBandChannels; ++i)
        m_channel->addItem(tr("%1: %2 MHz").arg(i + 1).arg(frequencies[std::size_t(i)]));
    m_channel->setCurrentIndex(chosen);
}

QString TransmitterCard::told() const
{
    return m_told->text();
}

QString TransmitterCard::said() const
{
    return m_said->text();
}

QString TransmitterCard::obstacle() const
{
    return droneObstacle(m_workspace, Calibration::NotNeeded);
}

void TransmitterCard::ask()
{
    if (m_workspace.client().isConnected() && m_workspace.client().identity().writable)
        m_question->ask();
}

void TransmitterCard::refresh()
{
    const QString why = obstacle();
    const bool isFree = why.isEmpty() && m_isKnown && !m_isSetting;
    for (QWidget *widget :
         std::initializer_list<QWidget *>{m_band, m_channel, m_power, m_setChannel, m_setPower})
        widget->setEnabled(isFree);
    m_why->setText(why);
    m_why->setVisible(!why.isEmpty());
}

void TransmitterCard::set(const QString &action, const QVariantMap &arguments)
{
    m_isSetting = true;
    sayIn(*m_said, {}, "");
    refresh();
    whenDone(m_workspace.perform(action, arguments), this, [this](const Result<ActionOutcome> &outcome) {
        m_isSetting = false;
        if (outcome) {
            sayIn(*m_said, tr("✓ Set, and read back."), "ok");
            take(outcome->reply);
        } else {
            sayIn(*m_said, tr("✖ Not set. What it sends with is read again."), "error");
            forget();
            ask();
        }
        refresh();
    });
}

void TransmitterCard::onTold(const Result<ActionOutcome> &outcome)
{
    if (outcome) {
        take(outcome->reply);
    } else {
        forget();
        m_told->setText(
            outcome.error().code == ErrorCode::Unsupported
                ? tr("The drone says that it has no video transmitter.")
                : tr("What it sends with could not be read: %1").arg(describe(outcome.error()).oneLine()));
    }
    refresh();
}

// What is chosen follows what it sends with, unless it is what it was before: then somebody may be choosing.
void TransmitterCard::take(const ActionReply &reply)
{
    const QString name = reply.value(u"band"_s).toString();
    const int channel = reply.value(u"channel"_s).toInt();
    const int frequency = reply.value(u"frequency"_s).toInt();
    const int power = reply.value(u"power"_s).toInt();
    const QStringList powers = reply.value(u"powers"_s).toString().split(u' ', Qt::SkipEmptyParts);
    const int band = m_band->findData(name);
    const int listed = bcflight::kTransmitterBands.at(std::size_t(band)).mhz.at(std::size_t(channel - 1));
    QStringList lines{tr("Sends in the band %1 on channel %2, at %3 MHz, with %4 dBm (step %5 of %6).")
                          .arg(m_band->itemText(band))
                          .arg(channel)
                          .arg(frequency)
                          .arg(reply.value(u"power.dbm"_s).toInt())
                          .arg(power)
                          .arg(powers.size())};
    if (frequency != listed)
        lines.append(tr("⚠ In the list of bands this channel has %1 MHz.").arg(listed));
    m_told->setText(lines.join(u' '));
    m_isKnown = true;
    if (std::exchange(m_reply, reply) == reply)
        return;
    m_power->clear();
    for (int i = 0; i < powers.size(); ++i)
        m_power->addItem(tr("%1: %2 dBm").arg(i + 1).arg(powers[i]));
    m_power->setCurrentIndex(power - 1);
    m_band->setCurrentIndex(band);
    m_channel->setCurrentIndex(channel - 1);
}

void TransmitterCard::forget()
{
    m_isKnown = false;
    m_told->setText(tr("What it sends with is not known yet."));
}
