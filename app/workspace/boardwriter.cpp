// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/boardwriter.h"

#include "protocol/procedure/wholewrite.h"
#include "protocol/procedure/writeconfiguration.h"
#include "widgets/models/errortext.h"
#include "widgets/models/parametermodel.h"

#include <algorithm>
#include <utility>

using namespace Qt::StringLiterals;

namespace {

std::vector<BlockKey> unknownParts(const WriteReport &report)
{
    std::vector<BlockKey> parts;
    for (const WriteLine &line : report.lines) {
        if (line.state == WriteState::Unknown)
            parts.push_back(
                {line.spec->row->scope == Scope::Board ? report.onBoard.activeProfile() : line.profile,
                 line.spec->row->block});
    }
    for (const WriteData &data : report.data) {
        if (data.state == WriteState::Unknown)
            parts.push_back(data.key);
    }
    if (report.areNamesUnknown())
        parts.push_back({0, MissingPart::kProfileNames});
    return parts;
}

// What is unknown counts as not read.
Configuration knownOf(const WriteReport &report)
{
    Configuration board = report.onBoard;
    for (const BlockKey part : unknownParts(report))
        board.addMissing(part, report.error.value_or(Error{ErrorCode::Incomplete, {}, 0}));
    return board;
}

}  // namespace

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
    m_notifications.settle(Concern::Writing);  // of the write before
    emit started();
    m_client
        .submit<WriteReport>([base = m_configuration.board(), wanted, history = m_history,
                              backupDone = m_backupDone, others,
                              live = m_live.unsaved()](Channel &channel, Device &device) {
            WriteOptions options;
            options.history = &history;
            options.backupDone = backupDone;
            options.live = live;
            options.others = others;
            if (device.identity().serial != base.identity().serial)  // it has not been read yet
                return Result<WriteReport>(failure(ErrorCode::Conflict, u"another board"_s));
            return writeConfiguration(channel, device, base, wanted, options);
        })
        .then(this, [this, live = m_live.ownUnsaved()](const Result<WriteReport> &result) {
            m_writing = false;
            onReport(result);
            // Never after a restart, which has ended what they were for.
            const bool isRestarted = result && result->restart.areAny();
            // Nobody knows what is in use while nobody knows what was written.
            const QSet<QString> kept
                = isUnknown() ? QSet<QString>() : restoreLive(isRestarted ? LiveValues() : live);
            if (result)
                tellReplaced(*result, kept);
            // The wanted values are not lost: they become unsaved edits again.
            if (const auto again = std::exchange(m_wantedAgain, std::nullopt);
                again && result && result->isComplete())
                m_edits.apply(*again, tr("Changes of the interrupted write"));
            emit finished();
        });
}

void BoardWriter::onReport(const Result<WriteReport> &result)
{
    m_notifications.settle(Concern::Writing);
    if (!result) {
        ErrorText text = describe(result.error());
        text.what = tr("Nothing was written.") + u' ' + text.what;
        m_notifications.report(text, Concern::Writing);
        if (result.error().code == ErrorCode::Conflict)
            emit conflicted();
        return;
    }
    m_lastReport = *result;
    if (result->isSnapshotComplete())
        m_backupDone = true;
    const bool isReadAgain = !result->isComplete() && !result->storedUntold && result->hasUnknown();
    m_configuration.setBoard(isReadAgain ? knownOf(*result) : result->onBoard);
    if (!result->snapshotPath.isEmpty())
        emit snapshotTaken();
    const int verified = result->count(WriteState::Verified);
    if (result->isComplete()) {
        forgetInterrupted();  // what is left of it are edits
        emit completed();
        QString text = result->lines.empty() && result->data.empty()
            ? tr("Profile names written and read back.")
            : tr("%n value(s) written and read back.", nullptr, verified);
        if (const int untold = result->countStoreUntold())
            text += u' '
                + tr("%n of them the board had used already: its next start shows whether they are stored.",
                     nullptr, untold);
        if (!result->snapshotPath.isEmpty())
            text += u' '
                + (result->snapshotLacks.isEmpty()
                       ? tr("The settings as they were are kept in %1")
                       : tr("What could be read of the settings as they were is kept in %1"))
                      .arg(result->snapshotPath);
        m_notifications.notify(text);
        if (!result->snapshotLacks.isEmpty())
            m_notifications.notify(
                tr("That backup lacks what could not be read: %1.").arg(result->snapshotLacks.join(u", "_s)),
                Notice::Attention);
        if (const QString restart = restartText(*result); !restart.isEmpty())
            m_notifications.notify(restart, Notice::Attention);
        tellOthers(*result);
        return;
    }
    ErrorText text = describe(*result);
    if (result->storedUntold) {
        text.cure = tr("Once the board has started, compare what is in use with what is stored.");
    } else if (isReadAgain) {
        m_pending = *result;
        text.cure = tr("When the board is back it is read again; then the write can be finished or undone.");
    }
    QStringList names;
    for (const WriteLine &line : result->lines)
        names.append(changePlace(result->onBoard, {line.spec, line.profile, line.from, line.to})
                     + line.spec->key);
    text.detail += u' ' + names.mid(0, 12).join(u", "_s);
    m_notifications.report(text, Concern::Writing);
}

