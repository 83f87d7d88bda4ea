// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/models/configurationmodel.h"
#include "widgets/models/refusedtexts.h"

#include <QJsonObject>
#include <QUndoStack>

/// Where a step acts: one value, the name of a profile, or a block as a whole.
struct EditPlace
{
    enum class Kind : std::uint8_t { Value, Name, Data };
    Kind kind = Kind::Value;
    QString key;  ///< of the parameter
    int profile = 0;
    int block = 0;
    QByteArray before;  ///< of the block, as the step found it when it was made
    QByteArray after;
};

/// Edits of the configuration that can be undone, over all pages and profiles.
class EditStack final : public QObject
{
    Q_OBJECT
public:
    explicit EditStack(ConfigurationModel &configuration, QObject *parent = nullptr);

    /// Changes a value; steps on the same value within one second become one edit. A value out of range or
    /// NaN is refused (false), unless it restores what the board holds.
    bool edit(int parameter, int profile, double raw);
    void rename(int profile, const QString &name);
    /// Changes a block without parameters as a whole.
    void editData(BlockKey key, const QByteArray &bytes);
    /// What was typed for values and is none; it goes with the edits when they are discarded.
    [[nodiscard]] RefusedTexts &refused() { return m_refused; }
    [[nodiscard]] const RefusedTexts &refused() const { return m_refused; }
    /// Takes back all edits, as one step that can itself be undone.
    void discardAll();
    /// Takes the profile values of one profile over into another, as one step. Returns what was left out
    /// because it is not allowed: "KEY = VALUE, allowed ...".
    QStringList copyProfile(int from, int to);
    /// Takes all values and names of a configuration of the same parameter set over, as one step.
    void apply(const Configuration &wanted, const QString &text);
    /// Takes one profile's values of a configuration of the same parameter set over, as one step. Returns
    /// what was left out.
    QStringList applyProfile(const Configuration &wanted, int from, int to, const QString &text);

    /// All steps that are not written yet, and undone ones, as data that survives the program.
    [[nodiscard]] QJsonObject toJson() const;
    struct Restored
    {
        bool any = false;
        int leftOut = 0;  ///< edits that do not fit this board
    };
    /// Puts such steps on an empty stack, as far as they fit this board.
    Restored restore(const QJsonObject &steps);
    /// Of such steps, those that the board does not hold already: what was written is left out, undone steps
    /// stay.
    [[nodiscard]] QJsonObject opened(const QJsonObject &steps) const;
    /// Some of such steps concern a part of the board that could not be read: nobody knows whether they fit.
    [[nodiscard]] bool concernsMissing(const QJsonObject &steps) const;
    [[nodiscard]] QUndoStack &undoStack() { return m_stack; }
    /// As the operator does it: tells where it acted.
    void undo();
    void redo();

signals:
    /// A step was undone or done again; of several values in one step, the first.
    void acted(const EditPlace &place);

private:
    void push(const ParameterChange &change);
    /// In range, or the board's own value.
    [[nodiscard]] bool canHold(const ParameterSpec &spec, int profile, double raw) const;
    /// @param edited what they have led to; null: what they say themselves
    [[nodiscard]] QJsonObject openSteps(const QJsonObject &steps, const Configuration *edited) const;
    /// False if it does not fit.
    bool restoreEdit(const QJsonObject &edit);

    ConfigurationModel &m_configuration;
    QUndoStack m_stack;
    RefusedTexts m_refused;
};
