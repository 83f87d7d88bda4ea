// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What is known of the board's firmware, and what another would change here: from the tables alone.
#include "protocol/simplebgc/firmware.h"

#include "protocol/simplebgc/actiontable.h"
#include "protocol/simplebgc/adjustables.h"
#include "protocol/simplebgc/device.h"
#include "protocol/simplebgc/messages.h"
#include "protocol/simplebgc/parametertables.h"
#include "protocol/simplebgc/payloads.h"
#include "protocol/simplebgc/steeringmodes.h"
#include "protocol/simplebgc/telemetrytables.h"

#include <algorithm>
#include <set>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

/// What the document and the errata say against some firmware, as far as this program is concerned. They name
/// no version as faulty.
struct FirmwareLimit
{
    int until = 0;  ///< the last one
    const char *text = "";
};
// clang-format off
constexpr FirmwareLimit kFirmwareLimits[] = {
    {2409, "On a serial line it needs even parity."},  // document "Message format"
    {2554, "It steers all axes in one mode: none can be left as it is."},  // errata 3.12
    {2589, "It streams no live data: they are asked for one by one, and come more slowly."},  // errata 3.10
};
// clang-format on

constexpr const char *kNewer
    = "This firmware is newer than any that this program knows: everything is shown, and nothing is written.";
constexpr const char *kOlder
    = "This firmware is older than any that this program knows: everything is shown, and nothing is written.";
constexpr const char *kKnown = "This program knows this firmware. No fault of it is documented.";
constexpr const char *kSpecial = "It is a special build, which may lack things or do them in another way.";

/// What a firmware has of everything that this program uses.
struct Offer
{
    QStringList actions;
    QStringList parameters;
    QStringList variables;
    QStringList modes;
    QStringList streams;
    QStringList channels;
    QStringList commands;
};

Offer offerOf(BoardIdentity identity, int firmware)
{
    identity.firmwareNumber = firmware;
    Offer offer;
    for (const ActionSpec &action : availableActions(identity))
        offer.actions.append(QLatin1String(action.key));
    const ParameterSet parameters(parameterRows(), kBlocks, firmware, identity.capabilities);
    for (const ParameterSpec &spec : parameters.all()) {
        if (kBlocks[spec.row->block].since <= firmware)
            offer.parameters.append(spec.key);
    }
    for (const AdjustableSpec &variable : adjustablesOf(firmware))
        offer.variables.append(QLatin1String(variable.key));
    for (const SteeringMode &mode : steeringModes(firmware))
        offer.modes.append(QLatin1String(mode.key));
    if (firmware >= findMessage(number(CommandId::DataStreamInterval))->since)
        offer.streams = Device::streamKeys();
    for (const ChannelSpec &channel : channelTable(firmware))
        offer.channels.append(QLatin1String(channel.key));
    for (const MessageSpec &message : messages()) {
        if (message.isPublic && message.since <= firmware)
            offer.commands.append(QLatin1String(message.name));
    }
    return offer;
}

QStringList added(const QStringList &before, const QStringList &after)
{
    const QSet<QString> known(before.begin(), before.end());
    QStringList added;
    for (const QString &key : after) {
        if (!known.contains(key))
            added.append(key);
    }
    return added;
}

// Where any of the tables begins or ends something.
std::set<int> boundaries()
{
    std::set<int> all;
    for (const ParameterRow &row : parameterRows()) {
        all.insert(row.since);
        all.insert(row.until + 1);
    }
    for (const BlockSpec &block : kBlocks)
        all.insert(block.since);
    for (const MessageSpec &message : messages())
        all.insert(message.since);
    BoardIdentity newest;
    newest.firmwareNumber = Device::kNewestFirmware;
    for (const ActionSpec &action : availableActions(newest))
        all.insert(action.since);
    for (const AdjustableSpec &variable : adjustablesOf(Device::kNewestFirmware))
        all.insert(variable.since);
    all.insert(kLaterCustomFirmware);
    for (int firmware = Device::kOldestFirmware; firmware <= Device::kNewestFirmware; ++firmware) {
        if (steeringModes(firmware).size() != steeringModes(firmware - 1).size())
            all.insert(firmware);
    }
    return all;
}

// "Later" of the errata, and what the tables assume themselves.
bool isAssumed(int firmware)
{
    return firmware == kLater
        || std::any_of(std::begin(kBlocks), std::end(kBlocks),
                       [firmware](const BlockSpec &block) { return block.since == firmware; });
}

QString versionText(int firmware)
{
    BoardInfo info;
    info.firmware = firmware;
    return info.firmwareText();
}

}  // namespace

std::vector<const char *> firmwareTexts()
{
    std::vector<const char *> texts{kNewer, kOlder, kKnown, kSpecial};
    for (const FirmwareLimit &limit : kFirmwareLimits)
        texts.push_back(limit.text);
    return texts;
}

std::vector<FirmwareRemark> Device::firmwareRemarks() const
{
    const int firmware = m_identity.firmwareNumber;
    std::vector<FirmwareRemark> remarks;
    const bool isKnown = firmware >= kOldestFirmware && firmware <= kNewestFirmware;
    remarks.push_back({isKnown ? kKnown : firmware > kNewestFirmware ? kNewer : kOlder, !isKnown});
    if (m_identity.extra.contains(kSpecialBuild))
        remarks.push_back({kSpecial, true});
    for (const FirmwareLimit &limit : kFirmwareLimits) {
        if (firmware <= limit.until)
            remarks.push_back({limit.text});
    }
    return remarks;
}

std::vector<FirmwareStep> Device::firmwareSteps() const
{
    std::vector<FirmwareStep> steps;
    Offer before = offerOf(m_identity, m_identity.firmwareNumber);
    for (const int firmware : boundaries()) {
        if (firmware <= m_identity.firmwareNumber || firmware > kNewestFirmware)
            continue;
        Offer now = offerOf(m_identity, firmware);
        FirmwareStep step{.firmware = versionText(firmware),
                          .isAbout = isAssumed(firmware),
                          .actions = added(before.actions, now.actions),
                          .parameters = added(before.parameters, now.parameters),
                          .variables = added(before.variables, now.variables),
                          .modes = added(before.modes, now.modes),
                          .streams = added(before.streams, now.streams),
                          .channels = added(before.channels, now.channels),
                          .commands = added(before.commands, now.commands),
                          .gone = added(now.parameters, before.parameters)};
        if (!step.isEmpty())
            steps.push_back(std::move(step));
        before = std::move(now);
    }
    return steps;
}

}  // namespace simplebgc
