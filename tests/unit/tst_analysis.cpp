// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/analysis/accelerometer.h"
#include "protocol/analysis/fieldsphere.h"
#include "protocol/analysis/filterresponse.h"
#include "protocol/analysis/frequencyresponse.h"
#include "protocol/analysis/holdingquality.h"
#include "protocol/analysis/pidshape.h"
#include "protocol/analysis/stepresponse.h"
#include "protocol/procedure/motiontest.h"
#include "protocol/simulator/world/stabilizer.h"
#include "protocol/telemetry/uniformsamples.h"
#include "tests/support/loopmath.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <random>

using namespace Qt::StringLiterals;

namespace {

constexpr double kRate = 1250.0;
constexpr double kTurn = 2.0 * std::numbers::pi;

std::vector<float> sampled(double seconds, const std::function<double(double)> &signal)
{
    std::vector<float> samples(std::size_t(seconds * kRate));
    for (std::size_t i = 0; i < samples.size(); ++i)
        samples[i] = float(signal(double(i) / kRate));
    return samples;
}

std::vector<float> whiteNoise(std::size_t count, double rms, unsigned seed)
{
    std::mt19937 generator(seed);
    std::normal_distribution<double> normal(0.0, rms);
    std::vector<float> samples(count);
    for (float &sample : samples)
        sample = float(normal(generator));
    return samples;
}

bool near(double value, double wanted, double tolerance)
{
    if (std::abs(value - wanted) <= tolerance)
        return true;
    qWarning("%g is not %g +- %g", value, wanted, tolerance);
    return false;
}

// 1 - (decaying cosine): a second-order step response with its textbook figures.
double secondOrder(double t, double omega, double zeta)
{
    const double damped = omega * std::sqrt(1.0 - zeta * zeta);
    return 1.0
        - std::exp(-zeta * omega * t) * (std::cos(damped * t) + zeta * omega / damped * std::sin(damped * t));
}

FrequencyResponse responseOf(const std::function<std::complex<double>(std::complex<double>)> &loop,
                             double resolution, double highest)
{
    FrequencyResponse response;
    response.resolution = resolution;
    response.segments = 10;
    for (double hz = 0.0; hz <= highest; hz += resolution) {
        response.gain.push_back(hz > 0.0 ? loop({0.0, kTurn * hz}) : 1e6);
        response.coherence.push_back(1.0);
    }
    return response;
}

}  // namespace

class TestAnalysis : public QObject
{
    Q_OBJECT
private slots:
    void gainsAsSliders();
    void accelerometerIsCalibrated();
    void sphereOfAFieldIsFound();
    void whatIsNoSphereIsTold();
    void toneHasItsFrequencyAndAmplitude_data();
    void toneHasItsFrequencyAndAmplitude();
    void whiteNoiseIsFlatAndKeepsItsPower();
    void peaksAreFoundAmongNoise();
    void noiseAloneHasNoPeaks();
    void badOptionsAreRefused_data();
    void badOptionsAreRefused();
    void bandsSplitAnError();
    void bandsBeyondTheRateAreUnknown();
    void driftIsNoError();
    void secondOrderStep_data();
    void secondOrderStep();
    void stepThatNeverSettlesSaysSo();
    void noStepIsRefused();
    void runsAreAveraged();
    void jumpsOfATargetAreFound();
    void filterIsIdentified();
    void coherenceTellsForeignNoise();
    void marginsOfAKnownLoop();
    void openLoopUndoesTheFeedback();
    void holesAreNotJudged();
    void notchCostsPhase();
    void lowPassLags();
    void resonanceOfThePlantIsFoundAndNotchedAway();
    void simulatedLoopHasTheMarginsOfItsMathematics();
    void stepsAreCutAtTheTarget();
    void plantStepsAsItsMathematicsSays_data();
    void plantStepsAsItsMathematicsSays();
    void plantHasTheMarginsOfItsMathematics_data();
    void plantHasTheMarginsOfItsMathematics();
    void samplesComeOutOfTheStore();
    void polledSamplesArePutOnAGrid();
    void holesInTheStoreAreBridgedOrSplit();
};

void TestAnalysis::toneHasItsFrequencyAndAmplitude_data()
{
    QTest::addColumn<double>("hz");
    QTest::addColumn<int>("window");
    for (const double hz : {12.5, 37.3, 110.0, 417.7}) {
        QTest::addRow("%g Hz, Hann", hz) << hz << int(WindowShape::Hann);
        QTest::addRow("%g Hz, flat top", hz) << hz << int(WindowShape::FlatTop);
    }
}

void TestAnalysis::toneHasItsFrequencyAndAmplitude()
{
    QFETCH(double, hz);
    QFETCH(int, window);
    const auto samples = sampled(10.0, [hz](double t) { return 5.0 + 3.0 * std::sin(kTurn * hz * t); });
    const auto result = spectrum(samples, kRate, {2048, 0.5, WindowShape(window)});
    QVERIFY(result);
    const auto peaks = findPeaks(*result);
    QVERIFY(!peaks.empty());
    QVERIFY(near(peaks[0].frequency, hz, result->resolution * 0.15));
    QVERIFY(near(peaks[0].rms, 3.0 / std::numbers::sqrt2, 0.03));
    QVERIFY(
        near(result->bandRms(0.0, kRate / 2), 3.0 / std::numbers::sqrt2, 0.03));  // the mean does not count
    if (window == int(WindowShape::FlatTop)) {
        const auto bin = std::size_t(std::lround(hz / result->resolution));
        QVERIFY(near(result->toneRms(bin), 3.0 / std::numbers::sqrt2, 0.02));
    }
}

