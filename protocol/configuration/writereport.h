// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/configuration.h"

#include <algorithm>

/// Outcome for one changed parameter.
enum class WriteState {
    Verified,  ///< written, read back, equal
    Unknown,  ///< sent, and the board could not be asked since what it holds
    NotWritten,  ///< never sent, or not taken by the board: it holds the old value
    Mismatch,  ///< read back with another value than written
    RolledBack,  ///< written, then restored because the rest failed
};

struct WriteLine
{
    const ParameterSpec *spec = nullptr;
    int profile = 0;
    double from = 0;
    double to = 0;
    WriteState state = WriteState::NotWritten;
    double found = 0;  ///< what the board holds, as last read; of no meaning while Unknown
    /// Verified, on a board that answers with what is in use and used it before: whether it is stored shows
    /// at its next start.
    bool isStoreUntold = false;
    QString setBy = {};  ///< what on the board sets it as well, whatever is written: "script 2"
    /// What was read back after it was sent, before anything was put back; empty: it could not be.
    std::optional<double> taken = {};

    /// The board holds another value than the one it had made of what was sent.
    [[nodiscard]] bool wasTakenOtherwise() const
    {
        return taken && !sameValue(*taken, to) && !sameValue(*taken, found);
    }
    /// The state that follows from what was read; asBefore where that is the old value.
    [[nodiscard]] WriteState read(WriteState asBefore) const
    {
        if (sameValue(found, from))
            return asBefore;
        return sameValue(found, to) ? WriteState::Verified : WriteState::Mismatch;
    }
};

/// The same for a block without parameters.
struct WriteData
{
    const BlockSpec *spec = nullptr;
    BlockKey key;
    WriteState state = WriteState::NotWritten;
    /// Whether it was otherwise than before once it was sent; empty: it could not be read.
    std::optional<bool> wasTaken = {};
};

/// On boards that can only store everything in use at once: what becomes of values that are in use without
/// being stored, beside those that are written.
enum class OtherValues {
    Keep,  ///< they stay in use, and what is stored stays stored
    Store,  ///< they are stored as well
    PutBack,  ///< the stored ones are put into use
};

/// Such a value, as it was found before the write.
struct OtherValue
{
    const ParameterSpec *spec = nullptr;
    double inUse = 0;
    double stored = 0;
    QString setBy;  ///< what on the board sets it: "script 2"; empty: somebody did
    /// What is in use after the write, where leaving it in use, or putting the stored one back, was refused.
    std::optional<double> now = {};
};

/// A value that was stored although nobody wanted it: what runs on the board had set it between putting the
/// wanted values into use and storing them.
struct StoredMeanwhile
{
    const ParameterSpec *spec = nullptr;
    double before = 0;
    double now = 0;
    QString setBy;  ///< "script 2"
};

/// What is in use after a write that failed, or could not leave in use what was to stay so, on a board that
/// keeps that apart from what is stored.
struct UseReport
{
    Configuration before;  ///< what was in use, and of what is written and in use now, that
    QStringList selfSet;  ///< keys of what the board itself sets
    std::optional<Configuration> now = {};  ///< as read since; empty: it could not be

    [[nodiscard]] std::vector<ParameterChange> changes() const
    {
        auto changes = now ? before.changesTo(*now) : std::vector<ParameterChange>();
        std::erase_if(changes,
                      [this](const ParameterChange &change) { return selfSet.contains(change.spec->key); });
        return changes;
    }
    [[nodiscard]] std::vector<DataChange> dataChanges() const
    {
        return now ? before.dataChangesTo(*now) : std::vector<DataChange>();
    }
};

/// What speaks for a restart of the board in the middle of a write, and what its motors do otherwise since.
struct RestartSigns
{
    double silentSeconds = 0;  ///< it stayed silent for so long, and then answered again; 0: it did not
    bool motorsStarted = false;  ///< they run now, and did not before
    bool motorsStopped = false;  ///< they are off now, and ran before: no sign of a restart by itself

    [[nodiscard]] bool areAny() const { return motorsStarted || silentSeconds > 0; }
    [[nodiscard]] bool areTold() const { return areAny() || motorsStopped; }
    [[nodiscard]] bool areProof() const { return motorsStarted && silentSeconds > 0; }
};

/// Result of a write, parameter by parameter. States only what is known: nothing is "probably written".
struct WriteReport
{
    std::vector<WriteLine> lines;
    std::vector<WriteData> data;
    bool namesWanted = false;  ///< profiles were to have other names
    WriteState namesState = WriteState::NotWritten;  ///< of all of them; the names found are in `onBoard`
    /// What is otherwise than before although it was not to be written, after a write that failed.
    std::vector<ParameterChange> strays;
    QStringList strayPlaces;  ///< the same of bytes without a parameter
    RestartSigns restart;
    std::vector<OtherValue> others;
    std::vector<StoredMeanwhile> storedMeanwhile;
    std::shared_ptr<const ParameterSet> otherParameters;  ///< which their specs are of
    QStringList otherData;  ///< blocks without parameters, likewise
    OtherValues othersWere = OtherValues::Keep;  ///< what was done with them
    QStringList othersLost = {};  ///< "pid.pitch.p=5.00": not in use any more, as read after the link broke
    /// The board answers with what is in use: what was set there without being stored is stored now as well,
    /// and nobody can tell what that is.
    bool storesUse = false;
    bool areOthersUnknown = false;  ///< the link broke before that could be seen
    /// Why nobody can tell; then all that was in use is stored, as the operator chose.
    std::optional<Error> othersUnknown;
    std::optional<UseReport> use = {};  ///< where it may be otherwise than expected
    /// What was written is in use, and why nobody can tell whether it is stored.
    std::optional<Error> storedUntold = {};
    std::optional<Error> error;  ///< why it is incomplete
    bool wasSent = true;  ///< false: it failed before anything of it had been sent
    /// The board uses another profile than before the write: this one; kUnread: it could not be asked.
    std::optional<int> strayProfile = {};
    static constexpr int kUnread = -1;
    QString snapshotPath;  ///< the backup made before
    QStringList snapshotLacks = {};  ///< parts that the board has and the backup does not hold
    Configuration before;  ///< what the board was expected to hold before; wanted: what it should hold after
    Configuration wanted;
    Configuration onBoard;  ///< what the board holds now, as far as it is known

