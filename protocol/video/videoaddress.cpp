// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/video/videoaddress.h"

#include <QRegularExpression>

using namespace Qt::StringLiterals;

Result<VideoAddress> VideoAddress::parse(const QString &text, const VideoAddress &usual)
{
    static const QRegularExpression form(u"^(?:\\[([0-9A-Fa-f:.]+)\\]|([^\\s:/\\[\\]]*))(?::(\\d{1,5}))?$"_s);
    const auto match = form.match(text.trimmed());
    if (!match.hasMatch())
        return failure(ErrorCode::InvalidArgument, u"an address of video is HOST:PORT, not '%1'"_s.arg(text));
    VideoAddress address = usual;
    if (const QString host = match.captured(1) + match.captured(2); !host.isEmpty())
        address.host = host;
    if (const QString port = match.captured(3); !port.isEmpty()) {
        const int number = port.toInt();
        if (number < 1 || number > 65535)
            return failure(ErrorCode::InvalidArgument, u"a port is 1 to 65535, not %1"_s.arg(port));
        address.port = quint16(number);
    }
    if (address.host.isEmpty())
        return failure(ErrorCode::InvalidArgument, u"the host of the video is missing"_s);
    return address;
}

QString VideoAddress::toString() const
{
    return (host.contains(u':') ? u"[%1]:%2"_s : u"%1:%2"_s).arg(host).arg(port);
}
