// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/simulator/world/simulatedfamily.h"
#include "tests/support/toyfamily/toytables.h"
#include "tests/support/toyfamily/toywire.h"

#include <deque>

/// A simulated toy: believes everybody who sends heartbeats, and has no dead-man rule of its own.
class ToyBoard final : public SimulatedBoard
{
public:
    explicit ToyBoard(const SimulatorOptions &options);

    [[nodiscard]] bool isPacketBased() const override { return true; }
    void receive(Bytes bytes) override;
    void cycle() override;
    QByteArray takeOutput(qsizetype max) override;
    /// False while it restarts.
    [[nodiscard]] bool isRunning() const override { return m_time < m_downAt || m_time >= m_awakeAt; }
    void setFaults(const Faults &) override { }

    [[nodiscard]] bool areOutputsOn() const { return m_outputs; }
    [[nodiscard]] bool isLocked() const { return m_locked; }
    /// How often each command was heard.
    [[nodiscard]] int heard(toy::Command command) const { return m_heard.value(int(command)); }
    [[nodiscard]] QByteArray block(int block) const { return m_blocks.value(block); }
    void setBlock(int block, const QByteArray &bytes) { m_blocks[block] = bytes; }
    [[nodiscard]] std::array<float, 3> control() const { return m_control; }
    [[nodiscard]] int restarts() const { return m_restarts; }

private:
    void onFrame(int id, const QByteArray &payload);
    void obey(toy::Command command, const QByteArray &payload);
    void stop();
    void write(const QByteArray &payload);
    void tellTelemetry();
    void answer(toy::Command command, const QByteArray &payload = {});

    SimulatorOptions m_options;
    toy::ToyFramer m_framer;
    std::deque<QByteArray> m_output;
    QMap<int, QByteArray> m_blocks;
    QMap<int, int> m_heard;
    Duration m_time{};
    Duration m_downAt{};  // restarts from then ...
    Duration m_awakeAt{};  // ... to then
    Duration m_deafUntil{};
    Duration m_lastBeat = -1h;
    std::array<float, 3> m_control{};  // pan, tilt, throttle
    double m_pitch = 5;
    double m_yaw = -20;
    bool m_outputs = false;
    bool m_armed = false;
    bool m_calibrated = false;
    bool m_locked = false;
    int m_deafHalts;
    int m_restarts = 0;
    int m_samples = 0;
};

[[nodiscard]] SimulatedFamily simulatedToy();