// What the write has replaced by what is stored, beside what is put into use again.
void BoardWriter::tellReplaced(const WriteReport &report, const QSet<QString> &restored)
{
    QStringList lost;
    for (const QString &value : report.othersLost) {
        if (!restored.contains(value.section(u'=', 0, 0)))
            lost.append(value);
    }
    if (!lost.isEmpty())
        m_notifications.notify(
            tr("Not in use any more, because it was not stored: %1").arg(lost.join(u", "_s)),
            Notice::Attention);
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

// A board that stores everything in use at once answers with what is in use, which says nothing about what an
// interrupted write has stored: then it is asked for both.
std::function<Result<Configuration>(Channel &, Device &)> BoardWriter::reader()
{
    m_untold->reset();
    return [untold = m_untold, isOpen = m_pending.has_value()](Channel &channel,
                                                               Device &device) -> Result<Configuration> {
        WholeMemory *memory = isOpen ? device.wholeMemory() : nullptr;
        if (!memory)
            return device.readConfiguration(channel);
        auto both = memory->readBoth(channel);
        if (both)
            return std::move(both->stored);
        if (!isUntold(both.error()))
            return tl::unexpected(both.error());
        *untold = both.error();
        return device.readConfiguration(channel);
    };
}

bool BoardWriter::isUnknown() const
{
    if (!m_pending)
        return false;
    const Configuration &board = std::as_const(m_configuration).board();
    const std::vector<BlockKey> parts = unknownParts(*m_pending);
    return m_pending->before.identity().serial == board.identity().serial
        && std::any_of(parts.begin(), parts.end(),
                       [&board](BlockKey part) { return board.findMissing(part) != nullptr; });
}

// The board has been read again since, so the state left by the interrupted write is known: the rest can be
// written, or what was written can be undone. Either is an ordinary verified write.
void BoardWriter::offerRepair()
{
    if (!m_pending)
        return;
    if (m_pending->before.identity().serial != std::as_const(m_configuration).board().identity().serial) {
        forgetInterrupted();
        m_notifications.settle(Concern::Writing);
        m_notifications.notify(tr("The interrupted write belongs to the board before: it is neither finished "
                                  "nor undone on this one."),
                               Notice::Attention);
        return;
    }
    if (*m_untold) {
        ErrorText text = describe(**m_untold);
        text.what = tr("Whether the interrupted write is stored could not be read.") + u' ' + text.what;
        m_notifications.settle(Concern::Writing);
        m_notifications.report(text, Concern::Writing);
        return;  // until it can be
    }
    if (isUnknown())
        return;
    m_notifications.settle(Concern::Writing);  // what was not known then is known now
    if (m_client.isConnected() && m_client.device()->wholeMemory()) {
        m_live.forget();
        m_live.read();
    }
    const Configuration &board = std::as_const(m_configuration).board();
    if (m_lastReport->strayProfile && board.activeProfile() != m_lastReport->before.activeProfile()) {
        m_notifications.notify(
            tr("The interrupted write has left “%1” as the active profile; before it was “%2”.")
                .arg(profileLabel(board, board.activeProfile()),
                     profileLabel(board, m_lastReport->before.activeProfile())),
            Notice::Attention);
    }
    Configuration finished = board;
    Configuration undone = board;
    int missing = 0;
    int landed = 0;
    for (const WriteLine &line : m_pending->lines) {
        const ParameterSpec *spec = board.parameters().find(line.spec->key);
        if (!spec)
            continue;
        if (sameValue(board.raw(*spec, line.profile), line.to)) {
            ++landed;
            std::ignore = undone.copyRaw(*spec, line.profile, m_pending->before);
        } else {
            ++missing;
            std::ignore = finished.copyRaw(*spec, line.profile, m_pending->wanted);
        }
    }
    for (const WriteData &data : m_pending->data) {
        if (board.block(data.key) == m_pending->wanted.block(data.key)) {
            ++landed;
            undone.setBlock(data.key, m_pending->before.block(data.key));
        } else {
            ++missing;
            finished.setBlock(data.key, m_pending->wanted.block(data.key));
        }
    }
    if (missing == 0) {
        forgetInterrupted();
        m_notifications.notify(tr("The interrupted write was complete: every value is on the board."));
        return;
    }
    Offer question;
    question.text = tr("The last write was interrupted: %1 of %2 values are not on the board.")
                        .arg(missing)
                        .arg(missing + landed);
    if (landed == 0)
        question.text += u' ' + tr("The board holds the old values.");
    question.choices.append({tr("Finish: write %n value(s)", nullptr, missing),
                             [this, finished] { answer(finished, std::nullopt); }});
    if (landed > 0)
        question.choices.append({tr("Revert %n value(s)", nullptr, landed),
                                 [this, undone, finished] { answer(undone, finished); }});
    question.choices.append({tr("Leave it as it is"), [this] { forgetInterrupted(); }});
    question.topic = Topic::Write;
    question.isUrgent = true;
    m_notifications.ask(question);
}

// Without a link, or on another board, nothing is written: it is asked again when the board is back.
void BoardWriter::answer(const Configuration &wanted, const std::optional<Configuration> &again)
{
    if (!m_pending)
        return;
    if (!m_client.isConnected() || m_client.identity().serial != m_pending->before.identity().serial) {
        m_notifications.report({ErrorCode::NotConnected, {}, 0});
        return;
    }
    m_pending.reset();
    m_wantedAgain = again;
    write(wanted);
}

bool BoardWriter::awaits(const ParameterChange &change) const
{
    return m_pending
        && std::any_of(m_pending->lines.begin(), m_pending->lines.end(), [&change](const WriteLine &line) {
               return change.spec->key == line.spec->key
                   && (change.spec->row->scope == Scope::Board || change.profile == line.profile);
           });
}

bool BoardWriter::awaits(BlockKey data) const
{
    return m_pending
        && std::any_of(m_pending->data.begin(), m_pending->data.end(),
                       [data](const WriteData &line) { return line.key == data; });
}

void BoardWriter::forgetInterrupted()
{
    if (std::exchange(m_pending, std::nullopt))
        m_notifications.withdrawOffer(Topic::Write);
}

// The board loads a written block at once, including its stored values: live values that it replaced, and
// that were set here, are put into use again. Returns their keys.
QSet<QString> BoardWriter::restoreLive(const LiveValues &before)
{
    if (!m_client.isConnected())
        return {};
    if (m_client.device()->wholeMemory()) {  // the write has kept them apart
        m_live.forget();
        m_live.read();
        return {};
    }
    QHash<int, double> values;
    QSet<QString> keys;
    for (const LiveValue &value : before) {
        const ParameterSpec *spec = std::as_const(m_configuration).board().parameters().find(value.key);
        if (!spec || !sameValue(m_live.stored(spec->id), value.stored))
            continue;
        values.insert(spec->id, value.inUse);
        keys.insert(value.key);
    }
    m_live.forget();
    m_live.read();
    m_live.putBack(values);
    return keys;
}
