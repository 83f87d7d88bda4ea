// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Reading the board, and what becomes of edits when it is another one or holds other values than before.
#include "app/workspace/workspace.h"
#include "protocol/configuration/aftermath.h"
#include "protocol/session/linkstatistics.h"
#include "widgets/models/boardtext.h"
#include "widgets/models/missingtext.h"
#include "widgets/models/parametermodel.h"

#include <algorithm>
#include <iterator>
#include <utility>

using namespace Qt::StringLiterals;

namespace {

constexpr int kMostRereads = 5;

}  // namespace

// What a search has put into use could not be told from what is stored before it has ended.
void Workspace::readBoard()
{
    m_readLater = m_live.isHeld();
    if (!m_readLater)
        readKnowing(std::nullopt);
}

void Workspace::readWhenFree()
{
    if (!m_live.isHeld() && m_client.isConnected() && std::exchange(m_readLater, false))
        readBoard();
}

bool Workspace::isUnknown() const
{
    return m_writer.isUnknown()
        || (m_unsettled && m_unsettled->after->before.identity().serial == m_client.identity().serial);
}

// What a write, an action or a live value has left unknown on a link that did not end is read as soon as the
// board answers again.
void Workspace::readUnknown()
{
    const quint64 frames = m_client.statistics().framing.frames;
    if (!m_client.isConnected() || (!isUnknown() && !m_live.isDoubted())) {
        m_framesHeard.reset();
        m_rereads = 0;
        return;
    }
    if (m_reading || m_client.isBusy() || m_live.isHeld() || !m_framesHeard) {
        m_framesHeard = frames;
        return;
    }
    if (frames == *m_framesHeard || m_rereads == kMostRereads)
        return;
    m_framesHeard = frames;
    ++m_rereads;
    if (isUnknown())
        readKnowing(std::nullopt, true);
    else
        m_live.read();
}

// Values that are in use without being stored: those given, or those known when the answer comes.
// @param quiet why it is read has been told already
void Workspace::readKnowing(const std::optional<LiveValues> &live, bool quiet)
{
    if (m_reading)
        return;
    m_reading = true;
    m_client.submit<Configuration>(m_writer.reader())
        .then(this, [this, live, quiet](const Result<Configuration> &answer) {
            m_reading = false;
            if (!answer) {
                if (!isEndOfLink(answer.error()) && (!quiet || answer.error().code != ErrorCode::Timeout))
                    m_notifications.report(answer.error(), Concern::Reading);
                return;
            }
            m_notifications.settle(Concern::Reading);
            const bool isFirst = std::exchange(m_unread, false);
            const bool sameBoard = !m_configuration.isEmpty()
                && answer->identity().serial == std::as_const(m_configuration).board().identity().serial;
            LiveValues known = live.value_or(m_live.unsaved());
            if (m_unsettled)
                std::ranges::copy(changedInUse(*m_unsettled->after, *answer), std::back_inserter(known));
            Configuration read = sameBoard ? withoutLive(*answer, known) : *answer;
            if (sameBoard)
                keepMissing(read);
            // A recording says nothing of what the board holds since.
            const bool isRecording = m_client.address().isReplay();
            const bool wasRecording = std::exchange(m_isRecording, isRecording);
            const bool isBoards = m_offlineFile.isEmpty() && !wasRecording && !isRecording;
            m_offlineFile.clear();
            const QStringList others
                = isFirst && sameBoard && isBoards ? changedMeanwhile(read) : QStringList();
            const LiveValues lost = isFirst && sameBoard ? lostSince(*answer) : LiveValues();
            m_usedBefore.clear();
            if (!m_configuration.rebase(read)) {
                leaveEdits();
                m_configuration.reset(read);
            }
            if (isFirst)
                m_journal.remind();
            tellLost(lost);
            if (!isRecording) {
                judge(int(others.size()), others);
                settle(*answer);
            }
            tellMissing(read);
            emit boardRead();
        });
}

// Edits are kept in the parts that did not come this time: these stay as they were read before, but count as
// missing. What cannot be read over this link is told by its page.
void Workspace::keepMissing(Configuration &read) const
{
    const Configuration &before = std::as_const(m_configuration).board();
    if (before.identity().firmwareNumber != read.identity().firmwareNumber)
        return;
    const std::vector<MissingPart> missing = read.missing();
    for (const MissingPart &part : missing) {
        if (part.why.code == ErrorCode::Unsupported)
            continue;
        if (part.key.block == MissingPart::kProfileNames)
            read.setProfileNames(before.profileNames());
        else if (before.blocks().contains(part.key))
            read.setBlock(part.key, before.block(part.key));
        read.addMissing(part.key, part.why);
    }
}

void Workspace::tellMissing(const Configuration &configuration)
{
    std::vector<MissingPart> unknown;
    std::vector<MissingPart> kept;
    for (const MissingPart &part : configuration.missing()) {
        if (part.why.code == ErrorCode::Unsupported)
            continue;
        const bool isKept = part.key.block == MissingPart::kProfileNames
            ? !configuration.profileNames().isEmpty()
            : configuration.blocks().contains(part.key);
        (isKept ? kept : unknown).push_back(part);
    }
    if (!unknown.empty())
        m_notifications.report({ErrorCode::Incomplete, missingText(configuration, unknown), 0},
                               Concern::Reading);
    if (!kept.empty())
        m_notifications.report(
            ErrorText{
                tr("Parts of the board could not be read again."), tr("What is shown there was read before."),
                tr("Read the board again; if parts keep missing, check its cable or network, and its power."),
                missingText(configuration, kept)},
            Concern::Reading);
}

