// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/command.h"

/// Moves an axis a little and reports how it follows.
class MeasureCommand final : public Command
{
    Q_OBJECT
public:
    using Command::Command;

    const char *name() const override { return "measure"; }
    const char *words() const override { return "steps|sweep AXIS [degrees=N] [to=HZ] ..."; }
    QString help() const override;
    const char *example() const override
    {
        return "--link serial:/dev/ttyUSB0 measure steps pitch degrees=2";
    }
    QList<CommandOption> options() override;
    QString check() const override;

    void start(DeviceClient &client) override;
    void stop() override;

private:
    void begin(const MotionTestPlan &plan);
    void onMeasured(const MotionTestResult &result);

    QString m_csv;
    DeviceClient *m_client = nullptr;
    bool m_running = false;
};
