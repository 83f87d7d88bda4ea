// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/device/deviceclient.h"

#include "protocol/device/telemetryfeed.h"

#include <QLoggingCategory>

#include <algorithm>

using namespace Qt::StringLiterals;

Q_LOGGING_CATEGORY(logClient, "gimbal.client", QtWarningMsg)

namespace {

constexpr auto kReconnectPause = 500ms;
constexpr auto kStatisticsPeriod = 250ms;
// A board that announces its restart still talks for up to a second (document CMD_RESET); we let go before it
// does.
constexpr auto kLetGoBeforeReset = 300ms;
constexpr auto kRestartTime = 1500ms;

// The board may be one of another family, or speak at another rate.
bool isNotHere(ErrorCode code)
{
    return code == ErrorCode::Silent || code == ErrorCode::Garbage || code == ErrorCode::WrongProtocol;
}

}  // namespace

/// One series of attempts to get a board: the first connection, or reconnecting until it succeeds.
struct DeviceClient::Attempt
{
    struct Candidate
    {
        QString family;
        QStringList speaks;
        std::shared_ptr<Device> device;
    };
    std::vector<Candidate> candidates;
    std::optional<Candidate> chosen;
    std::shared_ptr<JobControl> control;
    LinkAddress address;
    std::optional<LineSettings> knownLine;
    bool repeat = false;
    milliseconds delay{};

    Result<FoundBoard> ask(const Candidate &candidate, SessionChannel &channel, bool useKnownLine,
                           Search search = Search::AllRates)
    {
        LinkAddress target = address;
        if (useKnownLine && knownLine && address.kind() == LinkAddress::Kind::Serial)
            target = LinkAddress::serial(address.target(), knownLine->baud, knownLine->parity);
        if (auto opened = channel.open(target, candidate.device->makeFramer()); !opened)
            return tl::unexpected(opened.error());
        auto found = findBoard(channel, *candidate.device, target, search);
        if (found)
            chosen = candidate;
        return found;
    }

    // One family after the other. Where one is recognised by its bytes it is asked next; where nothing at all
    // came, nobody of them is there (a recording answers nobody but its own).
    Result<FoundBoard> once(SessionChannel &channel, bool useKnownLine)
    {
        std::optional<Error> first;
        // On a serial line each family is asked at its usual rate before any other rate is tried: a board
        // that cannot answer the first one's question is found in two seconds instead of after all its rates.
        const bool searches
            = candidates.size() > 1 && address.kind() == LinkAddress::Kind::Serial && !address.baud();
        for (const Candidate &candidate : candidates) {
            if (!searches || (useKnownLine && knownLine))
                break;
            auto found = ask(candidate, channel, useKnownLine, Search::UsualRate);
            if (found || !isNotHere(found.error().code))
                return found;
        }
        for (const Candidate &candidate : candidates) {
            auto found = ask(candidate, channel, useKnownLine);
            if (found || found.error().code == ErrorCode::Cancelled)
                return found;
            const Error error = found.error();
            if (!first || first->code == ErrorCode::Garbage)
                first = error;
            const auto named
                = std::find_if(candidates.begin(), candidates.end(), [&error](const Candidate &each) {
                      return error.code == ErrorCode::WrongProtocol && each.speaks.contains(error.detail);
                  });
            if (named != candidates.end() && &*named != &candidate)
                return ask(*named, channel, useKnownLine);
            const bool nobody = error.code != ErrorCode::Garbage && error.code != ErrorCode::Timeout;
            if (nobody && !address.isReplay())
                break;
        }
        return tl::unexpected(first.value_or(Error{ErrorCode::InvalidArgument, {}}));
    }

    Result<FoundBoard> run(SessionChannel &channel)
    {
        if (const auto slept = channel.sleep(delay); !slept)
            return tl::unexpected(slept.error());
        for (int round = 0;; ++round) {
            // Every third round looks at all rates again: a changed serial speed takes effect with a restart.
            auto found = once(channel, repeat && round % 3 != 2);
            if (found || !repeat || found.error().code == ErrorCode::Cancelled)
                return found;
            if (const auto slept = channel.sleep(kReconnectPause); !slept)
                return tl::unexpected(slept.error());
        }
    }
};

