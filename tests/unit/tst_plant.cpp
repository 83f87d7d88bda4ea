// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/simplebgc/autopidsearch.h"
#include "protocol/simulator/world/stabilizer.h"

#include <QTest>

#include <cmath>

namespace {

struct Run
{
    double rms = 0;
    double peak = 0;
    double gyroRms = 0;
    bool atStop = false;
};

AxisGains gains(double p, double i, double d, double power = 150.0 / 255)
{
    AxisGains g;
    g.p = p;
    g.i = i;
    g.d = d;
    g.power = power;
    g.dLpfHz = 200;
    return g;
}

class Bench
{
public:
    explicit Bench(unsigned seed = 3)
        : stabilizer(seed)
    {
        // A calibrated sensor, as on a board in use.
        stabilizer.imu().gyroCorrection = stabilizer.imu().gyroBias;
        stabilizer.imu().accCorrection = stabilizer.imu().accError;
        setAll(gains(35, 15, 30));
        stabilizer.setMotorsOn(true);
    }

    void setAll(const AxisGains &g)
    {
        for (const Axis axis : kAxes)
            stabilizer.setGains(axis, g);
    }

    Run run(Axis axis, double runSeconds, double settle = 2.0)
    {
        Run result;
        int samples = 0;
        for (int i = 0; i < int((settle + runSeconds) / Stabilizer::kCycle); ++i) {
            stabilizer.step();
            if (i * Stabilizer::kCycle < settle)
                continue;
            const double error = stabilizer.target(axis) - stabilizer.trueAngle(axis);
            result.rms += error * error;
            result.peak = std::max(result.peak, std::abs(error));
            result.gyroRms += stabilizer.gyro(axis) * stabilizer.gyro(axis);
            result.atStop |= stabilizer.plant(axis).isAtStop();
            ++samples;
        }
        result.rms = std::sqrt(result.rms / samples);
        result.gyroRms = std::sqrt(result.gyroRms / samples);
        return result;
    }

    Stabilizer stabilizer;
};

}  // namespace

class TestPlant : public QObject
{
    Q_OBJECT
private slots:
    void gravityIsOneG_data();
    void gravityIsOneG();
    void goodGainsHold_data();
    void goodGainsHold();
    void badGainsOscillate_data();
    void badGainsOscillate();
    void withoutPowerTheCameraIsLimp();
    void wrongInversionRunsAway();
    void swappedMotorsCannotHold();
    void weakPowerCannotHold();
    void lowBatteryWeakensTheMotors();
    void aSmallMotorIsWeaker();
    void motorsWarmWithPower();
    void resonanceShowsWhereItIs();
    void notchOnTheResonanceAllowsMoreD();
    void biasLetsYawDrift();
    void sameSeedSameMotion();
    void handShakesLikeAHand();
    void autoPidFindsGainsThatHold();
};

void TestPlant::gravityIsOneG_data()
{
    QTest::addColumn<double>("roll");
    QTest::addColumn<double>("pitch");
    QTest::newRow("level") << 0.0 << 0.0;
    QTest::newRow("tilted") << 20.0 << -30.0;
    QTest::newRow("far tilted") << 45.0 << 45.0;
    QTest::newRow("fallen") << -92.0 << 89.0;
    QTest::newRow("upside down") << 180.0 << 0.0;
    QTest::newRow("over the top") << 10.0 << 120.0;
}

// At rest the accelerometer measures gravity and nothing else, however the camera hangs, and the estimate
// stays with it.
void TestPlant::gravityIsOneG()
{
    QFETCH(double, roll);
    QFETCH(double, pitch);
    Bench bench;
    Stabilizer &s = bench.stabilizer;
    s.imu().accError = s.imu().accCorrection = {};
    s.imu().accScaleError = {1, 1, 1};
    s.setMotorsOn(false);
    s.setHeld(true);
    s.plant(Axis::Roll).setAngle(roll);
    s.plant(Axis::Pitch).setAngle(pitch);
    s.resetEstimate();
    for (int i = 0; i < int(5.0 / Stabilizer::kCycle); ++i)
        s.step();
    const auto &acc = s.acc();
    const double length = std::hypot(acc[0], acc[1], acc[2]);
    QVERIFY2(std::abs(length - 1.0) < 0.03, qPrintable(QString::number(length)));
    QVERIFY2(std::abs(s.estimate(Axis::Pitch) - pitch) < 1.5,
             qPrintable(QString::number(s.estimate(Axis::Pitch))));
    if (std::abs(pitch) < 80)  // an axis that points up or down has no reference
        QVERIFY2(std::abs(s.estimate(Axis::Roll) - roll) < 1.5,
                 qPrintable(QString::number(s.estimate(Axis::Roll))));
}

