// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/workspace.h"
#include "protocol/transport/portlist.h"

#include <QElapsedTimer>
#include <QFrame>

class ElidedLabel;
class QComboBox;
class QHBoxLayout;
class QLabel;
class QPushButton;

/// The top of the window: the link, what is looked at, the board's identity, its profile, and the motors
/// button. Where room is short everything else gives way to that button.
class LinkBar final : public QFrame
{
    Q_OBJECT
public:
    explicit LinkBar(Workspace &workspace, QWidget *parent = nullptr);

    /// Puts an address into the field.
    void setAddress(const QString &address);
    void connectOrDisconnect();
    /// Whether everything but the motors button can be used.
    void setLinkEnabled(bool enabled) { m_linkPart->setEnabled(enabled); }
    /// Looks for serial ports on another thread and fills the list.
    void scanPorts();
    [[nodiscard]] QPushButton *connectButton() const { return m_connect; }
    [[nodiscard]] QString stateText() const;
    [[nodiscard]] QPushButton *motorsButton() const { return m_motors; }
    [[nodiscard]] QComboBox *addressBox() const { return m_address; }

signals:
    /// Of a board that is connected; whether it may go is the window's to ask.
    void disconnectRequested();

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void showUsed();
    void showPorts(const QList<PortInfo> &ports);
    void updateState();
    void updateProfiles();
    void updateMotors();
    void updateBadges();
    void updateDot();
    void giveWay();
    void onMotors();
    void keepWidth(QPushButton *button, const QStringList &texts);
    [[nodiscard]] QString typedAddress() const;

    Workspace &m_workspace;
    QWidget *m_linkPart;
    QHBoxLayout *m_linkLayout;
    QComboBox *m_address;
    QPushButton *m_connect;
    QLabel *m_badge;  // what is looked at, if it is no live board
    QLabel *m_recording;
    QLabel *m_dot;
    ElidedLabel *m_state;
    QLabel *m_profileLabel;
    QComboBox *m_profile;
    bool m_hasProfiles = true;  // more than one
    QPushButton *m_motors;
    QTimer m_refresh;
    QString m_progress;
    std::optional<QString> m_typed;  // before the address in use was shown
    bool m_offNext = true;  // what the motors button does when pressed
    QElapsedTimer m_pressedOff;
};
