// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/watch/monitorpage.h"
#include "protocol/telemetry/telemetryplan.h"
#include "tests/bench/report.h"
#include "tests/support/simprocess.h"
#include "tests/support/windowrig.h"

#include <QDir>
#include <QElapsedTimer>
#include <QFile>

#include <mutex>
#include <unistd.h>

using namespace Qt::StringLiterals;

namespace {

constexpr int kStatus = 25;  // REALTIME_DATA_4

/// Hears frames after they are in the store: how long that took since their bytes were read.
class Watch final : public FrameListener
{
public:
    void frameReceived(const FrameView &frame, TimePoint at, bool) override
    {
        if (frame.id != kStatus)
            return;
        const std::lock_guard lock(m_mutex);
        ++m_frames;
        m_ms.push_back(seconds(Clock::now() - at) * 1000.0);
    }
    quint64 frames()
    {
        const std::lock_guard lock(m_mutex);
        return m_frames;
    }
    std::vector<double> latencies()
    {
        const std::lock_guard lock(m_mutex);
        return m_ms;
    }

private:
    std::mutex m_mutex;
    quint64 m_frames = 0;
    std::vector<double> m_ms;
};

// Processor milliseconds of each thread, by name.
QMap<QString, double> threadTimes()
{
    QMap<QString, double> times;
    const QDir tasks(u"/proc/self/task"_s);
    for (const QString &task : tasks.entryList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        QFile stat(tasks.filePath(task + u"/stat"_s));
        if (!stat.open(QIODevice::ReadOnly))
            continue;
        const QByteArray text = stat.readAll();
        const qsizetype close = text.lastIndexOf(')');
        const QString name
            = QString::fromUtf8(text.mid(text.indexOf('(') + 1, close - text.indexOf('(') - 1));
        const QList<QByteArray> fields = text.mid(close + 2).split(' ');
        times[name] += (fields.value(11).toDouble() + fields.value(12).toDouble()) * 1000.0
            / double(::sysconf(_SC_CLK_TCK));
    }
    return times;
}

}  // namespace

void benchEndToEnd(Report &report, int seconds)
{
    const QTemporaryDir folder;
    SimProcess simulator({u"--pty"_s, folder.filePath(u"board"_s)});
    WindowRig rig;
    if (!rig.open(simulator.address()))
        qFatal("no board");
    auto *monitor = rig.page<MonitorPage>();
    const ChannelRoles &roles = rig.workspace().roles();
    QList<int> channels;
    for (const auto &triple : {roles.angle, roles.target, roles.gyro, roles.acc})
        channels.append(QList<int>(triple.begin(), triple.end()));
    std::sort(channels.begin(), channels.end());
    monitor->channels().setTicked(channels);
    const auto quiet = [&rig] {
        auto stopped = rig.client().submit<bool>([bytes = rig.client().telemetryPlan().shutdownFrames](
                                                     Channel &channel, Device &) -> Result<bool> {
            Request request;
            request.bytes = bytes;
            channel.post(request);
            return true;
        });
        std::ignore = QTest::qWaitFor([&] { return stopped.isFinished(); }, 5000);
        QTest::qWait(300);
    };
    // Counted from one silence to the next, so that not a frame is in flight.
    QTest::qWait(500);
    quiet();
    const quint64 sentBefore = simulator.streams().all;
    Watch watch;
    rig.client().addListener(watch);
    rig.workspace().telemetry().setStreams({{u"realtime4"_s, 1250, {}}});
    if (!QTest::qWaitFor([&] { return rig.client().telemetryPlan().rate == 1250.0; }, 5000))
        qFatal("no stream");
    QTest::qWait(1000);
    PaintCounter paints;
    monitor->plots().first()->viewport()->installEventFilter(&paints);
    const QMap<QString, double> before = threadTimes();
    QElapsedTimer timer;
    timer.start();
    waitFor(seconds * 1000);
    const double elapsed = double(timer.elapsed());
    const QMap<QString, double> after = threadTimes();
    const double frames = paints.count / (elapsed / 1000.0);

    quiet();
    const quint64 sent = simulator.streams().all - sentBefore;
    const quint64 heard = watch.frames();
    rig.client().removeListener(watch);
    const TelemetryStore &store = *rig.client().telemetry();
    const QString what
        = u"%1 s, %2 series, REALTIME_DATA_4 at 1250/s through a pseudo-terminal"_s.arg(seconds).arg(
            channels.size());
    report.atMost(u"E2E"_s, u"frames lost, "_s + what, double(sent) - double(heard), 0, {},
                  u"%1 sent, %2 received, %3 thought lost"_s.arg(sent).arg(heard).arg(store.lost()));
    report.atLeast(u"E2E"_s, u"frames/s of the screen"_s, frames, 58, u"/s"_s, u"10 s window"_s);
    report.atMost(u"E2E"_s, u"latency from byte to store, p99"_s, quantile(watch.latencies(), 0.99), 5,
                  u"ms"_s, u"median %1 ms"_s.arg(median(watch.latencies()), 0, 'f', 3));
    QFile statm(u"/proc/self/statm"_s);
    if (statm.open(QIODevice::ReadOnly)) {
        report.tell(u"end to end: resident memory"_s,
                    u"%1 MB"_s.arg(statm.readAll().split(' ').value(1).toDouble()
                                       * double(::sysconf(_SC_PAGESIZE)) / 1e6,
                                   0, 'f', 0));
    }
    for (auto thread = after.begin(); thread != after.end(); ++thread) {
        const double share = (thread.value() - before.value(thread.key())) / elapsed * 100.0;
        if (share >= 0.1)
            report.tell(u"end to end: share of a core, thread %1"_s.arg(thread.key()),
                        u"%1 %"_s.arg(share, 0, 'f', 1));
    }
}
