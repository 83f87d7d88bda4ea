// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/pagetable.h"

#include "app/families/familypages.h"
#include "app/pages/board/actionspage.h"
#include "app/pages/board/backupspage.h"
#include "app/pages/board/consolepage.h"
#include "app/pages/board/controlpage.h"
#include "app/pages/board/flightpage.h"
#include "app/pages/program/gamepadpage.h"
#include "app/pages/program/helppage.h"
#include "app/pages/program/settingspage.h"
#include "app/pages/setup/documentspage.h"
#include "app/pages/setup/guidepage.h"
#include "app/pages/setup/parameterspage.h"
#include "app/pages/setup/profilespage.h"
#include "app/pages/setup/scriptspage.h"
#include "app/pages/tune/responsepage.h"
#include "app/pages/tune/spectrumpage.h"
#include "app/pages/tune/tuningpage.h"
#include "app/pages/tune/variablespage.h"
#include "app/pages/watch/blackboxpage.h"
#include "app/pages/watch/dashboardpage.h"
#include "app/pages/watch/debugpage.h"
#include "app/pages/watch/monitorpage.h"
#include "protocol/device/flight.h"
#include "protocol/device/steering.h"

#include <QCoreApplication>

namespace {

// What a page needs of a board.
// A black box is no board: it has been recorded, and that is all.
bool isBoard(const Workspace &workspace)
{
    return !workspace.expectedFamily()->links.isEmpty();
}

bool isBlackBox(const Workspace &workspace)
{
    return !isBoard(workspace);
}

bool hasProfiles(const Workspace &workspace)
{
    return workspace.tables()->profiles();
}

bool hasInnerVariables(const Workspace &workspace)
{
    return workspace.tables()->innerVariables();
}

bool hasLiveValues(const Workspace &workspace)
{
    return workspace.tables()->live();
}

bool canBeSteered(const Workspace &workspace)
{
    return workspace.tables()->steering() && !workspace.tables()->flight();
}

bool canBeGuided(const Workspace &workspace)
{
    return workspace.tables()->setupFacts();
}

bool flies(const Workspace &workspace)
{
    return workspace.tables()->flight();
}

bool hasMotionSensors(const Workspace &workspace)
{
    const ChannelRoles roles = rolesOf(*workspace.tables());
    return !ChannelRoles::present({roles.gyro, roles.angle}).isEmpty();
}

// A response is measured by steering to an angle.
bool showsMotion(const Workspace &workspace)
{
    const Steering *steering = workspace.tables()->steering();
    const auto modes = steering ? steering->modes() : std::span<const SteeringMode>();
    return hasMotionSensors(workspace)
        && std::any_of(modes.begin(), modes.end(),
                       [](const SteeringMode &mode) { return mode.isPositional(); });
}

bool wordsFrames(const Workspace &workspace)
{
    return workspace.tables()->inspector();
}

bool keepsScripts(const Workspace &workspace)
{
    return workspace.family() && workspace.family()->scripts;
}

bool keepsDocuments(const Workspace &workspace)
{
    const ConfigurationModel &shown = workspace.configuration();
    const auto set = !shown.isEmpty() && !workspace.client().isConnected() ? shown.board().parameterSet()
                                                                           : workspace.tables()->parameters();
    const auto blocks = set ? set->blocks() : std::span<const BlockSpec>();
    return std::any_of(blocks.begin(), blocks.end(), [](const BlockSpec &block) { return block.isText(); });
}

bool isPageOffered(const QString &key, const Workspace &workspace)
{
    const auto pages = pageTable();
    return std::any_of(pages.begin(), pages.end(), [&](const PageEntry &entry) {
        return key == QLatin1String(entry.key) && isOffered(entry, workspace);
    });
}

Page *makeHelp(Workspace &workspace)
{
    return new HelpPage(workspace,
                        [&workspace](const QString &key) { return isPageOffered(key, workspace); });
}

// clang-format off
constexpr PageEntry kPages[] = {
    {"dashboard", QT_TRANSLATE_NOOP("Pages", "Dashboard"), QT_TRANSLATE_NOOP("Pages", "Watch"), makePage<DashboardPage>},
    {"monitor", QT_TRANSLATE_NOOP("Pages", "Monitor"), QT_TRANSLATE_NOOP("Pages", "Watch"), makePage<MonitorPage>},
    {"blackbox", QT_TRANSLATE_NOOP("Pages", "Black box"), QT_TRANSLATE_NOOP("Pages", "Watch"), makePage<BlackBoxPage>, isBlackBox},
    {"debug", QT_TRANSLATE_NOOP("Pages", "Debug variables"), QT_TRANSLATE_NOOP("Pages", "Watch"), makePage<DebugPage>, hasInnerVariables},
    {"guide", QT_TRANSLATE_NOOP("Pages", "Gimbal setup"), QT_TRANSLATE_NOOP("Pages", "Set up"), makePage<GuidePage>, canBeGuided},
    {"parameters", QT_TRANSLATE_NOOP("Pages", "Parameters"), QT_TRANSLATE_NOOP("Pages", "Set up"), makePage<ParametersPage>, isBoard},
    {"profiles", QT_TRANSLATE_NOOP("Pages", "Profiles"), QT_TRANSLATE_NOOP("Pages", "Set up"), makePage<ProfilesPage>, hasProfiles},
    {"scripts", QT_TRANSLATE_NOOP("Pages", "Scripts"), QT_TRANSLATE_NOOP("Pages", "Set up"), makePage<ScriptsPage>, keepsScripts},
    {"documents", QT_TRANSLATE_NOOP("Pages", "Documents"), QT_TRANSLATE_NOOP("Pages", "Set up"), makePage<DocumentsPage>, keepsDocuments},
    {"tuning", QT_TRANSLATE_NOOP("Pages", "Tuning"), QT_TRANSLATE_NOOP("Pages", "Tune"), makePage<TuningPage>, hasLiveValues},
    {"spectrum", QT_TRANSLATE_NOOP("Pages", "Spectrum"), QT_TRANSLATE_NOOP("Pages", "Tune"), makePage<SpectrumPage>, hasMotionSensors},
    {"response", QT_TRANSLATE_NOOP("Pages", "Response"), QT_TRANSLATE_NOOP("Pages", "Tune"), makePage<ResponsePage>, showsMotion},
    {"variables", QT_TRANSLATE_NOOP("Pages", "Adjustable variables"), QT_TRANSLATE_NOOP("Pages", "Tune"),
     makePage<VariablesPage>, hasLiveValues},
    {"control", QT_TRANSLATE_NOOP("Pages", "Control"), QT_TRANSLATE_NOOP("Pages", "Board"), makePage<ControlPage>, canBeSteered},
    {"flight", QT_TRANSLATE_NOOP("Pages", "Flight"), QT_TRANSLATE_NOOP("Pages", "Board"), makePage<FlightPage>, flies},
    {"actions", QT_TRANSLATE_NOOP("Pages", "Actions"), QT_TRANSLATE_NOOP("Pages", "Board"), makePage<ActionsPage>, isBoard},
    {"backups", QT_TRANSLATE_NOOP("Pages", "Backups"), QT_TRANSLATE_NOOP("Pages", "Board"), makePage<BackupsPage>, isBoard},
    {"console", QT_TRANSLATE_NOOP("Pages", "Console"), QT_TRANSLATE_NOOP("Pages", "Board"), makePage<ConsolePage>, wordsFrames},
    {"gamepad", QT_TRANSLATE_NOOP("Pages", "Gamepad"), QT_TRANSLATE_NOOP("Pages", "Program"), makePage<GamepadPage>},
    {"settings", QT_TRANSLATE_NOOP("Pages", "Settings"), QT_TRANSLATE_NOOP("Pages", "Program"), makePage<SettingsPage>},
    {"help", QT_TRANSLATE_NOOP("Pages", "Help"), QT_TRANSLATE_NOOP("Pages", "Program"), makeHelp},
};
// clang-format on

}  // namespace

// The pages of families stand behind the page that each names.
std::span<const PageEntry> pageTable()
{
    static const std::vector<PageEntry> table = [] {
        std::vector<PageEntry> all(std::begin(kPages), std::end(kPages));
        for (const PageEntry &own : familyPages()) {
            const auto before = std::find_if(all.begin(), all.end(), [&own](const PageEntry &entry) {
                return qstrcmp(entry.key, own.after) == 0;
            });
            all.insert(before == all.end() ? before : before + 1, own);
        }
        return all;
    }();
    return table;
}

bool isOffered(const PageEntry &entry, const Workspace &workspace)
{
    if (*entry.family && workspace.expectedFamily()->key != QLatin1String(entry.family))
        return false;
    return !entry.fits || entry.fits(workspace);
}

QString pageText(const char *text)
{
    return QCoreApplication::translate("Pages", text);
}
