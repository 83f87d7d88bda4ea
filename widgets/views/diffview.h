// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/linediff.h"
#include "widgets/views/codeeditor.h"

/// The difference of two texts, line by line: what was added and removed in colours and signs, each with its
/// number in the text that has it. It can be selected and copied, not changed.
class DiffView final : public CodeEditor
{
    Q_OBJECT
public:
    explicit DiffView(Theme &theme, QWidget *parent = nullptr);

    /// @param lines with gaps where lines are left out
    void setLines(const std::vector<DiffLine> &lines);
    /// Number in the second text of the line at the cursor, or of the next one that it has; 0: none.
    [[nodiscard]] int lineThere() const;

private:
    void colorMarks();

    std::vector<DiffLine> m_lines;
};
