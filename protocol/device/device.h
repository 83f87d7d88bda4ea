// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/configuration.h"
#include "protocol/device/actionspec.h"
#include "protocol/telemetry/channelspec.h"
#include "protocol/telemetry/roles.h"

#include <memory>
#include <optional>
#include <span>

class Bearings;
class Channel;
class FaultWords;
class FirmwareAdvice;
class FlyingMachine;
class FrameInspector;
class GainShape;
class InnerVariables;
class LiveAccess;
class MotorLayout;
class MotorSwitch;
class NotchFilters;
class ProfileAccess;
class RestartNotice;
class SetupFacts;
class StatusWords;
class Steering;
class StreamControl;
class TelemetryDecoder;
class WholeMemory;
class WriteBracket;
struct LineSettings;
struct StopPlan;
struct Subscription;
struct TelemetryPlan;

/// What a family knows, as plain sequential code that talks to a Channel. Constant once identified, so the
/// GUI may read the tables while the worker thread uses the rest. What every board has is a pure virtual
/// function here; what only some have is an interface (abilities.h, motorlayout.h, steering.h), null if the
/// board lacks it.
class Device
{
public:
    virtual ~Device() = default;

    /// Sends one harmless query; true if a board of this family answered it.
    virtual Result<bool> probe(Channel &channel) = 0;
    /// Identifies the board. Errors: Timeout, BadReply, LinkClosed.
    virtual Result<BoardIdentity> identify(Channel &channel) = 0;
    [[nodiscard]] virtual const BoardIdentity &identity() const = 0;
    /// Forbids writing from now on: for a recording, or a board under someone else's control.
    virtual void setReadOnly() = 0;
    [[nodiscard]] virtual std::shared_ptr<const ParameterSet> parameters() const = 0;

    /// Reads everything; a missing part is left out and is not an error.
    virtual Result<Configuration> readConfiguration(Channel &channel) = 0;
    virtual Result<QByteArray> readBlock(Channel &channel, BlockKey key) = 0;
    /// Writes one block; BlockSpec tells what that does to the board. May make its profile the active one.
    virtual Result<void> writeBlock(Channel &channel, BlockKey key, const QByteArray &bytes) = 0;

    [[nodiscard]] virtual std::span<const ActionSpec> actions() const = 0;
    /// Performs an action with arguments from parseArguments(). Errors: InvalidArgument, Unsupported, the
    /// board's own.
    virtual Result<ActionReply> perform(Channel &channel, const QString &key, const QVariantMap &arguments)
        = 0;

    [[nodiscard]] virtual ChannelTable channels() const = 0;
    /// Sets up live data. Errors: TooMuch (the line cannot carry it), InvalidArgument (no such stream), the
    /// board's own.
    virtual Result<TelemetryPlan> subscribe(Channel &channel, const Subscription &subscription,
                                            std::optional<LineSettings> line)
        = 0;
    /// For a recording: a decoder that learns from the sent frames what the board was asked for.
    [[nodiscard]] virtual std::shared_ptr<TelemetryDecoder> replayDecoder() const = 0;

    /// How to stop the motors. Requested after each job, because a job may change how the board is reached.
    [[nodiscard]] virtual StopPlan stopPlan() const = 0;

    // Used on the worker thread; the GUI reads only what is constant.
    [[nodiscard]] virtual ProfileAccess *profiles() { return nullptr; }
    [[nodiscard]] virtual const ProfileAccess *profiles() const { return nullptr; }
    [[nodiscard]] virtual WriteBracket *writeBracket() { return nullptr; }
    [[nodiscard]] virtual WholeMemory *wholeMemory() { return nullptr; }
    [[nodiscard]] virtual const WholeMemory *wholeMemory() const { return nullptr; }
    [[nodiscard]] virtual LiveAccess *live() { return nullptr; }
    [[nodiscard]] virtual const LiveAccess *live() const { return nullptr; }
    [[nodiscard]] virtual InnerVariables *innerVariables() { return nullptr; }
    [[nodiscard]] virtual const InnerVariables *innerVariables() const { return nullptr; }
    [[nodiscard]] virtual const StreamControl *streamControl() const { return nullptr; }
    [[nodiscard]] virtual const Steering *steering() const { return nullptr; }
    [[nodiscard]] virtual FlyingMachine *flight() { return nullptr; }
    [[nodiscard]] virtual const FlyingMachine *flight() const { return nullptr; }
    [[nodiscard]] virtual const MotorSwitch *motorSwitch() const { return nullptr; }
    [[nodiscard]] virtual const MotorLayout *motorLayout() const { return nullptr; }
    [[nodiscard]] virtual const FrameInspector *inspector() const { return nullptr; }
    [[nodiscard]] virtual const FaultWords *faultWords() const { return nullptr; }
    [[nodiscard]] virtual const Bearings *bearings() const { return nullptr; }
    [[nodiscard]] virtual const StatusWords *statusWords() const { return nullptr; }
    [[nodiscard]] virtual const SetupFacts *setupFacts() const { return nullptr; }
    [[nodiscard]] virtual const FirmwareAdvice *firmwareAdvice() const { return nullptr; }
    [[nodiscard]] virtual const NotchFilters *notchFilters() const { return nullptr; }
    [[nodiscard]] virtual std::shared_ptr<const GainShape> gainShape() const { return nullptr; }
    [[nodiscard]] virtual const RestartNotice *restartNotice() const { return nullptr; }
};

/// The channels of a board by the roles that pages look for.
[[nodiscard]] inline ChannelRoles rolesOf(const Device &device)
{
    return {device.channels(), device.identity().capabilities};
}
