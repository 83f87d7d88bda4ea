// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/forms/filterrows.h"

#include "widgets/forms/editstack.h"
#include "widgets/forms/valueeditor.h"
#include "widgets/models/configurationmodel.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"
#include "widgets/theme/theme.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr double kFromHz = 5;
constexpr double kToHz = 500;
constexpr double kFloorDb = -40;
constexpr double kCeilingDb = 10;
constexpr int kCurveWidth = 96;
constexpr int kCurveHeight = 30;

}  // namespace

FilterCurve::FilterCurve(QWidget *parent)
    : QWidget(parent)
{
    setFixedSize(kCurveWidth, kCurveHeight);
}

void FilterCurve::show(const NotchShape &shape, bool inUse)
{
    m_shape = shape;
    m_inUse = inUse;
    const QString text = inUse ? tr("Takes out %1 dB at %2 Hz; drawn from %3 to %4 Hz")
                                     .arg(numberText(shape.depthDb, 0), shortNumberText(shape.hz),
                                          shortNumberText(kFromHz), shortNumberText(kToHz))
                               : tr("Not in use");
    setToolTip(text);
    setAccessibleName(text);
    update();
}

void FilterCurve::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF area = QRectF(rect()).adjusted(1, 1, -1, -1);
    const auto y = [&area](double db) {
        return area.top()
            + area.height() * (kCeilingDb - std::clamp(db, kFloorDb, kCeilingDb)) / (kCeilingDb - kFloorDb);
    };
    painter.setPen(QPen(palette().color(QPalette::Mid), 1));
    painter.drawLine(QPointF(area.left(), y(0)), QPointF(area.right(), y(0)));
    QPainterPath path;
    for (double x = area.left(); x <= area.right(); x += 0.5) {
        const double hz = kFromHz * std::pow(kToHz / kFromHz, (x - area.left()) / area.width());
        const double db = m_inUse ? 20.0 * std::log10(std::abs(notchResponse(m_shape, hz))) : 0.0;
        if (path.elementCount() == 0)
            path.moveTo(x, y(db));
        else
            path.lineTo(x, y(db));
    }
    if (m_inUse)
        painter.setPen(QPen(palette().color(QPalette::Highlight), 1.5));
    painter.drawPath(path);
}

FilterRows::FilterRows(const ConfigurationModel &configuration, EditStack &edits,
                       const std::vector<NotchFilter> &filters,
                       const std::function<ValueEditor *(int)> &makeEditor, QWidget *parent)
    : QWidget(parent)
    , m_configuration(configuration)
    , m_edits(edits)
{
    const ParameterSet &set = configuration.edited().parameters();
    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(Metric::kGap);
    grid->setVerticalSpacing(Metric::kUnit);
    const QStringList heads{tr("In use"), tr("Frequency, Hz"), tr("Width, Hz"), tr("Depth, dB")};
    for (int column = 0; column < heads.size(); ++column) {
        auto *head = new QLabel(heads[column]);
        head->setObjectName(u"muted"_s);
        grid->addWidget(head, 0, column);
        grid->setColumnStretch(column, column == 0 ? 0 : 1);
    }
    for (const NotchFilter &filter : filters) {
        Row row;
        row.frequency = set.find(filter.frequency)->id;
        row.width = set.find(filter.width)->id;
        row.depth = set.find(filter.depth)->id;
        row.enabled = set.find(filter.enabled)->id;
        row.bit = filter.bit;
        const int line = grid->rowCount();
        row.use = new QCheckBox(
            tr("%1, notch %2").arg(axisLabel(set.at(row.frequency).axis)).arg(filter.bit + 1));
        row.use->setToolTip(tr("Use this filter"));
        row.use->setEnabled(configuration.board().identity().writable);
        row.curve = new FilterCurve;
        grid->addWidget(row.use, line, 0);
        int column = 1;
        for (const int parameter : {row.frequency, row.width, row.depth})
            grid->addWidget(makeEditor(parameter), line, column++, Qt::AlignVCenter);
        grid->addWidget(row.curve, line, column, Qt::AlignVCenter);
        connect(row.use, &QCheckBox::clicked, this, [this, row](bool on) { use(row, on); });
        m_rows.push_back(row);
    }
    setMaximumWidth(2 * Metric::kFieldWidth);
}

double FilterRows::value(int parameter) const
{
    const ParameterSpec &spec = m_configuration.edited().parameters().at(parameter);
    const auto raw = m_configuration.value(spec, m_configuration.shownProfile());
    return raw ? spec.toDisplay(*raw) : 0.0;
}

bool FilterRows::isInUse(const Row &row) const
{
    const ParameterSpec &spec = m_configuration.edited().parameters().at(row.enabled);
    const auto bits = m_configuration.value(spec, m_configuration.shownProfile());
    return bits && flagBits(*bits) & (1U << row.bit);
}

void FilterRows::use(const Row &row, bool on)
{
    const ParameterSpec &spec = m_configuration.edited().parameters().at(row.enabled);
    if (const auto bits = m_configuration.value(spec, m_configuration.shownProfile())) {
        const unsigned bit = 1U << row.bit;
        m_edits.edit(row.enabled, m_configuration.shownProfile(),
                     on ? flagBits(*bits) | bit : flagBits(*bits) & ~bit);
    }
    refresh();
}

void FilterRows::refresh()
{
    for (const Row &row : m_rows) {
        row.use->setChecked(isInUse(row));
        row.curve->show({value(row.frequency), value(row.width), value(row.depth)}, isInUse(row));
    }
}

bool FilterRows::concerns(int parameter) const
{
    return std::any_of(m_rows.begin(), m_rows.end(), [parameter](const Row &row) {
        return parameter == row.frequency || parameter == row.width || parameter == row.depth
            || parameter == row.enabled;
    });
}

QString FilterRows::inactiveReason(int parameter) const
{
    for (const Row &row : m_rows) {
        if (parameter == row.frequency || parameter == row.width || parameter == row.depth)
            return isInUse(row) ? QString() : tr("No effect while this filter is not in use.");
    }
    return {};
}
