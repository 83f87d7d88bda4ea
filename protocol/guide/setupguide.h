// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/analysis/spectrum.h"
#include "protocol/configuration/livevalues.h"
#include "protocol/guide/setuprecord.h"
#include "protocol/record/boardhistory.h"
#include "protocol/telemetry/roles.h"
#include "protocol/telemetry/telemetrystore.h"

class Channel;

/// Carries out one step at a time on the worker, the same for the window and for the command line. Where a
/// person has to do something meanwhile, it is told by progress ("setup-hold", "setup-let-go", "setup-move"),
/// and the step waits for what it sees. Whatever is written goes the way of every write: with a safety copy,
/// read back and compared.
class SetupGuide
{
public:
    SetupGuide(Channel &channel, Device &device, const TelemetryStore &telemetry, const BoardHistory &history,
               LiveValues live = {});

    /// The channels that must arrive while a step runs.
    [[nodiscard]] static QList<int> channels(const Device &device);

    /// @param areMotorsKnown before that they are not trusted to hold the camera: calibrations switch them
    /// off
    /// @param answers of parseArguments() of the step's action; whoever calls has had `confirm` confirmed
    /// Errors, with the board as it was unless the error says otherwise: ReadOnly, Unsupported (the board
    /// lacks something for it), Unready (no telemetry, motors off where they have to run), ConditionUnmet
    /// (with what has to be seen to), InvalidArgument (an answer is needed), Diverged (an axis ran away and
    /// the motors were stopped), those of writing and of the actions.
    Result<SetupResult> run(SetupStep step, const QVariantMap &answers, bool areMotorsKnown);

private:
    using Figures = std::array<double, kAxisCount>;

    Result<SetupResult> power(const QVariantMap &answers);
    Result<SetupResult> calibrate(const QString &action, const QString &part, const QString &figure,
                                  double good, double usable, bool areMotorsKnown);
    Result<SetupResult> balance();
    Result<SetupResult> motors();
    Result<SetupResult> gains();
    Result<SetupResult> vibration(const QVariantMap &answers);
    Result<SetupResult> limits(const QVariantMap &answers);
    Result<SetupResult> use(const QVariantMap &answers);

    // What is seen.
    [[nodiscard]] double latest(int channel) const { return double(m_telemetry.latest(channel)); }
    /// Waits until all of them are newer than now. Errors: Unready.
    Result<void> awaitNews(const QList<int> &channels);
    /// The mean over that time. Errors: Unready.
    Result<double> average(int channel, double seconds);
    /// Watches for that time; `each` sees every moment and ends it by an error.
    Result<void> watch(double seconds, const std::function<Result<void>()> &each, const QString &step);
    /// Lets that time pass. @return from when to when, in seconds since the origin of the store
    Result<std::pair<double, double>> measure(double seconds);
    /// How far angles are from their targets, RMS.
    Result<Figures> measureHolding();
    void tell(const QString &step, double share);
    /// Lines of the turn rates that may be worth a notch.
    using Lines = std::vector<std::pair<Axis, SpectrumPeak>>;
    Result<Lines> measureLines(SetupResult &result);
    /// @return whether the notch was kept
    Result<bool> tryNotchFor(Axis axis, const SpectrumPeak &peak, SetupResult &result);

    // What is done.
    Result<void> switchOff();
    Result<void> requireMotors();
    /// Writes the difference, verified; lists it in the result.
    Result<void> write(const Configuration &base, const Configuration &edited, SetupResult &result);
    static void list(const Configuration &base, const Configuration &edited, SetupResult &result);
    [[nodiscard]] const ParameterSpec *find(const QString &key, Axis axis = Axis::None) const;

    Channel &m_channel;
    Device &m_device;
    const TelemetryStore &m_telemetry;
    const BoardHistory &m_history;
    LiveValues m_live;
    const ChannelRoles m_roles;
    SetupKeys m_keys;
};
