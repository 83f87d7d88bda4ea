// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/workspace.h"

#include "protocol/procedure/writeconfiguration.h"

#include <QSet>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

// Older than this, telemetry says nothing about now.
constexpr auto kStale = 1500ms;

} // namespace

Workspace::Workspace(TransportFactory transports, QList<Family> families, Theme &theme, QObject *parent)
    : QObject(parent)
    , m_theme(theme)
    , m_client(std::move(transports), std::move(families))
    , m_edits(m_configuration)
{
    connect(&m_client, &DeviceClient::stateChanged, this, &Workspace::onState);
    connect(&m_client, &DeviceClient::connectionFailed, this, [this](const Error &error) {
        emit problem(describe(error));
    });
    connect(&m_client, &DeviceClient::connectionLost, this, [this](const Error &error) {
        m_wasLost = true;
        ErrorText text = describe(error);
        if (m_configuration.changeCount() > 0)
            text.cure += tr(" Unsaved changes are kept.");
        emit problem(text);
    });
    connect(&m_client, &DeviceClient::telemetryFailed, this, [this](const Error &error) {
        ErrorText text = describe(error);
        text.what = tr("Live data could not be started. ") + text.what;
        emit problem(text);
    });
    connect(&m_client, &DeviceClient::motorsOffFinished, this, [this](bool confirmed) {
        if (confirmed) {
            emit notice(tr("Motors are off."));
            return;
        }
        emit problem({tr("The board did not confirm that the motors are off."), tr("They may still be running."),
                      tr("Hold the camera and disconnect the power."), {}});
    });
    connect(&m_client, &DeviceClient::controlRescued, this, [this] {
        emit notice(tr("Control was released because the program did not refresh it in time."));
    });
    connect(&m_client, &DeviceClient::statisticsChanged, this, &Workspace::followActiveProfile);
}

void Workspace::connectTo(const LinkAddress &address, const QString &family)
{
    m_client.connectTo(address, family);
}

void Workspace::onState(DeviceClient::State state)
{
    if (state != DeviceClient::State::Connected)
        return;
    // Another board, or one that may have been changed meanwhile: the next write makes its own safety copy.
    m_backupDone = false;
    m_reading = false;
    if (std::exchange(m_wasLost, false))
        emit notice(tr("Connected again."));
    if (!m_client.identity().writable)
        emit problem(describe({ErrorCode::ReadOnly, m_client.identity().firmware, 0}));
    updateWish();
    readBoard();
}

void Workspace::readBoard()
{
    if (m_reading)
        return;
    m_reading = true;
    m_client.submit<Configuration>([](Channel &channel, Device &device) {
        return device.readConfiguration(channel);
    }).then(this, [this](const Result<Configuration> &read) {
        m_reading = false;
        if (!read) {
            if (read.error().code != ErrorCode::Cancelled && read.error().code != ErrorCode::LinkClosed)
                emit problem(describe(read.error()));
            return;
        }
        if (!m_configuration.rebase(*read)) {
            m_edits.undoStack().clear();
            m_configuration.reset(*read);
        }
        if (std::exchange(m_writeInterrupted, false))
            tellInterruptedWrite();
        emit boardRead();
    });
}

void Workspace::write(const Configuration &wanted)
{
    if (m_writing) {
        emit problem(describe({ErrorCode::Busy, {}, 0}));
        return;
    }
    m_writing = true;
    m_client.submit<WriteReport>([base = m_configuration.board(), wanted, history = m_history,
                                  backupDone = m_backupDone](Channel &channel, Device &device) {
        WriteOptions options;
        options.history = &history;
        options.backupDone = backupDone;
        return writeConfiguration(channel, device, base, wanted, options);
    }).then(this, [this](const Result<WriteReport> &result) {
        m_writing = false;
        onReport(result);
        emit writeFinished();
    });
}

void Workspace::onReport(const Result<WriteReport> &result)
{
    if (!result) {
        emit problem(describe(result.error()));
        if (result.error().code == ErrorCode::Conflict)
            readBoard();
        return;
    }
    m_lastReport = *result;
    if (!result->snapshotPath.isEmpty())
        m_backupDone = true;
    m_configuration.setBoard(result->onBoard);
    const int verified = result->count(WriteState::Verified);
    if (result->isComplete()) {
        QString text = result->lines.empty() ? tr("Profile names written and read back.")
                                             : tr("%n value(s) written and read back.", nullptr, verified);
        if (!result->snapshotPath.isEmpty())
            text += u' ' + tr("The board as it was is kept in %1").arg(result->snapshotPath);
        emit notice(text);
        return;
    }
    ErrorText text = describe(*result->error);
    QStringList counts;
    if (verified > 0)
        counts.append(tr("%n verified", nullptr, verified));
    if (const int n = result->count(WriteState::RolledBack))
        counts.append(tr("%n put back", nullptr, n));
    if (const int n = result->count(WriteState::Unknown))
        counts.append(tr("%n unknown", nullptr, n));
    if (const int n = result->count(WriteState::NotWritten))
        counts.append(tr("%n not written", nullptr, n));
    if (const int n = result->count(WriteState::Mismatch))
        counts.append(tr("%n different", nullptr, n));
    text.what = tr("The write is not complete: %1. ").arg(counts.join(u", "_s)) + text.what;
    m_writeInterrupted = result->count(WriteState::Unknown) > 0;
    if (m_writeInterrupted) {
        text.cure = tr("When the board is back it is read again: what still shows as changed is not on it. Write again, "
                       "or discard.");
    }
    QStringList names;
    for (const WriteLine &line : result->lines)
        names.append(line.spec->key);
    text.detail += u' ' + names.mid(0, 12).join(u", "_s);
    emit problem(text);
}

