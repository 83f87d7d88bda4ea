// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/workspace/notifications.h"

#include <QWidget>

#include <optional>

class QLabel;
class QToolButton;

/// What stands before a message. @param kind nothing for a problem
[[nodiscard]] QString messageSign(std::optional<Notice> kind);

/// One message: the text, details folded, buttons to copy and to close it.
class MessageRow final : public QWidget
{
    Q_OBJECT
public:
    /// @param kind nothing for a problem; @param circumstances copied along with it
    MessageRow(const ErrorText &text, std::optional<Notice> kind, const QString &circumstances,
               QWidget *parent = nullptr);

    void setText(const ErrorText &text);

signals:
    void closed();

private:
    QLabel *m_text;
    QLabel *m_detail;
    QToolButton *m_more;
    QToolButton *m_copy;
    QToolButton *m_close;
    std::optional<Notice> m_kind;
    QString m_circumstances;
    QString m_full;
};
