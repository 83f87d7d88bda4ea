// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/livemodel.h"

#include "protocol/client/whendone.h"
#include "protocol/configuration/leap.h"
#include "protocol/device/abilities.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace {

constexpr qint64 kOneStepMs = 1000;

}  // namespace

LiveModel::LiveModel(DeviceClient &client, ConfigurationModel &configuration, QObject *parent)
    : QObject(parent)
    , m_client(client)
    , m_configuration(configuration)
{
    connect(&configuration, &ConfigurationModel::boardReset, this, &LiveModel::reset);
    connect(&configuration, &ConfigurationModel::activeProfileChanged, this, &LiveModel::reset);
    connect(&configuration, &ConfigurationModel::storedChanged, this, [this] {
        recount();
        for (const int parameter : std::as_const(m_known))
            emit valueChanged(parameter);  // against what is stored now
    });
    reset();
}

const ParameterSpec &LiveModel::spec(int parameter) const
{
    return m_set->at(parameter);
}

int LiveModel::variableOf(int parameter) const
{
    const LiveAccess *live = m_client.device() ? m_client.device()->live() : nullptr;
    return live ? live->variableOf(spec(parameter)) : spec(parameter).adjustable;
}

LiveModel::Values LiveModel::tuned() const
{
    Values values;
    for (const int parameter : m_parameters) {
        if (const auto now = value(parameter))
            values.insert(parameter, *now);
    }
    return values;
}

void LiveModel::reset()
{
    ++m_generation;
    m_wanted.clear();
    m_back.clear();
    m_sent.clear();
    m_writing = false;
    m_parameters.clear();
    m_known.clear();
    const Configuration &board = std::as_const(m_configuration).board();
    const QString key = m_configuration.isEmpty() ? QString()
                                                  : board.identity().serial + u'/' + board.identity().firmware
            + u'/' + QString::number(board.activeProfile());
    // The same board read anew keeps the two sets; ids mean the same for the same firmware.
    if (key != std::exchange(m_boardKey, key)) {
        m_values.clear();
        m_own.clear();
        m_agreed.clear();
        m_other.clear();
        m_otherKnown = false;
        m_doubted.clear();
        m_steps.clear();
        m_done = 0;
        m_stepAge.invalidate();
        m_slot = Slot::A;
    }
    m_set = m_configuration.isEmpty() ? nullptr : std::as_const(m_configuration).board().parameterSet();
    if (m_set) {
        for (const ParameterSpec &candidate : m_set->all()) {
            // Without what is stored, nobody could tell what is changed or go back.
            if (board.findMissing(candidate, board.activeProfile()) || candidate.row->state)
                continue;
            if (candidate.adjustable >= 0)
                m_parameters.append(candidate.id);
            if (candidate.adjustable >= 0 || (m_client.isConnected() && variableOf(candidate.id) >= 0))
                m_known.append(candidate.id);
        }
    }
    recount();
    emit modelReset();
    emit slotChanged();
    read();
}

std::optional<double> LiveModel::value(int parameter) const
{
    const auto it = m_values.find(parameter);
    return it == m_values.end() ? std::nullopt : std::optional(*it);
}

std::optional<double> LiveModel::stored(int parameter) const
{
    if (!m_set)
        return {};
    return m_configuration.boardValue(spec(parameter),
                                      std::as_const(m_configuration).board().activeProfile());
}

bool LiveModel::isChanged(int parameter) const
{
    const auto now = value(parameter);
    const auto held = stored(parameter);
    // A board that lacks the block does not tell what it has stored: only what was set here is another.
    return now && (held ? !sameValue(held, now) : m_own.contains(parameter));
}

void LiveModel::forget()
{
    m_values.clear();
    m_own.clear();
    recount();
}

void LiveModel::read()
{
    if (!m_client.isConnected() || m_known.isEmpty())
        return;
    QList<int> ids;
    for (const int parameter : std::as_const(m_known))
        ids.append(variableOf(parameter));
    whenDone(m_client.submit<std::vector<AdjustableValue>>([ids](Channel &channel, Device &device) {
        return device.live()->readAdjustables(channel, ids);
    }),
             this, [this, generation = m_generation](const Result<std::vector<AdjustableValue>> &read) {
                 if (generation != m_generation)
                     return;
                 if (!read) {
                     emit failed(read.error());
                     return;
                 }
                 const Values doubted = std::exchange(m_doubted, {});
                 QHash<int, double> byId;
                 for (const AdjustableValue &variable : *read)
                     byId.insert(variable.id, variable.value);
                 for (const int parameter : std::as_const(m_known)) {
                     const auto it = byId.find(variableOf(parameter));
                     // What was asked before a value went out says nothing about it.
                     if (it == byId.end() || m_wanted.contains(parameter)
                         || (m_writing && m_sent.contains(parameter)))
                         continue;
                     const double raw = spec(parameter).rawOf(*it);
                     if (sameValue(value(parameter), raw))
                         continue;
                     m_values.insert(parameter, raw);
                     m_own.remove(parameter);
                     emit valueChanged(parameter);
                 }
                 recount();
                 tellDoubted(doubted);
             });
}