DeviceClient::DeviceClient(TransportFactory makeTransport, QList<Family> families, QObject *parent)
    : QObject(parent)
    , m_makeTransport(std::move(makeTransport))
    , m_families(std::move(families))
    , m_session(new Session(m_makeTransport))
    , m_worker(new QObject)
{
    m_ioThread.setObjectName(u"gimbal-io"_s);
    m_workerThread.setObjectName(u"gimbal-worker"_s);
    m_session->addListener(&m_frames);
    m_session->moveToThread(&m_ioThread);
    m_worker->moveToThread(&m_workerThread);
    connect(&m_ioThread, &QThread::finished, m_session, &QObject::deleteLater);
    connect(&m_workerThread, &QThread::finished, m_worker, &QObject::deleteLater);
    connect(m_session, &Session::closed, this, &DeviceClient::onSessionClosed, Qt::QueuedConnection);
    m_ioThread.start(QThread::TimeCriticalPriority);
    m_workerThread.start();

    m_statisticsTimer.setInterval(kStatisticsPeriod);
    connect(&m_statisticsTimer, &QTimer::timeout, this, [this] {
        QMetaObject::invokeMethod(
            m_session,
            [this, session = m_session] {
                const LinkStatistics now = session->statistics();
                QMetaObject::invokeMethod(
                    this,
                    [this, now] {
                        const bool rescued = now.deadManRescues > m_statistics.deadManRescues;
                        m_statistics = now;
                        emit statisticsChanged();
                        if (rescued)
                            emit controlRescued();
                    },
                    Qt::QueuedConnection);
            },
            Qt::QueuedConnection);
    });
}

DeviceClient::~DeviceClient()
{
    shutDown();
}

void DeviceClient::shutDown()
{
    if (!m_ioThread.isRunning())
        return;
    m_statisticsTimer.stop();
    m_session->disconnect(this);
    cancelJobs();
    if (m_attemptControl)
        m_attemptControl->cancel();
    m_state = State::Disconnected;  // nothing new is begun
    closeSession();
    // The worker may still wait for the I/O thread, so it goes first.
    m_workerThread.quit();
    m_workerThread.wait();
    QMetaObject::invokeMethod(
        m_session,
        [this] {
            m_session->removeListener(&m_frames);
            m_session->removeListener(m_feed.get());
            for (FrameListener *listener : m_foreign)
                m_session->removeListener(listener);
        },
        Qt::BlockingQueuedConnection);
    m_ioThread.quit();
    m_ioThread.wait();
}

void DeviceClient::addListener(FrameListener &listener)
{
    if (!m_ioThread.isRunning())
        return;
    m_foreign.push_back(&listener);
    QMetaObject::invokeMethod(
        m_session, [this, &listener] { m_session->addListener(&listener); }, Qt::BlockingQueuedConnection);
}

void DeviceClient::removeListener(FrameListener &listener)
{
    if (std::erase(m_foreign, &listener) == 0 || !m_ioThread.isRunning())
        return;
    QMetaObject::invokeMethod(
        m_session, [this, &listener] { m_session->removeListener(&listener); }, Qt::BlockingQueuedConnection);
}

void DeviceClient::connectTo(const LinkAddress &address, const QString &family)
{
    disconnectFromBoard();
    m_address = address;
    m_familyKey = family;
    m_replayFrom = 0;
    m_replaySpeed.reset();
    m_replayPaused = false;
    startAttempt(State::Connecting, 0ms);
}

void DeviceClient::disconnectFromBoard()
{
    cancelJobs();
    if (m_attemptControl) {
        m_attemptControl->cancel();
        m_attemptControl.reset();
    }
    closeSession();
    m_statisticsTimer.stop();
    m_line.reset();
    setState(State::Disconnected);
}

