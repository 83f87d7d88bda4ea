// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The report of a write as text and document.
#include "app/cli/command.h"
#include "widgets/models/errortext.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

QString stateText(WriteState state)
{
    switch (state) {
    case WriteState::Verified: return u"verified"_s;
    case WriteState::Unknown: return u"unknown"_s;
    case WriteState::NotWritten: return u"not written"_s;
    case WriteState::Mismatch: return u"mismatch"_s;
    case WriteState::RolledBack: return u"rolled back"_s;
    }
    return {};
}

// What was not to be written and is otherwise all the same.
void tellStrays(const WriteReport &report, QString &text, QJsonObject &json)
{
    QJsonArray strays;
    for (const ParameterChange &change : report.strays) {
        strays.append(QJsonObject{{u"key"_s, change.spec->key},
                                  {u"profile"_s, change.profile + 1},
                                  {u"before"_s, valueJson(*change.spec, change.from)},
                                  {u"onBoard"_s, valueJson(*change.spec, change.to)}});
        const QString profile
            = change.spec->row->scope == Scope::Profile && report.before.identity().profileCount > 1
            ? report.before.profileName(change.profile) + u": "_s
            : QString();
        text += u"%1 %2 %3%4 before, %5 now\n"_s.arg(
            u"not wanted"_s.leftJustified(12), change.spec->key.leftJustified(28), profile,
            valueText(*change.spec, change.from), valueText(*change.spec, change.to));
    }
    for (const QString &place : report.strayPlaces) {
        strays.append(QJsonObject{{u"place"_s, place}});
        text += u"%1 %2 is otherwise than before\n"_s.arg(u"not wanted"_s.leftJustified(12), place);
    }
    if (!strays.isEmpty())
        json.insert(u"notWanted"_s, strays);
}

}  // namespace

void tellReport(CommandOutcome &outcome)
{
    if (!outcome.report)
        return;
    const WriteReport &report = *outcome.report;
    QString text;
    QJsonObject json = outcome.json.toObject();
    QJsonArray lines;
    for (const WriteLine &line : report.lines) {
        QJsonObject object = changeJson({line.spec, line.profile, line.from, line.to});
        const bool isUntold = line.state == WriteState::Verified && line.isStoreUntold;
        const QString state = isUntold ? u"confirmed"_s : stateText(line.state);
        object.insert(u"state"_s, state);
        if (line.state != WriteState::Unknown)
            object.insert(u"onBoard"_s, valueJson(*line.spec, line.found));
        text += u"%1 %2 %3%4 -> %5"_s.arg(state.leftJustified(12), line.spec->key.leftJustified(28),
                                          profileOf(report, line), valueText(*line.spec, line.from),
                                          valueText(*line.spec, line.to));
        const bool isOld = sameValue(line.found, line.from);
        if (line.wasTakenOtherwise() && line.state != WriteState::Unknown) {
            object.insert(u"took"_s, valueJson(*line.spec, *line.taken));
            text += (isOld ? u" (the board took %1; %2 was put back)"_s
                           : u" (the board took %1 and holds %2)"_s)
                        .arg(valueText(*line.spec, *line.taken), valueText(*line.spec, line.found));
        } else if (line.state == WriteState::Mismatch) {
            text += (isOld ? u" (the board kept %1)"_s : u" (the board holds %1)"_s)
                        .arg(valueText(*line.spec, line.found));
        } else if (line.state == WriteState::RolledBack && line.taken) {
            text += u" (the board had taken it; %1 was put back)"_s.arg(valueText(*line.spec, line.found));
        }
        if (!line.setBy.isEmpty()) {
            object.insert(u"setBy"_s, line.setBy);
            if (line.state == WriteState::Verified)
                text += u" (stored; in use is what %1 sets)"_s.arg(line.setBy);
        }
        lines.append(object);
        text += u'\n';
    }
    tellStrays(report, text, json);
    QJsonArray data;
    for (const WriteData &block : report.data) {
        data.append(
            QJsonObject{{u"data"_s, QLatin1String(block.spec->data)}, {u"state"_s, stateText(block.state)}});
        text += u"%1 %2\n"_s.arg(stateText(block.state).leftJustified(12), QLatin1String(block.spec->data));
    }
    const QStringList names = report.onBoard.profileNames();
    if (report.namesWanted) {
        text += stateText(report.namesState).leftJustified(12) + u" profile names"_s;
        if (!report.areNamesWritten() && !report.areNamesUnknown())
            text += u" (the board holds %1)"_s.arg(names.join(u", "_s));
        text += u'\n';
    }
    json.insert(u"complete"_s, report.isComplete());
    json.insert(u"written"_s, lines);
    json.insert(u"data"_s, data);
    json.insert(u"namesWritten"_s, report.areNamesWritten());
    if (report.namesWanted) {
        QJsonObject told{{u"state"_s, stateText(report.namesState)}};
        if (!report.areNamesUnknown())
            told.insert(u"onBoard"_s, QJsonArray::fromStringList(names));
        json.insert(u"names"_s, told);
    }
    json.insert(u"snapshot"_s, report.snapshotPath);
    const QString others = tellOthers(report, text, json);
    QStringList notes;
    if (report.error) {
        outcome.exitCode = Refused;
        notes.append(forConsole(describe(report), report.error->code).oneLine());
        json.insert(u"error"_s, notes.first());
    } else if (report.restart.areTold()) {
        notes.append(restartText(report));
    }
    if (report.restart.areTold()) {
        json.insert(u"restart"_s,
                    QJsonObject{{u"silentSeconds"_s, report.restart.silentSeconds},
                                {u"motorsStarted"_s, report.restart.motorsStarted},
                                {u"motorsStopped"_s, report.restart.motorsStopped}});
    }
    // Whoever had switched them off, or on, counts on that.
    if (report.restart.motorsStarted || report.restart.motorsStopped)
        outcome.exitCode = Refused;
    if (!report.snapshotPath.isEmpty())
        notes.append(u"snapshot: "_s + report.snapshotPath
                     + (report.isSnapshotComplete() ? QString()
                                                    : u" (it lacks what could not be read: %1)"_s.arg(
                                                        report.snapshotLacks.join(u", "_s))));
    if (!others.isEmpty())
        notes.append(others);
    const int untold = report.countStoreUntold();
    if (untold > 0) {
        json.insert(u"storeUntold"_s, untold);
        notes.append(u"confirmed: the board used that already, so only its next start shows whether it has "
                     "stored it"_s);
    }
    if (report.storesUse) {
        json.insert(u"storesUse"_s, true);
        notes.append((
            report.isComplete() && untold == 0
                ? u"what else was set in use without being stored is stored now as well, if there was any: "
                  "this board does not tell"_s
                : u"what else was set in use without being stored may be stored now as well: this board does "
                  "not tell"_s));
    }
    // What was written is in use, and that is all.
    const bool isForNow
        = std::any_of(report.lines.begin(), report.lines.end(), [&report](const WriteLine &line) {
              const BlockSpec *block = report.before.parameters().block(line.spec->row->block);
              return line.state == WriteState::Verified && block && block->effect == WriteEffect::Volatile;
          });
    if (isForNow) {
        json.insert(u"untilRestart"_s, true);
        notes.append(u"in use until the board restarts, and not stored"_s);
    }
    if (!outcome.note.isEmpty())
        notes.append(outcome.note.trimmed());
    outcome.text = text + outcome.text;
    outcome.note = notes.join(u'\n');
    outcome.json = json;
}
