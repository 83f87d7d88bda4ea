// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

class MainWindow;

/// Visits every page with a living board and writes one PNG of each.
class Tour final : public QObject
{
    Q_OBJECT
public:
    /// Pictures go to this folder, which is made if need be.
    Tour(MainWindow &window, QString folder, QString suffix, QObject *parent = nullptr);

signals:
    /// Paths of the pictures; empty when something failed, then the error says what.
    void finished(const QStringList &pictures, const QString &error);

private:
    void next();
    bool save(QWidget *widget, const QString &name);
    void fail(const QString &error);

    MainWindow &m_window;
    QString m_folder;
    QString m_suffix;
    QTimer m_step;
    QTimer m_limit;
    int m_stage = -1;
    QStringList m_pictures;
};
