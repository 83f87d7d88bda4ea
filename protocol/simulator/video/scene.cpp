// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/video/scene.h"

#include <QByteArray>

#include <algorithm>
#include <array>
#include <cmath>

namespace {

constexpr double kPixelsPerDegree = 1280.0 / 90;  // at 1280 pixels
constexpr int kGridDeg = 10;

// The squares of the number: two rows of 20, which leaves 20 bits for a check sum.
constexpr int kSquare = 32;  // pixels at a width of 1280; whole blocks of the encoder
constexpr int kColumns = 20;
constexpr int kLeft = 32;
constexpr int kTop = 32;
constexpr double kWidth = 1280;
constexpr std::uint32_t kNumberMask = (1U << kColumns) - 1;

/// A colour as it is sent: brightness and two differences.
struct Ink
{
    int y;
    int u;
    int v;
};
constexpr Ink kSky{150, 150, 110};
constexpr Ink kGround{90, 110, 145};
constexpr Ink kGridInk{200, 128, 128};
constexpr Ink kHorizonInk{235, 128, 128};
constexpr Ink kBlack{16, 128, 128};
constexpr Ink kWhite{235, 128, 128};

// Digits of 3 by 5 dots, rows from the top; then a colon and a point.
constexpr std::array<std::array<int, 5>, 12> kDigits{{{7, 5, 5, 5, 7},
                                                      {2, 6, 2, 2, 7},
                                                      {7, 1, 7, 4, 7},
                                                      {7, 1, 7, 1, 7},
                                                      {5, 5, 7, 1, 1},
                                                      {7, 4, 7, 1, 7},
                                                      {7, 4, 7, 5, 7},
                                                      {7, 1, 2, 2, 2},
                                                      {7, 5, 7, 5, 7},
                                                      {7, 5, 7, 1, 7},
                                                      {0, 2, 0, 2, 0},
                                                      {0, 0, 0, 0, 2}}};
constexpr int kDot = 6;  // pixels

class Canvas
{
public:
    Canvas(VideoPlanes &picture, const CameraView &view)
        : m_picture(picture)
        , m_view(view)
    {
    }

    /// What the camera makes of a colour.
    [[nodiscard]] Ink seen(const Ink &ink) const
    {
        const auto limited = [](double value) { return int(std::clamp(value, 16.0, 235.0)); };
        return {limited((ink.y - 126) * m_view.contrast + 126 + m_view.brightness * 219),
                limited((ink.u - 128) * m_view.saturation + 128),
                limited((ink.v - 128) * m_view.saturation + 128)};
    }

    void fillRow(int row, int from, int to, const Ink &ink)
    {
        from = std::clamp(from, 0, m_picture.width);
        to = std::clamp(to, from, m_picture.width);
        const auto line = m_picture.y.begin() + std::ptrdiff_t(row) * m_picture.width;
        std::fill(line + from, line + to, std::uint8_t(ink.y));
        if (row % 2)
            return;
        const std::ptrdiff_t half = std::ptrdiff_t(row / 2) * (m_picture.width / 2);
        std::fill(m_picture.u.begin() + half + from / 2, m_picture.u.begin() + half + to / 2,
                  std::uint8_t(ink.u));
        std::fill(m_picture.v.begin() + half + from / 2, m_picture.v.begin() + half + to / 2,
                  std::uint8_t(ink.v));
    }

    void fillRect(int left, int top, int width, int height, const Ink &ink)
    {
        for (int row = std::max(0, top); row < std::min(top + height, m_picture.height); ++row)
            fillRow(row, left, left + width, ink);
    }

