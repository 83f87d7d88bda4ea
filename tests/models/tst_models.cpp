// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/base/filefault.h"
#include "protocol/simplebgc/telemetrytables.h"
#include "tests/support/virtualboard.h"
#include "widgets/forms/editstack.h"
#include "widgets/models/changemodel.h"
#include "widgets/models/channelmodel.h"
#include "widgets/models/errortext.h"
#include "widgets/models/parametermodel.h"

#include <QAbstractItemModelTester>
#include <QRegularExpression>
#include <QSet>
#include <QSignalSpy>
#include <QTest>

using namespace Qt::StringLiterals;

namespace {

Configuration readBoard(int firmware = 2590, unsigned seed = 1)
{
    SimulatorOptions options;
    options.firmware = firmware;
    options.seed = seed;
    VirtualBoard bench(options);
    if (!bench.identify())
        qFatal("not identified");
    return *bench.device.readConfiguration(bench.channel);
}

int warningCount = 0;
QtMessageHandler handlerBefore = nullptr;

// QString::arg() warns of arguments without a placeholder.
int warnings()
{
    return warningCount;
}

bool isWhole(const ErrorText &text)
{
    static const QRegularExpression placeholder(u"%[1-9n]"_s);
    return !text.what.isEmpty() && !text.oneLine().contains(placeholder);
}

int idOf(const ConfigurationModel &model, const QString &key)
{
    return model.edited().parameters().find(key)->id;
}

}  // namespace

class TestModels : public QObject
{
    Q_OBJECT
private slots:
    void initTestCase()
    {
        handlerBefore = qInstallMessageHandler(
            [](QtMsgType type, const QMessageLogContext &context, const QString &text) {
                warningCount += text.contains(u"QString::arg"_s) ? 1 : 0;
                handlerBefore(type, context, text);
            });
    }
    void cleanupTestCase() { qInstallMessageHandler(handlerBefore); }
    void parameterModel();
    void parameterModelEmitsTheSmallestChange();
    void dirtyIsAComparison();
    void boardWideEditsShowInEveryProfile();
    void undoAndRedoSpanProfiles();
    void undoRestoresWhatNobodyMaySet();
    void copiesLeaveOutWhatNobodyMaySet();
    void stepsOnOneValueAreOneUndo();
    void discardCanBeUndone();
    void refusesOutOfRange();
    void rebaseKeepsEdits();
    void rebaseRefusesAnotherBoard();
    void setBoardAfterAWrite();
    void changeModel();
    void changeModelWritesOnlyWhatIsTicked();
    void channelModel();
    void channelsTellWhatTheyMean();
    void everyErrorHasWords();
    void everyFileFaultHasWords();
    void everyProgressHasWords();
};

void TestModels::parameterModel()
{
    ConfigurationModel configuration;
    ParameterModel model(configuration);
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    QCOMPARE(model.rowCount(), 0);
    configuration.reset(readBoard());
    QVERIFY2(model.rowCount() > 170, qPrintable(QString::number(model.rowCount())));
    const int row = idOf(configuration, u"pid.roll.i"_s);
    QCOMPARE(model.index(row, ParameterModel::ValueColumn).data().toString(), u"0.15"_s);
    QCOMPARE(model.index(row, ParameterModel::RangeColumn).data().toString(), u"0.00 to 2.55"_s);
    QCOMPARE(model.index(row, ParameterModel::KeyColumn).data().toString(), u"pid.roll.i"_s);
    QSignalSpy edits(&model, &ParameterModel::editRequested);
    QVERIFY(model.setData(model.index(row, ParameterModel::ValueColumn), u"0.22"_s));
    QCOMPARE(edits.first().at(1).toInt(), 22);
    QVERIFY(!model.setData(model.index(row, ParameterModel::ValueColumn), u"99"_s));
    QVERIFY(!model.setData(model.index(row, ParameterModel::ValueColumn), u"much"_s));
    QVERIFY(!(model.flags(model.index(idOf(configuration, u"state.profile"_s), ParameterModel::ValueColumn))
              & Qt::ItemIsEditable));
    configuration.setShownProfile(1);
    QCOMPARE(model.index(idOf(configuration, u"pid.roll.p"_s), ParameterModel::ValueColumn).data().toString(),
             u"45"_s);
    configuration.reset(readBoard(2704));
    QVERIFY(model.rowCount() > 300);
}

