// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The process that stops what flies when the program that steers it has died.
#include "protocol/transport/flightguard.h"

#include <QCoreApplication>

int main(int argc, char **argv)
{
    const QCoreApplication application(argc, argv);
    return FlightGuard::run(QCoreApplication::arguments().mid(1));
}
