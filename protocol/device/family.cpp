// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/device/family.h"

#include <algorithm>

namespace {

bool isMadeUp(LinkAddress::Kind kind)
{
    return kind == LinkAddress::Kind::Simulator || kind == LinkAddress::Kind::Replay;
}

}  // namespace

bool Family::livesOn(LinkAddress::Kind kind) const
{
    return isMadeUp(kind) || std::any_of(links.begin(), links.end(), [kind](const FamilyLink &link) {
               return link.kind == kind;
           });
}

bool Family::mayAskAnybody(LinkAddress::Kind kind) const
{
    return isMadeUp(kind) || std::any_of(links.begin(), links.end(), [kind](const FamilyLink &link) {
               return link.kind == kind && link.mayAskAnybody;
           });
}

double fullRate(const QList<Family> &families)
{
    double rate = 0;
    for (const Family &family : families)
        rate = std::max(rate, family.fullRate);
    return rate;
}
