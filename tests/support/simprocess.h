// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/patience.h"

#include <QProcess>
#include <QTest>

#include <sys/resource.h>
#include <tuple>

/// A running gimbalsim, or one of another composition, ended by its process id.
class SimProcess
{
public:
    explicit SimProcess(const QStringList &arguments, const QString &family = QStringLiteral("simplebgc"),
                        const QString &program = QStringLiteral("gimbalsim"))
    {
        m_process.setProgram(QStringLiteral(GIMBAL_BIN_DIR "/") + program);
        m_process.setArguments(QStringList{QStringLiteral("--family"), family} + arguments);
        // A board has a processor of its own: it answers in time while the machine compiles. Only root may
        // ask for that.
        m_process.setChildProcessModifier([] { setpriority(PRIO_PROCESS, 0, -15); });
        m_process.start();
        std::ignore = QTest::qWaitFor(
            [this] { return m_process.canReadLine() || m_process.state() == QProcess::NotRunning; },
            kPatience);
        const QByteArray line = m_process.readLine().trimmed();
        if (line.startsWith("ready "))
            m_address = QString::fromLocal8Bit(line.mid(6));
    }
    ~SimProcess() { stop(); }
    SimProcess(const SimProcess &) = delete;
    SimProcess &operator=(const SimProcess &) = delete;

    /// What follows "ready"; empty if it did not start.
    [[nodiscard]] const QString &address() const { return m_address; }
    /// Exit code after SIGTERM.
    int stop()
    {
        if (m_process.state() == QProcess::NotRunning)
            return m_process.exitCode();
        m_process.terminate();
        std::ignore
            = QTest::qWaitFor([this] { return m_process.state() == QProcess::NotRunning; }, kPatience);
        return m_process.exitStatus() == QProcess::NormalExit ? m_process.exitCode() : -1;
    }
    QProcess &process() { return m_process; }
    /// Frames of data streams so far.
    struct Streams
    {
        quint64 all = 0;
        quint64 skipped = 0;
    };
    Streams streams()
    {
        m_process.write("streams\n");
        std::ignore = QTest::qWaitFor([this] { return m_process.canReadLine(); }, kPatience);
        const QList<QByteArray> words = m_process.readLine().simplified().split(' ');
        return {words.value(2).toULongLong() + words.value(4).toULongLong(), words.value(4).toULongLong()};
    }

private:
    QProcess m_process;
    QString m_address;
};
