// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/client/supervision.h"

#include "protocol/device/device.h"

#include <QLoggingCategory>

#include <algorithm>
#include <utility>

using namespace Qt::StringLiterals;

Q_LOGGING_CATEGORY(logSupervisor, "gimbal.supervisor", QtWarningMsg)

namespace {

constexpr auto kTick = 20ms;
constexpr auto kSteeringLasts = 400ms;  // since the last set-point; they are repeated every 250 ms or sooner
constexpr double kMissingAtFirst = 3.0;  // seconds
constexpr double kMissingEvery = 1.0;
constexpr double kHelpTime = 1.5;  // seconds after which a change that was taken back has to have helped

// What becomes of a stop is told even when what it was for is over.
bool isStopOpen(const AlarmReport &report)
{
    return report.action == AlarmAction::MotorsOff
        && (report.outcome == AlarmOutcome::Acting || report.outcome == AlarmOutcome::NotProven);
}

}  // namespace

Supervision::Supervision(Hooks hooks)
    : m_hooks(std::move(hooks))
    , m_watcher(new QObject)
    , m_rescuer(new QObject)
    , m_timer(new QTimer(m_watcher))
{
    m_door->watcher = m_watcher;
    m_thread.setObjectName(u"gimbal-supervisor"_s);
    m_rescueThread.setObjectName(u"gimbal-rescue"_s);
    m_watcher->moveToThread(&m_thread);
    m_rescuer->moveToThread(&m_rescueThread);
    QObject::connect(&m_thread, &QThread::finished, m_watcher, &QObject::deleteLater);
    QObject::connect(&m_rescueThread, &QThread::finished, m_rescuer, &QObject::deleteLater);
    m_timer->setTimerType(Qt::PreciseTimer);
    m_timer->setInterval(kTick);
    QObject::connect(m_timer, &QTimer::timeout, m_watcher, [this] { tick(); });
    m_thread.start(QThread::HighPriority);
    m_rescueThread.start(QThread::HighPriority);
}

Supervision::~Supervision()
{
    {
        const std::lock_guard lock(m_door->mutex);
        m_door->watcher = nullptr;
    }
    m_control->cancel();
    for (QThread *thread : {&m_rescueThread, &m_thread}) {
        thread->quit();
        thread->wait();
    }
}

void Supervision::setRules(const SupervisorRules &rules)
{
    QMetaObject::invokeMethod(
        m_watcher,
        [this, rules] {
            m_rules = rules;
            if (m_supervisor)
                m_supervisor->setRules(rules);
        },
        Qt::QueuedConnection);
}

void Supervision::begin(const Board &board)
{
    m_steering->take(nullptr);
    QMetaObject::invokeMethod(
        m_watcher, [this, board] { start(board); }, Qt::QueuedConnection);
}

void Supervision::end()
{
    QMetaObject::invokeMethod(
        m_watcher,
        [this] {
            m_timer->stop();
            m_board.reset();
            m_supervisor.reset();
            m_source.reset();
            m_helps.clear();
            m_missing.clear();
            if (!std::exchange(m_toldMissing, {}).empty() && m_hooks.unwatched)
                m_hooks.unwatched({});
            // What is told of a board that is gone is over.
            for (AlarmReport &report : m_reports) {
                report.isOver = true;
                tell(report);
            }
            m_reports.clear();
        },
        Qt::QueuedConnection);
}

void Supervision::stopProven()
{
    QMetaObject::invokeMethod(
        m_watcher,
        [this] {
            for (AlarmReport &report : m_reports) {
                if (report.outcome != AlarmOutcome::NotProven)
                    continue;
                report.outcome = AlarmOutcome::Done;
                tell(report);
            }
            forgetSettled();
        },
        Qt::QueuedConnection);
}

void SteeringNote::take(const ControlFrames *frames)
{
    const bool isSteered = frames && !frames->setpoint.isEmpty();
    for (std::size_t axis = 0; isSteered && axis < kAxisCount; ++axis)
        to[axis] = frames->angles[axis];
    at = isSteered ? Clock::now().time_since_epoch().count() : Duration::rep{};
}

void Supervision::start(const Board &board)
{
    m_board = board;
    m_supervisor = std::make_unique<Supervisor>();
    m_supervisor->setRules(m_rules);
    ChannelRoles roles = board.roles;
    // What flies goes where it is steered to. Where it does not tell its targets, they are not guessed.
    if (board.flies && ChannelRoles::present({roles.target}).isEmpty())
        roles.angle.fill(-1);
    m_source = std::make_unique<SupervisedStore>(board.store, board.device, roles);
    m_source->skip();  // what came over an earlier link
    m_possible = Supervisor::possible(roles);
    m_nextMissing = m_source->now() + kMissingAtFirst;
    m_missing.clear();
    m_timer->start();
}

SupervisedSituation Supervision::situation()
{
    SupervisedSituation now = m_source->situation();
    now.isSteered = Clock::now() - TimePoint(Duration(m_steering->at.load())) < kSteeringLasts;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis)
        now.steeredTo[axis] = m_steering->to[axis];
    now.isProcedure = m_hooks.isMoving();
    now.period = m_period;
    return now;
}

void Supervision::tick()
{
    if (!m_supervisor)
        return;
    m_supervisor->setSituation(situation());
    m_source->feed(*m_supervisor);
    m_supervisor->look(m_source->now());
    for (const Alarm &alarm : m_supervisor->takeRaised())
        act(alarm);
    followUp();
    lookWhatIsMissing();
    for (const Alarm &alarm : m_supervisor->takeEnded()) {
        for (auto it = m_reports.begin(); it != m_reports.end();) {
            if (it->isOver || !it->alarm.isSame(alarm)) {
                ++it;
                continue;
            }
            it->isOver = it->wasSeenToEnd = true;
            tell(*it);
            std::erase_if(m_helps, [it](const auto &help) { return help.first == it->number; });
            it = isStopOpen(*it) ? std::next(it) : m_reports.erase(it);
        }
    }
}

