// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/bcflight/framer.h"
#include "protocol/bcflight/luacheck.h"
#include "protocol/bcflight/luatext.h"
#include "protocol/procedure/writeconfiguration.h"
#include "protocol/record/configurationformats.h"
#include "protocol/session/stopplan.h"
#include "protocol/telemetry/telemetryplan.h"
#include "tests/support/channelproxy.h"
#include "tests/support/dronerig.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <limits>
#include <map>

using namespace Qt::StringLiterals;
using namespace bcflight;
using Drone = bcflight::SimulatedBoard;

namespace {

Faults losing(double share)
{
    Faults faults;
    faults.loseByte = share;
    return faults;
}

struct Rig : DroneRig
{
    explicit Rig(Generation generation = Generation::G, const QMap<QString, int> &own = {}, double lose = 0)
        : DroneRig(droneOptions(generation, own, losing(lose)))
    {
    }
    Drone &board() { return static_cast<Drone &>(port.board()); }
    Result<ActionReply> perform(const char *key, const QMap<QString, QString> &texts = {})
    {
        for (const ActionSpec &action : device.actions()) {
            if (qstrcmp(action.key, key) != 0)
                continue;
            const auto arguments = parseArguments(action, texts);
            return arguments ? device.perform(channel, QString::fromLatin1(key), *arguments)
                             : tl::unexpected(arguments.error());
        }
        return failure(ErrorCode::Unsupported, QString::fromLatin1(key));
    }
    /// Somebody else flies it.
    void fly(const Controls &controls)
    {
        Request request;
        request.bytes = encode(Message::Controls, controls.encode(Generation::G));
        channel.post(request);
        std::ignore = channel.sleep(20ms);
    }
    bool arm()
    {
        if (!calibrate())
            return false;
        fly({.arm = true});
        return board().isArmed();
    }
};

double gainOf(const Configuration &configuration, const char *key)
{
    return configuration.raw(*configuration.parameters().find(QString::fromLatin1(key)), 0).value_or(-1);
}

}  // namespace

/// What the program knows of a drone, against the simulated one in virtual time.
class TestBcflightDevice final : public QObject
{
    Q_OBJECT
private slots:
    void generationsAreTold_data();
    void generationsAreTold();
    void everythingIsRead();
    void gainsAreSetOneByOne();
    void noNumberIsNeverSent();
    void refusalIsSilence();
    void nothingIsSetWhileArmed_data();
    void nothingIsSetWhileArmed();
    void gainsAreStoredInTheText();
    void textThatCannotBeEditedIsLeftAlone_data();
    void textThatCannotBeEditedIsLeftAlone();
    void gainsThatAreNoneAreNotStored_data();
    void gainsThatAreNoneAreNotStored();
    void storeThatDidNotTakeIsTold();
    void textIsUploaded();
    void textComesBeforeGains();
    void lostAnswersToAnUploadAreSeenThrough_data();
    void lostAnswersToAnUploadAreSeenThrough();
    void textThatIsNotTakenIsNotPutBack_data();
    void textThatIsNotTakenIsNotPutBack();
    void droneThatDoesNotComeBackIsTold();
    void gainsStandInTheTextByTheirScales();
    void textIsRefused_data();
    void textIsRefused();
    void motorTestNeedsACountAndCalibration();
    void deafDroneIsLeftAlone();
    void cancelledTestIsWaitedFor();
    void calibrationIsFollowed();
    void calibrationIsNotLostWithAPacket();
    void textIsNotSentAgainToAnArmedDrone();
    void calibrationIsNotBegunAgainWhileArmed();
    void repeatedIsNotTaken();
    void transmitterThatKeepsItsSettingIsTold();
    void disarmedIsNotStandingBeforeOutputsCouldTell();
    void textThatSetsNothingIsRefused_data();
    void textThatSetsNothingIsRefused();
    void mistakesAreTold_data();
    void mistakesAreTold();
    void textThatIsRightPasses();
    void stopIsProvenByStateAndOutputs();
    void outputsOfBeforeAStopProveNothing();
    void telemetryIsDecoded();
    void noFalsePoints();
    void streamIsTakenApart_data();
    void streamIsTakenApart();
    void cellsAreCountedByTheLevel_data();
    void cellsAreCountedByTheLevel();
    void spectrumIsTakenApart();
    void chargeIsForgotten();
    void consoleRefusesWhatSteers();
    void actionsTell();
    void camerasAreTold();
};

void TestBcflightDevice::generationsAreTold_data()
{
    QTest::addColumn<int>("generation");
    QTest::addColumn<QString>("told");
    QTest::addColumn<bool>("writable");
    const auto add = [](Generation generation, const QString &told, bool writable) {
        QTest::newRow(qPrintable(generationText(generation))) << int(generation) << told << writable;
    };
    add(Generation::A, u"A"_s, false);
    add(Generation::B, u"B"_s, false);
    add(Generation::C, u"C or D"_s, false);
    add(Generation::D, u"C or D"_s, false);  // these two cannot be told apart
    add(Generation::E, u"E"_s, false);
    add(Generation::F, u"F or G"_s, true);  // they differ by one flag
    add(Generation::G, u"F or G"_s, true);
}

// Without side effects: the simulated receiver takes whatever it does not know for commands.
void TestBcflightDevice::generationsAreTold()
{
    QFETCH(int, generation);
    QFETCH(QString, told);
    QFETCH(bool, writable);
    Rig rig{Generation(generation)};
    const auto identity = rig.device.identify(rig.channel);
    QVERIFY2(identity, identity ? "" : qPrintable(identity.error().detail));
    QCOMPARE(identity->extra.value(u"generation"_s).toString(), told);
    QCOMPARE(identity->writable, writable);
    QVERIFY2(identity->model.contains(u"BCFlight"_s), qPrintable(identity->model));
    QVERIFY(!identity->isNumbered());
    // A question that older ones do not know has nothing behind it (errata 1).
    QVERIFY(rig.board().unknownMessages() <= (generation < int(Generation::F) ? 6 : 0));
    QVERIFY(!rig.board().isArmed() && !rig.board().status().calibrating);
}

void TestBcflightDevice::everythingIsRead()
{
    Rig rig;
    QVERIFY(rig.identify());
    const auto read = rig.device.readConfiguration(rig.channel);
    QVERIFY(read);
    QVERIFY(read->missing().empty());
    QCOMPARE(read->block({0, ConfigurationText}), rig.board().configuration());
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const QString name = QLatin1String(axisKey(kAxes[axis]));
        QCOMPARE(gainOf(*read, qPrintable(u"pid."_s + name + u".p"_s)),
                 double(float(rig.board().gains()[axis][0])));
        QCOMPARE(gainOf(*read, qPrintable(u"pid."_s + name + u".d"_s)),
                 double(float(rig.board().gains()[axis][2])));
    }
    QCOMPARE(rig.board().unknownMessages(), 0);
}

void TestBcflightDevice::gainsAreSetOneByOne()
{
    Rig rig;
    QVERIFY(rig.identify());
    auto wanted = rig.device.readConfiguration(rig.channel).value();
    const auto before = rig.board().gains();
    QVERIFY(wanted.setRaw(*wanted.parameters().find(u"pid.pitch.d"_s), 0, double(2.125e-6F)));
    QVERIFY(wanted.setRaw(*wanted.parameters().find(u"horizon.roll.offset"_s), 0, double(1.5F)));
    const auto written = rig.device.writeBlock(rig.channel, {0, Gains}, wanted.block({0, Gains}));
    QVERIFY(written);
    const auto now = rig.device.readConfiguration(rig.channel).value();
    QCOMPARE(now.block({0, Gains}), wanted.block({0, Gains}));
    QCOMPARE(rig.board().gains()[1][2], double(2.125e-6F));
    // The others kept every bit.
    QCOMPARE(rig.board().gains()[1][0], before[1][0]);
    QCOMPARE(rig.board().gains()[0], before[0]);
}

