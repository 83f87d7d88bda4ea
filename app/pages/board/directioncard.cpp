// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/board/directioncard.h"

#include "app/workspace/flightstate.h"
#include "app/workspace/wizardparts.h"
#include "protocol/device/flight.h"
#include "protocol/device/motorlayout.h"
#include "widgets/forms/clickshield.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr int kPerCent = 100;
constexpr std::array kParts{&MotorShare::roll, &MotorShare::pitch, &MotorShare::yaw};

using Kind = DirectionCheck::Kind;

QString motorsText(const QList<int> &numbers)
{
    QStringList texts;
    for (const int number : numbers)
        texts.append(numberText(number, 0));
    return texts.join(u", "_s);
}

}  // namespace

DirectionCard::DirectionCard(Workspace &workspace, QWidget *parent)
    : Card(tr("Directions"), parent)
    , m_workspace(workspace)
    , m_what(new QLabel)
    , m_sees(new QLabel)
    , m_progress(new QProgressBar)
    , m_hands(new SimulatedHands(workspace,
                                 {{tr("as it is held"), 0},
                                  {tr("level"), 1},
                                  {tr("right side down"), 2},
                                  {tr("left side down"), 3},
                                  {tr("nose down"), 4},
                                  {tr("nose up"), 5},
                                  {tr("turned to the right"), 6},
                                  {tr("turned to the left"), 7}},
                                 this, tr("Simulated drone: your hands")))
    , m_same(new QPushButton)
    , m_begin(new QPushButton)
    , m_anew(new QPushButton(tr("From the beginning…")))
    , m_cancel(new QPushButton(tr("Cancel the check")))
    , m_yes(new QPushButton(tr("Yes, those")))
    , m_no(new QPushButton(tr("No, others")))
{
    m_what->setWordWrap(true);
    m_sees->setWordWrap(true);
    m_sees->setObjectName(u"muted"_s);
    setQuiet(*m_progress, tr("Progress of the check"));
    for (QLabel *label : {m_what, m_sees})
        label->setAlignment(Qt::AlignTop);
    // Above what is said: while motors turn they stay where they are.
    auto *buttons = new QHBoxLayout;
    buttons->addWidget(m_same);
    buttons->addWidget(m_begin);
    buttons->addWidget(m_anew);
    buttons->addWidget(m_yes);
    buttons->addWidget(m_no);
    buttons->addStretch();
    buttons->addWidget(m_cancel);
    content()->addLayout(buttons);
    content()->addWidget(m_what);
    content()->addWidget(m_sees);
    content()->addWidget(m_progress);
    content()->addWidget(m_hands);
    connect(m_same, &QPushButton::clicked, this, [this] {
        BoardNaming &naming = m_workspace.naming();
        if (const auto said = naming.choose(naming.name()); !said)
            m_workspace.notifications().report(said.error());
    });
    connect(m_begin, &QPushButton::clicked, this, [this] { begin(found()); });
    connect(m_anew, &QPushButton::clicked, this, [this] { begin({}); });
    connect(m_cancel, &QPushButton::clicked, this, &DirectionCard::cancel);
    connect(m_yes, &QPushButton::clicked, this, [this] { answer(true); });
    connect(m_no, &QPushButton::clicked, this, [this] { answer(false); });
    connect(&workspace.client(), &DeviceClient::stateChanged, this, &DirectionCard::cancel);
    connect(&workspace.naming(), &BoardNaming::changed, this, [this] {
        keepDirectionsByName(m_workspace);
        show();
    });
    connect(&workspace, &Workspace::boardRead, this, [this] { show(); });
    show();
}

CheckedDirections DirectionCard::found() const
{
    if (m_check)
        return m_check->found();
    return checkedDirections(m_workspace);
}

void DirectionCard::begin(const CheckedDirections &known)
{
    if (!m_workspace.client().isConnected() || axesKey(m_workspace).isEmpty())
        return;
    m_check = DirectionCheck(known);
    show();
    emit stepChanged();
}

void DirectionCard::cancel()
{
    if (m_check) {
        // First: its limits go with it.
        emit ending();
        m_hands->putBack();
    }
    m_check.reset();
    show();
    emit stepChanged();
}