void TestAnalysis::whiteNoiseIsFlatAndKeepsItsPower()
{
    const auto result = spectrum(whiteNoise(200000, 2.0, 1), kRate);
    QVERIFY(result);
    QVERIFY(near(result->bandRms(0.0, kRate / 2), 2.0, 0.02));
    // Evenly spread: 4 unit² over 625 Hz.
    for (double from = 50.0; from < 600.0; from += 100.0)
        QVERIFY(near(result->bandRms(from, from + 50.0), std::sqrt(4.0 * 50.0 / 625.0), 0.03));
    QVERIFY(result->segments > 300);
}

void TestAnalysis::peaksAreFoundAmongNoise()
{
    auto samples = whiteNoise(25000, 1.0, 2);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const double t = double(i) / kRate;
        samples[i] += float(0.8 * std::sin(kTurn * 61.0 * t) + 0.4 * std::sin(kTurn * 143.0 * t));
    }
    const auto result = spectrum(samples, kRate);
    QVERIFY(result);
    const auto peaks = findPeaks(*result);
    QCOMPARE(peaks.size(), std::size_t(2));
    QVERIFY(near(peaks[0].frequency, 61.0, 0.4));
    QVERIFY(near(peaks[1].frequency, 143.0, 0.4));
    QVERIFY(near(peaks[0].rms, 0.8 / std::numbers::sqrt2, 0.1));
    QVERIFY(peaks[0].height > peaks[1].height);
    QVERIFY(peaks[0].width < 4.0);
    QCOMPARE(findPeaks(*result, 1).size(), std::size_t(1));
    QCOMPARE(findPeaks(*result, 5, 100.0).size(), std::size_t(1));
}

void TestAnalysis::noiseAloneHasNoPeaks()
{
    const auto result = spectrum(whiteNoise(60000, 1.0, 3), kRate);
    QVERIFY(result);
    QVERIFY(findPeaks(*result).empty());
}

void TestAnalysis::badOptionsAreRefused_data()
{
    QTest::addColumn<int>("samples");
    QTest::addColumn<int>("length");
    QTest::addColumn<double>("overlap");
    QTest::addColumn<double>("rate");
    QTest::addRow("too few samples") << 1000 << 1024 << 0.5 << kRate;
    QTest::addRow("none") << 0 << 1024 << 0.5 << kRate;
    QTest::addRow("length 0") << 5000 << 0 << 0.5 << kRate;
    QTest::addRow("negative length") << 5000 << -1024 << 0.5 << kRate;
    QTest::addRow("odd length") << 5000 << 1023 << 0.5 << kRate;
    QTest::addRow("all overlap") << 5000 << 1024 << 1.0 << kRate;
    QTest::addRow("overlap NaN") << 5000 << 1024 << std::nan("") << kRate;
    QTest::addRow("no rate") << 5000 << 1024 << 0.5 << 0.0;
    QTest::addRow("endless rate") << 5000 << 1024 << 0.5 << HUGE_VAL;
}

void TestAnalysis::badOptionsAreRefused()
{
    QFETCH(int, samples);
    QFETCH(int, length);
    QFETCH(double, overlap);
    QFETCH(double, rate);
    const std::vector<float> values(std::size_t(samples), 1.0F);
    const SpectrumOptions options{length, overlap, WindowShape::Hann};
    const auto result = spectrum(values, rate, options);
    QVERIFY(!result);
    const bool tooFew = options.length == 1024 && samples < 1024;
    QCOMPARE(result.error().code, tooFew ? ErrorCode::TooFewSamples : ErrorCode::InvalidArgument);
    QVERIFY(!result.error().detail.isEmpty());
    QVERIFY(!frequencyResponse(values, values, rate, options));
}

void TestAnalysis::bandsSplitAnError()
{
    const auto error = sampled(20.0, [](double t) {
        return 1.0 * std::sin(kTurn * 2.0 * t) + 0.5 * std::sin(kTurn * 11.0 * t)
            + 0.25 * std::sin(kTurn * 90.0 * t);
    });
    const auto bands = holdingQuality(error, kRate);
    QCOMPARE(bands.size(), std::size_t(3));
    const std::array<double, 3> amplitudes{1.0, 0.5, 0.25};
    for (std::size_t i = 0; i < 3; ++i) {
        QVERIFY(bands[i].known);
        QVERIFY(near(bands[i].rms, amplitudes[i] / std::numbers::sqrt2, 0.01));
        QVERIFY(near(bands[i].peak, amplitudes[i], 0.03));
    }
}

void TestAnalysis::bandsBeyondTheRateAreUnknown()
{
    const auto error = whiteNoise(400, 1.0, 4);
    const auto slow = holdingQuality(error, 50.0);  // 8 s at 50 per second
    QVERIFY(slow[0].known);
    QVERIFY(slow[1].known);
    QCOMPARE(slow[1].band.to, 25.0);
    QVERIFY(!slow[2].known);
    QCOMPARE(slow[2].rms, 0.0);
    const auto brief = holdingQuality(error, kRate);  // a third of a second
    QVERIFY(!brief[0].known);
    QVERIFY(brief[2].known);
    for (const BandQuality &band : holdingQuality({}, kRate))
        QVERIFY(!band.known);
}

void TestAnalysis::driftIsNoError()
{
    const auto error = sampled(10.0, [](double t) { return 40.0 + 3.0 * t; });
    for (const BandQuality &band : holdingQuality(error, kRate))
        QVERIFY(near(band.rms, 0.0, 1e-3));
}

void TestAnalysis::secondOrderStep_data()
{
    QTest::addColumn<double>("zeta");
    QTest::addColumn<double>("way");
    for (const double zeta : {0.3, 0.5, 0.7, 0.9}) {
        QTest::addRow("damping %g", zeta) << zeta << 10.0;
        QTest::addRow("damping %g, downwards", zeta) << zeta << -5.0;
    }
}

