// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/link/simulatorsetup.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

Result<void> readSeed(SimulatorSetup &setup, const QString &text)
{
    const auto seed = wholeNumber(u"seed"_s, text, 0, 1'000'000'000);
    if (!seed)
        return tl::unexpected(seed.error());
    setup.options.seed = unsigned(*seed);
    return {};
}

Result<void> readRate(SimulatorSetup &setup, const QString &text)
{
    const auto baud = wholeNumber(u"rate"_s, text, 1200, 4'000'000);
    if (!baud)
        return tl::unexpected(baud.error());
    setup.rate = *baud;
    setup.options.usb = false;
    return {};
}

}  // namespace

Result<SimulatedFamily> findSimulatedFamily(const QList<SimulatedFamily> &families, const QString &key)
{
    QStringList keys;
    for (const SimulatedFamily &family : families) {
        if (family.key == key)
            return family;
        keys.append(family.key);
    }
    return failure(
        ErrorCode::InvalidArgument,
        u"there is no simulated board of the family '%1'; there are: %2"_s.arg(key, keys.join(u", "_s)));
}

QList<SimulatedOption> simulatedOptions(const SimulatedFamily &family)
{
    const auto readFirmware
        = [parse = family.firmware.parse](SimulatorSetup &setup, const QString &text) -> Result<void> {
        const auto firmware = parse(text);
        if (!firmware)
            return tl::unexpected(firmware.error());
        setup.options.firmware = *firmware;
        return {};
    };
    QList<SimulatedOption> options{
        {u"seed"_s, u"N"_s, {u"another gimbal: noise, bias, hand; same seed, same behaviour"_s}, readSeed},
        {u"firmware"_s, u"V"_s, {family.firmware.help}, readFirmware}};
    if (family.links.contains(LinkAddress::Kind::Serial)) {
        options.append({u"rate"_s,
                        u"BAUD"_s,
                        {u"behave like a UART of that rate; without it, like native USB (not throttled)"_s},
                        readRate});
    }
    return options + family.options;
}

Result<SimulatorSetup> parseSimulatorSetup(const SimulatedFamily &family,
                                           const QMap<QString, QString> &options, const QStringList &faults)
{
    SimulatorSetup setup;
    const QList<SimulatedOption> known = simulatedOptions(family);
    for (auto it = options.begin(); it != options.end(); ++it) {
        if (it.key() == u"fault"_s)
            continue;
        const auto option = std::find_if(
            known.begin(), known.end(), [&it](const SimulatedOption &each) { return each.name == it.key(); });
        if (option == known.end()) {
            QStringList names;
            for (const SimulatedOption &each : known)
                names.append(each.name);
            return failure(
                ErrorCode::InvalidArgument,
                u"there is no option '%1'; there are: %2, fault"_s.arg(it.key(), names.join(u", "_s)));
        }
        if (const auto read = option->read(setup, it.value()); !read)
            return tl::unexpected(read.error());
    }
    for (const QString &fault : faults) {
        if (const auto set = setup.options.faults.set(fault, family.key); !set)
            return tl::unexpected(set.error());
    }
    return setup;
}
