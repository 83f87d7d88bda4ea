// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/memoryplaces.h"

#include "protocol/simplebgc/parametertables.h"
#include "protocol/simplebgc/payloads.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr int kStateBytes = 2;  // at the end of PARAMS_3: sensor and profile in use (errata 3.4)

// -1: nowhere, or in more than one place. Bytes that are all the same stand for nothing.
qsizetype findOnce(const QByteArray &memory, const QByteArray &bytes)
{
    if (bytes.isEmpty() || bytes.count(bytes.front()) == bytes.size())
        return -1;
    const qsizetype at = memory.indexOf(bytes);
    return at >= 0 && memory.indexOf(bytes, at + 1) < 0 ? at : -1;
}

// The slots stand in every profile of a configuration, and once in a board.
bool isWanted(BlockKey key)
{
    return key.block != AdjVarsCfg || key.profile == 0;
}

QString nameOf(BlockKey key, const QString &parameter)
{
    return key.block == AdjVarsCfg ? parameter : u"profile %1: %2"_s.arg(key.profile + 1).arg(parameter);
}

}  // namespace

std::vector<MemoryPlace> findPlaces(const QByteArray &memory, const Configuration &board)
{
    std::vector<MemoryPlace> places;
    for (const auto &[key, bytes] : board.blocks()) {
        if (!isWanted(key))
            continue;
        // A block begins with the number of its profile, which the memory need not hold.
        const QByteArray kept = bytes.chopped(key.block == Params3 ? kStateBytes : 0);
        qsizetype at = findOnce(memory, kept);
        if (at < 0 && key.block != AdjVarsCfg)
            at = findOnce(memory, kept.mid(1)) - 1;
        if (at >= 0)
            places.push_back({key, at, kept.size()});
    }
    const QByteArray names = encodeProfileNames(board.profileNames());
    if (const qsizetype at = findOnce(memory, names); at >= 0)
        places.push_back({{0, MemoryPlace::kNames}, at, names.size()});
    return places;
}

int placesWanted(const Configuration &board)
{
    const auto &blocks = board.blocks();
    return 1 + int(std::count_if(blocks.begin(), blocks.end(), [](const auto &each) {
               return isWanted(each.first);
           }));
}

std::vector<std::pair<QString, QString>> explainDifferences(QByteArray &file, const QByteArray &memory,
                                                            const std::vector<MemoryPlace> &places,
                                                            const Configuration &board)
{
    std::vector<std::pair<QString, QString>> changes;
    for (const MemoryPlace &place : places) {
        QByteArray from = file.mid(place.at, place.size);
        const QByteArray to = memory.mid(place.at, place.size);
        if (place.key.block == MemoryPlace::kNames) {
            const auto before = decodeProfileNames(asBytes(from));
            const auto after = decodeProfileNames(asBytes(to));
            for (int profile = 0; before && after && from != to && profile < kProfileCount; ++profile) {
                if ((*before)[profile] != (*after)[profile])
                    changes.emplace_back(u"profile %1: name"_s.arg(profile + 1),
                                         (*before)[profile] + u" -> "_s + (*after)[profile]);
            }
            if (before && after)
                from = to;
        }
        for (const ParameterSpec &spec : board.parameters().all()) {
            if (spec.row->block != place.key.block || spec.row->state)
                continue;
            const auto before = spec.read(from);
            const auto after = spec.read(to);
            if (!before || !after || sameValue(*before, *after))
                continue;
            changes.emplace_back(nameOf(place.key, spec.key),
                                 spec.format(*before) + u" -> "_s + spec.format(*after));
            spec.copy(from, to);
        }
        file.replace(place.at, place.size, from);
    }
    return changes;
}

}  // namespace simplebgc