// The drone would take it and fly with it.
void TestBcflightDevice::noNumberIsNeverSent()
{
    Rig rig;
    QVERIFY(rig.identify());
    auto bytes = rig.device.readBlock(rig.channel, {0, Gains}).value();
    const QByteArray before = bytes;
    bytes.replace(4, 4, bigF32(std::numeric_limits<float>::quiet_NaN()));
    const auto written = rig.device.writeBlock(rig.channel, {0, Gains}, bytes);
    QVERIFY(!written);
    QCOMPARE(written.error().code, ErrorCode::OutOfRange);
    QCOMPARE(rig.device.readBlock(rig.channel, {0, Gains}).value(), before);
    for (const double value : {std::nan(""), -0.1, 1.5})
        QVERIFY(!rig.device.writeAdjustables(rig.channel, {{0, value}}));
    QCOMPARE(rig.device.readBlock(rig.channel, {0, Gains}).value(), before);
}

void TestBcflightDevice::refusalIsSilence()
{
    Rig rig;
    QVERIFY(rig.identify());
    auto bytes = rig.device.readBlock(rig.channel, {0, Gains}).value();
    bytes.replace(0, 4, bigF32(1.5F));
    const auto written = rig.device.writeBlock(rig.channel, {0, Gains}, bytes);
    QVERIFY(!written);
    QCOMPARE(written.error().code, ErrorCode::Timeout);
}

void TestBcflightDevice::nothingIsSetWhileArmed_data()
{
    QTest::addColumn<QString>("what");
    for (const char *what : {"gain", "live", "text", "mode", "beep", "calibration", "store", "motor", "escs"})
        QTest::newRow(what) << QString::fromLatin1(what);
}

// Errata 9.2, rules 4, 5 and 6: the drone itself refuses hardly any of it.
void TestBcflightDevice::nothingIsSetWhileArmed()
{
    QFETCH(QString, what);
    Rig rig;
    QVERIFY(rig.arm());
    const QByteArray text = rig.board().configuration();
    const auto gains = rig.board().gains();
    auto bytes = rig.device.readBlock(rig.channel, {0, Gains}).value();
    bytes.replace(0, 4, bigF32(0.25F));
    const auto attempt = [&]() -> Result<void> {
        const auto done = [](const Result<ActionReply> &reply) {
            return reply ? Result<void>() : tl::unexpected(reply.error());
        };
        if (what == u"gain"_s)
            return rig.device.writeBlock(rig.channel, {0, Gains}, bytes);
        if (what == u"live"_s)
            return rig.device.writeAdjustables(rig.channel, {{0, 0.25}});
        if (what == u"text"_s)
            return rig.device.writeBlock(rig.channel, {0, ConfigurationText}, text + "-- more\n");
        if (what == u"mode"_s)
            return done(rig.perform("mode", {{u"mode"_s, u"rate"_s}}));
        if (what == u"beep"_s)
            return done(rig.perform("motors.beep", {{u"on"_s, u"on"_s}}));
        if (what == u"calibration"_s)
            return done(rig.perform("calibrate.gyro"));
        if (what == u"store"_s)
            return done(rig.perform("gains.store"));
        if (what == u"motor"_s)
            return done(rig.perform("motor.test", {{u"motor"_s, u"1"_s}}));
        return done(rig.perform("escs.calibrate"));
    };
    const auto result = attempt();
    QVERIFY(!result);
    QCOMPARE(result.error().code, ErrorCode::ConditionUnmet);
    QVERIFY2(result.error().detail.contains(u"armed"_s), qPrintable(result.error().detail));
    QVERIFY(rig.board().isArmed());
    QCOMPARE(rig.board().gains(), gains);
    QCOMPARE(rig.board().configuration(), text);
}

void TestBcflightDevice::gainsAreStoredInTheText()
{
    Rig rig;
    QVERIFY(rig.identify());
    const QByteArray before = rig.board().configuration();
    const double p = double(float(rig.board().gains()[0][0] * 1.25));
    QVERIFY(rig.device.writeAdjustables(rig.channel, {{0, p}}));
    const auto stored = rig.perform("gains.store");
    QVERIFY2(stored, stored ? "" : qPrintable(stored.error().detail));
    QCOMPARE(stored->value(u"changed"_s).toInt(), 1);
    QCOMPARE(stored->value(u"pid.roll.p"_s).toString(), u"90 > 112.5"_s);
    // One number is another one, all else is as it was.
    const QByteArray after = rig.board().configuration();
    const auto literals = findGains(after, u"pid_roll"_s);
    QVERIFY(literals);
    QVERIFY(std::abs((*literals)[0].value - 112.5) < 0.001);
    QByteArray undone = after;
    undone.replace((*literals)[0].from, (*literals)[0].to - (*literals)[0].from, "90");
    QCOMPARE(undone, before);
    QCOMPARE(float(rig.board().gains()[0][0]), float(p));
    QVERIFY(!rig.board().isLost());
    // Nothing differs: nothing is uploaded, and it does not restart.
    QCOMPARE(rig.perform("gains.store").value().value(u"changed"_s).toInt(), 0);
    // Each is told by its own name.
    for (const AdjustableSpec &spec : rig.device.adjustables()) {
        if (spec.id >= kRateGains)
            continue;
        const double used = rig.board().gains()[std::size_t(spec.id / 3)][std::size_t(spec.id % 3)];
        const double next = double(float(used + 0.001));
        QVERIFY(rig.device.writeAdjustables(rig.channel, {{spec.id, next}}));
        const auto told = rig.perform("gains.store");
        QVERIFY2(told, told ? "" : qPrintable(QLatin1String(spec.key) + u" "_s + told.error().detail));
        QVERIFY2(told->contains(QLatin1String(spec.key)), spec.key);
        QCOMPARE(told->value(u"changed"_s).toInt(), 1);
    }
}

void TestBcflightDevice::textThatCannotBeEditedIsLeftAlone_data()
{
    QTest::addColumn<QByteArray>("from");
    QTest::addColumn<QByteArray>("to");
    QTest::newRow("set twice") << QByteArray("pid_yaw = PID( 180, 40, 0 ),")
                               << QByteArray("pid_yaw = PID( 180, 40, 0 ), pid_yaw = PID( 180, 40, 0 ),");
    QTest::newRow("set in a table as well")
        << QByteArray("pid_yaw = PID( 180, 40, 0 ),")
        << QByteArray("pid_yaw = PID( 180, 40, 0 ), f = function() stabilizer.pid_yaw = PID( 1, 1, 1 ) end,");
    QTest::newRow("computed") << QByteArray("PID( 90, 25, 80 )") << QByteArray("PID( 2 * 45, 25, 80 )");
}

void TestBcflightDevice::textThatCannotBeEditedIsLeftAlone()
{
    QFETCH(QByteArray, from);
    QFETCH(QByteArray, to);
    Rig rig;
    QVERIFY(rig.identify());
    QByteArray text = rig.board().configuration();
    QVERIFY(text.contains(from));
    text.replace(from, to);
    QVERIFY(rig.device.writeBlock(rig.channel, {0, ConfigurationText}, text));
    QVERIFY(!rig.board().isLost());
    QVERIFY(rig.identify());
    QVERIFY(rig.device.writeAdjustables(rig.channel, {{0, 0.002}}));
    const auto stored = rig.perform("gains.store");
    QVERIFY(!stored);
    QCOMPARE(stored.error().code, ErrorCode::ConditionUnmet);
    QVERIFY(stored.error().place);
    QCOMPARE(stored.error().place->block, int(ConfigurationText));
    QCOMPARE(stored.error().place->line,
             lineAt(text, text.lastIndexOf(to.endsWith(',') ? "pid_yaw" : "PID( 2")));
    QCOMPARE(rig.board().configuration(), text);
}

// Any ground may have set anything (errata 7.2): what names a variable in the text, or steers the other way,
// is not stored.
void TestBcflightDevice::gainsThatAreNoneAreNotStored_data()
{
    QTest::addColumn<QByteArray>("scale");
    QTest::addColumn<float>("gain");
    QTest::newRow("no number") << QByteArray() << std::numeric_limits<float>::quiet_NaN();
    QTest::newRow("negative") << QByteArray() << -0.002F;
    QTest::newRow("without a scale") << QByteArray("PID.pscale = 0") << 0.002F;
}

