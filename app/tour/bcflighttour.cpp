// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of a drone.
#include "app/tour/tour.h"

#if GIMBAL_WITH_BCFLIGHT

#include "app/families/bcflight/benchcards.h"
#include "app/families/bcflight/benchpage.h"
#include "app/families/bcflight/camerapage.h"
#include "app/families/bcflight/fullview.h"
#include "app/families/bcflight/picturesettings.h"
#include "app/mainwindow/mainwindow.h"
#include "app/pages/board/directioncard.h"
#include "app/pages/board/flightpage.h"
#include "app/pages/setup/documentspage.h"
#include "protocol/base/filefault.h"
#include "protocol/device/device.h"
#include "protocol/device/flight.h"
#include "widgets/forms/panel.h"
#include "widgets/views/codeeditor.h"
#include "widgets/views/searchbar.h"
#include "widgets/views/videoview.h"

#include <QPushButton>
#include <QTemporaryDir>

#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr int kMistakenLine = 12;
constexpr int kBlackBoxRows = 600;
constexpr int kFirmwareSize = 300000;

// Its numbers are whole: what the program writes has decimals.
QByteArray someBlackBox()
{
    QByteArray text = "80999000,IMU:state,Off\n";
    for (int row = 0; row < kBlackBoxRows; ++row) {
        const QByteArray at = QByteArray::number(81000000 + row * 4000);
        const int turn = int(std::lround(40 * std::sin(row * 0.21)));
        text += at + ",IMU:rate,\"" + QByteArray::number(turn) + ",1,-2\"\n" + at + ",Stabilizer:thrust,"
            + QByteArray::number(row / 4) + '\n';
        if (row == 8)
            text += at + ",IMU:state,Running\n";
    }
    return text;
}

}  // namespace

void Tour::addDroneSteps(const QString &family)
{
    addConnecting(family);
    const auto isCalibrated
        = [this] { return m_window.workspace().latest(m_window.workspace().roles().calibrated) == 1.0; };
    m_steps.append({{},
                    show(u"dashboard"_s),
                    [this] { return m_window.workspace().latest(m_window.workspace().roles().armed) == 0.0; },
                    100,
                    {},
                    false});
    m_steps.append(
        {{}, [this] { m_window.workspace().perform(u"calibrate.all"_s, {}); }, isCalibrated, 100, {}, false});
    for (const QString &page :
         {u"dashboard"_s, u"monitor"_s, u"camera"_s, u"parameters"_s, u"tuning"_s, u"documents"_s,
          u"system"_s, u"recordings"_s, u"actions"_s, u"bench"_s, u"console"_s, u"backups"_s})
        m_steps.append({family + u'-' + page, show(page), {}, 1500, {}, page == u"dashboard"_s});
    addBenchSteps(family);
    addCameraSteps(family);
    addFlightSteps(family);
    addTextSteps(family);
    addGamepadStep();
    m_steps.append({{}, [this] { m_window.workspace().client().disconnectFromBoard(); }, {}, 100, {}, false});
    addBlackBoxSteps(family);
}

// The black box of a short flight.
void Tour::addBlackBoxSteps(const QString &family)
{
    const auto folder = std::make_shared<QTemporaryDir>();
    const auto isOpen = [this] {
        return m_window.workspace().client().isConnected() && !m_window.workspace().configuration().isEmpty();
    };
    m_steps.append({{},
                    [this, folder] {
                        const QString path = folder->filePath(u"blackbox_000001.csv"_s);
                        if (writeWhole(path, someBlackBox(), FileKind::Other))
                            std::ignore = m_window.workspace().openFile(path);
                    },
                    isOpen,
                    500,
                    {},
                    true});
    m_steps.append({family + u"-blackbox"_s, show(u"blackbox"_s), {}, 1500, {}, true});
    m_steps.append({{}, [this] { m_window.workspace().client().disconnectFromBoard(); }, {}, 100, {}, true});
}

