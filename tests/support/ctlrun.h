// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/patience.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTest>

/// What a run of gimbalctl printed.
struct Run
{
    int exitCode = -1;
    QString out;
    QString err;
    [[nodiscard]] QJsonObject json() const { return QJsonDocument::fromJson(out.toUtf8()).object(); }
};

/// gimbalctl, or that of another composition, while it runs. What it prints goes to files, so that it can be
/// watched.
class Running
{
public:
    /// @param folder for what it prints and, in `history`, for snapshots
    Running(const QString &folder, const QStringList &arguments,
            const QString &program = QStringLiteral("gimbalctl"))
        : m_out(folder + QStringLiteral("/out"))
        , m_err(folder + QStringLiteral("/err"))
    {
        m_process.setStandardOutputFile(m_out);
        m_process.setStandardErrorFile(m_err);
        m_process.start(QStringLiteral(GIMBAL_BIN_DIR "/") + program,
                        QStringList{QStringLiteral("--history"), folder + QStringLiteral("/history")}
                            + arguments);
    }
    ~Running()
    {
        m_process.kill();
        m_process.waitForFinished();
    }
    Running(const Running &) = delete;
    Running &operator=(const Running &) = delete;

    [[nodiscard]] QString printed() const { return text(m_out); }
    [[nodiscard]] QString told() const { return text(m_err); }
    [[nodiscard]] bool isRunning() const { return m_process.state() != QProcess::NotRunning; }
    [[nodiscard]] qint64 id() const { return m_process.processId(); }
    /// From one moment to the next, without a farewell.
    void kill()
    {
        m_process.kill();
        m_process.waitForFinished();
    }
    Run finish(int ms = kPatience)
    {
        if (!QTest::qWaitFor([this] { return m_process.state() == QProcess::NotRunning; }, ms)) {
            qWarning("%s does not end: %s", qPrintable(m_process.arguments().join(u' ')),
                     qPrintable(text(m_err)));
            return {-1, text(m_out), QStringLiteral("it does not end: ") + text(m_err)};
        }
        return {m_process.exitCode(), text(m_out), text(m_err)};
    }

private:
    static QString text(const QString &path)
    {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
    }

    QString m_out;
    QString m_err;
    QProcess m_process;
};
