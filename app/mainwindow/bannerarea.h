// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QWidget>

#include <functional>
#include <vector>

class QStackedWidget;

/// The room of the page, with messages and questions floating over its upper edge, or over its lower one
/// where less is hidden there: headings, what acts, motors, what tells whether a drone is armed, pointer and
/// keyboard.
/// Where motors would be hidden at either, the page gets lower for them, unless it cannot. They go out of
/// the keyboard's way later; one that closes moves none of the others. Ctrl+F6 goes to the newest and back,
/// Esc closes it.
class BannerArea final : public QWidget
{
    Q_OBJECT
public:
    /// @param pages take all the room; the title of the one shown and the controls beside it stay in sight
    explicit BannerArea(QStackedWidget &pages, QWidget *parent = nullptr);
    ~BannerArea() override;

    /// Lets this float; whoever has it shows and hides it. @param close what Esc does; nothing without it
    void add(QWidget &banner, std::function<void()> close = {});
    /// What lies over an edge while it is shown: banners keep off it.
    void giveWayTo(QWidget &cover);
    /// Where, seen from an ancestor, something as wide as this area hides least: beneath the row that holds
    /// the title of the page and the controls beside it, or at the lower edge.
    [[nodiscard]] QPoint freePlace(const QWidget &ancestor,
                                   const std::function<int(int width)> &heightFor) const;

    bool eventFilter(QObject *watched, QEvent *event) override;

protected:
    void resizeEvent(QResizeEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    struct Banner
    {
        QWidget *widget = nullptr;
        std::function<void()> close;
        int offset = 0;  // from the edge
    };
    void appear(QWidget *widget);
    void place();
    void findPlace();
    void lookAgain();
    void makeRoom();
    void jump();
    /// Goes to the other edge where there is room that hides less, but never from under the pointer.
    void uncoverState();
    void followFocus(QWidget *before, QWidget *now);
    [[nodiscard]] bool holds(const QWidget *widget) const;
    /// What the banners that are shown need at that edge.
    [[nodiscard]] QRect room(bool lower) const;
    [[nodiscard]] bool isInUse(const QRect &room) const;
    [[nodiscard]] bool hidesState(const QRect &room) const;
    [[nodiscard]] QRect shownPart(const QWidget &widget) const;
    /// What would be hidden there, by weight; 0: nothing of importance.
    [[nodiscard]] int hidden(const QRect &room) const;
    [[nodiscard]] bool isPointerIn(const QRect &room) const;
    [[nodiscard]] int covered(bool lower) const;
    [[nodiscard]] int headEnd() const;
    /// A click that was meant for a banner which has just gone or moved reaches nothing.
    void shield(const QRect &place);
    [[nodiscard]] int heightOf(const QWidget &widget) const;

    QStackedWidget &m_pages;
    std::vector<Banner> m_banners;
    std::vector<Banner> m_shown;  // the newest last
    QPointer<QWidget> m_before;  // had the keyboard before a banner
    QPointer<QWidget> m_cover;
    bool m_lower = false;
    bool m_makesRoom = false;
};
