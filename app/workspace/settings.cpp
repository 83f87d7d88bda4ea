// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/settings.h"

#include "protocol/supervisor/alarmkeys.h"

#include <QFileInfo>
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
const QString Settings::kAskAboutMotors = u"safety/askAboutMotors"_s;
const QString Settings::kAlarmSound = u"supervisor/sound"_s;
const QString Settings::kSupervisor = u"supervisor/"_s;
const QString Settings::kLastAddress = u"link/lastAddress"_s;
const QString Settings::kRecentAddresses = u"link/recentAddresses"_s;
const QString Settings::kRecentFiles = u"files/recent"_s;
const QString Settings::kLayout = u"layout/"_s;
const QString Settings::kGamepads = u"gamepads/"_s;
const QString Settings::kChosenGamepad = u"control/chosenGamepad"_s;
const QString Settings::kGamepadSteers = u"control/gamepad"_s;
const QString Settings::kDirections = u"directions/"_s;
const QString Settings::kVideoAddress = u"video/address"_s;
const QString Settings::kVideoFolder = u"video/folder"_s;
const QString Settings::kPlotLayouts = u"data/plotLayouts"_s;

namespace {

// Names in the file, in the order of the enumeration.
constexpr std::array<const char *, 4> kActionNames{"warn", "back", "back-else-off", "off"};

}  // namespace

