// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/gamepad/gamepad.h"

namespace {

constexpr auto kWatchPeriod = 20ms;

}  // namespace

Gamepad::Gamepad(Store store, GamepadPoller::Maker maker, QObject *parent)
    : QObject(parent)
    , m_store(std::move(store))
    , m_maker(std::move(maker))
{
    if (m_store.chosen)
        m_preferred = m_store.chosen();
    m_watch.setInterval(kWatchPeriod);
    connect(&m_watch, &QTimer::timeout, this, &Gamepad::look);
}

Gamepad::~Gamepad()
{
    if (m_poller)
        m_poller->stop();
}

void Gamepad::use(QObject &user)
{
    if (m_users.contains(&user))
        return;
    m_users.append(&user);
    connect(&user, &QObject::destroyed, this, [this, gone = &user] { letGo(*gone); });
    if (m_users.size() > 1)
        return;
    if (m_poller && !m_poller->state().error)
        m_poller->setPaused(false);
    else  // what was missing may be there now
        m_poller = GamepadPoller::start(m_maker, m_preferred.guid, m_preferred.name);
    m_watch.start();
}

void Gamepad::letGo(QObject &user)
{
    if (m_users.removeAll(&user) == 0)
        return;
    disconnect(&user, &QObject::destroyed, this, nullptr);
    if (!m_users.isEmpty())
        return;
    m_watch.stop();
    m_poller->setPaused(true);
    m_wasAlive = false;
    m_session = 0;
    m_hadError = false;
    m_padCount = 0;
}

void Gamepad::setMaker(GamepadPoller::Maker maker)
{
    m_maker = std::move(maker);
    if (m_poller)
        std::exchange(m_poller, nullptr)->stop();
}

GamepadSnapshot Gamepad::snapshot() const
{
    GamepadSnapshot snapshot;
    if (!m_poller)
        return snapshot;
    const GamepadPoller::State state = m_poller->state();
    snapshot.at = state.at;
    snapshot.session = state.session;
    snapshot.connected = state.used.has_value();
    if (!state.used)
        return snapshot;
    const Mapped &now = mapped(*state.used);
    applyMapping(now.mapping, *state.used, snapshot);
    snapshot.isStandard = now.isStandard;
    for (std::size_t i = 0; i < kGamepadButtons; ++i) {
        const auto button = std::size_t(now.mapping.buttons[i]);
        snapshot.presses[i] = button < state.presses.size() ? state.presses[button] : 0;
    }
    return snapshot;
}

std::optional<GamepadReading> Gamepad::reading() const
{
    return m_poller ? m_poller->state().used : std::nullopt;
}

QList<std::pair<QByteArray, QString>> Gamepad::pads() const
{
    QList<std::pair<QByteArray, QString>> list;
    if (!m_poller)
        return list;
    const GamepadPoller::State state = m_poller->state();
    for (const GamepadReading &pad : state.pads)
        list.append({pad.guid, pad.name});
    return list;
}

void Gamepad::prefer(const Kind &kind)
{
    m_preferred = kind;
    if (m_store.choose)
        m_store.choose(kind);
    if (m_poller)
        m_poller->prefer(kind.guid, kind.name);
}

void Gamepad::setUse(GamepadUse use)
{
    if (std::exchange(m_use, use) == use)
        return;
    m_mapped = {};
    emit changed();
}

std::optional<Error> Gamepad::error() const
{
    return m_poller ? m_poller->state().error : std::nullopt;
}

const Gamepad::Mapped &Gamepad::mapped(const GamepadReading &pad) const
{
    const QByteArray key = m_use == GamepadUse::Flight ? pad.guid + "-flight" : pad.guid;
    if (key == m_mapped.key)
        return m_mapped;
    const QByteArray kept = m_store.load(key);
    m_mapped.key = key;
    m_mapped.mapping
        = kept.isEmpty() ? GamepadMapping::standard(pad.layout, m_use) : GamepadMapping::fromJson(kept);
    m_mapped.isStandard = kept.isEmpty() && m_mapped.mapping.isSetUp();
    return m_mapped;
}

GamepadMapping Gamepad::mapping() const
{
    const auto used = reading();
    return used ? mapped(*used).mapping : GamepadMapping();
}

bool Gamepad::isStandard() const
{
    const auto used = reading();
    return used && mapped(*used).isStandard;
}

bool Gamepad::hasStandard() const
{
    const auto used = reading();
    return used && GamepadMapping::standard(used->layout, m_use).isSetUp();
}

void Gamepad::setMapping(const GamepadMapping &mapping)
{
    const auto used = reading();
    if (!used || mapped(*used).mapping == mapping)
        return;
    m_mapped.mapping = mapping;
    m_mapped.isStandard = false;
    m_store.save(m_mapped.key, mapping.toJson());
    emit changed();
}

void Gamepad::useStandard()
{
    const auto used = reading();
    if (!used || mapped(*used).isStandard)
        return;
    m_store.save(m_mapped.key, {});
    m_mapped = {};
    emit changed();
}

// Ends of a pad are told before what has come instead.
void Gamepad::look()
{
    const GamepadPoller::State state = m_poller->state();
    const bool isAlive = state.used.has_value() && Clock::now() - state.at <= GamepadSnapshot::kDeadMan;
    const bool isOther = state.session != m_session;
    const bool wasLost = m_wasAlive && (!isAlive || isOther);
    const bool isNews = isAlive != m_wasAlive || isOther || state.error.has_value() != m_hadError
        || qsizetype(state.pads.size()) != m_padCount;
    m_wasAlive = isAlive;
    m_session = state.session;
    m_hadError = state.error.has_value();
    m_padCount = qsizetype(state.pads.size());
    if (wasLost)
        emit lost(state.used && !isOther ? Loss::Silent : Loss::Unplugged);
    if (isNews)
        emit changed();
}
