// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/simplebgc/magnetometercard.h"

#include "app/workspace/question.h"
#include "app/workspace/wizardparts.h"
#include "protocol/client/whendone.h"
#include "protocol/simplebgc/telemetrytables.h"
#include "widgets/forms/keyboard.h"
#include "widgets/models/errortext.h"
#include "widgets/models/numbertext.h"
#include "widgets/views/fieldsphereview.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kPointsPeriod = 100ms;
constexpr double kApart = 0.02;  // of the field: a camera at rest adds no points
constexpr std::size_t kMostPoints = 4000;
constexpr std::size_t kAllAround = 24;  // of 26 directions
constexpr std::size_t kFewestAround = 18;  // the action refuses less
constexpr qsizetype kNamed = 6;  // missing directions that are named
constexpr double kGoodHeading = 3;  // degrees
constexpr double kFairHeading = 8;
constexpr double kSmooth = 0.04;  // of the radius
constexpr double kFairlySmooth = 0.10;

QString dash()
{
    return u"–"_s;
}

QString percent(double fraction, int decimals)
{
    return MagnetometerCard::tr("%1 %").arg(numberText(100 * fraction, decimals));
}

}  // namespace

MagnetometerCard::MagnetometerCard(Workspace &workspace, QWidget *parent)
    : Card({}, parent)
    , m_workspace(workspace)
    , m_what(new QLabel)
    , m_sees(new QLabel)
    , m_figures(new QLabel)
    , m_view(new FieldSphereView(workspace.theme()))
    , m_back(new QPushButton(tr("Back")))
    , m_cancel(new QPushButton(tr("Cancel")))
    , m_go(new QPushButton)
{
    makeBody();
    connect(m_back, &QPushButton::clicked, this, &MagnetometerCard::left);
    connect(m_cancel, &QPushButton::clicked, this, [this] { m_workspace.client().cancelJobs(); });
    connect(m_go, &QPushButton::clicked, this, [this] {
        if (m_step == Step::Result)
            emit left();
        else
            askToLetGo(m_workspace, m_go->text(), this, [this] { calibrate(); });
    });
    connect(&workspace.client(), &DeviceClient::progressChanged, this, &MagnetometerCard::onProgress);
    m_timer.setInterval(kPointsPeriod);
    connect(&m_timer, &QTimer::timeout, this, &MagnetometerCard::look);
    setStep(Step::Ready);
}

void MagnetometerCard::makeBody()
{
    setHeadline(*m_what);
    m_sees->setWordWrap(true);
    m_figures->setWordWrap(true);
    m_figures->setTextFormat(Qt::RichText);
    m_figures->setAlignment(Qt::AlignTop);
    m_go->setObjectName(u"primary"_s);
    setHarmless(*m_back);
    setHarmless(*m_cancel);
    auto *middle = new QHBoxLayout;
    middle->setSpacing(Metric::kGroupGap);
    middle->addWidget(m_view, 3);
    middle->addWidget(m_figures, 2);
    auto *buttons = new QHBoxLayout;
    buttons->addWidget(m_back);
    buttons->addStretch(1);
    buttons->addWidget(m_cancel);
    buttons->addWidget(m_go);
    content()->setSpacing(12);
    content()->addWidget(m_what);
    content()->addLayout(middle, 1);
    content()->addWidget(m_sees);
    content()->addLayout(buttons);
}

QString MagnetometerCard::sees() const
{
    return m_sees->text();
}

void MagnetometerCard::showEvent(QShowEvent *event)
{
    Card::showEvent(event);
    m_timer.start();
}

void MagnetometerCard::hideEvent(QHideEvent *event)
{
    Card::hideEvent(event);
    m_timer.stop();
}

void MagnetometerCard::begin()
{
    m_before.reset();
    forgetPoints();
    setStep(Step::Ready);
}

void MagnetometerCard::forgetPoints()
{
    const auto store = m_workspace.client().telemetry();
    m_since = store ? store->now() : 0;
    m_points.clear();
    m_sphere.reset();
    m_seen.reset();
}

void MagnetometerCard::setStep(Step step)
{
    m_step = step;
    m_back->setVisible(step == Step::Ready);
    m_cancel->setVisible(step == Step::Turning);
    m_go->setVisible(step != Step::Turning);
    m_go->setText(step == Step::Result ? tr("Finish") : tr("Calibrate the magnetometer"));
    if (step == Step::Ready)
        m_what->setText(
            tr("Turn the camera by hand to see what iron does to the field, or calibrate at once. "
               "Keep away from iron, cables and motors."));
    else if (step == Step::Turning)
        m_what->setText(tr("Turn the camera slowly until the cross has been at every empty ring. The board "
                           "ends by itself."));
    look();
    if (isVisible())
        (step == Step::Turning ? m_cancel : m_go->isEnabled() ? m_go : m_back)->setFocus();
}

