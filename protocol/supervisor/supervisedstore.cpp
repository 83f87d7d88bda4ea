// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/supervisor/supervisedstore.h"

#include "protocol/device/abilities.h"
#include "protocol/device/bearings.h"

#include <algorithm>
#include <cmath>
#include <utility>

SupervisedStore::SupervisedStore(std::shared_ptr<const TelemetryStore> store,
                                 std::shared_ptr<const Device> device, const ChannelRoles &roles)
    : m_store(std::move(store))
    , m_device(std::move(device))
    , m_roles(roles)
{
    using Axes = SupervisedSample::Axes;
    const auto axes = [this](const std::array<int, 3> &channels, Axes SupervisedSample::*into) {
        for (std::size_t axis = 0; axis < channels.size(); ++axis) {
            if (channels[axis] >= 0)
                m_slots.push_back({channels[axis], [into, axis](SupervisedSample &sample, double value) {
                                       (sample.*into)[axis] = value;
                                   }});
        }
    };
    const auto single = [this](int channel, double SupervisedSample::*into) {
        if (channel >= 0)
            m_slots.push_back(
                {channel, [into](SupervisedSample &sample, double value) { sample.*into = value; }});
    };
    axes(roles.angle, &SupervisedSample::angle);
    axes(roles.target, &SupervisedSample::target);
    axes(roles.gyro, &SupervisedSample::rate);
    axes(roles.input, &SupervisedSample::input);
    axes(roles.motorTemperature, &SupervisedSample::motorTemperature);
    single(roles.outputs, &SupervisedSample::outputs);
    single(roles.armed, &SupervisedSample::armed);
    single(roles.battery, &SupervisedSample::battery);
    single(roles.batteryCells, &SupervisedSample::batteryCells);
    single(roles.temperature, &SupervisedSample::temperature);
}

void SupervisedStore::skip()
{
    findSources();
    for (Source &source : m_sources)
        source.next = source.group->end();
}

void SupervisedStore::findSources()
{
    const int generation = m_store->generation();
    if (generation == std::exchange(m_generation, generation))
        return;
    const std::vector<Source> before = std::exchange(m_sources, {});
    const auto find = [](auto &sources, const TelemetryGroup *group) {
        return std::find_if(sources.begin(), sources.end(),
                            [group](const Source &source) { return source.group == group; });
    };
    for (std::size_t slot = 0; slot < m_slots.size(); ++slot) {
        for (TrackView &track : m_store->tracks(m_slots[slot].channel)) {
            auto source = find(m_sources, track.group());
            if (source == m_sources.end()) {
                const auto kept = find(before, track.group());
                m_sources.push_back({track.group(), {}, kept == before.end() ? 0 : kept->next});
                source = std::prev(m_sources.end());
            }
            source->tracks.emplace_back(slot, std::move(track));
        }
    }
}

void SupervisedStore::feed(Supervisor &supervisor)
{
    findSources();
    for (Source &source : m_sources) {
        if (source.next >= source.group->end())
            continue;
        std::size_t end = source.group->end();
        for (auto &[slot, track] : source.tracks) {
            track.refresh();
            source.next = std::max(source.next, track.begin());
            end = std::min(end, track.end());
        }
        for (; source.next < end; ++source.next) {
            SupervisedSample sample;
            sample.time = source.tracks.front().second.time(source.next);
            bool any = false;
            for (const auto &[slot, track] : source.tracks) {
                const auto value = double(track.value(source.next));
                m_slots[slot].put(sample, value);
                any |= !std::isnan(value);
            }
            if (any)
                supervisor.add(sample);
        }
    }
}

SupervisedSituation SupervisedStore::situation()
{
    const auto latest = [this](int channel) {
        return channel < 0 ? SupervisedSample::kNone : double(m_store->latest(channel));
    };
    SupervisedSituation now;
    const TimePoint clock = Clock::now();
    m_change.look(m_store.get(), clock);
    if (const auto since = m_change.unchangedSince(*m_store, clock))
        now.unchangedSince = m_store->secondsAt(*since);
    now.tellsMotion = !ChannelRoles::present({m_roles.angle, m_roles.gyro}).isEmpty();
    if (const StatusWords *words = m_device->statusWords(); words && m_roles.state >= 0) {
        const double state = latest(m_roles.state);
        now.isStabilising = !std::isnan(state) && words->isStabilising(int(state));
    }
    if (const Bearings *bearings = m_device->bearings()) {
        for (const Axis axis : kAxes) {
            const AxisBearing bearing = bearings->bearing(axis, m_nothing, latest);
            now.follows[std::size_t(axis)] = bearing.follows;
            now.isDriven[std::size_t(axis)] = bearing.isDriven;
        }
    }
    const LiveAccess *live = m_device->live();
    if (live && live->isChanging())
        now.changedAt = m_store->now();
    else if (const auto change = live ? live->lastChange() : std::nullopt)
        now.changedAt = m_store->secondsAt(change->until);
    const double bits = latest(m_roles.faults);
    const double detail = latest(m_roles.faultDetail);
    const FaultWords *words = m_device->faultWords();
    if (words && !std::isnan(bits) && (bits != m_bits || (!std::isnan(detail) && detail != m_detail))) {
        m_bits = bits;
        m_detail = detail;
        m_faults.clear();
        for (const BoardFault &fault :
             words->faults(unsigned(bits), std::isnan(detail) ? 0 : unsigned(detail)))
            m_faults.append(fault.key);
    }
    now.faults = m_faults;
    now.tellsMotorHeat = !ChannelRoles::present({m_roles.motorTemperature}).isEmpty();
    now.tellsFaults = words && !std::isnan(bits);
    return now;
}
