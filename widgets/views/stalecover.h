// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/theme/theme.h"

#include <QWidget>

#include <functional>

class QAbstractScrollArea;
class QHeaderView;

/// Lies over a view of live data once there are none, and says so: what is shown then is old, or means
/// nothing. Lets the mouse through.
class StaleCover final : public QWidget
{
    Q_OBJECT
public:
    enum class Look {
        Veil,  ///< fades the view and says why
        Fade,  ///< fades it: the words stand beside it
        Tag,  ///< leaves it as it is: what it shows is past anyway
    };
    /// @param view is covered, and owns the cover; no splitter, which would make room for it
    StaleCover(const Theme &theme, QWidget &view, Look look = Look::Veil);
    /// Fades only one column of a table. @param header is the table's
    StaleCover(const Theme &theme, QAbstractScrollArea &table, const QHeaderView &header, int column);

    /// What is wrong with the data; empty: they are live.
    void setText(const QString &text);
    [[nodiscard]] QString text() const { return m_text; }
    /// Words stand over the middle of this view: it draws none there itself.
    [[nodiscard]] static bool isOver(const QWidget &view);
    bool eventFilter(QObject *watched, QEvent *event) override;

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    void place();

    const Theme &m_theme;
    Look m_look;
    std::function<QRect()> m_area;  // of the view
    QString m_text;
};