void TestBcflightDevice::gainsThatAreNoneAreNotStored()
{
    QFETCH(QByteArray, scale);
    QFETCH(float, gain);
    Rig rig;
    QVERIFY(rig.identify());
    QByteArray text = rig.board().configuration();
    if (!scale.isEmpty()) {
        text.replace("PID.pscale = 0.032029 * 0.0005", scale);
        QVERIFY(rig.device.writeBlock(rig.channel, {0, ConfigurationText}, text));
        QVERIFY(rig.identify());
    }
    Request other;
    other.bytes = encode(Message::SetRollP, bigF32(gain), Generation::G);
    rig.channel.post(other);
    QVERIFY(!rig.perform("gains.store"));
    QCOMPARE(rig.board().configuration(), text);
    QVERIFY(!rig.board().isLost());
}

// Errata 7.3: the drone may hold something else than what was uploaded, and start with something else.
void TestBcflightDevice::storeThatDidNotTakeIsTold()
{
    Rig rig;
    QVERIFY(rig.identify());
    QVERIFY(rig.device.writeAdjustables(rig.channel, {{0, 0.002}}));
    const QByteArray before = rig.board().configuration();
    bool hasUploaded = false;
    Altering forgetful(rig.channel, [&](const Request &request, const Altering::Pass &pass) -> Result<Frame> {
        auto reply = pass(request);
        hasUploaded |= request.kind == int(Message::SetConfigFile);
        if (reply && hasUploaded && request.kind == int(Message::GetConfigFile))
            reply->payload = encodeChecked(before);
        return reply;
    });
    const auto stored = rig.device.perform(forgetful, u"gains.store"_s, {});
    QVERIFY(!stored);
    QCOMPARE(stored.error().code, ErrorCode::NotStored);
}

void TestBcflightDevice::textIsUploaded()
{
    Rig rig;
    QVERIFY(rig.identify());
    const QByteArray text = rig.board().configuration() + "-- uploaded\n";
    const double begun = rig.board().now();
    QVERIFY(rig.device.writeBlock(rig.channel, {0, ConfigurationText}, text));
    QVERIFY(rig.board().now() - begun >= Drone::kRestartTime);  // it was seen to come back
    QCOMPARE(rig.device.readBlock(rig.channel, {0, ConfigurationText}).value(), text);
    QCOMPARE(rig.board().configuration(), text);
    QVERIFY(!rig.board().status().calibrated);
}

// The restart that follows the text takes gains out of use: they come behind it, and what the new text says
// of others holds.
void TestBcflightDevice::textComesBeforeGains()
{
    Rig rig;
    QVERIFY(rig.identify());
    const auto base = rig.device.readConfiguration(rig.channel);
    QVERIFY(base);
    Configuration edited = *base;
    const ParameterSpec &roll = *base->parameters().find(u"pid.roll.p"_s);
    const double wanted = double(float(base->raw(roll, 0).value() * 1.25));
    QVERIFY(edited.setRaw(roll, 0, wanted));
    QByteArray text = base->block({0, ConfigurationText});
    const auto yaw = findGains(text, u"pid_yaw"_s);
    QVERIFY(yaw);
    text = replaced(text, (*yaw)[0], (*yaw)[0].value * 2);
    edited.setBlock({0, ConfigurationText}, text);
    const QTemporaryDir folder;
    const BoardHistory history(folder.path());
    WriteOptions options;
    options.history = &history;
    const auto report = writeConfiguration(rig.channel, rig.device, *base, edited, options);
    QVERIFY(report);
    QVERIFY2(report->isComplete(), report->error ? qPrintable(report->error->detail) : "");
    QCOMPARE(report->count(WriteState::Verified), 2);
    QCOMPARE(rig.board().configuration(), text);
    QCOMPARE(double(float(rig.board().gains()[0][0])), wanted);
    const double yawBefore = gainOf(*base, "pid.yaw.p");
    QVERIFY(std::abs(rig.board().gains()[2][0] - 2 * yawBefore) < yawBefore / 100);
    QVERIFY(std::abs(gainOf(report->onBoard, "pid.yaw.p") - 2 * yawBefore) < yawBefore / 100);
    QStringList written;
    for (const Progress &progress : rig.channel.progressReports()) {
        if (progress.step == u"write-block"_s)
            written.append(progress.subject);
    }
    QCOMPARE(written, (QStringList{u"CONFIG_FILE"_s, u"GAINS"_s}));

    // What stood in a text cannot be guessed: each state of it is kept, unlike values.
    options.backupDone = true;
    Configuration again = report->onBoard;
    again.setBlock({0, ConfigurationText}, text + "-- quieter\n");
    const auto second = writeConfiguration(rig.channel, rig.device, report->onBoard, again, options);
    QVERIFY(second && second->isComplete());
    QVERIFY(!second->snapshotPath.isEmpty());
    const auto kept = loadConfiguration(second->snapshotPath, {family()});
    QVERIFY(kept);
    QCOMPARE(kept->configuration.block({0, ConfigurationText}), text);
    QVERIFY(again.setRaw(roll, 0, wanted * 1.1));
    const auto third = writeConfiguration(rig.channel, rig.device, second->onBoard, again, options);
    QVERIFY(third && third->isComplete() && third->snapshotPath.isEmpty());
}

void TestBcflightDevice::lostAnswersToAnUploadAreSeenThrough_data()
{
    QTest::addColumn<bool>("arrives");
    QTest::addColumn<int>("losses");
    QTest::addColumn<bool>("done");
    QTest::addColumn<QByteArray>("answer");  // that comes instead
    QTest::newRow("the answer is lost") << true << 1 << true << QByteArray();
    QTest::newRow("the answer is damaged") << true << 1 << true << QByteArray("\1\0\0\1", 4);
    QTest::newRow("the answer is cut off") << true << 1 << true << QByteArray(2, '\0');
    QTest::newRow("the upload is lost") << false << 1 << true << QByteArray();
    QTest::newRow("every upload is lost") << false << 99 << false << QByteArray();
}

// Errata 7.3: no answer, so it is asked; it restarts, or it is told again.
void TestBcflightDevice::lostAnswersToAnUploadAreSeenThrough()
{
    QFETCH(bool, arrives);
    QFETCH(int, losses);
    QFETCH(bool, done);
    QFETCH(QByteArray, answer);
    Rig rig;
    QVERIFY(rig.identify());
    const QByteArray before = rig.board().configuration();
    const QByteArray text = before + "-- uploaded\n";
    int uploads = 0;
    Altering lossy(rig.channel, [&](const Request &request, const Altering::Pass &pass) -> Result<Frame> {
        if (request.kind != int(Message::SetConfigFile) || ++uploads > losses)
            return pass(request);
        auto reply = arrives ? pass(request) : failure(ErrorCode::Timeout, request.name);
        if (!reply || answer.isEmpty())
            return failure(ErrorCode::Timeout, request.name);
        reply->payload = answer;
        return reply;
    });
    const auto written = rig.device.writeBlock(lossy, {0, ConfigurationText}, text);
    QCOMPARE(written.has_value(), done);
    QCOMPARE(rig.board().configuration(), done ? text : before);
    QCOMPARE(uploads, arrives ? 1 : done ? 2 : 3);  // never again where it had arrived, and not for ever
    if (!done)
        QCOMPARE(written.error().code, ErrorCode::Timeout);
    QCOMPARE(rig.board().unknownMessages(), 0);
}

void TestBcflightDevice::textThatIsNotTakenIsNotPutBack_data()
{
    QTest::addColumn<QByteArray>("answer");  // none: the upload is lost
    QTest::addColumn<ErrorCode>("code");
    QTest::newRow("it did not arrive whole") << QByteArray("\0\0\0\1", 4) << ErrorCode::BoardError;
    QTest::newRow("it confirms and does nothing") << QByteArray(4, '\0') << ErrorCode::NoEffect;
    QTest::newRow("every upload is lost") << QByteArray() << ErrorCode::Timeout;
}

