// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/guide/setupguide.h"
#include "protocol/telemetry/telemetryplan.h"
#include "tests/support/sticks.h"
#include "tests/support/virtualboard.h"

#include <QTemporaryDir>

/// A gimbal and hands that do what they are told, in virtual time.
struct SetupBench
{
    explicit SetupBench(bool isNew = true, const Faults &faults = {}, int firmware = 0)
        : SetupBench(unpacked(isNew, faults, firmware))
    {
    }
    explicit SetupBench(const SimulatorOptions &options)
        : board(options)
        , history(dir.path())
    {
        if (!board.identify())
            qFatal("not identified");
        store = std::make_unique<TelemetryStore>(int(board.device.channels().size()), board.channel.now());
        auto subscribed = board.device.subscribe(board.channel, {SetupGuide::channels(board.device), 0}, {});
        decoder = subscribed->decoder;
        board.channel.setTap(
            [this](const FrameView &frame, TimePoint at) { decoder->decode(frame, at, *store); });
        board.channel.setOperator([this](const Progress &progress) { obey(progress); });
        record = SetupRecord(board.device.identity());
    }
    /// The hands do what they are told.
    void obey(const Progress &progress)
    {
        if (progress.step == QStringLiteral("setup-let-go"))
            hand(0);
        else if (progress.step == QStringLiteral("setup-tilt-level"))
            hand(1);
        else if (progress.step == QStringLiteral("setup-tilt-down"))
            hand(3);
        else if (progress.step == QStringLiteral("setup-tilt-right"))
            hand(4);
        else if (progress.step.startsWith(QStringLiteral("setup-stick-")))
            stick(stickFor(progress, m_stick));
    }
    void stick(int which)
    {
        if (std::exchange(m_stick, which) != which)
            world(QStringLiteral("stick=%1").arg(which));
    }
    static SimulatorOptions unpacked(bool isNew, const Faults &faults, int firmware, unsigned seed = 1)
    {
        SimulatorOptions options = withFirmware(firmware);
        options.seed = seed;
        options.faults = faults;
        if (isNew) {
            options.own[QStringLiteral("condition")] = 1;
            options.faults.imbalance = 500;
            options.faults.receiver = 1;
        }
        return options;
    }
    /// The step "orientation" is behind it.
    void knowSensor()
    {
        board.board().store(QStringLiteral("imu.main.axis_top"), 0, 3);
        board.board().store(QStringLiteral("imu.main.axis_right"), 0, 1);
    }
    void hand(int what) { world(QStringLiteral("hand=%1").arg(what)); }
    void world(const QString &assignment)
    {
        if (!board.port.change(assignment))
            qFatal("%s", qPrintable(assignment));
    }
    Result<SetupResult> run(const char *key, const QMap<QString, QString> &texts = {})
    {
        const SetupStepSpec &spec = *findSetupStep(QLatin1String(key));
        const auto answers = parseArguments(spec.action, texts);
        if (!answers)
            return tl::unexpected(answers.error());
        SetupGuide guide(board.channel, board.device, *store, history);
        auto result = guide.run(spec.step, *answers, record.result(SetupStep::Motors).isOver());
        if (result)
            record.add(spec.step, *result);
        return result;
    }
    [[nodiscard]] int stored(const QString &key) { return board.board().stored(key, 0); }

    QTemporaryDir dir;
    VirtualBoard board;
    BoardHistory history;
    std::unique_ptr<TelemetryStore> store;
    std::shared_ptr<TelemetryDecoder> decoder;
    SetupRecord record;

private:
    int m_stick = 0;
};

/// How it ended, for a test that fails.
inline QString why(const Result<SetupResult> &result)
{
    if (!result)
        return result.error().detail;
    QString text = setupStateKey(result->state) + u' ' + result->remarks.join(u' ');
    for (const SetupFigure &figure : result->figures)
        text += u' ' + figure.key + u'=' + setupFigureText(figure);
    return text;
}