void DeviceClient::closeSession()
{
    {
        const std::lock_guard lock(m_urgentMutex);
        m_motorsOff.reset();
    }
    if (!m_ioThread.isRunning())
        return;
    QMetaObject::invokeMethod(
        m_session,
        [session = m_session] {
            session->close({ErrorCode::Cancelled, {}});
        },
        Qt::QueuedConnection);
}

void DeviceClient::startAttempt(State state, milliseconds delay)
{
    auto attempt = std::make_shared<Attempt>();
    const bool simulated = m_address.kind() == LinkAddress::Kind::Simulator;
    const QString wanted = m_familyKey.isEmpty() && simulated ? m_address.target() : m_familyKey;
    for (const Family &family : std::as_const(m_families)) {
        if (wanted.isEmpty() || family.key == wanted)
            attempt->candidates.push_back({family.key, family.speaks, family.makeDevice()});
    }
    if (attempt->candidates.empty()) {
        emit connectionFailed({ErrorCode::InvalidArgument, u"family %1"_s.arg(wanted)});
        return;
    }
    attempt->control = std::make_shared<JobControl>();
    attempt->address = m_address;
    attempt->knownLine = m_line;
    attempt->repeat = state == State::Reconnecting;
    attempt->delay = delay;
    m_attemptControl = attempt->control;
    setState(state);
    QMetaObject::invokeMethod(
        m_worker,
        [this, attempt] {
            const auto channel = makeChannel(attempt->control);
            auto found = attempt->run(*channel);
            QMetaObject::invokeMethod(
                this, [this, attempt, found = std::move(found)] { finishAttempt(attempt, found); },
                Qt::QueuedConnection);
        },
        Qt::QueuedConnection);
}

void DeviceClient::finishAttempt(const std::shared_ptr<Attempt> &attempt, Result<FoundBoard> found)
{
    if (attempt->control != m_attemptControl)
        return;  // overtaken by another attempt
    m_attemptControl.reset();
    if (!found) {
        closeSession();
        setState(State::Disconnected);
        if (found.error().code != ErrorCode::Cancelled)
            emit connectionFailed(found.error());
        return;
    }
    m_device = attempt->chosen->device;
    m_familyKey = attempt->chosen->family;  // it stays the one when the link comes back
    if (m_address.isReplay())
        m_device->setReadOnly();  // what happened cannot be changed
    m_identity = m_device->identity();
    m_line = found->line;
    qCInfo(logClient) << "connected to" << m_identity.model << m_identity.firmware;

    // A fresh store for a new board; the same board goes on in the same one.
    if (!m_store || m_state != State::Reconnecting)
        m_store = std::make_shared<TelemetryStore>(int(m_device->channels().size()));
    m_store->setReplayed(m_address.isReplay());
    auto feed = std::make_unique<TelemetryFeed>(
        m_store, [device = m_device](const FrameView &frame) { return device->announcesReset(frame); },
        [this] { QMetaObject::invokeMethod(this, &DeviceClient::onResetAnnounced, Qt::QueuedConnection); },
        [this, device = m_device](const FrameView &frame) {
            if (const QString text = device->spokenText(frame); !text.isEmpty())
                QMetaObject::invokeMethod(
                    this, [this, text] { emit boardSpoke(text); }, Qt::QueuedConnection);
        });
    QMetaObject::invokeMethod(
        m_session,
        [this, fresh = feed.get(), old = m_feed.get()] {
            m_session->removeListener(old);
            m_session->addListener(fresh);
        },
        Qt::BlockingQueuedConnection);
    m_feed = std::move(feed);
    {
        const std::lock_guard lock(m_urgentMutex);
        m_motorsOff = m_device->motorsOffRequest();
    }
    m_plan = {};
    m_statistics = {};
    m_statisticsTimer.start();
    setState(State::Connected);
    requestTelemetry();
}

