// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedure/notchplan.h"
#include "protocol/procedure/notchtrial.h"

#include <QObject>

#include <array>
#include <atomic>
#include <memory>

class BoardHistory;
class BoardWriter;
class ConfigurationModel;
class DeviceClient;
class EditStack;
class LinkMarks;
class LiveModel;
class Notifications;
class TelemetrySubscriptions;

/// Judges notches before they are offered, tries them on the board and tells what came out. A trial always
/// ends with the values from before on the board; what was better is offered as an edit. It goes on without
/// any page. One that was cut off (by the end of the link or of the program) is made good when that board is
/// read again.
class NotchAdviser final : public QObject
{
    Q_OBJECT
public:
    NotchAdviser(DeviceClient &client, ConfigurationModel &configuration, LiveModel &live, EditStack &edits,
                 BoardWriter &writer, const BoardHistory &history, Notifications &notifications,
                 TelemetrySubscriptions &telemetry, LinkMarks &marks);
    ~NotchAdviser() override;

    using Plan = NotchPlan;

    /// planNotch() on the board that is shown.
    [[nodiscard]] std::optional<Plan> plan(Axis axis, const SpectrumPeak &peak) const;
    /// @param wholeRms,commandedRms as in NotchEvidence
    [[nodiscard]] NotchAdvice advise(const Plan &plan, double wholeRms, double commandedRms) const;
    /// The advice in a sentence for the operator.
    [[nodiscard]] QString inWords(const Plan &plan, const NotchAdvice &advice) const;
    /// What trying it means: the notch, its cost for the loop as far as known, what will be done.
    [[nodiscard]] QString question(const Plan &plan, const NotchAdvice &advice) const;
    /// Why nothing can be tried now; empty if it can.
    [[nodiscard]] QString obstacle() const;

    void start(const Plan &plan);
    /// Ends the trial; the old values are written back.
    void stop();
    [[nodiscard]] bool isRunning() const { return m_stop != nullptr; }
    /// The last trial in words; empty before the first.
    [[nodiscard]] const QString &outcome() const { return m_outcome; }

    /// The open loop of an axis as just measured; forgotten when gains or board change.
    void keepLoop(Axis axis, const MeasuredLoop &loop) { m_loops[std::size_t(axis)] = loop; }
    void forgetLoops() { m_loops = {}; }
    /// To be called after the board was read: values of a trial that was cut off give way to those from
    /// before.
    void makeGood();

signals:
    /// A trial has begun or ended.
    void changed();
    /// It is not known what the board holds.
    void readWanted();

private:
    [[nodiscard]] QString name(const Plan &plan) const;
    void onResult(const Plan &plan, const Result<NotchTrialResult> &result);
    void tell(const Plan &plan, const NotchTrialResult &result);

    DeviceClient &m_client;
    ConfigurationModel &m_configuration;
    LiveModel &m_live;
    EditStack &m_edits;
    BoardWriter &m_writer;
    const BoardHistory &m_history;
    Notifications &m_notifications;
    TelemetrySubscriptions &m_telemetry;
    LinkMarks &m_marks;
    std::shared_ptr<std::atomic<bool>> m_stop;  // of the running trial
    QString m_outcome;
    std::array<std::optional<MeasuredLoop>, kAxisCount> m_loops;
};
