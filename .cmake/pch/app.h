// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Precompiled for what stands on app/workspace, our own headers too: they are half of what these folders
// read, and an edit of one of them compiles these folders anew anyhow.
#pragma once

#include "app/workspace/page.h"
#include "app/workspace/question.h"
#include "app/workspace/workspace.h"
#include "protocol/client/whendone.h"
#include "protocol/telemetry/telemetrystore.h"
#include "screen.h"
#include "widgets/forms/numberbox.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"
#include "widgets/views/card.h"
