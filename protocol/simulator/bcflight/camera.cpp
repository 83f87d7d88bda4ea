// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the drone's camera sees, and what the commands for its picture do (errata 6.5).
#include "protocol/simulator/bcflight/board.h"

#include <algorithm>

namespace bcflight {

namespace {

constexpr double kPictureStep = 0.05;
constexpr int kMostSteps = 20;
constexpr int kIsoStep = 100;

}  // namespace

bool SimulatedBoard::hasVideo() const
{
    return m_options.own.value(QLatin1String(kVideoless), 0) == 0;
}

bool SimulatedBoard::hasCamera() const
{
    return hasVideo() && m_options.own.value(QLatin1String(kCamera), 1) != 0;
}

std::optional<CameraView> SimulatedBoard::cameraView() const
{
    if (!hasCamera() || m_isDead || m_now < m_awayUntil)
        return {};
    const Vector3 attitude = m_quadcopter.attitude();
    CameraView view;
    view.rollDeg = attitude.x;
    view.pitchDeg = attitude.y;
    view.yawDeg = attitude.z;
    view.seconds = m_now;
    view.frameRate = m_options.own.value(QLatin1String(kFrameRate), view.frameRate);
    view.isMjpeg = m_options.own.value(QLatin1String(kJpegs), 0) != 0;
    view.loss = m_options.faults.loseByte;
    view.brightness = m_pictureSteps[0] * kPictureStep;
    view.contrast = 1 + m_pictureSteps[1] * kPictureStep;
    view.saturation = 1 + m_pictureSteps[2] * kPictureStep;
    return view;
}

// Its program never tells them. A restart brings the first picture back.
void SimulatedBoard::stepPicture(Message id)
{
    const auto step = [this](std::size_t which, int by) {
        m_pictureSteps[which] = std::clamp(m_pictureSteps[which] + by, -kMostSteps, kMostSteps);
    };
    switch (id) {
    case Message::BrightnessUp: step(0, 1); break;
    case Message::BrightnessDown: step(0, -1); break;
    case Message::ContrastUp: step(1, 1); break;
    case Message::ContrastDown: step(1, -1); break;
    case Message::SaturationUp: step(2, 1); break;
    case Message::SaturationDown: step(2, -1); break;
    case Message::IsoUp: m_iso += kIsoStep; break;
    case Message::IsoDown: m_iso -= std::min(m_iso, kIsoStep); break;  // 0 is automatic
    default: break;
    }
}

}  // namespace bcflight