    [[nodiscard]] bool isComplete() const { return !error; }
    [[nodiscard]] bool isSnapshotComplete() const
    {
        return !snapshotPath.isEmpty() && snapshotLacks.isEmpty();
    }
    /// All that was wanted is on the board, and nothing else was changed, whatever went wrong meanwhile.
    [[nodiscard]] bool holdsAll() const
    {
        const auto isThere = [](const auto &each) { return each.state == WriteState::Verified; };
        return (!lines.empty() || !data.empty() || namesWanted)
            && std::all_of(lines.begin(), lines.end(), isThere)
            && std::all_of(data.begin(), data.end(), isThere) && (!namesWanted || areNamesWritten())
            && strays.empty() && strayPlaces.isEmpty() && !strayProfile && !storedUntold && !areOthersUnknown
            && othersLost.isEmpty();
    }
    [[nodiscard]] bool areNamesWritten() const { return namesWanted && namesState == WriteState::Verified; }
    [[nodiscard]] bool areNamesUnknown() const { return namesWanted && namesState == WriteState::Unknown; }
    /// Something was sent, and the board could not be asked since what it holds.
    [[nodiscard]] bool hasUnknown() const { return count(WriteState::Unknown) > 0 || areNamesUnknown(); }
    /// The names that the board holds now; asBefore where those are the old ones.
    void learnNames(const QStringList &names, WriteState asBefore)
    {
        onBoard.setProfileNames(names);
        namesState = !onBoard.hasOtherNames(wanted) ? WriteState::Verified
            : !onBoard.hasOtherNames(before)        ? asBefore
                                                    : WriteState::Mismatch;
    }
    /// Which profile the board uses.
    void learnProfile(int active)
    {
        strayProfile = active == before.activeProfile() ? std::nullopt : std::optional(active);
    }
    /// The board was read again later: what was unknown is known as far as it was delivered.
    void learn(const Configuration &board)
    {
        for (WriteLine &line : lines) {
            const ParameterSpec *spec = board.parameters().find(line.spec->key);
            const auto raw = spec ? board.raw(*spec, line.profile) : std::nullopt;
            if (line.state != WriteState::Unknown || !raw)
                continue;
            line.found = *raw;
            line.state = line.read(WriteState::NotWritten);
        }
        learnStrays(before.changesTo(board));
        for (WriteData &block : data) {
            const QByteArray now = board.block(block.key);
            if (block.state != WriteState::Unknown || now.isEmpty())
                continue;
            block.state = now == before.block(block.key) ? WriteState::NotWritten
                : now == wanted.block(block.key)         ? WriteState::Verified
                                                         : WriteState::Mismatch;
        }
        onBoard = board;
        if (strayProfile)
            learnProfile(board.activeProfile());
        if (areNamesUnknown() && !board.findMissing({0, MissingPart::kProfileNames}))
            learnNames(board.profileNames(), WriteState::NotWritten);
    }
    /// What of these changes was not to be written.
    void learnStrays(std::vector<ParameterChange> changes)
    {
        std::erase_if(changes, [this](const ParameterChange &change) {
            return std::any_of(lines.begin(), lines.end(), [&change](const WriteLine &line) {
                return line.spec->key == change.spec->key
                    && (line.profile == change.profile || line.spec->row->scope == Scope::Board);
            });
        });
        strays = std::move(changes);
    }
    /// What is in use was read again later: values that are still in use, each as it was, were kept.
    void learnOthers(const Configuration &inUse)
    {
        std::erase_if(others, [this, &inUse](const OtherValue &other) {
            const ParameterSpec *spec = inUse.parameters().find(other.spec->key);
            const bool isKept = spec && sameValue(inUse.raw(*spec, inUse.activeProfile()), other.inUse);
            if (!isKept)
                othersLost.append(other.spec->key + QLatin1Char('=') + other.spec->format(other.inUse));
            return !isKept;
        });
        areOthersUnknown = false;
        othersWere = OtherValues::Keep;
        if (use)
            use->now = inUse;
    }
    /// How many values the board is known to hold that it did not hold before.
    [[nodiscard]] int countOther() const
    {
        int n = int(strays.size()) + int(strayPlaces.size());
        for (const WriteLine &line : lines)
            n += line.state != WriteState::Unknown && !sameValue(line.found, line.from);
        for (const WriteData &block : data)
            n += block.state != WriteState::Unknown && onBoard.block(block.key) != before.block(block.key);
        return n;
    }
    [[nodiscard]] int countStoreUntold() const
    {
        return int(std::count_if(lines.begin(), lines.end(), [](const WriteLine &line) {
            return line.state == WriteState::Verified && line.isStoreUntold;
        }));
    }
    [[nodiscard]] int count(WriteState state) const
    {
        int n = 0;
        for (const WriteLine &line : lines)
            n += line.state == state;
        for (const WriteData &block : data)
            n += block.state == state;
        return n;
    }
};
