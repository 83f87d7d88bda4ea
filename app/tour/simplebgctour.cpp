// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The tour's steps with a SimpleBGC board, which shows what all families share as well.
#if GIMBAL_WITH_SIMPLEBGC
#include "app/families/simplebgc/autotunepage.h"
#include "app/families/simplebgc/calibrationpage.h"
#include "app/mainwindow/bars.h"
#include "app/mainwindow/mainwindow.h"
#include "app/mainwindow/messagebar.h"
#include "app/pages/board/actionspage.h"
#include "app/pages/board/controlpage.h"
#include "app/pages/program/helppage.h"
#include "app/pages/setup/guidepage.h"
#include "app/pages/setup/parameterspage.h"
#include "app/pages/setup/profilespage.h"
#include "app/pages/setup/stickinputs.h"
#include "app/pages/tune/responsepage.h"
#include "app/pages/tune/spectrumpage.h"
#include "app/pages/tune/tuningpage.h"
#include "app/pages/watch/debugpage.h"
#include "app/pages/watch/monitorpage.h"
#include "app/pages/watch/streamsdialog.h"
#include "app/tour/tour.h"
#include "protocol/client/replaycontrol.h"
#include "protocol/record/recording.h"
#include "protocol/transport/replay.h"
#include "widgets/forms/argumentform.h"
#include "widgets/forms/reviewdialog.h"
#include "widgets/models/parametermodel.h"
#include "widgets/plot/plotstack.h"
#include "widgets/plot/plotview.h"
#include "widgets/views/controlpad.h"
#include "widgets/views/inputbars.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QTableView>

using namespace Qt::StringLiterals;

namespace {

constexpr int kLongSettleMs = 5500;  // for traces to fill their windows

template <typename P> P *pageAs(MainWindow &window, const QString &key)
{
    return static_cast<P *>(window.page(key));
}

}  // namespace

void Tour::addSimpleBgcSteps()
{
    Workspace &workspace = m_window.workspace();
    const auto alive = [&workspace] {
        return workspace.motorsRunning().has_value() && !workspace.configuration().isEmpty();
    };
    m_steps.append({u"start"_s, {}, {}, 300, {}, false});
    m_steps.append({{},
                    [this] {
                        m_window.openLink(u"sim:simplebgc"_s);
                        m_window.showPage(u"monitor"_s);
                    },
                    alive,
                    0,
                    {},
                    false});
    m_steps.append({u"monitor"_s, show(u"monitor"_s), {}, kLongSettleMs, {}, false});
    m_steps.append({u"monitor-cursor"_s,
                    [this] {
                        auto *monitor = pageAs<MonitorPage>(m_window, u"monitor"_s);
                        monitor->pauseButton()->setChecked(true);
                        for (PlotView *plot : monitor->plots())
                            plot->setCursorTime(plot->endTime() - 2.0);
                    },
                    {},
                    300,
                    {},
                    true});
    m_steps.append({u"dashboard"_s,
                    [this] {
                        pageAs<MonitorPage>(m_window, u"monitor"_s)->pauseButton()->setChecked(false);
                        m_window.showPage(u"dashboard"_s);
                    },
                    {},
                    800,
                    {},
                    false});
    m_steps.append({u"debug"_s,
                    show(u"debug"_s),
                    [this] { return pageAs<DebugPage>(m_window, u"debug"_s)->model().rowCount() > 0; },
                    2500,
                    {},
                    true});
    addEditSteps();
    addCalibrationSteps();
    addMotionSteps();
    addTelemetrySteps();
    addProgramSteps();
    addDialogSteps();
    addReplaySteps();
}

