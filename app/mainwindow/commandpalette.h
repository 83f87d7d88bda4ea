// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include <functional>

class QLineEdit;
class QListWidget;

/// Something that can be shown or done from the palette.
struct PaletteEntry
{
    QString kind;  ///< "Page", "Parameter", "Channel", "Action"
    QString text;
    QString hint;  ///< key, shown in a lighter tone
    QString search;  ///< lower-case text to look in
    std::function<void()> chosen;
};

/// Ctrl+K: finds any page, parameter, channel and action by its words.
class CommandPalette final : public QDialog
{
    Q_OBJECT
public:
    CommandPalette(QList<PaletteEntry> entries, QWidget *parent = nullptr);

    [[nodiscard]] QLineEdit *input() const { return m_input; }
    [[nodiscard]] QListWidget *list() const { return m_list; }

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void refilter();
    void choose();

    QList<PaletteEntry> m_entries;
    QLineEdit *m_input;
    QListWidget *m_list;
};
