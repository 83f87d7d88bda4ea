// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/bars.h"

#include "app/mainwindow/motorskeys.h"
#include "app/workspace/question.h"
#include "protocol/client/whendone.h"
#include "protocol/session/linkstatistics.h"
#include "protocol/telemetry/telemetryplan.h"
#include "protocol/telemetry/telemetrystore.h"
#include "widgets/forms/clickshield.h"
#include "widgets/forms/numberbox.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"
#include "widgets/models/thinningtext.h"
#include "widgets/views/elidedlabel.h"

#include <QDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr double kPoorShare = 80;  // %, of what one end receives
constexpr auto kPoorRoundTrip = 500ms;  // who steers sees what was half a second ago
constexpr qint64 kBadTimeMs = 10000;  // how long a loss colours the link's dot

}  // namespace

OfferBar::OfferBar(QWidget *parent)
    : QFrame(parent)
    , m_text(new QLabel)
    , m_row(new QHBoxLayout)
    , m_fold(new QToolButton)
{
    setObjectName(u"offerBar"_s);
    m_text->setWordWrap(true);
    m_fold->setCheckable(true);
    m_row->setSpacing(Metric::kGap);
    m_row->addWidget(m_text, 1);
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(12, Metric::kGap, Metric::kGap, Metric::kGap);
    layout->setSpacing(Metric::kGap);
    layout->addLayout(m_row, 1);
    layout->addWidget(m_fold);
    connect(m_fold, &QToolButton::toggled, this, &OfferBar::setFolded);
    hide();
}

// What moves or destroys something never waits unseen behind another question.
void OfferBar::ask(const Offer &offer)
{
    const auto known = std::find_if(m_offers.begin(), m_offers.end(), [&offer](const Offer &each) {
        return offer.topic != Topic::None && each.topic == offer.topic;
    });
    const bool isUrgent = offer.isUrgent
        || std::any_of(offer.choices.begin(), offer.choices.end(),
                       [](const auto &choice) { return choice.loses; });
    const bool isFirst = m_offers.isEmpty() || known == m_offers.begin() || isUrgent;
    if (known != m_offers.end() && !isUrgent) {
        *known = offer;
    } else {
        if (known != m_offers.end())
            m_offers.erase(known);
        m_offers.insert(isUrgent ? 0 : m_offers.size(), offer);
    }
    if (isFirst)
        showFirst();
    else
        setFolded(m_fold->isChecked());
}

void OfferBar::withdraw(Topic topic)
{
    const bool isFirst = !m_offers.isEmpty() && m_offers.first().topic == topic;
    m_offers.removeIf([topic](const Offer &each) { return each.topic == topic; });
    if (isFirst)
        showFirst();
    else if (!m_offers.isEmpty())
        setFolded(m_fold->isChecked());
}

void OfferBar::clear()
{
    m_offers.clear();
    showFirst();
}

void OfferBar::showFirst()
{
    for (QPushButton *button : std::exchange(m_buttons, {})) {
        button->hide();
        button->deleteLater();
    }
    if (m_offers.isEmpty()) {
        hide();
        return;
    }
    m_text->setText(m_offers.first().text);
    for (const Offer::Choice &choice : m_offers.first().choices) {
        auto *button = new QPushButton(choice.text);
        button->setObjectName(choice.loses ? u"danger"_s : m_buttons.isEmpty() ? u"primary"_s : QString());
        connect(button, &QPushButton::clicked, this, [this, chosen = choice.chosen] {
            m_offers.removeFirst();
            showFirst();
            chosen();
        });
        m_row->addWidget(button);
        m_buttons.append(button);
    }
    m_fold->setChecked(false);
    setFolded(false);
    show();
    new ClickShield(*this);
}

