// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Precompiled for tests of models and widgets.
#pragma once

#include "screen.h"
#include "tests.h"

#include <QAbstractItemModelTester>
