// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/filedialogs.h"
#include "app/workspace/workspace.h"

#include <QTimer>
#include <QWidget>

#include <any>
#include <chrono>
#include <functional>

class QAbstractScrollArea;
class QHBoxLayout;
class QHeaderView;
class QLabel;
class QVBoxLayout;

enum class SetupStep : std::uint8_t;

/// A page of the main window: a header with title and actions, and a body.
class Page : public QWidget
{
    Q_OBJECT
public:
    Page(Workspace &workspace, const QString &key, const QString &title, QWidget *parent = nullptr);
    ~Page() override;

    /// Name for `--page` and for picture files.
    [[nodiscard]] const QString &key() const { return m_key; }
    [[nodiscard]] const QString &title() const { return m_title; }
    /// Unsaved changes live on this page.
    [[nodiscard]] virtual bool hasChanges() const { return false; }
    /// Something runs or is half done that ends with the page.
    [[nodiscard]] virtual bool isUnderWay() const { return false; }
    /// What only this page holds and the operator would miss, for the page that takes its place when all are
    /// made anew: measurements, comparisons, what is chosen. Empty: nothing.
    [[nodiscard]] virtual std::any keep() { return {}; }
    /// @param kept what the page before it kept; never empty
    virtual void resume(const std::any &kept) { Q_UNUSED(kept) }

signals:
    void changesChanged();
    /// The operator wants to go to an action of the board, which this page has named.
    void actionWanted(const QString &key);
    /// The operator wants to go to the page of that key.
    void pageWanted(const QString &key);
    /// The operator wants to go to that step of the guided set-up.
    void setupStepWanted(SetupStep step);

protected:
    [[nodiscard]] Workspace &workspace() const { return m_workspace; }
    [[nodiscard]] QVBoxLayout *body() const { return m_body; }
    /// Space in the header, right of the title.
    [[nodiscard]] QHBoxLayout *header() const { return m_header; }

    /// Covers a view of live data while these channels are stale; none = all.
    void coverWhenStale(QWidget &view, const Freshness::Channels &channels = {},
                        StaleCover::Look look = StaleCover::Look::Veil);
    /// Fades the column of a table that shows live data, while there are none.
    void fadeWhenStale(QAbstractScrollArea &table, const QHeaderView &header, int column);

    /// Does this when the page comes into view, and again at this interval as long as it is seen and not
    /// paused.
    void refreshWhileShown(std::chrono::milliseconds interval, std::function<void()> refresh,
                           std::function<bool()> isPaused);
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    Workspace &m_workspace;
    QString m_key;
    QString m_title;
    QVBoxLayout *m_body;
    QHBoxLayout *m_header;
    QTimer m_refreshTimer;
    std::function<void()> m_refresh;
};