void Tour::addTelemetrySteps()
{
    const auto response = [this] { return pageAs<ResponsePage>(m_window, u"response"_s); };
    const auto begin = [response](ResponsePage::Way way) {
        response()->wayChoice()->setCurrentIndex(response()->wayChoice()->findData(int(way)));
        response()->armButton()->click();
        response()->startButton()->click();
    };
    m_steps.append({{},
                    [this] {
                        m_window.workspace().setMotors(true);
                        m_window.showPage(u"response"_s);
                    },
                    [this] { return m_window.workspace().motorsRunning() == std::optional(true); },
                    2500,
                    {},
                    false});
    m_steps.append({u"response"_s,
                    [begin] { begin(ResponsePage::Way::Steps); },
                    [response] { return !response()->records().empty() && !response()->isRunning(); },
                    400,
                    {},
                    false});
    m_steps.append({u"response-running"_s, [begin] { begin(ResponsePage::Way::Sweep); }, {}, 3000, {}, true});
    m_steps.append({u"response-sweep"_s, {}, [response] { return !response()->isRunning(); }, 400, {}, true});
    const auto view = [this](const QString &text) {
        for (QAction *action : pageAs<SpectrumPage>(m_window, u"spectrum"_s)->viewMenu()->actions()) {
            if (action->text() == text)
                action->trigger();
        }
    };
    m_steps.append({u"spectrum-waterfall"_s,
                    [this, view] {
                        m_window.showPage(u"spectrum"_s);
                        view(SpectrumPage::tr("Waterfall, %1").arg(axisLabel(Axis::Pitch)));
                    },
                    {},
                    8000,
                    {},
                    true});
    const auto monitor = [this] { return pageAs<MonitorPage>(m_window, u"monitor"_s); };
    m_steps.append({u"monitor-figures"_s,
                    [this, monitor, view] {
                        view(SpectrumPage::tr("Lines"));
                        m_window.showPage(u"monitor"_s);
                        const ChannelTable table = m_window.workspace().client().device()->channels();
                        monitor()->stack()->addChannels(1, {findChannel(table, u"power.roll"_s)});
                        monitor()->stack()->panels()[0]->setFiguresVisible(true);
                        emit monitor()->stack()->panels()[0]->changed();
                    },
                    {},
                    3000,
                    {},
                    true});
    m_steps.append({u"streams"_s, [monitor] { monitor()->streamsButton()->click(); }, {}, 300, {}, true});
    m_steps.append({{},
                    [this, monitor] {
                        m_window.findChild<StreamsDialog *>()->reject();
                        const ChannelTable table = m_window.workspace().client().device()->channels();
                        emit monitor()->stack()->panels()[1]->removeChannelRequested(
                            findChannel(table, u"power.roll"_s));
                        monitor()->stack()->panels()[0]->setFiguresVisible(false);
                        emit monitor()->stack()->panels()[0]->changed();
                    },
                    {},
                    200,
                    {},
                    true});
}

void Tour::addEditSteps()
{
    m_steps.append({u"parameters"_s, show(u"parameters"_s), {}, 600, {}, false});
    m_steps.append({u"parameters-edited"_s,
                    [this] {
                        EditStack &edits = m_window.workspace().edits();
                        ConfigurationModel &model = m_window.workspace().configuration();
                        const auto change = [&](const QString &key, int profile, int raw) {
                            if (const ParameterSpec *spec
                                = std::as_const(model).edited().parameters().find(key))
                                edits.edit(spec->id, profile, raw);
                        };
                        const int profile = model.shownProfile();
                        change(u"pid.roll.p"_s, profile, 42);
                        change(u"pid.roll.d"_s, profile, 36);
                        change(u"motor.yaw.power"_s, profile, 170);
                        change(u"follow.yaw.speed"_s, 1, 40);
                        pageAs<ParametersPage>(m_window, u"parameters"_s)->showParameter(u"pid.roll.p"_s);
                    },
                    {},
                    600,
                    {},
                    false});
    m_steps.append({u"profiles"_s,
                    [this] {
                        m_window.workspace().edits().copyProfile(0, 3);
                        m_window.workspace().edits().rename(3, u"Handheld, calm"_s);
                        m_window.showPage(u"profiles"_s);
                    },
                    {},
                    400,
                    {},
                    false});
    m_steps.append({u"review"_s,
                    [this] {
                        m_window.workspace().edits().undoStack().undo();
                        m_window.workspace().edits().undoStack().undo();
                        m_window.review();
                    },
                    [this] { return m_window.reviewDialog() != nullptr; },
                    400,
                    {},
                    false});
    m_steps.append({u"written"_s,
                    [this] { m_window.reviewDialog()->accept(); },
                    [this] { return m_window.workspace().configuration().changeCount() == 0; },
                    400,
                    {},
                    false});
    m_steps.append({u"backups"_s, show(u"backups"_s), {}, 400, {}, false});
}

