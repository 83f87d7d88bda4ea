// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/result.h"
#include "protocol/configuration/configuration.h"
#include "protocol/guide/setupstep.h"

#include <QDateTime>
#include <QJsonObject>
#include <QList>

#include <functional>
#include <map>
#include <optional>

/// What a step has measured, and what it was before, where that is known.
struct SetupFigure
{
    QString key;  ///< see setupFigures(); after it the axis, where there is one
    double value = 0;
    std::optional<double> before = {};
};

/// A parameter that a step has written and read back, or proposes; or that was so already, where that had to
/// be found.
struct SetupChange
{
    QString key;
    int profile = 0;  ///< from 0
    QString from;
    QString to;
};

/// How a step ended.
struct SetupResult
{
    enum class State { Open, Done, Poor, Skipped, Failed };

    State state = State::Open;
    QDateTime at;
    QList<SetupFigure> figures;
    QStringList remarks;  ///< see setupRemarks()
    QList<SetupChange> changes;
    QString why;  ///< of one that failed: the error's own words
    QString snapshot;  ///< path of the copy made before

    /// Nothing that has to be done again.
    [[nodiscard]] bool isOver() const { return state == State::Done || state == State::Skipped; }
    /// A parameter is otherwise than it was.
    [[nodiscard]] bool hasChanged() const;
    [[nodiscard]] std::optional<double> figure(const QString &key) const;
};

/// How far a board has come, kept beside its snapshots so that the way can be gone on with later.
class SetupRecord
{
public:
    SetupRecord() = default;
    explicit SetupRecord(const BoardIdentity &identity)
        : m_identity(identity)
    {
    }

    [[nodiscard]] const BoardIdentity &identity() const { return m_identity; }
    [[nodiscard]] SetupResult result(SetupStep step) const;
    void set(SetupStep step, const SetupResult &result) { m_results[step] = result; }
    /// The same for one that was done again: what it changed the first time, and what was before, stays
    /// known.
    void add(SetupStep step, SetupResult result);
    /// Steps whose values the board does not hold any more are to be done again. @return whether there are
    /// any
    bool compare(const Configuration &board);
    void clear() { m_results.clear(); }
    /// The first that is neither done nor skipped; empty: none is.
    [[nodiscard]] std::optional<SetupStep> next(const std::vector<SetupStep> &steps) const;

    [[nodiscard]] QJsonObject toJson() const;
    /// Errors: InvalidArgument (it is no such record).
    [[nodiscard]] static Result<SetupRecord> fromJson(const QJsonObject &json, const BoardIdentity &identity);

    /// Errors: BadFile.
    Result<void> save(const QString &path) const;
    /// One that does not exist is empty. Errors: BadFile.
    [[nodiscard]] static Result<SetupRecord> load(const QString &path, const BoardIdentity &identity);

private:
    [[nodiscard]] bool isHeld(const SetupChange &change, const Configuration &board) const;

    BoardIdentity m_identity;
    std::map<SetupStep, SetupResult> m_results;
};

/// "done", "poor", "skipped", "failed", "open".
[[nodiscard]] QString setupStateKey(SetupResult::State state);

/// The words of what the tables hold, in the reader's language.
using SetupWords = std::function<QString(const char *text)>;
/// "done", "to be done again"
[[nodiscard]] QString setupStateWord(SetupResult::State state, const SetupWords &words);
/// "0.115 °/s ← 2.400": what is, and what was before.
[[nodiscard]] QString setupFigureText(const SetupFigure &figure);
/// What a value of a parameter is called, by the parameter's key and the value as it is kept.
using SetupValueWords = std::function<QString(const QString &key, const QString &value)>;
/// The names of choices as their table has them.
[[nodiscard]] SetupValueWords setupValueNames(std::shared_ptr<const ParameterSet> parameters);
/// "None → RC channel 1"; "RC channel 1" where it was so already.
[[nodiscard]] QString setupChangeText(const SetupChange &change, const SetupValueWords &valueOf,
                                      const QString &arrow = QStringLiteral("→"));
/// "Zero of the gyroscope · Roll"
[[nodiscard]] QString setupFigureLabel(const SetupFigure &figure, const SetupWords &words);
/// The words of its frame, for the catalogue.
[[nodiscard]] std::span<const char *const> setupCertificateWords();
/// The certificate as one page of HTML: the board, each step with what it measured, and what was left out.
/// @param labelOf what a parameter is called, by its key @param valueOf its values @param note what else has
/// to be known; may be empty
[[nodiscard]] QString setupCertificate(const SetupRecord &record, const std::vector<SetupStep> &steps,
                                       const SetupWords &words,
                                       const std::function<QString(const QString &key)> &labelOf,
                                       const SetupValueWords &valueOf, const QString &note = {});
