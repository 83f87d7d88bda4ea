// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"
#include "widgets/models/adjustablemodel.h"

class FilterTable;
class QCheckBox;
class QLineEdit;

/// All live-adjustable variables: shows and sets the values in use.
class VariablesPage final : public Page
{
    Q_OBJECT
public:
    explicit VariablesPage(Workspace &workspace, QWidget *parent = nullptr);

    [[nodiscard]] AdjustableModel &model() { return m_model; }
    [[nodiscard]] FilterTable *table() const { return m_table; }

private:
    void save();
    void onState();

    AdjustableModel m_model;
    FilterTable *m_table;
    QLineEdit *m_search;
    QCheckBox *m_live;
    QLabel *m_note;
};