// The sticks of a remote control, one of them held at an end.
void Tour::addRemoteSteps()
{
    const auto page = [this] { return pageAs<GuidePage>(m_window, u"guide"_s); };
    const QString roll = u"RC_ROLL (PWM)"_s;
    m_steps.append({{},
                    [this, page] {
                        for (const char *world : {"hand=1", "receiver=1", "stick=0"})
                            m_window.workspace().changeWorld(QLatin1String(world));
                        page()->choose(SetupStep::Remote);
                        page()->confirmBox()->setChecked(true);
                        page()->beginButton()->click();
                    },
                    [page] { return page()->isUnderWay() && page()->asks().step == u"setup-stick-roll"_s; },
                    0,
                    {},
                    false});
    m_steps.append({u"guide-remote"_s,
                    [this] { m_window.workspace().changeWorld(u"stick=1"_s); },
                    [page, roll] {
                        return page()->asks().step == u"setup-stick-back"_s
                            && page()->remote()->bars()->value(roll) > 90;
                    },
                    0,
                    {},
                    false});
    m_steps.append({{},
                    [page] { page()->cancelButton()->click(); },
                    [page] { return !page()->isUnderWay(); },
                    0,
                    {},
                    false});
    m_steps.append({{},
                    [this] {
                        for (const char *world : {"stick=0", "receiver=0", "hand=0"})
                            m_window.workspace().changeWorld(QLatin1String(world));
                        m_window.workspace().setMotors(true);
                    },
                    [this] { return m_window.workspace().motorsRunning() == true; },
                    500,
                    {},
                    false});
}

void Tour::addCalibrationSteps()
{
    const auto page = [this] { return pageAs<CalibrationPage>(m_window, u"calibration"_s); };
    using Kind = CalibrationPage::Kind;
    using Wizard = CalibrationPage::Step;
    m_steps.append({u"guide"_s, show(u"guide"_s), {}, 500, {}, false});
    const auto guide = [this] { return pageAs<GuidePage>(m_window, u"guide"_s); };
    m_steps.append({u"guide-power"_s,
                    [guide] {
                        guide()->choose(SetupStep::MotorPower);
                        guide()->confirmBox()->setChecked(true);
                        guide()->beginButton()->click();
                    },
                    [guide] { return guide()->isUnderWay(); },
                    6000,
                    {},
                    true});
    m_steps.append({{},
                    [guide] { guide()->cancelButton()->click(); },
                    [guide] { return !guide()->isUnderWay(); },
                    0,
                    {},
                    true});
    addRemoteSteps();
    m_steps.append({u"signals"_s, show(u"signals"_s), {}, 800, {}, false});
    m_steps.append({u"wholeboard"_s, show(u"wholeboard"_s), {}, 400, {}, false});
    m_steps.append({u"scriptslots"_s, show(u"scriptslots"_s), {}, 800, {}, false});
    m_steps.append({u"calibration"_s, show(u"calibration"_s), {}, 400, {}, false});
    m_steps.append({u"calibration-waiting"_s,
                    [this, page] {
                        m_window.workspace().changeWorld(u"shake=12"_s);
                        page()->start(Kind::Gyroscope);
                    },
                    [page] { return !page()->isSatisfied(); },
                    1500,
                    {},
                    true});
    m_steps.append({u"calibration-ready"_s,
                    [this] {
                        m_window.workspace().changeWorld(u"shake=1"_s);
                        m_window.workspace().changeWorld(u"pose=1"_s);
                    },
                    [page] { return page()->isSatisfied(); },
                    300,
                    {},
                    true});
    m_steps.append(
        {u"calibration-measuring"_s, [page] { page()->continueButton()->click(); }, {}, 2500, {}, true});
    m_steps.append(
        {u"calibration-result"_s, {}, [page] { return page()->step() == Wizard::Result; }, 300, {}, true});
    m_steps.append({{},
                    [this] { m_window.workspace().setMotors(false); },
                    [this] { return m_window.workspace().motorsRunning() == false; },
                    0,
                    {},
                    false});
    m_steps.append({{},
                    [this, page] {
                        page()->start(Kind::SixPositions);
                        m_window.workspace().changeWorld(u"pose=1"_s);
                    },
                    [page] { return page()->isSatisfied(); },
                    300,
                    {},
                    false});
    m_steps.append({{},
                    [page] { page()->continueButton()->click(); },
                    [page] { return page()->step() == Wizard::Place; },
                    0,
                    {},
                    false});
    m_steps.append({u"calibration-six"_s,
                    [this] { m_window.workspace().changeWorld(u"pose=3"_s); },
                    [page] { return page()->isSatisfied(); },
                    300,
                    {},
                    false});
    m_steps.append({{},
                    [this, page] {
                        page()->cancelButton()->click();
                        m_window.workspace().changeWorld(u"pose=0"_s);
                        m_window.workspace().setMotors(true);
                    },
                    [this] { return m_window.workspace().motorsRunning() == true; },
                    500,
                    {},
                    false});
}

