// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/filefault.h"
#include "protocol/supervisor/alarm.h"

#include <QObject>
#include <QSettings>
#include <QTimer>

#include <optional>

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
    /// Language code ("de"), empty = the system's.
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
    /// Whether an end of the link that leaves motors running is asked about.
    [[nodiscard]] bool askAboutMotors() const { return m_file.value(kAskAboutMotors, true).toBool(); }
    void setAskAboutMotors(bool on) { set(kAskAboutMotors, on); }

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
    /// Where the video of a drone comes from, as typed; empty: from the drone's own host.
    [[nodiscard]] QString videoAddress() const { return m_file.value(kVideoAddress).toString(); }
    void setVideoAddress(const QString &address) { set(kVideoAddress, address); }
    /// Where pictures and recordings of it are saved; empty: in the operator's folder for pictures.
    [[nodiscard]] QString videoFolder() const { return m_file.value(kVideoFolder).toString(); }
    void setVideoFolder(const QString &folder) { set(kVideoFolder, folder); }
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

    /// What the sticks of a kind of gamepad are used for, as it was kept; empty: not set up.
    [[nodiscard]] QByteArray gamepad(const QByteArray &key) const
    {
        return m_file.value(kGamepads + QString::fromLatin1(key)).toByteArray();
    }
    /// @param json empty: it is forgotten
    void setGamepad(const QByteArray &key, const QByteArray &json);
    /// The one to use of several: its kind, a space and its name; empty: none was chosen.
    [[nodiscard]] QString chosenGamepad() const { return m_file.value(kChosenGamepad).toString(); }
    void setChosenGamepad(const QString &kindAndName) { set(kChosenGamepad, kindAndName); }
    /// The control pages listen to a gamepad.
    [[nodiscard]] bool gamepadSteers() const { return m_file.value(kGamepadSteers, false).toBool(); }
    void setGamepadSteers(bool on) { set(kGamepadSteers, on); }

    /// What was found when the directions of a machine that flies were checked, by its serial number and what
    /// they depend on (FlyingMachine::axesKey); empty: nothing.
    [[nodiscard]] QByteArray checkedDirections(const QString &board, const QByteArray &axesKey) const;
    void setCheckedDirections(const QString &board, const QByteArray &axesKey, const QByteArray &found);
    /// Nothing of it is checked, whatever its axes depend on and its sticks were pushed with.
    void dropDirections(const QString &board);

    /// What is wrong with the file: it cannot be read, or values that somebody edited make no sense. These
    /// have their defaults, or the nearest value that is possible.
    [[nodiscard]] QList<Error> problems();

signals:
    void changed();
    /// What was set cannot be written to the file.
    void failed(const Error &error);

private:
    static const QString kTheme, kLanguage, kFahrenheit, kRetention, kEscapeHold, kSpeedLimit, kDisarm,
        kMotorsOffOnQuit, kAskAboutMotors, kAlarmSound, kSupervisor, kLastAddress, kRecentAddresses,
        kRecentFiles, kLayout, kPlotLayouts, kGamepads, kGamepadSteers, kChosenGamepad, kDirections,
        kVideoAddress, kVideoFolder;
    void set(const QString &key, const QVariant &value);
    void addRecent(const QString &key, const QString &text);
    struct Range
    {
        QString key;
        double standard = 0;
        double low = 0;
        double high = 0;
    };
    [[nodiscard]] static const QList<Range> &ranges();
    [[nodiscard]] double number(const QString &key) const;
    [[nodiscard]] std::optional<Error> fileError();
    [[nodiscard]] Error badEntry(FileProblem problem, const QString &key, const QString &expected) const;
    void checkSoon() { m_check.start(); }

    QSettings m_file;
    QTimer m_check;  // whether the file could be written
    bool m_failed = false;
};
