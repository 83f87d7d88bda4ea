// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/abilities.h"
#include "protocol/telemetry/channelspec.h"
#include "protocol/telemetry/pollcount.h"
#include "protocol/telemetry/streams.h"

#include <atomic>

namespace storm32 {

/// Telemetry channels: the 32 words of `d` (errata 3.5) and what is packed into them; the number is the
/// position in channelTable().
enum ChannelId : int {
    AngleRoll,
    AnglePitch,
    AngleYaw,
    Angle2Roll,
    Angle2Pitch,
    Angle2Yaw,
    GyroX,
    GyroY,
    GyroZ,
    AccX,
    AccY,
    AccZ,
    UpX,
    UpY,
    UpZ,
    OutputRoll,
    OutputPitch,
    OutputYaw,
    InputRoll,
    InputPitch,
    InputYaw,
    MagYaw,
    LinkYaw,
    AccConfidence,
    Voltage,
    State,
    Status,
    Status2,
    BusErrors,
    CycleTime,
    MotorsActive,
    Functions,
    ChannelCount
};

[[nodiscard]] ChannelTable channelTable();

/// Scales of the counts of `d`: those of gyro and accelerometer have changed between versions (errata 3.5).
struct LiveScales
{
    double gyro = 0;  ///< deg/s per count
    double acc = 0;  ///< g per count
    bool clock = true;  ///< the time stamp is usable

    explicit LiveScales(int firmware);
};

/// One row from the data of `d`: a value for each channel, NaN for missing ones. @param data 64 bytes
[[nodiscard]] std::array<float, ChannelCount> liveRow(Bytes data, const LiveScales &scales);
/// The first state with turning motors. Only a start leads through those before it; leaving standby does not
/// (errata 3.7).
inline constexpr int kMotorsTurn = 4;
inline constexpr int kMotorBits = 0x0038;  ///< of status2: a motor is active (errata 3.8)
/// Of status2: roll, pitch and yaw follow the handle (errata 3.8).
inline constexpr std::array<unsigned, 3> kPanBits{0x4000, 0x2000, 0x8000};
inline constexpr double kStickRest = 12.0;  ///< microseconds; an untouched stick is not exactly in its middle
inline constexpr unsigned kAllPanBits = kPanBits[0] | kPanBits[1] | kPanBits[2];
/// Whether a state means standby (errata 3.7).
[[nodiscard]] bool isStandby(int state, int firmware);
/// The name of a state; up to 0.90 state 7 is standby (errata 3.7).
[[nodiscard]] QString stateName(int state, int firmware);
/// Status words and function inputs as facts (errata 3.5, 3.8).
[[nodiscard]] std::vector<BoardFact> factsOf(unsigned status, unsigned status2, unsigned functions);
/// Status bits and state as faults with causes. @param bits status; @param state the state
[[nodiscard]] std::vector<BoardFault> faultsOf(unsigned bits, unsigned state);

/// What was seen of a board since its start that says what the angles of its axes are counted from; it does
/// not report that itself. Written by the worker and the I/O thread, read by the GUI.
struct PanHistory
{
    /// Pan bits (of status2) of the axes whose position has more than one cause: they follow the handle, have
    /// followed it, or the middle of their stick is set off. Never cleared.
    std::atomic<unsigned> shifted = 0;
    /// The board was met before its motors turned, and watched since without a gap. Otherwise an axis may
    /// have followed the handle before.
    std::atomic<bool> sawStart = false;
};

/// Turns answers to `d`, GETDATA and embedded `d` into rows.
class Decoder final : public TelemetryDecoder
{
public:
    /// @param history gathers what all samples say about it
    explicit Decoder(int firmware, std::shared_ptr<PanHistory> history = {})
        : m_scales(firmware)
        , m_history(std::move(history))
    {
    }
    void decode(const FrameView &frame, TimePoint at, TelemetryStore &store) override;
    void sent(QByteArrayView bytes, TelemetryStore &store) override;

private:
    [[nodiscard]] double timeOf(int stamp, double arrival);

    LiveScales m_scales;
    std::shared_ptr<PanHistory> m_history;
    std::shared_ptr<TelemetryGroup> m_group;
    PollCount m_polls;
    QByteArray m_newest;
    int m_lastStamp = -1;
    double m_boardTime = 0;  // seconds, unwrapped
    double m_offset = 0;  // arrival minus board time, of the least late answer
    double m_lastTime = 0;
    double m_lastArrival = 0;
};

}  // namespace storm32
