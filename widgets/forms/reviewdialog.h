// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/livevalues.h"
#include "protocol/configuration/scriptmistake.h"
#include "protocol/configuration/writereport.h"
#include "widgets/models/changemodel.h"

#include <QDialog>

#include <functional>

class QComboBox;
class QLabel;
class QPlainTextEdit;
class QPushButton;
class QTableView;

/// What will be written, before it is: board and new value side by side, red class first, a tick for each.
class ReviewDialog final : public QDialog
{
    Q_OBJECT
public:
    /// @param live what is in use without being stored, where the board would store all of it; else empty
    ReviewDialog(const Configuration &board, const Configuration &edited, const LiveValues &live = {},
                 QWidget *parent = nullptr);

    /// What is in use and is replaced by what is stored when the board loads what is written.
    void setReplaced(const LiveValues &replaced);
    /// Nobody holds what flies: then what is said of dangerous values is about a drone.
    void setFlies(bool flies);
    /// Tells what speaks against the texts of a configuration; asked for those that are written.
    using DoubtsOf = std::function<std::vector<ScriptMistake>(const Configuration &)>;
    void setDoubtsOf(const DoubtsOf &doubtsOf);
    /// Leaps (isLeap()) that a text which changes brings, and that no row tells.
    void setTextLeaps(const std::vector<ParameterChange> &leaps);
    /// The configuration with the ticked changes.
    [[nodiscard]] Configuration chosen() const { return m_changes.ticked(); }
    /// What becomes of values in use that are not among them.
    [[nodiscard]] OtherValues others() const;
    [[nodiscard]] QComboBox *othersChoice() const { return m_others; }
    [[nodiscard]] QTableView *table() const { return m_table; }
    /// The lines of texts that change; null without any.
    [[nodiscard]] QPlainTextEdit *lines() const { return m_lines; }
    /// What is said of the texts that are written.
    [[nodiscard]] QString doubts() const;
    [[nodiscard]] QPushButton *writeButton() const { return m_write; }
    /// What is said of dangerous values, also where it is not shown.
    [[nodiscard]] QString riskText() const;

private:
    void updateButton();
    [[nodiscard]] QString leapsText() const;
    void updateOthers();
    /// Returns whether there are doubts.
    bool showDoubts();
    void makeLines(const Configuration &board, const Configuration &edited);

    ChangeModel m_changes;
    QTableView *m_table;
    QPlainTextEdit *m_lines = nullptr;
    QLabel *m_risk;
    DoubtsOf m_doubtsOf;
    QLabel *m_doubts;
    QString m_riskText;  // what the risk class means
    std::vector<ParameterChange> m_textLeaps;
    LiveValues m_live;
    bool m_areReplaced = false;
    QLabel *m_othersText;
    QComboBox *m_others;
    QLabel *m_effect;  // what writing means for the board
    QPushButton *m_write;
};