// Errata 7.3: what it did not take is no reason to send the old text, with which it would restart.
void TestBcflightDevice::textThatIsNotTakenIsNotPutBack()
{
    QFETCH(QByteArray, answer);
    QFETCH(ErrorCode, code);
    Rig rig;
    QVERIFY(rig.calibrate());
    const QByteArray before = rig.board().configuration();
    const auto base = rig.device.readConfiguration(rig.channel);
    QVERIFY(base);
    Configuration edited = *base;
    edited.setBlock({0, ConfigurationText}, before + "-- edited\n");
    QList<QByteArray> uploads;
    Altering deaf(rig.channel, [&](const Request &request, const Altering::Pass &pass) -> Result<Frame> {
        if (request.kind != int(Message::SetConfigFile))
            return pass(request);
        uploads.append(request.bytes);
        if (answer.isEmpty())
            return failure(ErrorCode::Timeout, request.name);
        Frame reply;
        reply.id = int(Message::SetConfigFile);
        reply.payload = answer;
        return reply;
    });
    QTemporaryDir dir;
    const BoardHistory history(dir.path());
    WriteOptions options;
    options.history = &history;
    const auto report = writeConfiguration(deaf, rig.device, *base, edited, options);
    QVERIFY(report);
    QVERIFY(report->error);
    QCOMPARE(report->error->code, code);
    for (const QByteArray &upload : uploads)
        QVERIFY(upload.contains("-- edited"));
    QCOMPARE(report->data.size(), std::size_t(1));
    QCOMPARE(report->data.front().state, WriteState::NotWritten);
    QCOMPARE(rig.board().configuration(), before);
    const auto now = rig.device.checkMayTake(rig.channel, {u"SET_MODE"_s, {}});
    QVERIFY(now);
    QVERIFY(rig.board().status().calibrated);  // it has not restarted
}

// It compiles, and the drone cannot fly with it.
void TestBcflightDevice::droneThatDoesNotComeBackIsTold()
{
    Rig rig;
    QVERIFY(rig.identify());
    const auto written = rig.device.writeBlock(rig.channel, {0, ConfigurationText}, "frame = nil\n");
    QVERIFY(!written);
    QCOMPARE(written.error().code, ErrorCode::NotSeen);
    QVERIFY2(written.error().detail.contains(u"may not start"_s), qPrintable(written.error().detail));
    QVERIFY(rig.board().isLost());
}

void TestBcflightDevice::gainsStandInTheTextByTheirScales()
{
    Rig rig;
    QVERIFY(rig.identify());
    Configuration read = rig.device.readConfiguration(rig.channel).value();
    const auto figure = [&read](const char *key) {
        const ParameterSpec &spec = *read.parameters().find(QString::fromLatin1(key));
        return read.textFigure(spec, read.raw(spec, 0).value());
    };
    QCOMPARE(figure("pid.roll.p"), std::optional(90.0));
    QCOMPARE(figure("pid.pitch.i"), std::optional(25.0));
    QCOMPARE(figure("pid.pitch.d"), std::optional(90.0));
    QCOMPARE(figure("pid.yaw.d"), std::optional(0.0));
    QVERIFY(!figure("horizon.roll.offset"));  // the text has none
    const ParameterSpec &gain = *read.parameters().find(u"pid.roll.p"_s);
    QVERIFY(!read.textFigure(gain, std::nan("")));
    // Nobody knows them where the text does not tell its scales.
    QByteArray text = rig.board().configuration();
    read.setBlock({0, ConfigurationText}, QByteArray(text).replace("0.032029 * 0.0005", "tuned( 1 )"));
    QVERIFY(!figure("pid.roll.p"));
    read.setBlock({0, ConfigurationText}, text.replace("PID.pscale = 0.032029 * 0.0005", ""));
    QCOMPARE(float(figure("pid.roll.p").value_or(-1)), float(read.raw(gain, 0).value()));
}

void TestBcflightDevice::textIsRefused_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<ErrorCode>("code");
    QTest::newRow("no Lua") << QByteArray("a = = 1\n") << ErrorCode::InvalidArgument;
    QTest::newRow("a later Lua") << QByteArray("a = 7 // 2\n") << ErrorCode::InvalidArgument;
    QTest::newRow("a later escape") << QByteArray("a = \"\\u{41}\"\n") << ErrorCode::InvalidArgument;
    QTest::newRow("compiled") << QByteArray("\x1bLJ\x02") << ErrorCode::InvalidArgument;
    QTest::newRow("a zero inside") << QByteArray("a = 1\0b = 2\n", 12) << ErrorCode::InvalidArgument;
    QTest::newRow("too long") << "a = 1 --" + QByteArray(60000, 'x') << ErrorCode::TooMuch;
}

void TestBcflightDevice::textIsRefused()
{
    QFETCH(QByteArray, text);
    QFETCH(ErrorCode, code);
    Rig rig;
    QVERIFY(rig.identify());
    const QByteArray before = rig.board().configuration();
    const auto written = rig.device.writeBlock(rig.channel, {0, ConfigurationText}, text);
    QVERIFY(!written);
    QCOMPARE(written.error().code, code);
    QCOMPARE(rig.board().configuration(), before);
    QCOMPARE(rig.board().unknownMessages(), 0);
}

// Errata 7.7: before the calibration it would hang, with a wrong number it would end.
void TestBcflightDevice::motorTestNeedsACountAndCalibration()
{
    Rig rig;
    QVERIFY(rig.identify());
    const auto early = rig.perform("motor.test", {{u"motor"_s, u"1"_s}});
    QVERIFY(!early);
    QCOMPARE(early.error().code, ErrorCode::ConditionUnmet);
    QVERIFY(rig.perform("calibrate.all"));
    const auto fifth = rig.perform("motor.test", {{u"motor"_s, u"5"_s}});
    QVERIFY(!fifth);
    QCOMPARE(fifth.error().code, ErrorCode::InvalidArgument);
    QVERIFY(!rig.board().isLost());
    QVERIFY(rig.perform("telemetry.full", {{u"on"_s, u"off"_s}}));
    std::ignore = rig.channel.sleep(100ms);
    const auto unknown = rig.perform("motor.test", {{u"motor"_s, u"1"_s}});
    QVERIFY(!unknown);
    QCOMPARE(unknown.error().code, ErrorCode::ConditionUnmet);
    QVERIFY2(unknown.error().detail.contains(u"how many motors"_s), qPrintable(unknown.error().detail));
    QVERIFY(rig.perform("telemetry.full", {{u"on"_s, u"on"_s}}));
    const auto turned = rig.perform("motor.test", {{u"motor"_s, u"3"_s}});
    QVERIFY2(turned, turned ? "" : qPrintable(turned.error().detail));
    QVERIFY(!rig.board().isLost() && !rig.board().isArmed());
}

// Nobody can call it back: who cancels is told when it is over, and nothing queues up behind it.
void TestBcflightDevice::cancelledTestIsWaitedFor()
{
    Rig rig;
    QVERIFY(rig.identify());
    QVERIFY(rig.perform("calibrate.all"));
    const TimePoint begin = rig.channel.now();
    rig.channel.cancelAfter(1s);
    const auto cancelled = rig.perform("motor.test", {{u"motor"_s, u"1"_s}});
    QVERIFY(!cancelled);
    QCOMPARE(cancelled.error().code, ErrorCode::Cancelled);
    QVERIFY2(cancelled.error().detail.contains(u"has carried it out"_s),
             qPrintable(cancelled.error().detail));
    QVERIFY(rig.channel.now() - begin >= 8s);
}

// What is sent meanwhile would be carried out afterwards, in a burst.
void TestBcflightDevice::deafDroneIsLeftAlone()
{
    Rig rig;
    QVERIFY(rig.calibrate());
    qint64 atStart = -1;
    qint64 atEnd = -1;
    rig.channel.setOperator([&](const Progress &progress) {
        if (progress.step != u"motor-test"_s)
            return;
        atEnd = rig.channel.bytesOut();
        if (atStart < 0 && progress.done > 0)
            atStart = atEnd;
    });
    QVERIFY(rig.perform("motor.test", {{u"motor"_s, u"2"_s}}));
    QVERIFY(atStart > 0);
    QCOMPARE(atEnd, atStart);
}

