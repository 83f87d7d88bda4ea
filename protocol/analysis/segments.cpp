// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/analysis/segments.h"

#include <unsupported/Eigen/FFT>

#include <cmath>

using namespace Qt::StringLiterals;

struct Segments::Transform
{
    Eigen::FFT<double> fft;
    std::vector<double> input;
    std::vector<std::complex<double>> bins;
};

Segments::Segments(std::vector<double> weights, double rate, int count, std::size_t hop)
    : m_weights(std::move(weights))
    , m_rate(rate)
    , m_count(count)
    , m_hop(hop)
    , m_transform(std::make_unique<Transform>())
{
    m_transform->fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
    m_transform->input.resize(m_weights.size());
    for (const double weight : m_weights)
        m_squares += weight * weight;
}

Segments::Segments(Segments &&) noexcept = default;
Segments::~Segments() = default;

Result<Segments> Segments::make(std::size_t samples, double rate, const SpectrumOptions &options)
{
    if (options.length < 16 || options.length > 65536 || options.length % 2 != 0)
        return failure(ErrorCode::InvalidArgument, u"a segment has 16 to 65536 samples, an even number"_s);
    if (!(options.overlap >= 0.0 && options.overlap <= 0.9))
        return failure(ErrorCode::InvalidArgument, u"the overlap is 0 to 0.9"_s);
    if (!(rate > 0.0) || !std::isfinite(rate))
        return failure(ErrorCode::InvalidArgument, u"the sample rate is not known"_s);
    const auto length = std::size_t(options.length);
    if (samples < length) {
        return failure(ErrorCode::InvalidArgument,
                       u"%1 samples are fewer than one segment of %2"_s.arg(samples).arg(length));
    }
    const std::size_t hop = std::max<std::size_t>(1, std::size_t(std::lround(double(length) * (1.0 - options.overlap))));
    const int count = int((samples - length) / hop) + 1;
    return Segments(windowWeights(options.window, options.length), rate, count, hop);
}

double Segments::noiseBandwidth() const
{
    double sum = 0.0;
    for (const double weight : m_weights)
        sum += weight;
    return double(m_weights.size()) * m_squares / (sum * sum);
}

double Segments::powerScale(std::size_t bin) const
{
    const bool single = bin == 0 || bin + 1 == bins();   // these have no mirror image
    return (single ? 1.0 : 2.0) / (m_rate * m_squares * m_count);
}

const std::vector<std::complex<double>> &Segments::transform(std::span<const float> samples, int segment)
{
    const std::size_t from = std::size_t(segment) * m_hop;
    std::vector<double> &input = m_transform->input;
    double mean = 0.0;
    for (std::size_t i = 0; i < input.size(); ++i)
        mean += double(samples[from + i]);
    mean /= double(input.size());
    for (std::size_t i = 0; i < input.size(); ++i)
        input[i] = (double(samples[from + i]) - mean) * m_weights[i];
    m_transform->fft.fwd(m_transform->bins, input);
    return m_transform->bins;
}