// It gives the page free without being answered.
void OfferBar::setFolded(bool folded)
{
    m_text->setVisible(!folded);
    for (QPushButton *button : std::as_const(m_buttons))
        button->setVisible(!folded);
    m_fold->setText(folded ? tr("%n open question(s)", nullptr, int(m_offers.size())) : u"▴"_s);
    m_fold->setAccessibleName(folded ? m_fold->text() : tr("Fold the question"));
    m_fold->setToolTip(folded ? text() : tr("Fold the question; it stays open. Ctrl+F6 leads here and back"));
    m_row->invalidate();  // it does not learn that its widgets were hidden before it is laid out
    setMaximumWidth(folded ? sizeHint().width() : QWIDGETSIZE_MAX);
    updateGeometry();
}

QString OfferBar::text() const
{
    return m_offers.isEmpty() ? QString() : m_offers.first().text;
}

UnsavedBar::UnsavedBar(Workspace &workspace, QWidget *parent)
    : QFrame(parent)
    , m_workspace(workspace)
    , m_text(new ElidedLabel)
    , m_where(new ElidedLabel)
    , m_undo(new QPushButton(tr("&Undo")))
    , m_redo(new QPushButton(tr("&Redo")))
    , m_discard(new QPushButton(tr("&Discard")))
    , m_saveFile(new QPushButton(tr("Save to &file…")))
    , m_write(new QPushButton(tr("Review and &write…")))
{
    setObjectName(u"unsavedBar"_s);
    m_write->setObjectName(u"primary"_s);
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(Metric::kMargin, Metric::kUnit, Metric::kMargin, Metric::kUnit);
    layout->setSpacing(Metric::kGap);
    m_text->setObjectName(u"changed"_s);
    m_where->setObjectName(u"muted"_s);
    // One above the other: beside each other, the profiles would be cut away first.
    auto *words = new QVBoxLayout;
    words->setSpacing(0);
    words->addWidget(m_text);
    words->addWidget(m_where);
    layout->addLayout(words, 1);
    // What comes and goes with the link stands where it moves none of the others.
    for (QPushButton *button : {m_saveFile, m_undo, m_redo, m_discard})
        layout->addWidget(button);
    layout->addWidget(m_write);
    connect(m_saveFile, &QPushButton::clicked, this, &UnsavedBar::saveFileRequested);
    QUndoStack &stack = workspace.edits().undoStack();
    connect(m_undo, &QPushButton::clicked, &workspace.edits(), &EditStack::undo);
    connect(m_redo, &QPushButton::clicked, &workspace.edits(), &EditStack::redo);
    connect(m_discard, &QPushButton::clicked, &workspace.edits(), &EditStack::discardAll);
    connect(m_write, &QPushButton::clicked, this, &UnsavedBar::reviewRequested);
    connect(&stack, &QUndoStack::indexChanged, this, [this] {
        m_written = false;
        refresh();
    });
    connect(&stack, &QUndoStack::cleanChanged, this, &UnsavedBar::refresh);
    connect(&workspace.configuration(), &ConfigurationModel::changeCountChanged, this, &UnsavedBar::refresh);
    connect(&workspace.edits().refused(), &RefusedTexts::changed, this, &UnsavedBar::refresh);
    connect(&workspace.configuration(), &ConfigurationModel::boardReset, this, &UnsavedBar::refresh);
    connect(&workspace.client(), &DeviceClient::stateChanged, this, &UnsavedBar::refresh);
    connect(&workspace, &Workspace::writeStarted, this, &UnsavedBar::refresh);
    connect(&workspace, &Workspace::writeFinished, this, [this] {
        m_written = true;
        refresh();
    });
    refresh();
}

