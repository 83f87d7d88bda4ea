// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointer>
#include <QWidget>

#include <vector>

/// The room of the page, with messages and questions floating over its upper edge: nothing of the page moves
/// when one comes or goes. They come at the lower edge instead where the pointer or the keyboard is at the
/// upper one, and go out of the keyboard's way later; one that closes moves none of the others. Ctrl+F6 goes
/// to the newest and back, Esc closes it.
class BannerArea final : public QWidget
{
    Q_OBJECT
public:
    /// @param page takes all the room
    explicit BannerArea(QWidget &page, QWidget *parent = nullptr);
    ~BannerArea() override;

    enum class Closing { ByEsc, Never };
    /// Lets this float; whoever has it shows and hides it.
    void add(QWidget &banner, Closing closing);

    bool eventFilter(QObject *watched, QEvent *event) override;

protected:
    void resizeEvent(QResizeEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    struct Banner
    {
        QWidget *widget = nullptr;
        Closing closing = Closing::Never;
        int offset = 0;  // from the edge
    };
    void appear(QWidget *widget);
    void place();
    void jump();
    void followFocus(QWidget *before, QWidget *now);
    [[nodiscard]] bool holds(const QWidget *widget) const;
    /// What the banners that are shown need at that edge.
    [[nodiscard]] QRect room(bool lower) const;
    [[nodiscard]] bool isInUse(const QRect &room) const;
    [[nodiscard]] bool isPointerIn(const QRect &room) const;
    [[nodiscard]] int heightOf(const QWidget &widget) const;

    std::vector<Banner> m_banners;
    std::vector<Banner> m_shown;  // the newest last
    QPointer<QWidget> m_before;  // had the keyboard before a banner
    bool m_lower = false;
};