void TestAnalysis::secondOrderStep()
{
    QFETCH(double, zeta);
    QFETCH(double, way);
    const double omega = 40.0;
    const auto response = sampled(1.5, [&](double t) { return 2.0 + way * secondOrder(t, omega, zeta); });
    const auto metrics = stepMetrics(response, kRate, 2.0, 2.0 + way);
    QVERIFY(metrics);
    // Overshoot and time of the peak: Ogata, Modern Control Engineering, transient response of second-order
    // systems.
    const double root = std::sqrt(1.0 - zeta * zeta);
    QVERIFY(near(metrics->overshoot, 100.0 * std::exp(-std::numbers::pi * zeta / root), 0.5));
    QVERIFY(near(metrics->peakSeconds, std::numbers::pi / (omega * root), 0.002));
    QVERIFY(near(metrics->error, 0.0, 0.01));
    // Rise and settling against a search through the closed form.
    double low = 0.0, high = 0.0, settled = 0.0;
    for (double t = 0.0; t < 1.5; t += 1e-5) {
        const double covered = secondOrder(t, omega, zeta);
        if (low == 0.0 && covered >= 0.1)
            low = t;
        if (high == 0.0 && covered >= 0.9)
            high = t;
        if (std::abs(covered - 1.0) > 0.05)
            settled = t;
    }
    QVERIFY(metrics->riseSeconds && near(*metrics->riseSeconds, high - low, 0.0005));
    QVERIFY(metrics->settlingSeconds && near(*metrics->settlingSeconds, settled, 0.0015));
}

void TestAnalysis::stepThatNeverSettlesSaysSo()
{
    const auto response = sampled(1.0, [](double t) { return 1.0 + 0.25 * std::sin(kTurn * 8.0 * t); });
    const auto metrics = stepMetrics(response, kRate, 0.0, 1.0);
    QVERIFY(metrics);
    QVERIFY(!metrics->settlingSeconds);
    QVERIFY(near(metrics->overshoot, 25.0, 10.0));
    QVERIFY(metrics->noise > 0.1);
}

void TestAnalysis::noStepIsRefused()
{
    QVERIFY(!stepMetrics(whiteNoise(1000, 0.1, 5), kRate, 0.0, 5.0));
    QVERIFY(!stepMetrics(std::vector<float>(10, 1.0F), kRate, 0.0, 1.0));
    QVERIFY(!stepMetrics(std::vector<float>(100, 1.0F), 0.0, 0.0, 1.0));
    QVERIFY(!stepMetrics({}, kRate, 0.0, 1.0));
}

void TestAnalysis::runsAreAveraged()
{
    QCOMPARE(averageRuns({{1, 2, 3}, {3, 4}}), (std::vector<float>{2, 3}));
    QVERIFY(averageRuns({}).empty());
}

void TestAnalysis::jumpsOfATargetAreFound()
{
    auto target = sampled(6.0, [](double t) {
        return t < 1.0 ? 0.0 : t < 3.0 ? 4.0 : t < 5.0 ? -1.0 : -1.0 + (t - 5.0) * 9.0;
    });
    const auto steps = findSteps(target, kRate, 1.0, 0.4);
    QCOMPARE(steps.size(), std::size_t(2));  // the ramp at the end is no step
    QVERIFY(near(double(steps[0].index) / kRate, 1.0, 0.0009));
    QCOMPARE(steps[0].from, 0.0);
    QCOMPARE(steps[0].to, 4.0);
    QVERIFY(near(double(steps[1].index) / kRate, 3.0, 0.0009));
    QCOMPARE(steps[1].to, -1.0);
    QVERIFY(findSteps(target, kRate, 8.0, 0.4).empty());
    QVERIFY(findSteps({}, kRate, 1.0, 0.4).empty());
}

void TestAnalysis::filterIsIdentified()
{
    const auto input = whiteNoise(125000, 1.0, 6);
    Biquad lowPass = Biquad::lowPass(40.0, kRate);
    std::vector<float> output;
    for (const float sample : input)
        output.push_back(float(lowPass.process(double(sample))));
    const auto response = frequencyResponse(input, output, kRate);
    QVERIFY(response);
    for (const double hz : {5.0, 20.0, 40.0, 80.0}) {
        const auto bin = std::size_t(std::lround(hz / response->resolution));
        const auto wanted = lowPassResponse(40.0, response->frequency(bin));
        QVERIFY(near(response->gainDb(bin), 20.0 * std::log10(std::abs(wanted)), 0.8));
        QVERIFY(near(response->phaseDeg(bin), -lagDeg(wanted), 4.0));
        QVERIFY(response->coherence[bin] > 0.97);
    }
}

void TestAnalysis::coherenceTellsForeignNoise()
{
    const auto input = whiteNoise(125000, 1.0, 7);
    auto output = whiteNoise(125000, 1.0, 8);
    const auto foreign = frequencyResponse(input, output, kRate);
    for (std::size_t i = 0; i < output.size(); ++i)
        output[i] += input[i];
    const auto half = frequencyResponse(input, output, kRate);
    QVERIFY(foreign && half);
    double foreignMean = 0.0, halfMean = 0.0;
    for (std::size_t bin = 10; bin < 500; ++bin) {
        foreignMean += foreign->coherence[bin] / 490.0;
        halfMean += half->coherence[bin] / 490.0;
    }
    QVERIFY(foreignMean < 0.02);
    QVERIFY(near(halfMean, 0.5, 0.03));
}

