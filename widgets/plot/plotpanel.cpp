// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/plot/plotpanel.h"

#include "widgets/models/channelmodel.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"
#include "widgets/theme/tablelook.h"

#include <QHeaderView>
#include <QMenu>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

constexpr int kMaxRows = 6;  // of figures; more scroll
enum Column { Name, Mean, Rms, PeakToPeak, Rate, ColumnCount };

}  // namespace

PlotPanel::PlotPanel(const Theme &theme, QWidget *parent)
    : QWidget(parent)
    , m_view(new PlotView(theme))
    , m_button(new QToolButton(m_view))
    , m_menu(new QMenu(this))
    , m_figures(new QTableWidget(0, ColumnCount))
{
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_view, 1);
    layout->addWidget(m_figures);
    m_button->setText(u"⋯"_s);
    m_button->setToolTip(tr("What this plot shows and how"));
    m_button->setAccessibleName(tr("Plot menu"));
    m_button->setMenu(m_menu);
    m_button->setPopupMode(QToolButton::InstantPopup);
    m_button->setAutoRaise(true);
    m_button->setObjectName(u"plotMenu"_s);
    m_button->move(8, 4);
    m_view->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_view, &QWidget::customContextMenuRequested, this,
            [this](const QPoint &at) { m_menu->popup(m_view->mapToGlobal(at)); });
    connect(m_menu, &QMenu::aboutToShow, this, &PlotPanel::fillMenu);

    m_figures->setHorizontalHeaderLabels(
        {tr("Channel"), tr("Mean"), tr("RMS"), tr("Peak to peak"), tr("Samples/s")});
    m_figures->setAccessibleName(tr("Figures of the visible span"));
    setPlainRows(*m_figures);
    m_figures->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_figures->setSelectionMode(QAbstractItemView::NoSelection);
    m_figures->horizontalHeader()->setHighlightSections(false);
    m_figures->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_figures->horizontalHeader()->setSectionResizeMode(Name, QHeaderView::ResizeToContents);
    m_figures->setIconSize({10, 10});
    m_figures->hide();
}

void PlotPanel::setChannels(ChannelTable table, const QList<int> &channels,
                            std::shared_ptr<const TelemetryStore> store)
{
    m_table = table;
    m_channels = channels;
    m_view->setChannels(table, channels, store);
    m_meters.clear();
    m_figures->setRowCount(int(channels.size()));
    for (qsizetype i = 0; i < channels.size(); ++i) {
        m_meters.emplace_back(store, channels[i], -1);
        for (int column = 0; column < ColumnCount; ++column) {
            auto *item = new QTableWidgetItem;
            item->setTextAlignment(column == Name ? Qt::AlignLeft | Qt::AlignVCenter
                                                  : Qt::AlignRight | Qt::AlignVCenter);
            m_figures->setItem(int(i), column, item);
        }
        m_figures->item(int(i), Name)->setText(m_view->curveName(i));
    }
    for (int column = 0; column < ColumnCount; ++column) {
        m_figures->horizontalHeaderItem(column)->setTextAlignment(
            column == Name ? Qt::AlignLeft | Qt::AlignVCenter : Qt::AlignRight | Qt::AlignVCenter);
    }
    setFiguresVisible(figuresVisible());
    refreshFigures();
}

void PlotPanel::setFiguresVisible(bool visible)
{
    m_figures->setVisible(visible && !m_channels.isEmpty());
    m_figures->ensurePolished();
    const int row = m_figures->verticalHeader()->defaultSectionSize();
    const int rows = std::min<int>(kMaxRows, m_figures->rowCount());
    m_figures->setFixedHeight(m_figures->horizontalHeader()->sizeHint().height() + rows * row + 4);
    refreshFigures();
}

bool PlotPanel::figuresVisible() const
{
    return !m_figures->isHidden();
}

void PlotPanel::refreshFigures()
{
    if (!figuresVisible())
        return;
    for (std::size_t i = 0; i < m_meters.size(); ++i) {
        const SpanMeter::Figures figures = m_meters[i].measure(m_view->startTime(), m_view->endTime());
        const ChannelSpec &spec = m_table[std::size_t(m_channels[qsizetype(i)])];
        const auto text = [&](double value) {
            return figures.samples == 0
                ? u"–"_s
                : u"%1 %2"_s.arg(numberText(value, spec.decimals + 1), QString::fromUtf8(spec.unit))
                      .trimmed();
        };
        const int row = int(i);
        m_figures->item(row, Mean)->setText(text(figures.mean));
        m_figures->item(row, Rms)->setText(text(figures.rms));
        m_figures->item(row, PeakToPeak)->setText(text(figures.high - figures.low));
        m_figures->item(row, Rate)->setText(figures.rate > 0 ? numberText(figures.rate, 0) : u"–"_s);
        m_figures->item(row, Name)->setData(Qt::DecorationRole, m_view->curveColor(qsizetype(i)));
    }
}

void PlotPanel::fillMenu()
{
    m_menu->clear();
    const auto check = [this](const QString &text, bool on, auto &&toggled) {
        QAction *action = m_menu->addAction(text);
        action->setCheckable(true);
        action->setChecked(on);
        connect(action, &QAction::toggled, this, toggled);
    };
    check(tr("Show figures"), figuresVisible(), [this](bool on) {
        setFiguresVisible(on);
        emit changed();
    });
    check(tr("Each channel on a scale of its own"), m_view->hasOwnScales(), [this](bool on) {
        m_view->setOwnScales(on);
        emit changed();
    });
    m_menu->addAction(tr("Fit the scales (A)"), m_view, &PlotView::autoScale);
    m_menu->addAction(m_view->referenceTime() ? tr("Remove the reference line (R)")
                                              : tr("Reference line at the cursor (R)"),
                      this, [this] {
                          const double middle = (m_view->startTime() + m_view->endTime()) / 2;
                          emit m_view->referenceMoved(
                              m_view->referenceTime() ? std::nullopt
                                                      : std::optional(m_view->cursorTime().value_or(middle)));
                      });
    m_menu->addSeparator();
    for (qsizetype i = 0; i < m_channels.size(); ++i) {
        m_menu->addAction(tr("Remove “%1”").arg(m_view->curveName(i)), this,
                          [this, channel = m_channels[i]] { emit removeChannelRequested(channel); });
    }
    m_menu->addAction(tr("Remove this plot"), this, &PlotPanel::removeRequested);
}