void TestPlant::goodGainsHold_data()
{
    QTest::addColumn<int>("axis");
    for (const Axis axis : kAxes)
        QTest::newRow(axisKey(axis)) << int(axis);
}

void TestPlant::goodGainsHold()
{
    QFETCH(int, axis);
    Bench bench;
    const Run run = bench.run(Axis(axis), 8.0);
    QVERIFY2(run.rms < 0.4, qPrintable(QString::number(run.rms)));
    QVERIFY(run.peak < 2.0);
}

void TestPlant::badGainsOscillate_data()
{
    QTest::addColumn<double>("p");
    QTest::addColumn<double>("d");
    QTest::newRow("too much P for its D") << 250.0 << 8.0;
    QTest::newRow("too much D") << 40.0 << 250.0;
}

void TestPlant::badGainsOscillate()
{
    QFETCH(double, p);
    QFETCH(double, d);
    Bench good;
    Bench bad;
    bad.setAll(gains(p, 15, d));
    const Run calm = good.run(Axis::Pitch, 4.0);
    const Run shaking = bad.run(Axis::Pitch, 4.0);
    QVERIFY2(shaking.gyroRms > 10 * calm.gyroRms,
             qPrintable(QStringLiteral("%1 %2").arg(shaking.gyroRms).arg(calm.gyroRms)));
}

void TestPlant::withoutPowerTheCameraIsLimp()
{
    Bench bench;
    bench.setAll(gains(35, 15, 30, 0.0));
    const Run run = bench.run(Axis::Roll, 5.0);
    QVERIFY2(run.rms > 20.0, qPrintable(QString::number(run.rms)));
}

void TestPlant::wrongInversionRunsAway()
{
    Bench bench;
    AxisGains wrong = gains(35, 15, 30);
    wrong.inverted = true;
    bench.stabilizer.setGains(Axis::Yaw, wrong);
    const Run run = bench.run(Axis::Yaw, 3.0, 1.0);
    QVERIFY(run.atStop);
    QVERIFY(run.rms > 60.0);
    // The other axes still hold.
    QVERIFY(std::abs(bench.stabilizer.trueAngle(Axis::Roll)) < 3.0);
}

void TestPlant::swappedMotorsCannotHold()
{
    Bench bench;
    bench.stabilizer.setSwappedMotors(true);
    QVERIFY(bench.run(Axis::Roll, 4.0).rms > 10.0);
    QVERIFY(bench.run(Axis::Yaw, 2.0).rms < 0.5);
}

void TestPlant::weakPowerCannotHold()
{
    Bench bench;
    bench.setAll(gains(35, 15, 30, 0.01));
    bench.stabilizer.hand().setStrength(3);
    QVERIFY(bench.run(Axis::Pitch, 4.0).rms > 5.0);
}

void TestPlant::lowBatteryWeakensTheMotors()
{
    Bench full;
    Bench empty;
    for (Bench *bench : {&full, &empty})
        bench->setAll(gains(200, 0, 60, 0.02));
    empty.stabilizer.setVoltage(5.0);
    QVERIFY(empty.run(Axis::Pitch, 4.0).rms > full.run(Axis::Pitch, 4.0).rms * 1.2);
}

void TestPlant::aSmallMotorIsWeaker()
{
    Bench large;
    Bench small;
    for (Bench *bench : {&large, &small})
        bench->setAll(gains(35, 15, 30, 0.2));
    small.stabilizer.plant(Axis::Pitch).setMotorStrength(0.05);
    QVERIFY(small.run(Axis::Pitch, 4.0).rms > large.run(Axis::Pitch, 4.0).rms * 2);
}

// With the square of it, slowly, and they cool as slowly.
void TestPlant::motorsWarmWithPower()
{
    std::array<double, 2> warmer{};
    for (std::size_t i = 0; i < warmer.size(); ++i) {
        Bench bench;
        bench.setAll(gains(35, 15, 30, i == 0 ? 0.4 : 0.8));
        const double cold = bench.stabilizer.motorCelsius(Axis::Pitch);
        bench.run(Axis::Pitch, 60);
        const double warm = bench.stabilizer.motorCelsius(Axis::Pitch);
        warmer[i] = warm - cold;
        bench.stabilizer.setMotorsOn(false);
        bench.run(Axis::Pitch, 60);
        const double cooled = bench.stabilizer.motorCelsius(Axis::Pitch);
        QVERIFY(cooled < warm && cooled > cold);
    }
    QVERIFY(warmer[0] > 1);
    QVERIFY2(std::abs(warmer[1] / warmer[0] - 4) < 0.1, qPrintable(QString::number(warmer[1] / warmer[0])));
}

