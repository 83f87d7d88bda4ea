// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"

class NumberBox;
class QCheckBox;
class QComboBox;
class QScrollArea;

/// What the operator can choose about the program itself.
class SettingsPage final : public Page
{
    Q_OBJECT
public:
    explicit SettingsPage(Workspace &workspace, QWidget *parent = nullptr);

    [[nodiscard]] std::any keep() override;
    void resume(const std::any &kept) override;

private:
    struct Kept
    {
        int scrolled = 0;
        bool languageHasFocus = false;
    };
    void fillFields();
    void makeBody();
    void connectAll();
    void updateNotes();

    QComboBox *m_theme;
    QComboBox *m_language;
    QComboBox *m_temperature;
    NumberBox *m_retention;
    NumberBox *m_escape;
    NumberBox *m_speed;
    NumberBox *m_disarm;
    QCheckBox *m_offOnQuit;
    QCheckBox *m_askMotors;
    QScrollArea *m_scroll;
    QLabel *m_memory;
    QString m_madeIn;  // the language
    QLabel *m_wait;
    QTimer m_patience;
};