void TestAnalysis::marginsOfAKnownLoop()
{
    // L = 6 / (s (s + 1) (s + 2)) oscillates exactly; 3 of it has 6.02 dB of gain margin at sqrt(2) rad/s.
    const auto loop
        = responseOf([](std::complex<double> s) { return 3.0 / (s * (s + 1.0) * (s + 2.0)); }, 0.0005, 2.0);
    const Margins m = margins(loop);
    QVERIFY(m.gainDb && near(*m.gainDb, 6.0206, 0.02));
    QVERIFY(near(*m.gainHz, std::numbers::sqrt2 / kTurn, 0.001));
    QVERIFY(m.phaseDeg && near(*m.phaseDeg, 20.04, 0.1));
    QVERIFY(near(*m.phaseHz, 0.9693 / kTurn, 0.001));
    double peak = 0.0;
    for (std::size_t i = 1; i < loop.gain.size(); ++i)
        peak = std::max(peak, 1.0 / std::abs(1.0 + loop.gain[i]));
    QVERIFY(near(m.sensitivityDb, 20.0 * std::log10(peak), 1e-6));
    // Ten times the gain: the margin is negative, it oscillates.
    const auto wild
        = responseOf([](std::complex<double> s) { return 30.0 / (s * (s + 1.0) * (s + 2.0)); }, 0.0005, 2.0);
    QVERIFY(*margins(wild).gainDb < -13.9);
    QVERIFY(*margins(wild).phaseDeg < 0.0);
    // An integrator alone never reaches -180 degrees.
    const auto calm = responseOf([](std::complex<double> s) { return 3.0 / s; }, 0.001, 2.0);
    QVERIFY(!margins(calm).gainDb);
    QVERIFY(near(*margins(calm).phaseDeg, 90.0, 0.5));
}

void TestAnalysis::openLoopUndoesTheFeedback()
{
    const auto loop
        = responseOf([](std::complex<double> s) { return 3.0 / (s * (s + 1.0) * (s + 2.0)); }, 0.01, 2.0);
    FrequencyResponse closed = loop;
    for (auto &gain : closed.gain)
        gain = gain / (1.0 + gain);
    const FrequencyResponse again = openLoop(closed);
    for (std::size_t i = 1; i < loop.gain.size(); ++i)
        QVERIFY(std::abs(again.gain[i] - loop.gain[i]) < 1e-9 * (1.0 + std::abs(loop.gain[i])));
    closed.gain[3] = 1.0;  // feedback without end: no division by nothing
    QVERIFY(std::isfinite(std::abs(openLoop(closed).gain[3])));
}

void TestAnalysis::holesAreNotJudged()
{
    auto loop
        = responseOf([](std::complex<double> s) { return 3.0 / (s * (s + 1.0) * (s + 2.0)); }, 0.001, 2.0);
    for (std::size_t i = 0; i < loop.coherence.size(); ++i) {
        if (std::abs(loop.frequency(i) - std::numbers::sqrt2 / kTurn) < 0.05)
            loop.coherence[i] = 0.1;
    }
    const Margins m = margins(loop);
    QVERIFY(!m.gainDb);
    QVERIFY(m.bins > 100);
    QCOMPARE(margins(loop, 1.1).bins, 0);
}

void TestAnalysis::notchCostsPhase()
{
    const NotchShape notch{80.0, 20.0, 12.0};
    QVERIFY(near(20.0 * std::log10(std::abs(notchResponse(notch, 80.0))), -12.0, 0.01));
    QVERIFY(
        near(20.0 * std::log10(std::abs(notchResponse(notch, 70.6))), -6.0, 0.4));  // half of it at the edges
    QVERIFY(lagDeg(notchResponse(notch, 40.0)) > 5.0);
    QVERIFY(lagDeg(notchResponse(notch, 160.0)) < -5.0);
    QCOMPARE(notchResponse({0.0, 20.0, 12.0}, 50.0), std::complex<double>(1.0));
    // The simulated board's sampled filter agrees.
    const auto input = whiteNoise(200000, 1.0, 9);
    Biquad filter = Biquad::notch(notch.hz, notch.width, notch.depthDb, kRate);
    std::vector<float> output;
    for (const float sample : input)
        output.push_back(float(filter.process(double(sample))));
    const auto response = frequencyResponse(input, output, kRate, {2048, 0.5, WindowShape::Hann});
    QVERIFY(response);
    for (const double hz : {30.0, 60.0, 80.0, 120.0}) {
        const auto bin = std::size_t(std::lround(hz / response->resolution));
        const auto wanted = notchResponse(notch, response->frequency(bin));
        QVERIFY(near(-response->phaseDeg(bin), lagDeg(wanted), 3.0));
        QVERIFY(near(std::abs(response->gain[bin]), std::abs(wanted), 0.03));
    }
}

void TestAnalysis::lowPassLags()
{
    QVERIFY(near(lagDeg(lowPassResponse(50.0, 50.0)), 90.0, 1e-6));
    QVERIFY(near(20.0 * std::log10(std::abs(lowPassResponse(50.0, 50.0))), -3.0103, 1e-3));
    QCOMPARE(lowPassResponse(0.0, 10.0), std::complex<double>(1.0));
}

