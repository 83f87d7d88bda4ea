// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/workspace.h"

#include <QWidget>

class QGridLayout;
class QLabel;
class QPushButton;
class QuietQuestion;

/// What the camera of a drone can be told, and what is known to come of it (errata 6.5): most of it cannot be
/// read back.
class PictureSettings final : public QWidget
{
    Q_OBJECT
public:
    explicit PictureSettings(Workspace &workspace, QWidget *parent = nullptr);

    /// Asks the drone for what it tells: sensitivity and shutter.
    void ask();
    [[nodiscard]] QPushButton *button(const QString &key) const { return m_buttons.value(key); }
    [[nodiscard]] QString told(const QString &what) const;

private:
    [[nodiscard]] QWidget *makePicture();
    [[nodiscard]] QWidget *makeLight();
    [[nodiscard]] QWidget *makeOnDrone();
    /// A row with a name, a value and two buttons that step it.
    void addSteps(QGridLayout &grid, const QString &name, const QString &key, int down,
                  const QString &hint = {});
    QPushButton *addButton(const QString &key, const QString &text, const QString &name, const QString &hint,
                           std::function<void()> action);
    QLabel *addValue(const QString &what);
    void perform(const QString &key, const QVariantMap &arguments = {});
    void onTold(const Result<ActionOutcome> &outcome);
    void editLens();
    void openLens(const QVariantMap &values);
    void updateState();

    Workspace &m_workspace;
    QuietQuestion *m_question;
    QHash<QString, QPushButton *> m_buttons;
    QHash<QString, QLabel *> m_values;
    QString m_board;  // that told them
};
