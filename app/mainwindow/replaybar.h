// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/workspace.h"

#include <QFrame>

class QComboBox;
class QLabel;
class QPushButton;
class QSlider;

/// Controls of an open recording: position, pause, speed.
class ReplayBar final : public QFrame
{
    Q_OBJECT
public:
    explicit ReplayBar(Workspace &workspace, QWidget *parent = nullptr);

    [[nodiscard]] QPushButton *pauseButton() const { return m_pause; }
    [[nodiscard]] QSlider *place() const { return m_place; }
    [[nodiscard]] QComboBox *speed() const { return m_speed; }
    [[nodiscard]] QString text() const;

private:
    void showState();
    void seek();

    Workspace &m_workspace;
    QPushButton *m_pause;
    QSlider *m_place;
    QLabel *m_text;
    QComboBox *m_speed;
};
