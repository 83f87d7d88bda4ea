// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/guide/setuprecord.h"

#include "protocol/base/axis.h"
#include "protocol/base/filefault.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr qint64 kLargestRecord = 1 << 20;
const QString kFormat = u"gimbaldesk-setup"_s;
constexpr int kFormatVersion = 1;
using State = SetupResult::State;
constexpr std::array kStates{std::pair(State::Open, "open"), std::pair(State::Done, "done"),
                             std::pair(State::Poor, "poor"), std::pair(State::Skipped, "skipped"),
                             std::pair(State::Failed, "failed")};

QJsonObject resultJson(const SetupResult &result)
{
    QJsonArray figures;
    for (const SetupFigure &figure : result.figures) {
        QJsonObject entry{{u"key"_s, figure.key}, {u"value"_s, figure.value}};
        if (figure.before)
            entry.insert(u"before"_s, *figure.before);
        figures.append(entry);
    }
    QJsonArray changes;
    for (const SetupChange &change : result.changes)
        changes.append(QJsonObject{{u"key"_s, change.key},
                                   {u"profile"_s, change.profile + 1},
                                   {u"from"_s, change.from},
                                   {u"to"_s, change.to}});
    return {{u"state"_s, setupStateKey(result.state)},
            {u"at"_s, result.at.toUTC().toString(Qt::ISODate)},
            {u"figures"_s, figures},
            {u"remarks"_s, QJsonArray::fromStringList(result.remarks)},
            {u"changes"_s, changes},
            {u"why"_s, result.why},
            {u"snapshot"_s, result.snapshot}};
}

SetupResult resultOf(const QJsonObject &json)
{
    SetupResult result;
    const QString state = json.value(u"state"_s).toString();
    for (const auto &[value, key] : kStates) {
        if (state == QLatin1String(key))
            result.state = value;
    }
    result.at = QDateTime::fromString(json.value(u"at"_s).toString(), Qt::ISODate);
    for (const QJsonValue &each : json.value(u"figures"_s).toArray()) {
        SetupFigure figure{each[u"key"_s].toString(), each[u"value"_s].toDouble()};
        if (each[u"before"_s].isDouble())
            figure.before = each[u"before"_s].toDouble();
        result.figures.append(figure);
    }
    for (const QJsonValue &each : json.value(u"remarks"_s).toArray())
        result.remarks.append(each.toString());
    for (const QJsonValue &each : json.value(u"changes"_s).toArray())
        result.changes.append({each[u"key"_s].toString(), each[u"profile"_s].toInt(1) - 1,
                               each[u"from"_s].toString(), each[u"to"_s].toString()});
    result.why = json.value(u"why"_s).toString();
    result.snapshot = json.value(u"snapshot"_s).toString();
    return result;
}

}  // namespace

QString setupStateKey(SetupResult::State state)
{
    const auto it = std::find_if(kStates.begin(), kStates.end(),
                                 [state](const auto &each) { return each.first == state; });
    return QLatin1String(it->second);
}

bool SetupResult::hasChanged() const
{
    return std::any_of(changes.begin(), changes.end(),
                       [](const SetupChange &change) { return change.from != change.to; });
}

std::optional<double> SetupResult::figure(const QString &key) const
{
    const auto it = std::find_if(figures.begin(), figures.end(),
                                 [&key](const SetupFigure &each) { return each.key == key; });
    return it == figures.end() ? std::nullopt : std::optional(it->value);
}

SetupResult SetupRecord::result(SetupStep step) const
{
    const auto it = m_results.find(step);
    return it == m_results.end() ? SetupResult() : it->second;
}

void SetupRecord::add(SetupStep step, SetupResult result)
{
    const SetupResult before = this->result(step);
    if (result.state == State::Done && before.state == State::Done && !result.hasChanged()) {
        result.changes = before.changes;
        result.snapshot = before.snapshot;
        for (SetupFigure &figure : result.figures) {
            const auto old
                = std::find_if(before.figures.begin(), before.figures.end(),
                               [&figure](const SetupFigure &each) { return each.key == figure.key; });
            if (old != before.figures.end() && (!figure.before || *figure.before == figure.value))
                figure.before = old->before;
        }
    }
    set(step, result);
}

// Or a later step has written it.
bool SetupRecord::isHeld(const SetupChange &change, const Configuration &board) const
{
    const ParameterSpec *spec = board.parameters().find(change.key);
    const auto raw = spec ? board.raw(*spec, change.profile) : std::nullopt;
    if (!raw)
        return true;
    return std::ranges::any_of(m_results, [&](const auto &each) {
        return std::ranges::any_of(each.second.changes, [&](const SetupChange &other) {
            return other.key == change.key && other.profile == change.profile
                && spec->format(*raw) == other.to;
        });
    });
}

