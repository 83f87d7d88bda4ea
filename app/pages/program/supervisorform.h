// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/supervisor/alarm.h"

#include <QObject>

#include <array>
#include <functional>

class DeviceClient;
class NumberBox;
class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class Settings;

/// The supervisor's part of the settings: for each kind of alarm what is done, and the limits.
class SupervisorForm final : public QObject
{
    Q_OBJECT
public:
    /// Adds a row with a label and its field.
    using AddRow = std::function<void(const QString &label, QWidget *field)>;
    SupervisorForm(Settings &settings, const DeviceClient &client, const AddRow &row, QFormLayout &form,
                   QObject *parent);

private:
    void apply();

    Settings &m_settings;
    std::array<QComboBox *, kAlarmKinds> m_actions{};
    NumberBox *m_runaway;
    NumberBox *m_oscillation;
    NumberBox *m_cell;
    NumberBox *m_hot;
    QCheckBox *m_sound;
    QLabel *m_missing;
};
