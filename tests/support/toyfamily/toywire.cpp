// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/toyfamily/toywire.h"

#include "protocol/base/checksum.h"

#include <QIODevice>
#include <QtEndian>

namespace toy {
namespace {

constexpr qsizetype kHeader = 5;
constexpr qsizetype kChecksum = 2;

}  // namespace

QByteArray encode(int id, const QByteArray &payload)
{
    QByteArray frame = "TY" + pack([&](QDataStream &out) { out << quint8(id) << quint16(payload.size()); });
    frame += payload;
    return frame + pack([&](QDataStream &out) { out << crc16Arc(asBytes(frame)); });
}

QByteArray pack(const std::function<void(QDataStream &)> &fields)
{
    QByteArray bytes;
    QDataStream out(&bytes, QIODevice::WriteOnly);
    out.setFloatingPointPrecision(QDataStream::SinglePrecision);
    fields(out);
    return bytes;
}

bool unpack(const QByteArray &payload, const std::function<void(QDataStream &)> &fields)
{
    QDataStream in(payload);
    in.setFloatingPointPrecision(QDataStream::SinglePrecision);
    fields(in);
    return in.status() == QDataStream::Ok;
}

Request request(Command command, const QByteArray &payload)
{
    Request request;
    request.name = QStringLiteral("TOY %1").arg(int(command));
    request.bytes = encode(command, payload);
    request.kind = int(command);
    request.retries = 2;
    request.idempotent = true;
    request.timeout = milliseconds(200);
    request.answer = [wanted = answerTo(command)](const FrameView &frame) -> std::optional<Result<Frame>> {
        return frame.id == wanted ? std::optional<Result<Frame>>(Frame(frame)) : std::nullopt;
    };
    return request;
}

qsizetype ToyFramer::frameAtStart() const
{
    if (!QByteArrayView("TY").startsWith(QByteArrayView(m_buffer).first(qMin(m_buffer.size(), qsizetype(2)))))
        return -1;
    if (m_buffer.size() < kHeader)
        return 0;
    const qsizetype whole = kHeader + qFromBigEndian<quint16>(m_buffer.constData() + 3) + kChecksum;
    if (m_buffer.size() < whole)
        return 0;
    const auto told = qFromBigEndian<quint16>(m_buffer.constData() + whole - kChecksum);
    return crc16Arc(asBytes(QByteArrayView(m_buffer).first(whole - kChecksum))) == told ? whole : -1;
}

void ToyFramer::feed(Bytes bytes, const FrameSink &sink)
{
    m_buffer += toByteArray(bytes);
    while (!m_buffer.isEmpty()) {
        const qsizetype whole = frameAtStart();
        if (whole == 0)
            return;
        if (whole < 0) {
            ++m_statistics.skippedBytes;
            m_buffer.remove(0, 1);
            continue;
        }
        ++m_statistics.frames;
        const QByteArray frame = m_buffer.first(whole);
        m_buffer.remove(0, whole);
        sink({.id = quint8(frame[2]),
              .payload = asBytes(QByteArrayView(frame).sliced(kHeader, whole - kHeader - kChecksum)),
              .raw = asBytes(frame)});
    }
}

void ToyFramer::flush(const FrameSink &)
{
    if (m_buffer.isEmpty())
        return;
    ++m_statistics.bodyErrors;
    m_statistics.skippedBytes += quint64(m_buffer.size());
    m_buffer.clear();
}

}  // namespace toy
