// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/settings.h"

#include <QStandardPaths>

#include <algorithm>

using namespace Qt::StringLiterals;

const QString Settings::kTheme = u"look/theme"_s;
const QString Settings::kLanguage = u"look/language"_s;
const QString Settings::kFahrenheit = u"units/fahrenheit"_s;
const QString Settings::kRetention = u"data/retentionMinutes"_s;
const QString Settings::kEscapeHold = u"safety/escapeHoldMs"_s;
const QString Settings::kSpeedLimit = u"safety/controlSpeedLimit"_s;
const QString Settings::kDisarm = u"safety/disarmSeconds"_s;
const QString Settings::kMotorsOffOnQuit = u"safety/motorsOffOnQuit"_s;
const QString Settings::kLastAddress = u"link/lastAddress"_s;
const QString Settings::kRecentAddresses = u"link/recentAddresses"_s;
const QString Settings::kRecentFiles = u"files/recent"_s;
const QString Settings::kLayout = u"layout/"_s;
const QString Settings::kCutTrials = u"trials/"_s;
const QString Settings::kPlotLayouts = u"data/plotLayouts"_s;

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
