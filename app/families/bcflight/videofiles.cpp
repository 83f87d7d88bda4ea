// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/bcflight/videofiles.h"

#include "protocol/base/filefault.h"

#include <QBuffer>
#include <QDateTime>
#include <QDir>
#include <QImage>
#include <QImageWriter>
#include <QStandardPaths>

using namespace Qt::StringLiterals;

Result<QString> newVideoFile(const QString &folder, const QString &suffix)
{
    if (!QDir().mkpath(folder))
        return fileFailure({.problem = FileProblem::NotWritable, .path = folder, .writing = true});
    const QDir dir(folder);
    const QString stem = u"drone-"_s + QDateTime::currentDateTime().toString(u"yyyy-MM-dd-HHmmss"_s);
    QString name = u"%1.%2"_s.arg(stem, suffix);
    for (int next = 2; dir.exists(name); ++next)
        name = u"%1-%2.%3"_s.arg(stem).arg(next).arg(suffix);
    return dir.filePath(name);
}

Result<void> saveStill(const VideoPicture &picture, const QString &path)
{
    const QImage image(picture.pixels.data(), picture.width, picture.height, picture.stride(),
                       QImage::Format_RGB32);
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QImageWriter writer(&buffer, "png");
    if (!writer.write(image))
        return fileFailure(
            {.problem = FileProblem::System, .path = path, .writing = true, .said = writer.errorString()});
    return writeWhole(path, buffer.data());
}

QString defaultVideoFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::PicturesLocation);
}