void TestModels::parameterModelEmitsTheSmallestChange()
{
    ConfigurationModel configuration;
    ParameterModel model(configuration);
    configuration.reset(readBoard());
    QSignalSpy changed(&model, &QAbstractItemModel::dataChanged);
    QSignalSpy resets(&model, &QAbstractItemModel::modelReset);
    const ParameterSpec *spec = configuration.edited().parameters().find(u"pid.yaw.p"_s);
    QVERIFY(configuration.setValue(*spec, 0, 41));
    QCOMPARE(changed.count(), 1);
    QCOMPARE(changed.first().at(0).toModelIndex().row(), spec->id);
    QCOMPARE(changed.first().at(1).toModelIndex().row(), spec->id);
    QVERIFY(configuration.setValue(*spec, 0, 41));
    QCOMPARE(changed.count(), 1);
    QCOMPARE(resets.count(), 0);
    QVERIFY(model.index(spec->id, 0).data(ParameterModel::ChangedRole).toBool());
}

void TestModels::dirtyIsAComparison()
{
    ConfigurationModel configuration;
    configuration.reset(readBoard());
    QSignalSpy count(&configuration, &ConfigurationModel::changeCountChanged);
    const ParameterSpec *spec = configuration.edited().parameters().find(u"pid.roll.p"_s);
    QVERIFY(configuration.setValue(*spec, 0, 40));
    QCOMPARE(configuration.changeCount(), 1);
    QVERIFY(configuration.setValue(*spec, 0, 41));
    QVERIFY(configuration.setValue(*spec, 0, 35));
    QCOMPARE(configuration.changeCount(), 0);
    QCOMPARE(count.count(), 2);  // only when it changes
}

void TestModels::boardWideEditsShowInEveryProfile()
{
    ConfigurationModel configuration;
    configuration.reset(readBoard());
    const ParameterSpec *poles = configuration.edited().parameters().find(u"motor.roll.poles"_s);
    QVERIFY(configuration.setValue(*poles, 3, 22));
    for (int profile = 0; profile < 5; ++profile)
        QCOMPARE(*configuration.value(*poles, profile), 22);
    QCOMPARE(configuration.changeCount(), 1);
}

void TestModels::undoAndRedoSpanProfiles()
{
    ConfigurationModel configuration;
    EditStack edits(configuration);
    configuration.reset(readBoard());
    const int p = idOf(configuration, u"pid.roll.p"_s);
    const int d = idOf(configuration, u"pid.roll.d"_s);
    QVERIFY(edits.edit(p, 0, 40));
    QVERIFY(edits.edit(d, 2, 50));
    edits.rename(1, u"New"_s);
    QCOMPARE(configuration.changeCount(), 3);
    edits.undoStack().undo();
    QCOMPARE(configuration.edited().profileName(1), u"Studio"_s);
    edits.undoStack().undo();
    edits.undoStack().undo();
    QCOMPARE(configuration.changeCount(), 0);
    for (int i = 0; i < 3; ++i)
        edits.undoStack().redo();
    QCOMPARE(configuration.changeCount(), 3);
    QCOMPARE(*configuration.value(configuration.edited().parameters().at(d), 2), 50);
}

