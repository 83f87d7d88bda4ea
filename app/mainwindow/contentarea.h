// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>

/// The window's content, as large as its room, and scrolled where there is less than it needs.
class ContentArea final : public QScrollArea
{
    Q_OBJECT
public:
    /// @param smallest what the content needs
    ContentArea(QWidget &content, const QSize &smallest, QWidget *parent = nullptr);
};
