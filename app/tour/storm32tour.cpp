// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The tour's steps with a STorM32 board: the pages that only it has, and how the others fill themselves.
#if GIMBAL_WITH_STORM32
#include "app/families/storm32/sensorpage.h"
#include "app/families/storm32/setuppage.h"
#include "app/mainwindow/mainwindow.h"
#include "app/pages/board/controlpage.h"
#include "app/pages/board/sharedialog.h"
#include "app/pages/setup/parameterspage.h"
#include "app/pages/setup/scriptspage.h"
#include "app/pages/tune/responsepage.h"
#include "app/pages/tune/tuningpage.h"
#include "app/tour/tour.h"
#include "widgets/forms/panel.h"
#include "widgets/views/scripteditor.h"

#include <QPushButton>

using namespace Qt::StringLiterals;

namespace {

QString pictureName(const QString &family, const QString &page)
{
    return family + u'-' + page;
}

}  // namespace

void Tour::addFamilySteps(const QString &family)
{
    addFamilyWatchSteps(family);
    addFamilyTuningSteps(family);
    addSensorSteps(family);
    addSetupSteps(family);
    addScriptSteps(family);
    addFamilyBoardSteps(family);
    m_steps.append({{},
                    [this] {
                        m_window.panels()->rejectAll();
                        m_window.workspace().client().disconnectFromBoard();
                    },
                    {},
                    100,
                    {},
                    false});
}

// Connects to the family's simulated board first.
void Tour::addFamilyWatchSteps(const QString &family)
{
    addConnecting(family);
    m_steps.append({pictureName(family, u"dashboard"_s), show(u"dashboard"_s), {}, 2500, {}, false});
    m_steps.append({pictureName(family, u"monitor"_s), show(u"monitor"_s), {}, 2500, {}, true});
    m_steps.append({pictureName(family, u"parameters"_s),
                    [this] {
                        m_window.showPage(u"parameters"_s);
                        static_cast<ParametersPage *>(m_window.page(u"parameters"_s))
                            ->showParameter(u"pan.mode.setting1"_s);
                    },
                    {},
                    500,
                    {},
                    false});
}

void Tour::addFamilyTuningSteps(const QString &family)
{
    const auto tuning = [this] { return static_cast<TuningPage *>(m_window.page(u"tuning"_s)); };
    m_steps.append({{},
                    show(u"tuning"_s),
                    [tuning] { return !tuning()->live().parameters().isEmpty(); },
                    1500,
                    {},
                    false});
    m_steps.append({pictureName(family, u"tuning"_s),
                    [this, tuning] {
                        const ParameterSpec *spec = std::as_const(m_window.workspace().configuration())
                                                        .board()
                                                        .parameters()
                                                        .find(u"pid.roll.p"_s);
                        tuning()->live().setValue(spec->id, 450);
                    },
                    {},
                    3000,
                    {},
                    false});
    m_steps.append({{}, [tuning] { tuning()->revertButton()->click(); }, {}, 400, {}, false});
    m_steps.append({pictureName(family, u"spectrum"_s), show(u"spectrum"_s), {}, 5000, {}, true});
    const auto response = [this] { return static_cast<ResponsePage *>(m_window.page(u"response"_s)); };
    m_steps.append({pictureName(family, u"response-armed"_s),
                    [this, response] {
                        m_window.showPage(u"response"_s);
                        response()->armButton()->click();
                    },
                    {},
                    600,
                    {},
                    true});
    m_steps.append({pictureName(family, u"response"_s),
                    [response] { response()->startButton()->click(); },
                    [response] { return !response()->records().empty() && !response()->isRunning(); },
                    400,
                    {},
                    true});
    m_steps.append({pictureName(family, u"variables"_s), show(u"variables"_s), {}, 900, {}, true});
    m_steps.append({pictureName(family, u"control"_s),
                    [this] {
                        m_window.showPage(u"control"_s);
                        static_cast<ControlPage *>(m_window.page(u"control"_s))->setArmed(true);
                    },
                    {},
                    700,
                    {},
                    false});
}

void Tour::addSensorSteps(const QString &family)
{
    const auto sensors = [this] { return static_cast<SensorPage *>(m_window.page(u"sensor"_s)); };
    m_steps.append({pictureName(family, u"calibration"_s), show(u"sensor"_s), {}, 500, {}, false});
    m_steps.append({{},
                    [this] { m_window.workspace().setMotors(false); },
                    [this] { return m_window.workspace().motorsRunning() == false; },
                    0,
                    {},
                    true});
    m_steps.append({{},
                    [this, sensors] {
                        m_window.workspace().changeWorld(u"pose=1"_s);
                        sensors()->start(true);
                    },
                    [sensors] { return sensors()->doneCount() == 1; },
                    0,
                    {},
                    true});
    m_steps.append({pictureName(family, u"calibration-six"_s),
                    [this] { m_window.workspace().changeWorld(u"pose=4"_s); },
                    [sensors] { return sensors()->doneCount() == 2; },
                    400,
                    {},
                    true});
    for (int pose : {2, 3, 5, 6}) {
        const int done = pose == 2 ? 3 : pose == 3 ? 4 : pose == 5 ? 5 : 6;
        m_steps.append({{},
                        [this, pose] { m_window.workspace().changeWorld(u"pose=%1"_s.arg(pose)); },
                        [sensors, done] {
                            return sensors()->doneCount() >= done
                                || sensors()->step() == SensorPage::Step::Result;
                        },
                        0,
                        {},
                        true});
    }
    m_steps.append({pictureName(family, u"calibration-result"_s),
                    {},
                    [sensors] { return sensors()->step() == SensorPage::Step::Result; },
                    400,
                    {},
                    true});
    m_steps.append({{},
                    [this] {
                        m_window.workspace().changeWorld(u"pose=0"_s);
                        m_window.workspace().setMotors(true);
                    },
                    [this] { return m_window.workspace().motorsRunning() == true; },
                    200,
                    {},
                    true});
}

