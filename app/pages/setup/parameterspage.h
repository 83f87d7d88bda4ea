// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"
#include "widgets/models/parametermodel.h"

class HelpCard;
class ParameterForm;
class QComboBox;
class QLineEdit;
class QListWidget;
class QPushButton;
class QScrollArea;
class QSortFilterProxyModel;
class QStackedWidget;
class QTableView;

/// All parameters: groups on the left, forms made from the tables in the middle, the help card on the right;
/// or everything as one table.
class ParametersPage final : public Page
{
    Q_OBJECT
public:
    explicit ParametersPage(Workspace &workspace, QWidget *parent = nullptr);

    [[nodiscard]] bool hasChanges() const override;
    /// Shows a group, or one parameter with the focus in its field.
    void showGroup(int row);
    void showParameter(const QString &key);
    /// The same, in the view that is open, as far as it has it.
    void reveal(const ParameterSpec &spec);
    [[nodiscard]] ParameterForm *form() const { return m_form; }
    [[nodiscard]] QLineEdit *search() const { return m_search; }
    [[nodiscard]] QTableView *table() const { return m_table; }

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void makeHeader();
    void makeBody();
    void connectAll();
    void arrange(bool narrow);
    void fitGroups();
    void onBoard();
    void refilter();
    void updateGroupMarks();
    void onRefused(int parameter, const QString &text);
    void updateProfileNote();
    void focusEditor(int parameter);
    [[nodiscard]] bool matches(const ParameterSpec &spec) const;

    ParameterModel m_model;
    QSortFilterProxyModel *m_proxy;
    QListWidget *m_groups;
    QScrollArea *m_scroll;
    ParameterForm *m_form;
    HelpCard *m_help;
    QTableView *m_table;
    QStackedWidget *m_views;
    QLineEdit *m_search;
    QComboBox *m_level;
    QPushButton *m_onlyChanged;
    QPushButton *m_onlyNonDefault;
    QPushButton *m_onlyRed;
    QPushButton *m_asTable;
    QLabel *m_nothing;
    QPushButton *m_otherProfile;
    QVBoxLayout *m_left;
    QHBoxLayout *m_row;
    bool m_narrow = false;
};