void TestBcflightDevice::calibrationIsFollowed()
{
    Rig rig;
    QVERIFY(rig.identify());
    QVERIFY(!rig.board().status().calibrated);
    QVERIFY(rig.perform("calibrate.gyro"));
    QVERIFY(rig.board().status().calibrated && !rig.board().status().calibrating);
}

// One packet in ten is lost on each way; each of the calibrations is seen to have been done.
void TestBcflightDevice::calibrationIsNotLostWithAPacket()
{
    Rig rig(Generation::G, {}, 0.1);
    QVERIFY(rig.identify());
    for (int i = 0; i < 20; ++i) {
        const auto done = rig.perform(i % 2 == 0 ? "calibrate.all" : "calibrate.gyro");
        QVERIFY2(done, qPrintable(done ? QString() : done.error().detail));
        QVERIFY(rig.board().status().calibrated && !rig.board().status().calibrating);
    }
}

// The first upload is lost, and somebody else arms the drone meanwhile: a text would restart it in flight.
void TestBcflightDevice::textIsNotSentAgainToAnArmedDrone()
{
    Rig rig;
    QVERIFY(rig.calibrate());
    const QByteArray before = rig.device.readBlock(rig.channel, {0, ConfigurationText}).value();
    int sent = 0;
    Altering channel(rig.channel, [&](const Request &request, const Altering::Pass &pass) -> Result<Frame> {
        if (request.kind != int(Message::SetConfigFile))
            return pass(request);
        ++sent;
        rig.fly({.thrust = 0, .arm = true});
        return failure(ErrorCode::Timeout, request.name);
    });
    const auto written = rig.device.writeBlock(channel, {0, ConfigurationText}, before + "\n-- changed\n");
    QVERIFY(!written);
    QCOMPARE(written.error().code, ErrorCode::ConditionUnmet);
    QCOMPARE(sent, 1);
    QVERIFY(rig.board().isArmed());
}

// The same with a calibration: what is not answered may have been lost, and is not told to a drone that
// flies.
void TestBcflightDevice::calibrationIsNotBegunAgainWhileArmed()
{
    Rig rig;
    QVERIFY(rig.calibrate());
    int sent = 0;
    Altering channel(rig.channel, [&](const Request &request, const Altering::Pass &pass) -> Result<Frame> {
        if (request.kind != int(Message::Calibrate))
            return pass(request);
        ++sent;
        rig.fly({.thrust = 0, .arm = true});
        return failure(ErrorCode::Timeout, request.name);
    });
    const auto done = rig.device.perform(channel, u"calibrate.gyro"_s, {});
    QVERIFY(!done);
    QCOMPARE(done.error().code, ErrorCode::ConditionUnmet);
    QCOMPARE(sent, 1);
    QVERIFY(rig.board().isArmed());
}

void TestBcflightDevice::repeatedIsNotTaken()
{
    Rig rig;
    QVERIFY(rig.identify());
    std::optional<Frame> first;
    Altering channel(rig.channel, [&](const Request &request, const Altering::Pass &pass) -> Result<Frame> {
        const auto reply = pass(request);
        if (request.kind != int(Message::RollPidFactors) || !reply)
            return reply;
        if (!first)
            first = *reply;
        return *first;
    });
    const auto set = rig.device.writeAdjustables(channel, {{0, 0.5}});
    QVERIFY(!set);
    QCOMPARE(set.error().code, ErrorCode::NoEffect);
}

void TestBcflightDevice::transmitterThatKeepsItsSettingIsTold()
{
    Rig rig;
    QVERIFY(rig.identify());
    QVERIFY(rig.perform("vtx.power", {{u"power"_s, u"2"_s}}));
    int sent = 0;
    Altering stubborn(rig.channel, [&](const Request &request, const Altering::Pass &pass) -> Result<Frame> {
        if (request.kind != int(Message::VtxSetPower))
            return pass(request);
        ++sent;
        Request other = request;
        other.bytes.back() = 1;
        return pass(other);
    });
    const auto power = rig.device.perform(stubborn, u"vtx.power"_s, {{u"power"_s, 3}});
    QVERIFY(!power);
    QCOMPARE(power.error().code, ErrorCode::NoEffect);
    QCOMPARE(sent, 1);
    // Its table has three steps; what a drone makes of a fourth nobody knows.
    const auto beyond = rig.device.perform(stubborn, u"vtx.power"_s, {{u"power"_s, 4}});
    QVERIFY(!beyond);
    QCOMPARE(beyond.error().code, ErrorCode::OutOfRange);
    QCOMPARE(sent, 1);
    QVERIFY(rig.perform("vtx.channel", {{u"band"_s, u"raceband"_s}, {u"channel"_s, u"3"_s}}));
}

// A link of this moment has not heard of the outputs yet.
void TestBcflightDevice::disarmedIsNotStandingBeforeOutputsCouldTell()
{
    struct Told final : LatestValues
    {
        std::map<int, std::pair<float, TimePoint>> values;
        float latest(int channel) const override
        {
            const auto it = values.find(channel);
            return it == values.end() ? std::numeric_limits<float>::quiet_NaN() : it->second.first;
        }
        TimePoint latestAt(int channel) const override
        {
            const auto it = values.find(channel);
            return it == values.end() ? TimePoint{} : it->second.second;
        }
    };
    Rig rig;
    QVERIFY(rig.identify());
    const StopPlan plan = rig.device.stopPlan();
    const TimePoint since = rig.channel.now();
    Told told;
    told.values[Armed] = {0.F, since + 20ms};
    QCOMPARE(plan.fromTelemetry(told, since), Proof::Nothing);
    told.values[Outputs] = {1.F, since + 60ms};
    QCOMPARE(plan.fromTelemetry(told, since), Proof::Refuted);
    told.values[Outputs] = {0.F, since + 160ms};
    QCOMPARE(plan.fromTelemetry(told, since), Proof::Proven);
    // Without a stream of them its word has to do.
    told.values.erase(Outputs);
    told.values[Armed] = {0.F, since + 700ms};
    QCOMPARE(plan.fromTelemetry(told, since), Proof::Proven);
}

void TestBcflightDevice::textThatSetsNothingIsRefused_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("blank") << QByteArray(" \n\n");
    QTest::newRow("comments") << QByteArray("-- frame = {}\n--[[ all of it\n]]\n");
}

void TestBcflightDevice::textThatSetsNothingIsRefused()
{
    QFETCH(QByteArray, text);
    QVERIFY(findMistake(text));
    QVERIFY(!findMistake(text + "\nframe = {}\n"));
}

void TestBcflightDevice::mistakesAreTold_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("line");
    QTest::addColumn<QString>("told");
    QTest::newRow("open brace") << QByteArray("a = 1\nb = {\n  1\n") << 4
                                << u"'}' is missing, which closes '{' of line 2"_s;
    QTest::newRow("brace before") << QByteArray("b = {\n  1\n\nc = 2\n") << 4
                                  << u"'}' is missing before 'c', which closes '{' of line 1"_s;
    QTest::newRow("symbol") << QByteArray("a = 1\nb = )\n") << 2 << u"')' cannot stand here"_s;
    QTest::newRow("assignment") << QByteArray("a 5\n") << 1 << u"'=' is missing before '5'"_s;
    QTest::newRow("number") << QByteArray("a = 12xy\n") << 1 << u"this is not a number: '12xy'"_s;
    QTest::newRow("string") << QByteArray("a = 'x\n") << 1 << u"a string does not end: ''x'"_s;
    QTest::newRow("comment") << QByteArray("a = 1 --[[ x\n") << 2 << u"a comment does not end"_s;
    QTest::newRow("percent") << QByteArray("a = ( %2\n") << 1 << u"'%' cannot stand here"_s;
    QTest::newRow("binary number") << QByteArray("a = 1\nb = 0b101\n") << 2
                                   << u"the drone's Lua does not know binary numbers"_s;
    QTest::newRow("later escape behind two strokes")
        << QByteArray("a = \"-- \\u{41}\"\n") << 1 << u"the drone's Lua does not know \\u{}"_s;
    QTest::newRow("later escape behind an escaped one")
        << QByteArray("a = \"\\\\\\u{41}\"\n") << 1 << u"the drone's Lua does not know \\u{}"_s;
    QTest::newRow("unknown saying") << QByteArray("break\n") << 1 << u"no loop to break"_s;
}

