// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What else was in use without being stored, on boards that store everything at once.
#include "app/cli/command.h"
#include "protocol/configuration/leap.h"
#include "protocol/procedure/inuse.h"
#include "protocol/procedure/wholewrite.h"

#include <QJsonArray>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

struct Way
{
    OtherValues others;
    const char *word;
    const char *done;
};
constexpr std::array kWays{
    Way{OtherValues::Keep, "keep", "kept"},
    Way{OtherValues::Store, "store", "stored"},
    Way{OtherValues::PutBack, "restore", "restored"},
};

}  // namespace

CommandOption othersOption(std::optional<OtherValues> &others)
{
    return {
        u"others"_s, u"WHAT"_s,
        u"values in use that are not stored: keep leaves them so (default), store stores them too, restore "
        u"puts the stored ones into use"_s,
        [&others](const QString &text) -> Result<void> {
            for (const Way &way : kWays) {
                if (text == QLatin1String(way.word)) {
                    others = way.others;
                    return {};
                }
            }
            return failure(ErrorCode::InvalidArgument,
                           u"--others is keep, store or restore, not '%1'"_s.arg(text));
        }};
}

Result<void> checkOthers(Device &device, std::optional<OtherValues> others)
{
    if (!others || device.wholeMemory())
        return {};
    return failure(
        ErrorCode::InvalidArgument,
        u"--others is for boards that store everything in use at once; this one stores the blocks that "
        u"are written, with whatever of them is in use"_s);
}

Result<Configuration> readBase(Channel &channel, Device &device, std::optional<OtherValues> others,
                               WriteOptions &options)
{
    if (const auto checked = checkOthers(device, others); !checked)
        return tl::unexpected(checked.error());
    options.others = others.value_or(OtherValues::Keep);
    if (WholeMemory *memory = device.wholeMemory(); memory && device.identity().writable) {
        auto both = memory->readBoth(channel);
        if (both) {
            options.contents = *both;
            return both->stored;
        }
        // The write says so, or refuses, by itself.
        if (!isUntold(both.error()))
            return tl::unexpected(both.error());
    }
    return device.readConfiguration(channel);
}

