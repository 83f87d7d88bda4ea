// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/analysis/spectrumoptions.h"
#include "protocol/base/result.h"

#include <complex>
#include <memory>
#include <span>
#include <vector>

/// Cuts evenly spaced samples into overlapping, windowed segments and transforms them: what a spectrum and a
/// frequency response have in common.
class Segments
{
public:
    /// Errors: those of spectrum().
    static Result<Segments> make(std::size_t samples, double rate, const SpectrumOptions &options);
    Segments(Segments &&) noexcept;
    ~Segments();

    [[nodiscard]] int count() const { return m_count; }
    [[nodiscard]] std::size_t bins() const { return m_length / 2 + 1; }
    [[nodiscard]] double resolution() const { return m_rate / double(m_length); }
    [[nodiscard]] double noiseBandwidth() const;
    /// Factor that turns the sum of |bin|² over all segments into unit² per Hz, one-sided.
    [[nodiscard]] double powerScale(std::size_t bin) const;
    /// Bins 0 ... half of one segment; valid until the next call.
    const std::vector<std::complex<double>> &transform(std::span<const float> samples, int segment);

private:
    struct Transform;
    struct Window;
    static std::shared_ptr<const Window> windowFor(WindowShape shape, int length);
    static std::shared_ptr<Transform> transformFor(std::size_t length);
    Segments(std::shared_ptr<const Window> window, double rate, int count, std::size_t hop);

    std::shared_ptr<const Window> m_window;
    std::size_t m_length;
    double m_rate;
    int m_count;
    std::size_t m_hop;
    std::shared_ptr<Transform> m_transform;
};
