// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/models/configurationmodel.h"

#include <QUndoStack>

/// Edits of the configuration that can be undone, over all pages and profiles.
class EditStack final : public QObject
{
    Q_OBJECT
public:
    explicit EditStack(ConfigurationModel &configuration, QObject *parent = nullptr);

    /// Changes a value; steps on the same value within one second become one edit. Out of range: refused, false.
    bool edit(int parameter, int profile, int raw);
    void rename(int profile, const QString &name);
    /// Takes back all edits, as one step that can itself be undone.
    void discardAll();
    [[nodiscard]] QUndoStack &undoStack() { return m_stack; }

private:
    ConfigurationModel &m_configuration;
    QUndoStack m_stack;
};