void TestBcflightDevice::mistakesAreTold()
{
    QFETCH(QByteArray, text);
    QFETCH(int, line);
    QFETCH(QString, told);
    const auto mistake = findMistake(text);
    QVERIFY(mistake);
    QCOMPARE(mistake->sentence(QString::fromUtf8(mistake->what)), told);
    QCOMPARE(mistake->line, line);
}

// What only looks like an escape of a later Lua.
void TestBcflightDevice::textThatIsRightPasses()
{
    for (const QByteArray &text : {QByteArray("a = [[ \\u{41} ]]\n"), QByteArray("a = \"\\\\u{41}\"\n"),
                                   QByteArray("a = 1 -- \\u{41} 0b1\n"), QByteArray("a = \"0b1\"\n")})
        QVERIFY2(!findMistake(text), text.constData());
}

void TestBcflightDevice::stopIsProvenByStateAndOutputs()
{
    Rig rig;
    QVERIFY(rig.arm());
    QVERIFY(!reloadingAction(rig.device.actions()));  // its upload puts nothing back into use
    rig.fly({.thrust = 0.5, .arm = true});
    rig.channel.stopMotors(rig.device.stopPlan());
    std::ignore = rig.channel.sleep(1s);
    QVERIFY(rig.channel.stopResult());
    QVERIFY(*rig.channel.stopResult());
    QVERIFY(!rig.board().isArmed());
    for (const double output : rig.board().outputs())
        QCOMPARE(output, 0.0);
    QCOMPARE(rig.board().unknownMessages(), 0);

    // Disarmed is not stopped: outputs that go on are no proof.
    Rig turning;
    QVERIFY(turning.calibrate());
    const StopPlan plan = turning.device.stopPlan();
    TelemetryStore store(int(bcflight::channels().size()));
    const auto state = store.defineGroup({Armed}, 0);
    const auto outputs = store.defineGroup({Outputs}, 0);
    const TimePoint now = TimePoint() + 1h;
    const auto tell = [&](float armed, float driven, TimePoint at) {
        store.append(*state, at, std::array{armed});
        store.append(*outputs, at, std::array{driven});
    };
    tell(0, 1, now + 10ms);
    QCOMPARE(plan.fromTelemetry(store, now), Proof::Refuted);
    tell(1, 0, now + 20ms);
    QCOMPARE(plan.fromTelemetry(store, now), Proof::Refuted);
    tell(0, 0, now + 30ms);
    QCOMPARE(plan.fromTelemetry(store, now), Proof::Proven);
    QCOMPARE(plan.fromTelemetry(store, now + 1s), Proof::Nothing);
}

// Its stream ends just before it is stopped: what it told until then is no proof, whatever it was.
void TestBcflightDevice::outputsOfBeforeAStopProveNothing()
{
    for (const double thrust : {0.0, 0.5}) {
        Rig rig;
        QVERIFY(rig.arm());
        rig.fly({.thrust = thrust, .arm = true});
        std::ignore = rig.channel.sleep(200ms);
        QCOMPARE(rig.store->latest(Outputs) != 0, thrust > 0);
        QVERIFY(rig.perform("telemetry.full", {{u"on"_s, u"off"_s}}));
        rig.channel.stopMotors(rig.device.stopPlan());
        std::ignore = rig.channel.sleep(kOutputsTold - 100ms);
        QVERIFY(!rig.board().isArmed() && rig.store->latest(Armed) == 0);
        QVERIFY(!rig.channel.stopResult());
        std::ignore = rig.channel.sleep(300ms);
        QVERIFY(rig.channel.stopResult() && *rig.channel.stopResult());
        // Whoever tells of it says that its outputs are not known.
        QVERIFY(rig.channel.now() - rig.store->latestAt(Outputs) > kOutputsTold);
        const auto stopped = rig.perform("motors.off");
        QVERIFY(stopped);
        QCOMPARE(stopped->value(u"outputs"_s).toString(), u"not told"_s);
    }
}

void TestBcflightDevice::telemetryIsDecoded()
{
    Rig rig;
    QVERIFY(rig.calibrate());
    const auto plan = rig.device.subscribe(rig.channel, {}, {});
    QVERIFY(plan && plan->poll);
    QVERIFY(rig.channel.transact(*plan->poll));
    std::ignore = rig.channel.sleep(200ms);
    const auto latest = [&rig](int channel) { return double(rig.store->latest(channel)); };
    QVERIFY(std::abs(latest(BatteryVolts) - 16.8) < 0.6);
    QCOMPARE(latest(Armed), 0.0);
    QCOMPARE(latest(Calibrated), 1.0);
    QCOMPARE(latest(Outputs), 0.0);
    QCOMPARE(latest(Motor1), 0.0);
    QVERIFY(std::isnan(latest(Motor1 + 4)));
    QCOMPARE(latest(Loops), 1250.0);
    QVERIFY2(std::abs(latest(AccelX + 2) - 9.8) < 1.0, qPrintable(QString::number(latest(AccelX + 2))));
    QVERIFY(std::abs(latest(AttitudeRoll)) < 5);
    rig.fly({.thrust = 0.5, .arm = true});
    std::ignore = rig.channel.sleep(300ms);
    QCOMPARE(latest(Outputs), 1.0);
    QVERIFY(latest(Motor1) > 1);
}

// Before the first arming the thrust is whatever the memory held.
void TestBcflightDevice::noFalsePoints()
{
    TelemetryStore store(int(bcflight::channels().size()));
    Decoder decoder;
    const auto take = [&](Message id, const QByteArray &payload) {
        decoder.decode({int(id), asBytes(payload)}, Clock::now(), store);
    };
    for (const float absurd : {std::nanf(""), 1e30F, -0.5F, 3.0F}) {
        take(Message::SetThrust, bigF32(absurd));
        QVERIFY(std::isnan(store.latest(Thrust)));
    }
    take(Message::SetThrust, bigF32(0.5F));
    QCOMPARE(store.latest(Thrust), 0.5F);
    // Nothing has told yet that its attitude unit is on: 0 for ever, or the last of what was.
    take(Message::RollPitchYaw, bigF32(0) + bigF32(0) + bigF32(0));
    QVERIFY(std::isnan(store.latest(AttitudeRoll)));
    QCOMPARE(store.invalid(AttitudeRoll), quint64(1));
    take(Message::Status, bigU32(Status{.calibrated = true}.bits()));
    take(Message::Gyro, bigF32(1) + bigF32(std::numeric_limits<float>::infinity()) + bigF32(3));
    QCOMPARE(store.latest(GyroX), 1.0F);
    QVERIFY(std::isnan(store.latest(GyroX + 1)));
    QCOMPARE(store.latest(GyroX + 2), 3.0F);
    // More motors than anybody has, and none at all.
    take(Message::MotorsSpeed, bigU32(0));
    take(Message::MotorsSpeed, bigU32(100) + QByteArray(400, '\0'));
    QVERIFY(std::isnan(store.latest(Outputs)));
    take(Message::MotorsSpeed, bigU32(1) + bigF32(1e30F));
    QVERIFY(std::isnan(store.latest(Outputs)) && std::isnan(store.latest(Motor1)));
    // Of more than are shown, the one that is driven counts.
    take(Message::MotorsSpeed, bigU32(10) + QByteArray(36, '\0') + bigF32(0.5F));
    QCOMPARE(store.latest(Outputs), 1.0F);
    QCOMPARE(store.latest(Motor1), 0.0F);
}

