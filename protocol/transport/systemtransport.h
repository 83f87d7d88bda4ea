// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/transport/transport.h"

/// Serial ports, TCP and UDP. Errors: InvalidArgument for any other kind.
Result<std::unique_ptr<Transport>> makeSystemTransport(const LinkAddress &address);
