// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/tune/tuningpage.h"

#include "app/pages/tune/gaincard.h"
#include "app/workspace/signsnote.h"
#include "protocol/client/whendone.h"
#include "widgets/forms/liveslider.h"
#include "widgets/forms/numberbox.h"
#include "widgets/forms/valueeditor.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"
#include "widgets/plot/plotview.h"
#include "widgets/plot/spanstatistics.h"
#include "widgets/views/card.h"

#include <QButtonGroup>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QShortcut>
#include <QSlider>
#include <QSplitter>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kFigurePeriod = 250ms;
constexpr double kFigureSpan = 3.0;  // seconds that the figures look back
constexpr double kPlotWindow = 10.0;
constexpr int kControlsWidth = 404;
constexpr int kMaxControlsWidth = 520;
constexpr int kLabelWidth = 84;
constexpr int kMaxLabelWidth = 112;  // a longer word stands above its fields

QPushButton *makeButton(const QString &text, const QString &tip)
{
    auto *button = new QPushButton(text);
    button->setToolTip(tip);
    return button;
}

// As many digits however large the angle is: a column never grows under what stands beside it.
QString figure(double value)
{
    const int decimals = value < 9.9995 ? 3 : value < 99.995 ? 2 : 1;
    return std::isnan(value) ? u"–"_s : u"%1°"_s.arg(numberText(value, decimals));
}

// The slider beneath the field is no part of its line.
void standOnLineOf(const LiveSlider &control, QLabel &label)
{
    const QWidget *field = control.editor()->control();
    field->ensurePolished();
    const int drop = (field->sizeHint().height() - label.fontMetrics().height()) / 2;
    label.setContentsMargins(0, std::max(0, drop), 0, 0);
    label.setAlignment(Qt::AlignLeft | Qt::AlignTop);  // its first line
}

QString percentText(double change)
{
    if (std::isnan(change))
        return u"–"_s;
    const QString amount = std::abs(change) > 999 ? u">999"_s : numberText(std::abs(change), 0);
    return (change < 0 ? u"▼ "_s : u"▲ "_s) + u"%1 %"_s.arg(amount);
}

}  // namespace

TuningPage::TuningPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"tuning"_s, tr("Tuning"), parent)
    , m_live(workspace.live())
    , m_scroll(new QScrollArea)
    , m_a(makeButton(tr("Set A"), tr("Use the first set of values (F6 switches)")))
    , m_b(makeButton(tr("Set B"), tr("Use the second set of values (F6 switches)")))
    , m_copy(makeButton(tr("Copy to other"), tr("Make the other set the same as the values in use")))
    , m_revert(makeButton(tr("Revert all"),
                          tr("Put the values that were read from the board into use at once (F9)")))
    , m_save(makeButton(tr("Store"),
                        tr("Store the values in use in the active profile; a snapshot is taken first")))
    , m_state(new QLabel)
    , m_signs(new SignsNote(workspace))
    , m_compare(
          makeButton(tr("Compare with stored"), tr("Reads what is stored: the board uses it for a moment")))
{
    makeHeader();
    makeBody();
    connectAll();
    rebuild();
    onStore();
}

void TuningPage::makeHeader()
{
    auto *sets = new QButtonGroup(this);
    for (QPushButton *button : {m_a, m_b}) {
        button->setCheckable(true);
        sets->addButton(button);
    }
    m_revert->setObjectName(u"danger"_s);
    m_save->setObjectName(u"primary"_s);
    m_state->setObjectName(u"muted"_s);
    for (QPushButton *button : {m_a, m_b, m_copy, m_revert, m_save})
        header()->addWidget(button);
}