bool MagnetometerCard::hasVectors() const
{
    double length = 0;
    for (const int channel : {simplebgc::MagRoll, simplebgc::MagPitch, simplebgc::MagYaw})
        length += std::abs(m_workspace.latest(channel));
    return length > 0;  // not a number while nothing has come
}

// What has come since, without what a camera at rest repeats.
void MagnetometerCard::collect()
{
    const auto store = m_workspace.client().telemetry();
    if (!store)
        return;
    const auto x = store->tracks(simplebgc::MagRoll);
    const auto y = store->tracks(simplebgc::MagPitch);
    const auto z = store->tracks(simplebgc::MagYaw);
    if (x.empty() || y.empty() || z.empty() || x.back().group() != y.back().group()
        || x.back().group() != z.back().group())
        return;
    const TrackView &rows = x.back();
    const std::size_t end = std::min({rows.end(), y.back().end(), z.back().end()});
    for (std::size_t row = rows.rowAt(m_since); row < end; ++row) {
        if (rows.time(row) <= m_since)
            continue;
        m_since = rows.time(row);
        const Vector3 point{double(rows.value(row)), double(y.back().value(row)),
                            double(z.back().value(row))};
        // What was not measured is zero, and what got lost is no number.
        if (point.norm() > 0
            && (m_points.empty() || (point - m_points.back()).norm() > kApart * point.norm()))
            m_points.push_back(point);
    }
    if (m_points.size() > kMostPoints)
        m_points.erase(m_points.begin(), m_points.end() - kMostPoints);
}

void MagnetometerCard::look()
{
    if (m_step == Step::Result)
        return;
    const bool isConnected = m_workspace.client().isConnected();
    if (isConnected)
        collect();
    m_sphere = fitFieldSphere(m_points);
    m_seen = m_sphere ? directionsSeen(m_points, *m_sphere) : SeenDirections();
    m_view->setPoints(m_points, m_sphere, m_seen);
    m_go->setEnabled(isConnected && !m_isAsked && hasVectors());
    m_sees->setText(seenText());
    showFigures(m_before, figures());
}

QString MagnetometerCard::seenText() const
{
    if (!m_workspace.client().isConnected())
        return tr("No board is connected.");
    if (const QString trouble = m_workspace.freshness().troubleText(); !trouble.isEmpty())
        return tr("%1. Waiting until the sensor sends live data again.").arg(trouble);
    if (!hasVectors())
        return tr("The board has sent no measurement of its magnetometer so far. Without any, nobody sees "
                  "whether a calibration helps, and none is begun.");
    if (!m_sphere)
        return tr("No sphere shows yet: turn the camera about another axis as well.");
    QStringList missing;
    for (std::size_t i = 0; i < kFieldDirections; ++i) {
        if (!m_seen[i])
            missing.append(directionName(fieldDirections()[i]));
    }
    if (missing.isEmpty())
        return tr("✓ All %1 directions are seen.").arg(int(kFieldDirections));
    if (missing.size() > kNamed)
        missing = missing.first(kNamed) + QStringList{u"…"_s};
    return tr("%1 of %2 directions are seen. The field has not yet come from: %3.")
        .arg(int(m_seen.count()))
        .arg(int(kFieldDirections))
        .arg(missing.join(u", "_s));
}

MagnetometerCard::Figures MagnetometerCard::figures() const
{
    Figures now{m_sphere, {}, {}, m_seen.count()};
    if (m_seen.count() >= kFewestAround)  // some directions alone do not show it
        now.stretch = fieldStretch(m_points);
    if (const double heading = m_workspace.latest(simplebgc::HeadingError); !std::isnan(heading))
        now.heading = heading;
    return now;
}

// It begins with a question and a look at the heading; the board's own part is told by its progress.
void MagnetometerCard::calibrate()
{
    m_isAsked = true;
    look();
    whenDone(m_workspace.perform(u"calibrate.magnetometer"_s, {}, true), this,
             [this](const Result<ActionOutcome> &outcome) { onDone(outcome); });
}