void TestAnalysis::resonanceOfThePlantIsFoundAndNotchedAway()
{
    const auto gyroSpectrum = [](const AxisGains &gains) {
        Stabilizer stabilizer(3);
        stabilizer.imu().gyroCorrection = stabilizer.imu().gyroBias;
        stabilizer.imu().accCorrection = stabilizer.imu().accError;
        for (const Axis axis : kAxes)
            stabilizer.setGains(axis, gains);
        stabilizer.setMotorsOn(true);
        std::vector<float> gyro;
        for (int i = 0; i < int(22.0 * kRate); ++i) {
            stabilizer.step();
            if (i >= int(2.0 * kRate))
                gyro.push_back(float(stabilizer.gyro(Axis::Roll)));
        }
        return *spectrum(gyro, kRate);
    };
    const double resonance = simulatedMechanics(Axis::Roll).resonanceHz;
    AxisGains gains;
    gains.p = 60;
    gains.i = 15;
    gains.d = 60;
    gains.power = 150.0 / 255;
    gains.dLpfHz = 200;
    const Spectrum ringing = gyroSpectrum(gains);
    const auto peaks = findPeaks(ringing, 5, 25.0);
    QVERIFY(!peaks.empty());
    QVERIFY2(near(peaks[0].frequency, resonance, resonance * 0.15),
             qPrintable(u"%1 Hz"_s.arg(peaks[0].frequency)));
    // What the spectrum shows is put into a notch, as the operator would.
    gains.notches[0] = {peaks[0].frequency, std::max(20.0, peaks[0].width), 20.0};
    const Spectrum calm = gyroSpectrum(gains);
    QVERIFY(calm.bandRms(resonance * 0.8, resonance * 1.2)
            < ringing.bandRms(resonance * 0.8, resonance * 1.2) / 2);
}

void TestAnalysis::simulatedLoopHasTheMarginsOfItsMathematics()
{
    // A sampled loop of an integrator with delay: y[n+1] = y[n] + k (r[n-d] - y[n-d]). L(z) = k z^-d / (z -
    // 1).
    constexpr double k = 0.02;
    constexpr int delay = 20;
    const auto reference = whiteNoise(400000, 1.0, 10);
    std::vector<float> output(reference.size());
    double y = 0.0;
    std::vector<double> errors(reference.size());
    for (std::size_t n = 0; n < reference.size(); ++n) {
        output[n] = float(y);
        errors[n] = double(reference[n]) - y;
        if (n >= delay)
            y += k * errors[n - delay];
    }
    const auto closed = frequencyResponse(reference, output, kRate, {4096, 0.5, WindowShape::Hann});
    QVERIFY(closed);
    const Margins measured = margins(openLoop(*closed), 0.5, 1.0, 40.0);
    FrequencyResponse exact;
    exact.resolution = 0.01;
    for (double hz = 0.0; hz < 40.0; hz += exact.resolution) {
        const std::complex<double> z = std::polar(1.0, kTurn * hz / kRate);
        exact.gain.push_back(hz > 0.0 ? k * std::pow(z, -delay) / (z - 1.0) : 1e6);
        exact.coherence.push_back(1.0);
    }
    const Margins wanted = margins(exact);
    QVERIFY(measured.gainDb && measured.phaseDeg && wanted.gainDb && wanted.phaseDeg);
    QVERIFY(near(*measured.gainDb, *wanted.gainDb, 0.8));
    QVERIFY(near(*measured.gainHz, *wanted.gainHz, 0.5));
    QVERIFY(near(*measured.phaseDeg, *wanted.phaseDeg, 4.0));
    QVERIFY(near(*measured.phaseHz, *wanted.phaseHz, 0.3));
    QVERIFY(near(measured.sensitivityDb, wanted.sensitivityDb, 0.8));
}

void TestAnalysis::stepsAreCutAtTheTarget()
{
    std::vector<float> target;
    std::vector<float> response;
    for (const float level : {1.0F, 3.0F, 1.0F, 3.0F}) {
        for (int i = 0; i < 100; ++i) {
            target.push_back(level);
            response.push_back(i < 10 && target.size() > 100 ? 4.0F - level
                                                             : level);  // follows ten samples later
        }
    }
    const StepRuns runs = cutSteps(target, response, 100, 1.0, 3.0, 0.8);
    QCOMPARE(runs.target.size(), std::size_t(3));
    for (std::size_t run = 0; run < 3; ++run) {
        QCOMPARE(runs.target[run].size(), std::size_t(80));
        QCOMPARE(runs.target[run].front(), 1.0F);
        QCOMPARE(runs.response[run][9], 0.0F);
        QCOMPARE(runs.response[run][10], 1.0F);
    }
    // A run that would end behind the record is left out, and nothing is cut from nothing.
    QCOMPARE(cutSteps(target, response, 100, 1.0, 3.0, 1.5).target.size(), std::size_t(2));
    const auto all = measureSteps(target, response, 100, 0.8);
    QVERIFY(all);
    QCOMPARE(all->runs.response.size(), std::size_t(3));
    QCOMPARE(all->metrics.overshoot, 0.0);
    QVERIFY(!measureSteps(std::vector<float>(500, 1.0F), response, 100, 0.8));
    QVERIFY(!measureSteps({}, {}, 100, 0.8));
    // A stick in units of its own: the same steps are found, whatever the response is counted in.
    std::vector<float> scaled;
    for (const float value : response)
        scaled.push_back(-30 * value + 7);
    const auto unknown = measureCommandSteps(target, scaled, 100, 0.8);
    QVERIFY(unknown);
    QCOMPARE(unknown->runs.response.size(), all->runs.response.size());
    QVERIFY(std::abs(unknown->metrics.overshoot - all->metrics.overshoot) < 3);
    QVERIFY(std::abs(unknown->metrics.riseSeconds.value() - all->metrics.riseSeconds.value()) < 0.02);
    QVERIFY(!measureCommandSteps(std::vector<float>(500, 1.0F), response, 100, 0.8));
    QVERIFY(!measureCommandSteps({}, {}, 100, 0.8));
    QVERIFY(cutSteps({}, {}, 100, 1.0, 3.0, 0.8).target.empty());
    QVERIFY(cutSteps(target, response, 100, 1.0, 1.0, 0.8).target.empty());
}

