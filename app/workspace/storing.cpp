// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What is in use goes to what is stored, and how the two are told apart.
#include "app/workspace/question.h"
#include "app/workspace/workspace.h"
#include "protocol/configuration/leap.h"
#include "protocol/procedure/wholewrite.h"
#include "widgets/forms/panel.h"
#include "widgets/forms/reviewdialog.h"
#include "widgets/models/detailtext.h"
#include "widgets/models/parametermodel.h"

#include <QPointer>
#include <QPromise>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

using Stored = std::shared_ptr<QPromise<bool>>;

Stored makeStored()
{
    auto stored = std::make_shared<QPromise<bool>>();
    stored->start();
    return stored;
}

// Ends once: what is decided later does not count.
void end(const Stored &stored, bool done)
{
    if (stored->future().isFinished())
        return;
    stored->addResult(done);
    stored->finish();
}

// Whatever is in use without being stored, and was not listed.
bool hasUnlisted(const WholeMemory::Contents &both, const QSet<QString> &listed)
{
    const auto changes = both.stored.changesTo(both.inUse);
    const auto data = both.stored.dataChangesTo(both.inUse);
    return std::any_of(
               changes.begin(), changes.end(),
               [&listed](const ParameterChange &change) { return !listed.contains(change.spec->key); })
        || std::any_of(data.begin(), data.end(), [&listed](const DataChange &change) {
               return !listed.contains(QLatin1String(change.spec->data));
           });
}

}  // namespace

bool Workspace::canCompareStored() const
{
    return m_client.isConnected() && m_client.identity().writable && m_client.device()->wholeMemory();
}

QFuture<Result<WholeMemory::Contents>> Workspace::compareStored()
{
    beginWork();
    return m_client
        .submit<WholeMemory::Contents>([](Channel &channel, Device &device) -> Result<WholeMemory::Contents> {
            WholeMemory *memory = device.wholeMemory();
            return memory ? memory->readBoth(channel) : failure(ErrorCode::Unsupported);
        })
        .then(this, [this](const Result<WholeMemory::Contents> &both) {
            endWork();
            if (both)
                learnStored(*both);
            return both;
        });
}

// A board that keeps its values in a text starts with those.
void Workspace::compareWithText()
{
    m_isTextOlder = std::as_const(m_configuration).board().usesUnstored();
    emit unstoredChanged();
}

// The board's values are those that are stored from now on; what else is in use is live.
void Workspace::learnStored(const WholeMemory::Contents &both)
{
    const Configuration &board = std::as_const(m_configuration).board();
    if (board.isEmpty() || board.identity().serial != both.stored.identity().serial)
        return;
    Configuration stored = both.stored;
    for (const MissingPart &part : board.missing()) {
        if (stored.blocks().contains(part.key))
            continue;
        if (board.blocks().contains(part.key))
            stored.setBlock(part.key, board.block(part.key));
        stored.addMissing(part.key, part.why);
    }
    m_configuration.setBoard(stored);
    m_live.read();
    m_storedKnown = true;
    setUnstored(!both.stored.dataChangesTo(both.inUse).empty());
}

// After an action that has compared.
void Workspace::learnLastStored()
{
    m_client
        .submit<WholeMemory::Contents>([](Channel &channel, Device &device) -> Result<WholeMemory::Contents> {
            auto inUse = device.readConfiguration(channel);
            if (!inUse)
                return tl::unexpected(inUse.error());
            auto stored = device.wholeMemory()->lastStored();
            if (!stored)
                return failure(ErrorCode::Unready);
            return WholeMemory::Contents{*std::move(inUse), *std::move(stored)};
        })
        .then(this, [this](const Result<WholeMemory::Contents> &both) {
            if (both)
                learnStored(*both);
        });
}

// Told where it is not.
bool Workspace::isProven(const ActionOutcome &stored)
{
    if (stored.answered)
        return true;
    m_notifications.notify(
        tr("The command to store was sent, but whether the board has stored could not be proven: %1")
            .arg(stored.reply.value(u"unproven"_s).toString()),
        Notice::Attention);
    return false;
}

QFuture<bool> Workspace::storeAll()
{
    return perform(m_client.device() && m_client.device()->live() ? m_client.device()->live()->storeAction()
                                                                  : QString(),
                   {})
        .then(this, [this](const Result<ActionOutcome> &saved) {
            if (!saved || !isProven(*saved))
                return false;
            m_notifications.notify(
                (saved->isStoreUntold ? tr(
                     "The board confirms that it has stored; only its next start shows it. The settings as "
                     "they were are kept in %1")
                                      : tr("Stored on the board. The settings as they were are kept in %1"))
                    .arg(saved->snapshotPath));
            return true;
        });
}

QFuture<bool> Workspace::saveLive(QWidget &over, std::optional<QSet<QString>> listed)
{
    if (m_guided) {
        tellGuided();
        return QtFuture::makeReadyFuture(false);
    }
    if (refusesMeanwhile())
        return QtFuture::makeReadyFuture(false);
    return isAlarmedInUse() ? askToStoreAlarmed(over, listed) : storeLive(over, listed);
}

// All that was in use when the gimbal ran away or oscillated still is.
bool Workspace::isAlarmedInUse() const
{
    const LiveValues now = m_live.unsaved();
    return !m_alarmedWith.empty() && std::ranges::all_of(m_alarmedWith, [&now](const LiveValue &value) {
        return std::ranges::any_of(now, [&value](const LiveValue &each) {
            return each.key == value.key && sameValue(each.inUse, value.inUse);
        });
    });
}