void TestModels::undoRestoresWhatNobodyMaySet()
{
    ConfigurationModel configuration;
    EditStack edits(configuration);
    Configuration board = readBoard();
    const int source = board.parameters().find(u"rc.map.roll"_s)->id;
    QVERIFY(board.restoreRaw(board.parameters().at(source), 0, 200));
    configuration.reset(board);
    const ParameterSpec &spec = configuration.edited().parameters().at(source);
    QVERIFY(!edits.edit(source, 0, 201));
    QVERIFY(edits.edit(source, 0, 2));
    const QJsonObject journal = edits.toJson();
    edits.undoStack().undo();
    QCOMPARE(*configuration.value(spec, 0), 200.0);
    edits.undoStack().redo();
    // Also once a write has replaced it; the edit then stays one when the board is read again.
    configuration.setBoard(configuration.edited());
    edits.undoStack().undo();
    QCOMPARE(*configuration.value(spec, 0), 200.0);
    QVERIFY(configuration.rebase(configuration.board()));
    QCOMPARE(configuration.changeCount(), 1);
    edits.undoStack().redo();
    QCOMPARE(configuration.changeCount(), 0);

    configuration.reset(board);
    QVERIFY(edits.restore(journal).any);
    QCOMPARE(*configuration.value(configuration.edited().parameters().at(source), 0), 2.0);
    edits.undoStack().undo();
    QCOMPARE(configuration.changeCount(), 0);
}

void TestModels::copiesLeaveOutWhatNobodyMaySet()
{
    ConfigurationModel configuration;
    EditStack edits(configuration);
    Configuration board = readBoard();
    const int source = board.parameters().find(u"rc.map.roll"_s)->id;
    const int gain = board.parameters().find(u"pid.roll.p"_s)->id;
    QVERIFY(board.restoreRaw(board.parameters().at(source), 0, 200));
    QVERIFY(board.setRaw(board.parameters().at(gain), 0, 77));
    configuration.reset(board);
    const auto value = [&configuration](int id, int profile) {
        return *configuration.value(configuration.edited().parameters().at(id), profile);
    };
    const double before = value(source, 1);
    const QStringList leftOut = edits.copyProfile(0, 1);
    QCOMPARE(leftOut.size(), 1);
    QVERIFY2(leftOut.first().startsWith(u"rc.map.roll = 200"_s), qPrintable(leftOut.first()));
    QCOMPARE(value(source, 1), before);
    QCOMPARE(value(gain, 1), 77.0);
    edits.undoStack().undo();
    QCOMPARE(configuration.changeCount(), 0);
}

void TestModels::stepsOnOneValueAreOneUndo()
{
    ConfigurationModel configuration;
    EditStack edits(configuration);
    configuration.reset(readBoard());
    const int p = idOf(configuration, u"pid.roll.p"_s);
    for (int raw = 36; raw < 60; ++raw)
        QVERIFY(edits.edit(p, 0, raw));
    QCOMPARE(edits.undoStack().count(), 1);
    edits.undoStack().undo();
    QCOMPARE(configuration.changeCount(), 0);
}

void TestModels::discardCanBeUndone()
{
    ConfigurationModel configuration;
    EditStack edits(configuration);
    configuration.reset(readBoard());
    QVERIFY(edits.edit(idOf(configuration, u"pid.roll.p"_s), 0, 40));
    QVERIFY(edits.edit(idOf(configuration, u"pid.roll.d"_s), 1, 40));
    edits.discardAll();
    QCOMPARE(configuration.changeCount(), 0);
    edits.undoStack().undo();
    QCOMPARE(configuration.changeCount(), 2);
}

void TestModels::refusesOutOfRange()
{
    ConfigurationModel configuration;
    EditStack edits(configuration);
    configuration.reset(readBoard());
    QVERIFY(!edits.edit(idOf(configuration, u"pid.roll.p"_s), 0, 256));
    QVERIFY(!edits.edit(idOf(configuration, u"pid.roll.p"_s), 0, -1));
    QVERIFY(!edits.edit(idOf(configuration, u"state.profile"_s), 0, 1));
    const ParameterSpec *spec = configuration.edited().parameters().find(u"pid.roll.p"_s);
    QCOMPARE(configuration.setValue(*spec, 0, 999).error().code, ErrorCode::OutOfRange);
    QCOMPARE(configuration.changeCount(), 0);
}