void DeviceClient::onSessionClosed(const Error &why)
{
    if (m_state != State::Connected)
        return;
    emit connectionLost(why);
    // Jobs that waited for this link are told; they must not start on the next one by surprise.
    cancelJobs();
    startAttempt(State::Reconnecting, why.code == ErrorCode::Cancelled ? 0ms : kReconnectPause);
}

void DeviceClient::onResetAnnounced()
{
    if (m_state != State::Connected)
        return;
    QTimer::singleShot(kLetGoBeforeReset, this, [this] {
        if (m_state != State::Connected)
            return;
        emit connectionLost({ErrorCode::LinkClosed, u"the board restarts"_s});
        QMetaObject::invokeMethod(
            m_session,
            [session = m_session] {
                session->close({ErrorCode::LinkClosed, u"the board restarts"_s});
            },
            Qt::QueuedConnection);
        cancelJobs();
        startAttempt(State::Reconnecting, kRestartTime);
    });
}

void DeviceClient::cancelJobs()
{
    m_control->cancel();
    m_control = std::make_shared<JobControl>();
    const std::lock_guard lock(m_urgentMutex);
    for (const auto &moving : std::exchange(m_movingJobs, {})) {
        if (const auto control = moving.lock())
            control->cancel();
    }
}

void DeviceClient::motorsOff()
{
    std::optional<Request> request;
    {
        const std::lock_guard lock(m_urgentMutex);
        request = m_motorsOff;
    }
    if (!request) {
        QMetaObject::invokeMethod(
            this, [this] { emit motorsOffFinished(false); }, Qt::QueuedConnection);
        return;
    }
    QMetaObject::invokeMethod(
        m_session,
        [this, session = m_session, request = *request] {
            session->sendUrgent(request, [this](const Result<Frame> &result) {
                const bool confirmed = result.has_value();
                QMetaObject::invokeMethod(
                    this, [this, confirmed] { emit motorsOffFinished(confirmed); }, Qt::QueuedConnection);
            });
        },
        Qt::QueuedConnection);
    const std::lock_guard lock(m_urgentMutex);
    for (const auto &moving : std::exchange(m_movingJobs, {})) {
        if (const auto control = moving.lock())
            control->cancel();
    }
}

void DeviceClient::setControl(const ControlSetpoint &setpoint)
{
    if (m_state != State::Connected)
        return;
    QMetaObject::invokeMethod(
        m_session,
        [session = m_session, frames = m_device->controlFrames(setpoint)] {
            session->refreshControl(frames);
        },
        Qt::QueuedConnection);
}

void DeviceClient::releaseControl()
{
    if (m_state != State::Connected)
        return;
    QMetaObject::invokeMethod(
        m_session, [session = m_session] { session->endControl(); }, Qt::QueuedConnection);
}

void DeviceClient::setTelemetry(const TelemetryWish &wish)
{
    if (wish == m_wish)
        return;
    m_wish = wish;
    requestTelemetry();
}

void DeviceClient::requestTelemetry()
{
    if (m_state != State::Connected || m_telemetryRequested)
        return;
    if (m_address.isReplay()) {
        startReplay();
        return;
    }
    TelemetryWish wish = m_wish;
    if (const auto refused = refusal(wish)) {
        emit telemetryFailed(*refused);
        if (m_plan.decoder)
            return;  // what was arranged before goes on
        wish.streams.clear();
    }
    // Several wishes in one round of the event loop make one request.
    m_telemetryRequested = true;
    // While streams are rearranged, missing samples are nobody's loss.
    QMetaObject::invokeMethod(
        m_session, [feed = m_feed.get()] { feed->setDecoder(nullptr); }, Qt::BlockingQueuedConnection);
    submit<TelemetryPlan>([wish, line = m_line](Channel &channel, Device &device) {
        return device.startTelemetry(channel, wish, line);
    }).then(this, [this, asked = m_wish](const Result<TelemetryPlan> &plan) {
        m_telemetryRequested = false;
        if (!plan) {
            if (plan.error().code == ErrorCode::Cancelled)
                requestTelemetry();  // somebody cancelled all jobs; telemetry is still wanted
            else if (plan.error().code != ErrorCode::LinkClosed)
                emit telemetryFailed(plan.error());
            return;
        }
        m_plan = *plan;
        QMetaObject::invokeMethod(
            m_session,
            [session = m_session, feed = m_feed.get(), plan = *plan] {
                feed->setDecoder(plan.decoder);
                session->setPoll(plan.poll, plan.pollInterval);
                session->setFarewell(plan.farewell);
            },
            Qt::BlockingQueuedConnection);
        emit telemetryPlanChanged();
        if (m_wish != asked)
            requestTelemetry();
    });
}