void Supervision::act(const Alarm &alarm)
{
    AlarmReport report;
    report.number = ++m_count;
    report.alarm = alarm;
    report.at = QDateTime::currentDateTime();
    const AlarmAction wanted
        = m_board->flies || alarm.mayBeMeant ? AlarmAction::Warn : m_rules.action(alarm.kind);
    qCInfo(logSupervisor) << "alarm" << int(alarm.kind) << "axis" << int(alarm.axis) << "value" << alarm.value
                          << "action" << int(wanted);
    report.action = wanted;
    const bool takesBack = wanted == AlarmAction::TakeBack || wanted == AlarmAction::TakeBackElseOff;
    const bool hasChange
        = alarm.isAfterChange && m_board->device->live() && m_board->device->identity().writable;
    if (takesBack && !hasChange) {
        report.outcome = AlarmOutcome::NoChange;
        report.alarm = Supervisor::withoutChange(report.alarm);
        if (wanted == AlarmAction::TakeBack)
            report.action = AlarmAction::Warn;
    }
    m_reports.push_back(report);
    if (takesBack && hasChange)
        takeBackFor(report);
    else if (wanted == AlarmAction::MotorsOff || wanted == AlarmAction::TakeBackElseOff)
        stopFor(report);
    else
        tell(report);
}

void Supervision::stopFor(AlarmReport report)
{
    report.action = AlarmAction::MotorsOff;
    report.outcome = AlarmOutcome::Acting;
    if (AlarmReport *kept = find(report.number))
        *kept = report;
    m_hooks.stop([this, door = m_door, number = report.number](bool proven) {
        const std::lock_guard lock(door->mutex);
        if (!door->watcher)
            return;
        QMetaObject::invokeMethod(
            door->watcher,
            [this, number, proven] {
                if (AlarmReport *known = find(number)) {
                    known->outcome = proven ? AlarmOutcome::Done : AlarmOutcome::NotProven;
                    tell(*known);
                    forgetSettled();
                }
            },
            Qt::QueuedConnection);
    });
    tell(report);
}

void Supervision::takeBackFor(const AlarmReport &report)
{
    if (AlarmReport *kept = find(report.number)) {
        kept->outcome = AlarmOutcome::Acting;
        tell(*kept);
    }
    QMetaObject::invokeMethod(
        m_rescuer,
        [this, number = report.number, device = m_board->device] {
            const auto channel = m_hooks.makeChannel(m_control);
            const auto change = device->live()->takeBack(*channel);
            QMetaObject::invokeMethod(
                m_watcher, [this, number, change] { tookBack(number, change); }, Qt::QueuedConnection);
        },
        Qt::QueuedConnection);
}

void Supervision::tookBack(int number, const Result<LiveChange> &change)
{
    AlarmReport *report = find(number);
    if (!report || !m_supervisor)
        return;
    if (change) {
        report->change = *change;
        report->outcome = AlarmOutcome::Done;
        m_helps.emplace_back(number, m_source->now() + kHelpTime);
        tell(*report);
        return;
    }
    report->outcome = change.error().code == ErrorCode::Conflict ? AlarmOutcome::Conflict
        : change.error().code == ErrorCode::NoEffect             ? AlarmOutcome::NoChange
                                                                 : AlarmOutcome::Failed;
    if (report->outcome == AlarmOutcome::NoChange)
        report->alarm = Supervisor::withoutChange(report->alarm);
    if (report->action == AlarmAction::TakeBackElseOff)
        stopFor(*report);
    else
        tell(*report);
}

// A change that was taken back has to have helped after a while. What is quiet by then is followed until it
// is over, or is heard again.
void Supervision::followUp()
{
    const double now = m_source->now();
    for (auto it = m_helps.begin(); it != m_helps.end();) {
        AlarmReport *report = find(it->first);
        if (report && (now < it->second || m_supervisor->isAbsent(report->alarm))) {
            ++it;
            continue;
        }
        if (report) {
            report->outcome = AlarmOutcome::GoesOn;
            report->alarm = Supervisor::withoutChange(report->alarm);
            if (report->action == AlarmAction::TakeBackElseOff)
                stopFor(*report);
            else
                tell(*report);
        }
        it = m_helps.erase(it);
    }
}

// Told when it has been the same twice, because data pause while streams are arranged anew.
void Supervision::lookWhatIsMissing()
{
    const double now = m_source->now();
    if (now < m_nextMissing)
        return;
    m_nextMissing = now + kMissingEvery;
    const std::vector<Unwatched> missing = m_supervisor->unwatched(m_possible, now);
    if (missing == std::exchange(m_missing, missing) && missing != m_toldMissing && m_hooks.unwatched) {
        m_toldMissing = missing;
        m_hooks.unwatched(missing);
    }
}

void Supervision::forgetSettled()
{
    std::erase_if(m_reports, [](const AlarmReport &report) { return report.isOver && !isStopOpen(report); });
}

AlarmReport *Supervision::find(int number)
{
    const auto it = std::find_if(m_reports.begin(), m_reports.end(),
                                 [number](const AlarmReport &report) { return report.number == number; });
    return it == m_reports.end() ? nullptr : &*it;
}

void Supervision::tell(const AlarmReport &report)
{
    m_hooks.report(report);
}
