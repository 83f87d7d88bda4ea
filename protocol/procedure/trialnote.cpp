// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/procedure/trialnote.h"

#include "protocol/base/filefault.h"
#include "protocol/procedure/writeconfiguration.h"
#include "protocol/record/boardhistory.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

using namespace Qt::StringLiterals;

namespace {

constexpr qint64 kLongestNote = 1 << 20;

}  // namespace

Configuration TrialNote::madeGood(const Configuration &board) const
{
    Configuration old = board;
    for (const Value &value : values) {
        const ParameterSpec *spec = board.parameters().find(value.key);
        if (spec && sameValue(board.raw(*spec, profile), value.tried))
            std::ignore = old.setRaw(*spec, profile, value.old);
    }
    return old;
}

Result<void> keepTrial(const BoardHistory &history, const Configuration &base, const Configuration &tried,
                       const Configuration *before)
{
    QJsonArray values;
    for (const Configuration *each : {&tried, before}) {
        if (!each)
            continue;
        for (const ParameterChange &change : base.changesTo(*each))
            values.append(
                QJsonObject{{u"key"_s, change.spec->key}, {u"old"_s, change.from}, {u"tried"_s, change.to}});
    }
    const QString path = history.trialFile(base.identity().serial);
    QDir().mkpath(QFileInfo(path).path());  // what fails, writing says
    const QJsonObject note{{u"profile"_s, base.activeProfile()}, {u"values"_s, values}};
    return writeWhole(path, QJsonDocument(note).toJson(), FileKind::Other);
}

void dropTrial(const BoardHistory &history, const BoardIdentity &identity)
{
    QFile::remove(history.trialFile(identity.serial));
}

std::optional<TrialNote> keptTrial(const BoardHistory &history, const BoardIdentity &identity)
{
    const auto bytes = readWhole(history.trialFile(identity.serial), FileKind::Other, kLongestNote);
    if (!bytes)
        return {};
    const QJsonObject json = QJsonDocument::fromJson(*bytes).object();
    TrialNote note;
    note.profile = json[u"profile"_s].toInt();
    for (const QJsonValue &each : json[u"values"_s].toArray())
        note.values.push_back(
            {each[u"key"_s].toString(), each[u"old"_s].toDouble(), each[u"tried"_s].toDouble()});
    return note;
}

Result<QStringList> makeTrialGood(Channel &channel, Device &device, const BoardHistory &history,
                                  const Configuration &board)
{
    const auto note = keptTrial(history, device.identity());
    if (!note)
        return QStringList();
    const Configuration old = note->madeGood(board);
    QStringList keys;
    for (const ParameterChange &change : board.changesTo(old))
        keys.append(change.spec->key);
    if (!keys.isEmpty()) {
        const auto report
            = writeConfiguration(channel, device, board, old, {.history = &history, .live = {}});
        if (!report)
            return tl::unexpected(report.error());
        if (report->error)
            return tl::unexpected(*report->error);
    }
    dropTrial(history, device.identity());
    return keys;
}
