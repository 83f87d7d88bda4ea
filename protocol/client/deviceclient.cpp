// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/client/deviceclient.h"

#include "protocol/client/deviceclient_p.h"
#include "protocol/device/abilities.h"
#include "protocol/device/flight.h"
#include "protocol/device/steering.h"

#include <QLoggingCategory>

#include <algorithm>

using namespace Qt::StringLiterals;

Q_LOGGING_CATEGORY(logClient, "gimbal.client", QtWarningMsg)

namespace {

constexpr auto kStatisticsPeriod = 250ms;
constexpr auto kStopPatience = 1s;
// For a board that is being steered to be seen standing still, before the program ends.
constexpr milliseconds kLongestFarewell = ControlStream::kStopLimit + 1s;

// The part of a stop plan that shows how the board is reached.
QByteArray wayOf(const StopPlan &plan)
{
    QByteArray bytes;
    for (const StopPlan::Means &means : plan.means) {
        for (const Request &request : means.requests)
            bytes += request.bytes;
    }
    return bytes;
}

// Whether data of the one go on as data of the other.
bool isSameBoard(const BoardIdentity &a, const BoardIdentity &b)
{
    return a.family == b.family && a.serial == b.serial && a.firmwareNumber == b.firmwareNumber;
}

}  // namespace

DeviceClient::Private::Private(DeviceClient &client, TransportFactory makeTransport, QList<Family> known)
    : q(client)
    , families(std::move(known))
    , session(new Session(std::move(makeTransport)))
    , worker(new QObject)
    , replay(
          [this](const ReplayControl::Job &job) {
              later([link = session, job] {
                  if (Replay *recording = link->replay())
                      job(*recording);
              });
          },
          [this] {
              if (address.isReplay())
                  q.connectTo(LinkAddress(address), QString(familyKey));
          })
{
    ioThread.setObjectName(u"gimbal-io"_s);
    workerThread.setObjectName(u"gimbal-worker"_s);
    session->addListener(&frames);
    restartTimer = new QTimer(session);
    restartTimer->setInterval(kStatisticsPeriod);
    connect(restartTimer, &QTimer::timeout, session, [this] { lookForRestart(watched); });
    session->moveToThread(&ioThread);
    worker->moveToThread(&workerThread);
    connect(&ioThread, &QThread::finished, session, &QObject::deleteLater);
    connect(&workerThread, &QThread::finished, worker, &QObject::deleteLater);
    connect(
        session, &Session::closed, &q, [this](const Error &why) { onSessionClosed(why); },
        Qt::QueuedConnection);
    connect(session, &Session::failsafeActed, &q, &DeviceClient::failsafeActed, Qt::QueuedConnection);
    connect(
        session, &Session::steeringEnded, &q,
        [this](bool confirmed) {
            // What flies must not go on as it was told last.
            if (!confirmed && state == State::Connected && device->flight())
                stopMotors();
            emit q.steeringEnded(confirmed);
        },
        Qt::QueuedConnection);
    connect(
        session, &Session::motorsStoppedLate, &q, [this] { tellStopped(true); }, Qt::QueuedConnection);
    connect(
        session, &Session::stopForgone, &q,
        [this] {
            stopIsUnproven = false;
            emit q.motorsOffForgone();
        },
        Qt::QueuedConnection);
    stopPatience.setSingleShot(true);
    connect(&stopPatience, &QTimer::timeout, &q, &DeviceClient::motorsOffLate);
    ioThread.start(QThread::TimeCriticalPriority);
    workerThread.start();
    statisticsTimer.setInterval(kStatisticsPeriod);
    connect(&statisticsTimer, &QTimer::timeout, &q, [this] { pollStatistics(); });
    startSupervision();
}

DeviceClient::DeviceClient(
    std::function<Result<std::unique_ptr<Transport>>(const LinkAddress &)> makeTransport,
    QList<Family> families, QObject *parent)
    : QObject(parent)
    , d(std::make_unique<Private>(*this, std::move(makeTransport), std::move(families)))
{
}

DeviceClient::~DeviceClient()
{
    shutDown();
}

DeviceClient::State DeviceClient::state() const
{
    return d->state;
}

void DeviceClient::stopBeforeAsking()
{
    for (Family &family : d->families)
        family.timing.stopsFirst = true;
}

const QList<Family> &DeviceClient::families() const
{
    return d->families;
}

const LinkAddress &DeviceClient::address() const
{
    return d->address;
}

QString DeviceClient::addressText() const
{
    return address().toString();
}

