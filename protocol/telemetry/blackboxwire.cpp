// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/telemetry/blackboxwire.h"

namespace blackboxwire {

QByteArray namesLine(const BlackBox &box)
{
    QByteArrayList parts;
    for (int name = 0; name < int(box.names().size()); ++name)
        parts << box.names()[name] << QByteArray::number(box.elements(name));
    return '#' + parts.join('\t') + '\n';
}

std::optional<std::vector<Name>> readNames(QByteArrayView line)
{
    if (!line.startsWith('#'))
        return {};
    const QByteArrayList parts = line.sliced(1).toByteArray().split('\t');
    if (parts.size() % 2 != 0 || parts.size() > 2 * BlackBox::kMostNames)
        return {};
    std::vector<Name> names;
    for (qsizetype i = 0; i < parts.size(); i += 2) {
        bool ok = false;
        const int elements = parts[i + 1].toInt(&ok);
        if (!ok || elements < 0 || elements > BlackBox::kMostNumbers || parts[i].isEmpty())
            return {};
        names.push_back({parts[i], elements});
    }
    return names;
}

}  // namespace blackboxwire
