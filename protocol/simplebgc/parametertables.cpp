// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simplebgc/parametertables.h"

#include "protocol/simplebgc/choices.h"

namespace simplebgc {

std::span<const ParameterRow> parameterRows()
{
    static const std::vector<ParameterRow> rows = [] {
        std::vector<ParameterRow> all;
        for (const auto part : {params3Rows(), paramsExtRows(), paramsExt2Rows()})
            all.insert(all.end(), part.begin(), part.end());
        return all;
    }();
    return rows;
}

std::span<const Choice> menuActions()
{
    return kMenuActions;
}

std::span<const Choice> signalSources()
{
    return kSignalSources;
}

}  // namespace simplebgc
