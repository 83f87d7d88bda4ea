// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/workspace.h"

#include <QDialog>

class QButtonGroup;
class QCheckBox;
class QLabel;
class QLineEdit;

/// Which board without a serial number it is: one that has a name, or a new one.
class BoardNameDialog final : public QDialog
{
    Q_OBJECT
public:
    explicit BoardNameDialog(Workspace &workspace, QWidget *parent = nullptr);

private:
    void makeBody();
    void makeButtons();
    void update();
    void take();
    [[nodiscard]] QString chosen() const;

    Workspace &m_workspace;
    QStringList m_names;
    QButtonGroup *m_which;
    QLineEdit *m_name;
    QCheckBox *m_store;
    QLabel *m_problem;
    QPushButton *m_take;
};
