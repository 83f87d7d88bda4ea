// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/views/diffview.h"

#include <Qsci/qscistyle.h>

using namespace Qt::StringLiterals;

namespace {

constexpr int kAddedMarker = 4;
constexpr int kRemovedMarker = 5;
constexpr int kPlaceMargin = 0;
constexpr int kTint = 55;  // of 255

}  // namespace

DiffView::DiffView(Theme &theme, QWidget *parent)
    : CodeEditor(theme, parent)
{
    setReadOnly(true);
    markerDefine(Background, kAddedMarker);
    markerDefine(Background, kRemovedMarker);
    followTheme();
    setMarginType(kPlaceMargin, TextMarginRightJustified);
    connect(&theme, &Theme::changed, this, [this] { setLines(std::vector(m_lines)); });
    colorMarks();
}

void DiffView::colorMarks()
{
    const auto tint = [this](ColorRole role, int marker) {
        QColor color = theme().color(role);
        color.setAlpha(kTint);
        setMarkerBackgroundColor(color, marker);
    };
    tint(ColorRole::Ok, kAddedMarker);
    tint(ColorRole::Danger, kRemovedMarker);
}

void DiffView::setLines(const std::vector<DiffLine> &lines)
{
    m_lines = lines;
    colorMarks();
    QStringList texts;
    for (const DiffLine &line : m_lines) {
        switch (line.kind) {
        case DiffLine::Kind::Same: texts.append(u"  "_s + line.text); break;
        case DiffLine::Kind::Added: texts.append(u"+ "_s + line.text); break;
        case DiffLine::Kind::Removed: texts.append(u"− "_s + line.text); break;
        case DiffLine::Kind::Gap:
            texts.append(tr("⋯ %n line(s) without a difference", nullptr, line.left));
            break;
        }
    }
    markerDeleteAll();
    setBytes(texts.join(u'\n').toUtf8());
    const QsciStyle places(-1, u"places"_s, theme().color(ColorRole::Muted),
                           theme().color(ColorRole::Background), font());
    for (int i = 0; i < int(m_lines.size()); ++i) {
        const DiffLine &line = m_lines[std::size_t(i)];
        const int number = line.kind == DiffLine::Kind::Removed ? line.before : line.after;
        setMarginText(i, number > 0 ? QString::number(number) : QString(), places);
        if (line.kind == DiffLine::Kind::Added)
            markerAdd(i, kAddedMarker);
        else if (line.kind == DiffLine::Kind::Removed)
            markerAdd(i, kRemovedMarker);
    }
}

int DiffView::lineThere() const
{
    int row = 0;
    int column = 0;
    getCursorPosition(&row, &column);
    for (std::size_t i = std::size_t(std::max(0, row)); i < m_lines.size(); ++i) {
        if (m_lines[i].after > 0)
            return m_lines[i].after;
    }
    return 0;
}