const BoardIdentity &DeviceClient::identity() const
{
    return d->identity;
}

const Device *DeviceClient::device() const
{
    return d->device.get();
}

const ChannelRoles &DeviceClient::roles() const
{
    return d->roles;
}

std::shared_ptr<TelemetryStore> DeviceClient::telemetry() const
{
    return d->store;
}

const TelemetryPlan &DeviceClient::telemetryPlan() const
{
    return d->plan;
}

const LinkStatistics &DeviceClient::statistics() const
{
    return d->statistics;
}

QByteArray DeviceClient::heartbeatBytes() const
{
    const auto family = std::find_if(d->families.begin(), d->families.end(),
                                     [this](const Family &each) { return each.key == identity().family; });
    return family != d->families.end() && family->timing.heartbeat ? family->timing.heartbeat()
                                                                   : QByteArray();
}

QByteArray DeviceClient::pollBytes() const
{
    return d->plan.poll ? d->plan.poll->bytes : QByteArray();
}

const std::optional<LineSettings> &DeviceClient::line() const
{
    return d->line;
}

bool DeviceClient::isBusy() const
{
    return d->jobs > 0;
}

const FrameLog &DeviceClient::frames() const
{
    return d->frames;
}

ReplayControl &DeviceClient::replay()
{
    return d->replay;
}

void DeviceClient::Private::pollStatistics()
{
    later([this] {
        Replay *recording = session->replay();
        back([this, counted = session->statistics(),
              place = recording ? std::optional(recording->state()) : std::nullopt] {
            statistics = counted;
            replay.setState(place);
            emit q.statisticsChanged();
        });
    });
}

void DeviceClient::shutDown()
{
    d->shutDown();
}

void DeviceClient::Private::shutDown()
{
    if (!ioThread.isRunning())
        return;
    supervision.reset();
    statisticsTimer.stop();
    session->disconnect(&q);
    cancelJobs();
    // What it has found already must not begin anything either.
    if (const auto attempt = std::exchange(attemptControl, nullptr))
        attempt->cancel();
    state = State::Disconnected;  // no new work starts
    closing = std::make_shared<QSemaphore>();
    closeSession();
    closing->tryAcquire(1, int(kLongestFarewell.count()));
    // The worker may still wait for the I/O thread, so it goes first.
    workerThread.quit();
    workerThread.wait();
    while (const Delivery next = nextDelivery())
        next();
    now([this] {
        session->removeListener(&frames);
        session->removeListener(feed.get());
        for (FrameListener *listener : foreign)
            session->removeListener(listener);
    });
    ioThread.quit();
    ioThread.wait();
}

void DeviceClient::addListener(FrameListener &listener)
{
    if (!d->ioThread.isRunning())
        return;
    d->foreign.push_back(&listener);
    d->now([this, &listener] { d->session->addListener(&listener); });
}

void DeviceClient::removeListener(FrameListener &listener)
{
    if (std::erase(d->foreign, &listener) == 0 || !d->ioThread.isRunning())
        return;
    d->now([this, &listener] { d->session->removeListener(&listener); });
}

void DeviceClient::connectTo(const LinkAddress &address, const QString &family)
{
    d->disconnectFromBoard();
    d->address = address;
    d->familyKey = family;
    d->replay.forget();
    d->startAttempt(State::Connecting, 0ms);
}

void DeviceClient::disconnectFromBoard()
{
    d->disconnectFromBoard();
}

void DeviceClient::Private::disconnectFromBoard()
{
    cancelJobs();
    if (attemptControl) {
        attemptControl->cancel();
        attemptControl.reset();
    }
    closeSession();
    statisticsTimer.stop();
    later([this] {
        restartTimer->stop();
        watched.reset();
    });
    line.reset();
    setState(State::Disconnected);
}

void DeviceClient::Private::closeSession()
{
    {
        const std::lock_guard lock(urgentMutex);
        stopPlan.reset();
    }
    stopIsUnproven = false;
    if (ioThread.isRunning())
        later([link = session, isClosed = closing] { link->finish([isClosed] { isClosed->release(); }); });
}