void UnsavedBar::refresh()
{
    const ConfigurationModel &model = m_workspace.configuration();
    const int count = model.changeCount();
    QUndoStack &stack = m_workspace.edits().undoStack();
    const int refused = m_workspace.edits().refused().count();
    showCounts(count, refused);
    m_undo->setEnabled(stack.canUndo());
    m_redo->setEnabled(stack.canRedo());
    m_undo->setToolTip(stack.canUndo() ? tr("Undo: %1 (Ctrl+Z)").arg(stack.undoText()) : QString());
    m_redo->setToolTip(stack.canRedo() ? tr("Redo: %1 (Ctrl+Shift+Z)").arg(stack.redoText()) : QString());
    m_discard->setEnabled(count + refused > 0);
    // With a text that is no value, a review leads there.
    const bool canWrite = count + refused > 0 && m_workspace.client().isConnected()
        && m_workspace.client().identity().writable && !m_workspace.isWriting();
    m_write->setEnabled(canWrite);
    m_write->setToolTip(canWrite || count + refused == 0 ? tr("Ctrl+S")
                            : m_workspace.isWriting()    ? tr("A write is running")
                                                         : tr("Connect the board to write to it"));
    const QString offline = m_workspace.offlineFile();
    m_saveFile->setVisible(!model.isEmpty() && !m_workspace.client().isConnected());
    m_saveFile->setToolTip(offline);
    // After a write, redoing is possible only by its shortcut; the bar is for unsaved changes.
    setVisible(count + refused > 0 || (stack.canRedo() && !m_written));
}

// With their profiles, which have numbers where there is no room for names.
void UnsavedBar::showCounts(int changes, int refused)
{
    const ConfigurationModel &model = m_workspace.configuration();
    QStringList counts;
    QStringList shortCounts;
    if (changes > 0) {
        counts.append(tr("%n unwritten change(s)", nullptr, changes));
        shortCounts.append(tr("%n unwritten", nullptr, changes));
    }
    if (refused > 0) {
        counts.append(tr("%n entry(s) that are no values", nullptr, refused));
        shortCounts.append(tr("%n no value", nullptr, refused));
    }
    if (counts.isEmpty())
        counts.append(tr("No unwritten changes"));
    m_text->setFullText(counts.join(u", "_s), {}, shortCounts.join(u", "_s));
    const QMap<int, int> byProfile = model.changesByProfile();
    QStringList numbers;
    for (auto each = byProfile.begin(); each != byProfile.end(); ++each)
        numbers.append(each.key() == ConfigurationModel::kAllProfiles
                           ? tr("all: %1").arg(each.value())
                           : tr("P%1: %2").arg(each.key() + 1).arg(each.value()));
    const QString places = changePlaces(model, byProfile).join(u" · "_s);
    m_where->setFullText(places, {}, numbers.join(u" · "_s));
    m_where->setMinimumHeight(m_where->fontMetrics().height());  // its line stays when nothing is in it
    m_where->setVisible(m_workspace.profileCount() > 1);
}

UnstoredBar::UnstoredBar(Workspace &workspace, QWidget *parent)
    : QFrame(parent)
    , m_workspace(workspace)
    , m_text(new ElidedLabel)
    , m_back(new QPushButton(tr("Revert all")))
    , m_store(new QPushButton(tr("Store on the board")))
{
    setObjectName(u"unsavedBar"_s);
    m_text->setObjectName(u"changed"_s);
    m_store->setObjectName(u"primary"_s);
    m_back->setToolTip(tr("Put the values that were read from the board into use at once"));
    m_store->setToolTip(tr("Store everything that is in use; a snapshot is taken first"));
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(Metric::kMargin, Metric::kGap, Metric::kMargin, Metric::kGap);
    layout->setSpacing(Metric::kGap);
    layout->addWidget(m_text, 1);
    layout->addWidget(m_back);
    layout->addWidget(m_store);
    connect(m_store, &QPushButton::clicked, this, [this] {
        if (NumberBox::refusedIn(*window()))  // it is not in use, and would not be stored
            return;
        setEnabled(false);
        whenDone(m_workspace.saveLive(*this), this, [this](bool) { setEnabled(true); });
    });
    connect(m_back, &QPushButton::clicked, this, &UnstoredBar::goBack);
    connect(&workspace, &Workspace::unstoredChanged, this, &UnstoredBar::refresh);
    connect(&workspace, &Workspace::guidedChanged, this, &UnstoredBar::refresh);
    connect(&workspace.live(), &LiveModel::changeCountChanged, this, &UnstoredBar::refresh);
    connect(&workspace.live(), &LiveModel::heldChanged, this, &UnstoredBar::refresh);
    connect(&workspace.live(), &LiveModel::leapt, this, [this](const ParameterChange &change) {
        const auto goOn = [this, id = change.spec->id, to = change.to] { m_workspace.live().agree(id, to); };
        askAboutLeap(m_workspace, change, this, goOn);
    });
    connect(&workspace.client(), &DeviceClient::stateChanged, this, &UnstoredBar::refresh);
    refresh();
}

