// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/supervisor/alarm.h"

#include <QObject>
#include <QSettings>

/// What the operator has chosen, kept in an INI file after the XDG rules.
class Settings final : public QObject
{
    Q_OBJECT
public:
    enum class ThemeChoice { System, Light, Dark };
    Q_ENUM(ThemeChoice)

    explicit Settings(const QString &path = defaultPath(), QObject *parent = nullptr);
    [[nodiscard]] static QString defaultPath();

    [[nodiscard]] ThemeChoice theme() const;
    void setTheme(ThemeChoice theme);
    /// Language code ("de"), empty = the system's. Takes effect at the next start.
    [[nodiscard]] QString language() const { return m_file.value(kLanguage).toString(); }
    void setLanguage(const QString &code) { set(kLanguage, code); }
    [[nodiscard]] bool fahrenheit() const { return m_file.value(kFahrenheit, false).toBool(); }
    void setFahrenheit(bool on) { set(kFahrenheit, on); }
    /// Minutes of live data kept in memory, 1 to 60.
    [[nodiscard]] int retentionMinutes() const;
    void setRetentionMinutes(int minutes) { set(kRetention, minutes); }

    /// Milliseconds that Esc must be held to switch the motors off, 300 to 3000; 0 = not by Esc.
    [[nodiscard]] int escapeHoldMs() const;
    void setEscapeHoldMs(int ms) { set(kEscapeHold, ms); }
    /// Highest speed that the control page sends, degrees per second, 1 to 360.
    [[nodiscard]] int controlSpeedLimit() const;
    void setControlSpeedLimit(int degreesPerSecond) { set(kSpeedLimit, degreesPerSecond); }
    /// Seconds without input by the operator until control is disarmed, 2 to 120.
    [[nodiscard]] int disarmSeconds() const;
    void setDisarmSeconds(int seconds) { set(kDisarm, seconds); }
    /// Whether closing the program while connected switches the motors off.
    [[nodiscard]] bool motorsOffOnQuit() const { return m_file.value(kMotorsOffOnQuit, false).toBool(); }
    void setMotorsOffOnQuit(bool on) { set(kMotorsOffOnQuit, on); }

    /// What the supervisor looks for and does; the limits of angles are the board's own and not in here.
    [[nodiscard]] SupervisorRules supervisorRules() const;
    /// Angles 5 to 90 degrees, oscillations 1 to 100 deg/s, cells 2.5 to 4.2 V, 30 to 120 °C.
    void setSupervisorRules(const SupervisorRules &rules);
    /// An alarm makes a sound.
    [[nodiscard]] bool alarmSound() const { return m_file.value(kAlarmSound, false).toBool(); }
    void setAlarmSound(bool on) { set(kAlarmSound, on); }

    [[nodiscard]] QString lastAddress() const { return m_file.value(kLastAddress).toString(); }
    void setLastAddress(const QString &address) { set(kLastAddress, address); }
    /// Addresses of boards that were reached and files that were opened, the latest first.
    [[nodiscard]] QStringList recentAddresses() const
    {
        return m_file.value(kRecentAddresses).toStringList();
    }
    void addRecentAddress(const QString &address) { addRecent(kRecentAddresses, address); }
    [[nodiscard]] QStringList recentFiles() const { return m_file.value(kRecentFiles).toStringList(); }
    void addRecentFile(const QString &path) { addRecent(kRecentFiles, path); }
    /// Sizes of windows and splitters, by name.
    [[nodiscard]] QByteArray layout(const QString &name) const
    {
        return m_file.value(kLayout + name).toByteArray();
    }
    void setLayout(const QString &name, const QByteArray &state) { m_file.setValue(kLayout + name, state); }

    /// Names of the kept arrangements of plots.
    [[nodiscard]] QStringList plotLayouts() const;
    [[nodiscard]] QByteArray plotLayout(const QString &name) const;
    /// Keeps an arrangement under a name; an empty one forgets it.
    void setPlotLayout(const QString &name, const QByteArray &json);

    /// What a trial may have left on a board when it was cut off, by the board's serial number; empty: none.
    [[nodiscard]] QByteArray cutTrial(const QString &board) const
    {
        return m_file.value(kCutTrials + board).toByteArray();
    }
    void setCutTrial(const QString &board, const QByteArray &note);

signals:
    void changed();

private:
    static const QString kTheme, kLanguage, kFahrenheit, kRetention, kEscapeHold, kSpeedLimit, kDisarm,
        kMotorsOffOnQuit, kAlarmSound, kSupervisor, kLastAddress, kRecentAddresses, kRecentFiles, kLayout,
        kPlotLayouts, kCutTrials;
    void set(const QString &key, const QVariant &value);
    void addRecent(const QString &key, const QString &text);
    [[nodiscard]] int number(const QString &key, int standard, int low, int high) const;
    [[nodiscard]] double real(const QString &key, double standard, double low, double high) const;

    QSettings m_file;
};
