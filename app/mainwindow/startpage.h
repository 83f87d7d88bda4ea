// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QVBoxLayout;

/// The first thing a new operator sees: connect, open a file, or try the simulated gimbal; and what an
/// earlier run has left.
class StartPage final : public QWidget
{
    Q_OBJECT
public:
    explicit StartPage(QWidget *parent = nullptr);

    /// Files with unsaved edits of earlier runs.
    void setLeftovers(const QStringList &bases);
    /// What was looked at lately, the latest first.
    void setRecent(const QStringList &addresses, const QStringList &files);

signals:
    void connectRequested();
    void demoRequested();
    void fileRequested();
    void leftoverRequested(const QString &base);
    void addressRequested(const QString &address);
    void pathRequested(const QString &path);

private:
    QVBoxLayout *m_leftovers;
    QVBoxLayout *m_recent;
};
