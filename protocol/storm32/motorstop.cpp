// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/storm32/motorstop.h"

#include "protocol/base/bytes.h"
#include "protocol/storm32/commands.h"
#include "protocol/storm32/framer.h"
#include "protocol/storm32/telemetrytables.h"

#include <algorithm>
#include <utility>

namespace storm32 {

namespace {

bool areDisabled(const std::array<int, MotorStop::kWords> &words)
{
    return std::all_of(words.begin(), words.end(), [](int value) { return value == MotorStop::kDisabled; });
}

}  // namespace

Proof MotorStop::learn(const Frame &frame, int firmware)
{
    const std::lock_guard lock(m_mutex);
    ByteReader reader(frame.payload);
    if (frame.id == FrameId::kRc + int(Rc::GetParameter)) {
        const int word = reader.u16() - kFirstWord;
        const int value = reader.u16();
        if (word < 0 || word >= kWords || !reader.ok())
            return Proof::Nothing;
        m_now[std::size_t(word)] = value;
        if (!m_active)
            m_before[std::size_t(word)] = value;
        return Proof::Nothing;
    }
    if (frame.id != FrameId::kSimple + int(Simple::Status))
        return Proof::Nothing;
    const int state = reader.u16();
    reader.u16();
    const int motors = reader.u16() & kMotorBits;
    if (!reader.ok())
        return Proof::Nothing;
    m_standby = motors == 0 && isStandby(state, firmware);
    if (motors != 0)
        return Proof::Refuted;
    if (!m_standby && !areDisabled(m_active ? m_now : m_before))
        return Proof::Nothing;  // they do not run yet, but will
    if (!m_active)
        m_before.fill(-1);  // read anew at the next stop
    return Proof::Proven;
}

std::vector<Request> MotorStop::ask(const MakeRequest &make)
{
    const std::lock_guard lock(m_mutex);
    std::vector<Request> requests;
    for (int i = 0; i < kWords; ++i) {
        if (m_before[std::size_t(i)] < 0)
            requests.push_back(make(kFirstWord + i, {}));
    }
    return requests;
}

std::vector<Request> MotorStop::disable(const MakeRequest &make)
{
    std::vector<Request> requests = ask(make);
    const std::lock_guard lock(m_mutex);
    if (!requests.empty() || areDisabled(m_before))
        return requests;
    if (!std::exchange(m_active, true))
        m_now.fill(-1);
    for (int i = 0; i < kWords; ++i) {
        requests.push_back(make(kFirstWord + i, kDisabled));
        requests.push_back(make(kFirstWord + i, {}));
    }
    return requests;
}

std::vector<Request> MotorStop::restore(const MakeRequest &make, const std::vector<Request> &standby)
{
    const std::lock_guard lock(m_mutex);
    if (m_active && m_standby && m_now == m_before) {
        m_active = false;
        m_before.fill(-1);
    }
    if (!m_active)
        return {};
    std::vector<Request> requests = standby;
    for (int i = 0; m_standby && i < kWords; ++i) {
        requests.push_back(make(kFirstWord + i, m_before[std::size_t(i)]));
        requests.push_back(make(kFirstWord + i, {}));
    }
    m_now.fill(-1);
    return requests;
}

bool MotorStop::isActive() const
{
    const std::lock_guard lock(m_mutex);
    return m_active;
}

std::vector<int> MotorStop::replaced() const
{
    const std::lock_guard lock(m_mutex);
    return m_active ? std::vector<int>(m_before.begin(), m_before.end()) : std::vector<int>();
}

void MotorStop::correct(QByteArray &stream) const
{
    const std::lock_guard lock(m_mutex);
    for (int i = 0; m_active && i < kWords; ++i) {
        const qsizetype at = 2 * qsizetype(kFirstWord + i);
        if (stream.size() >= at + 2)
            stream.replace(at, 2, ByteWriter().u16(m_before[std::size_t(i)]).take());
    }
}

}  // namespace storm32