void DirectionCard::answer(bool isRight)
{
    if (!m_check)
        return;
    emit worked();
    m_check->answer(isRight);
    feed({}, m_session);
}

void DirectionCard::feed(const DirectionCheck::Axes &sticks, const Session &session)
{
    m_session = session;
    if (!m_check) {
        show();
        return;
    }
    const ChannelRoles &roles = m_workspace.roles();
    DirectionCheck::Axes angles{};
    for (std::size_t axis = 0; axis < kAxisCount; ++axis)
        angles[axis] = m_workspace.latest(roles.angle[axis]);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        if (std::abs(std::remainder(angles[axis] - m_seenAngles[axis], 360.0)) > DirectionCheck::kLevel) {
            m_seenAngles = angles;
            emit worked();
        }
    }
    m_check->feedAngles(angles);
    m_check->feedSticks(sticks);
    QList<double> outputs;
    for (const int motor : roles.motors) {
        const double percent = m_workspace.latest(motor);
        outputs.append(std::isnan(percent) ? 0.0 : percent / kPerCent);
    }
    m_check->setSizes(sizes());
    m_check->feedOutputs(session.isArmed ? outputs : QList<double>());
    const bool isEnded = !m_check->step();
    const bool isNext = std::exchange(m_shownStep, m_check->stepNumber()) != m_check->stepNumber() || isEnded;
    if (isNext)
        keepDirections(m_workspace,
                       isEnded && !m_check->failed() ? withMotors(m_check->found()) : m_check->found());
    if (isEnded) {
        const auto failed = m_check->failed();
        emit ending();
        if (failed)
            m_workspace.notifications().report(
                {tr("%1 answers the wrong way round.").arg(axisLabel(*failed)),
                 *failed == Axis::Yaw ? tr("It would spin as soon as it leaves the ground.")
                                      : tr("It would turn over as soon as it leaves the ground."),
                 tr("Do not fly it. Correct the axes, the motors' places or the mixing in the configuration "
                    "text, then check again."),
                 {}});
        else
            m_workspace.notifications().notify(tr("All directions are known: it may be flown."));
        cancel();
        return;
    }
    show();
    if (isNext)
        emit stepChanged();
}

bool DirectionCard::isAsking() const
{
    return m_check && m_check->isArmedStep() && m_check->sight() == DirectionCheck::Sight::Seen;
}

QList<int> DirectionCard::asked() const
{
    return isAsking() ? m_check->faster() : QList<int>();
}

QString DirectionCard::checkedText() const
{
    const BoardNaming &naming = m_workspace.naming();
    if (!naming.lastingKey().isEmpty())
        return tr("Checked with this drone and this configuration.");
    return naming.name().isEmpty()
        ? tr("Checked, until another connection is made: it has no serial number. With a name (Backups) it "
             "is kept.")
        : tr("Checked, until another connection is made: it has no serial number. If it is “%1”, say so, and "
             "it is kept.")
              .arg(naming.name());
}

// Empty: no check of a drone that looks like this one is known.
QString DirectionCard::presumedText() const
{
    const PresumedDirections presumed = presumedDirections(m_workspace);
    if (presumed.found.level == CheckedDirections::Level::Nothing)
        return {};
    const QString name = m_workspace.naming().name();
    const QString checked = presumed.on.isValid()
        ? tr("Checked for “%1” on %2.").arg(name, numberLocale().toString(presumed.on, QLocale::ShortFormat))
        : tr("Checked for “%1”.").arg(name);
    return checked + u' '
        + tr("Is this the same drone? It has no serial number, and another one may look the same. Until you "
             "say so, or have checked it, it is not armed.");
}

void DirectionCard::showSame()
{
    const BoardNaming &naming = m_workspace.naming();
    m_same->setVisible(!m_check && naming.isNeeded() && !naming.isCertain() && !naming.name().isEmpty());
    m_same->setText(tr("It is “%1”").arg(naming.name()));
}