// What is asked before motors turn or a firmware is replaced.
void Tour::addBenchSteps(const QString &family)
{
    const auto folder = std::make_shared<QTemporaryDir>();
    const auto bench = [this] { return static_cast<BenchPage *>(m_window.page(u"bench"_s)); };
    const auto isAsked = [this] { return m_window.panels()->isOpen(); };
    const auto addQuestion = [&](const QString &name, const std::function<QPushButton *()> &button) {
        m_steps.append({{}, show(u"bench"_s), [button] { return button()->isEnabled(); }, 100, {}, true});
        m_steps.append(
            {family + u"-bench-"_s + name, [button] { button()->click(); }, isAsked, 300, {}, true});
        m_steps.append({{}, [this] { m_window.panels()->rejectAll(); }, {}, 100, {}, true});
    };
    m_steps.append({{},
                    [bench, folder] {
                        const QString path = folder->filePath(u"flight-1.0.bin"_s);
                        if (writeWhole(path, QByteArray(kFirmwareSize, '\xa5'), FileKind::Other))
                            bench()->firmware()->choose(path);
                    },
                    {},
                    100,
                    {},
                    true});
    addQuestion(u"motor"_s, [bench] { return bench()->turnButton(); });
    addQuestion(u"esc"_s, [bench] { return bench()->escs()->startButton(); });
    addQuestion(u"firmware"_s, [bench] { return bench()->firmware()->uploadButton(); });
}

// On the whole screen, and what is asked for lens shading.
void Tour::addCameraSteps(const QString &family)
{
    const auto camera = [this] { return static_cast<CameraPage *>(m_window.page(u"camera"_s)); };
    const auto hasPicture = [camera] { return camera()->view()->picture() != nullptr; };
    m_steps.append({{}, show(u"camera"_s), hasPicture, 100, {}, true});
    m_steps.append(
        {family + u"-camera-full"_s, [camera] { camera()->fullView()->setOn(true); }, {}, 500, {}, true});
    m_steps.append({family + u"-camera-lens"_s,
                    [camera] {
                        camera()->fullView()->setOn(false);
                        camera()->settings()->button(u"camera.lens.set"_s)->click();
                    },
                    [this] { return m_window.panels()->isOpen(); },
                    300,
                    {},
                    true});
    m_steps.append({{}, [this] { m_window.panels()->rejectAll(); }, {}, 100, {}, true});
}

// Not checked, while it is checked, and ready to be armed.
void Tour::addFlightSteps(const QString &family)
{
    const auto flight = [this] { return static_cast<FlightPage *>(m_window.page(u"flight"_s)); };
    m_steps.append({family + u"-flight"_s, show(u"flight"_s), {}, 1000, {}, true});
    m_steps.append(
        {family + u"-flight-directions"_s, [flight] { flight()->directions()->begin(); }, {}, 500, {}, true});
    m_steps.append({family + u"-flight-open"_s,
                    [this, flight] {
                        flight()->directions()->cancel();
                        // As found by a check.
                        Workspace &workspace = m_window.workspace();
                        workspace.settings().setCheckedDirections(
                            workspace.client().identity().serial,
                            workspace.client().device()->flight()->axesKey(
                                std::as_const(workspace.configuration()).board()),
                            "2++++++");
                        flight()->open(true);
                    },
                    {},
                    500,
                    {},
                    true});
}

// A text with a mistake, what was searched for, and what differs.
void Tour::addTextSteps(const QString &family)
{
    const auto documents = [this] { return static_cast<DocumentsPage *>(m_window.page(u"documents"_s)); };
    m_steps.append({family + u"-text-mistake"_s,
                    [this, documents] {
                        m_window.showPage(u"documents"_s);
                        TextEditor *editor = documents()->editor();
                        editor->goToLine(kMistakenLine);
                        editor->insert(u"= "_s);
                    },
                    {},
                    1000,
                    {},
                    true});
    m_steps.append({family + u"-text-difference"_s,
                    [documents] { documents()->showDifference(true); },
                    {},
                    500,
                    {},
                    true});
    m_steps.append({family + u"-text-review"_s,
                    // One that is valid: the other is not even reviewed.
                    [this, documents] {
                        m_window.workspace().edits().discardAll();
                        documents()->showDifference(false);
                        documents()->editor()->goToLine(1);
                        documents()->editor()->insert(u"-- quieter yaw\n"_s);
                        m_window.review();
                    },
                    [this] { return m_window.reviewDialog() != nullptr; },
                    500,
                    {},
                    true});
    m_steps.append({family + u"-text-search"_s,
                    [this, documents] {
                        if (m_window.reviewDialog())
                            m_window.reviewDialog()->reject();
                        m_window.workspace().edits().discardAll();
                        documents()->search(u"pid_"_s);
                    },
                    {},
                    500,
                    {},
                    true});
    m_steps.append({{}, [documents] { documents()->findChild<SearchBar *>()->end(); }, {}, 100, {}, true});
}

#endif
