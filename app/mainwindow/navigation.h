// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QListWidget>

/// The list of pages at the left: groups with headings, an icon and a word for each page, a dot for unsaved
/// changes.
class Navigation final : public QListWidget
{
    Q_OBJECT
public:
    explicit Navigation(QWidget *parent = nullptr);

    [[nodiscard]] QString currentPage() const;
    void setCurrentPage(const QString &key);
    /// Makes it the current one as soon as it is offered, unless another is chosen before. False if there is
    /// no such page.
    bool awaitPage(const QString &key);
    /// The page that is still awaited, and is no longer from now on. Empty if there is none.
    [[nodiscard]] QString takeAwaited();
    void setMarked(const QString &key, bool marked);
    /// A page that the board shown has no use for is not listed.
    void setOffered(const QString &key, bool offered);
    [[nodiscard]] bool isOffered(const QString &key) const;
    [[nodiscard]] QString titleOf(const QString &key) const;
    [[nodiscard]] QStringList offeredTitles() const;
    /// The page that is offered under the title of this one, which another family has. Empty if there is
    /// none.
    [[nodiscard]] QString offeredInPlaceOf(const QString &key) const;
    /// The page that Ctrl and this number (from 1) show: they count what is listed. Empty if there is none.
    [[nodiscard]] QString pageOfNumber(int number) const;

signals:
    void pageChosen(const QString &key);

private:
    void renumber();
    [[nodiscard]] QListWidgetItem *itemOf(const QString &key) const;

    QString m_awaited;
};