// What values set live before the link was lost have become the stored ones: the board has restarted.
LiveValues Workspace::lostSince(const Configuration &read) const
{
    LiveValues lost;
    std::ranges::copy_if(m_usedBefore, std::back_inserter(lost), [&read](const LiveValue &value) {
        const ParameterSpec *spec = read.parameters().find(value.key);
        return spec && sameValue(read.raw(*spec, read.activeProfile()), value.stored);
    });
    return lost;
}

// What a board holds otherwise than when it was read last, beside what an interrupted write waits for.
QStringList Workspace::changedMeanwhile(const Configuration &read) const
{
    const Configuration &before = std::as_const(m_configuration).board();
    QStringList others;
    if (before.identity().firmwareNumber != read.identity().firmwareNumber)
        return others;
    for (const ParameterChange &change : before.changesTo(read)) {
        if (!m_writer.awaits(change))
            others.append(changePlace(read, change)
                          + u"%1 %2 → %3"_s.arg(parameterLabel(*change.spec),
                                                parameterValueText(*change.spec, change.from),
                                                parameterQuantityText(*change.spec, change.to)));
    }
    for (const DataChange &change : before.dataChangesTo(read)) {
        if (!m_writer.awaits(change.key))
            others.append(tableText(change.spec->data));
    }
    return others;
}

// Edits of another board stay in its journal, and are offered when it is back.
void Workspace::leaveEdits()
{
    const int left = m_offlineFile.isEmpty() && m_client.isConnected() ? unsavedCount() : 0;
    m_journal.flush();
    m_edits.undoStack().clear();
    if (left > 0)
        m_notifications.notify(
            tr("%n unwritten change(s) belong to the board before (%1) and are kept for it; they are offered "
               "when it is connected again.",
               nullptr, left)
                .arg(boardText(std::as_const(m_configuration).board().identity())),
            Notice::Attention);
}

// A board without a serial number that holds other values may be another one: nothing that was begun on the
// one before goes on without an answer.
void Workspace::judge(int others, QStringList names)
{
    constexpr int kNamed = 6;
    if (others > 0 && !m_client.identity().isNumbered()
        && (m_writer.isInterrupted() || m_configuration.changeCount() > 0)) {
        m_isDoubted = true;
        Offer question;
        question.topic = Topic::Board;
        question.text
            = tr("The board that answers looks like the one before, but %n of its values differ from "
                 "what was read then. Is it the same one?",
                 nullptr, others);
        question.choices.append({tr("It is the same one"), [this] {
                                     m_isDoubted = false;
                                     m_writer.offerRepair();
                                 }});
        question.choices.append({tr("It is another one"), [this] { setEditsAside(); }});
        m_notifications.ask(question);
        return;
    }
    if (names.size() > kNamed)
        names = names.mid(0, kNamed) + QStringList{u"…"_s};
    if (others > 0)
        m_notifications.notify(
            tr("%n value(s) on the board differ from what was read before the link ended.", nullptr, others)
                + (names.isEmpty() ? QString() : u' ' + names.join(u", "_s)),
            Notice::Attention);
    if (!m_isDoubted)
        m_writer.offerRepair();
}

void Workspace::setEditsAside()
{
    const Configuration board = std::as_const(m_configuration).board();
    const Configuration edited = std::as_const(m_configuration).edited();
    if (m_configuration.changeCount() > 0) {
        const auto saved = m_history.save(edited, u"unwritten edits of an earlier run"_s);
        if (!saved) {
            m_notifications.report(saved.error(), Concern::Saving);
            judge(1);
            return;
        }
        m_notifications.notify(tr("The unwritten changes of the board before are kept in %1. Say under "
                                  "Backups which board this is.")
                                   .arg(*saved),
                               Notice::Attention);
        emit snapshotTaken();
    }
    m_isDoubted = false;
    m_writer.forgetInterrupted();
    m_edits.undoStack().clear();
    m_configuration.reset(board);
}

void Workspace::offerLeftover(int steps, int texts)
{
    if (m_client.isConnected() && !m_client.identity().writable)
        return;  // they are kept until the board itself is connected
    Offer question;
    if (steps > 0)
        question.text = tr("%n unwritten step(s) of an earlier run belong to this board.", nullptr, steps);
    if (texts > 0)
        question.text += (steps > 0 ? u" "_s : QString())
            + tr("%n unfinished text(s) of an earlier run belong to this board.", nullptr, texts);
    question.choices.append({tr("Restore them"), [this] { restoreLeftover(); }});
    question.choices.append({tr("Throw them away"), [this] { m_journal.dropLeftover(); }});
    question.topic = Topic::Leftover;
    m_notifications.ask(question);
}

void Workspace::restoreLeftover()
{
    const EditStack::Restored restored = m_journal.restoreLeftover();
    if (m_journal.leftoverWaits())
        m_notifications.notify(
            tr("They concern parts of the board that could not be read. They are kept, and "
               "offered again once a reading is complete (F5)."),
            Notice::Attention);
    else if (!restored.any)
        m_notifications.notify(tr("None of it fits this board any more."), Notice::Attention);
    else if (restored.leftOut > 0)
        m_notifications.notify(
            tr("%n edit(s) do not fit this board any more and were left out.", nullptr, restored.leftOut),
            Notice::Attention);
}