Settings::Settings(const QString &path, QObject *parent)
    : QObject(parent)
    , m_file(path, QSettings::IniFormat)
{
    m_check.setSingleShot(true);
    m_check.setInterval(0);
    connect(&m_check, &QTimer::timeout, this, [this] {
        const auto error = fileError();
        if (error && !m_failed)  // once is enough
            emit failed(*error);
        m_failed = error.has_value();
    });
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
    checkSoon();
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

const QList<Settings::Range> &Settings::ranges()
{
    static const SupervisorRules rules;
    static const QList<Range> all{
        {kRetention, 10, 1, 60},
        {kEscapeHold, 700, 0, 3000},
        {kSpeedLimit, 60, 1, 360},
        {kDisarm, 20, 2, 120},
        {kSupervisor + u"runawayDegrees"_s, rules.runawayDeg, 5, 90},
        {kSupervisor + u"oscillationRate"_s, rules.oscillation, 1, 100},
        {kSupervisor + u"cellVolts"_s, rules.cellVolts, 2.5, 4.2},
        {kSupervisor + u"hotCelsius"_s, rules.hotCelsius, 30, 120},
    };
    return all;
}

// The file may have been edited by hand, so numbers are clamped to their range; problems() says so.
double Settings::number(const QString &key) const
{
    const auto range = std::find_if(ranges().begin(), ranges().end(),
                                    [&key](const Range &each) { return each.key == key; });
    bool ok = false;
    const double value = m_file.value(key, range->standard).toDouble(&ok);
    return ok && std::isfinite(value) ? std::clamp(value, range->low, range->high) : range->standard;
}

std::optional<Error> Settings::fileError()
{
    m_file.sync();
    if (m_file.status() == QSettings::NoError)
        return {};
    const bool isDamaged = m_file.status() == QSettings::FormatError;
    const bool isReadable = QFileInfo(m_file.fileName()).isReadable() || !QFile::exists(m_file.fileName());
    return FileFault{.problem = isDamaged ? FileProblem::Damaged
                         : isReadable     ? FileProblem::NotWritable
                                          : FileProblem::NotReadable,
                     .kind = FileKind::ProgramSettings,
                     .path = m_file.fileName(),
                     .writing = !isDamaged && isReadable}
        .error();
}

// With its line: "[section]", then "name=value".
Error Settings::badEntry(FileProblem problem, const QString &key, const QString &expected) const
{
    FileFault fault{.problem = problem, .kind = FileKind::ProgramSettings, .path = m_file.fileName()};
    fault.key = key;
    fault.value = m_file.value(key).toString();
    fault.expected = expected;
    QFile file(m_file.fileName());
    QByteArray section;
    if (file.open(QIODevice::ReadOnly)) {
        for (int number = 1; !file.atEnd() && fault.line == 0; ++number) {
            const QByteArray line = file.readLine().trimmed();
            if (line.startsWith('[') && line.endsWith(']'))
                section = line.mid(1, line.size() - 2);
            if (QString::fromLatin1(section + '/' + line.split('=').first().trimmed()) == key)
                fault.line = number;
        }
    }
    return fault.error();
}

QList<Error> Settings::problems()
{
    QList<Error> list;
    if (const auto error = fileError())
        list.append(*error);
    for (const Range &range : ranges()) {
        if (!m_file.contains(range.key))
            continue;
        bool ok = false;
        const double value = m_file.value(range.key).toDouble(&ok);
        if (!ok || !(value >= range.low && value <= range.high))
            list.append(badEntry(ok ? FileProblem::OutOfRange : FileProblem::BadValue, range.key,
                                 u"%1 to %2"_s.arg(range.low).arg(range.high)));
    }
    const auto checkWord = [this, &list](const QString &key, const QStringList &words) {
        if (m_file.contains(key) && !words.contains(m_file.value(key).toString()))
            list.append(badEntry(FileProblem::BadValue, key, words.join(u", "_s)));
    };
    checkWord(kTheme, {u"light"_s, u"dark"_s, u"system"_s});
    for (std::size_t kind = 0; kind < kAlarmKinds; ++kind) {
        QStringList words;
        for (std::size_t action = 0; action < kActionNames.size(); ++action) {
            if (SupervisorRules::offers(AlarmKind(kind), AlarmAction(action)))
                words.append(QLatin1String(kActionNames[action]));
        }
        checkWord(kSupervisor + QLatin1String(kAlarmKeys[kind]), words);
    }
    return list;
}

SupervisorRules Settings::supervisorRules() const
{
    SupervisorRules rules;
    for (std::size_t kind = 0; kind < kAlarmKinds; ++kind) {
        const QString name = m_file.value(kSupervisor + QLatin1String(kAlarmKeys[kind])).toString();
        const auto found = std::find_if(kActionNames.begin(), kActionNames.end(),
                                        [&name](const char *known) { return name == QLatin1String(known); });
        if (found == kActionNames.end())
            continue;
        const auto action = AlarmAction(found - kActionNames.begin());
        if (SupervisorRules::offers(AlarmKind(kind), action))
            rules.actions[kind] = action;
    }
    rules.runawayDeg = number(kSupervisor + u"runawayDegrees"_s);
    rules.oscillation = number(kSupervisor + u"oscillationRate"_s);
    rules.cellVolts = number(kSupervisor + u"cellVolts"_s);
    rules.hotCelsius = number(kSupervisor + u"hotCelsius"_s);
    return rules;
}

void Settings::setSupervisorRules(const SupervisorRules &rules)
{
    const SupervisorRules before = supervisorRules();
    // Only what was changed: what stays at its default follows the default of later versions.
    for (std::size_t kind = 0; kind < kAlarmKinds; ++kind) {
        if (rules.actions[kind] != before.actions[kind])
            set(kSupervisor + QLatin1String(kAlarmKeys[kind]),
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
    return int(number(kRetention));
}

int Settings::escapeHoldMs() const
{
    const int ms = int(number(kEscapeHold));
    return ms == 0 ? 0 : std::max(ms, 300);
}

int Settings::controlSpeedLimit() const
{
    return int(number(kSpeedLimit));
}

int Settings::disarmSeconds() const
{
    return int(number(kDisarm));
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
    checkSoon();
}

void Settings::setGamepad(const QByteArray &key, const QByteArray &json)
{
    if (json.isEmpty())
        m_file.remove(kGamepads + QString::fromLatin1(key));
    else
        m_file.setValue(kGamepads + QString::fromLatin1(key), json);
    checkSoon();
}

// One entry for a board: with another configuration it has to be checked anew.
QByteArray Settings::checkedDirections(const QString &board, const QByteArray &axesKey) const
{
    const QByteArray kept = m_file.value(kDirections + board).toByteArray();
    return !axesKey.isEmpty() && kept.startsWith(axesKey + ':') ? kept.mid(axesKey.size() + 1) : QByteArray();
}

void Settings::setCheckedDirections(const QString &board, const QByteArray &axesKey, const QByteArray &found)
{
    m_file.setValue(kDirections + board, axesKey + ':' + found);
    m_file.sync();
    emit changed();
}

void Settings::dropDirections(const QString &board)
{
    for (const QString &key : m_file.allKeys()) {
        if (key == kDirections + board || key.startsWith(kDirections + board + u'-'))
            m_file.remove(key);
    }
    m_file.sync();
    emit changed();
}