void Tour::addMotionSteps()
{
    const auto tuning = [this] { return pageAs<TuningPage>(m_window, u"tuning"_s); };
    m_steps.append({{},
                    show(u"tuning"_s),
                    [tuning] { return !tuning()->live().parameters().isEmpty(); },
                    4000,
                    {},
                    false});
    m_steps.append(
        {u"tuning"_s,
         [this, tuning] {
             const ParameterSet &set
                 = std::as_const(m_window.workspace().configuration()).board().parameters();
             tuning()->slotButton(LiveModel::Slot::B)->click();
             for (const auto &[key, raw] :
                  {std::pair(u"pid.roll.p"_s, 60), {u"pid.roll.d"_s, 44}, {u"pid.pitch.i"_s, 20}}) {
                 if (const ParameterSpec *spec = set.find(key))
                     tuning()->live().setValue(spec->id, raw);
             }
         },
         {},
         kLongSettleMs,
         {},
         false});
    m_steps.append({u"spectrum"_s, show(u"spectrum"_s), {}, kLongSettleMs, {}, false});
    const auto autotune = [this] { return pageAs<AutoTunePage>(m_window, u"autotune"_s); };
    m_steps.append({u"autotune-ready"_s,
                    [this, tuning] {
                        tuning()->revertButton()->click();
                        m_window.showPage(u"autotune"_s);
                    },
                    [autotune] { return autotune()->startButton()->isEnabled(); },
                    600,
                    {},
                    true});
    m_steps.append(
        {u"autotune-running"_s, [autotune] { autotune()->startButton()->click(); }, {}, 6000, {}, true});
    m_steps.append({u"autotune"_s,
                    {},
                    [autotune] { return autotune()->state() != AutoTunePage::State::Running; },
                    800,
                    {},
                    true});
    m_steps.append({{}, [autotune] { autotune()->revertButton()->click(); }, {}, 500, {}, true});
    m_steps.append({u"variables"_s, show(u"variables"_s), {}, 900, {}, false});
    const auto control = [this] { return pageAs<ControlPage>(m_window, u"control"_s); };
    m_steps.append({u"control"_s,
                    [this, control] {
                        m_window.showPage(u"control"_s);
                        control()->setArmed(true);
                    },
                    {},
                    700,
                    {},
                    false});
}

