// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>

#include <functional>
#include <optional>
#include <utility>

class Page;
class Workspace;
struct EditPlace;

/// Leads to where a step was undone or done again, or to what was typed and is no value: the page, the
/// profile and the field.
class EditGuide final : public QObject
{
    Q_OBJECT
public:
    /// Shows the page with that key; null if it cannot be shown.
    using ShowPage = std::function<Page *(const QString &key)>;
    EditGuide(Workspace &workspace, ShowPage showPage, QObject *parent);

    /// Leads to the first text that is no value, and says which one it is. False: there is none.
    bool showRefused();
    /// Leads to the first value or text that cannot be written beside the others, and says why. False: there
    /// is none.
    bool showContradiction();

private:
    void show(const EditPlace &place);
    void showData(const EditPlace &place);
    void withdrawWhatIsMended();

    Workspace &m_workspace;
    ShowPage m_showPage;
    std::optional<QString> m_told;  // text that is no value
    std::pair<QString, int> m_toldOf;  // parameter and profile
};
