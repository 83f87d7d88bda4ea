// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/workspace.h"
#include "widgets/views/card.h"

#include <QListWidget>

class QBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;

/// What the calibration and setup wizards share.

/// How a sensor lies, as setPosition() of SensorCube counts: 0-5 are Z, -Z, X, -X, Y, -Y up, all else is
/// tilted.
inline constexpr int kSensorFaces = 6;
[[nodiscard]] QString faceName(int face);

/// The instruction of a step: larger, wrapped.
void setHeadline(QLabel &label);
/// A progress bar that the text beside it explains; 0 to 100.
void setQuiet(QProgressBar &bar, const QString &accessibleName);

/// A card with the picture of a lying sensor, what the method is for and its button, added to the row.
QPushButton *addMethod(QBoxLayout &row, const Theme &theme, const QString &title, const QString &text,
                       const QString &button, int face);

/// The six faces, with marks at those that are done.
class FaceList final : public QListWidget
{
    Q_OBJECT
public:
    explicit FaceList(QWidget *parent = nullptr);
    /// @param done bit by face
    void setDone(unsigned done);
};

/// Places a simulated camera by hand; hidden with a real board.
class SimulatedHands final : public Card
{
    Q_OBJECT
public:
    /// A place's name and the number that the simulator has for it.
    using Places = QList<std::pair<QString, int>>;

    /// @param title by default that of a gimbal
    SimulatedHands(Workspace &workspace, const Places &places, QWidget *parent, const QString &title = {});
    /// Other hands: what they do is added.
    SimulatedHands(Workspace &workspace, QWidget *parent);
    /// A choice of its own. @param what of the world it changes, as gimbalsim has it; @param now which of
    /// them it is as long as nobody changes it; -1: that is not known
    void add(const QString &what, const QString &accessibleName, const Places &places, int now = 0);
    /// In the gimbal, and still on each face.
    [[nodiscard]] static Places faces();
    /// The camera in the gimbal, in the operator's hand.
    [[nodiscard]] static Places::value_type inGimbal();
    /// Puts the camera back into the gimbal.
    void putBack();

private:
    Workspace &m_workspace;
};
