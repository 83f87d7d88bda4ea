// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/page.h"
#include "widgets/models/profilemodel.h"

class QComboBox;
class QPushButton;
class QTableView;

/// Profiles: rename, copy one onto another, load, save, make active.
class ProfilesPage final : public Page
{
    Q_OBJECT
public:
    explicit ProfilesPage(Workspace &workspace, QWidget *parent = nullptr);

    [[nodiscard]] bool hasChanges() const override;
    [[nodiscard]] QTableView *table() const { return m_table; }
    /// Loads one profile of a file into a profile here, or asks which one where the file has several.
    void loadInto(const QString &path, int profile);
    void saveTo(const QString &path);
    /// Leads to the name of a profile.
    void showName(int profile);
    /// The profile chosen in the table, -1 without one.
    [[nodiscard]] int chosen() const;

private:
    void makeHeader();
    void makeBody();
    void connectAll();
    void updateButtons();
    void onNameRefused(int profile, const QString &name, int limit);
    void loadFrom(const QString &path, int from, int to);

    ProfileModel m_model;
    QTableView *m_table;
    QPushButton *m_active;
    QPushButton *m_rename;
    QPushButton *m_copy;
    QComboBox *m_target;
    QPushButton *m_load;
    QPushButton *m_save;
    QPushButton *m_loadAll;
};
