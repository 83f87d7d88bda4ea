// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/bcflight/payloads.h"
#include "protocol/simulator/bcflight/quadcopter.h"
#include "protocol/simulator/bcflight/reader.h"
#include "protocol/simulator/world/simulatedboard.h"

#include <deque>

namespace bcflight {

/// A drone with BCFlight on a simulated quadcopter: what it answers, streams, refuses by silence, and where
/// it is dangerous, as in the errata (numbers in brackets are its sections). It is reached over UDP: one
/// packet in and out at a time. Its control loop runs once in each cycle.
class SimulatedBoard final : public ::SimulatedBoard
{
public:
    /// Options of this family: names and defaults.
    static constexpr const char *kGeneration = "generation";  ///< 1 to 7, A to G
    static constexpr const char *kCamera = "camera";
    static constexpr const char *kVideoless = "videoless";  ///< so its program was built (6.2)
    static constexpr const char *kFrameRate = "frames";  ///< of the camera, per second
    static constexpr const char *kJpegs = "mjpeg";
    static constexpr const char *kTransmitter = "vtx";
    static constexpr const char *kStand = "stand";
    static constexpr const char *kNotch = "notch";

    static constexpr double kCycle = 0.0008;  ///< seconds
    static constexpr double kCalibrationTime = 2.0;  ///< of gyroscope and altimeter (7.1)
    static constexpr double kFullCalibrationTime = 3.0;
    static constexpr double kMotorTestTime = 8.0;  ///< nothing is read meanwhile (7.7)
    static constexpr double kEscCalibrationTime = 26.0;
    static constexpr double kRestartTime = 6.0;  ///< after a new configuration (7.3)
    static constexpr double kReplaceTime = 10.0;  ///< after a new firmware (7.4)
    static constexpr double kReadTimeout = 0.5;  ///< of a TCP client (2.6)
    static constexpr qsizetype kLargestImage = 4194304;

    explicit SimulatedBoard(const SimulatorOptions &options);

    [[nodiscard]] bool isPacketBased() const override { return true; }
    void receive(Bytes bytes) override;
    void cycle() override;
    QByteArray takeOutput(qsizetype max) override;
    [[nodiscard]] bool isRunning() const override { return true; }
    [[nodiscard]] StreamCount streamCount() const override { return m_streamed; }
    [[nodiscard]] std::optional<CameraView> cameraView() const override;
    void setFaults(const Faults &faults) override;
    // Over TCP (2.6, 9.1).
    void clientCame() override;
    void clientWent() override;
    [[nodiscard]] QByteArray askedByOthers() override;

    // For tests.
    [[nodiscard]] bool isArmed() const { return m_armed; }
    [[nodiscard]] Status status() const;
    [[nodiscard]] const std::vector<double> &outputs() const { return m_outputs; }
    [[nodiscard]] const QByteArray &configuration() const { return m_configuration; }
    [[nodiscard]] static QByteArray shippedConfiguration();
    [[nodiscard]] const QByteArray &firmware() const { return m_firmware; }
    [[nodiscard]] const std::array<std::array<double, 3>, 3> &gains() const { return m_gains; }
    /// The flight program has ended, or its command thread hangs: only a power cycle helps.
    [[nodiscard]] bool isLost() const { return m_isDead || m_isHung; }
    [[nodiscard]] Quadcopter &quadcopter() { return m_quadcopter; }
    [[nodiscard]] double now() const { return m_now; }
    /// Unknown messages that were met (2.5): a client makes none.
    [[nodiscard]] int unknownMessages() const { return m_unknown; }
    /// What it was told last, in the order in which it took it up; `at` in seconds as now().
    struct Handled
    {
        double at = 0;
        Message id = Message::Unknown;
    };
    [[nodiscard]] const std::deque<Handled> &handled() const { return m_handled; }
    [[nodiscard]] bool isStreamPaused() const { return m_isStreamPaused; }
    [[nodiscard]] bool isBeeping() const { return m_isBeeping; }
    /// Of its video transmitter: the channel from 1 through all bands, the step of power from 0.
    [[nodiscard]] std::pair<int, int> transmitterState() const { return {m_vtxChannel, m_vtxPower}; }

private:
    // state and control (board.cpp)
    void start();
    void control();
    void estimate();
    void beCalibrated();
    [[nodiscard]] bool hasDroppedClient() const;
    [[nodiscard]] bool isOutOfReach() const;
    void disarm();
    void stopOutputs();

