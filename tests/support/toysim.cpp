// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/sim.h"
#include "tests/support/toyfamily/toyboard.h"

#include <QCoreApplication>

int main(int argc, char **argv)
{
    QCoreApplication application(argc, argv);
    Sim sim({simulatedToy()});
    QObject::connect(&sim, &Sim::finished, &application, &QCoreApplication::quit);
    if (const auto code = sim.start(application.arguments()))
        return *code;
    return QCoreApplication::exec();
}