QString UnstoredBar::reloadAction() const
{
    if (!m_workspace.client().isConnected())
        return {};
    const ActionSpec *action = reloadingAction(m_workspace.client().device()->actions());
    return action ? QString::fromLatin1(action->key) : QString();
}

void UnstoredBar::goBack()
{
    if (!m_workspace.isUnstored()) {
        m_workspace.live().revert();
        return;
    }
    QDialog *panel = askInPanel(
        {tr("Revert all?"),
         tr("All values in use that are not stored are lost. The board starts with the stored ones, and so "
            "may "
            "its motors: keep hands and cables clear of the gimbal."),
         {{tr("Revert all"), [this] { m_workspace.perform(reloadAction(), {}); }, true}},
         tr("Keep what is in use")},
        this);
    connect(&m_workspace.client(), &DeviceClient::stateChanged, panel, &QDialog::reject);
}

void UnstoredBar::refresh()
{
    const bool connected = m_workspace.client().isConnected() && m_workspace.client().identity().writable;
    const int live = m_workspace.live().changeCount();
    const int doubted = m_workspace.live().doubtedCount();
    const bool more = m_workspace.isUnstored();
    const bool isCompared = !m_workspace.canCompareStored() || m_workspace.isStoredKnown();
    m_text->setFullText(
        doubted > 0 ? tr("Whether %n value(s) set last are in use is not known: the board has not answered.",
                         nullptr, doubted)
            : more  ? tr("Values in use on the board are not stored: a restart loses them.")
            : isCompared
            ? tr("%n value(s) set live, not stored: a restart loses them.", nullptr, live)
            : tr("%n value(s) set live, not stored; whether others are is not known.", nullptr, live),
        {},
        doubted > 0 ? tr("%n not known", nullptr, doubted)
            : more  ? tr("Values are not stored")
                    : tr("%n not stored", nullptr, live));
    const bool isFree = !m_workspace.isGuided() && !m_workspace.live().isHeld();
    m_back->setEnabled((!more || !reloadAction().isEmpty()) && isFree);
    m_store->setEnabled(isFree);
    setVisible(connected && (more || live > 0 || doubted > 0));
}

StatusStrip::StatusStrip(Workspace &workspace, QWidget *parent)
    : QFrame(parent)
    , m_workspace(workspace)
    , m_link(new QLabel)
    , m_battery(new QLabel)
    , m_temperature(new QLabel)
    , m_faults(new QLabel)
    , m_sensor(new QLabel)
    , m_hint(new QLabel)
{
    setObjectName(u"statusBar"_s);
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(Metric::kMargin, Metric::kUnit, Metric::kMargin, Metric::kUnit);
    layout->setSpacing(Metric::kGroupGap);
    for (QLabel *label : {m_link, m_battery, m_temperature, m_faults}) {
        label->setTextFormat(Qt::RichText);
        layout->addWidget(label);
    }
    m_sensor->setObjectName(u"warning"_s);
    m_sensor->setToolTip(
        tr("Rates and accelerations on all pages are those of this sensor, and calibrations are "
           "about it, until another one is selected or the board restarts."));
    layout->addWidget(m_sensor);
    layout->addStretch(1);
    m_hint->setObjectName(u"warning"_s);
    layout->addWidget(m_hint);
    connect(&workspace.client(), &DeviceClient::statisticsChanged, this, &StatusStrip::refresh);
    connect(&workspace.client(), &DeviceClient::stateChanged, this, &StatusStrip::refresh);
    connect(&workspace.theme(), &Theme::changed, this, &StatusStrip::refresh);
    connect(&workspace.configuration(), &ConfigurationModel::boardReset, this, &StatusStrip::refresh);
    refresh();
}

