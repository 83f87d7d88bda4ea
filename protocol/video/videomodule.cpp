// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/video/videomodule.h"

#include <QCoreApplication>
#include <QDir>
#include <QLibrary>

using namespace Qt::StringLiterals;

namespace {

// Changes with the interface.
constexpr const char *kEntry = "gimbalVideoCodecs1";

QStringList moduleFolders()
{
    if (const QString chosen = qEnvironmentVariable(kVideoModuleFolder); !chosen.isEmpty())
        return {chosen};
    const QString programs = QCoreApplication::applicationDirPath();
    return {programs + u"/modules"_s,
            QDir::cleanPath(programs + u'/' + QStringLiteral(GIMBAL_MODULES_FROM_PROGRAMS))};
}

}  // namespace

Result<const VideoCodecs *> loadVideoCodecs()
{
    QStringList said;
    for (const QString &folder : moduleFolders()) {
        QLibrary library(folder + u"/libgimbaldesk-video"_s);
        library.setLoadHints(QLibrary::PreventUnloadHint);
        using Entry = const VideoCodecs *(*)();
        if (const auto entry = reinterpret_cast<Entry>(library.resolve(kEntry)))
            return entry();
        said.append(library.errorString());
    }
    return failure(ErrorCode::Unsupported,
                   u"the video module is missing or does not fit this program: %1"_s.arg(said.join(u"; "_s)));
}
