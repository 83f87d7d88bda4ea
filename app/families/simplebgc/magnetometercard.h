// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/workspace.h"
#include "protocol/analysis/fieldsphere.h"
#include "widgets/views/card.h"

#include <QTimer>

#include <vector>

class FieldSphereView;
class QLabel;
class QPushButton;

/// The magnetometer's calibration: its points are drawn while the camera is turned, before it as well, to
/// see what iron does.
class MagnetometerCard final : public Card
{
    Q_OBJECT
public:
    enum class Step { Ready, Turning, Result };

    explicit MagnetometerCard(Workspace &workspace, QWidget *parent = nullptr);

    void begin();
    [[nodiscard]] Step step() const { return m_step; }
    [[nodiscard]] QPushButton *goButton() const { return m_go; }
    [[nodiscard]] QPushButton *backButton() const { return m_back; }
    [[nodiscard]] QPushButton *cancelButton() const { return m_cancel; }
    [[nodiscard]] const SeenDirections &seen() const { return m_seen; }
    [[nodiscard]] const std::optional<FieldSphere> &sphere() const { return m_sphere; }
    /// What it tells below the sphere.
    [[nodiscard]] QString sees() const;

signals:
    void left();

protected:
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    /// Of points that were turned.
    struct Figures
    {
        std::optional<FieldSphere> sphere;
        std::optional<double> stretch;
        std::optional<double> heading;  // degrees
        std::size_t directions = 0;
    };
    void makeBody();
    void setStep(Step step);
    void look();
    void collect();
    void forgetPoints();
    void calibrate();
    void onProgress(const Progress &progress);
    void onDone(const Result<ActionOutcome> &outcome);
    void showFigures(const std::optional<Figures> &before, const Figures &now);
    [[nodiscard]] Figures figures() const;
    [[nodiscard]] QString verdict(const Figures &now) const;
    [[nodiscard]] bool hasVectors() const;
    [[nodiscard]] QString seenText() const;

    Workspace &m_workspace;
    Step m_step = Step::Ready;
    bool m_isAsked = false;  // to calibrate, and has not ended
    std::vector<Vector3> m_points;
    double m_since = 0;  // of the newest row taken, in seconds of the store
    std::optional<FieldSphere> m_sphere;
    SeenDirections m_seen;
    std::optional<Figures> m_before;
    QLabel *m_what;
    QLabel *m_sees;
    QLabel *m_figures;
    FieldSphereView *m_view;
    QPushButton *m_back;
    QPushButton *m_cancel;
    QPushButton *m_go;
    QTimer m_timer;
};