void StatusStrip::follow(const MotorsKeys &keys)
{
    connect(&keys, &MotorsKeys::holdStarted, this,
            [this] { m_hint->setText(tr("Hold Esc to stop the motors.")); });
    connect(&keys, &MotorsKeys::holdEnded, m_hint, &QLabel::clear);
}

// Where it is another one than the camera's, whoever has selected it.
void StatusStrip::tellSensor()
{
    m_sensor->clear();
    const Device *device = m_workspace.client().device();
    if (!device || !m_workspace.client().isConnected())
        return;
    const auto channels = device->channels();
    const int role = findRole(channels, m_workspace.client().identity().capabilities, "sensor");
    if (role < 0)
        return;
    const auto choices = channels[std::size_t(role)].choices;
    const double shown = m_workspace.latest(role);
    const auto name
        = std::ranges::find_if(choices, [shown](const Choice &choice) { return choice.value == shown; });
    if (name != choices.begin() && name != choices.end())
        m_sensor->setText(tr("sensor shown: %1").arg(tableText(name->name)));
}

// Of both ends, where the board answers heartbeats; the time of the newest answer otherwise.
QString StatusStrip::qualityText(const LinkStatistics &link) const
{
    if (link.isDegraded())
        return u" · "_s + tr("nothing for %1 s").arg(numberText(seconds(link.silence), 1));
    QString text;
    const auto time = link.quality && link.quality->roundTrip ? link.quality->roundTrip
                                                              : m_workspace.freshness().answerTime();
    if (time)
        text += u" · "_s + tr("%1 ms").arg(numberText(seconds(*time) * 1000, 1));
    if (!link.quality)
        return text;
    if (link.quality->answered)
        text += u" · "_s + tr("↓ %1 %").arg(numberText(*link.quality->answered * 100, 0));
    if (const double there = m_workspace.latest(m_workspace.roles().receiveQuality); !std::isnan(there))
        text += u" ↑ %1 %"_s.arg(numberText(std::clamp(there, 0.0, 100.0), 0));
    if (link.quality->isShared)
        text += u" · "_s + tr("another ground station");
    return text;
}

// What makes the present link a poor one, as sentences; empty: nothing does.
QString StatusStrip::weaknessText(const LinkStatistics &link) const
{
    QStringList texts;
    if (!link.quality)
        return {};
    const double here = link.quality->answered.value_or(1.0) * 100;
    const double there = m_workspace.latest(m_workspace.roles().receiveQuality);
    if (here < kPoorShare)
        texts.append(tr("Weak link: only %1 % of the questions are answered. Commands may be lost as well.")
                         .arg(numberText(here, 0)));
    if (there < kPoorShare)
        texts.append(tr("Weak link: the board receives only %1 % of what is sent. Commands may be lost.")
                         .arg(numberText(std::max(there, 0.0), 0)));
    if (link.quality->roundTrip && *link.quality->roundTrip > kPoorRoundTrip)
        texts.append(tr("Slow link: an answer takes %1 ms. What is shown is old, and a stop comes late.")
                         .arg(numberText(seconds(*link.quality->roundTrip) * 1000, 0)));
    return texts.join(u'\n');
}

void StatusStrip::resizeEvent(QResizeEvent *event)
{
    QFrame::resizeEvent(event);
    giveWay();
}

void StatusStrip::refresh()
{
    tellSensor();
    tell();
    giveWay();
}

// What is told last goes first, and whole: a number that is cut is another one.
void StatusStrip::giveWay()
{
    QStringList parts = m_linkText.split(u" · "_s);
    m_link->setText(m_linkText);
    while (parts.size() > 1 && layout()->minimumSize().width() > width()) {
        parts.removeLast();
        m_link->setText(parts.join(u" · "_s));
    }
}