namespace {

struct LoopRecord
{
    std::vector<float> target;
    std::vector<float> angle;
};

// The simulated yaw axis on a tripod, its target moved by a function of time.
template <typename Function> LoopRecord runLoop(const AxisGains &gains, double duration, Function &&offset)
{
    Stabilizer stabilizer(5);
    stabilizer.hand().setStrength(0.0);
    stabilizer.imu().gyroCorrection = stabilizer.imu().gyroBias;
    stabilizer.imu().accCorrection = stabilizer.imu().accError;
    for (const Axis axis : kAxes)
        stabilizer.setGains(axis, gains);
    stabilizer.setMotorsOn(true);
    for (int i = 0; i < 2500; ++i)
        stabilizer.step();
    LoopRecord record;
    for (double t = 0; t < duration; t += Stabilizer::kCycle) {
        stabilizer.setTarget(Axis::Yaw, offset(t));
        record.target.push_back(float(offset(t)));
        record.angle.push_back(float(stabilizer.estimate(Axis::Yaw)));
        stabilizer.step();
    }
    return record;
}

AxisGains loopGains(double p, double i, double d)
{
    AxisGains gains;
    gains.p = p;
    gains.i = i;
    gains.d = d;
    gains.power = 1.0;
    gains.dLpfHz = 200;
    return gains;
}

void addLoops()
{
    QTest::addColumn<double>("p");
    QTest::addColumn<double>("i");
    QTest::addColumn<double>("d");
    QTest::newRow("calm") << 25.0 << 5.0 << 30.0;
    QTest::newRow("usual") << 35.0 << 15.0 << 30.0;
    QTest::newRow("lively") << 60.0 << 20.0 << 25.0;
}

}  // namespace

void TestAnalysis::plantStepsAsItsMathematicsSays_data()
{
    addLoops();
}

void TestAnalysis::plantStepsAsItsMathematicsSays()
{
    QFETCH(double, p);
    QFETCH(double, i);
    QFETCH(double, d);
    const AxisGains gains = loopGains(p, i, d);
    const MotionTestPlan plan{MotionTestPlan::Kind::Steps, Axis::Yaw, 2.0, 12, 1.0};
    const LoopRecord record = runLoop(gains, plan.duration(), [&](double t) { return plan.offsetAt(t); });
    const StepRuns runs = cutSteps(record.target, record.angle, kRate, 0.0, plan.degrees, 0.95);
    QCOMPARE(runs.response.size(), std::size_t(12));
    const auto measured = stepMetrics(averageRuns(runs.response), kRate, 0.0, 1.0);
    const auto wanted
        = stepMetrics(LoopMath{simulatedMechanics(Axis::Yaw), gains}.step(kRate, 0.95), kRate, 0.0, 1.0);
    QVERIFY(measured && wanted && measured->riseSeconds && wanted->riseSeconds);
    qInfo("rise %.1f ms, mathematics %.1f ms; overshoot %.1f %%, mathematics %.1f %%",
          *measured->riseSeconds * 1000, *wanted->riseSeconds * 1000, measured->overshoot, wanted->overshoot);
    // Dry friction and cogging are not in the mathematics: an eighth of the time, five and a half points of
    // overshoot.
    QVERIFY(near(*measured->riseSeconds, *wanted->riseSeconds, 0.125 * *wanted->riseSeconds));
    QVERIFY(near(measured->overshoot, wanted->overshoot, 5.5));
}

void TestAnalysis::plantHasTheMarginsOfItsMathematics_data()
{
    addLoops();
}

void TestAnalysis::plantHasTheMarginsOfItsMathematics()
{
    QFETCH(double, p);
    QFETCH(double, i);
    QFETCH(double, d);
    const AxisGains gains = loopGains(p, i, d);
    MotionTestPlan plan{MotionTestPlan::Kind::Sweep, Axis::Yaw, 2.0};
    plan.toHz = 20;
    plan.sweepSeconds = 40;
    // Set-points go out every 20 ms, so the target moves in stairs.
    const LoopRecord record = runLoop(gains, plan.duration(),
                                      [&](double t) { return plan.offsetAt(std::floor(t / 0.02) * 0.02); });
    const auto closed = frequencyResponse(record.target, record.angle, kRate, {4096, 0.5, WindowShape::Hann});
    QVERIFY(closed);
    const Margins measured = margins(openLoop(*closed), 0.8, 0.7, 20.0);
    const Margins wanted
        = margins(LoopMath{simulatedMechanics(Axis::Yaw), gains}.openLoop(20.0), 0.8, 0.7, 20.0);
    qInfo("phase margin %.1f at %.2f Hz, mathematics %.1f at %.2f Hz; sensitivity %.2f dB, mathematics %.2f "
          "dB; gain margin "
          "%.1f dB, mathematics %.1f dB",
          measured.phaseDeg.value_or(NAN), measured.phaseHz.value_or(NAN), wanted.phaseDeg.value_or(NAN),
          wanted.phaseHz.value_or(NAN), measured.sensitivityDb, wanted.sensitivityDb,
          measured.gainDb.value_or(NAN), wanted.gainDb.value_or(NAN));
    QVERIFY(measured.phaseDeg && wanted.phaseDeg);
    QVERIFY(near(*measured.phaseDeg, *wanted.phaseDeg, 3.0));
    QVERIFY(near(*measured.phaseHz, *wanted.phaseHz, 0.05 * *wanted.phaseHz));
    QVERIFY(near(measured.sensitivityDb, wanted.sensitivityDb, 0.5));
    // Where the gain margin is read the loop passes a hundredth of the motion, and dry friction takes its
    // part of that.
    QVERIFY(measured.gainDb && wanted.gainDb);
    QVERIFY(near(*measured.gainDb, *wanted.gainDb, 2.5));
}

