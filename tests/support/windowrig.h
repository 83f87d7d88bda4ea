// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/composition/composition.h"
#include "app/mainwindow/mainwindow.h"
#include "app/mainwindow/pagetable.h"

#include <QTemporaryDir>
#include <QTest>

/// The real window on a simulated board, with folders of its own for settings and history.
class WindowRig
{
public:
    WindowRig()
    {
        m_theme.setMode(Theme::Mode::Light);
        m_theme.apply();
        qputenv("XDG_DATA_HOME", m_dir.path().toLocal8Bit());
        restart();
    }

    /// The program ends and starts again.
    void restart()
    {
        m_window.reset();
        m_settings = std::make_unique<Settings>(filePath(QStringLiteral("settings.ini")));
        m_window = std::make_unique<MainWindow>(allLinks(), allFamilies(), m_theme, *m_settings);
        m_window->show();
        if (!QTest::qWaitForWindowExposed(m_window.get()))
            qFatal("no window");
        m_window->activateWindow();
    }
    /// The program is gone from one moment to the next: nothing is written any more.
    void crash()
    {
        m_window->workspace().journal().abandon();
        m_window.reset();
    }

    bool open(const QString &address = QStringLiteral("sim:simplebgc"))
    {
        m_window->openLink(address);
        return QTest::qWaitFor([this] { return client().isConnected() && !model().isEmpty(); }, 15000);
    }
    MainWindow &window() { return *m_window; }
    Workspace &workspace() { return m_window->workspace(); }
    ConfigurationModel &model() { return workspace().configuration(); }
    DeviceClient &client() { return workspace().client(); }
    Theme &theme() { return m_theme; }
    Settings &settings() { return *m_settings; }
    [[nodiscard]] QString filePath(const QString &name) const { return m_dir.filePath(name); }

    /// Shows the page of that class.
    template <typename P> P *page()
    {
        for (const PageEntry &entry : pageTable()) {
            const QString key = QString::fromLatin1(entry.key);
            if (QString::fromLatin1(P::staticMetaObject.className()).toLower()
                != key + QStringLiteral("page"))
                continue;
            m_window->showPage(key);
            return qobject_cast<P *>(m_window->page(key));
        }
        return nullptr;
    }
    const ParameterSpec &spec(const QString &key) { return *model().edited().parameters().find(key); }
    /// What the board holds, as last read.
    int raw(const QString &key, int profile = 0)
    {
        return std::as_const(model()).board().raw(spec(key), profile).value();
    }
    void edit(const QString &key, int profile, int value)
    {
        workspace().edits().edit(spec(key).id, profile, value);
    }

private:
    QTemporaryDir m_dir;
    Theme m_theme;
    std::unique_ptr<Settings> m_settings;
    std::unique_ptr<MainWindow> m_window;
};
