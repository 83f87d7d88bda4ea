// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/measurecommand.h"

#include "protocol/base/filefault.h"
#include "protocol/base/responsecsv.h"

#include <QSaveFile>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kTelemetryLead = 1500ms;  // telemetry first: a test begins only when the axis can be seen
constexpr auto kLastWords = 300ms;  // "stop" and "release" go out before the link is closed

/// "steps pitch degrees=3": measures how an axis follows by moving it a little.
Result<MotionTestPlan> motionPlan(const QStringList &words)
{
    MotionTestPlan plan;
    if (words.size() < 2 || (words[0] != u"steps"_s && words[0] != u"sweep"_s))
        return failure(ErrorCode::InvalidArgument, u"measure needs steps or sweep, and an axis"_s);
    plan.kind = words[0] == u"steps"_s ? MotionTestPlan::Kind::Steps : MotionTestPlan::Kind::Sweep;
    const auto axis = std::find_if(kAxes.begin(), kAxes.end(),
                                   [&](Axis each) { return words[1] == QLatin1String(axisKey(each)); });
    if (axis == kAxes.end())
        return failure(ErrorCode::InvalidArgument,
                       u"'%1' is no axis; there are roll, pitch, yaw"_s.arg(words[1]));
    plan.axis = *axis;
    double steps = plan.steps;
    // clang-format off
    const QMap<QString, double *> values{{u"degrees"_s, &plan.degrees}, {u"steps"_s, &steps}, {u"rest"_s, &plan.rest},
                                         {u"from"_s, &plan.fromHz}, {u"to"_s, &plan.toHz}, {u"seconds"_s, &plan.sweepSeconds},
                                         {u"limit"_s, &plan.limit}};
    // clang-format on
    for (const QString &word : words.sliced(2)) {
        const QString name = word.section(u'=', 0, 0);
        bool ok = false;
        const double value = word.section(u'=', 1).toDouble(&ok);
        if (!ok || !values.contains(name)) {
            return failure(ErrorCode::InvalidArgument,
                           u"'%1' is not NAME=NUMBER with one of %2"_s.arg(
                               word, QStringList(values.keys()).join(u", "_s)));
        }
        *values.value(name) = value;
    }
    plan.steps = int(steps);
    if (const auto checked = plan.check(); !checked)
        return tl::unexpected(checked.error());
    return plan;
}

}  // namespace

QString MeasureCommand::help() const
{
    return u"moves an axis a little and tells how it follows; motors must run"_s;
}

QList<CommandOption> MeasureCommand::options()
{
    return {textOption(u"csv"_s, u"FILE"_s, u"also write what was asked for and what was done"_s, m_csv)};
}

QString MeasureCommand::check() const
{
    const auto plan = motionPlan(arguments());
    return plan ? QString() : plan.error().detail;
}

void MeasureCommand::start(DeviceClient &client)
{
    m_client = &client;
    tellCondition(client);
    const MotionTestPlan plan = *motionPlan(arguments());
    connect(&client, &DeviceClient::telemetryFailed, this,
            [this](const Error &error) { emit finished(tl::unexpected(error)); });
    client.subscribe({motionChannels(*client.device(), plan.axis), 0});
    QTimer::singleShot(kTelemetryLead, this, [this, plan] { begin(plan); });
}

void MeasureCommand::begin(const MotionTestPlan &plan)
{
    emit told((tellsTargets(*m_client->device())
                   ? u"moving %1 by %2 degrees"_s
                   : u"bringing the camera to its middle, then moving %1 by %2 degrees"_s)
                  .arg(QLatin1String(axisKey(plan.axis)))
                  .arg(plan.degrees));
    m_running = true;
    m_client
        ->submit<MotionTestResult>(
            [plan, telemetry = m_client->telemetry()](Channel &channel, Device &device) {
                return measureMotion(channel, device, *telemetry, plan);
            },
            DeviceClient::JobKind::Moving)
        .then(this, [this](const Result<MotionTestResult> &result) {
            if (result)
                onMeasured(*result);
            else
                QTimer::singleShot(kLastWords, this,
                                   [this, error = result.error()] { emit failed(error, Refused); });
        });
}

void MeasureCommand::stop()
{
    if (m_running)
        m_client->cancelMovingJobs();
    else
        emit failed({ErrorCode::Cancelled, {}, 0}, Refused);
}

void MeasureCommand::onMeasured(const MotionTestResult &result)
{
    auto outcome = describeMotion(result);
    if (outcome && !m_csv.isEmpty()) {
        QSaveFile file(m_csv);
        const auto checked = checkTarget(m_csv, FileKind::Measurement);
        const bool written = checked && file.open(QIODevice::WriteOnly)
            && writeResponseCsv(file, result.target.values, result.angle.values, result.angle.rate)
            && file.commit();
        if (!checked)
            outcome = tl::unexpected(checked.error());
        else if (!written)
            outcome = tl::unexpected(systemError(file, FileKind::Measurement, true));
        else
            outcome->note = u"both sides are in "_s + m_csv;
    }
    QTimer::singleShot(kLastWords, this, [this, outcome] { emit finished(outcome); });
}
