// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/result.h"
#include "protocol/bcflight/messages.h"

#include <vector>

namespace bcflight {

/// What one field of a payload holds.
struct FieldValue
{
    const FieldSpec *spec = nullptr;
    double number = 0;
    std::vector<float> numbers = {};  ///< of Floats, Bins and Powers, as they come
    QByteArray bytes = {};  ///< of Text (without its zero) and Rest, and the raw ones of Sticks
};

/// The fields of a payload, as many as it holds.
[[nodiscard]] std::vector<FieldValue> decodeFields(std::span<const FieldSpec> fields, Bytes payload,
                                                   int stickBytes = 6);
/// A payload of numbers, and a text or bytes as its last field. Errors: InvalidArgument (another count, a
/// number that is none), OutOfRange.
[[nodiscard]] Result<QByteArray> encodeFields(std::span<const FieldSpec> fields,
                                              const std::vector<double> &numbers, QByteArrayView last = {});

/// Bits of STATUS (errata 4.1).
struct Status
{
    static constexpr std::uint32_t kArmed = 0x01;
    static constexpr std::uint32_t kCalibrated = 0x02;  ///< the attitude unit runs
    static constexpr std::uint32_t kCalibrating = 0x04;
    static constexpr std::uint32_t kNightMode = 0x80;

    bool armed = false;
    bool calibrated = false;
    bool calibrating = false;
    std::uint32_t others = 0;  ///< bits beside those, as they came

    [[nodiscard]] static std::optional<Status> decode(Bytes payload);
    [[nodiscard]] std::uint32_t bits() const;

    friend bool operator==(const Status &, const Status &) = default;
};

/// Cells that the drone counts its battery's level by: from 3.0 V of a cell, empty, to 4.2 V (errata 4.2).
/// 0: what it tells shows none. @param level share of full
[[nodiscard]] int countedCells(double volts, double level);

/// CONTROLS (errata 4.3): what the pilot wants. Shares of full deflection.
struct Controls
{
    double thrust = 0;  ///< 0 to 1
    double roll = 0;  ///< -1 to 1, as are the others
    double pitch = 0;
    double yaw = 0;
    bool arm = false;
    bool smoothing = false;  ///< generation G

    /// 6 bytes from generation D on, 5 before. What is beyond the range, or no number, counts as the nearest
    /// or as 0.
    [[nodiscard]] QByteArray encode(Generation generation) const;
    [[nodiscard]] static std::optional<Controls> decode(Bytes payload, Generation generation);
    [[nodiscard]] static int size(Generation generation);
};

/// The battery and the link as the drone sees them (errata 4.2).
struct Telemetry
{
    double voltage = 0;  ///< V
    double charge = 0;  ///< mAh
    double current = 0;  ///< A; the drone counts up to 25.5
    int level = 0;  ///< %
    int cpuLoad = 0;  ///< %
    int cpuTemperature = 0;  ///< °C
    int receiveQuality = 0;  ///< %
    int receiveLevel = 0;  ///< dBm

    static constexpr std::size_t kSize = 10;
    [[nodiscard]] static std::optional<Telemetry> decode(Bytes payload);
    [[nodiscard]] QByteArray encode() const;
};

/// What MOTORS_SPEED tells of each motor: shares of full output, nominal 0 to 1 (errata 6.3). Empty: damaged.
[[nodiscard]] std::vector<float> outputsIn(Bytes payload);
/// Whether any of them turns.
[[nodiscard]] bool areDriven(const std::vector<float> &outputs);

/// A text with its CRC in front (errata 7.3, 7.6).
[[nodiscard]] QByteArray encodeChecked(QByteArrayView text);
/// The text. Errors: Damaged.
[[nodiscard]] Result<QByteArray> decodeChecked(Bytes payload);

/// One piece of a firmware image (errata 7.4).
[[nodiscard]] QByteArray encodeChunk(std::uint32_t offset, QByteArrayView data);

/// Big-endian (errata 2.3).
[[nodiscard]] QByteArray bigU32(std::uint32_t value);
[[nodiscard]] QByteArray bigU16(std::uint16_t value);
[[nodiscard]] QByteArray bigF32(float value);

}  // namespace bcflight
