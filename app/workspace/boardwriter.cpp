// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/boardwriter.h"

#include "protocol/procedure/writeconfiguration.h"

using namespace Qt::StringLiterals;

BoardWriter::BoardWriter(DeviceClient &client, ConfigurationModel &configuration, LiveModel &live,
                         EditStack &edits, const BoardHistory &history, Notifications &notifications)
    : m_client(client)
    , m_configuration(configuration)
    , m_live(live)
    , m_edits(edits)
    , m_history(history)
    , m_notifications(notifications)
{
}

void BoardWriter::write(const Configuration &wanted, OtherValues others)
{
    if (m_writing) {
        m_notifications.report({ErrorCode::Busy, {}, 0});
        return;
    }
    m_writing = true;
    m_client
        .submit<WriteReport>([base = m_configuration.board(), wanted, history = m_history,
                              backupDone = m_backupDone, others,
                              live = m_live.unsaved()](Channel &channel, Device &device) {
            WriteOptions options;
            options.history = &history;
            options.backupDone = backupDone;
            options.live = live;
            options.others = others;
            return writeConfiguration(channel, device, base, wanted, options);
        })
        .then(this, [this, live = m_live.unsaved()](const Result<WriteReport> &result) {
            m_writing = false;
            onReport(result);
            restoreLive(live);
            // The wanted values are not lost: they become unsaved edits again.
            if (const auto again = std::exchange(m_wantedAgain, std::nullopt);
                again && result && result->isComplete())
                m_edits.apply(*again, tr("Changes of the interrupted write"));
            emit finished();
        });
}

void BoardWriter::onReport(const Result<WriteReport> &result)
{
    if (!result) {
        m_notifications.report(result.error());
        if (result.error().code == ErrorCode::Conflict)
            emit conflicted();
        return;
    }
    m_lastReport = *result;
    if (result->isSnapshotComplete)
        m_backupDone = true;
    m_configuration.setBoard(result->onBoard);
    if (!result->snapshotPath.isEmpty())
        emit snapshotTaken();
    const int verified = result->count(WriteState::Verified);
    if (result->isComplete()) {
        emit completed();
        QString text = result->lines.empty() && result->data.empty()
            ? tr("Profile names written and read back.")
            : tr("%n value(s) written and read back.", nullptr, verified);
        if (!result->snapshotPath.isEmpty())
            text += u' '
                + (result->isSnapshotComplete ? tr("The board as it was is kept in %1")
                                              : tr("What could be read of the board as it was is kept in %1"))
                      .arg(result->snapshotPath);
        m_notifications.notify(text);
        tellOthers(*result);
        return;
    }
    ErrorText text = describe(*result);
    m_interrupted = result->count(WriteState::Unknown) > 0;
    if (m_interrupted) {
        text.cure = tr("When the board is back it is read again; then the write can be finished or undone.");
    }
    QStringList names;
    for (const WriteLine &line : result->lines)
        names.append(line.spec->key);
    text.detail += u' ' + names.mid(0, 12).join(u", "_s);
    m_notifications.report(text);
}

// What else was in use without being stored, on a board that stores everything at once.
void BoardWriter::tellOthers(const WriteReport &report)
{
    if (report.othersUnknown) {
        m_notifications.notify(
            tr("Everything else that was in use on the board is stored now as well; what it "
               "was could not be told: %1")
                .arg(report.othersUnknown->detail),
            Notice::Attention);
        return;
    }
    QStringList names = report.otherData;
    for (const OtherValue &other : report.others)
        names.append(other.setBy.isEmpty() ? other.spec->key
                                           : tr("%1 (%2 sets it)").arg(other.spec->key, other.setBy));
    if (names.isEmpty())
        return;
    const auto count = int(names.size());
    const QString list = names.mid(0, 8).join(u", "_s);
    switch (report.othersWere) {
    case OtherValues::Keep:
        m_notifications.notify(
            tr("%n other value(s) stay in use without being stored: %1", nullptr, count).arg(list),
            Notice::Hint);
        return;
    case OtherValues::Store:
        m_notifications.notify(tr("%n other value(s) in use are stored too: %1", nullptr, count).arg(list),
                               Notice::Hint);
        return;
    case OtherValues::PutBack:
        m_notifications.notify(
            tr("%n other value(s) are in use as they are stored again: %1", nullptr, count).arg(list),
            Notice::Hint);
        return;
    }
}

// The board has been read again after reconnecting, so the state left by the interrupted write is known: the
// rest can be written, or what was written can be undone. Either is an ordinary verified write.
void BoardWriter::offerRepair()
{
    if (!std::exchange(m_interrupted, false))
        return;
    const Configuration &board = std::as_const(m_configuration).board();
    Configuration finished = board;
    Configuration undone = board;
    int missing = 0;
    int landed = 0;
    for (const WriteLine &line : m_lastReport->lines) {
        const ParameterSpec *spec = board.parameters().find(line.spec->key);
        if (!spec)
            continue;
        if (sameValue(board.raw(*spec, line.profile), line.to)) {
            ++landed;
            std::ignore = undone.copyRaw(*spec, line.profile, m_lastReport->before);
        } else {
            ++missing;
            std::ignore = finished.copyRaw(*spec, line.profile, m_lastReport->wanted);
        }
    }
    for (const WriteData &data : m_lastReport->data) {
        if (board.block(data.key) == m_lastReport->wanted.block(data.key)) {
            ++landed;
            undone.setBlock(data.key, m_lastReport->before.block(data.key));
        } else {
            ++missing;
            finished.setBlock(data.key, m_lastReport->wanted.block(data.key));
        }
    }
    if (missing == 0) {
        m_notifications.notify(tr("The interrupted write was complete: every value is on the board."));
        return;
    }
    Offer question;
    question.text = tr("The last write was interrupted: %1 of %2 values are not on the board.")
                        .arg(missing)
                        .arg(missing + landed);
    if (landed == 0)
        question.text += u' ' + tr("The board holds the old values.");
    question.choices.append(
        {tr("Finish: write %n value(s)", nullptr, missing), [this, finished] { write(finished); }});
    if (landed > 0)
        question.choices.append({tr("Revert %n value(s)", nullptr, landed), [this, undone, finished] {
                                     m_wantedAgain = finished;
                                     write(undone);
                                 }});
    question.choices.append({tr("Leave it as it is"), [] {}});
    m_notifications.ask(question);
}

// The board loads a written block at once, including its stored values: live values that it replaced are put
// into use again.
void BoardWriter::restoreLive(const LiveValues &before)
{
    if (!m_client.isConnected())
        return;
    if (m_client.device()->wholeMemory()) {  // the write has kept them apart
        m_live.forget();
        m_live.read();
        return;
    }
    QHash<int, double> values;
    for (const LiveValue &value : before) {
        const ParameterSpec *spec = std::as_const(m_configuration).board().parameters().find(value.key);
        if (spec && sameValue(m_live.stored(spec->id), value.stored))
            values.insert(spec->id, value.inUse);
    }
    m_live.forget();
    m_live.read();
    m_live.setValues(values);
}
