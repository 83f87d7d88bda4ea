// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/transport/linkaddress.h"

#include <QUrl>
#include <QUrlQuery>

using namespace Qt::StringLiterals;

namespace {

constexpr int kUsualUdpPort = 2020;  // of the only family that is reached so (BCFlight errata 2.1)

Result<QMap<QString, QString>> parseOptions(const QString &query)
{
    QMap<QString, QString> options;
    const auto pairs = QUrlQuery(query).queryItems(QUrl::FullyDecoded);
    for (const auto &[name, value] : pairs) {
        if (value.isEmpty())
            return failure(ErrorCode::InvalidArgument, u"the option '%1' has no value"_s.arg(name));
        options.insert(name, value);
    }
    return options;
}

Result<void> checkLineOptions(const QMap<QString, QString> &options)
{
    if (const auto baud = options.find(u"baud"_s); baud != options.end()) {
        bool ok = false;
        const int value = baud->toInt(&ok);
        if (!ok || value < 300 || value > 4'000'000)
            return failure(ErrorCode::InvalidArgument,
                           u"baud=%1 is not a rate between 300 and 4000000"_s.arg(*baud));
    }
    if (const auto parity = options.find(u"parity"_s); parity != options.end()) {
        if (*parity != u"none"_s && *parity != u"even"_s)
            return failure(ErrorCode::InvalidArgument, u"parity=%1 is neither none nor even"_s.arg(*parity));
    }
    return {};
}

}  // namespace

Result<LinkAddress> LinkAddress::parse(const QString &text)
{
    LinkAddress address;
    // The last one: a file's name may have one too.
    const qsizetype mark = text.lastIndexOf(u'?');
    const QString place = mark < 0 ? text : text.left(mark);
    auto options = parseOptions(mark < 0 ? QString() : text.mid(mark + 1));
    if (!options)
        return tl::unexpected(options.error());
    address.m_options = *options;
    if (const auto line = checkLineOptions(*options); !line)
        return tl::unexpected(line.error());

    if (place.startsWith(u"tcp://"_s) || place.startsWith(u"udp://"_s)) {
        address.m_kind = place.startsWith(u't') ? Kind::Tcp : Kind::Udp;
        const QUrl url(place, QUrl::StrictMode);
        const bool mayLackPort = address.m_kind == Kind::Udp && !place.endsWith(u':');
        const int port = url.port(mayLackPort ? kUsualUdpPort : -1);
        if (!url.isValid() || url.host().isEmpty() || port <= 0 || !url.path().isEmpty())
            return failure(ErrorCode::InvalidArgument,
                           u"'%1' is not %2://host:port"_s.arg(place, place.left(3)));
        address.m_target = url.host();
        address.m_port = static_cast<quint16>(port);
        return address;
    }
    if (place.startsWith(u"sim:"_s)) {
        address.m_kind = Kind::Simulator;
        address.m_target = place.mid(4);
    } else if (place.startsWith(u"replay:"_s)) {
        address.m_kind = Kind::Replay;
        address.m_target = place.mid(7);
    } else if (place.startsWith(u"serial:"_s)) {
        address.m_kind = Kind::Serial;
        address.m_target = place.mid(7);
    } else if (place.startsWith(u'/') || place.startsWith(u"COM"_s)) {
        address.m_kind = Kind::Serial;
        address.m_target = place;
    }
    if (address.m_kind == Kind::None || address.m_target.isEmpty()) {
        return failure(
            ErrorCode::InvalidArgument,
            u"'%1' is not an address; use serial:/dev/ttyUSB0, tcp://host:port, udp://host[:port], "
            u"sim:simplebgc or replay:FILE"_s.arg(text));
    }
    return address;
}

LinkAddress LinkAddress::replay(const QString &path)
{
    LinkAddress address;
    address.m_kind = Kind::Replay;
    address.m_target = path;
    return address;
}

LinkAddress LinkAddress::serial(const QString &port, std::optional<int> baud, std::optional<Parity> parity)
{
    LinkAddress address;
    address.m_kind = Kind::Serial;
    address.m_target = port;
    if (baud)
        address.m_options.insert(u"baud"_s, QString::number(*baud));
    if (parity)
        address.m_options.insert(u"parity"_s, *parity == Parity::Even ? u"even"_s : u"none"_s);
    return address;
}

std::optional<int> LinkAddress::baud() const
{
    const auto it = m_options.find(u"baud"_s);
    return it == m_options.end() ? std::nullopt : std::optional(it->toInt());
}

std::optional<Parity> LinkAddress::parity() const
{
    const auto it = m_options.find(u"parity"_s);
    if (it == m_options.end())
        return std::nullopt;
    return *it == u"even"_s ? Parity::Even : Parity::None;
}

QString LinkAddress::toString() const
{
    QString text;
    switch (m_kind) {
    case Kind::None: return {};
    case Kind::Serial: text = u"serial:"_s + m_target; break;
    case Kind::Simulator: text = u"sim:"_s + m_target; break;
    case Kind::Replay: text = u"replay:"_s + m_target; break;
    case Kind::Tcp:
    case Kind::Udp:
        // An IPv6 host needs its brackets back.
        text = u"%1://%2:%3"_s
                   .arg(m_kind == Kind::Tcp ? u"tcp"_s : u"udp"_s,
                        m_target.contains(u':') ? u"[%1]"_s.arg(m_target) : m_target)
                   .arg(m_port);
        break;
    }
    QUrlQuery query;
    for (auto it = m_options.begin(); it != m_options.end(); ++it)
        query.addQueryItem(it.key(), it.value());
    // Options begin at the last question mark, which must not be one of the name's or of an option's value.
    if (query.isEmpty())
        return text.contains(u'?') ? text + u'?' : text;
    return text + u'?' + query.toString().replace(u'?', u"%3F"_s);
}
