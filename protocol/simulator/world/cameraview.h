// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// What the camera on a simulated board sees, and how it sends it.
struct CameraView
{
    double rollDeg = 0;
    double pitchDeg = 0;
    double yawDeg = 0;
    double seconds = 0;  ///< since the board was switched on
    int frameRate = 30;  ///< per second
    bool isMjpeg = false;  ///< JPEGs instead of H.264
    double loss = 0;  ///< probability that a datagram is lost
    double brightness = 0;  ///< -1 to 1, added
    double contrast = 1;  ///< factor
    double saturation = 1;  ///< factor
};