void TuningPage::makeBody()
{
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto *right = new QWidget;
    auto *rightLayout = new QVBoxLayout(right);
    rightLayout->setContentsMargins(0, 0, 0, 0);
    rightLayout->setSpacing(12);
    for (int i = 0; i < 2; ++i) {
        auto *plot = new PlotView(workspace().theme());
        plot->setMinimumHeight(90);
        plot->setWindow(kPlotWindow);
        plot->setAccessibleName(i == 0 ? tr("Angle error") : tr("Gyroscope"));
        rightLayout->addWidget(plot, 1);
        plot->setMarks(&workspace().marks());
        m_plots.append(plot);
        coverWhenStale(
            *plot,
            [this] {
                const ChannelRoles &roles = this->workspace().roles();
                return ChannelRoles::present({roles.angle, roles.gyro});
            },
            StaleCover::Look::Tag);
    }
    QWidget *figures = makeFigures();
    coverWhenStale(
        *figures,
        [this] {
            const ChannelRoles &roles = this->workspace().roles();
            return ChannelRoles::present({roles.angle});
        },
        StaleCover::Look::Fade);
    rightLayout->addWidget(figures);
    auto *split = new QHBoxLayout;
    split->setSpacing(12);
    split->addWidget(m_scroll);
    split->addWidget(right, 1);
    auto *state = new QHBoxLayout;
    state->setSpacing(Metric::kGap);
    m_state->setWordWrap(true);
    state->addWidget(m_state, 1);
    state->addWidget(m_compare);
    body()->addLayout(state);
    body()->addWidget(m_signs);
    body()->addLayout(split, 1);
    m_clock.setPlots(m_plots);
}

// The angle error in figures, now and before.
QWidget *TuningPage::makeFigures()
{
    auto *figures = new Card(tr("Angle error, last %1 s").arg(shortNumberText(kFigureSpan)));
    auto *grid = new QGridLayout;
    grid->setHorizontalSpacing(2 * Metric::kUnit);
    grid->setVerticalSpacing(Metric::kUnit);
    const QStringList heads{QString(),         tr("RMS"),          tr("Peak"),
                            tr("RMS\nbefore"), tr("Peak\nbefore"), tr("Change")};
    for (int column = 0; column < heads.size(); ++column) {
        auto *head = new QLabel(heads[column]);
        head->setObjectName(u"muted"_s);
        head->setAlignment((column == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignBottom);
        grid->addWidget(head, 0, column);
    }
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        auto *name = new QLabel(axisLabel(kAxes[axis]));
        grid->addWidget(name, int(axis) + 1, 0);
        for (std::size_t cell = 0; cell < m_cells[axis].size(); ++cell) {
            m_cells[axis][cell] = new QLabel;
            m_cells[axis][cell]->setAlignment(Qt::AlignRight);
            const QString widest = cell + 1 < m_cells[axis].size() ? figure(88.888) : percentText(1000);
            m_cells[axis][cell]->setMinimumWidth(fontMetrics().horizontalAdvance(widest));
            grid->addWidget(m_cells[axis][cell], int(axis) + 1, int(cell) + 1);
        }
    }
    auto *keep = makeButton(tr("Compare"),
                            tr("Compare what follows with these figures; switching sets does so too"));
    grid->setColumnStretch(0, 1);
    header()->insertWidget(header()->indexOf(m_a), keep);  // a row here would be the plots' loss
    figures->content()->addLayout(grid);
    connect(keep, &QPushButton::clicked, this, &TuningPage::keepFigures);
    return figures;
}

