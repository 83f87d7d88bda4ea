// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>

/// Three numbers along or about x (roll), y (pitch) and z (yaw).
struct Vector3
{
    double x = 0;
    double y = 0;
    double z = 0;

    [[nodiscard]] double &operator[](std::size_t axis) { return axis == 0 ? x : axis == 1 ? y : z; }
    [[nodiscard]] double operator[](std::size_t axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
    Vector3 &operator+=(const Vector3 &other)
    {
        x += other.x;
        y += other.y;
        z += other.z;
        return *this;
    }
    [[nodiscard]] double norm() const { return std::hypot(x, y, z); }

    friend Vector3 operator+(Vector3 a, const Vector3 &b) { return a += b; }
    friend Vector3 operator*(const Vector3 &a, double factor)
    {
        return {a.x * factor, a.y * factor, a.z * factor};
    }
    friend Vector3 operator*(double factor, const Vector3 &a) { return a * factor; }
    friend Vector3 operator/(const Vector3 &a, double divisor) { return a * (1 / divisor); }
    friend Vector3 operator-(const Vector3 &a, const Vector3 &b) { return a + b * -1.0; }
    friend bool operator==(const Vector3 &, const Vector3 &) = default;
};