void Tour::addSetupSteps(const QString &family)
{
    const auto setup = [this] { return static_cast<SetupPage *>(m_window.page(u"setup"_s)); };
    m_steps.append({pictureName(family, u"setup"_s), show(u"setup"_s), {}, 500, {}, false});
    m_steps.append({pictureName(family, u"setup-orientation"_s),
                    [this, setup] {
                        m_window.workspace().changeWorld(u"pose=1"_s);
                        setup()->continueButton()->click();
                    },
                    [setup] {
                        return setup()->step() == SetupPage::Step::Orientation
                            && setup()->what().contains(u"45°"_s);
                    },
                    500,
                    {},
                    true});
    m_steps.append({pictureName(family, u"setup-poles"_s),
                    [this] { m_window.workspace().changeWorld(u"pose=7"_s); },
                    [setup] { return setup()->step() == SetupPage::Step::Poles; },
                    400,
                    {},
                    true});
    m_steps.append({pictureName(family, u"setup-start"_s),
                    [setup] { setup()->continueButton()->click(); },
                    [setup] { return setup()->step() == SetupPage::Step::AskStart; },
                    400,
                    {},
                    true});
    m_steps.append({pictureName(family, u"setup-yaw"_s),
                    [setup] { setup()->continueButton()->click(); },
                    [setup] {
                        return setup()->step() == SetupPage::Step::AlignYaw
                            && setup()->continueButton()->isEnabled();
                    },
                    600,
                    {},
                    true});
    m_steps.append({{},
                    [setup] { setup()->continueButton()->click(); },
                    [setup] { return setup()->step() == SetupPage::Step::AskFinish; },
                    0,
                    {},
                    true});
    m_steps.append({pictureName(family, u"setup-done"_s),
                    [setup] { setup()->continueButton()->click(); },
                    [setup] { return setup()->step() == SetupPage::Step::Done; },
                    600,
                    {},
                    true});
}

void Tour::addScriptSteps(const QString &family)
{
    m_steps.append({pictureName(family, u"scripts"_s),
                    [this] {
                        m_window.showPage(u"scripts"_s);
                        auto *scripts = static_cast<ScriptsPage *>(m_window.page(u"scripts"_s));
                        scripts->editor()->setText(u"; A slow look around\nCASE#DEFAULT\n  SETANGLE 0 0 0\n  "
                                                   u"WAIT 10\n  SETANGLEYAW_W 30 20\n  REPEAT\n"
                                                   "CASE#1\n  SET \"Pitch P\" 500\n  STOP\n"_s);
                    },
                    {},
                    900,
                    {},
                    false});
    m_steps.append({pictureName(family, u"scripts-wrong"_s),
                    [this] {
                        auto *scripts = static_cast<ScriptsPage *>(m_window.page(u"scripts"_s));
                        scripts->editor()->setText(scripts->editor()->text() + u"  FLY 3\n"_s);
                    },
                    {},
                    900,
                    {},
                    true});
    m_steps.append(
        {{},
         [this] { static_cast<ScriptsPage *>(m_window.page(u"scripts"_s))->revertButton()->click(); },
         {},
         200,
         {},
         false});
}

void Tour::addFamilyBoardSteps(const QString &family)
{
    Workspace &workspace = m_window.workspace();
    m_steps.append({pictureName(family, u"share"_s),
                    [this] {
                        m_window.showPage(u"backups"_s);
                        m_window.page(u"backups"_s)->findChild<QPushButton *>(u"share"_s)->click();
                    },
                    {},
                    800,
                    {},
                    true});
    m_steps.append({{}, [this] { m_window.findChild<ShareDialog *>()->reject(); }, {}, 200, {}, true});
    m_steps.append(
        {pictureName(family, u"review"_s),
         [this] {
             const ParameterSet &set
                 = std::as_const(m_window.workspace().configuration()).edited().parameters();
             for (const auto &[key, raw] :
                  {std::pair(u"pid.roll.p"_s, 450), {u"pan.mode.setting1"_s, 2}, {u"rc.pitch.min"_s, -300}})
                 m_window.workspace().edits().edit(set.find(key)->id, 0, raw);
             m_window.review();
         },
         [this] { return m_window.reviewDialog() != nullptr; },
         400,
         {},
         true});
    m_steps.append({pictureName(family, u"backups"_s),
                    [this] {
                        m_window.reviewDialog()->reject();
                        m_window.workspace().edits().discardAll();
                        m_window.showPage(u"backups"_s);
                    },
                    {},
                    500,
                    {},
                    true});
    m_steps.append({pictureName(family, u"console"_s), show(u"console"_s), {}, 800, {}, true});
    m_steps.append({pictureName(family, u"unstored"_s),
                    [this] {
                        m_window.showPage(u"actions"_s);
                        // The directions are stored since the setup; these poles are not.
                        m_window.workspace().perform(u"setup.poles"_s,
                                                     {{u"pitch"_s, 16}, {u"roll"_s, 14}, {u"yaw"_s, 14}});
                    },
                    [&workspace] { return workspace.isUnstored(); },
                    400,
                    {},
                    true});
}
#endif