void DirectionCard::show()
{
    using Level = CheckedDirections::Level;
    const Level level = found().level;
    const QString presumed = level == Level::Nothing ? presumedText() : QString();
    m_what->setText(
        m_check                   ? instruction()
            : !presumed.isEmpty() ? presumed
            : level == Level::All ? checkedText()
            : level == Level::Signs
            ? tr("Angles and sticks are checked; what the motors answer is not.")
            : tr("Not checked. Nothing tells the program which way this drone counts its axes, so "
                 "it is not armed until you have looked."));
    m_sees->setText(m_check ? sees() : level == Level::All ? QString() : handsText());
    m_sees->setVisible(!m_sees->text().isEmpty());
    m_progress->setVisible(m_check.has_value());
    m_progress->setValue(m_check ? kPerCent * m_check->stepNumber() / DirectionCheck::stepCount() : 0);
    m_hands->setVisible(m_check && m_workspace.isSimulated());
    showSame();
    if (!m_check && m_begin->isHidden())
        new ClickShield(*this);  // it takes the place of the last answer
    m_begin->setVisible(!m_check);
    m_begin->setText(level == Level::All || !presumed.isEmpty() ? tr("Check again…")
                         : level == Level::Signs                ? tr("Go on with the check…")
                                                                : tr("Check directions…"));
    m_anew->setVisible(!m_check && level == Level::Signs);
    // Before that its angles are nothing (BCFlight errata 8.2).
    const bool isCalibrated = freshlyTold(m_workspace, m_workspace.roles().calibrated).value_or(false);
    m_begin->setEnabled(!axesKey(m_workspace).isEmpty() && isCalibrated);
    m_anew->setEnabled(m_begin->isEnabled());
    m_begin->setToolTip(isCalibrated ? QString()
                                     : tr("Calibrate it first: its angles are not known before."));
    m_cancel->setVisible(m_check.has_value());
    for (QPushButton *button : {m_yes, m_no}) {
        QSizePolicy policy = button->sizePolicy();
        policy.setRetainSizeWhenHidden(m_check.has_value());
        button->setSizePolicy(policy);
        button->setVisible(isAsking());
    }
}

QString DirectionCard::instruction() const
{
    const auto step = m_check ? m_check->step() : std::nullopt;
    if (!step)
        return {};
    const auto of = [&step](const QString &roll, const QString &pitch, const QString &yaw) {
        return step->axis == Axis::Roll ? roll : step->axis == Axis::Pitch ? pitch : yaw;
    };
    switch (step->kind) {
    case Kind::Tilt:
        return of(tr("Hold it level, then tilt it to its right side."),
                  tr("Hold it level, then tilt its nose down."),
                  tr("Hold it level, then turn its nose to the right, seen from above."));
    case Kind::Stick:
        return of(tr("Push the stick for roll to the right, at least a third of the way, and let go."),
                  tr("Push the stick for pitch forward, at least a third of the way, and let go."),
                  tr("Push the stick for yaw to the right, at least a third of the way, and let go."));
    case Kind::TiltAnswer:
        return of(tr("Armed without propellers, with 5 to 15 % throttle: hold it level, then tilt it to its "
                     "right side."),
                  tr("Armed without propellers, with 5 to 15 % throttle: hold it level, then tilt its nose "
                     "down."),
                  tr("Armed without propellers, with 5 to 15 % throttle: hold it level, then turn its nose "
                     "to the right."))
            + u' ' + handsText();
    case Kind::StickAnswer:
        return of(tr("Hold it level and push the stick for roll to the right, at least a third of the way."),
                  tr("Hold it level and push the stick for pitch forward, at least a third of the way."),
                  tr("Hold it level and push the stick for yaw to the right, at least a third of the way."));
    }
    return {};
}

// The controller works against the hand, and sums up what it does not reach.
QString DirectionCard::handsText() const
{
    return tr("Propellers off: while it is tilted by hand the controller drives motors up to full throttle, "
              "whatever the throttle here says.");
}

QString DirectionCard::question() const
{
    const auto step = m_check->step();
    const QString motors = motorsText(m_check->faster());
    const auto of = [&step](const QString &roll, const QString &pitch, const QString &yaw) {
        return step->axis == Axis::Roll ? roll : step->axis == Axis::Pitch ? pitch : yaw;
    };
    if (step->kind == Kind::TiltAnswer)
        return of(tr("Faster turned: %1. Are those the motors on its right?"),
                  tr("Faster turned: %1. Are those the motors in front?"),
                  tr("Faster turned: %1. Are those the ones that turn clockwise, seen from above?"))
            .arg(motors);
    return of(tr("Faster turned: %1. Are those the motors on its left?"),
              tr("Faster turned: %1. Are those the motors behind?"),
              tr("Faster turned: %1. Are those the ones that turn counter-clockwise, seen from above?"))
        .arg(motors);
}

