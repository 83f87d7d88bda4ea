// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/motorlayout.h"
#include "widgets/theme/theme.h"

#include <QList>
#include <QWidget>

#include <vector>

/// The motors of a flying machine, each at the place that the board's mixing gives it: its number, how much
/// it is driven, and the group of those that turn the same way. Where nobody knows the places, numbered bars.
/// The signs of the axes are the board's own: which of them is the front, or clockwise, is not told, unless
/// somebody has looked.
class MotorDiagram final : public QWidget
{
    Q_OBJECT
public:
    explicit MotorDiagram(const Theme &theme, QWidget *parent = nullptr);

    /// @param shares one for each motor, else they are not used
    void setMotors(int count, const std::vector<MotorShare> &shares);
    [[nodiscard]] int count() const { return int(m_outputs.size()); }
    [[nodiscard]] bool hasPlaces() const { return !m_shares.empty(); }
    /// Somebody has looked where the motors are: the picture's upper edge is the front, its right side the
    /// right.
    void setSidesKnown(bool known);
    [[nodiscard]] bool areSidesKnown() const { return m_areSidesKnown; }
    /// Percent, in the order of the motors; NaN = not known.
    void setOutputs(const std::vector<double> &outputs);
    /// The motor that a test turns now, from 1; 0 = none.
    void setTested(int motor);
    /// The motors, from 1, that a question is about.
    void setAsked(const QList<int> &motors);
    [[nodiscard]] const QList<int> &asked() const { return m_asked; }
    /// One of them can be chosen, by a click or with the arrow keys.
    void setSelectable(bool selectable);
    void setSelected(int motor);
    /// From 1; 0 = none.
    [[nodiscard]] int selected() const { return m_selected; }
    /// "12 %", "stands", "–".
    [[nodiscard]] QString outputText(int motor) const;
    /// Where a motor is drawn, for a click.
    [[nodiscard]] QPointF placeOf(int motor) const;
    [[nodiscard]] QSize sizeHint() const override { return {300, 280}; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {180, 170}; }

signals:
    void selectedChanged(int motor);

protected:
    void paintEvent(QPaintEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    void tell();
    void explain();
    [[nodiscard]] int motorAt(QPointF point) const;
    [[nodiscard]] QRectF area() const;
    [[nodiscard]] double radius() const;
    [[nodiscard]] QRectF barOf(int motor) const;
    [[nodiscard]] double output(int motor) const { return m_outputs[std::size_t(motor - 1)]; }
    [[nodiscard]] QColor colourOf(int motor) const;
    /// Of the line around it; invalid: it is not marked.
    [[nodiscard]] QColor markOf(int motor) const;
    void choose(int motor);
    void drawFrame(QPainter &painter) const;
    void drawMotor(QPainter &painter, int motor) const;
    void drawTurn(QPainter &painter, QPointF centre, double size, bool positive) const;
    void drawBar(QPainter &painter, int motor) const;

    const Theme &m_theme;
    std::vector<MotorShare> m_shares;
    std::vector<QPointF> m_places;  // -1 to 1, right and down
    std::vector<double> m_outputs;
    int m_tested = 0;
    QList<int> m_asked;
    int m_selected = 0;
    bool m_selectable = false;
    bool m_areSidesKnown = false;
};