void TestBcflightDevice::streamIsTakenApart_data()
{
    QTest::addColumn<int>("id");
    QTest::addColumn<QByteArray>("payload");
    QTest::addColumn<QList<float>>("values");  // of channels in a row
    QTest::addColumn<int>("first");
    const QByteArray three = bigF32(1.5F) + bigF32(-2) + bigF32(40);
    const QList<float> alike{1.5F, -2, 40};
    const auto row = [](const char *name, Message id, const QByteArray &payload, const QList<float> &values,
                        int first) { QTest::newRow(name) << int(id) << payload << values << first; };
    row("attitude", Message::RollPitchYaw, three, alike, AttitudeRoll);
    row("rates", Message::Rates, three, alike, RateRoll);
    row("gyroscope", Message::Gyro, three, alike, GyroX);
    row("acceleration", Message::Accel, three, alike, AccelX);
    row("field", Message::Magn, three, alike, FieldX);
    row("rates of the D term", Message::GyroDterm, three, alike, SlowRateRoll);
    row("length of the acceleration", Message::CurrentAcceleration, bigF32(9.5F), {9.5F}, AccelLength);
    row("height", Message::Altitude, bigF32(12.5F), {12.5F}, Height);
    row("volts", Message::BatteryVoltage, bigF32(15.5F), {15.5F}, BatteryVolts);
    row("charge comes in ampere-hours", Message::TotalCurrent, bigF32(0.5F), {500}, BatteryCharge);
    row("current", Message::CurrentDraw, bigF32(3.5F), {3.5F}, BatteryCurrent);
    row("level comes as a share", Message::BatteryLevel, bigF32(0.5F), {50}, BatteryShare);
    row("load", Message::CpuLoad, bigU32(31), {31}, CpuLoad);
    row("temperature", Message::CpuTemperature, bigU32(47), {47}, CpuCelsius);
    row("quality", Message::ReceiveQuality, bigU32(98), {98}, LinkQuality);
    row("level of the receiver", Message::ReceiveLevel, bigU32(std::uint32_t(-48)), {-48}, LinkLevel);
    row("unknown level", Message::ReceiveLevel, bigU32(std::uint32_t(-200)), {std::nanf("")}, LinkLevel);
    row("loops", Message::StabilizerFrequency, bigU32(4000), {4000}, Loops);
}

// Errata 8.1, each item of the periodic stream.
void TestBcflightDevice::streamIsTakenApart()
{
    QFETCH(int, id);
    QFETCH(QByteArray, payload);
    QFETCH(QList<float>, values);
    QFETCH(int, first);
    TelemetryStore store(int(bcflight::channels().size()));
    Decoder decoder;
    const QByteArray calibrated = bigU32(Status::kCalibrated);
    decoder.decode({int(Message::Status), asBytes(calibrated)}, Clock::now(), store);
    decoder.decode({id, asBytes(payload)}, Clock::now(), store);
    for (int i = 0; i < values.size(); ++i) {
        const float told = store.latest(first + i);
        QVERIFY2(told == values[i] || (std::isnan(told) && std::isnan(values[i])),
                 qPrintable(QString::number(double(told))));
    }
}

void TestBcflightDevice::cellsAreCountedByTheLevel_data()
{
    QTest::addColumn<float>("volts");
    QTest::addColumn<float>("level");
    QTest::addColumn<float>("cells");
    QTest::newRow("four full") << 16.8F << 1.F << 4.F;
    QTest::newRow("four nearly empty") << 12.6F << 0.125F << 4.F;
    QTest::newRow("four empty") << 11.6F << -0.083F << 4.F;
    QTest::newRow("three full") << 12.6F << 1.F << 3.F;
    QTest::newRow("six") << 22.2F << 0.58F << 6.F;
    QTest::newRow("beyond a full cell it may be anything") << 17.4F << 30.F << std::nanf("");
    QTest::newRow("no battery") << 0.4F << 0.5F << std::nanf("");
}

// Errata 4.2. Both ways in which a drone tells.
void TestBcflightDevice::cellsAreCountedByTheLevel()
{
    QFETCH(float, volts);
    QFETCH(float, level);
    QFETCH(float, cells);
    const auto isRight = [cells](const TelemetryStore &store) {
        const float told = store.latest(BatteryCells);
        return told == cells || (std::isnan(told) && std::isnan(cells));
    };
    TelemetryStore streamed(int(bcflight::channels().size()));
    Decoder decoder;
    const QByteArray voltage = bigF32(volts);
    const QByteArray share = bigF32(level);
    decoder.decode({int(Message::BatteryVoltage), asBytes(voltage)}, Clock::now(), streamed);
    decoder.decode({int(Message::BatteryLevel), asBytes(share)}, Clock::now(), streamed);
    QVERIFY2(isRight(streamed), qPrintable(QString::number(double(streamed.latest(BatteryCells)))));
    if (level > 1)
        return;  // does not fit into a byte
    TelemetryStore asked(int(bcflight::channels().size()));
    Telemetry telemetry;
    telemetry.voltage = double(volts);
    telemetry.level = int(std::lround(level * 100));
    const QByteArray answer = telemetry.encode();
    Decoder().decode({int(Message::Telemetry), asBytes(answer)}, Clock::now(), asked);
    QVERIFY2(isRight(asked), qPrintable(QString::number(double(asked.latest(BatteryCells)))));
}

// Errata 8.3: four numbers in a bin, little-endian, the fourth unused.
void TestBcflightDevice::spectrumIsTakenApart()
{
    TelemetryStore store(int(bcflight::channels().size()));
    Decoder decoder;
    QByteArray payload = QByteArray::fromHex("0020");  // bytes that follow
    for (const float number : {1.F, 2.F, 3.F, 99.F, 4.F, 1e30F, 6.F, 99.F}) {
        QByteArray bytes = bigF32(number);
        std::reverse(bytes.begin(), bytes.end());
        payload += bytes;
    }
    decoder.decode({int(Message::RateSpectrum), asBytes(payload)}, Clock::now(), store);
    const auto bins = [&store](int axis) { return *store.latestArray(SpectrumRoll + axis).values; };
    QCOMPARE(bins(0), (std::vector<float>{1, 4}));
    QCOMPARE(bins(2), (std::vector<float>{3, 6}));
    QCOMPARE(bins(1).front(), 2.F);
    QVERIFY(std::isnan(bins(1).back()));
    QCOMPARE(store.invalid(SpectrumRoll + 1), quint64(1));
}

void TestBcflightDevice::chargeIsForgotten()
{
    Rig rig;
    QVERIFY(rig.identify());
    const auto charge
        = [&rig] { return rig.perform("status").value().value(u"battery.charge"_s).toDouble(); };
    QVERIFY(charge() > 0);  // of an earlier flight
    QVERIFY(rig.perform("battery.reset"));
    QCOMPARE(charge(), 0.0);
}

