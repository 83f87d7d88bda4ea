// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/configuration/identity.h"

#include <QByteArrayView>

namespace storm32 {

/// Takes name, type and what they say of the board from the answer to `v` (54 bytes, errata 3). The board has
/// no serial number: its name and type must do.
void describeLook(BoardIdentity &identity, QByteArrayView version);

}  // namespace storm32
