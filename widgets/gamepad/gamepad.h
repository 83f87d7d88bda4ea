// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/gamepad/gamepadmapping.h"
#include "widgets/gamepad/gamepadpoller.h"

#include <QList>
#include <QObject>
#include <QPointer>
#include <QTimer>

#include <utility>

/// The gamepad, for whoever steers with it. It is read only while somebody uses it.
///
/// Readings are those of a thread; snapshot() may be asked as often as wanted. A pad that is plugged out, and
/// a thread that is silent for GamepadSnapshot::kDeadMan, are lost: lost() says so, and isAlive() of a
/// snapshot is false. Whoever steers asks that of each snapshot, and compares its session.
class Gamepad final : public QObject
{
    Q_OBJECT
public:
    enum class Loss {
        Unplugged,
        Silent,  ///< the thread that reads it hangs
    };
    Q_ENUM(Loss)
    /// One of those that are plugged in, as the operator knows it.
    struct Kind
    {
        QByteArray guid;
        QString name;
        friend bool operator==(const Kind &, const Kind &) = default;
    };
    /// Keeps what was set up, by the kind of gamepad and what it is used for, and which one was chosen.
    struct Store
    {
        std::function<QByteArray(const QByteArray &key)> load;
        std::function<void(const QByteArray &key, const QByteArray &json)> save;  ///< empty: forgotten
        std::function<Kind()> chosen = {};
        std::function<void(const Kind &kind)> choose = {};
    };

    Gamepad(Store store, GamepadPoller::Maker maker, QObject *parent = nullptr);
    ~Gamepad() override;

    /// Reads until this user, and all others, have let go or are destroyed.
    void use(QObject &user);
    void letGo(QObject &user);
    [[nodiscard]] bool isUsed() const { return !m_users.isEmpty(); }

    /// As of the last poll; without users of nothing at all.
    [[nodiscard]] GamepadSnapshot snapshot() const;
    /// The pad in use as the device has it; nothing without one.
    [[nodiscard]] std::optional<GamepadReading> reading() const;
    /// Kind and name of those that are plugged in.
    [[nodiscard]] QList<std::pair<QByteArray, QString>> pads() const;
    /// The one to use when several are plugged in; it is changed over to at once, and remembered.
    void prefer(const Kind &kind);
    /// What is steered by it now; each use has its own mapping.
    void setUse(GamepadUse use);
    [[nodiscard]] GamepadUse steers() const { return m_use; }
    /// Why none can be read: the module is missing, or the system refuses.
    [[nodiscard]] std::optional<Error> error() const;

    /// Of the pad in use: what was set up, or the default for it; nothing is assigned without one.
    [[nodiscard]] GamepadMapping mapping() const;
    /// The mapping is the default one.
    [[nodiscard]] bool isStandard() const;
    /// There is a default for the pad in use.
    [[nodiscard]] bool hasStandard() const;
    /// Forgets what was set up for it.
    void useStandard();
    /// Sets it for that kind of pad, and keeps it. Without a pad nothing happens.
    void setMapping(const GamepadMapping &mapping);

    /// Where readings come from, for tests and pictures; while nobody uses it.
    void setMaker(GamepadPoller::Maker maker);

signals:
    /// A pad came or went, was set up, or cannot be read.
    void changed();
    /// The pad that was in use is not there any more, or not heard of.
    void lost(Gamepad::Loss why);

private:
    void look();
    struct Mapped
    {
        QByteArray key;  // in the store
        GamepadMapping mapping;
        bool isStandard = false;
    };
    [[nodiscard]] const Mapped &mapped(const GamepadReading &pad) const;

    Store m_store;
    GamepadPoller::Maker m_maker;
    std::shared_ptr<GamepadPoller> m_poller;
    QList<QObject *> m_users;
    QTimer m_watch;
    Kind m_preferred;
    GamepadUse m_use = GamepadUse::Camera;
    // As it was at the last look.
    bool m_wasAlive = false;
    quint64 m_session = 0;
    bool m_hadError = false;
    qsizetype m_padCount = 0;
    mutable Mapped m_mapped;  // of the pad that was asked for last
};
