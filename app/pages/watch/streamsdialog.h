// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/workspace.h"

#include <QDialog>

class NumberBox;
class QCheckBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QRadioButton;

/// Which streams the board sends and how often, and the share of the link that this takes.
class StreamsDialog final : public QDialog
{
    Q_OBJECT
public:
    StreamsDialog(Workspace &workspace, QWidget *parent = nullptr);

    [[nodiscard]] QRadioButton *byHand() const { return m_byHand; }
    [[nodiscard]] QCheckBox *check(const QString &stream) const;
    [[nodiscard]] NumberBox *rate(const QString &stream) const;
    [[nodiscard]] QLabel *verdict() const { return m_verdict; }

protected:
    void showEvent(QShowEvent *event) override;

private:
    struct Row
    {
        StreamSpec spec;
        QCheckBox *check;
        NumberBox *rate;
        QLabel *use;
    };
    [[nodiscard]] QList<StreamChoice> chosen() const;
    void update();

    Workspace &m_workspace;
    QRadioButton *m_automatic;
    QRadioButton *m_byHand;
    std::vector<Row> m_rows;
    QProgressBar *m_line;
    QLabel *m_verdict;
    QPushButton *m_apply;
};