// What a silent board was told to use, once it has said what it does use.
void LiveModel::tellDoubted(const Values &doubted)
{
    LiveValues lost;
    for (auto it = doubted.begin(); it != doubted.end(); ++it) {
        const auto now = value(it.key());
        if (now && !sameValue(*now, *it) && !m_wanted.contains(it.key()))
            lost.push_back({spec(it.key()).key, *now, *it});
    }
    if (std::exchange(m_wasSilent, false) && !lost.empty())
        emit notTaken(lost);
    if (!doubted.isEmpty())
        emit changeCountChanged(m_changeCount);  // they count again
}

std::pair<double, double> LiveModel::range(int parameter) const
{
    const ParameterSpec &parameterSpec = spec(parameter);
    std::pair<double, double> range{parameterSpec.row->min, parameterSpec.row->max};
    const LiveAccess *live = m_client.device() ? m_client.device()->live() : nullptr;
    const auto variables = live ? live->adjustables() : std::span<const AdjustableSpec>();
    for (const AdjustableSpec &variable : variables) {
        if (variable.id != parameterSpec.adjustable)
            continue;
        range.first = std::max(range.first, parameterSpec.rawOf(variable.min));
        range.second = std::min(range.second, parameterSpec.rawOf(variable.max));
    }
    return range;
}

void LiveModel::setValue(int parameter, double raw)
{
    if (!m_client.isConnected() && m_known.contains(parameter) && !sameValue(value(parameter), raw))
        emit setWithoutLink({{spec(parameter).key, value(parameter).value_or(raw), raw}});
    if (!m_client.isConnected() || isHeld() || !m_known.contains(parameter))
        return;
    const auto [low, high] = range(parameter);
    const double wanted = std::clamp(spec(parameter).nearest(raw), low, high);
    if (!spec(parameter).accepts(wanted) && !sameValue(stored(parameter), wanted))
        return;
    if (isLeap(spec(parameter), usual(parameter), wanted)) {
        emit leapt({&spec(parameter), 0, usual(parameter), wanted});
        emit valueChanged(parameter);  // whoever shows it shows what is in use
        return;
    }
    choose(parameter, wanted);
    flush();
}

void LiveModel::agree(int parameter, double raw)
{
    m_agreed.insert(parameter, raw);
    setValue(parameter, raw);
}

// Many small steps up are one large one: what was set here by itself is no measure.
double LiveModel::usual(int parameter) const
{
    const double used = m_own.contains(parameter) ? 0 : value(parameter).value_or(0);
    double most = 0;
    for (const double each : {used, stored(parameter).value_or(0), m_agreed.value(parameter, 0)})
        most = std::isfinite(each) ? std::max(most, std::abs(each)) : most;
    return most;
}

void LiveModel::setValues(const QHash<int, double> &values)
{
    demand(values);
    flush();
}

void LiveModel::putBack(const QHash<int, double> &values)
{
    demand(values);
    for (auto it = values.begin(); it != values.end(); ++it) {
        if (m_wanted.contains(it.key()))
            m_back.insert(it.key());
    }
    flush();
}

void LiveModel::demand(const QHash<int, double> &values)
{
    if (!m_client.isConnected())
        return;
    for (auto it = values.begin(); it != values.end(); ++it) {
        if (!m_known.contains(it.key()))
            continue;
        const double raw = spec(it.key()).clamped(it.value());
        if (!std::isfinite(raw))
            continue;
        // Always written: the value assumed to be in use may be outdated.
        put(it.key(), raw);
        m_own.insert(it.key());
        m_wanted.insert(it.key(), raw);
        m_back.remove(it.key());
    }
}

LiveValues LiveModel::unsaved() const
{
    return unsavedOf([](int) { return true; });
}

LiveValues LiveModel::ownUnsaved() const
{
    return unsavedOf([this](int parameter) { return m_own.contains(parameter); });
}

LiveValues LiveModel::unsavedOf(const std::function<bool(int)> &isMeant) const
{
    LiveValues values;
    for (const int parameter : m_known) {
        if (isChanged(parameter) && isMeant(parameter))
            values.push_back(
                {spec(parameter).key, stored(parameter).value_or(*value(parameter)), *value(parameter)});
    }
    return values;
}

void LiveModel::put(int parameter, double raw)
{
    if (!std::isfinite(raw) || sameValue(value(parameter), raw))
        return;
    m_values.insert(parameter, raw);
    m_own.insert(parameter);
    m_wanted.insert(parameter, raw);
    m_back.remove(parameter);
    emit valueChanged(parameter);
    recount();
}

void LiveModel::choose(int parameter, double raw)
{
    if (const auto now = value(parameter); now && !sameValue(*now, raw)) {
        m_steps.resize(m_done);
        if (m_steps.empty() || !m_stepAge.isValid() || m_stepAge.hasExpired(kOneStepMs))
            m_steps.emplace_back();
        Step &step = m_steps.back();
        if (!step.before.contains(parameter))
            step.before.insert(parameter, *now);
        step.after.insert(parameter, raw);
        if (sameValue(step.before.value(parameter), raw)) {  // there and back
            step.before.remove(parameter);
            step.after.remove(parameter);
        }
        m_stepAge.start();
        if (step.before.isEmpty()) {
            m_steps.pop_back();
            m_stepAge.invalidate();
        }
        m_done = m_steps.size();
    }
    put(parameter, raw);
}

