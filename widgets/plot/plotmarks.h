// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <optional>
#include <span>
#include <vector>

/// Something that happened, drawn as a line in the plots.
struct PlotMark
{
    enum class Kind { Note, Change, Fault };
    double time = 0;  ///< seconds since the store's origin
    Kind kind = Kind::Note;
    QString text;
};

/// Events during data acquisition, in order of time.
class PlotMarks final : public QObject
{
    Q_OBJECT
public:
    using QObject::QObject;

    void add(PlotMark mark);
    void clear();
    [[nodiscard]] const std::vector<PlotMark> &all() const { return m_marks; }
    [[nodiscard]] std::span<const PlotMark> between(double from, double to) const;
    /// The mark nearest to a time, if it is not further away than that.
    [[nodiscard]] const PlotMark *near(double time, double within) const;
    /// The next one after (or the last one before) a time.
    [[nodiscard]] std::optional<double> next(double time, bool forward) const;

signals:
    void changed();

private:
    std::vector<PlotMark> m_marks;
};