void StatusStrip::tell()
{
    const DeviceClient &client = m_workspace.client();
    const Theme &theme = m_workspace.theme();
    const auto dot = [&theme](ColorRole role) {
        return u"<span style='color:%1'>●</span> "_s.arg(theme.color(role).name());
    };
    if (!client.isConnected()) {
        const QString offline = m_workspace.offlineFile();
        m_linkText = dot(ColorRole::Muted)
            + (offline.isEmpty()
                   ? tr("no link")
                   : tr("offline: editing %1").arg(QFileInfo(offline).fileName().toHtmlEscaped()));
        for (QLabel *label : {m_battery, m_temperature, m_faults})
            label->clear();
        return;
    }
    const LinkStatistics &link = client.statistics();
    const auto store = client.telemetry();
    const quint64 damaged = link.framing.headerErrors + link.framing.bodyErrors;
    const quint64 lost = store ? store->lost() : 0;
    const TelemetryPlan &plan = client.telemetryPlan();
    // What a board streams by itself has no numbers: nobody can count what does not arrive.
    const bool counts = lost > 0 || !plan.isStreamedUnasked;
    const QString rate = numberText(link.framesPerSecond, 0);
    QString text = counts ? tr("%1/s · %2 lost").arg(rate).arg(lost) : tr("%1/s").arg(rate);
    const QString thinned = thinningText(plan.rate, plan.fullRate, plan.budget);
    if (!thinned.isEmpty())
        text += u" · "_s + tr("thinned out: slow line");
    const QString weakness = weaknessText(link);
    QStringList hints{!link.quality ? tr("Messages received per second, samples lost, answer time")
                          : counts ? tr("Messages received per second, samples lost, round trip; ↓ share of "
                                        "our questions that are answered, ↑ how well the board receives")
                                   : tr("Messages received per second, round trip; ↓ share of our questions "
                                        "that are answered, ↑ how well the board receives")};
    for (const QString &hint : {thinned, weakness}) {
        if (!hint.isEmpty())
            hints.append(hint);
    }
    m_link->setToolTip(hints.join(u'\n'));
    if (damaged > 0)
        text += u" · "_s + tr("%1 damaged").arg(damaged);
    text += qualityText(link);
    if (!weakness.isEmpty())
        text.prepend(tr("weak link") + u" · "_s);
    // The colour shows the present state; the numbers cover the whole connection.
    if (damaged + lost != m_lastBad) {
        m_lastBad = damaged + lost;
        m_badAt.start();
    }
    const bool bad = m_lastBad > 0 && m_badAt.isValid() && m_badAt.elapsed() < kBadTimeMs;
    const bool stale = m_workspace.freshness().staleSince().has_value();
    const bool frozen = m_workspace.freshness().frozenSince().has_value();
    const bool played = m_workspace.freshness().hasPlayed();
    const bool poor = !weakness.isEmpty() || link.isDegraded() || (link.quality && link.quality->isShared);
    m_linkText = dot(bad || stale || frozen || played || poor ? ColorRole::Warning : ColorRole::Ok) + text;
    if (stale || frozen || played) {
        // What they said is old; the views say since when.
        m_battery->setText(u"<span style='color:%1'>%2</span>"_s.arg(theme.color(ColorRole::Warning).name(),
                                                                     frozen ? tr("live data stand still")
                                                                         : played
                                                                         ? tr("the recording has ended")
                                                                         : tr("no live data")));
        m_temperature->clear();
        m_faults->clear();
        return;
    }
    const ChannelRoles &roles = m_workspace.roles();
    const double volts = m_workspace.latest(roles.battery);
    m_battery->setText(std::isnan(volts) ? QString() : tr("%1 V").arg(numberText(volts, 1)));
    const double celsius = m_workspace.latest(roles.temperature);
    m_temperature->setText(temperatureText(celsius, m_workspace.settings().fahrenheit()));
    const auto faults = m_workspace.faults();
    if (faults.empty()) {
        // Only a board that tells its errors tells that it has none.
        m_faults->setText(m_workspace.motorsRunning() && roles.faults >= 0 ? tr("no errors") : QString());
        return;
    }
    QStringList names;
    for (const BoardFault &fault : faults)
        names.append(tableText(fault.name.toUtf8().constData()));
    m_faults->setText(u"<span style='color:%1'>✖ %2</span>"_s.arg(theme.color(ColorRole::Danger).name(),
                                                                  names.join(u", "_s).toHtmlEscaped()));
}
