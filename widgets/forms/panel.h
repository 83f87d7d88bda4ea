// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <QWidget>

class Panel;
class QDialog;

/// Where a window shows its dialogs: over its content, while everything outside of this area stays in reach.
/// A dialog with a window of its own would block the whole window, the button that switches the motors off
/// included.
class PanelArea final : public QWidget
{
    Q_OBJECT
public:
    /// @param content lies beneath the panels; disabled while one is open
    explicit PanelArea(QWidget *content, QWidget *parent = nullptr);
    ~PanelArea() override;

    /// Opens a dialog over the content. It keeps its signals, its keys (Return, Esc) and, as far as there is
    /// room, its size, and is destroyed when it is closed.
    void open(QDialog &dialog);
    [[nodiscard]] bool isOpen() const { return !m_panels.isEmpty(); }
    /// Rejects all that is open, the newest first.
    void rejectAll();
    /// The dialog that was opened last; null if none is open.
    [[nodiscard]] QDialog *newest() const;

signals:
    void openChanged(bool open);

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    void close(Panel *panel);
    void update(bool wasOpen);

    QWidget *m_content;
    QList<Panel *> m_panels;
};

/// Opens a dialog in the area of the window that it belongs to, or as a window where that has none.
void openPanel(QDialog &dialog);
