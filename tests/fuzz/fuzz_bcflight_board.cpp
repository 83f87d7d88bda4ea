// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/simulator/bcflight/board.h"

#include <algorithm>

// Packets of any bytes, of any generation, whatever state the simulated drone is in.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    if (size < 2)
        return 0;
    SimulatorOptions options;
    options.own.insert(QLatin1String(bcflight::SimulatedBoard::kGeneration), 1 + data[0] % 7);
    options.own.insert(QLatin1String(bcflight::SimulatedBoard::kTransmitter), data[1] & 1);
    options.own.insert(QLatin1String(bcflight::SimulatedBoard::kCamera), data[1] >> 1 & 1);
    bcflight::SimulatedBoard drone(options);
    const QByteArray ping("\x81\0\0\0\0", 5);
    drone.receive(asBytes(ping));
    for (int i = 0; i < 20; ++i)
        drone.cycle();
    const Bytes bytes(reinterpret_cast<const std::byte *>(data + 2), size - 2);
    for (std::size_t at = 0; at < bytes.size();) {
        const std::size_t length
            = std::min<std::size_t>(1 + std::to_integer<std::size_t>(bytes[at]) % 64, bytes.size() - at);
        drone.receive(bytes.subspan(at, length));
        for (int i = 0; i < 5; ++i)
            drone.cycle();
        while (!drone.takeOutput(65535).isEmpty()) { }
        at += length;
    }
    return 0;
}