// After the reconnection the board was read again, so it is known what a broken write left behind.
void Workspace::tellInterruptedWrite()
{
    int missing = 0;
    const ConfigurationModel &model = m_configuration;
    for (const WriteLine &line : m_lastReport->lines) {
        const ParameterSpec *spec = model.board().parameters().find(line.spec->key);
        missing += !spec || model.board().raw(*spec, line.profile) != line.to;
    }
    ErrorText text;
    text.what = tr("The last write was interrupted: %1 of %2 values are not on the board.").arg(missing)
                    .arg(m_lastReport->lines.size());
    text.meaning = tr("The board was read again; the values that are missing show as changed.");
    text.cure = missing > 0 ? tr("Review and write again to finish, or discard to stay with what the board has.")
                            : tr("Nothing is left to do.");
    text.detail = m_lastReport->snapshotPath;
    emit problem(text);
}

void Workspace::useProfile(int profile)
{
    if (!m_client.isConnected()) {
        m_configuration.setShownProfile(profile);
        return;
    }
    m_switchingProfile = true;
    m_client.submit<bool>([profile](Channel &channel, Device &device) -> Result<bool> {
        const auto selected = device.selectProfile(channel, profile);
        return selected ? Result<bool>(true) : tl::unexpected(selected.error());
    }).then(this, [this, profile](const Result<bool> &done) {
        m_switchingProfile = false;
        if (!done) {
            emit problem(describe(done.error()));
            emit m_configuration.activeProfileChanged(m_configuration.board().activeProfile());
            return;
        }
        m_configuration.setActiveProfile(profile);
        m_configuration.setShownProfile(profile);
    });
}

void Workspace::setMotors(bool on)
{
    if (!on) {
        m_client.motorsOff();
        return;
    }
    m_client.submit<Frame>([](Channel &channel, Device &device) {
        return channel.transact(device.motorsOnRequest());
    }).then(this, [this](const Result<Frame> &done) {
        if (!done)
            emit problem(describe(done.error()));
    });
}

void Workspace::wishTelemetry(const QObject *who, const QList<int> &channels)
{
    m_wishes.insert(who, channels);
    updateWish();
}

void Workspace::updateWish()
{
    if (!m_client.device())
        return;
    const QList<int> fast = m_client.device()->fastChannels();
    QSet<int> wanted;
    for (const QList<int> &channels : std::as_const(m_wishes)) {
        for (const int channel : channels) {
            if (fast.contains(channel))
                wanted.insert(channel);
        }
    }
    QList<int> sorted(wanted.begin(), wanted.end());
    std::sort(sorted.begin(), sorted.end());
    m_client.setTelemetry({sorted, 0});
}

double Workspace::latest(int channel) const
{
    const auto store = m_client.telemetry();
    return store ? double(store->latest(channel)) : std::nan("");
}

ChannelRoles Workspace::roles() const
{
    return m_client.device() ? m_client.device()->roles() : ChannelRoles();
}

std::optional<bool> Workspace::motorsRunning() const
{
    const auto store = m_client.telemetry();
    if (!m_client.isConnected() || !store)
        return {};
    const TimePoint now = Clock::now();
    if (store->rows() != m_lastRows) {
        m_lastRows = store->rows();
        m_lastRowsAt = now;
    }
    const double value = latest(roles().motorsOn);
    if (std::isnan(value) || now - m_lastRowsAt > kStale)
        return {};
    return value != 0.0;
}

std::vector<BoardFault> Workspace::faults() const
{
    if (!m_client.isConnected())
        return {};
    const ChannelRoles channels = roles();
    const double bits = latest(channels.faults);
    const double detail = latest(channels.faultDetail);
    if (std::isnan(bits))
        return {};
    return m_client.device()->faults(unsigned(bits), std::isnan(detail) ? 0U : unsigned(detail));
}

// The profile can be changed by a menu button, a radio or another program as well.
void Workspace::followActiveProfile()
{
    const double active = latest(roles().activeProfile);
    if (std::isnan(active) || m_switchingProfile || m_writing || m_reading || m_configuration.isEmpty()
        || !m_client.isConnected() || int(active) == m_configuration.board().activeProfile())
        return;
    m_configuration.setActiveProfile(int(active));
}
