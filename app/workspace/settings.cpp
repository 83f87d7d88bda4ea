// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/settings.h"

#include <QStandardPaths>

#include <algorithm>
#include <array>
#include <cmath>

using namespace Qt::StringLiterals;

const QString Settings::kTheme = u"look/theme"_s;
const QString Settings::kLanguage = u"look/language"_s;
const QString Settings::kFahrenheit = u"units/fahrenheit"_s;
const QString Settings::kRetention = u"data/retentionMinutes"_s;
const QString Settings::kEscapeHold = u"safety/escapeHoldMs"_s;
const QString Settings::kSpeedLimit = u"safety/controlSpeedLimit"_s;
const QString Settings::kDisarm = u"safety/disarmSeconds"_s;
const QString Settings::kMotorsOffOnQuit = u"safety/motorsOffOnQuit"_s;
const QString Settings::kAlarmSound = u"supervisor/sound"_s;
const QString Settings::kSupervisor = u"supervisor/"_s;
const QString Settings::kLastAddress = u"link/lastAddress"_s;
const QString Settings::kRecentAddresses = u"link/recentAddresses"_s;
const QString Settings::kRecentFiles = u"files/recent"_s;
const QString Settings::kLayout = u"layout/"_s;
const QString Settings::kCutTrials = u"trials/"_s;
const QString Settings::kPlotLayouts = u"data/plotLayouts"_s;

namespace {

// Names in the file, in the order of the enumerations.
constexpr std::array<const char *, kAlarmKinds> kKindNames{"runaway", "oscillation", "limit",   "saturation",
                                                           "sensor",  "heat",        "battery", "stale"};
constexpr std::array<const char *, 4> kActionNames{"warn", "back", "back-else-off", "off"};

}  // namespace

Settings::Settings(const QString &path, QObject *parent)
    : QObject(parent)
    , m_file(path, QSettings::IniFormat)
{
}

QString Settings::defaultPath()
{
    return QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation)
        + u"/gimbaldesk/gimbaldesk.ini"_s;
}

void Settings::set(const QString &key, const QVariant &value)
{
    if (m_file.value(key) == value)
        return;
    m_file.setValue(key, value);
    emit changed();
}

void Settings::addRecent(const QString &key, const QString &text)
{
    constexpr qsizetype kKept = 6;
    QStringList recent = m_file.value(key).toStringList();
    recent.removeAll(text);
    recent.prepend(text);
    set(key, recent.mid(0, kKept));
}

// The file may have been edited by hand, so numbers are clamped to their range.
int Settings::number(const QString &key, int standard, int low, int high) const
{
    bool ok = false;
    const int value = m_file.value(key, standard).toInt(&ok);
    return ok ? std::clamp(value, low, high) : standard;
}

double Settings::real(const QString &key, double standard, double low, double high) const
{
    bool ok = false;
    const double value = m_file.value(key, standard).toDouble(&ok);
    return ok && std::isfinite(value) ? std::clamp(value, low, high) : standard;
}

SupervisorRules Settings::supervisorRules() const
{
    SupervisorRules rules;
    for (std::size_t kind = 0; kind < kAlarmKinds; ++kind) {
        const QString name = m_file.value(kSupervisor + QLatin1String(kKindNames[kind])).toString();
        const auto found = std::find_if(kActionNames.begin(), kActionNames.end(),
                                        [&name](const char *known) { return name == QLatin1String(known); });
        if (found == kActionNames.end())
            continue;
        const auto action = AlarmAction(found - kActionNames.begin());
        if (SupervisorRules::offers(AlarmKind(kind), action))
            rules.actions[kind] = action;
    }
    rules.runawayDeg = real(kSupervisor + u"runawayDegrees"_s, rules.runawayDeg, 5, 90);
    rules.oscillation = real(kSupervisor + u"oscillationRate"_s, rules.oscillation, 1, 100);
    rules.cellVolts = real(kSupervisor + u"cellVolts"_s, rules.cellVolts, 2.5, 4.2);
    rules.hotCelsius = real(kSupervisor + u"hotCelsius"_s, rules.hotCelsius, 30, 120);
    return rules;
}

void Settings::setSupervisorRules(const SupervisorRules &rules)
{
    const SupervisorRules before = supervisorRules();
    // Only what was changed: what stays at its default follows the default of later versions.
    for (std::size_t kind = 0; kind < kAlarmKinds; ++kind) {
        if (rules.actions[kind] != before.actions[kind])
            set(kSupervisor + QLatin1String(kKindNames[kind]),
                QString::fromLatin1(kActionNames[std::size_t(rules.actions[kind])]));
    }
    const auto put = [this](const QString &key, double value, double was) {
        if (value != was)
            set(kSupervisor + key, value);
    };
    put(u"runawayDegrees"_s, rules.runawayDeg, before.runawayDeg);
    put(u"oscillationRate"_s, rules.oscillation, before.oscillation);
    put(u"cellVolts"_s, rules.cellVolts, before.cellVolts);
    put(u"hotCelsius"_s, rules.hotCelsius, before.hotCelsius);
}

Settings::ThemeChoice Settings::theme() const
{
    const QString name = m_file.value(kTheme).toString();
    return name == u"light"_s ? ThemeChoice::Light
        : name == u"dark"_s   ? ThemeChoice::Dark
                              : ThemeChoice::System;
}

void Settings::setTheme(ThemeChoice theme)
{
    set(kTheme,
        theme == ThemeChoice::Light      ? u"light"_s
            : theme == ThemeChoice::Dark ? u"dark"_s
                                         : u"system"_s);
}

int Settings::retentionMinutes() const
{
    return number(kRetention, 10, 1, 60);
}

int Settings::escapeHoldMs() const
{
    const int ms = number(kEscapeHold, 700, 0, 3000);
    return ms == 0 ? 0 : std::max(ms, 300);
}

int Settings::controlSpeedLimit() const
{
    return number(kSpeedLimit, 60, 1, 360);
}

int Settings::disarmSeconds() const
{
    return number(kDisarm, 20, 2, 120);
}

// One map for all: names may hold characters that mean something in a settings file's keys.
QStringList Settings::plotLayouts() const
{
    return m_file.value(kPlotLayouts).toMap().keys();
}

QByteArray Settings::plotLayout(const QString &name) const
{
    return m_file.value(kPlotLayouts).toMap().value(name).toByteArray();
}

void Settings::setPlotLayout(const QString &name, const QByteArray &json)
{
    QVariantMap layouts = m_file.value(kPlotLayouts).toMap();
    if (json.isEmpty())
        layouts.remove(name);
    else
        layouts.insert(name, json);
    m_file.setValue(kPlotLayouts, layouts);
}

void Settings::setCutTrial(const QString &board, const QByteArray &note)
{
    if (note.isEmpty())
        m_file.remove(kCutTrials + board);
    else
        m_file.setValue(kCutTrials + board, note);
    m_file.sync();
}
