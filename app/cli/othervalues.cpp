// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What else was in use without being stored, on boards that store everything at once.
#include "app/cli/command.h"

#include <QJsonArray>

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

CommandOption othersOption(OtherValues &others)
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

Result<Configuration> readBase(Channel &channel, Device &device, OtherValues others, WriteOptions &options)
{
    options.others = others;
    if (WholeMemory *memory = device.wholeMemory(); memory && device.identity().writable) {
        auto both = memory->readBoth(channel);
        if (both) {
            options.contents = *both;
            return both->stored;
        }
        // The write says so, or refuses, by itself.
        const ErrorCode code = both.error().code;
        if (code != ErrorCode::Unsupported && code != ErrorCode::Unready && code != ErrorCode::ConditionUnmet)
            return tl::unexpected(both.error());
    }
    return device.readConfiguration(channel);
}

QString tellOthers(const WriteReport &report, QString &text, QJsonObject &json)
{
    const bool isTold = report.otherParameters || report.othersUnknown;
    if (!isTold)
        return {};
    if (report.othersUnknown) {
        json.insert(u"othersUnknown"_s, report.othersUnknown->detail);
        return u"whatever else was in use is stored now; nobody can tell what it is: %1"_s.arg(
            report.othersUnknown->detail);
    }
    const auto way = std::find_if(kWays.begin(), kWays.end(),
                                  [&report](const Way &each) { return each.others == report.othersWere; });
    QJsonArray others;
    QString lines;
    for (const OtherValue &other : report.others) {
        others.append(QJsonObject{{u"key"_s, other.spec->key},
                                  {u"inUse"_s, valueJson(*other.spec, other.inUse)},
                                  {u"stored"_s, valueJson(*other.spec, other.stored)},
                                  {u"setBy"_s, other.setBy}});
        lines += u"%1 %2 %3 in use, %4 stored%5\n"_s.arg(
            QString::fromLatin1(way->done).leftJustified(12), other.spec->key.leftJustified(28),
            valueText(*other.spec, other.inUse), valueText(*other.spec, other.stored),
            other.setBy.isEmpty() ? QString() : u" (%1 sets it)"_s.arg(other.setBy));
    }
    for (const QString &data : report.otherData) {
        others.append(QJsonObject{{u"data"_s, data}});
        lines += u"%1 %2 in use are not the stored ones\n"_s.arg(
            QString::fromLatin1(way->done).leftJustified(12), data);
    }
    json.insert(u"others"_s, others);
    if (others.isEmpty())
        return {};
    json.insert(u"othersWere"_s, QLatin1String(way->done));
    if (report.error)
        return {};
    text += lines;
    switch (report.othersWere) {
    case OtherValues::Keep:
        return u"%1 other in use before without being stored: left so; --others store stores them too, "
               u"--others restore puts the stored ones into use"_s.arg(others.size());
    case OtherValues::Store:
        return u"%1 other in use before without being stored: stored too"_s.arg(others.size());
    case OtherValues::PutBack:
        return u"%1 other in use before without being stored: the stored values are in use again"_s.arg(
            others.size());
    }
    return {};
}
