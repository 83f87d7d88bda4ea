// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/models/configurationmodel.h"

#include <QFrame>

class QLabel;

/// What a parameter is: name, key, range, default, effect in one sentence, what the board has now.
class HelpCard final : public QFrame
{
    Q_OBJECT
public:
    explicit HelpCard(ConfigurationModel &configuration, QWidget *parent = nullptr);
    void show(int parameter);
    [[nodiscard]] int parameter() const { return m_parameter; }

private:
    void refresh();

    ConfigurationModel &m_configuration;
    int m_parameter = -1;
    QLabel *m_title;
    QLabel *m_help;
    QLabel *m_facts;
};