void TestBcflightDevice::consoleRefusesWhatSteers()
{
    Rig rig;
    QVERIFY(rig.identify());
    for (const char *text :
         {"CONTROLS 0", "SET_THRUST 0.5", "SET_ROLL 1", "MOTOR_TEST 0", "CALIBRATE_ESCS", "SET_CONFIG_FILE 0",
          "UPDATE_UPLOAD_INIT", "NOTHING", "", "SET_ROLL_PID_P", "SET_ROLL_PID_P nan", "SET_ROLL_PID_P 2"})
        QVERIFY2(!rig.device.parseCommand(QString::fromLatin1(text)), text);
    // In hex as well: of what is not sent, too much, too little, two at once, no number, out of range.
    for (const char *text : {"83ff01000000", "83 ff 01 00 00 00 00", "00e000000000", "0043 3f000000", "8500",
                             "00503f0000", "8582", "0050 7fc00000", "0050 40000000", "00"})
        QVERIFY2(!rig.device.parseCommand(QString::fromLatin1(text)), text);
    for (const char *text : {"0050 3f 00 00 00", "00503f000000"}) {
        const auto typed = rig.device.parseCommand(QString::fromLatin1(text));
        QVERIFY2(typed && typed->name == u"SET_ROLL_PID_P"_s && typed->risk == ActionRisk::Writes, text);
        QCOMPARE(typed->bytes, QByteArray::fromHex("00503f000000"));
    }
    QCOMPARE(rig.device.parseCommand(u"00 69"_s)->name, u"GET_BOARD_INFOS"_s);
    const auto status = rig.device.parseCommand(u"status"_s);
    QVERIFY(status);
    QCOMPARE(status->bytes, QByteArray::fromHex("85"));
    QCOMPARE(status->risk, ActionRisk::Safe);
    const auto gain = rig.device.parseCommand(u"SET_ROLL_PID_P 0.5"_s);
    QVERIFY(gain);
    QCOMPARE(gain->bytes, QByteArray::fromHex("00503f000000"));
    QCOMPARE(gain->risk, ActionRisk::Writes);
    QCOMPARE(rig.device.describeSent(gain->bytes).name, u"SET_ROLL_PID_P"_s);
    QCOMPARE(rig.device.describeSent(QByteArray::fromHex("8582")).name, u"STATUS + TELEMETRY"_s);
    QVERIFY(!rig.device.commandNames().contains(u"CONTROLS"_s));
    // What was thrown away because a message before it is unknown (errata 2.3).
    const QByteArray lost = QByteArray::fromHex("0102");
    const FrameText discarded = rig.device.describeFrame({kDiscarded, asBytes(lost)}, true);
    QVERIFY(discarded.name == u"?"_s && discarded.fields.contains(u"01 02"_s));
    // What nobody uses has its name, and is not sent (errata 6).
    for (const QString &dead : {u"CONNECT"_s, u"SENSORS_DATA"_s, u"ERROR_MICROPHONE_MISSING"_s}) {
        const auto typed = rig.device.parseCommand(dead);
        QVERIFY(!typed);
        QCOMPARE(typed.error().detail, dead + u" is not sent from here: nobody uses it"_s);
        QVERIFY(!rig.device.commandNames().contains(dead));
    }
    QVERIFY(rig.device.parseCommand(u"SET_THRUST 0.5"_s).error().detail.contains(u"whether or not"_s));
    const QByteArray dead = QByteArray::fromHex("00203f800000");
    const FrameText named = rig.device.describeFrame({kDiscarded, asBytes(dead)}, true);
    QCOMPARE(named.name, u"SENSORS_DATA"_s);
    QVERIFY2(named.fields.contains(u"00 20 3f 80"_s) && named.fields.contains(u"nobody uses it"_s),
             qPrintable(named.fields));
    // What an answer is worth (errata 6.5).
    const QByteArray record = rig.device.parseCommand(u"VIDEO_START_RECORD"_s).value().bytes;
    QVERIFY(rig.device.describeSent(record).fields.contains(u"no proof"_s));
    for (const char *name : {"VIDEO_PAUSE", "VIDEO_RESUME", "ENABLE_TUN_DEVICE", "DISABLE_TUN_DEVICE"}) {
        const auto idle = rig.device.parseCommand(QLatin1String(name));
        QVERIFY(idle);
        QCOMPARE(rig.device.describeSent(idle->bytes).fields, u"(no effect today)"_s);
    }
    const auto hold = rig.device.parseCommand(u"SET_ALTITUDE_HOLD 1"_s);
    QVERIFY(hold);
    QVERIFY(rig.device.describeSent(hold->bytes).fields.contains(u"no effect on flight today"_s));
    const QByteArray code = bigU32(1);
    QVERIFY(rig.device.describeFrame({int(Message::VideoStartRecord), asBytes(code)}, true)
                .fields.contains(u"no proof"_s));
}

void TestBcflightDevice::actionsTell()
{
    Rig rig;
    QVERIFY(rig.identify());
    const auto status = rig.perform("status");
    QVERIFY(status);
    QCOMPARE(status->value(u"armed"_s).toBool(), false);
    QVERIFY(status->value(u"battery.voltage"_s).toDouble() > 10);
    QVERIFY(!rig.perform("board").value().isEmpty());
    QVERIFY(rig.perform("sensors").value().contains(u"Gyroscopes.ICM-42605.sample_rate"_s));
    const auto vtx = rig.perform("vtx.channel", {{u"band"_s, u"RaceBand"_s}, {u"channel"_s, u"2"_s}});
    QVERIFY2(vtx, vtx ? "" : qPrintable(vtx.error().detail));
    QCOMPARE(vtx->value(u"frequency"_s).toInt(), 5695);
    QCOMPARE(rig.perform("mode", {{u"mode"_s, u"rate"_s}}).value().value(u"mode"_s).toInt(), 0);
    QVERIFY(!rig.perform("recordings").value().isEmpty());
    Rig bare{Generation::G, {{QLatin1String(Drone::kCamera), 0}, {QLatin1String(Drone::kTransmitter), 0}}};
    QVERIFY(bare.identify());
    QVERIFY(!bare.perform("camera"));
    QVERIFY(!bare.perform("camera.white_balance"));
    QVERIFY(!bare.perform("camera.lock"));
    QVERIFY(!bare.perform("vtx.power", {{u"power"_s, u"2"_s}}));
    QCOMPARE(bare.board().unknownMessages(), 0);
}

// What has an effect is seen in the simulated picture; what is only confirmed proves nothing (errata 6.5).
void TestBcflightDevice::camerasAreTold()
{
    Rig rig;
    QVERIFY(rig.identify());
    QCOMPARE(rig.perform("camera").value().value(u"shutter"_s).toInt(), 200);
    for (const char *step :
         {"brightness.up", "brightness.up", "contrast.down", "saturation.up", "shutter.up"})
        QVERIFY(rig.perform("camera.step", {{u"step"_s, QLatin1String(step)}}));
    QVERIFY(rig.perform("camera"));  // they have arrived
    const CameraView view = rig.board().cameraView().value();
    QCOMPARE(view.brightness, 0.1);
    QCOMPARE(view.contrast, 0.95);
    QCOMPARE(view.saturation, 1.05);
    QCOMPARE(rig.perform("camera.white_balance").value().value(u"white_balance"_s).toString(),
             u"incandescent"_s);
    QCOMPARE(rig.perform("camera.white_balance").value().value(u"white_balance"_s).toString(),
             u"fluorescent"_s);
    // Its answer got lost, and it is asked again: it switches once (errata 5).
    int asked = 0;
    Altering lossy(rig.channel, [&](const Request &request, const Altering::Pass &pass) -> Result<Frame> {
        auto reply = pass(request);
        if (request.kind == int(Message::WhiteBalance) && ++asked == 1)
            return pass(request);
        return reply;
    });
    QCOMPARE(
        rig.device.perform(lossy, u"camera.white_balance"_s, {}).value().value(u"white_balance"_s).toString(),
        u"daylight"_s);
    // By whomever it was told something before.
    QVERIFY(rig.identify());
    QCOMPARE(rig.perform("camera.white_balance").value().value(u"white_balance"_s).toString(), u"cloudy"_s);
    Altering mute(rig.channel, [](const Request &request, const Altering::Pass &pass) -> Result<Frame> {
        return request.kind == int(Message::WhiteBalance) ? failure(ErrorCode::Timeout) : pass(request);
    });
    QCOMPARE(rig.device.perform(mute, u"camera.white_balance"_s, {}).error().code, ErrorCode::NotProven);
    QCOMPARE(rig.perform("camera.lock").value().value(u"white_balance"_s).toString(), u"R1.50B2.25"_s);
    QCOMPARE(rig.perform("camera.exposure").value().value(u"exposure"_s).toString(), QString());
    QVERIFY(rig.perform("camera.night", {{u"on"_s, u"on"_s}}));
    QVERIFY(rig.perform("camera.record", {{u"on"_s, u"off"_s}}));
    QVERIFY(rig.perform("camera.picture"));
    QCOMPARE(rig.perform("camera.lens").value().value(u"blue.strength"_s).toInt(), 0x2A);
    QMap<QString, QString> lens;
    for (const QString &colour : {u"red."_s, u"green."_s, u"blue."_s}) {
        lens.insert(colour + u"base"_s, u"32"_s);
        lens.insert(colour + u"radius"_s, u"200"_s);
        lens.insert(colour + u"strength"_s, u"-5"_s);
    }
    QVERIFY(rig.perform("camera.lens.set", lens));
    QVERIFY(rig.perform("camera"));
    QCOMPARE(rig.board().unknownMessages(), 0);
}

QTEST_GUILESS_MAIN(TestBcflightDevice)
#include "tst_bcflightdevice.moc"
