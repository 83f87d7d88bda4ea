// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/supervisor/alarmreport.h"
#include "widgets/models/errortext.h"

#include <QObject>

class ConfigurationModel;
class DeviceClient;
class LinkMarks;
class LiveModel;
class Settings;
class TelemetrySubscriptions;

/// What the supervisor has noticed on this link, as long as the operator has not acknowledged it; and what
/// the supervisor has to know of his settings and of the board's configuration.
class Alarms final : public QObject
{
    Q_OBJECT
public:
    Alarms(DeviceClient &client, const ConfigurationModel &configuration, LiveModel &live,
           TelemetrySubscriptions &telemetry, LinkMarks &marks, const Settings &settings);

    /// Newest first. Those that are over stay until they are acknowledged.
    [[nodiscard]] const QList<AlarmReport> &all() const { return m_reports; }
    /// Those that have to be seen now: they go on, the program did something about them, or the camera moved
    /// by itself or unseen.
    [[nodiscard]] QList<AlarmReport> pressing() const;
    [[nodiscard]] ErrorText text(const AlarmReport &report) const;
    /// How often the same happened since it was acknowledged last.
    [[nodiscard]] int timesOf(int number) const { return m_times.value(number, 1); }
    /// Takes it off the list. If it goes on, it comes back only when it began anew.
    void acknowledge(int number);
    /// The motors cannot be the remedy: the board flies, or they were switched off.
    [[nodiscard]] bool offersMotorsOff(const AlarmReport &report) const;
    void motorsOff();

signals:
    void changed();

private:
    void onAlarm(const AlarmReport &report);
    void applyRules();
    void onState();

    DeviceClient &m_client;
    const ConfigurationModel &m_configuration;
    LiveModel &m_live;
    LinkMarks &m_marks;
    const Settings &m_settings;
    QString m_serial;  // of the board that they are about
    QList<AlarmReport> m_reports;
    QHash<int, int> m_times;
    int m_acknowledged = 0;  // reports up to this number that are not on the list are not wanted any more
};