void TuningPage::connectAll()
{
    connect(m_a, &QPushButton::clicked, this, [this] {
        keepFigures();
        m_live.useSlot(LiveModel::Slot::A);
    });
    connect(m_b, &QPushButton::clicked, this, [this] {
        keepFigures();
        m_live.useSlot(LiveModel::Slot::B);
    });
    connect(m_copy, &QPushButton::clicked, &m_live, &LiveModel::copyToOther);
    connect(m_revert, &QPushButton::clicked, &m_live, &LiveModel::revert);
    connect(m_save, &QPushButton::clicked, this, &TuningPage::save);
    connect(m_compare, &QPushButton::clicked, this, &TuningPage::compare);
    connect(&workspace(), &Workspace::unstoredChanged, this, &TuningPage::updateState);
    new QShortcut(Qt::Key_F6, this, [this] { (m_live.slot() == LiveModel::Slot::A ? m_b : m_a)->click(); });
    new QShortcut(Qt::Key_F9, this, [this] { m_revert->click(); });
    connect(&m_live, &LiveModel::modelReset, this, &TuningPage::rebuild);
    connect(&m_live, &LiveModel::valueChanged, this, [this](int parameter) {
        if (LiveSlider *shown = m_controls.value(parameter))
            showValue(*shown, parameter);
    });
    connect(&m_live, &LiveModel::changeCountChanged, this, [this] {
        updateState();
        emit changesChanged();
    });
    connect(&m_live, &LiveModel::slotChanged, this, &TuningPage::updateState);
    connect(&m_live, &LiveModel::heldChanged, this, &TuningPage::updateState);
    connect(&m_live, &LiveModel::failed, this, [this](const Error &error) {
        if (isEndOfLink(error))
            return;
        ErrorText text = describe(error);
        if (m_live.isDoubted() && error.code == ErrorCode::Timeout)
            text.meaning = tr("What it uses is not known until it answers.");
        workspace().notifications().report(text);
    });
    connect(&workspace().client(), &DeviceClient::stateChanged, this, &TuningPage::onStore);
    m_figureTimer.setInterval(kFigurePeriod);
    connect(&m_figureTimer, &QTimer::timeout, this, &TuningPage::updateFigures);
}

QWidget *TuningPage::makeControls()
{
    auto *holder = new QWidget;
    auto *layout = new QVBoxLayout(holder);
    layout->setContentsMargins(0, 0, Metric::kGap, 0);
    layout->setSpacing(12);
    const int firmware = m_set->firmware();
    if (const Device *tables = workspace().tables(); tables && tables->gainShape()) {
        m_gains = new GainCard(m_live, tables->gainShape());
        m_gains->setParameters(m_set);
        layout->addWidget(m_gains);
    }
    QString group;
    QGridLayout *grid = nullptr;
    int row = -1;
    bool hasHeads = false;
    const ParameterRow *last = nullptr;
    QLabel *beside = nullptr;  // the label of a row whose first control follows
    for (const int parameter : m_live.parameters()) {
        const ParameterSpec &spec = m_set->at(parameter);
        if (group != QLatin1String(spec.row->group) || !grid) {
            group = QLatin1String(spec.row->group);
            auto *card = new Card(tableText(spec.row->group));
            grid = new QGridLayout;
            grid->setHorizontalSpacing(Metric::kGap);
            grid->setVerticalSpacing(Metric::kGap);
            grid->setColumnMinimumWidth(0, kLabelWidth);
            for (int column = 1; column <= 3; ++column)
                grid->setColumnStretch(column, 1);
            card->content()->addLayout(grid);
            layout->addWidget(card);
            row = 0;
            last = nullptr;
            hasHeads = false;
        }
        if (spec.axis != Axis::None && !std::exchange(hasHeads, true)) {
            ++row;
            for (int column = 1; column <= 3; ++column) {
                auto *head = new QLabel(axisLabel(kAxes[std::size_t(column - 1)]));
                head->setObjectName(u"muted"_s);
                grid->addWidget(head, row, column);
            }
        }
        if (last != spec.row) {
            ++row;
            last = spec.row;
            auto *label = new QLabel(parameterLabel(spec, false));
            label->setWordWrap(true);
            label->setToolTip(tableText(spec.row->help));
            label->ensurePolished();
            if (label->minimumSizeHint().width() > kMaxLabelWidth) {
                grid->addWidget(label, row++, 0, 1, 4);
            } else {
                grid->addWidget(label, row, 0, Qt::AlignTop);
                beside = label;
            }
        }
        auto *control = new LiveSlider(spec, m_live.range(parameter), firmware);
        const int column = spec.axis == Axis::None ? 1 : int(spec.axis) + 1;
        grid->addWidget(control, row, column, 1, spec.axis == Axis::None ? 3 : 1, Qt::AlignTop);
        if (QLabel *named = std::exchange(beside, nullptr))
            standOnLineOf(*control, *named);
        connect(control, &LiveSlider::edited, this, [this, control, parameter](double raw) {
            m_live.setValue(parameter, raw);
            showValue(*control, parameter);  // the result, limited to its range
        });
        m_controls.insert(parameter, control);
        showValue(*control, parameter);
    }
    if (m_live.parameters().isEmpty()) {
        auto *nothing = new QLabel(tr("This board has no values that can be changed live."));
        nothing->setWordWrap(true);
        nothing->setObjectName(u"muted"_s);
        layout->addWidget(nothing);
    }
    layout->addStretch(1);
    return holder;
}