    // commands (commands.cpp)
    void serve();
    void handle(const QByteArray &packet);
    /// False: the payload is left to be read as messages.
    bool handle(const DroneReader::Item &item, DroneReader &reader);
    bool handleGain(Message id, Bytes payload);
    bool handleCamera(Message id, Bytes payload);
    bool handleUpload(Message id, const DroneReader::Item &item, DroneReader &reader);
    void handleVtx(Message id, const DroneReader::Item &item, DroneReader &reader);
    void calibrate(Bytes payload);
    void testMotor(std::uint32_t index);
    void takeConfiguration(Bytes payload);
    void block(double seconds);
    void restart(double seconds);
    void send(const QByteArray &packet);
    [[nodiscard]] QByteArray message(Message id, const QByteArray &payload = {}) const;

    // camera.cpp
    [[nodiscard]] bool hasVideo() const;
    [[nodiscard]] bool hasCamera() const;
    void stepPicture(Message id);

    // reports (reports.cpp)
    void stream();
    [[nodiscard]] Telemetry telemetry() const;
    [[nodiscard]] double batteryLevel() const;
    [[nodiscard]] QByteArray spectrum() const;
    [[nodiscard]] QByteArray userName() const;
    [[nodiscard]] QByteArray boardText() const;
    [[nodiscard]] QByteArray sensorsText() const;
    [[nodiscard]] QByteArray camerasText() const;
    [[nodiscard]] QByteArray transmitter() const;

    /// Something that happens later, in the command thread or on the motors.
    struct Step
    {
        double at = 0;
        std::vector<double> outputs;
    };

    SimulatorOptions m_options;
    Generation m_generation;
    Quadcopter m_quadcopter;
    SimulatedNoise m_noise;
    double m_now = 0;

    // The program.
    bool m_isConnected = false;
    bool m_isDead = false;
    bool m_isHung = false;
    double m_awayUntil = 0;
    double m_busyUntil = 0;  // its command thread
    double m_resetDone = -1;
    std::deque<QByteArray> m_inbox;
    std::deque<QByteArray> m_outbox;
    StreamCount m_streamed;
    int m_unknown = 0;
    std::deque<Handled> m_handled;
    int m_lastAck = 0;
    int m_gainsSet = 0;
    bool m_isRetry = false;  // the command behind the last ACK_ID
    int m_clients = 0;  // over TCP, so far
    bool m_hasClient = false;
    double m_heardClient = 0;
    int m_askedByOthers = 0;
    double m_heardControls = -1;

    // Flight.
    bool m_armed = false;
    bool m_everArmed = false;
    double m_armedAt = 0;
    int m_mode = 1;
    Controls m_sticks;
    bool m_calibrated = false;
    double m_calibratingUntil = -1;
    bool m_isCalibrationOver = false;  // for one loop it is neither (7.1)
    bool m_isFullCalibration = false;
    Vector3 m_zero;
    Vector3 m_zeroSum;
    int m_zeroCount = 0;
    bool m_hasOffsets = false;  // the accelerometer was calibrated once
    Vector3 m_rate;  // filtered
    Vector3 m_slowRate;  // for the D term
    Vector3 m_turning;  // °/s²
    Vector3 m_attitude;
    Vector3 m_integral;
    Vector3 m_correction;
    std::array<std::array<double, 3>, 3> m_gains{};  // effective: roll, pitch, yaw; P, I, D
    std::array<double, 2> m_offset{};
    Mix m_mix;
    std::vector<double> m_outputs;
    std::deque<Step> m_steps;
    std::deque<Vector3> m_history;  // of the rate, for the spectrum

    // What it keeps.
    QByteArray m_configuration;
    QByteArray m_firmware;
    QByteArray m_upload;
    QByteArray m_version = "1.0";
    bool m_isStreamPaused = false;
    bool m_isFull = true;
    double m_streamRate = 100;
    quint64 m_streamTick = 0;
    double m_nextStream = 0;
    double m_storedCharge = 412;  // mAh, of whatever flight; nothing measures it today (errata 4.2)
    int m_vtxChannel = 37;
    int m_vtxPower = 0;
    int m_whiteBalance = 0;
    bool m_isBeeping = false;
    int m_iso = 0;
    std::array<int, 3> m_pictureSteps{};  // brightness, contrast, saturation
    std::uint32_t m_clock = 0;
};

}  // namespace bcflight
