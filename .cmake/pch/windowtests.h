// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Precompiled for tests of the whole window; see app.h about our own headers.
#pragma once

#include "app.h"
#include "app/mainwindow/bars.h"
#include "app/mainwindow/linkbar.h"
#include "app/mainwindow/messagebar.h"
#include "tests.h"
#include "tests/support/named.h"
#include "tests/support/windowrig.h"

#include <QTableWidget>