QFuture<bool> Workspace::askToStoreAlarmed(QWidget &over, const std::optional<QSet<QString>> &listed)
{
    const Stored stored = makeStored();
    const QPointer<QWidget> window = &over;
    const auto store = [this, stored, window, listed] {
        m_alarmedWith.clear();
        if (window)
            saveLive(*window, listed).then(this, [stored](bool done) { end(stored, done); });
        else
            end(stored, false);
    };
    QDialog *panel = askInPanel({tr("Store values that an alarm came with?"),
                                 tr("With these values in use, the program has seen the gimbal run away or "
                                    "oscillate. Stored, they are used again after every start of the board."),
                                 {{tr("Store them all the same"), store, true}},
                                 tr("Store nothing")},
                                &over);
    connect(&m_client, &DeviceClient::stateChanged, panel, &QDialog::reject);
    connect(panel, &QDialog::rejected, this, [stored] { end(stored, false); });
    return stored->future();
}

QFuture<bool> Workspace::storeLive(QWidget &over, std::optional<QSet<QString>> listed)
{
    if (!canCompareStored())
        return reviewRewriting(over);
    if (!listed) {
        listed.emplace();
        for (const LiveValue &value : m_live.unsaved())
            listed->insert(value.key);
    }
    const QPointer<QWidget> window = &over;
    return compareStored()
        .then(this,
              [this, window, listed = *listed](const Result<WholeMemory::Contents> &both) {
                  if (both && !hasUnlisted(*both, listed))
                      return storeAll();
                  if (both && window)
                      return reviewStoring(*both, *window);
                  // Motors that are stored otherwise than they are in use: nobody can list the rest.
                  if (!both && both.error().code == ErrorCode::ConditionUnmet && window)
                      return askToStoreAll(both.error(), *window);
                  if (!both)
                      m_notifications.report(both.error());
                  return QtFuture::makeReadyFuture(false);
              })
        .unwrap();
}

// Where storing rewrites a text of the board, its lines are seen before.
QFuture<bool> Workspace::reviewRewriting(QWidget &over)
{
    const LiveAccess *live = m_client.device() ? m_client.device()->live() : nullptr;
    Configuration inUse = std::as_const(m_configuration).board();
    for (const int id : m_live.parameters()) {
        if (const auto value = m_live.value(id))
            std::ignore = inUse.setRaw(inUse.parameters().at(id), 0, *value);
    }
    const auto after = live ? live->storedAs(inUse) : std::nullopt;
    // What stands in the way is told by storing.
    if (!after || !*after || inUse.dataChangesTo(**after).empty())
        return storeAll();
    const Stored stored = makeStored();
    auto *review = new ReviewDialog(inUse, **after, {}, &over);
    review->setFlies(m_notifications.flies());
    std::vector<ParameterChange> changes;
    for (const LiveValue &value : m_live.unsaved())
        changes.push_back({inUse.parameters().find(value.key), 0, value.stored, value.inUse});
    review->setTextLeaps(leapsAmong(changes));
    review->setAttribute(Qt::WA_DeleteOnClose);
    connect(&m_client, &DeviceClient::stateChanged, review, &QDialog::reject);
    connect(review, &QDialog::rejected, this, [stored] { end(stored, false); });
    connect(review, &QDialog::accepted, this,
            [this, stored] { storeAll().then(this, [stored](bool done) { end(stored, done); }); });
    openPanel(*review);
    return stored->future();
}

QFuture<bool> Workspace::reviewStoring(const WholeMemory::Contents &both, QWidget &over)
{
    const Stored stored = makeStored();
    auto *review = new ReviewDialog(both.stored, both.inUse, {}, &over);
    review->setAttribute(Qt::WA_DeleteOnClose);
    connect(&m_client, &DeviceClient::stateChanged, review, &QDialog::reject);
    connect(review, &QDialog::rejected, this, [stored] { end(stored, false); });
    connect(review, &QDialog::accepted, this, [this, review, stored, inUse = both.inUse] {
        const Configuration chosen = review->chosen();
        const bool isAll = chosen.changesTo(inUse).empty() && chosen.dataChangesTo(inUse).empty();
        (isAll ? storeAll() : storeChosen(chosen)).then(this, [stored](bool done) { end(stored, done); });
    });
    openPanel(*review);
    return stored->future();
}

QFuture<bool> Workspace::askToStoreAll(const Error &untold, QWidget &over)
{
    const Stored stored = makeStored();
    // The detail begins with the key of the value that stands in the way.
    const ParameterSpec *spec = m_configuration.board().parameters().find(untold.detail.section(u' ', 0, 0));
    const QString cause = spec ? tr("%1 is stored otherwise than it is used").arg(parameterLabel(*spec))
                               : detailText(untold.detail);
    QDialog *panel = askInPanel(
        {tr("Store everything in use?"),
         tr("What is stored cannot be compared now, so values cannot be kept out: %1. The board stores "
            "everything that it uses, whoever has set it.")
             .arg(cause),
         {{tr("Store everything"),
           [this, stored] { storeAll().then(this, [stored](bool done) { end(stored, done); }); }, true}},
         tr("Store nothing")},
        &over);
    connect(&m_client, &DeviceClient::stateChanged, panel, &QDialog::reject);
    connect(panel, &QDialog::rejected, this, [stored] { end(stored, false); });
    return stored->future();
}

QFuture<bool> Workspace::storeChosen(const Configuration &chosen)
{
    const Stored stored = makeStored();
    if (m_writer.isWriting()) {
        end(stored, false);
        return stored->future();
    }
    connect(
        &m_writer, &BoardWriter::finished, this,
        [this, stored] { end(stored, lastReport() && lastReport()->isComplete()); },
        Qt::SingleShotConnection);
    write(chosen);
    return stored->future();
}
