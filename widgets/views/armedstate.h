// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/theme/theme.h"

#include <QWidget>

#include <optional>

/// Whether a flying machine may turn its propellers, as one tile: a colour, a sign and a word that nobody
/// takes for another, with a sentence beneath.
class ArmedState final : public QWidget
{
    Q_OBJECT
public:
    enum class State {
        Unknown,  ///< nothing tells it, or what told it is old
        NotCalibrated,  ///< cannot be armed
        Calibrating,
        Disarmed,  ///< calibrated: can be armed
        OutputsUnknown,  ///< calibrated and disarmed, and nothing tells whether motors stand
        Awaited,  ///< armed or disarmed from here, and it has not said so yet
        RunsOn,  ///< not armed, and motors are driven all the same, or are about to be by a test
        Armed,
    };

    explicit ArmedState(const Theme &theme, QWidget *parent = nullptr);

    /// What these four say together; what is not known is empty.
    [[nodiscard]] static State stateOf(std::optional<bool> armed, std::optional<bool> calibrated,
                                       std::optional<bool> calibrating, std::optional<bool> outputs);
    void setState(State state);
    [[nodiscard]] State state() const { return m_state; }
    /// It says that it is not armed, as far as it tells anything.
    [[nodiscard]] static bool isDisarmed(State state);
    /// The word of the tile, and what it means.
    [[nodiscard]] QString word() const;
    [[nodiscard]] QString sentence() const;
    /// The word as it stands in a tile of this width.
    [[nodiscard]] QString shownWord(int width) const;

    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void tell();
    [[nodiscard]] QFont wordFont() const;
    /// Smaller where the word would not fit.
    [[nodiscard]] QFont wordFontIn(int room) const;
    [[nodiscard]] int roomIn(int width) const;
    [[nodiscard]] bool isWarning() const
    {
        return m_state == State::Calibrating || m_state == State::OutputsUnknown || m_state == State::Awaited;
    }
    [[nodiscard]] bool isAlarm() const { return m_state == State::Armed || m_state == State::RunsOn; }
    void drawSign(QPainter &painter, const QRectF &room, const QColor &colour) const;

    const Theme &m_theme;
    State m_state = State::Unknown;
};