void TestPlant::resonanceShowsWhereItIs()
{
    // Excite the axis alone and count how fast the structure rings afterwards.
    AxisPlant plant(simulatedMechanics(Axis::Roll));
    for (int i = 0; i < 3; ++i)
        plant.step(Stabilizer::kCycle, 1.0, 0, 0);
    for (int i = 0; i < 40; ++i)
        plant.step(Stabilizer::kCycle, 0.0, 0, 0);
    int crossings = 0;
    double slow = plant.rate();
    double last = 0;
    for (int i = 0; i < 250; ++i) {
        plant.step(Stabilizer::kCycle, 0.0, 0, 0);
        slow += 0.02 * (plant.rate() - slow);
        const double ring = plant.rate() - slow;
        crossings += (ring > 0) != (last > 0);
        last = ring;
    }
    const double hz = crossings / 2.0 / (250 * Stabilizer::kCycle);
    QVERIFY2(std::abs(hz - plant.mechanics().resonanceHz) < 8.0, qPrintable(QString::number(hz)));
}

void TestPlant::notchOnTheResonanceAllowsMoreD()
{
    const double hz = simulatedMechanics(Axis::Pitch).resonanceHz;
    Bench plain;
    Bench notched;
    AxisGains strong = gains(40, 10, 95);
    plain.setAll(strong);
    strong.notches[0] = {hz, 25.0, 30.0};
    notched.setAll(strong);
    const double without = plain.run(Axis::Pitch, 4.0).gyroRms;
    const double with = notched.run(Axis::Pitch, 4.0).gyroRms;
    QVERIFY2(with < without / 3, qPrintable(QStringLiteral("%1 %2").arg(with).arg(without)));
}

void TestPlant::biasLetsYawDrift()
{
    Bench calibrated;
    Bench biased;
    biased.stabilizer.imu().gyroCorrection = {};
    calibrated.run(Axis::Yaw, 30.0);
    biased.run(Axis::Yaw, 30.0);
    QVERIFY(std::abs(calibrated.stabilizer.trueAngle(Axis::Yaw)) < 2.0);
    QVERIFY(std::abs(biased.stabilizer.trueAngle(Axis::Yaw)) > 8.0);
}

void TestPlant::sameSeedSameMotion()
{
    Bench a(9);
    Bench b(9);
    Bench other(10);
    QCOMPARE(a.run(Axis::Roll, 1.0).rms, b.run(Axis::Roll, 1.0).rms);
    QVERIFY(a.run(Axis::Roll, 1.0).rms != other.run(Axis::Roll, 1.0).rms);
}

void TestPlant::handShakesLikeAHand()
{
    HandShake hand(5);
    double angle = 0;
    double rate = 0;
    constexpr int kSamples = 100000;
    for (int i = 0; i < kSamples; ++i) {
        hand.step(Stabilizer::kCycle);
        angle += hand.angle(Axis::Roll) * hand.angle(Axis::Roll);
        rate += hand.rate(Axis::Roll) * hand.rate(Axis::Roll);
    }
    angle = std::sqrt(angle / kSamples);
    rate = std::sqrt(rate / kSamples);
    QVERIFY2(angle > 0.5 && angle < 8.0, qPrintable(QString::number(angle)));
    QVERIFY2(rate > 2.0 && rate < 40.0, qPrintable(QString::number(rate)));
}

void TestPlant::autoPidFindsGainsThatHold()
{
    Bench bench;
    simplebgc::AutoPidSearch search({true, true, true}, {{{8, 2, 8, 0}, {8, 2, 8, 0}, {8, 2, 8, 0}}},
                                    {128, 128, 128});
    int cycles = 0;
    for (; !search.isFinished() && cycles < 100000; ++cycles) {
        for (const Axis axis : kAxes)
            bench.stabilizer.setTarget(axis, search.stimulus(axis));
        bench.stabilizer.step();
        if (!search.observe(bench.stabilizer))
            continue;
        for (const Axis axis : kAxes) {
            const auto &result = search.results()[std::size_t(axis)];
            bench.stabilizer.setGains(axis, gains(result.p, result.i, result.d));
        }
    }
    QVERIFY(search.isFinished());
    Bench soft;
    soft.setAll(gains(8, 2, 8));
    for (const Axis axis : kAxes) {
        const auto &result = search.results()[std::size_t(axis)];
        Bench found;
        found.stabilizer.setGains(axis, gains(result.p, result.i, result.d));
        const Run after = found.run(axis, 5.0);
        qInfo() << axisKey(axis) << result.p << result.i << result.d << "holds to" << after.rms << "deg, gyro"
                << after.gyroRms << "after" << search.iteration() << "iterations";
        QVERIFY(result.p > 15 && result.d > 15);
        QVERIFY(after.rms < 0.35);
        QVERIFY(after.gyroRms < 8.0);
        QVERIFY(after.rms < Bench(soft).run(axis, 5.0).rms);
    }
}

QTEST_APPLESS_MAIN(TestPlant)
#include "tst_plant.moc"
