// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/device/abilities.h"

#include "protocol/session/channel.h"
#include "protocol/session/framer.h"

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

// Writes that follow one another this closely are one change: a slider that is dragged.
constexpr auto kOneChange = 2s;

QList<int> idsOf(const std::vector<AdjustableValue> &values)
{
    QList<int> ids;
    for (const AdjustableValue &value : values)
        ids.append(value.id);
    return ids;
}

const AdjustableValue *findValue(const std::vector<AdjustableValue> &values, int id)
{
    const auto it = std::find_if(values.begin(), values.end(),
                                 [id](const AdjustableValue &value) { return value.id == id; });
    return it == values.end() ? nullptr : &*it;
}

}  // namespace

Result<void> LiveAccess::writeAdjustables(Channel &channel, const std::vector<AdjustableValue> &values)
{
    // A board that does not tell refuses the write, too, or it cannot be taken back.
    const auto before = readAdjustables(channel, idsOf(values));
    for (const AdjustableValue &value : values) {
        const AdjustableValue *used = before ? findValue(*before, value.id) : nullptr;
        if (used && used->value == value.value)
            continue;
        if (const auto checked = checkAdjustable(value); !checked)
            return checked;
    }
    const auto done = putAdjustables(channel, values);
    close();
    // Also after a failure: some of them may be in use.
    if (before)
        note(channel.now(), *before, values);
    return done;
}

Result<void> LiveAccess::restoreAdjustables(Channel &channel, const std::vector<AdjustableValue> &values)
{
    close();
    return putAdjustables(channel, values);
}

// Whoever sets values knows what is in use.
void LiveAccess::close()
{
    const std::lock_guard lock(m_mutex);
    if (!m_open.isRunning)
        m_open = {};
}

bool LiveAccess::isChanging() const
{
    const std::lock_guard lock(m_mutex);
    return m_open.isRunning || !m_open.before.empty();
}

Result<std::vector<AdjustableValue>> LiveAccess::readAllAdjustables(Channel &channel)
{
    QList<int> ids;
    for (const AdjustableSpec &spec : adjustables())
        ids.append(spec.id);
    return readAdjustables(channel, ids);
}

bool LiveAccess::noteChangesBy(Channel &channel, const std::function<bool()> &job)
{
    const auto before = readAllAdjustables(channel);
    const auto setOpen = [this](OpenChange open) {
        const std::lock_guard lock(m_mutex);
        m_open = std::move(open);
    };
    setOpen({true, before ? *before : std::vector<AdjustableValue>()});
    const bool done = job();
    const auto after = before ? readAllAdjustables(channel) : before;
    // What cannot be read stays open; a board that never tells has nothing to go back to.
    setOpen(before && !after ? OpenChange{false, *before} : OpenChange());
    if (!before || !after)
        return done;
    std::vector<AdjustableValue> changed;
    for (const AdjustableValue &value : *after) {
        const AdjustableValue *was = findValue(*before, value.id);
        if (was && was->value != value.value)
            changed.push_back(value);
    }
    if (!changed.empty())
        note(channel.now(), *before, changed);
    return done;
}

void LiveAccess::note(TimePoint now, const std::vector<AdjustableValue> &before,
                      const std::vector<AdjustableValue> &after)
{
    // What is set to what it is already changes nothing.
    const bool isChange = std::any_of(after.begin(), after.end(), [&before](const AdjustableValue &value) {
        const AdjustableValue *was = findValue(before, value.id);
        return was && was->value != value.value;
    });
    if (!isChange)
        return;
    const std::lock_guard lock(m_mutex);
    if (!m_change || now - m_change->until > kOneChange)
        m_change = LiveChange{now, now, {}, {}};
    m_change->until = now;
    for (const AdjustableValue &value : after) {
        const AdjustableValue *was = findValue(before, value.id);
        if (!was)
            continue;
        // What matters is what was in use before the first of the writes. What is so again is no change.
        std::vector<AdjustableValue> &first = m_change->before;
        std::vector<AdjustableValue> &last = m_change->after;
        const auto known = std::find_if(first.begin(), first.end(),
                                        [&](const AdjustableValue &each) { return each.id == value.id; });
        const auto place = known - first.begin();
        const double original = known == first.end() ? was->value : known->value;
        if (known != first.end()) {
            first.erase(known);
            last.erase(last.begin() + place);
        }
        if (original != value.value) {
            first.insert(first.begin() + place, {value.id, original});
            last.insert(last.begin() + place, value);
        }
    }
    if (m_change->before.empty())
        m_change.reset();
}

std::optional<LiveChange> LiveAccess::lastChange() const
{
    const std::lock_guard lock(m_mutex);
    return m_change;
}

Result<LiveChange> LiveAccess::takeBack(Channel &channel)
{
    std::optional<LiveChange> change = lastChange();
    OpenChange open;
    {
        const std::lock_guard lock(m_mutex);
        open = m_open;
    }
    if (open.isRunning)
        return failure(ErrorCode::Busy, u"the board is tuning itself"_s);
    if (!open.before.empty()) {
        const auto now = readAdjustables(channel, idsOf(open.before));
        if (!now)
            return tl::unexpected(now.error());
        std::erase_if(open.before, [&now](const AdjustableValue &was) {
            const AdjustableValue *is = findValue(*now, was.id);
            return is && is->value == was.value;
        });
        change = LiveChange{channel.now(), channel.now(), open.before, {}};
    }
    if (!change || change->before.empty())
        return failure(ErrorCode::NoEffect, u"nothing was changed live"_s);
    const auto inUse = readAdjustables(channel, idsOf(change->after));
    if (!inUse)
        return tl::unexpected(inUse.error());
    for (const AdjustableValue &value : change->after) {
        const AdjustableValue *now = findValue(*inUse, value.id);
        if (!now || now->value != std::round(value.value))
            return failure(ErrorCode::Conflict,
                           u"variable %1: %2 was written, %3 is in use"_s.arg(value.id)
                               .arg(value.value)
                               .arg(now ? QString::number(now->value) : u"nothing"_s));
    }
    if (const auto done = putAdjustables(channel, change->before); !done)
        return tl::unexpected(done.error());
    const std::lock_guard lock(m_mutex);
    m_change.reset();
    m_open = {};
    return *change;
}

FrameText FrameInspector::describeFrames(QByteArrayView bytes, Framer &framer) const
{
    QStringList names;
    QStringList fields;
    const FrameSink sink = [&](const FrameView &frame) {
        const FrameText one = describeFrame(frame, false);
        names.append(one.name);
        fields.append(one.fields);
    };
    framer.feed(asBytes(bytes), sink);
    framer.flush(sink);
    return {names.join(u" + "_s), fields.join(u" + "_s)};
}