void TestModels::rebaseKeepsEdits()
{
    ConfigurationModel configuration;
    EditStack edits(configuration);
    configuration.reset(readBoard());
    const int p = idOf(configuration, u"pid.roll.p"_s);
    QVERIFY(edits.edit(p, 0, 40));
    QVERIFY(edits.edit(idOf(configuration, u"pid.roll.d"_s), 0, 44));
    Configuration again = readBoard();
    // Meanwhile the board got one of the wanted values.
    QVERIFY(again.setRaw(*again.parameters().find(u"pid.roll.d"_s), 0, 44));
    QVERIFY(configuration.rebase(again));
    QCOMPARE(configuration.changeCount(), 1);
    edits.undoStack().undo();
    edits.undoStack().undo();
    QCOMPARE(*configuration.value(configuration.edited().parameters().at(p), 0), 35);
}

void TestModels::rebaseRefusesAnotherBoard()
{
    ConfigurationModel configuration;
    configuration.reset(readBoard());
    QVERIFY(!configuration.rebase(readBoard(2590, 9)));
    QVERIFY(!configuration.rebase(readBoard(2704)));
}

void TestModels::setBoardAfterAWrite()
{
    ConfigurationModel configuration;
    EditStack edits(configuration);
    configuration.reset(readBoard());
    QVERIFY(edits.edit(idOf(configuration, u"pid.roll.p"_s), 0, 40));
    QVERIFY(edits.edit(idOf(configuration, u"pid.roll.d"_s), 0, 44));
    Configuration written = configuration.board();
    QVERIFY(written.setRaw(*written.parameters().find(u"pid.roll.p"_s), 0, 40));
    // Found otherwise than it was known, without having been edited: that is shown as well.
    QVERIFY(written.setRaw(*written.parameters().find(u"pid.yaw.p"_s), 0, 33));
    QSignalSpy changed(&configuration, &ConfigurationModel::valueChanged);
    configuration.setBoard(written);
    const int found = idOf(configuration, u"pid.yaw.p"_s);
    QVERIFY(std::any_of(changed.begin(), changed.end(),
                        [found](const QList<QVariant> &call) { return call.first().toInt() == found; }));
    QCOMPARE(configuration.changeCount(), 1);
    // Undo after a write is an edit back, to be written again.
    edits.undoStack().undo();
    edits.undoStack().undo();
    QCOMPARE(configuration.changeCount(), 1);
}

void TestModels::changeModel()
{
    const Configuration board = readBoard();
    Configuration edited = board;
    QVERIFY(edited.setRaw(*board.parameters().find(u"pid.roll.p"_s), 0, 40));
    QVERIFY(edited.setRaw(*board.parameters().find(u"motor.roll.power"_s), 1, 222));
    edited.setProfileNames({u"A"_s, u"Studio"_s, u"Vehicle"_s, {}, {}});
    ChangeModel model(board, edited);
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    QCOMPARE(model.rowCount(), 3);
    QVERIFY(model.index(0, 0).data(ChangeModel::RedRole).toBool());  // red class first
    QCOMPARE(model.index(0, ChangeModel::BoardColumn).data().toString(), u"150"_s);
    QCOMPARE(model.index(0, ChangeModel::EditedColumn).data().toString(), u"222"_s);
    QCOMPARE(model.index(0, ChangeModel::ProfileColumn).data().toString(), u"Studio"_s);
    QCOMPARE(model.tickedCount(), 3);
    QVERIFY(model.hasTickedRed());
    QVERIFY(model.setData(model.index(0, 0), Qt::Unchecked, Qt::CheckStateRole));
    QVERIFY(!model.hasTickedRed());
    QCOMPARE(model.tickedCount(), 2);
}

