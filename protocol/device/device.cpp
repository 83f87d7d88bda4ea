// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/device/device.h"

using namespace Qt::StringLiterals;

// Where both directions have the same frames.
FrameText Device::describeSent(QByteArrayView bytes) const
{
    QStringList names;
    QStringList fields;
    const FrameSink sink = [&](const FrameView &frame) {
        const FrameText one = describeFrame(frame, false);
        names.append(one.name);
        fields.append(one.fields);
    };
    const auto framer = makeFramer();
    framer->feed(asBytes(bytes), sink);
    framer->flush(sink);
    return {names.join(u" + "_s), fields.join(u" + "_s)};
}
