// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/actionspec.h"

#include <QWidget>

/// Fields for the arguments of an action, made from their declarations.
class ArgumentForm final : public QWidget
{
    Q_OBJECT
public:
    /// @param hidden arguments that the caller supplies
    explicit ArgumentForm(const ActionSpec &action, const QStringList &hidden = {},
                          QWidget *parent = nullptr);

    /// What was entered, checked. Errors: InvalidArgument naming the argument.
    [[nodiscard]] Result<QVariantMap> arguments() const;
    [[nodiscard]] QWidget *field(const QString &key) const { return m_fields.value(key); }
    /// Replaces a field's text, as typed.
    void setText(const QString &key, const QString &text);

private:
    [[nodiscard]] QWidget *makeField(const ArgumentSpec &argument);

    ActionSpec m_action;
    QMap<QString, QWidget *> m_fields;
};
