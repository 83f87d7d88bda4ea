// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Where the main window stands: never with a part of it, the red button say, off the screen.
#include "app/mainwindow/windowplace.h"

#include "app/mainwindow/mainwindow.h"

#include <QGuiApplication>
#include <QScreen>
#include <QTimer>
#include <QWindow>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

constexpr QSize kFullSize(1024, 640);  // holds every page
constexpr QSize kSmallestSize(560, 320);
constexpr QSize kFirstSize(1280, 800);
constexpr QSize kDecoration(16, 40);  // what a window manager puts around

// Without a display, Qt's screen is one in name only: pictures are as large as they are asked for.
bool isNominal(const QScreen *screen)
{
    return !screen || QGuiApplication::platformName() == u"offscreen"_s;
}

QSize roomOn(const QScreen *screen)
{
    return isNominal(screen) ? kFirstSize : screen->availableSize() - kDecoration;
}

}  // namespace

QRect keptOnScreen(const QRect &frame, const QRect &room)
{
    const QSize size = frame.size().boundedTo(room.size());
    return {std::clamp(frame.x(), room.x(), room.x() + room.width() - size.width()),
            std::clamp(frame.y(), room.y(), room.y() + room.height() - size.height()), size.width(),
            size.height()};
}

void MainWindow::takePlace(const QByteArray &saved)
{
    resize(kFirstSize.boundedTo(roomOn(screen())));
    restoreGeometry(saved);
    // Who quit while one view had the whole screen does not begin so.
    setWindowState(windowState() & ~Qt::WindowFullScreen);
    keepOnScreen();
}

// On a screen with less room the content is scrolled, and the red button stays where it is.
void MainWindow::keepOnScreen()
{
    setMinimumSize(kFullSize.boundedTo(roomOn(screen())).expandedTo(kSmallestSize));
    if (isNominal(screen()) || isMaximized() || isFullScreen())
        return;
    const QSize around = (frameGeometry().size() - size()).expandedTo(kDecoration);
    const QRect frame(pos(), size() + around);
    const QRect kept = keptOnScreen(frame, screen()->availableGeometry());
    if (kept.size() != frame.size())
        resize(kept.size() - around);
    if (kept.topLeft() != frame.topLeft())
        move(kept.topLeft());
}

void MainWindow::showEvent(QShowEvent *event)
{
    QMainWindow::showEvent(event);
    if (m_isPlaced || !windowHandle())
        return;
    m_isPlaced = true;
    const auto follow = [this] {
        disconnect(m_room);
        m_room = connect(screen(), &QScreen::availableGeometryChanged, this, &MainWindow::keepOnScreen);
    };
    connect(windowHandle(), &QWindow::screenChanged, this, [this, follow] {
        follow();
        QTimer::singleShot(0, this, &MainWindow::keepOnScreen);  // the frame has its size then
    });
    follow();
    QTimer::singleShot(0, this, &MainWindow::keepOnScreen);
}
