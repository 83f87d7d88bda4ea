// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/procedure/motiontest.h"

#include <QFormLayout>

class NumberBox;

/// How far, how often and how fast a test moves an axis.
class MovementForm final : public QFormLayout
{
    Q_OBJECT
public:
    MovementForm();

    /// Shows what this kind of test asks for; without one, only how much of the past is looked at.
    void showFor(std::optional<MotionTestPlan::Kind> kind);
    [[nodiscard]] MotionTestPlan plan(MotionTestPlan::Kind kind, Axis axis) const;
    [[nodiscard]] double degrees() const;
    [[nodiscard]] double seconds() const;

private:
    NumberBox *m_degrees;
    NumberBox *m_count;
    NumberBox *m_rest;
    NumberBox *m_from;
    NumberBox *m_to;
    NumberBox *m_seconds;
    NumberBox *m_limit;
};