void MagnetometerCard::onProgress(const Progress &progress)
{
    if (!m_isAsked || m_step != Step::Ready || progress.step != u"calibrate-magnetometer"_s)
        return;
    m_before = figures();
    forgetPoints();
    setStep(Step::Turning);
}

void MagnetometerCard::onDone(const Result<ActionOutcome> &outcome)
{
    m_isAsked = false;
    const bool isCalledOff
        = !outcome && m_step == Step::Ready && outcome.error().code == ErrorCode::Cancelled;
    if (isCalledOff)
        return;
    if (!outcome) {
        ErrorText text = describe(outcome.error());
        if (outcome.error().code == ErrorCode::Cancelled) {
            text.what = tr("The calibration of the magnetometer was cancelled.");
            text.meaning = tr("The board ends it by itself, with what it has seen by then.");
            text.cure = tr("Calibrate again, and turn the camera to all sides.");
        }
        m_workspace.notifications().report(text);
        begin();
        return;
    }
    look();
    Figures now = figures();
    now.heading = outcome->reply.value(u"heading.error.after"_s).toDouble();
    if (m_before)
        m_before->heading = outcome->reply.value(u"heading.error.before"_s).toDouble();
    setStep(Step::Result);
    m_go->setEnabled(true);
    m_what->setText(verdict(now));
    m_sees->setText(tr("The points are what the sensor itself measures: a calibration moves none of them. "
                       "Whether it helped, the error of the heading tells."));
    showFigures(m_before, now);
}

QString MagnetometerCard::verdict(const Figures &now) const
{
    const double heading = now.heading.value_or(0);
    if (heading > kFairHeading)
        return tr("Magnetometer: poor, the heading is off by %1°. Repeat it away from iron.")
            .arg(numberText(heading, 1));
    if (!now.sphere)
        return tr("Magnetometer: calibrated, but its points did not come; the heading alone judges it.");
    if (now.sphere->roughness > kFairlySmooth)
        return tr("Magnetometer: poor, the points lie on no sphere. Something made of iron moved, or the "
                  "field is not the earth's alone.");
    const bool isGood
        = heading <= kGoodHeading && now.sphere->roughness <= kSmooth && now.directions >= kAllAround;
    return isGood ? tr("Magnetometer: good") : tr("Magnetometer: usable");
}

void MagnetometerCard::showFigures(const std::optional<Figures> &before, const Figures &now)
{
    const auto cell = u"<td align='right' style='padding-right:12px'>%1</td>"_s;
    QString html = u"<table cellspacing='0' cellpadding='2'>"_s;
    const auto row = [&](const QString &name, const auto &value) {
        html += u"<tr><td style='padding-right:12px'>%1</td>"_s.arg(name.toHtmlEscaped());
        html += (before ? cell.arg(value(*before)) : QString()) + cell.arg(value(now)) + u"</tr>"_s;
    };
    if (before)
        html += u"<tr><td></td>"_s + cell.arg(tr("before")) + cell.arg(tr("now")) + u"</tr>"_s;
    row(tr("Error of the heading"),
        [](const Figures &of) { return of.heading ? tr("%1°").arg(numberText(*of.heading, 1)) : dash(); });
    row(tr("Directions seen"),
        [](const Figures &of) { return tr("%1 of %2").arg(int(of.directions)).arg(int(kFieldDirections)); });
    const auto ofSphere = [&row](const QString &name, const auto &value) {
        row(name, [&value](const Figures &of) { return of.sphere ? value(*of.sphere) : dash(); });
    };
    ofSphere(tr("Field (radius)"), [](const FieldSphere &sphere) { return numberText(sphere.radius, 0); });
    constexpr std::array kAxisLetters{u'X', u'Y', u'Z'};
    for (std::size_t axis = 0; axis < kAxisLetters.size(); ++axis)
        ofSphere(tr("Centre, %1").arg(QChar(kAxisLetters[axis])),
                 [axis](const FieldSphere &sphere) { return numberText(sphere.centre[axis], 0); });
    ofSphere(tr("Shifted by iron"),
             [](const FieldSphere &sphere) { return percent(sphere.centre.norm() / sphere.radius, 0); });
    row(tr("Stretched by iron"),
        [](const Figures &of) { return of.stretch ? percent(*of.stretch - 1, 0) : dash(); });
    ofSphere(tr("Off the sphere"), [](const FieldSphere &sphere) { return percent(sphere.roughness, 1); });
    m_figures->setText(html + u"</table>"_s);
}
