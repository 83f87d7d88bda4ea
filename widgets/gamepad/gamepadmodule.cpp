// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/gamepad/gamepadmodule.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QPluginLoader>

using namespace Qt::StringLiterals;

// Never unloaded: libraries behind a module keep threads and handlers of the whole process.
Result<std::unique_ptr<GamepadSource>> loadGamepadModule()
{
    const QString name = u"libgimbaldesk-gamepad.so"_s;
    const QDir programs(QCoreApplication::applicationDirPath());
    for (const QString &folder : {u"modules"_s, QStringLiteral(GIMBAL_MODULES_FROM_PROGRAMS)}) {
        const QString path = programs.absoluteFilePath(folder + u'/' + name);
        if (!QFileInfo::exists(path))
            continue;
        QPluginLoader loader(path);
        if (const auto *module = qobject_cast<GamepadModule *>(loader.instance()))
            return module->makeSource();
        return failure(ErrorCode::Unsupported, loader.errorString());
    }
    return failure(ErrorCode::Unsupported, u"there is no %1"_s.arg(name));
}
