// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/views/settingspicture.h"

#include "widgets/models/missingtext.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"

#include <QApplication>
#include <QDateTime>
#include <QPainter>

#include <algorithm>
#include <array>
#include <vector>

using namespace Qt::StringLiterals;

namespace {

constexpr int kColumns = 4;
constexpr int kColumnWidth = 400;
constexpr int kGutter = 24;
constexpr int kMargin = 24;

struct Cell
{
    QString text;
    bool differs = false;
};

/// One line: a name, and one value or one for each axis.
struct Line
{
    QString name;
    std::vector<Cell> cells;
    bool isHeading = false;
};

Cell cellOf(const ParameterSpec &spec, double raw)
{
    return {parameterQuantityText(spec, raw), !sameValue(raw, spec.defaultRaw)};
}

std::vector<Line> linesOf(const Configuration &configuration, int profile)
{
    std::vector<Line> lines;
    for (const char *group : configuration.parameters().groups()) {
        lines.push_back({tableText(group), {}, true});
        const ParameterRow *last = nullptr;
        int index = -1;
        for (const ParameterSpec &spec : configuration.parameters().all()) {
            const auto raw = configuration.raw(spec, profile);
            if (!raw || spec.row->state || qstrcmp(spec.row->group, group) != 0)
                continue;
            if (spec.row->axes > 1 && last == spec.row && index == spec.index) {
                lines.back().cells.push_back(cellOf(spec, *raw));
                continue;
            }
            lines.push_back({parameterLabel(spec, spec.row->axes < 2), {cellOf(spec, *raw)}, false});
            last = spec.row;
            index = spec.index;
        }
        if (lines.back().isHeading)
            lines.pop_back();
    }
    return lines;
}

}  // namespace

QImage settingsPicture(const Configuration &configuration, int profile, const Theme &theme, double scale,
                       const QString &note)
{
    const QFont plain = QApplication::font();
    QFont small = plain;
    small.setPointSizeF(plain.pointSizeF() - 1);
    QFont bold = small;
    bold.setWeight(QFont::Bold);
    QFont title = plain;
    title.setPointSizeF(plain.pointSizeF() + 4);
    title.setWeight(QFont::DemiBold);
    const std::vector<Line> lines = linesOf(configuration, profile);
    const int height = QFontMetrics(small).height() + 5;
    const int top = kMargin + QFontMetrics(title).height() + height + kGutter;
    const int perColumn = (int(lines.size()) + kColumns - 1) / kColumns + 1;
    const QSize size(2 * kMargin + kColumns * kColumnWidth + (kColumns - 1) * kGutter,
                     top + perColumn * height + kMargin);
    QImage image(size * scale, QImage::Format_RGB32);
    image.setDevicePixelRatio(scale);
    image.fill(theme.color(ColorRole::Surface));
    QPainter painter(&image);
    painter.setPen(theme.color(ColorRole::Text));
    painter.setFont(title);
    const BoardIdentity &identity = configuration.identity();
    QString head = u"%1 · %2"_s.arg(identity.model, identity.firmware);
    if (const QString name = identity.extra.value(u"name"_s).toString(); !name.isEmpty())
        head += u" · "_s + name;
    if (identity.profileCount > 1)
        head += u" · "_s + profileLabel(configuration, profile);
    painter.drawText(kMargin, kMargin + QFontMetrics(title).ascent(), head);
    painter.setFont(small);
    painter.setPen(theme.color(ColorRole::Muted));
    painter.drawText(
        kMargin, kMargin + QFontMetrics(title).height() + height,
        QCoreApplication::translate("SettingsPicture", "%1 · bold differs from the default · GimbalDesk")
                .arg(dateText(QDateTime::currentDateTime()))
            + (note.isEmpty() ? QString() : u" · "_s + note)
            + (configuration.missing().empty() ? QString()
                                               : u" · "_s
                       + QCoreApplication::translate("SettingsPicture", "not read: %1")
                             .arg(missingText(configuration, configuration.missing()))));
    int line = 0;
    int column = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const Line &each = lines[i];
        // No heading at the bottom of a column without its rows.
        if (line >= perColumn || (each.isHeading && line >= perColumn - 1)) {
            line = 0;
            ++column;
        }
        const QRect row(kMargin + column * (kColumnWidth + kGutter), top + line++ * height, kColumnWidth,
                        height);
        if (each.isHeading) {
            painter.setFont(bold);
            painter.setPen(theme.color(ColorRole::Accent));
            painter.drawText(row, Qt::AlignLeft | Qt::AlignVCenter, each.name);
            painter.setPen(theme.color(ColorRole::Border));
            painter.drawLine(row.bottomLeft(), row.bottomRight());
            continue;
        }
        const int cells = int(each.cells.size());
        const int width = cells > 1 ? 74 : 190;
        painter.setFont(small);
        painter.setPen(theme.color(ColorRole::Muted));
        const QRect nameRect = row.adjusted(0, 0, -cells * width - Metric::kGap, 0);
        painter.drawText(nameRect, Qt::AlignLeft | Qt::AlignVCenter,
                         QFontMetrics(small).elidedText(each.name, Qt::ElideRight, nameRect.width()));
        painter.setPen(theme.color(ColorRole::Text));
        for (int cell = 0; cell < cells; ++cell) {
            const QRect rect(row.right() - (cells - cell) * width, row.top(), width, height);
            painter.setFont(each.cells[std::size_t(cell)].differs ? bold : small);
            painter.drawText(
                rect, Qt::AlignRight | Qt::AlignVCenter,
                painter.fontMetrics().elidedText(each.cells[std::size_t(cell)].text, Qt::ElideRight, width));
        }
    }
    return image;
}
