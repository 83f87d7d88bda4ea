// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/analysis/segments.h"

#include <cmath>
#include <map>
#include <numbers>
#include <unsupported/Eigen/FFT>

using namespace Qt::StringLiterals;

namespace {

constexpr std::size_t kKept = 8;

std::vector<double> windowWeights(WindowShape shape, int length)
{
    std::vector<double> weights(std::size_t(length), 1.0);
    if (shape == WindowShape::Rectangular)
        return weights;
    for (int i = 0; i < length; ++i) {
        const double phase = 2.0 * std::numbers::pi * i / length;
        weights[std::size_t(i)] = shape == WindowShape::Hann
            ? 0.5 - 0.5 * std::cos(phase)
            : 0.21557895 - 0.41663158 * std::cos(phase) + 0.277263158 * std::cos(2 * phase)
                - 0.083578947 * std::cos(3 * phase) + 0.006947368 * std::cos(4 * phase);
    }
    return weights;
}

}  // namespace

struct Segments::Transform
{
    Eigen::FFT<double> fft;
    std::vector<double> input;
    std::vector<std::complex<double>> bins;
};

struct Segments::Window
{
    std::vector<double> weights;
    double sum = 0;
    double squares = 0;
};

// Windows and transforms of one length are always the same and expensive to build, so each thread caches the
// most recent ones.
std::shared_ptr<const Segments::Window> Segments::windowFor(WindowShape shape, int length)
{
    thread_local std::map<std::pair<WindowShape, int>, std::shared_ptr<const Window>> known;
    if (const auto it = known.find({shape, length}); it != known.end())
        return it->second;
    if (known.size() >= kKept)
        known.clear();
    auto window = std::make_shared<Window>();
    window->weights = windowWeights(shape, length);
    for (const double weight : window->weights) {
        window->sum += weight;
        window->squares += weight * weight;
    }
    return known[{shape, length}] = window;
}

std::shared_ptr<Segments::Transform> Segments::transformFor(std::size_t length)
{
    thread_local std::map<std::size_t, std::shared_ptr<Transform>> known;
    if (known.size() >= kKept && !known.contains(length))
        known.clear();
    auto &transform = known[length];
    // A transform that other segments of this thread are using is left to them.
    if (!transform || transform.use_count() > 1) {
        transform = std::make_shared<Transform>();
        transform->fft.SetFlag(Eigen::FFT<double>::HalfSpectrum);
        transform->input.resize(length);
    }
    return transform;
}

Segments::Segments(std::shared_ptr<const Window> window, double rate, int count, std::size_t hop)
    : m_window(std::move(window))
    , m_length(m_window->weights.size())
    , m_rate(rate)
    , m_count(count)
    , m_hop(hop)
    , m_transform(transformFor(m_length))
{
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
        return failure(ErrorCode::TooFewSamples,
                       u"%1 samples are fewer than one segment of %2"_s.arg(samples).arg(length));
    }
    const std::size_t hop
        = std::max<std::size_t>(1, std::size_t(std::lround(double(length) * (1.0 - options.overlap))));
    const int count = int((samples - length) / hop) + 1;
    return Segments(windowFor(options.window, options.length), rate, count, hop);
}

double Segments::noiseBandwidth() const
{
    return double(m_length) * m_window->squares / (m_window->sum * m_window->sum);
}

double Segments::powerScale(std::size_t bin) const
{
    const bool single = bin == 0 || bin + 1 == bins();  // these have no mirror image
    return (single ? 1.0 : 2.0) / (m_rate * m_window->squares * m_count);
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
        input[i] = (double(samples[from + i]) - mean) * m_window->weights[i];
    m_transform->fft.fwd(m_transform->bins, input);
    return m_transform->bins;
}