bool SetupRecord::compare(const Configuration &board)
{
    bool isAny = false;
    for (auto &[step, result] : m_results) {
        const bool isOther = std::any_of(result.changes.begin(), result.changes.end(),
                                         [&](const SetupChange &change) { return !isHeld(change, board); });
        if (!isOther || result.state != State::Done)
            continue;
        result.state = State::Poor;
        result.remarks = QStringList{u"changed.since"_s};
        isAny = true;
    }
    return isAny;
}

std::optional<SetupStep> SetupRecord::next(const std::vector<SetupStep> &steps) const
{
    const auto it
        = std::find_if(steps.begin(), steps.end(), [this](SetupStep step) { return !result(step).isOver(); });
    return it == steps.end() ? std::nullopt : std::optional(*it);
}

QJsonObject SetupRecord::toJson() const
{
    QJsonObject steps;
    for (const auto &[step, result] : m_results)
        steps.insert(QLatin1String(setupStep(step).action.key), resultJson(result));
    return {{u"format"_s, kFormat},           {u"version"_s, kFormatVersion},
            {u"board"_s, m_identity.model},   {u"firmware"_s, m_identity.firmware},
            {u"serial"_s, m_identity.serial}, {u"steps"_s, steps}};
}

Result<SetupRecord> SetupRecord::fromJson(const QJsonObject &json, const BoardIdentity &identity)
{
    if (json.value(u"format"_s).toString() != kFormat || json.value(u"version"_s).toInt() > kFormatVersion)
        return failure(ErrorCode::InvalidArgument, u"not a record of a set-up that this version reads"_s);
    SetupRecord record(identity);
    const QJsonObject steps = json.value(u"steps"_s).toObject();
    for (auto it = steps.begin(); it != steps.end(); ++it) {
        if (const SetupStepSpec *spec = findSetupStep(it.key()))
            record.set(spec->step, resultOf(it->toObject()));
    }
    return record;
}

Result<void> SetupRecord::save(const QString &path) const
{
    QDir().mkpath(QFileInfo(path).path());  // the first that is kept of a board; what fails, writing says
    return writeWhole(path, QJsonDocument(toJson()).toJson(), FileKind::Other);
}

Result<SetupRecord> SetupRecord::load(const QString &path, const BoardIdentity &identity)
{
    if (!QFileInfo::exists(path))
        return SetupRecord(identity);
    const auto bytes = readWhole(path, FileKind::Other, kLargestRecord);
    if (!bytes)
        return tl::unexpected(bytes.error());
    const QJsonDocument document = QJsonDocument::fromJson(*bytes);
    const auto record = fromJson(document.object(), identity);
    if (record)
        return record;
    return fileFailure({.problem = FileProblem::Damaged, .path = path});
}

QString setupFigureText(const SetupFigure &figure)
{
    const SetupFigureSpec *spec = findSetupFigure(figure.key);
    const int decimals = spec ? spec->decimals : 3;
    const QString unit = spec && *spec->unit ? u' ' + QString::fromUtf8(spec->unit) : QString();
    const auto number = [decimals](double value) {
        const QString text = QString::number(value, 'f', decimals);
        return text.toDouble() == 0 ? QString::number(0.0, 'f', decimals) : text;  // no "-0.0"
    };
    const QString text = number(figure.value) + unit;
    return figure.before ? u"%1 ← %2"_s.arg(text, number(*figure.before)) : text;
}

SetupValueWords setupValueNames(std::shared_ptr<const ParameterSet> parameters)
{
    return [parameters = std::move(parameters)](const QString &key, const QString &value) -> QString {
        const ParameterSpec *spec = parameters->find(key);
        const auto raw = spec && spec->row->kind == ValueKind::Choice ? spec->parse(value) : std::nullopt;
        for (const Choice &choice : raw ? spec->choices(spec->firmware) : std::vector<Choice>()) {
            if (choice.value == *raw)
                return QLatin1String(choice.name);
        }
        return value;
    };
}

QString setupChangeText(const SetupChange &change, const SetupValueWords &valueOf, const QString &arrow)
{
    const QString to = valueOf(change.key, change.to);
    return change.from == change.to ? to : u"%1 %2 %3"_s.arg(valueOf(change.key, change.from), arrow, to);
}

QString setupFigureLabel(const SetupFigure &figure, const SetupWords &words)
{
    const SetupFigureSpec *spec = findSetupFigure(figure.key);
    QString label = spec ? words(spec->label) : figure.key;
    for (const Axis axis : kAxes) {
        if (figure.key.endsWith(u'.' + QLatin1String(axisKey(axis))))
            label += u" · "_s + words(axis == Axis::Roll ? "Roll" : axis == Axis::Pitch ? "Pitch" : "Yaw");
    }
    return label;
}
