// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/theme/theme.h"

#include <QVariantMap>
#include <QWidget>

#include <map>

class QGridLayout;
class QLabel;
class StickBar;

/// What comes in at the inputs of a remote control, a bar for each; the one that moves stands out.
class InputBars final : public QWidget
{
    Q_OBJECT
public:
    explicit InputBars(const Theme &theme, QWidget *parent = nullptr);
    /// @param percents by the input's name in the board's tables; what has no signal is not in it
    void setValues(const QMap<QString, double> &percents);
    /// The same from a reply with "input.NAME".
    void setInputs(const QVariantMap &reply);
    /// In percent; NaN: nothing comes in there.
    [[nodiscard]] double value(const QString &name) const;
    [[nodiscard]] bool isMoving(const QString &name) const;

private:
    struct Row
    {
        QLabel *name;
        StickBar *bar;
        QLabel *percent;
        double slow = 0;
    };
    void makeRows(const QStringList &names);

    const Theme &m_theme;
    QGridLayout *m_grid;
    QLabel *m_nothing;
    std::map<QString, Row> m_rows;
};
