// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/composition/composition.h"
#include "app/mainwindow/mainwindow.h"
#include "app/mainwindow/navigation.h"
#include "app/mainwindow/pagetable.h"
#include "tests/support/boardtime.h"
#include "tests/support/patience.h"

#include <QTemporaryDir>
#include <QTest>

#include <filesystem>

/// Whether the navigation marks this page as one with unsaved changes.
inline bool isMarked(const MainWindow &window, const QString &title)
{
    return !window.navigation()->findItems(title + QStringLiteral(" •"), Qt::MatchExactly).isEmpty();
}

/// The real window on a simulated board, with folders of its own for settings and history.
class WindowRig
{
public:
    /// @param links, families the composition; by default the program's own
    explicit WindowRig(Links links = allLinks(), QList<Family> families = allFamilies())
        : m_links(std::move(links))
        , m_families(std::move(families))
    {
        m_theme.setMode(Theme::Mode::Light);
        m_theme.apply();
        qputenv("XDG_DATA_HOME", m_dir.path().toLocal8Bit());
        restart();
    }

    /// The program ends and starts again.
    void restart()
    {
        // Pages have the room that they are made for, however small the screen of the platform is.
        const QSize size = m_window ? m_window->size() : QSize(1280, 800);
        m_window.reset();
        m_settings = std::make_unique<Settings>(filePath(QStringLiteral("settings.ini")));
        m_settings->setAskAboutMotors(false);
        m_window = std::make_unique<MainWindow>(m_links, m_families, m_theme, *m_settings);
        // What the operator was told stands beside a failure.
        QObject::connect(&workspace().notifications(), &Notifications::problem, m_window.get(),
                         [](const ErrorText &text) { qInfo().noquote() << "told:" << text.oneLine(); });
        m_window->resize(size);
        m_window->show();
        if (!QTest::qWaitForWindowExposed(m_window.get()))
            qFatal("no window");
        m_window->activateWindow();
    }
    /// The program is gone from one moment to the next: what is on the disk stays as it is now.
    void crash()
    {
        namespace fs = std::filesystem;
        const fs::path history = BoardHistory::defaultRoot().toStdString();
        const fs::path kept = filePath(QStringLiteral("kept")).toStdString();
        fs::remove_all(kept);
        fs::copy(history, kept, fs::copy_options::recursive);
        m_window.reset();
        fs::remove_all(history);
        fs::rename(kept, history);
    }

    /// @param address by default a simulated board of the first family
    bool open(const QString &address = {})
    {
        m_window->openLink(address.isEmpty() ? QStringLiteral("sim:") + m_families.first().key : address);
        return QTest::qWaitFor([this] { return client().isConnected() && !model().isEmpty(); }, kPatience);
    }
    /// Waits until so many more seconds of samples have come from the board.
    bool boardGoesOn(double seconds) { return ::boardGoesOn(client(), seconds); }
    /// Waits until everything that was submitted so far is done and its results have arrived.
    bool jobsAreDone()
    {
        const auto done = std::make_shared<bool>(false);
        client()
            .submit<bool>([](Channel &, Device &) -> Result<bool> { return true; })
            .then(m_window.get(), [done](const Result<bool> &) { *done = true; });
        return QTest::qWaitFor([done] { return *done; },
                               kPatience);  // whole reads through MAVLink are before it
    }
    /// Waits until a turn of the event loop moves no widget any more.
    bool isSettled()
    {
        QList<QRect> before;
        return QTest::qWaitFor([this, &before] {
            QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
            QList<QRect> now;
            for (const QWidget *widget : m_window->findChildren<QWidget *>()) {
                if (widget->isVisible())
                    now.append(widget->geometry());
            }
            return std::exchange(before, now) == now;
        });
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
    double raw(const QString &key, int profile = 0)
    {
        return std::as_const(model()).board().raw(spec(key), profile).value();
    }
    void edit(const QString &key, int profile, double value)
    {
        workspace().edits().edit(spec(key).id, profile, value);
    }

private:
    Links m_links;
    QList<Family> m_families;
    QTemporaryDir m_dir;
    Theme m_theme;
    std::unique_ptr<Settings> m_settings;
    std::unique_ptr<MainWindow> m_window;
};
