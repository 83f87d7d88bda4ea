// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <functional>

class Page;
class Workspace;
struct EditPlace;

/// Leads to where a step was undone or done again: the page, the profile and the field.
class EditGuide final : public QObject
{
    Q_OBJECT
public:
    /// Shows the page with that key; null if it cannot be shown.
    using ShowPage = std::function<Page *(const QString &key)>;
    EditGuide(Workspace &workspace, ShowPage showPage, QObject *parent);

private:
    void show(const EditPlace &place);

    Workspace &m_workspace;
    ShowPage m_showPage;
};
