// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/configuration.h"

#include <QMap>
#include <QObject>

/// What the board holds and what the operator wants: two configurations of one board, with signals for their
/// changes. Dirty is a comparison, never a flag.
class ConfigurationModel final : public QObject
{
    Q_OBJECT
public:
    explicit ConfigurationModel(QObject *parent = nullptr);

    [[nodiscard]] bool isEmpty() const { return m_board.isEmpty(); }
    [[nodiscard]] const Configuration &board() const { return m_board; }
    [[nodiscard]] const Configuration &edited() const { return m_edited; }

    /// A new board, or the same one read again, discarding all edits.
    void reset(Configuration board);
    /// The same board read again: edits are kept where they still differ. False if it is another board.
    bool rebase(Configuration board);
    /// After a write: what is on the board now; edits that were not written stay edits.
    void setBoard(const Configuration &board);

    /// The board uses another profile now; forms follow.
    void setActiveProfile(int profile);
    /// Profile that forms show and edit.
    [[nodiscard]] int shownProfile() const { return m_shownProfile; }
    void setShownProfile(int profile);

    [[nodiscard]] std::optional<double> value(const ParameterSpec &spec, int profile) const;
    [[nodiscard]] std::optional<double> boardValue(const ParameterSpec &spec, int profile) const;
    [[nodiscard]] bool isChanged(const ParameterSpec &spec, int profile) const;
    /// What the board holds is taken over bit by bit, in range and a number or not. Errors: those of
    /// Configuration::setRaw().
    Result<void> setValue(const ParameterSpec &spec, int profile, double raw);
    /// Back to a value that was there before, allowed or not. Errors: those of Configuration::restoreRaw().
    Result<void> restoreValue(const ParameterSpec &spec, int profile, double raw);
    void setProfileName(int profile, const QString &name);
    /// Edits a block without parameters as a whole. Errors: Unsupported (no such block), OutOfRange (its
    /// length).
    Result<void> setData(BlockKey key, const QByteArray &bytes);

    [[nodiscard]] std::vector<ParameterChange> changes() const { return m_board.changesTo(m_edited); }
    [[nodiscard]] std::vector<DataChange> dataChanges() const { return m_board.dataChangesTo(m_edited); }
    [[nodiscard]] int changeCount() const { return m_changeCount; }
    /// How many changes there are in each profile; under kAllProfiles those of the board as a whole.
    [[nodiscard]] QMap<int, int> changesByProfile() const;
    static constexpr int kAllProfiles = -1;
    /// A board takes all names at once, so none is edited while some of them were not read.
    [[nodiscard]] bool canRename() const
    {
        return !m_board.isEmpty() && !m_board.findMissing({0, MissingPart::kProfileNames});
    }
    [[nodiscard]] bool namesChanged() const { return m_board.hasOtherNames(m_edited); }

signals:
    void boardReset();
    /// A write has changed what the board holds.
    void storedChanged();
    void valueChanged(int parameter, int profile);
    void dataChanged(int block, int profile);
    void shownProfileChanged(int profile);
    void activeProfileChanged(int profile);
    void profileNamesChanged();
    void changeCountChanged(int count);

private:
    Result<void> taken(const Result<void> &set, const ParameterSpec &spec, int profile);
    void keepNames(const Configuration &before, const QStringList &edited);
    void recount();

    Configuration m_board;
    Configuration m_edited;
    int m_shownProfile = 0;
    int m_changeCount = 0;
};