void TestAnalysis::samplesComeOutOfTheStore()
{
    TelemetryStore store(2);
    auto group = store.defineGroup({0, 1}, 1.0 / kRate);
    for (int i = 0; i < 5000; ++i) {
        const std::array<float, 2> row{float(i), float(i) / 2};
        store.append(*group, store.origin() + durationFromSeconds(i / kRate), row);
    }
    const auto all = uniformSamples(store, 0, -1, -1e9, 1e9);
    QVERIFY(all);
    QCOMPARE(all->values.size(), std::size_t(5000));
    QCOMPARE(all->rate, kRate);
    QCOMPARE(all->filled, std::size_t(0));
    const auto part = uniformSamples(store, 0, 1, 1.0 - 1e-6, 2.0 - 1e-6);
    QVERIFY(part);
    QCOMPARE(part->values.size(), std::size_t(1250));
    QCOMPARE(part->values.front(), 625.0F);
    QVERIFY(near(part->start, 1.0, 1e-6));
    QVERIFY(near(part->end(), 2.0, 1e-6));
    QVERIFY(!uniformSamples(store, 0, -1, 10.0, 20.0));
    QVERIFY(!uniformSamples(store, 7, -1, 0.0, 1.0));
    // Streams that were arranged anew a moment ago carry little.
    const auto before = uniformSamples(store, 0, -1, 0.0, 5.0);
    const auto renewed = store.defineGroup({0, 1}, 0.01);
    for (int row = 0; row < 2; ++row)
        store.append(*renewed, store.origin() + durationFromSeconds(4.98 + 0.01 * row),
                     std::array{0.0F, 0.0F});
    const auto after = uniformSamples(store, 0, -1, 0.0, 5.0);
    QVERIFY(before && after && before->values.size() > 100 && after->values.size() == before->values.size());
    auto polled = store.defineGroup({1}, 0.0);
    store.append(*polled, store.origin() + durationFromSeconds(30.0), std::array<float, 1>{1.0F});
    QVERIFY(!uniformSamples(store, 1, -1, 29.0, 31.0));  // one sample has no rate
}

// A board that is asked for each row answers about evenly: the tone in it keeps its frequency and height.
void TestAnalysis::polledSamplesArePutOnAGrid()
{
    TelemetryStore store(2);
    auto group = store.defineGroup({0, 1}, 0.0);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> jitter(-0.002, 0.002);
    for (int i = 0; i < 3000; ++i) {
        const double time = 0.012 * i + jitter(random);
        if (i % 100 == 50)
            continue;  // an answer that was lost
        if (i >= 2000 && i < 2030)
            continue;  // a hole of 0.36 s
        const std::array<float, 2> row{float(2.0 * std::sin(2 * std::numbers::pi * 5.0 * time)), float(time)};
        store.append(*group, store.origin() + durationFromSeconds(time), row);
    }
    const auto samples = uniformSamples(store, 0, -1, -1e9, 1e9);
    QVERIFY(samples && samples->polled);
    QVERIFY(near(samples->rate, 1 / 0.012, 1.5));
    QVERIFY(samples->end() < 24.1);  // up to the hole: that is the longest piece
    QVERIFY(samples->filled >= 20 && samples->filled < 30);
    const auto tone = spectrum(samples->values, samples->rate, {1024, 0.5, WindowShape::Hann});
    QVERIFY(tone);
    const auto peaks = findPeaks(*tone);
    QVERIFY(!peaks.empty());
    QVERIFY(near(peaks.front().frequency, 5.0, 0.05));
    QVERIFY(near(peaks.front().rms, std::sqrt(2.0), 0.06));
    // Times stand where they stood: a ramp of time shows its own grid.
    const auto ramp = uniformSamples(store, 1, -1, -1e9, 1e9);
    QVERIFY(ramp);
    for (std::size_t i = 0; i < ramp->values.size(); ++i)
        QVERIFY(near(double(ramp->values[i]), ramp->start + double(i) / ramp->rate, 1e-3));
    QVERIFY(!uniformSamples(store, 0, -1, 0.0, 0.1));  // too few to tell a rate
}

void TestAnalysis::holesInTheStoreAreBridgedOrSplit()
{
    TelemetryStore store(1);
    auto group = store.defineGroup({0}, 1.0 / kRate);
    for (int i = 0; i < 3000; ++i) {
        if ((i >= 500 && i < 503) || (i >= 1000 && i < 1100))
            continue;
        const TimePoint at = store.origin() + durationFromSeconds(i / kRate);
        if (i == 503 || i == 1100)
            store.appendGap(*group, at - durationFromSeconds(1 / kRate));
        store.append(*group, at, std::array<float, 1>{float(i)});
    }
    const auto first = uniformSamples(store, 0, -1, 0.0, 0.75);
    QVERIFY(first);
    QCOMPARE(first->filled, std::size_t(3));
    for (std::size_t i = 0; i < first->values.size(); ++i)
        QVERIFY(near(double(first->values[i]), double(i), 1e-3));
    const auto longest = uniformSamples(store, 0, -1, 0.0, 10.0);
    QVERIFY(longest);
    QCOMPARE(longest->values.front(), 1100.0F);  // the piece behind the long hole
    QCOMPARE(longest->values.size(), std::size_t(1900));
}

