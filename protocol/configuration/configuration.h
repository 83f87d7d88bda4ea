// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/result.h"
#include "protocol/configuration/identity.h"

#include <map>
#include <memory>

/// Which block of which profile.
struct BlockKey
{
    int profile = 0;
    int block = 0;

    friend auto operator<=>(const BlockKey &, const BlockKey &) = default;
};

/// A difference between two configurations in one parameter.
struct ParameterChange
{
    const ParameterSpec *spec = nullptr;
    int profile = 0;  ///< the active profile for board-wide parameters
    double from = 0;
    double to = 0;
};

/// A difference between two configurations in a block without parameters (BlockSpec::data).
struct DataChange
{
    const BlockSpec *spec = nullptr;
    BlockKey key;
    QByteArray from;
    QByteArray to;
};

/// A part that the board has but did not deliver.
struct MissingPart
{
    static constexpr int kProfileNames = -1;  ///< as BlockKey::block

    BlockKey key;
    Error why;
};

/// The values of one board, kept as the raw blocks they came in, so reserved and unknown bytes survive
/// untouched.
class Configuration
{
public:
    Configuration() = default;
    Configuration(BoardIdentity identity, std::shared_ptr<const ParameterSet> parameters);

    [[nodiscard]] bool isEmpty() const { return m_blocks.empty(); }
    [[nodiscard]] const BoardIdentity &identity() const { return m_identity; }
    /// Of a file that tells none, so that it is not taken for another such file.
    void setSerial(const QString &serial) { m_identity.serial = serial; }
    [[nodiscard]] const ParameterSet &parameters() const { return *m_parameters; }
    [[nodiscard]] const std::shared_ptr<const ParameterSet> &parameterSet() const { return m_parameters; }

    [[nodiscard]] int activeProfile() const { return m_activeProfile; }
    void setActiveProfile(int profile) { m_activeProfile = profile; }
    [[nodiscard]] const QStringList &profileNames() const { return m_profileNames; }
    void setProfileNames(const QStringList &names);
    /// Whether any profile has a different name; a missing name equals an empty one.
    [[nodiscard]] bool hasOtherNames(const Configuration &other) const;
    /// The name, or "Profile N" (N from 1) if it has none.
    [[nodiscard]] QString profileName(int profile) const;

    [[nodiscard]] const std::map<BlockKey, QByteArray> &blocks() const { return m_blocks; }
    [[nodiscard]] QByteArray block(BlockKey key) const;
    void setBlock(BlockKey key, QByteArray bytes);

    /// Parts that the board has but did not deliver; what a firmware does not have is none of them.
    [[nodiscard]] const std::vector<MissingPart> &missing() const { return m_missing; }
    /// A part that is set later is no longer missing.
    void addMissing(BlockKey key, const Error &why);
    /// Null if it is not missing.
    [[nodiscard]] const MissingPart *findMissing(BlockKey key) const;
    /// The part without which a value is not known; null if the value is there, or the board lacks it.
    [[nodiscard]] const MissingPart *findMissing(const ParameterSpec &spec, int profile) const;
    /// The name that the parameters' tables give a block.
    [[nodiscard]] QString blockName(int block) const;
    /// "PARAMS_EXT of profile 2", for error details and reports.
    [[nodiscard]] QString partName(BlockKey key) const;
    /// Names of everything that is missing.
    [[nodiscard]] QStringList missingNames() const;

    /// Raw value, NaN for a float that is not a number; empty when the board did not deliver that block.
    [[nodiscard]] std::optional<double> raw(const ParameterSpec &spec, int profile) const;
    /// Sets a raw value; a board-wide one is set in every profile's block. Errors: OutOfRange (what
    /// ParameterSpec::accepts() does not, so also NaN), InvalidArgument (a fraction for an integer),
    /// Unsupported (no such block), ReadOnly (a state value).
    Result<void> setRaw(const ParameterSpec &spec, int profile, double raw);
    /// Sets a value that the board is known to hold or to have held, allowed or not. Errors: OutOfRange (not
    /// a number, or none that fits its bytes), Unsupported (no such block), ReadOnly.
    Result<void> restoreRaw(const ParameterSpec &spec, int profile, double raw);
    /// Copies a value bit by bit from another configuration of the same parameters, even if it is out of
    /// range or not a number. Errors: Unsupported (one of them has no such block), ReadOnly.
    Result<void> copyRaw(const ParameterSpec &spec, int profile, const Configuration &from);

    /// The number that stands for a raw value in a text which the board keeps (ParameterRow::textFigure).
    [[nodiscard]] std::optional<double> textFigure(const ParameterSpec &spec, double raw) const;
    /// The value that the board starts with, as a text that it keeps tells (ParameterRow::startsWith).
    [[nodiscard]] std::optional<double> startsWith(const ParameterSpec &spec) const;
    /// Whether it starts with another value than the one that it uses; empty: not all of it is told, or
    /// nothing.
    [[nodiscard]] std::optional<bool> usesUnstored() const;

    /// The rule that a value breaks, and the parameter with which it does (null: alone). Null: none.
    struct Contradiction
    {
        const ValueRule *rule = nullptr;
        const ParameterSpec *other = nullptr;
    };
    [[nodiscard]] Contradiction findContradiction(const ParameterSpec &spec, int profile) const;
    /// Whether its values can hold together. What contradicts itself already in `held` may stay as it is.
    /// So may a text that is not valid. Errors: Contradiction with both parameters; InvalidArgument with the
    /// place in the text.
    [[nodiscard]] Result<void> checkRules(const Configuration &held) const;

    /// All parameters in which the two differ, board-wide ones once. Both must have the same parameter set.
    [[nodiscard]] std::vector<ParameterChange> changesTo(const Configuration &other) const;
    /// The same for blocks without parameters, if both have them.
    [[nodiscard]] std::vector<DataChange> dataChangesTo(const Configuration &other) const;

private:
    [[nodiscard]] bool isBroken(const ValueRule &rule, int profile) const;
    Result<void> put(const ParameterSpec &spec, int profile, double raw);

    BoardIdentity m_identity;
    std::shared_ptr<const ParameterSet> m_parameters;
    std::map<BlockKey, QByteArray> m_blocks;
    std::vector<MissingPart> m_missing;
    QStringList m_profileNames;
    int m_activeProfile = 0;
};
