// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QProcess>

/// The whole tour in every appearance: runs this program once per theme and scale, one after the other.
class TourRunner final : public QObject
{
    Q_OBJECT
public:
    TourRunner(QString folder, QStringList moreArguments, QObject *parent = nullptr);
    void start();

signals:
    /// Lines with paths; an error is empty when all went well.
    void finished(const QString &paths, const QString &error);

private:
    void next();

    QString m_folder;
    QStringList m_more;
    QProcess m_process;
    int m_at = 0;
    QString m_paths;
};