namespace {

// What a script had set between putting values into use and storing them.
QString tellMeanwhile(const WriteReport &report, QString &text, QJsonObject &json)
{
    if (report.storedMeanwhile.empty())
        return {};
    QJsonArray meanwhile;
    for (const StoredMeanwhile &value : report.storedMeanwhile) {
        meanwhile.append(QJsonObject{{u"key"_s, value.spec->key},
                                     {u"before"_s, valueJson(*value.spec, value.before)},
                                     {u"stored"_s, valueJson(*value.spec, value.now)},
                                     {u"setBy"_s, value.setBy}});
        text += u"%1 %2 %3 -> %4, because %5 sets it\n"_s.arg(
            u"stored too"_s.leftJustified(12), value.spec->key.leftJustified(28),
            valueText(*value.spec, value.before), valueText(*value.spec, value.now), value.setBy);
    }
    json.insert(u"storedMeanwhile"_s, meanwhile);
    return u"%1 not wanted and stored all the same, because a script sets it: stop the script before you "
           u"store"_s.arg(meanwhile.size());
}

// What was in use beside what was written, if anything; one line each.
QJsonArray othersJson(const WriteReport &report, const QString &done, QString &lines)
{
    QJsonArray others;
    for (const OtherValue &other : report.others) {
        QJsonObject object{{u"key"_s, other.spec->key},
                           {u"inUse"_s, valueJson(*other.spec, other.inUse)},
                           {u"stored"_s, valueJson(*other.spec, other.stored)},
                           {u"setBy"_s, other.setBy}};
        if (other.now) {
            object.insert(u"now"_s, valueJson(*other.spec, *other.now));
            const bool isLost = !sameValue(*other.now, other.inUse);
            lines += u"%1 %2 %3 in use before, %4 now\n"_s.arg(
                (isLost ? u"not kept"_s : u"kept"_s).leftJustified(12), other.spec->key.leftJustified(28),
                valueText(*other.spec, other.inUse), valueText(*other.spec, *other.now));
        }
        others.append(object);
        if (other.now)
            continue;
        lines += u"%1 %2 %3 in use, %4 stored%5\n"_s.arg(
            done.leftJustified(12), other.spec->key.leftJustified(28), valueText(*other.spec, other.inUse),
            valueText(*other.spec, other.stored),
            other.setBy.isEmpty() ? QString() : u" (%1 sets it)"_s.arg(other.setBy));
    }
    for (const QString &data : report.otherData) {
        others.append(QJsonObject{{u"data"_s, data}});
        lines += u"%1 %2 in use are not the stored ones\n"_s.arg(done.leftJustified(12), data);
    }
    return others;
}

QString othersNote(const WriteReport &report, const QString &count)
{
    if (report.areOthersUnknown)
        return u"%1 in use before without being stored: whether they still are could not be read"_s.arg(
            count);
    switch (report.othersWere) {
    case OtherValues::Keep:
        return u"%1 in use before without being stored: left so; --others store stores them too, "
               u"--others restore puts the stored ones into use"_s.arg(count);
    case OtherValues::Store: return u"%1 in use before without being stored: stored too"_s.arg(count);
    case OtherValues::PutBack:
        return u"%1 in use before without being stored: the stored values are in use again"_s.arg(count);
    }
    return {};
}

// What the board does not use any more since its link broke.
QString tellLost(const WriteReport &report, QJsonObject &json)
{
    if (report.othersLost.isEmpty())
        return {};
    json.insert(u"othersLost"_s, QJsonArray::fromStringList(report.othersLost));
    return u"in use before without being stored, and not any more: %1"_s.arg(report.othersLost.join(u", "_s));
}

// What is in use otherwise than before, beside the others that were not kept.
void tellUse(const WriteReport &report, QString &text, QJsonObject &json)
{
    if (!report.use)
        return;
    QJsonArray values;
    for (const ParameterChange &change : report.use->changes()) {
        values.append(QJsonObject{{u"key"_s, change.spec->key},
                                  {u"before"_s, valueJson(*change.spec, change.from)},
                                  {u"inUse"_s, valueJson(*change.spec, change.to)}});
        const bool isTold
            = std::any_of(report.others.begin(), report.others.end(), [&change](const OtherValue &other) {
                  return other.now && other.spec->key == change.spec->key;
              });
        if (!isTold)
            text += u"%1 %2 %3 in use before, %4 now\n"_s.arg(
                u"in use"_s.leftJustified(12), change.spec->key.leftJustified(28),
                valueText(*change.spec, change.from), valueText(*change.spec, change.to));
    }
    for (const DataChange &change : report.use->dataChanges())
        values.append(QJsonObject{{u"data"_s, QLatin1String(change.spec->data)}});
    json.insert(u"inUseNow"_s, report.use->now ? QJsonValue(values) : QJsonValue());
}

// The gimbal runs on another profile's values than before.
void tellProfile(const WriteReport &report, QString &text, QJsonObject &json)
{
    if (!report.strayProfile)
        return;
    const bool isRead = *report.strayProfile != WriteReport::kUnread;
    json.insert(u"activeProfile"_s, isRead ? QJsonValue(*report.strayProfile + 1) : QJsonValue());
    json.insert(u"activeProfileBefore"_s, report.before.activeProfile() + 1);
    text += u"%1 active profile, before the write it was %2\n"_s.arg(
        (isRead ? u"now %1"_s.arg(*report.strayProfile + 1) : u"unknown"_s).leftJustified(12),
        report.before.profileName(report.before.activeProfile()));
}

// Everything in use was to be stored, without anybody knowing what was stored before.
QString tellUnknown(const WriteReport &report)
{
    const QString before
        = u"the snapshot holds what was in use before; nobody can tell what was stored: %1"_s.arg(
            report.othersUnknown->detail);
    if (!report.error)
        return u"whatever else was in use is stored now; "_s + before;
    return report.storedUntold ? u"whether anything is stored could not be read; "_s + before : before;
}

}  // namespace

QString profileOf(const WriteReport &report, const WriteLine &line)
{
    const bool isOneOfMany
        = std::any_of(report.lines.begin(), report.lines.end(),
                      [&](const WriteLine &other) { return other.profile != report.before.activeProfile(); });
    return isOneOfMany && line.spec->row->scope == Scope::Profile
        ? report.before.profileName(line.profile) + u": "_s
        : QString();
}