void TuningPage::showValue(LiveSlider &control, int parameter) const
{
    const auto value = m_live.value(parameter);
    control.show(value, m_live.stored(parameter));
    const Configuration &board = std::as_const(workspace().configuration()).board();
    control.editor()->showFigure(board.textFigure(control.editor()->spec(), value.value_or(std::nan(""))));
}

void TuningPage::rebuild()
{
    const ConfigurationModel &model = workspace().configuration();
    const auto set = model.isEmpty() ? nullptr : model.board().parameterSet();
    if (set && set == m_set) {
        for (auto it = m_controls.begin(); it != m_controls.end(); ++it)
            showValue(*it.value(), it.key());
        updateState();
        return;
    }
    // What was typed and refused outlives the controls, on the same board.
    const QString serial = model.isEmpty() ? QString() : model.board().identity().serial;
    QMap<QString, QString> refused;
    for (const LiveSlider *control : std::as_const(m_controls)) {
        if (const auto text = control->editor()->refusedText(); text && serial == m_serial)
            refused.insert(control->editor()->spec().key, *text);
    }
    m_serial = serial;
    m_controls.clear();
    // The old controls refer to the old set, so they are removed first.
    delete m_scroll->takeWidget();
    m_gains = nullptr;
    m_set = set;
    if (m_set) {
        m_scroll->setWidget(makeControls());
        for (auto it = refused.begin(); it != refused.end(); ++it) {
            if (LiveSlider *again = control(it.key()))
                again->editor()->showRefused(it.value());
        }
        const int needed = m_scroll->widget()->minimumSizeHint().width()
            + m_scroll->verticalScrollBar()->sizeHint().width();
        m_scroll->setMinimumWidth(std::max(kControlsWidth, needed));
        m_scroll->setMaximumWidth(std::max(kMaxControlsWidth, needed));
    }
    m_before = {};
    updateState();
}

LiveSlider *TuningPage::control(const QString &key) const
{
    const ParameterSpec *spec = m_set ? m_set->find(key) : nullptr;
    return spec ? m_controls.value(spec->id) : nullptr;
}

void TuningPage::onStore()
{
    DeviceClient &client = workspace().client();
    updateState();
    if (!client.isConnected() || !client.device())
        return;
    const ChannelRoles &roles = client.roles();
    QList<Curve> errors;
    QList<Curve> gyros;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        // Without targets from the board, the angles themselves are shown.
        if (roles.target[axis] >= 0)
            errors.append(
                {roles.target[axis], roles.angle[axis], tr("Error, %1").arg(axisLabel(kAxes[axis]))});
        else
            errors.append({roles.angle[axis], -1, {}});
        gyros.append({roles.gyro[axis], -1, {}});
    }
    m_plots[0]->setCurves(client.device()->channels(), errors, client.telemetry());
    m_plots[1]->setCurves(client.device()->channels(), gyros, client.telemetry());
    m_clock.updateRate();
}

void TuningPage::showEvent(QShowEvent *event)
{
    Page::showEvent(event);
    workspace().telemetry().subscribe(this, [this] {
        const ChannelRoles &roles = workspace().roles();
        return ChannelRoles::present({roles.angle, roles.target, roles.gyro});
    });
    m_signs->refresh();
    m_clock.start();
    m_figureTimer.start();
}

void TuningPage::hideEvent(QHideEvent *event)
{
    Page::hideEvent(event);
    m_clock.stop();
    m_figureTimer.stop();
}