// STorM32 errata 9.1, by hand.
void TestAnalysis::gainsAsSliders()
{
    const PidGains gains = gainsFor(50, 20);
    QCOMPARE(gains.kd, 0.4);
    QCOMPARE(gains.ki, 400.0);
    QVERIFY(std::abs(gains.kp - std::sqrt(80.0)) < 1e-12);
    const auto [damping, stability] = slidersFor(gains);
    QCOMPARE(damping, 50.0);
    QCOMPARE(stability, 20.0);
    QCOMPARE(slidersFor({0, 9999, 9}), (std::pair{100.0, 100.0}));
    const PidShape shape = shapeOf({4, 100, 0.05});
    QVERIFY(std::abs(shape.frequency - 7.1176) < 1e-3);
    QVERIFY(std::abs(shape.damping - 0.8944) < 1e-3);
    QVERIFY(std::abs(shape.delayMs - 15.5525) < 1e-3);
    QCOMPARE(shapeOf({1, 0, 0}).frequency, 0.0);
    QCOMPARE(shapeOf({1, 5, 0}).damping, 0.0);
}

// A sensor with known errors is seen through (STorM32 errata 9.2).
void TestAnalysis::accelerometerIsCalibrated()
{
    constexpr double kOne = 8192;
    const AccReading zero{120, -340, 55};
    const AccReading scale{8100, 8300, 8250};
    std::array<AccReading, kAccFaces> readings{};
    for (int face = 0; face < kAccFaces; ++face) {
        constexpr std::array<std::size_t, 3> axisOf{2, 0, 1};
        readings[std::size_t(face)] = zero;
        const std::size_t axis = axisOf[std::size_t(face) / 2];
        readings[std::size_t(face)][axis] += face % 2 ? -scale[axis] : scale[axis];
        QCOMPARE(faceUp(readings[std::size_t(face)], kOne), face);
    }
    AccCalibration found = sixPointCalibration(readings);
    QCOMPARE(found.zero, (std::array{120, -340, 55}));
    QCOMPARE(found.scale, (std::array{8100, 8300, 8250}));
    QCOMPARE(found.quality, 0.0);
    QVERIFY(isPlausible(found, kOne));
    readings[2][1] += 1200;  // it did not lie square
    QVERIFY(std::abs(sixPointCalibration(readings).quality - 1200 / std::sqrt(12.0)) < 1.0);
    QCOMPARE(faceUp({5800, 0, 5800}, kOne), -1);
    const AccCalibration one = onePointCalibration({100, -50, 8292}, kOne);
    QCOMPARE(one.zero, (std::array{100, -50, 100}));
    QCOMPARE(one.scale, (std::array{8192, 8192, 8192}));
    for (const AccCalibration &bad :
         {AccCalibration{{3600, 0, 0}, {8192, 8192, 8192}}, AccCalibration{{0, 0, 0}, {7400, 8192, 8192}}})
        QVERIFY(!isPlausible(bad, kOne));
    QVERIFY(isPlausible({{6900, 0, 0}, {17400, 16384, 15100}}, 16384));
}

// To all sides, about a centre, with half axes of their own and noise.
static std::vector<Vector3> turned(const Vector3 &centre, const Vector3 &halves, double noise)
{
    std::mt19937 generator(7);
    std::normal_distribution<double> normal(0.0, 1.0);
    std::vector<Vector3> points(300);
    for (Vector3 &point : points) {
        Vector3 way{normal(generator), normal(generator), normal(generator)};
        way = way / way.norm();
        for (std::size_t i = 0; i < 3; ++i)
            point[i] = centre[i] + halves[i] * way[i] + noise * normal(generator);
    }
    return points;
}

void TestAnalysis::sphereOfAFieldIsFound()
{
    const Vector3 centre{900, -60, 110};  // more than its radius away
    const auto points = turned(centre, {400, 400, 400}, 4);
    const auto sphere = fitFieldSphere(points);
    QVERIFY(sphere);
    QVERIFY2((sphere->centre - centre).norm() < 2, qPrintable(QString::number(sphere->centre.x)));
    QVERIFY(near(sphere->radius, 400, 1));
    QVERIFY(near(sphere->roughness, 0.01, 0.002));
    QVERIFY(near(fieldStretch(points).value_or(0), 1, 0.02));
    QCOMPARE(directionsSeen(points, *sphere).count(), kFieldDirections);
    const auto bent = turned(centre, {440, 400, 360}, 1);
    QVERIFY(near(fieldStretch(bent).value_or(0), 440.0 / 360, 0.02));
    QVERIFY(fitFieldSphere(bent)->roughness > 0.04);
    // One half of it shows where it is, and which directions are missing.
    std::vector<Vector3> half;
    std::copy_if(points.begin(), points.end(), std::back_inserter(half),
                 [&centre](const Vector3 &point) { return point.z > centre.z; });
    const auto upper = fitFieldSphere(half);
    QVERIFY(upper && (upper->centre - centre).norm() < 10);
    const SeenDirections seen = directionsSeen(half, *upper);
    for (std::size_t i = 0; i < kFieldDirections; ++i) {
        if (std::abs(fieldDirections()[i].z) > 0.1)
            QCOMPARE(seen[i], fieldDirections()[i].z > 0);
    }
}

void TestAnalysis::whatIsNoSphereIsTold()
{
    const Vector3 centre{90, -60, 110};
    QVERIFY(!fitFieldSphere(turned({300, 200, 100}, {}, 2)));  // at rest
    QVERIFY(!fitFieldSphere(turned(centre, {400, 400, 0}, 2)));  // in a plane
    QVERIFY(!fieldStretch(turned(centre, {400, 400, 0}, 2)));
    const auto few = turned(centre, {400, 400, 400}, 2);
    QVERIFY(!fitFieldSphere(std::span(few).first(8)));
    QVERIFY(!fitFieldSphere(std::vector<Vector3>(100)));  // no sensor: nothing but zeros
}

QTEST_GUILESS_MAIN(TestAnalysis)
#include "tst_analysis.moc"
