// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/abilities.h"
#include "protocol/session/linkstatistics.h"
#include "protocol/telemetry/streams.h"
#include "protocol/telemetry/telemetrystore.h"
#include "tests/support/patience.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/reviewdialog.h"

#include <QSignalSpy>

/// A test with the window on a simulated STorM32 board.
class StormWindowTest : public QObject
{
protected:
    bool openStorm(const QString &options = {})
    {
        return m_rig->open(QStringLiteral("sim:storm32") + options) && ready();
    }
    bool ready()
    {
        return QTest::qWaitFor([this] { return m_rig->workspace().motorsRunning().has_value(); }, kPatience);
    }
    Workspace &workspace() { return m_rig->workspace(); }
    /// A word as the board uses it now, asked past all models.
    int inUse(int word)
    {
        std::optional<int> value;
        m_rig->client()
            .submit<std::vector<AdjustableValue>>([word](Channel &channel, Device &device) {
                return device.live()->readAdjustables(channel, {word});
            })
            .then(this, [&value](const Result<std::vector<AdjustableValue>> &read) {
                value = read ? int(read->front().value) : -1;
            });
        return QTest::qWaitFor([&value] { return value.has_value(); }, kPatience) ? *value : -1;
    }
    bool writeAll()
    {
        QSignalSpy finished(&workspace(), &Workspace::writeFinished);
        m_rig->window().review();
        if (!QTest::qWaitFor([this] { return m_rig->window().reviewDialog() != nullptr; }, kPatience))
            return false;
        m_rig->window().reviewDialog()->accept();
        return QTest::qWaitFor([&finished] { return finished.count() == 1; }, kPatience)
            && workspace().lastReport()->isComplete();
    }

    std::unique_ptr<WindowRig> m_rig;
};