void TuningPage::updateState()
{
    const bool connected = workspace().client().isConnected();
    const bool writable = connected && workspace().client().identity().writable && !m_live.isHeld();
    const int changed = m_live.changeCount();
    m_a->setChecked(m_live.slot() == LiveModel::Slot::A);
    m_b->setChecked(m_live.slot() == LiveModel::Slot::B);
    for (QPushButton *button : {m_a, m_b, m_copy})
        button->setEnabled(writable && !m_live.parameters().isEmpty());
    m_revert->setEnabled(writable && m_live.tunedCount() > 0);
    m_save->setEnabled(writable && (changed > 0 || workspace().isUnstored()) && !m_saving);
    m_scroll->setEnabled(writable);
    // It keeps its room while there is no link.
    const Device *device = workspace().client().device();
    m_compare->setVisible(device && device->wholeMemory());
    m_compare->setEnabled(workspace().canCompareStored() && !m_saving && !m_live.isHeld());
    if (!connected) {
        m_state->setText(tr("Connect the board to tune it live"));
        return;
    }
    if (m_live.isHeld()) {
        m_state->setText(tr("Locked while a search, measurement or calibration runs"));
        return;
    }
    QString text = changed > 0           ? tr("%n value(s) in use, not stored", nullptr, changed)
        : workspace().isUnstored()       ? tr("Values in use are not stored")
        : workspace().isStoredKnown()    ? tr("In use: as stored")
        : workspace().usesItsText()      ? tr("In use: as in the board's text")
        : workspace().canCompareStored() ? tr("Whether what is in use is stored is not known yet")
                                         : tr("Nothing is changed here; this board does not tell what it has "
                                              "stored");
    if (const int different = m_live.slotDifference())
        text += u" · "_s + tr("A and B differ in %1").arg(different);
    m_state->setText(text);
}

QString TuningPage::stateText() const
{
    return m_state->text();
}

void TuningPage::compare()
{
    m_saving = true;
    updateState();
    whenDone(workspace().compareStored(), this, [this](const Result<WholeMemory::Contents> &both) {
        m_saving = false;
        if (!both)
            workspace().notifications().report(both.error());
        updateState();
    });
}

void TuningPage::updateFigures()
{
    const auto store = workspace().client().telemetry();
    if (!store || !workspace().client().device())
        return;
    const ChannelRoles &roles = workspace().roles();
    const double now = store->now();
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        const bool told = roles.target[axis] >= 0;
        SpanStatistics span = spanStatistics(*store, told ? roles.target[axis] : roles.angle[axis],
                                             told ? roles.angle[axis] : -1, now - kFigureSpan, now, true);
        if (!told)
            span = span.aroundMean();  // without a target, the deviation from the mean
        m_now[axis] = {span.rms, span.peak};
        auto &cells = m_cells[axis];
        cells[0]->setText(figure(span.rms));
        cells[1]->setText(figure(span.peak));
        const auto &before = m_before[axis];
        cells[2]->setText(before ? figure(before->rms) : u"–"_s);
        cells[3]->setText(before ? figure(before->peak) : u"–"_s);
        const double change
            = before && before->rms > 0 ? 100.0 * (span.rms / before->rms - 1.0) : std::nan("");
        cells[4]->setText(percentText(change));
        const QString name = std::isnan(change) || std::abs(change) < 5 ? u"muted"_s
            : change < 0                                                ? u"ok"_s
                                                                        : u"warning"_s;
        if (cells[4]->objectName() != name) {
            cells[4]->setObjectName(name);
            repolish(cells[4]);
        }
    }
}

void TuningPage::keepFigures()
{
    updateFigures();
    for (std::size_t axis = 0; axis < kAxisCount; ++axis)
        m_before[axis] = m_now[axis];
    updateFigures();
}

void TuningPage::resume(const std::any &kept)
{
    m_before = std::any_cast<decltype(m_before)>(kept);
    updateFigures();
}

// What was refused is not in use, and would not be stored.
void TuningPage::save()
{
    if (NumberBox::refusedIn(*this))
        return;
    m_saving = true;
    updateState();
    whenDone(workspace().saveLive(*this), this, [this](bool) {
        m_saving = false;
        updateState();
    });
}
