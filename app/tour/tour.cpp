// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tour/tour.h"

#include "app/mainwindow/mainwindow.h"

#include <QDir>

using namespace Qt::StringLiterals;

namespace {

constexpr int kPollMs = 50;
constexpr int kLimitMs = 90000;  // for one step

// A gamepad with its left stick pushed, for the pictures.
class PicturedGamepad final : public GamepadSource
{
public:
    Result<void> open() override { return {}; }
    std::vector<GamepadReading> poll() override
    {
        return {
            {1, "picture", u"Wireless controller"_s, {0.35, -0.7, -1, 0.02, 0, -0.4}, std::vector<bool>(12)}};
    }
};

}  // namespace

Tour::Tour(MainWindow &window, QString folder, QString suffix, Extent extent, QString family, QObject *parent)
    : QObject(parent)
    , m_window(window)
    , m_folder(std::move(folder))
    , m_suffix(std::move(suffix))
    , m_extent(extent)
    , m_family(std::move(family))
{
    m_timer.setInterval(kPollMs);
    connect(&m_timer, &QTimer::timeout, this, &Tour::poll);
    addSteps();
    if (m_extent == Extent::Pages)
        m_steps.removeIf([](const Step &step) { return step.everythingOnly; });
}

void Tour::start()
{
    if (!QDir().mkpath(m_folder)) {
        QTimer::singleShot(0, this, [this] { fail(u"cannot make the folder %1"_s.arg(m_folder)); });
        return;
    }
    if (m_steps.isEmpty()) {
        QTimer::singleShot(0, this, [this] { fail(u"there is no tour with such a board"_s); });
        return;
    }
    m_timer.start();
    begin();
}

std::function<void()> Tour::show(const QString &page)
{
    return [this, page] { m_window.showPage(page); };
}

void Tour::addSteps()
{
    for (const Family &family : m_window.workspace().client().families()) {
        if (!family.links.isEmpty() && (m_family.isEmpty() || m_family == family.key))
            addStepsOf(family.key);
    }
}

void Tour::addStepsOf(const QString &family)
{
#if GIMBAL_WITH_SIMPLEBGC
    if (family == u"simplebgc"_s)
        addSimpleBgcSteps();
#endif
#if GIMBAL_WITH_STORM32
    if (family == u"storm32"_s)
        addFamilySteps(family);
#endif
#if GIMBAL_WITH_BCFLIGHT
    if (family == u"bcflight"_s)
        addDroneSteps(family);
#endif
}

void Tour::addGamepadStep()
{
    m_steps.append({u"gamepad"_s,
                    [this] {
                        Gamepad &gamepad = m_window.workspace().gamepad();
                        gamepad.setMaker([]() -> Result<std::unique_ptr<GamepadSource>> {
                            return std::make_unique<PicturedGamepad>();
                        });
                        m_window.showPage(u"gamepad"_s);
                    },
                    [this] {
                        Gamepad &gamepad = m_window.workspace().gamepad();
                        if (!gamepad.reading())
                            return false;
                        GamepadMapping mapping = gamepad.mapping();
                        mapping.assign(GamepadStick::Yaw, 0, false);
                        mapping.assign(GamepadStick::Pitch, 1, true);
                        mapping.assign(GamepadStick::Roll, 3, false);
                        mapping.assign(GamepadStick::Speed, 5, false);
                        mapping[GamepadStick::Pitch].expo = 0.3;
                        mapping.assign(GamepadButton::Disarm, 1);
                        gamepad.setMapping(mapping);
                        return true;
                    },
                    400,
                    {},
                    false});
}

// To the family's simulated board, from whatever was connected before.
void Tour::addConnecting(const QString &family)
{
    Workspace &workspace = m_window.workspace();
    m_steps.append({{},
                    [this, family] {
                        m_window.workspace().client().disconnectFromBoard();
                        m_window.openLink(u"sim:"_s + family);
                        m_window.showPage(u"monitor"_s);
                    },
                    [&workspace, family] {
                        return workspace.client().isConnected()
                            && workspace.client().identity().family == family
                            && !workspace.configuration().isEmpty()
                            && std::as_const(workspace.configuration()).board().identity().family == family
                            && workspace.motorsRunning().has_value();
                    },
                    3000,
                    {},
                    false});
}

void Tour::begin()
{
    ++m_at;
    m_since.start();
    if (m_at >= m_steps.size()) {
        m_timer.stop();
        emit finished(m_pictures, {});
        return;
    }
    if (m_steps[m_at].prepare)
        m_steps[m_at].prepare();
}

void Tour::poll()
{
    const Step &step = m_steps[m_at];
    if (m_since.elapsed() > kLimitMs) {
        fail(u"step %1 (%2) did not come about"_s.arg(m_at).arg(step.name));
        return;
    }
    if (step.ready) {
        if (!step.ready())
            return;
        // From here on, only the time to settle matters.
        m_steps[m_at].ready = {};
        m_since.start();
        return;
    }
    if (m_since.elapsed() < step.settleMs)
        return;
    if (!step.name.isEmpty() && !save(step))
        return;
    begin();
}

void Tour::fail(const QString &error)
{
    m_timer.stop();
    emit finished({}, error);
}

bool Tour::save(const Step &step)
{
    QWidget *widget = step.what ? step.what() : &m_window;
    const QString path = QDir(m_folder).filePath(step.name + m_suffix + u".png"_s);
    if (!widget || !widget->grab().save(path)) {
        fail(u"cannot write %1"_s.arg(path));
        return false;
    }
    m_pictures.append(path);
    return true;
}
