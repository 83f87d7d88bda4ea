// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/simplebgc/signalspage.h"

#include "protocol/client/whendone.h"
#include "protocol/simplebgc/parametertables.h"
#include "protocol/simplebgc/telemetrytables.h"
#include "widgets/forms/parameterform.h"
#include "widgets/models/errortext.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"
#include "widgets/views/card.h"
#include "widgets/views/inputbars.h"
#include "widgets/views/stickbar.h"

#include <QGridLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kAsk = 200ms;
constexpr int kFormWidth = 900;
constexpr int kBesideEms = 80;  // of width, and the inputs stand beside the map
constexpr int kInputsSince = 2600;  // READ_RC_INPUTS (errata 2)
constexpr double kMiddle = 1500;  // of the inputs as telemetry reports them
constexpr double kWay = 500;
constexpr std::size_t kReported = 4;  // of the functions: roll, pitch, yaw, command

bool isSlot(const QString &key)
{
    return key.startsWith(u"trigger"_s) || key.startsWith(u"analog"_s);
}

QString slotName(const QString &key)
{
    return key.startsWith(u"trigger"_s) ? SignalsPage::tr("Trigger slot %1").arg(key.mid(7))
                                        : SignalsPage::tr("Variable slot %1").arg(key.mid(6));
}

}  // namespace

SignalsPage::SignalsPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"signals"_s, tr("Signals"), parent)
    , m_form(new ParameterForm(workspace.configuration(), workspace.edits()))
    , m_inputs(new InputBars(workspace.theme()))
    , m_map(new QBoxLayout(QBoxLayout::TopToBottom))
    , m_live(new QGridLayout)
    , m_note(new QLabel)
{
    auto *cards = new QWidget;
    auto *column = new QVBoxLayout(cards);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(12);
    column->addWidget(makeMap());
    column->addWidget(makeLive());
    column->addStretch(1);
    auto *scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidget(cards);
    body()->addWidget(scroll, 1);
    connect(&workspace.configuration(), &ConfigurationModel::boardReset, this, &SignalsPage::onState);
    refreshWhileShown(
        kAsk, [this] { ask(); }, [this] { return m_open > 0 || !this->workspace().client().isConnected(); });
    onState();
}

QWidget *SignalsPage::makeMap()
{
    auto *map = new Card(tr("What is steered by which input"));
    m_form->setMaximumWidth(kFormWidth);
    map->content()->addWidget(m_form);
    map->content()->addStretch(1);
    auto *inputs = new Card(tr("All inputs"));
    auto *note = new QLabel(tr("Move a stick: the input whose bar moves is the one to choose."));
    note->setObjectName(u"muted"_s);
    note->setWordWrap(true);
    inputs->content()->addWidget(note);
    inputs->content()->addWidget(m_inputs);
    inputs->content()->addStretch(1);
    coverWhenStale(*m_inputs, {});
    auto *row = new QWidget;
    row->setLayout(m_map);
    m_map->setContentsMargins(0, 0, 0, 0);
    m_map->setSpacing(12);
    m_map->addWidget(map, 5);
    m_map->addWidget(inputs, 2);
    return row;
}

