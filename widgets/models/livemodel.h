// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/client/deviceclient.h"
#include "protocol/configuration/livevalues.h"
#include "widgets/models/configurationmodel.h"

#include <QElapsedTimer>
#include <QHash>
#include <QSet>

#include <functional>
#include <optional>
#include <vector>

/// Parameters that the board changes at once, in its volatile memory: what is in use now, what is stored, and
/// two sets to compare. Values are raw parameter values; writes go out one after the other, the newest value
/// of each wins. Beside those to tune with it knows all others that can be in use without being stored: an
/// action, a script or another program may have set them.
class LiveModel final : public QObject
{
    Q_OBJECT
public:
    enum class Slot { A, B };

    LiveModel(DeviceClient &client, ConfigurationModel &configuration, QObject *parent = nullptr);

    /// Ids of the parameters to tune with on this board, in table order.
    [[nodiscard]] const QList<int> &parameters() const { return m_parameters; }
    /// The value in use; empty until the board has reported it.
    [[nodiscard]] std::optional<double> value(int parameter) const;
    /// Raw values that can be set live, which may be fewer than can be stored.
    [[nodiscard]] std::pair<double, double> range(int parameter) const;
    /// What the active profile holds in permanent memory.
    [[nodiscard]] std::optional<double> stored(int parameter) const;
    [[nodiscard]] bool isChanged(int parameter) const;
    /// How many values in use are not stored.
    [[nodiscard]] int changeCount() const { return m_changeCount; }
    /// How many of them revert() puts back: those to tune with.
    [[nodiscard]] int tunedCount() const;
    [[nodiscard]] bool isDoubted() const { return !m_doubted.isEmpty(); }
    /// Values that were sent, and neither confirmed nor read since.
    [[nodiscard]] int doubtedCount() const { return int(m_doubted.size()); }
    /// All requested values have reached the board.
    [[nodiscard]] bool isSettled() const { return m_wanted.isEmpty() && !m_writing; }

    /// While a search, measurement or calibration runs, nobody puts a value into use: it would wait, be shown
    /// as if it were in use, and replace what was found. Each hold() has its release().
    void hold();
    void release();
    [[nodiscard]] bool isHeld() const { return m_holds > 0; }

    /// Asks the board what is in use.
    void read();
    /// Forgets what is in use: the board has loaded a profile anew.
    void forget();
    /// Not where it is a leap (isLeap()) from what the board had, or what was agreed to: leapt() tells then.
    void setValue(int parameter, double raw);
    /// Puts it into use, leap or not: the operator has been asked.
    void agree(int parameter, double raw);
    /// Puts into use what an operation has found: goes out in any case.
    void setValues(const QHash<int, double> &values);
    /// Puts back what a write has replaced: goes out in any case, and is no change that could be taken back.
    void putBack(const QHash<int, double> &values);
    /// Values in use that are not stored.
    [[nodiscard]] LiveValues unsaved() const;
    /// Those of them that were put into use here.
    [[nodiscard]] LiveValues ownUnsaved() const;
    /// Puts the stored values to tune with into use, ahead of pending changes.
    void revert();
    /// The operator has made a step whose values are in use still, or has undone one. Changes that follow
    /// each other within a second are one step.
    [[nodiscard]] bool canUndo() const { return nextStep(false).has_value(); }
    [[nodiscard]] bool canRedo() const { return nextStep(true).has_value(); }
    /// Puts into use what was so before that step, or again what was undone: a change like any other.
    void undo() { step(false); }
    void redo() { step(true); }

    [[nodiscard]] Slot slot() const { return m_slot; }
    /// Keeps the present values in the present slot and puts the other slot's values into use.
    void useSlot(Slot slot);
    /// Makes the other slot the same as the present values.
    void copyToOther();
    /// How many values differ between the two slots.
    [[nodiscard]] int slotDifference() const;

signals:
    /// Values are about to be put into use.
    void sending();
    /// Another board or profile: all values are new.
    void modelReset();
    void valueChanged(int parameter);
    /// It is not put into use unless agree() follows.
    void leapt(const ParameterChange &change);
    void changeCountChanged(int count);
    void slotChanged();
    void heldChanged(bool held);
    void failed(const Error &error);
    /// The board was silent when these were sent, and uses others: `stored` is what it uses instead.
    void notTaken(const LiveValues &values);
    /// There was no link when it was set: it is in use nowhere.
    void setWithoutLink(const LiveValues &values);
    /// All that was asked for has reached the board: these parameters.
    void settled(const QList<int> &parameters);

private:
    using Values = QHash<int, double>;  // parameter id -> raw
    void reset();
    void put(int parameter, double raw);
    /// The same, as a step of the operator.
    void choose(int parameter, double raw);
    void step(bool again);
    [[nodiscard]] std::optional<std::size_t> nextStep(bool again) const;
    void demand(const QHash<int, double> &values);
    void flush();
    void recount();
    void tellDoubted(const Values &doubted);
    [[nodiscard]] const ParameterSpec &spec(int parameter) const;
    [[nodiscard]] double usual(int parameter) const;
    [[nodiscard]] int variableOf(int parameter) const;
    [[nodiscard]] Values tuned() const;
    [[nodiscard]] LiveValues unsavedOf(const std::function<bool(int)> &isMeant) const;

    DeviceClient &m_client;
    ConfigurationModel &m_configuration;
    std::shared_ptr<const ParameterSet> m_set;
    QList<int> m_parameters;
    QList<int> m_known;  // the same, and the others whose value in use is known
    Values m_values;
    Values m_wanted;  // waiting to be written
    QSet<int> m_back;  // those of them that were in use before
    QSet<int> m_own;  // put into use here, and found so since
    Values m_agreed;
    QList<int> m_sent;  // since everything was settled last
    struct Step
    {
        Values before;
        Values after;
    };
    std::vector<Step> m_steps;
    std::size_t m_done = 0;  // of them; the others are undone
    QElapsedTimer m_stepAge;  // of the last one, while it goes on
    Values m_other;  // of the slot not in use
    Slot m_slot = Slot::A;
    bool m_otherKnown = false;
    bool m_writing = false;
    Values m_doubted;  // sent to a board that did not answer
    bool m_wasSilent = false;  // at one of them: no refusal has told about it
    int m_changeCount = 0;
    int m_holds = 0;
    QString m_boardKey;  // which board, firmware and profile the values belong to
    int m_generation = 0;  // answers to questions of an earlier board or profile are dropped
};
