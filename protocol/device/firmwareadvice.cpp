// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/device/firmwareadvice.h"

#include "protocol/device/device.h"

const FirmwareAdvice *firmwareAdvice(const Device *device)
{
    return dynamic_cast<const FirmwareAdvice *>(device);
}