// What somebody else has changed since is not undone here.
std::optional<std::size_t> LiveModel::nextStep(bool again) const
{
    const auto isInUse = [this](const Values &values) {
        for (auto it = values.begin(); it != values.end(); ++it) {
            if (!sameValue(value(it.key()), it.value()))
                return false;
        }
        return true;
    };
    for (std::size_t i = again ? m_done : 0; again && i < m_steps.size(); ++i) {
        if (isInUse(m_steps[i].before))
            return i;
    }
    for (std::size_t i = again ? 0 : m_done; i > 0; --i) {
        if (isInUse(m_steps[i - 1].after))
            return i - 1;
    }
    return {};
}

void LiveModel::step(bool again)
{
    const auto next = nextStep(again);
    if (!next || !m_client.isConnected() || isHeld())
        return;
    m_stepAge.invalidate();
    m_done = again ? *next + 1 : *next;
    const Values wanted = again ? m_steps[*next].after : m_steps[*next].before;
    for (auto it = wanted.begin(); it != wanted.end(); ++it)
        put(it.key(), it.value());
    flush();
}

void LiveModel::flush()
{
    if (m_writing || m_wanted.isEmpty())
        return;
    m_writing = true;
    emit sending();
    std::vector<AdjustableValue> values;
    std::vector<AdjustableValue> back;
    for (auto it = m_wanted.begin(); it != m_wanted.end(); ++it) {
        if (!m_sent.contains(it.key()))
            m_sent.append(it.key());
        (m_back.contains(it.key()) ? back : values)
            .push_back({variableOf(it.key()), it.value() * spec(it.key()).row->adjustableScale});
    }
    m_wanted.clear();
    m_back.clear();
    whenDone(m_client.submit<bool>([values, back](Channel &channel, Device &device) -> Result<bool> {
        Result<void> done;
        if (!back.empty())
            done = device.live()->restoreAdjustables(channel, back);
        if (done && !values.empty())
            done = device.live()->writeAdjustables(channel, values);
        return done ? Result<bool>(true) : tl::unexpected(done.error());
    }),
             this, [this, generation = m_generation](const Result<bool> &done) {
                 if (generation != m_generation)
                     return;
                 m_writing = false;
                 if (!done) {
                     // The values in use are no longer known, so they are read.
                     m_wanted.clear();
                     m_back.clear();
                     for (const int parameter : std::exchange(m_sent, {})) {
                         if (const auto wanted = value(parameter))
                             m_doubted.insert(parameter, *wanted);
                     }
                     m_done = m_steps.size();  // what was to be undone is in use again
                     m_wasSilent |= done.error().code == ErrorCode::Timeout;
                     emit changeCountChanged(m_changeCount);
                     emit failed(done.error());
                     read();
                     return;
                 }
                 flush();
                 if (isSettled())
                     emit settled(std::exchange(m_sent, {}));
             });
}

void LiveModel::hold()
{
    if (++m_holds == 1)
        emit heldChanged(true);
}

void LiveModel::release()
{
    if (--m_holds == 0)
        emit heldChanged(false);
}

void LiveModel::revert()
{
    if (isHeld())
        return;
    m_wanted.clear();
    for (const int parameter : std::as_const(m_parameters)) {
        const auto kept = stored(parameter);
        if (!kept || !value(parameter))
            continue;
        // Also values that look unchanged: a value still in flight must not win.
        if (m_writing && *value(parameter) == *kept)
            m_wanted.insert(parameter, *kept);
        choose(parameter, *kept);
    }
    flush();
}

void LiveModel::useSlot(Slot slot)
{
    if (slot == m_slot || isHeld())
        return;
    const Values present = tuned();
    if (!m_otherKnown)
        m_other = present;
    m_otherKnown = true;
    const Values wanted = std::exchange(m_other, present);
    m_slot = slot;
    for (auto it = wanted.begin(); it != wanted.end(); ++it)
        choose(it.key(), it.value());
    flush();
    emit slotChanged();
}

void LiveModel::copyToOther()
{
    m_other = tuned();
    m_otherKnown = true;
    emit slotChanged();
}

int LiveModel::slotDifference() const
{
    if (!m_otherKnown)
        return 0;
    int count = 0;
    const Values present = tuned();
    for (auto it = present.begin(); it != present.end(); ++it)
        count += !sameValue(m_other.value(it.key(), it.value()), it.value());
    return count;
}

int LiveModel::tunedCount() const
{
    return int(std::count_if(m_parameters.begin(), m_parameters.end(),
                             [this](int parameter) { return isChanged(parameter); }));
}

void LiveModel::recount()
{
    const auto count = int(std::count_if(m_known.begin(), m_known.end(),
                                         [this](int parameter) { return isChanged(parameter); }));
    if (count == m_changeCount)
        return;
    m_changeCount = count;
    emit changeCountChanged(count);
}
