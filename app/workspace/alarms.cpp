// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/alarms.h"

#include "app/workspace/linkmarks.h"
#include "app/workspace/settings.h"
#include "app/workspace/telemetrysubscriptions.h"
#include "protocol/device/family.h"
#include "protocol/supervisor/boardlimits.h"
#include "protocol/telemetry/telemetrystore.h"
#include "widgets/models/alarmtext.h"
#include "widgets/models/configurationmodel.h"
#include "widgets/models/livemodel.h"

#include <QApplication>

#include <algorithm>
#include <utility>

using namespace Qt::StringLiterals;

Alarms::Alarms(DeviceClient &client, const ConfigurationModel &configuration, LiveModel &live,
               TelemetrySubscriptions &telemetry, LinkMarks &marks, const Settings &settings)
    : m_client(client)
    , m_configuration(configuration)
    , m_live(live)
    , m_marks(marks)
    , m_settings(settings)
{
    connect(&client, &DeviceClient::alarmChanged, this, &Alarms::onAlarm);
    connect(&client, &DeviceClient::stateChanged, this, &Alarms::onState);
    connect(&settings, &Settings::changed, this, &Alarms::applyRules);
    connect(&configuration, &ConfigurationModel::boardReset, this, &Alarms::applyRules);
    connect(&configuration, &ConfigurationModel::storedChanged, this, &Alarms::applyRules);
    connect(&configuration, &ConfigurationModel::activeProfileChanged, this, &Alarms::applyRules);
    // On every page, and fast enough to see an oscillation.
    telemetry.subscribe(this, [&client] {
        const ChannelRoles &roles = client.roles();
        return ChannelRoles::present({roles.angle, roles.target, roles.gyro, roles.motorTemperature});
    });
    applyRules();
}

void Alarms::applyRules()
{
    SupervisorRules rules = m_settings.supervisorRules();
    if (const auto device = m_client.device(); device && !m_configuration.isEmpty())
        setBoardLimits(rules, *device, m_configuration.board());
    m_client.setSupervisorRules(rules);
}

void Alarms::onState()
{
    const DeviceClient::State state = m_client.state();
    const bool isConnected = state == DeviceClient::State::Connected;
    const bool isOther
        = isConnected && std::exchange(m_serial, m_client.identity().serial) != m_client.identity().serial;
    if (isConnected && !isOther)
        return;
    // What was told of one board says nothing about the next. Without a link nobody sees whether it goes on:
    // what does is told again.
    const bool isNext = isOther || state == DeviceClient::State::Connecting;
    m_reports.removeIf([isNext](const AlarmReport &report) { return isNext || !report.hasActed(); });
    if (isNext)
        m_times.clear();
    emit changed();
}

void Alarms::onAlarm(const AlarmReport &report)
{
    const auto known = std::find_if(m_reports.begin(), m_reports.end(),
                                    [&](const AlarmReport &each) { return each.number == report.number; });
    const auto tookBack = [](const AlarmReport &each) { return each.change.has_value(); };
    const bool isNewlyBack = tookBack(report) && (known == m_reports.end() || !tookBack(*known));
    if (isNewlyBack)
        m_live.read();  // the values in use are others now
    if (known != m_reports.end()) {
        *known = report;
    } else {
        // What is not on the list any more has gone with its link, which ended it.
        if (report.number <= m_acknowledged || report.isOver)
            return;
        // One card for one cause, however often it comes back.
        int times = 1;
        for (auto it = m_reports.begin(); it != m_reports.end();) {
            if (it->alarm.isSame(report.alarm) && it->isOver) {
                times += m_times.take(it->number);
                times += times == 1;
                it = m_reports.erase(it);
            } else {
                ++it;
            }
        }
        m_times.insert(report.number, times);
        m_reports.prepend(report);
        m_marks.add(PlotMark::Kind::Fault, u"%1: %2"_s.arg(alarmName(report.alarm), text(report).what));
        if (m_settings.alarmSound())
            QApplication::beep();
    }
    emit changed();
}

ErrorText Alarms::text(const AlarmReport &report) const
{
    const ParameterSet *set = m_configuration.isEmpty() ? nullptr : &m_configuration.board().parameters();
    return describe(report, set);
}

QList<AlarmReport> Alarms::pressing() const
{
    QList<AlarmReport> list;
    std::copy_if(m_reports.begin(), m_reports.end(), std::back_inserter(list), [](const AlarmReport &report) {
        return !report.isOver || report.hasActed() || report.alarm.isUnwantedMotion();
    });
    // What goes on comes before what is over, and what moves before what only wears out.
    std::stable_sort(list.begin(), list.end(), [](const AlarmReport &a, const AlarmReport &b) {
        return std::pair(a.isOver, a.alarm.kind) < std::pair(b.isOver, b.alarm.kind);
    });
    return list;
}

void Alarms::acknowledge(int number)
{
    m_acknowledged = std::max(m_acknowledged, number);
    m_reports.removeIf([number](const AlarmReport &report) { return report.number == number; });
    m_times.remove(number);
    emit changed();
}

bool Alarms::offersMotorsOff(const AlarmReport &report) const
{
    if (!m_client.isConnected() || report.isOver
        || (report.action == AlarmAction::MotorsOff && report.outcome != AlarmOutcome::NotProven))
        return false;
    const int outputs = m_client.roles().outputs;
    if (const auto store = m_client.telemetry(); store && outputs >= 0 && store->latest(outputs) == 0)
        return false;
    if (report.alarm.kind == AlarmKind::Disarmed)
        return true;
    const auto families = m_client.families();
    return std::none_of(families.begin(), families.end(), [this](const Family &family) {
        return family.key == m_client.identity().family && family.nouns.flies;
    });
}

void Alarms::motorsOff()
{
    m_client.motorsOff();
}
