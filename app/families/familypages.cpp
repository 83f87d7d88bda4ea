// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/familypages.h"

#if GIMBAL_WITH_BCFLIGHT
#include "app/families/bcflight/benchpage.h"
#include "app/families/bcflight/camerapage.h"
#include "app/families/bcflight/recordingspage.h"
#include "app/families/bcflight/systempage.h"
#endif
#if GIMBAL_WITH_SIMPLEBGC
#include "app/families/simplebgc/autotunepage.h"
#include "app/families/simplebgc/calibrationpage.h"
#include "app/families/simplebgc/scriptslotspage.h"
#include "app/families/simplebgc/signalspage.h"
#include "app/families/simplebgc/wholeboardpage.h"
#endif
#if GIMBAL_WITH_STORM32
#include "app/families/storm32/sensorpage.h"
#include "app/families/storm32/setuppage.h"
#endif

#include <QCoreApplication>

#if GIMBAL_WITH_SIMPLEBGC
namespace {

bool keepsScriptSlots(const Workspace &workspace)
{
    const DeviceClient &client = workspace.client();
    return !client.isConnected() || client.identity().capabilities.contains(QStringLiteral("scripting"));
}

}  // namespace
#endif

// clang-format off
QList<PageEntry> familyPages()
{
    QList<PageEntry> pages;
#if GIMBAL_WITH_STORM32
    pages += {
        {"sensor", QT_TRANSLATE_NOOP("Pages", "Calibration"), QT_TRANSLATE_NOOP("Pages", "Set up"), makePage<SensorPage>, nullptr, "storm32", "profiles"},
        {"setup", QT_TRANSLATE_NOOP("Pages", "Gimbal setup"), QT_TRANSLATE_NOOP("Pages", "Set up"), makePage<SetupPage>, nullptr, "storm32", "profiles"},
    };
#endif
#if GIMBAL_WITH_SIMPLEBGC
    pages += {
        {"calibration", QT_TRANSLATE_NOOP("Pages", "Calibration"), QT_TRANSLATE_NOOP("Pages", "Set up"), makePage<CalibrationPage>, nullptr, "simplebgc", "profiles"},
        {"scriptslots", QT_TRANSLATE_NOOP("Pages", "Scripts"), QT_TRANSLATE_NOOP("Pages", "Set up"), makePage<ScriptSlotsPage>, keepsScriptSlots, "simplebgc", "profiles"},
        {"signals", QT_TRANSLATE_NOOP("Pages", "Signals"), QT_TRANSLATE_NOOP("Pages", "Board"), makePage<SignalsPage>, nullptr, "simplebgc", "control"},
        {"wholeboard", QT_TRANSLATE_NOOP("Pages", "Whole board"), QT_TRANSLATE_NOOP("Pages", "Board"), makePage<WholeBoardPage>, nullptr, "simplebgc", "backups"},
        {"autotune", QT_TRANSLATE_NOOP("Pages", "Auto-tune"), QT_TRANSLATE_NOOP("Pages", "Tune"), makePage<AutoTunePage>, nullptr, "simplebgc", "response"},
    };
#endif
#if GIMBAL_WITH_BCFLIGHT
    pages += {
        {"bench", QT_TRANSLATE_NOOP("Pages", "Test bench"), QT_TRANSLATE_NOOP("Pages", "Board"), makePage<BenchPage>, nullptr, "bcflight", "actions"},
        {"system", QT_TRANSLATE_NOOP("Pages", "System"), QT_TRANSLATE_NOOP("Pages", "Board"), makePage<SystemPage>, nullptr, "bcflight", "backups"},
        {"recordings", QT_TRANSLATE_NOOP("Pages", "Recordings"), QT_TRANSLATE_NOOP("Pages", "Board"), makePage<RecordingsPage>, nullptr, "bcflight", "system"},
        {"camera", QT_TRANSLATE_NOOP("Pages", "Camera"), QT_TRANSLATE_NOOP("Pages", "Watch"), makePage<CameraPage>, nullptr, "bcflight", "monitor"},
    };
#endif
    return pages;
}
// clang-format on