QString tellOthers(const WriteReport &report, QString &text, QJsonObject &json)
{
    tellProfile(report, text, json);
    tellUse(report, text, json);
    QStringList notes{tellMeanwhile(report, text, json), tellLost(report, json)};
    notes.removeAll(QString());
    const QString meanwhile = notes.join(u'\n');
    if (report.othersUnknown) {
        json.insert(u"othersUnknown"_s, report.othersUnknown->detail);
        return tellUnknown(report);
    }
    if (!report.otherParameters)
        return meanwhile;
    const auto way = std::find_if(kWays.begin(), kWays.end(),
                                  [&report](const Way &each) { return each.others == report.othersWere; });
    QString lines;
    const QString done = report.areOthersUnknown ? u"unknown"_s : QLatin1String(way->done);
    const QJsonArray others = othersJson(report, done, lines);
    json.insert(u"others"_s, others);
    if (others.isEmpty())
        return meanwhile;
    // Only where it is so: a refusal is told value by value.
    const bool isRefused = std::any_of(report.others.begin(), report.others.end(),
                                       [](const OtherValue &other) { return other.now.has_value(); });
    const bool isTold = !report.error || report.areOthersUnknown;
    if (isTold)
        json.insert(u"othersWere"_s, done);
    if (isTold || isRefused)
        text += lines;
    if (!isTold)
        return meanwhile;
    // A plain store writes nothing beside them.
    const QString count
        = (report.lines.empty() && report.data.empty() ? u"%1"_s : u"%1 other"_s).arg(others.size());
    const QString told = othersNote(report, count);
    return meanwhile.isEmpty() ? told : told + u'\n' + meanwhile;
}

CommandOption leapOption(bool &on)
{
    return switchOption(u"confirmed"_s, u"values of the risk class may become many times what they are"_s,
                        on);
}

Result<void> checkLeaps(const Configuration &base, const Configuration &edited, bool areConfirmed)
{
    QStringList told;
    for (const ParameterChange &change : leapsAmong(base.changesTo(edited)))
        told.append(u"%1 from %2 to %3"_s.arg(change.spec->key, valueText(*change.spec, change.from),
                                              valueText(*change.spec, change.to)));
    if (areConfirmed || told.isEmpty())
        return {};
    return failure(ErrorCode::InvalidArgument,
                   u"more than %1 times what the board has: %2; confirm it with --confirmed"_s.arg(kLeap).arg(
                       told.join(u", "_s)));
}

QString othersText(Device &device, const WriteOptions &options, const QSet<QString> &wanted)
{
    WholeMemory *memory = device.wholeMemory();
    if (!memory || !options.contents)
        return {};
    WriteReport report;
    listOthers(*options.contents, memory->movedBy(options.contents->inUse), report);
    QStringList others;
    QStringList back;
    for (const OtherValue &other : report.others) {
        const QString text = u"%1 (%2 in use, %3 stored)"_s.arg(
            other.spec->key, other.spec->format(other.inUse), other.spec->format(other.stored));
        (wanted.contains(other.spec->key) ? back : others).append(text);
    }
    for (const QString &data : report.otherData)
        (wanted.contains(data) ? back : others).append(data);
    QStringList told;
    if (!back.isEmpty())
        told.append(u"in use otherwise, so the file's would be put into use: "_s + back.join(u", "_s));
    if (!others.isEmpty())
        told.append(u"in use without being stored, beside the file: "_s + others.join(u", "_s));
    return told.join(u'\n');
}

QString replacedText(Channel &channel, Device &device, const Configuration &base, const QSet<QString> &wanted)
{
    QStringList values;
    for (const OtherValue &value : readReplaceable(channel, device, base)) {
        if (!wanted.contains(value.spec->key))
            values.append(u"%1 (%2 in use, %3 stored)"_s.arg(value.spec->key, value.spec->format(value.inUse),
                                                             value.spec->format(value.stored)));
    }
    return values.isEmpty()
        ? QString()
        : u"in use without being stored, and replaced by the stored values with this write: "_s
            + values.join(u", "_s);
}

void reportRounded(CommandOutcome &outcome, const QStringList &rounded)
{
    if (rounded.isEmpty())
        return;
    outcome.note += (outcome.note.isEmpty() ? QString() : u"\n"_s) + rounded.join(u'\n');
    if (outcome.json.isArray()) {
        QJsonArray array = outcome.json.toArray();
        for (const QString &line : rounded)
            array.append(QJsonObject{{u"rounded"_s, line}});
        outcome.json = array;
        return;
    }
    QJsonObject object = outcome.json.toObject();
    object.insert(u"rounded"_s, QJsonArray::fromStringList(rounded));
    outcome.json = object;
}

void addMissing(CommandOutcome &outcome, const QStringList &names, const QString &where)
{
    const bool isList = outcome.json.isArray();
    QJsonObject object = outcome.json.toObject();
    QJsonArray parts = isList ? outcome.json.toArray() : object.value(u"missing"_s).toArray();
    for (const QString &name : names)
        parts.append(QJsonObject{{u"missing"_s, name}, {u"where"_s, where}});
    object.insert(u"missing"_s, parts);
    outcome.json = isList ? QJsonValue(parts) : QJsonValue(object);
}
