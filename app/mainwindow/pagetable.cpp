// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/pagetable.h"

#include "app/pages/actionspage.h"
#include "app/pages/backupspage.h"
#include "app/pages/consolepage.h"
#include "app/pages/controlpage.h"
#include "app/pages/dashboardpage.h"
#include "app/pages/debugpage.h"
#include "app/pages/helppage.h"
#include "app/pages/monitorpage.h"
#include "app/pages/parameterspage.h"
#include "app/pages/profilespage.h"
#include "app/pages/responsepage.h"
#include "app/pages/scriptspage.h"
#include "app/pages/settingspage.h"
#include "app/pages/spectrumpage.h"
#include "app/pages/tuningpage.h"
#include "app/pages/variablespage.h"
#include "app/wizards/autotunepage.h"
#include "app/wizards/calibrationpage.h"
#include "app/wizards/sensorpage.h"
#include "app/wizards/setuppage.h"

#include <QCoreApplication>

namespace {

template <typename P> Page *make(Workspace &workspace)
{
    return new P(workspace);
}

bool hasDebugVariables(const Workspace &workspace)
{
    return workspace.tables()->hasDebugVariables();
}

bool hasProfiles(const Workspace &workspace)
{
    return workspace.profileCount() != 1;
}

bool calibratesItself(const Workspace &workspace)
{
    return workspace.hasAction(QStringLiteral("calibrate.gyro"));
}

bool tunesItself(const Workspace &workspace)
{
    return workspace.hasAction(QStringLiteral("autotune"));
}

bool givesReadings(const Workspace &workspace)
{
    return workspace.hasAction(QStringLiteral("sensors.average"));
}

bool isSetUpByTasks(const Workspace &workspace)
{
    return workspace.hasAction(QStringLiteral("setup.orientation"));
}

bool keepsScripts(const Workspace &workspace)
{
    return workspace.family() && workspace.family()->scripts;
}

constexpr PageEntry kPages[] = {
    {"dashboard", QT_TRANSLATE_NOOP("Pages", "Dashboard"), QT_TRANSLATE_NOOP("Pages", "Watch"),
     make<DashboardPage>},
    {"monitor", QT_TRANSLATE_NOOP("Pages", "Monitor"), QT_TRANSLATE_NOOP("Pages", "Watch"),
     make<MonitorPage>},
    {"debug", QT_TRANSLATE_NOOP("Pages", "Debug variables"), QT_TRANSLATE_NOOP("Pages", "Watch"),
     make<DebugPage>, hasDebugVariables},
    {"parameters", QT_TRANSLATE_NOOP("Pages", "Parameters"), QT_TRANSLATE_NOOP("Pages", "Set up"),
     make<ParametersPage>},
    {"profiles", QT_TRANSLATE_NOOP("Pages", "Profiles"), QT_TRANSLATE_NOOP("Pages", "Set up"),
     make<ProfilesPage>, hasProfiles},
    {"calibration", QT_TRANSLATE_NOOP("Pages", "Calibration"), QT_TRANSLATE_NOOP("Pages", "Set up"),
     make<CalibrationPage>, calibratesItself},
    {"setup", QT_TRANSLATE_NOOP("Pages", "Gimbal setup"), QT_TRANSLATE_NOOP("Pages", "Set up"),
     make<SetupPage>, isSetUpByTasks},
    {"sensor", QT_TRANSLATE_NOOP("Pages", "Calibration"), QT_TRANSLATE_NOOP("Pages", "Set up"),
     make<SensorPage>, givesReadings},
    {"scripts", QT_TRANSLATE_NOOP("Pages", "Scripts"), QT_TRANSLATE_NOOP("Pages", "Set up"),
     make<ScriptsPage>, keepsScripts},
    {"tuning", QT_TRANSLATE_NOOP("Pages", "Tuning"), QT_TRANSLATE_NOOP("Pages", "Tune"), make<TuningPage>},
    {"spectrum", QT_TRANSLATE_NOOP("Pages", "Spectrum"), QT_TRANSLATE_NOOP("Pages", "Tune"),
     make<SpectrumPage>},
    {"response", QT_TRANSLATE_NOOP("Pages", "Response"), QT_TRANSLATE_NOOP("Pages", "Tune"),
     make<ResponsePage>},
    {"autotune", QT_TRANSLATE_NOOP("Pages", "Auto-tune"), QT_TRANSLATE_NOOP("Pages", "Tune"),
     make<AutoTunePage>, tunesItself},
    {"variables", QT_TRANSLATE_NOOP("Pages", "Adjustable variables"), QT_TRANSLATE_NOOP("Pages", "Tune"),
     make<VariablesPage>},
    {"control", QT_TRANSLATE_NOOP("Pages", "Control"), QT_TRANSLATE_NOOP("Pages", "Board"),
     make<ControlPage>},
    {"actions", QT_TRANSLATE_NOOP("Pages", "Actions"), QT_TRANSLATE_NOOP("Pages", "Board"),
     make<ActionsPage>},
    {"backups", QT_TRANSLATE_NOOP("Pages", "Backups"), QT_TRANSLATE_NOOP("Pages", "Board"),
     make<BackupsPage>},
    {"console", QT_TRANSLATE_NOOP("Pages", "Console"), QT_TRANSLATE_NOOP("Pages", "Board"),
     make<ConsolePage>},
    {"settings", QT_TRANSLATE_NOOP("Pages", "Settings"), QT_TRANSLATE_NOOP("Pages", "Program"),
     make<SettingsPage>},
    {"help", QT_TRANSLATE_NOOP("Pages", "Help"), QT_TRANSLATE_NOOP("Pages", "Program"), make<HelpPage>},
};

}  // namespace

std::span<const PageEntry> pageTable()
{
    return kPages;
}

QString pageText(const char *text)
{
    return QCoreApplication::translate("Pages", text);
}