    /// A line of brightness alone.
    void drawLine(double x1, double y1, double x2, double y2, int thickness, int brightness)
    {
        const double length = std::max(std::abs(x2 - x1), std::abs(y2 - y1));
        const int steps = int(std::min(length, 4096.0));
        const bool isSteep = std::abs(y2 - y1) > std::abs(x2 - x1);
        for (int step = 0; step <= steps; ++step) {
            const double part = steps > 0 ? double(step) / steps : 0;
            const int x = int(std::lround(x1 + (x2 - x1) * part));
            const int y = int(std::lround(y1 + (y2 - y1) * part));
            for (int wide = 0; wide < thickness; ++wide)
                setBrightness(isSteep ? x + wide : x, isSteep ? y : y + wide, brightness);
        }
    }

private:
    void setBrightness(int x, int y, int brightness)
    {
        if (x >= 0 && y >= 0 && x < m_picture.width && y < m_picture.height)
            m_picture.y[std::size_t(y) * std::size_t(m_picture.width) + std::size_t(x)]
                = std::uint8_t(brightness);
    }

    VideoPlanes &m_picture;
    const CameraView &m_view;
};

/// Directions to places in the picture: the middle looks ahead.
class Projection
{
public:
    Projection(const VideoPlanes &picture, const CameraView &view)
        : m_scale(kPixelsPerDegree * picture.width / kWidth)
        , m_cos(std::cos(view.rollDeg * M_PI / 180))
        , m_sin(std::sin(view.rollDeg * M_PI / 180))
        , m_x(picture.width / 2.0)
        , m_y(picture.height / 2.0)
        , m_pitch(view.pitchDeg)
        , m_yaw(view.yawDeg)
    {
    }

    struct Point
    {
        double x;
        double y;
    };
    /// @param yaw, pitch directions in the world, degrees
    [[nodiscard]] Point place(double yaw, double pitch) const
    {
        const double right = (yaw - m_yaw) * m_scale;
        const double down = (m_pitch - pitch) * m_scale;
        // A camera that rolls to the right sees the horizon rise on its right.
        return {m_x + right * m_cos + down * m_sin, m_y - right * m_sin + down * m_cos};
    }