void DeviceClient::Private::startAttempt(State next, milliseconds delay)
{
    const auto asked = familiesFor(families, address, familyKey);
    if (!asked) {
        emit q.connectionFailed(asked.error());
        return;
    }
    auto attempt = std::make_shared<Attempt>();
    attempt->search = std::make_unique<BoardSearch>(
        BoardSearch::Order{address, *asked, families, line, next == State::Reconnecting, delay});
    attemptControl = attempt->control;
    setState(next);
    QMetaObject::invokeMethod(
        worker,
        [this, attempt] {
            const auto channel = makeChannel(attempt->control, SessionChannel::Link::NotYet);
            auto found = attempt->search->run(*channel);
            back([this, attempt, found = std::move(found)] { finishAttempt(attempt, found); });
        },
        Qt::QueuedConnection);
}

void DeviceClient::Private::finishAttempt(const std::shared_ptr<Attempt> &attempt,
                                          Result<BoardSearch::Found> found)
{
    if (attempt->control != attemptControl)
        return;  // overtaken by another attempt
    attemptControl.reset();
    if (!found) {
        closeSession();
        setState(State::Disconnected);
        if (found.error().code != ErrorCode::Cancelled)
            emit q.connectionFailed(found.error());
        return;
    }
    device = found->candidate.device;
    familyKey = found->candidate.family.key;  // reconnecting looks for the same family
    if (address.isReplay())
        device->setReadOnly();  // a recording cannot be written to
    const BoardIdentity before = std::exchange(identity, device->identity());
    const bool isKnown = isSameBoard(before, identity);
    const bool isSame = state == State::Reconnecting && isKnown;
    roles = rolesOf(*device);
    line = found->board.line;
    qCInfo(logClient) << "connected to" << identity.model << identity.firmware;

    // A new board gets a new store; the same board continues in its old one.
    if (!store || !isSame)
        store = std::make_shared<TelemetryStore>(int(device->channels().size()));
    store->setReplayed(address.isReplay());
    installFeed(isSame);
    {
        const std::lock_guard lock(urgentMutex);
        stopPlan = device->stopPlan();
    }
    plan = {};
    statistics = {};
    statisticsTimer.start();
    // A recording is watched by who looks at it: there is nothing to stop.
    if (!address.isReplay())
        supervision->begin({store, device, roles, found->candidate.family.nouns.flies});
    setState(State::Connected);
    later([link = session, isKnown] { isKnown ? link->endLeftSteering() : link->forgetLeftSteering(); });
    requestTelemetry();
}

void DeviceClient::cancelJobs()
{
    d->cancelJobs();
}

void DeviceClient::Private::cancelJobs(const Error &why)
{
    control->cancel(why);
    control = std::make_shared<JobControl>();
    cancelMovingJobs(why);
}

void DeviceClient::Private::cancelMovingJobs(const Error &why)
{
    const std::lock_guard lock(urgentMutex);
    // They stay known until they have ended: what nobody can call back goes on moving its motors, and that is
    // no alarm (DeviceClient::Private::startSupervision()).
    for (const auto &moving : movingJobs) {
        if (const auto job = moving.lock())
            job->cancel(why);
    }
}

void DeviceClient::cancelMovingJobs()
{
    d->cancelMovingJobs();
}

void DeviceClient::motorsOff()
{
    d->stopMotors();
}

void DeviceClient::Private::stopMotors(const std::function<void(bool proven)> &proven)
{
    std::optional<StopPlan> wanted;
    {
        const std::lock_guard lock(urgentMutex);
        wanted = stopPlan;
    }
    const auto tell = [this, proven](bool isProven) {
        if (proven)
            proven(isProven);
        back([this, isProven] { tellStopped(isProven); });
    };
    if (!wanted) {
        tell(false);
        return;
    }
    back([this] { tellStopBegun(); });
    later([this, link = session, wanted = std::move(*wanted), tell] {
        link->stopMotors(
            wanted, [tell](const Result<void> &result) { tell(result.has_value()); },
            [this](const Result<void> &result) {
                back([this, restored = result.has_value()] { emit q.motorsOffSettled(restored); });
            });
    });
    cancelMovingJobs();
}

void DeviceClient::Private::tellStopBegun()
{
    const auto left = std::chrono::ceil<milliseconds>(deafUntil - Clock::now());
    stopPatience.start(kStopPatience + std::max(left, 0ms));
    emit q.motorsOffBegun();
    if (left > 0ms)
        emit q.motorsOffQueued(int(left.count()));
}

void DeviceClient::Private::setDeaf(milliseconds duration)
{
    deafUntil = duration > 0ms ? Clock::now() + duration : TimePoint{};
    emit q.deafChanged();
}

TimePoint DeviceClient::deafUntil() const
{
    return d->deafUntil;
}