// Streams that the line cannot carry are not asked for.
std::optional<Error> DeviceClient::refusal(const TelemetryWish &wish) const
{
    const auto budget = m_device->streamBudget(wish, m_line);
    if (!budget)
        return budget.error();
    return budget->fits() ? std::nullopt : std::optional(budget->refusal());
}

// A recording has the streams that it has: nobody can be asked for others.
void DeviceClient::startReplay()
{
    if (m_plan.decoder)
        return;
    m_plan.decoder = m_device->replayDecoder();
    m_plan.streaming = true;
    QMetaObject::invokeMethod(
        m_session,
        [session = m_session, feed = m_feed.get(), decoder = m_plan.decoder] {
            feed->setDecoder(decoder);
            session->play();
        },
        Qt::BlockingQueuedConnection);
    emit telemetryPlanChanged();
    if (m_replaySpeed)
        setReplaySpeed(*m_replaySpeed);
    if (m_replayFrom > 0)
        seekReplay(m_replayFrom);
    setReplayPaused(m_replayPaused);
}

void DeviceClient::setReplayPaused(bool paused)
{
    m_replayPaused = paused;
    QMetaObject::invokeMethod(
        m_session, [session = m_session, paused] { session->setReplayPaused(paused); }, Qt::QueuedConnection);
}

void DeviceClient::setReplaySpeed(double speed)
{
    m_replaySpeed = speed;
    QMetaObject::invokeMethod(
        m_session, [session = m_session, speed] { session->setReplaySpeed(speed); }, Qt::QueuedConnection);
}

void DeviceClient::seekReplay(double seconds)
{
    if (!m_address.isReplay())
        return;
    if (m_state == State::Connected && m_plan.decoder
        && (!m_statistics.replay || seconds >= m_statistics.replay->position)) {
        QMetaObject::invokeMethod(
            m_session, [session = m_session, seconds] { session->forwardReplay(seconds); },
            Qt::QueuedConnection);
        return;
    }
    const auto speed = m_replaySpeed;
    const bool paused = m_replayPaused;
    connectTo(LinkAddress(m_address), QString(m_familyKey));
    m_replayFrom = seconds;
    m_replaySpeed = speed;
    m_replayPaused = paused;
}

void DeviceClient::setState(State state)
{
    if (m_state == state)
        return;
    m_state = state;
    emit stateChanged(state);
}

std::unique_ptr<SessionChannel> DeviceClient::makeChannel(std::shared_ptr<JobControl> control)
{
    return std::make_unique<SessionChannel>(*m_session, std::move(control), [this](const Progress &progress) {
        QMetaObject::invokeMethod(
            this, [this, progress] { emit progressChanged(progress); }, Qt::QueuedConnection);
    });
}

void DeviceClient::jobStarted()
{
    if (++m_jobs == 1)
        emit busyChanged(true);
}

void DeviceClient::jobFinished()
{
    if (--m_jobs == 0)
        emit busyChanged(false);
    if (m_state == State::Connected)
        followWay();
}

// A job may have changed how the board is spoken to: what is sent without a job follows.
void DeviceClient::followWay()
{
    const Request off = m_device->motorsOffRequest();
    {
        const std::lock_guard lock(m_urgentMutex);
        if (!m_motorsOff || m_motorsOff->bytes == off.bytes)
            return;
        m_motorsOff = off;
    }
    requestTelemetry();
}
