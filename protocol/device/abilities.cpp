// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/device/abilities.h"

#include "protocol/session/framer.h"

using namespace Qt::StringLiterals;

FrameText FrameInspector::describeFrames(QByteArrayView bytes, Framer &framer) const
{
    QStringList names;
    QStringList fields;
    const FrameSink sink = [&](const FrameView &frame) {
        const FrameText one = describeFrame(frame, false);
        names.append(one.name);
        fields.append(one.fields);
    };
    framer.feed(asBytes(bytes), sink);
    framer.flush(sink);
    return {names.join(u" + "_s), fields.join(u" + "_s)};
}