void DeviceClient::Private::tellStopped(bool isProven)
{
    stopPatience.stop();
    stopIsUnproven = !isProven && state == State::Connected;
    if (isProven && supervision)
        supervision->stopProven();
    emit q.motorsOffFinished(isProven);
}

bool DeviceClient::isStopUnproven() const
{
    return d->stopIsUnproven;
}

bool DeviceClient::areOutputsUnknown() const
{
    return d->device && d->device->flight() && d->store
        && Clock::now() - d->store->latestAt(d->roles.outputs) > kOutputsTold;
}

bool DeviceClient::isSteering() const
{
    bool steers = false;
    if (d->state == State::Connected && d->ioThread.isRunning())
        d->now([this, &steers] { steers = d->session->isSteering(); });
    return steers;
}

void DeviceClient::setControl(const SteeringSetpoint &setpoint, Steers what)
{
    if (d->state != State::Connected || !d->device->steering()
        || (d->device->flight() && what != Steers::FlyingMachine))
        return;
    const ControlFrames wanted = d->device->steering()->controlFrames(setpoint);
    d->steering->take(&wanted);
    d->later([link = d->session, wanted] { link->refreshControl(wanted); });
}

void DeviceClient::releaseControl()
{
    if (d->state != State::Connected)
        return;
    d->steering->take(nullptr);
    d->later([link = d->session] { link->endControl(); });
}

void DeviceClient::Private::setState(State next)
{
    if (std::exchange(state, next) == next)
        return;
    if (next != State::Connected && deafUntil != TimePoint{})
        setDeaf(0ms);
    if (supervision && next != State::Connected)
        supervision->end();
    emit q.stateChanged(next);
}

std::unique_ptr<SessionChannel> DeviceClient::Private::makeChannel(std::shared_ptr<JobControl> job,
                                                                   SessionChannel::Link link)
{
    return std::make_unique<SessionChannel>(
        *session, std::move(job),
        SessionChannel::Hooks{
            [this](const Progress &progress) {
                back([this, progress] { emit q.progressChanged(progress); });
            },
            [this](bool proven) { back([this, proven] { tellStopped(proven); }); },
            [note = steering](const ControlFrames *wanted) { note->take(wanted); },
            [this](milliseconds duration) { back([this, duration] { setDeaf(duration); }); }},
        link);
}

void DeviceClient::enqueue(Job job, JobKind kind)
{
    if (d->state != State::Connected) {
        job(nullptr, nullptr, {ErrorCode::NotConnected, {}})();
        return;
    }
    // A moving job has its own control, so that stopping it does not cancel a write.
    auto control = kind == JobKind::Moving ? std::make_shared<JobControl>() : d->control;
    if (kind == JobKind::Moving) {
        const std::lock_guard lock(d->urgentMutex);
        d->movingJobs.push_back(control);
    }
    if (++d->jobs == 1)
        emit busyChanged(true);
    QMetaObject::invokeMethod(
        d->worker,
        [this, control, device = d->device, job = std::move(job)] {
            const auto channel = d->makeChannel(control, SessionChannel::Link::Open);
            const bool cancelled = channel->cancelled();
            d->deliverLater(
                job(cancelled ? nullptr : channel.get(), device.get(), cancelled ? control->why() : Error()));
        },
        Qt::QueuedConnection);
}

// Qt 6.4 runs a continuation twice, the second time without what it holds, if it is attached on one thread
// while another finishes the future. So the thread that attaches them finishes them, too.
void DeviceClient::Private::deliverLater(Delivery delivery)
{
    {
        const std::lock_guard lock(urgentMutex);
        deliveries.push_back(std::move(delivery));
    }
    back([this] {
        if (const Delivery next = nextDelivery()) {
            jobFinished();
            next();
        }
    });
}

DeviceClient::Delivery DeviceClient::Private::nextDelivery()
{
    const std::lock_guard lock(urgentMutex);
    if (deliveries.empty())
        return {};
    Delivery next = std::move(deliveries.front());
    deliveries.pop_front();
    return next;
}

void DeviceClient::Private::jobFinished()
{
    if (--jobs == 0)
        emit q.busyChanged(false);
    if (state == State::Connected)
        followWay();
}

// A job may have changed how the board is reached: what is sent outside of jobs has to follow.
void DeviceClient::Private::followWay()
{
    StopPlan fresh = device->stopPlan();
    {
        const std::lock_guard lock(urgentMutex);
        if (!stopPlan || wayOf(*stopPlan) == wayOf(fresh))
            return;
        stopPlan = std::move(fresh);
    }
    requestTelemetry();
}