// What has to be done before motors can answer; empty: nothing.
QString DirectionCard::lacking() const
{
    if (m_session.isOpen && m_session.isHeld)
        return tr("The control session is one for a test stand, with the propellers on. Close it, take the "
                  "propellers off, and open one that says so.");
    if (!m_check->isArmedStep() || m_session.isArmed)
        return {};
    return m_session.isOpen ? tr("Not armed: the session is open; hold the key to arm.")
                            : tr("Not armed: open a control session with the propellers off, then arm.");
}

// As many as the text lets answer, whatever its signs mean.
std::vector<MotorShare> DirectionCard::shares() const
{
    const MotorLayout *layout = m_workspace.tables() ? m_workspace.tables()->motorLayout() : nullptr;
    const ConfigurationModel &shown = m_workspace.configuration();
    return layout && !shown.isEmpty() ? layout->motorShares(shown.board()) : std::vector<MotorShare>();
}

// What was answered tells where the picture's motors are.
CheckedDirections DirectionCard::withMotors(CheckedDirections found) const
{
    const std::vector<MotorShare> all = shares();
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        double sum = 0;
        for (const int motor : m_check->named()[axis])
            sum += motor <= int(all.size()) ? all[std::size_t(motor - 1)].*kParts[axis] : 0;
        found.motors[axis] = sum < 0 ? -1 : 1;
    }
    return found;
}

std::array<int, kAxisCount> DirectionCard::sizes() const
{
    std::array<int, kAxisCount> sizes{};
    const std::vector<MotorShare> shares = this->shares();
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        const auto count = [&](double sign) {
            return int(std::count_if(shares.begin(), shares.end(), [&](const MotorShare &share) {
                return share.*kParts[axis] * sign > 0;
            }));
        };
        sizes[axis] = std::min(count(1), count(-1));
    }
    return sizes;
}

QString DirectionCard::waitsFor(const DirectionCheck::Step &step) const
{
    if (!m_check->isReady())
        return tr("Hold it level and let the sticks go until the motors turn steadily. If they do not, "
                  "disarm and arm again.");
    if (m_check->isStimulated())
        return tr("No motor turns faster than the others yet.");
    const QString degrees = numberText(DirectionCheck::kTilt, 0);
    return step.kind == Kind::TiltAnswer
        ? tr("The motors are compared once it is turned that way by %1°, and less any other way.")
              .arg(degrees)
        : tr("The motors are compared once the stick is pushed that way, at least a third.");
}

QString DirectionCard::sees() const
{
    const auto step = m_check->step();
    if (!step)
        return {};
    const auto sight = m_check->sight();
    if (isAsking())
        return question() + u' '
            + tr("Look at the drone: places and directions in the picture are those of the text, and are "
                 "being checked now.");
    const QString again = m_check->isArmedStep() && m_check->isContradicted()
        ? tr("That contradicts what was answered before: a motor has one place and turns one way. These axes "
             "are asked again.")
            + u' '
        : QString();
    if (const QString text = lacking(); !text.isEmpty())
        return again + text;
    if (m_check->isArmedStep()) {
        if (m_check->isReversed() && !m_check->isReady())
            return tr(
                "Turned round: from now on this stick is sent the other way. Let it go until the motors "
                "turn steadily, then push it again.");
        const QString reversed
            = m_check->isReversed() ? tr("This stick is sent the other way.") + u' ' : QString();
        return again + reversed + waitsFor(*step);
    }
    if (sight == DirectionCheck::Sight::Other)
        return step->kind == Kind::Tilt
            ? tr("Another angle moves more than this one. If it was turned as said, its axes are set up "
                 "wrongly.")
            : tr("Another stick moves, or this one the other way. See how the sticks are mapped.");
    if (sight == DirectionCheck::Sight::Seen)
        return step->kind == Kind::Tilt ? tr("Seen. Put it level again.") : tr("Seen. Let go.");
    return tr("Nothing has moved far enough yet.");
}
