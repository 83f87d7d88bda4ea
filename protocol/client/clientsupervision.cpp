// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What the client gives the supervisor to act with.
#include "protocol/client/deviceclient_p.h"

void DeviceClient::Private::startSupervision()
{
    supervision = std::make_unique<Supervision>(Supervision::Hooks{
        [this](const std::function<void(bool)> &proven) { stopMotors(proven); },
        [this](std::shared_ptr<JobControl> job) -> std::unique_ptr<Channel> {
            return makeChannel(std::move(job), SessionChannel::Link::Open);
        },
        [this] {
            const std::lock_guard lock(urgentMutex);
            std::erase_if(movingJobs, [](const auto &moving) { return moving.expired(); });
            return !movingJobs.empty();
        },
        [this](const AlarmReport &report) { back([this, report] { emit q.alarmChanged(report); }); },
        [this](const std::vector<Unwatched> &missing) {
            back([this, missing] {
                unwatched = missing;
                emit q.unwatchedChanged();
            });
        }});
    steering = supervision->steering();
}

const std::vector<Unwatched> &DeviceClient::unwatched() const
{
    return d->unwatched;
}

void DeviceClient::setSupervisorRules(const SupervisorRules &rules)
{
    if (d->supervision)
        d->supervision->setRules(rules);
}
