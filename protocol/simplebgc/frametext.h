// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/device/abilities.h"
#include "protocol/simplebgc/messages.h"

namespace simplebgc {

/// A frame in readable form: the command's name and the known fields. @param parameters names the values of
/// parameter blocks, may be null
/// @param firmware whose fields they are
[[nodiscard]] FrameText describeFrame(const FrameView &frame, bool fromBoard, const ParameterSet *parameters,
                                      int firmware = kAnyFirmware);

/// "EXECUTE_MENU 0B" or a complete frame in hex. Errors: InvalidArgument with the reason.
[[nodiscard]] Result<RawCommand> parseCommand(const QString &text, int version, int firmware = kAnyFirmware);

/// Commands that can be sent by name.
[[nodiscard]] QStringList commandNames();

}  // namespace simplebgc
