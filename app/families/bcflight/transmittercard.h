// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/workspace.h"
#include "widgets/views/card.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QuietQuestion;

/// The analog video transmitter of a drone: what it sends with, as it was read, and another channel or power
/// for it (errata 6.6).
class TransmitterCard final : public Card
{
    Q_OBJECT
public:
    explicit TransmitterCard(Workspace &workspace, QWidget *parent = nullptr);

    /// Asks the drone what it sends with.
    void ask();
    /// Looks again whether it can be set now.
    void refresh();
    [[nodiscard]] QString told() const;
    [[nodiscard]] QString said() const;
    /// Why it cannot be set now; empty: it can.
    [[nodiscard]] QString obstacle() const;
    [[nodiscard]] QComboBox *band() const { return m_band; }
    [[nodiscard]] QComboBox *channel() const { return m_channel; }
    [[nodiscard]] QComboBox *power() const { return m_power; }
    [[nodiscard]] QPushButton *channelButton() const { return m_setChannel; }
    [[nodiscard]] QPushButton *powerButton() const { return m_setPower; }

private:
    void addRow(QGridLayout &grid, const QString &name, QComboBox *field, QPushButton *button = nullptr);
    /// The channels of the band that is chosen.
    void fillChannels();
    void set(const QString &action, const QVariantMap &arguments);
    void onTold(const Result<ActionOutcome> &outcome);
    void take(const ActionReply &reply);
    void forget();

    Workspace &m_workspace;
    QuietQuestion *m_question;
    QLabel *m_told;
    QComboBox *m_band;
    QComboBox *m_channel;
    QComboBox *m_power;
    QPushButton *m_setChannel;
    QPushButton *m_setPower;
    QLabel *m_why;
    QLabel *m_said;
    ActionReply m_reply;  // what it sent with when that was read last
    bool m_isKnown = false;  // that it still does
    bool m_isSetting = false;
};