void Tour::addProgramSteps()
{
    m_steps.append({u"actions"_s,
                    [this] {
                        m_window.showPage(u"actions"_s);
                        auto *actions = pageAs<ActionsPage>(m_window, u"actions"_s);
                        actions->showAction(u"angles"_s);
                        actions->runButton()->click();
                    },
                    {},
                    800,
                    {},
                    false});
    m_steps.append({u"actions-destroys"_s,
                    [this] { pageAs<ActionsPage>(m_window, u"actions"_s)->showAction(u"defaults"_s); },
                    {},
                    300,
                    {},
                    true});
    m_steps.append({u"console"_s, show(u"console"_s), {}, 600, {}, false});
    addGamepadStep();
    m_steps.append({u"settings"_s, show(u"settings"_s), {}, 400, {}, false});
    m_steps.append({u"help"_s,
                    [this] {
                        m_window.showPage(u"help"_s);
                        pageAs<HelpPage>(m_window, u"help"_s)->showTopic(u"tuning"_s);
                    },
                    {},
                    400,
                    {},
                    false});
}

void Tour::addDialogSteps()
{
    m_steps.append({u"palette"_s,
                    [this] {
                        m_window.showPage(u"dashboard"_s);
                        m_window.showPalette();
                        m_window.commandPalette()->input()->setText(u"roll"_s);
                    },
                    {},
                    400,
                    [this] { return m_window.commandPalette(); },
                    false});
    m_steps.append({{}, [this] { m_window.commandPalette()->close(); }, {}, 0, {}, false});
    m_steps.append({u"offer"_s,
                    [this] {
                        Offer offer;
                        offer.text
                            = Workspace::tr(
                                  "The last write was interrupted: %1 of %2 values are not on the board.")
                                  .arg(3)
                                  .arg(12);
                        offer.choices = {{Workspace::tr("Finish: write %n value(s)", nullptr, 3), [] {}},
                                         {Workspace::tr("Revert %n value(s)", nullptr, 9), [] {}},
                                         {Workspace::tr("Leave it as it is"), [] {}}};
                        m_window.offerBar()->ask(offer);
                        m_window.messageBar()->showProblem(
                            describe({ErrorCode::BoardError, u"CALIB_ACC: not possible in this state"_s, 8}));
                    },
                    {},
                    300,
                    {},
                    true});
    m_steps.append({u"quit"_s,
                    [this] {
                        m_window.offerBar()->clear();
                        EditStack &edits = m_window.workspace().edits();
                        edits.edit(std::as_const(m_window.workspace().configuration())
                                       .board()
                                       .parameters()
                                       .find(u"pid.roll.p"_s)
                                       ->id,
                                   0, 50);
                        m_window.close();
                    },
                    [this] { return m_window.findChild<QMessageBox *>() != nullptr; },
                    300,
                    {},
                    true});
    m_steps.append({{},
                    [this] {
                        m_window.findChild<QMessageBox *>()->reject();
                        m_window.workspace().edits().discardAll();
                    },
                    {},
                    100,
                    {},
                    true});
}

// Opens the last minutes as a recording; the board is disconnected for that.
void Tour::addReplaySteps()
{
    const QString file = QDir(m_folder).filePath(u"tour.gimbalrec"_s);
    m_steps.append({{},
                    [this, file] { std::ignore = m_window.workspace().recorder().savePast(file); },
                    [file] { return Recording::load(file).has_value(); },
                    500,
                    {},
                    true});
    m_steps.append({u"replay"_s,
                    [this, file] {
                        m_window.workspace().client().disconnectFromBoard();
                        m_window.showPage(u"monitor"_s);
                        m_window.openFile(file);
                    },
                    [this] {
                        return m_window.replayBar()->isVisible()
                            && m_window.workspace().client().replay().state();
                    },
                    4000,
                    {},
                    true});
    m_steps.append({{},
                    [this, file] {
                        m_window.workspace().client().disconnectFromBoard();
                        QFile::remove(file);
                    },
                    {},
                    100,
                    {},
                    true});
}
#endif