    /// Degrees from the middle to a corner.
    [[nodiscard]] double reach() const { return std::hypot(m_x, m_y) / m_scale; }

private:
    double m_scale;
    double m_cos;
    double m_sin;
    double m_x;
    double m_y;
    double m_pitch;
    double m_yaw;
};

void drawHorizon(Canvas &canvas, const VideoPlanes &picture, const CameraView &view,
                 const Projection &projection)
{
    const auto left = projection.place(view.yawDeg - 90, 0);
    const auto right = projection.place(view.yawDeg + 90, 0);
    const double across = right.x - left.x;
    const double down = right.y - left.y;
    const Ink sky = canvas.seen(kSky);
    const Ink ground = canvas.seen(kGround);
    for (int row = 0; row < picture.height; ++row) {
        // Right of the line from left to right, seen along it, is the ground.
        const double here = across * (row - left.y);
        const int atLeft = here + down * left.x > 0;
        const double cross = std::abs(down) > 1e-6 ? left.x + here / down : -1;
        const Ink &first = atLeft ? ground : sky;
        if (cross <= 0 || cross >= picture.width) {
            canvas.fillRow(row, 0, picture.width, first);
            continue;
        }
        canvas.fillRow(row, 0, int(cross), first);
        canvas.fillRow(row, int(cross), picture.width, atLeft ? sky : ground);
    }
}

void drawGrid(Canvas &canvas, const CameraView &view, const Projection &projection)
{
    const double reach = projection.reach() + kGridDeg;
    const int ink = canvas.seen(kGridInk).y;
    const auto first = [](double from) { return int(std::floor(from / kGridDeg)) * kGridDeg; };
    for (int yaw = first(view.yawDeg - reach); yaw <= view.yawDeg + reach; yaw += kGridDeg) {
        const auto top = projection.place(yaw, view.pitchDeg + reach);
        const auto bottom = projection.place(yaw, view.pitchDeg - reach);
        canvas.drawLine(top.x, top.y, bottom.x, bottom.y, 2, ink);
    }
    for (int pitch = first(view.pitchDeg - reach); pitch <= view.pitchDeg + reach; pitch += kGridDeg) {
        const auto left = projection.place(view.yawDeg - reach, pitch);
        const auto right = projection.place(view.yawDeg + reach, pitch);
        const bool isHorizon = pitch == 0;
        canvas.drawLine(left.x, left.y, right.x, right.y, isHorizon ? 5 : 2,
                        isHorizon ? canvas.seen(kHorizonInk).y : ink);
    }
}

// 20 bits that change in about half of their places with each number.
std::uint32_t checkOf(std::uint32_t number)
{
    std::uint32_t hash = (number & kNumberMask) * 2654435761U;
    hash ^= hash >> 15;
    hash *= 2246822519U;
    return (hash >> 11) & kNumberMask;
}

void drawNumber(Canvas &canvas, std::uint32_t number, double scale)
{
    const std::array rows{number & kNumberMask, checkOf(number)};
    const auto scaled = [scale](int pixels) { return int(std::lround(pixels * scale)); };
    for (int row = 0; row < int(rows.size()); ++row) {
        for (int bit = 0; bit < kColumns; ++bit) {
            const bool isSet = rows[std::size_t(row)] >> (kColumns - 1 - bit) & 1U;
            canvas.fillRect(scaled(kLeft + bit * kSquare), scaled(kTop + row * kSquare), scaled(kSquare),
                            scaled(kSquare), isSet ? kWhite : kBlack);
        }
    }
}

void drawClock(Canvas &canvas, const VideoPlanes &picture, double seconds, double scale)
{
    const auto all = qint64(std::llround(std::max(0.0, seconds) * 1000));
    const QByteArray text = QByteArray::number(all / 60000).rightJustified(2, '0') + ':'
        + QByteArray::number(all / 1000 % 60).rightJustified(2, '0') + '.'
        + QByteArray::number(all % 1000).rightJustified(3, '0');
    const int dot = std::max(2, int(std::lround(kDot * scale)) / 2 * 2);
    const int top = picture.height - 8 * dot;
    int left = picture.width - 4 * dot * int(text.size()) - dot;
    canvas.fillRect(left - dot, top - dot, 4 * dot * int(text.size()) + dot, 7 * dot, kBlack);
    for (const char letter : text) {
        const std::size_t shape = letter == ':' ? 10 : letter == '.' ? 11 : std::size_t(letter - '0');
        for (int row = 0; row < 5; ++row) {
            for (int column = 0; column < 3; ++column) {
                if (kDigits[shape][std::size_t(row)] >> (2 - column) & 1)
                    canvas.fillRect(left + column * dot, top + row * dot, dot, dot, kWhite);
            }
        }
        left += 4 * dot;
    }
}

}  // namespace

void drawScene(VideoPlanes &picture, const CameraView &view, std::uint32_t number)
{
    const double scale = picture.width / kWidth;
    Canvas canvas(picture, view);
    const Projection projection(picture, view);
    drawHorizon(canvas, picture, view, projection);
    drawGrid(canvas, view, projection);
    drawNumber(canvas, number, scale);
    drawClock(canvas, picture, view.seconds, scale);
}

std::optional<std::uint32_t> readNumber(const VideoPicture &picture)
{
    const double scale = picture.width / kWidth;
    std::array<std::uint32_t, 2> rows{};
    for (int row = 0; row < int(rows.size()); ++row) {
        for (int bit = 0; bit < kColumns; ++bit) {
            const int x = int((kLeft + (bit + 0.5) * kSquare) * scale);
            const int y = int((kTop + (row + 0.5) * kSquare) * scale);
            if (x >= picture.width || y >= picture.height)
                return {};
            constexpr int kGreen = 1;
            const auto green
                = picture
                      .pixels[std::size_t(y) * std::size_t(picture.stride()) + std::size_t(x) * 4 + kGreen];
            rows[std::size_t(row)] = rows[std::size_t(row)] << 1 | (green > 127 ? 1U : 0U);
        }
    }
    return rows[1] == checkOf(rows[0]) ? std::optional(rows[0]) : std::nullopt;
}
