// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/workspace.h"

#include <QFrame>

class QLabel;

/// The room at the foot of the window for what is not stored and what is not written. Kept while values are
/// shown, so that no page moves when one of the two bars comes or goes; the other one may, and takes no
/// clicks then.
class FootBar final : public QFrame
{
    Q_OBJECT
public:
    /// @param bars come side by side
    FootBar(Workspace &workspace, const QList<QWidget *> &bars, QWidget *parent = nullptr);

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;
    bool eventFilter(QObject *watched, QEvent *event) override;

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    QList<QWidget *> m_bars;
    QLabel *m_calm;  // lies beneath the bars
};
