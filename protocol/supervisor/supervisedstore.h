// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/configuration.h"
#include "protocol/device/device.h"
#include "protocol/supervisor/supervisor.h"
#include "protocol/telemetry/changewatch.h"
#include "protocol/telemetry/telemetrystore.h"

#include <functional>

/// Feeds a supervisor from a store: every new row, by the roles of a board's channels.
class SupervisedStore
{
public:
    SupervisedStore(std::shared_ptr<const TelemetryStore> store, std::shared_ptr<const Device> device,
                    const ChannelRoles &roles);

    /// What is there already is past.
    void skip();
    void feed(Supervisor &supervisor);
    /// What the board reports, whether its data repeat themselves, and when its values were changed live; the
    /// rest is left as it is at first. To be called some times per second.
    [[nodiscard]] SupervisedSituation situation();
    [[nodiscard]] double now() const { return m_store->now(); }

private:
    /// Where a channel's values go in a sample.
    struct Slot
    {
        int channel = -1;
        std::function<void(SupervisedSample &, double)> put;
    };
    /// The supervised channels that one kind of frame carries.
    struct Source
    {
        const TelemetryGroup *group = nullptr;  // kept by its tracks
        std::vector<std::pair<std::size_t, TrackView>> tracks;  // with the slot
        std::size_t next = 0;
    };
    void findSources();

    std::shared_ptr<const TelemetryStore> m_store;
    std::shared_ptr<const Device> m_device;
    ChannelRoles m_roles;
    std::vector<Slot> m_slots;
    std::vector<Source> m_sources;
    int m_generation = -1;
    double m_bits = -1;  // of the faults, and their detail, when their keys were looked up
    double m_detail = -1;
    QStringList m_faults;
    ChangeWatch m_change;
    Configuration m_nothing;  // only the status counts here
};
