// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/transport/portlist.h"

#include <QSerialPortInfo>

#include <algorithm>

using namespace Qt::StringLiterals;

QString PortInfo::label() const
{
    QString text = path;
    if (!description.isEmpty())
        text += u" – "_s + description;
    if (vendorId)
        text += u" – "_s
            + u"%1:%2"_s.arg(vendorId, 4, 16, QChar(u'0')).arg(productId, 4, 16, QChar(u'0')).toUpper();
    return text;
}

QList<PortInfo> listSerialPorts()
{
    QList<PortInfo> ports;
    for (const QSerialPortInfo &info : QSerialPortInfo::availablePorts()) {
        ports.append({info.systemLocation(), info.description(),
                      info.hasVendorIdentifier() ? info.vendorIdentifier() : quint16(0),
                      info.hasProductIdentifier() ? info.productIdentifier() : quint16(0)});
    }
    std::stable_sort(ports.begin(), ports.end(), [](const PortInfo &a, const PortInfo &b) {
        return (a.vendorId != 0) > (b.vendorId != 0);
    });
    return ports;
}
