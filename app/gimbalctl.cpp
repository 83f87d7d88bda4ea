// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/ctl.h"
#include "app/composition/composition.h"

#include <QCoreApplication>

int main(int argc, char **argv)
{
    QCoreApplication application(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("gimbalctl"));
    Ctl ctl(allFamilies() + recordedFamilies(), allLinks());
    QObject::connect(
        &ctl, &Ctl::finished, &application, [](int code) { QCoreApplication::exit(code); },
        Qt::QueuedConnection);
    if (const auto code = ctl.start(application.arguments()))
        return *code;
    return QCoreApplication::exec();
}