void SignalsPage::resizeEvent(QResizeEvent *event)
{
    Page::resizeEvent(event);
    const bool isWide = width() > kBesideEms * fontMetrics().horizontalAdvance(u'm');
    m_map->setDirection(isWide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
}

QWidget *SignalsPage::makeLive()
{
    auto *live = new Card(tr("What the functions get now"));
    m_note->setWordWrap(true);
    m_note->setObjectName(u"muted"_s);
    m_live->setHorizontalSpacing(12);
    m_live->setVerticalSpacing(8);
    m_live->setColumnStretch(1, 1);
    auto *rows = new QWidget;
    auto *column = new QVBoxLayout(rows);
    column->setContentsMargins(0, 0, 0, 0);
    column->addLayout(m_live);
    live->content()->addWidget(rows);
    live->content()->addWidget(m_note);
    coverWhenStale(*rows, {});
    return live;
}

SignalsPage::Row &SignalsPage::row(const QString &key, const QString &name)
{
    const auto found = m_rows.find(key);
    if (found != m_rows.end())
        return found->second;
    const int at = m_live->rowCount();
    Row made{new QLabel(name), new StickBar(workspace().theme(), false), new QLabel, new QLabel};
    made.bar->setAccessibleName(name);
    made.percent->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    made.percent->setMinimumWidth(made.percent->fontMetrics().horizontalAdvance(u"-100,0 %  "_s));
    made.effect->setObjectName(u"muted"_s);
    m_live->addWidget(made.name, at, 0);
    m_live->addWidget(made.bar, at, 1);
    m_live->addWidget(made.percent, at, 2);
    m_live->addWidget(made.effect, at, 3);
    return m_rows.emplace(key, made).first->second;
}

void SignalsPage::removeRows(const std::function<bool(const QString &)> &isGone)
{
    for (auto it = m_rows.begin(); it != m_rows.end();) {
        if (!isGone(it->first)) {
            ++it;
            continue;
        }
        for (QWidget *widget :
             {static_cast<QWidget *>(it->second.name), static_cast<QWidget *>(it->second.bar),
              static_cast<QWidget *>(it->second.percent), static_cast<QWidget *>(it->second.effect)})
            delete widget;
        it = m_rows.erase(it);
    }
}

void SignalsPage::onState()
{
    const ConfigurationModel &model = workspace().configuration();
    QList<int> parameters;
    removeRows([](const QString &) { return true; });
    if (!model.isEmpty()) {
        const ParameterSet &set = model.board().parameters();
        for (const char *key : simplebgc::kSignalKeys) {
            const ParameterSpec *spec = set.find(QLatin1String(key));
            if (!spec)
                continue;
            parameters.append(spec->id);
            row(spec->key, parameterLabel(*spec));
        }
    }
    m_form->setParameters(parameters);
}

// Answers come while a procedure runs as well, or not: the next question waits for the last one.
void SignalsPage::ask()
{
    const auto perform = [this](const char *key, auto &&show) {
        ++m_open;
        whenDone(workspace().client().submit<ActionReply>([key](Channel &channel, Device &device) {
            return device.perform(channel, QLatin1String(key), {});
        }),
                 this, [this, show](const Result<ActionReply> &told) {
                     --m_open;
                     (this->*show)(told.value_or(ActionReply()));
                 });
    };
    if (workspace().client().identity().firmwareNumber >= kInputsSince)
        perform("signals", &SignalsPage::showSignals);
    else
        showSignals({});
    perform("inputs", &SignalsPage::showInputs);
    perform("slots.read", &SignalsPage::showSlots);
}

// Older firmware tells some of them with its telemetry.
QVariant SignalsPage::reported(std::size_t function) const
{
    if (function >= kReported)
        return {};
    const double raw = workspace().latest(simplebgc::RcRoll + int(function));
    return std::abs(raw - kMiddle) <= kWay ? QVariant(100 * (raw - kMiddle) / kWay) : QVariant();
}

void SignalsPage::showSignals(const ActionReply &told)
{
    const bool isAsked = workspace().client().identity().firmwareNumber >= kInputsSince;
    for (std::size_t i = 0; i < simplebgc::kSignalKeys.size(); ++i) {
        const QString key = QLatin1String(simplebgc::kSignalKeys[i]);
        if (m_rows.count(key) > 0)
            showRow(key, {}, isAsked ? told.value(key) : reported(i), {});
    }
}

void SignalsPage::showInputs(const ActionReply &told)
{
    m_inputs->setInputs(told);
}

void SignalsPage::showSlots(const ActionReply &told)
{
    const QStringList silent = told.value(u"no_signal"_s).toString().split(u", "_s, Qt::SkipEmptyParts);
    std::map<QString, bool> inUse;
    for (auto it = told.begin(); it != told.end(); ++it) {
        if (isSlot(it.key()))
            inUse[it.key().section(u'.', 0, 0)] = true;
    }
    for (const QString &slot : silent)
        inUse[slot] = true;
    removeRows([&inUse](const QString &key) { return isSlot(key) && inUse.count(key) == 0; });
    for (const auto &[key, is] : inUse) {
        const QVariant action = told.value(key + u".action"_s);
        const QVariant value = told.value(key + u".value"_s);
        showRow(key, slotName(key), told.value(key + u".signal"_s),
                action.isValid()      ? tableText(action.toString().toUtf8().constData())
                    : value.isValid() ? tr("sets %1").arg(shortNumberText(value.toDouble(), 6))
                                      : QString());
    }
    m_note->setText(inUse.empty()
                        ? tr("No slot is in use. What slots do is set under Parameters, “Trigger slots” "
                             "and “Variable slots”.")
                        : tr("What slots do is set under Parameters, “Trigger slots” and “Variable "
                             "slots”."));
}

void SignalsPage::showRow(const QString &key, const QString &name, const QVariant &percent,
                          const QString &effect)
{
    Row &shown = row(key, name);
    const double value = percent.isValid() ? percent.toDouble() : std::nan("");
    shown.bar->setValue(value / 100, value / 100);
    shown.percent->setText(std::isnan(value) ? tr("no signal") : tr("%1 %").arg(numberText(value, 1)));
    shown.effect->setText(effect);
}

double SignalsPage::signal(const QString &key) const
{
    const auto found = m_rows.find(key);
    return found == m_rows.end() ? std::nan("") : 100 * found->second.bar->value();
}

QString SignalsPage::effect(const QString &key) const
{
    const auto found = m_rows.find(key);
    return found == m_rows.end() ? QString() : found->second.effect->text();
}