void TestModels::changeModelWritesOnlyWhatIsTicked()
{
    const Configuration board = readBoard();
    Configuration edited = board;
    QVERIFY(edited.setRaw(*board.parameters().find(u"pid.roll.p"_s), 0, 40));
    QVERIFY(edited.setRaw(*board.parameters().find(u"pid.roll.d"_s), 0, 41));
    ChangeModel model(board, edited);
    QVERIFY(model.setData(model.index(0, 0), Qt::Unchecked, Qt::CheckStateRole));
    const auto changes = board.changesTo(model.ticked());
    QCOMPARE(changes.size(), std::size_t(1));
    QCOMPARE(changes[0].spec->key, u"pid.roll.d"_s);
}

void TestModels::channelModel()
{
    ChannelModel model;
    QAbstractItemModelTester tester(&model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    const simplebgc::Device device;
    auto store = std::make_shared<TelemetryStore>(int(device.channels().size()));
    model.reset(device.channels(), store);
    QVERIFY(model.rowCount() > 5);
    QSignalSpy ticks(&model, &ChannelModel::ticksChanged);
    model.setTicked({0, 6});
    QCOMPARE(ticks.count(), 1);
    model.setTicked({6, 0});
    QCOMPARE(ticks.count(), 1);
    const QModelIndex angles = model.index(0, 0);
    QCOMPARE(model.index(0, 0, angles).data(Qt::CheckStateRole).toInt(), int(Qt::Checked));
    QVERIFY(model.setData(model.index(1, 0, angles), Qt::Checked, Qt::CheckStateRole));
    QCOMPARE(model.ticked(), (QList<int>{0, 1, 6}));
    QCOMPARE(model.index(0, ChannelModel::ValueColumn, angles).data().toString(), u"–"_s);
    const auto group = store->defineGroup({0}, 0.1);
    const float value[] = {12.345F};
    store->append(*group, Clock::now(), value);
    model.refresh();
    QCOMPARE(model.index(0, ChannelModel::ValueColumn, angles).data().toString(), u"12.35"_s);
}

// What a number means is read in words; the number is in the plot and in the tip.
void TestModels::channelsTellWhatTheyMean()
{
    const ChannelTable table = simplebgc::channelTable();
    const auto spec = [table](const char *key) -> const ChannelSpec & {
        return table[std::size_t(findChannel(table, QLatin1String(key)))];
    };
    QCOMPARE(channelValueText(spec("system.calibration"), 3), u"poles"_s);
    QCOMPARE(channelValueText(spec("system.calibration"), 200), u"200"_s);
    QCOMPARE(channelValueText(spec("system.state"), 0x30), u"started, power manager"_s);
    QCOMPARE(channelValueText(spec("system.state"), 0), u"None"_s);
    QCOMPARE(channelValueText(spec("system.error"), 0x41), u"No IMU, Battery below the alarm"_s);
    QCOMPARE(channelValueText(spec("profile.active"), 1), u"profile 2"_s);
    QCOMPARE(channelValueText(spec("battery"), 12.3), u"12.30"_s);
    QCOMPARE(channelValueText(spec("system.state"), qQNaN()), u"–"_s);
    ChannelModel model;
    auto store = std::make_shared<TelemetryStore>(int(table.size()));
    model.reset(table, store);
    const int channel = findChannel(table, u"system.state"_s);
    const float value[] = {16.0F};
    store->append(*store->defineGroup({channel}, 0.1), Clock::now(), value);
    const QModelIndexList found = model.match(model.index(0, 0), ChannelModel::ChannelRole, channel, 1,
                                              Qt::MatchExactly | Qt::MatchRecursive);
    QCOMPARE(found.size(), 1);
    const QModelIndex shown = found.first().siblingAtColumn(ChannelModel::ValueColumn);
    QCOMPARE(shown.data().toString(), u"started"_s);
    QVERIFY2(shown.data(Qt::ToolTipRole).toString().endsWith(u"16 = started"_s),
             qPrintable(shown.data(Qt::ToolTipRole).toString()));
}

void TestModels::everyErrorHasWords()
{
    QSet<QString> seen;
    for (int code = 0; code <= int(ErrorCode::Busy); ++code) {
        const ErrorText text = describe(Error{ErrorCode(code), u"the detail"_s, 0});
        QVERIFY2(!text.what.isEmpty(), qPrintable(QString::number(code)));
        QVERIFY(!seen.contains(text.what));
        seen.insert(text.what);
        QVERIFY(text.oneLine().contains(u"the detail"_s));
        QVERIFY(!text.oneLine().contains(u'!'));
        const ErrorText bare = describe(Error{ErrorCode(code), {}, 0});
        QVERIFY2(isWhole(text) && isWhole(bare), qPrintable(text.oneLine()));
    }
    QCOMPARE(warnings(), 0);
}

// Whatever is known of a fault and whatever not: no placeholder is left, and none is missing.
void TestModels::everyFileFaultHasWords()
{
    const QString some = u"something"_s;
    for (int problem = 0; problem <= int(FileProblem::Same); ++problem) {
        for (int kind = 0; kind <= int(FileKind::Other); ++kind) {
            for (int known = 0; known < 1 << 7; ++known) {
                const auto text = [&](int bit) { return known & 1 << bit ? some : QString(); };
                const ErrorText words = describe(FileFault{.problem = FileProblem(problem),
                                                           .kind = FileKind(kind),
                                                           .path = text(0),
                                                           .line = known & 1 << 1 ? 3 : 0,
                                                           .key = text(2),
                                                           .value = text(3),
                                                           .expected = text(4),
                                                           .profile = known & 1 << 5 ? 1 : -1,
                                                           .writing = bool(known & 1 << 6),
                                                           .said = text(3)});
                QVERIFY2(isWhole(words) && warnings() == 0, qPrintable(words.oneLine()));
            }
        }
    }
}

void TestModels::everyProgressHasWords()
{
    for (const char *step : {"probe", "read-block", "write-block", "await-restart", "verify-block",
                             "roll-back", "calibrate", "autotune", "steer", "motor-test", "escs-off",
                             "escs-full", "escs-zero", "firmware-upload", "firmware-restart"}) {
        Progress progress;
        progress.step = QLatin1String(step);
        progress.subject = u"PARAMS_3"_s;
        QVERIFY(describe(progress) != progress.step);
    }
    Progress reading;
    reading.step = u"read-block"_s;
    reading.subject = u"PARAMS_3"_s;
    QCOMPARE(describe(reading), u"Reading PARAMS_3"_s);
    reading.profile = 1;
    QCOMPARE(describe(reading), u"Reading PARAMS_3 of profile 2"_s);
    const auto said = [](const char *step, const QString &subject = {}, int done = 0) {
        Progress progress;
        progress.step = QLatin1String(step);
        progress.subject = subject;
        progress.done = done;
        progress.values.insert(u"command"_s, 7);
        return describe(progress);
    };
    QCOMPARE(said("probe"), u"Looking for a board"_s);
    QCOMPARE(said("probe", u"115200"_s), u"Looking for a board at 115200"_s);
    QCOMPARE(said("await-restart", u"CONFIG_FILE"_s),
             u"The configuration text is written; waiting for the drone to restart"_s);
    QCOMPARE(said("await-restart", u"PARAMS_3"_s),
             u"PARAMS_3 is written; waiting for the board to restart"_s);
    QCOMPARE(said("calibrate-magnetometer", {}, 3), u"Turn the camera in all directions: 3 of 26 are seen"_s);
    QCOMPARE(said("autotune", u"PARAMS_3"_s, 4), u"Auto-tune, iteration 4"_s);
    QCOMPARE(said("script", u"2"_s), u"Script 2 runs: command 7"_s);
    QCOMPARE(said("steer", u"PARAMS_3"_s), u"Steering"_s);
    QCOMPARE(said("of another program"), u"of another program"_s);
}

QTEST_GUILESS_MAIN(TestModels)
#include "tst_models.moc"
