// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/record/recording.h"

#include "protocol/base/bytes.h"

#include <QCryptographicHash>
#include <QJsonDocument>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

constexpr QByteArrayView kMagic = "GIMBALREC 1\n";
constexpr QByteArrayView kChunkMark = "GDCK";
constexpr qsizetype kChunkHeader = 20;
constexpr qsizetype kChecksum = 8;
constexpr qsizetype kPieceHeader = 13;
constexpr quint32 kLongestChunk = 16U << 20;
constexpr qsizetype kChunkSize = 64 << 10;
constexpr qsizetype kLongestDescription = 64 << 10;

enum ChunkKind : quint8 { DescriptionChunk = 1, PiecesChunk = 2 };

// Mark, kind and length of a chunk: the checksum covers them too.
QByteArray chunkHead(quint8 kind, qsizetype length)
{
    return kChunkMark.toByteArray() + ByteWriter().u8(kind).zeros(3).u32(quint32(length)).take();
}

QByteArray checksum(QByteArrayView head, QByteArrayView content)
{
    QCryptographicHash hash(QCryptographicHash::Sha1);
    hash.addData(head.toByteArray());
    hash.addData(content.toByteArray());
    return hash.result().left(kChecksum);
}

quint64 readLittleEndian(QByteArrayView bytes)
{
    quint64 value = 0;
    for (qsizetype i = bytes.size() - 1; i >= 0; --i)
        value = value << 8 | quint8(bytes[i]);
    return value;
}

// False when the content is not what a chunk with a valid checksum must hold: another program wrote it.
bool readPieces(QByteArrayView content, std::vector<RecordedPiece> &pieces)
{
    while (!content.isEmpty()) {
        if (content.size() < kPieceHeader)
            return false;
        const auto kind = quint8(content[0]);
        const auto length = qsizetype(readLittleEndian(content.sliced(1, 4)));
        const auto at = qint64(readLittleEndian(content.sliced(5, 8)));
        if (kind < quint8(RecordedPiece::Kind::Received) || kind > quint8(RecordedPiece::Kind::Reply)
            || length > content.size() - kPieceHeader)
            return false;
        pieces.push_back({RecordedPiece::Kind(kind), at, content.sliced(kPieceHeader, length).toByteArray()});
        content = content.sliced(kPieceHeader + length);
    }
    return true;
}

}  // namespace

qint64 Recording::begin() const
{
    const auto first = std::find_if(pieces.begin(), pieces.end(), [](const RecordedPiece &piece) {
        return piece.kind == RecordedPiece::Kind::Received;
    });
    return first == pieces.end() ? 0 : first->at;
}

qint64 Recording::end() const
{
    const auto last = std::find_if(pieces.rbegin(), pieces.rend(), [](const RecordedPiece &piece) {
        return piece.kind == RecordedPiece::Kind::Received;
    });
    return last == pieces.rend() ? 0 : last->at;
}

Result<Recording> Recording::load(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return failure(ErrorCode::BadFile, u"%1: %2"_s.arg(path, file.errorString()));
    auto recording = fromBytes(file.readAll());
    if (!recording)
        return failure(ErrorCode::BadFile, u"%1: %2"_s.arg(path, recording.error().detail));
    return recording;
}

Result<QJsonObject> Recording::describe(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return failure(ErrorCode::BadFile, u"%1: %2"_s.arg(path, file.errorString()));
    const auto beginning = fromBytes(file.read(kMagic.size() + kLongestDescription));
    return beginning ? Result<QJsonObject>(beginning->description) : tl::unexpected(beginning.error());
}

Result<Recording> Recording::fromBytes(const QByteArray &bytes)
{
    if (!bytes.startsWith(kMagic))
        return failure(ErrorCode::BadFile, u"this is not a recording"_s);
    Recording recording;
    bool described = false;
    QByteArrayView rest = QByteArrayView(bytes).sliced(kMagic.size());
    while (!rest.isEmpty() && recording.damage.isEmpty()) {
        recording.damageAt = bytes.size() - rest.size();
        if (rest.size() < kChunkHeader) {
            recording.damage = u"the file ends within a chunk"_s;
            break;
        }
        const auto kind = quint8(rest[4]);
        const auto length = quint32(readLittleEndian(rest.sliced(8, 4)));
        if (!rest.startsWith(kChunkMark) || length > kLongestChunk) {
            recording.damage = u"no chunk begins here"_s;
        } else if (qsizetype(length) > rest.size() - kChunkHeader) {
            recording.damage = u"the file ends within a chunk"_s;
        } else {
            const QByteArrayView content = rest.sliced(kChunkHeader, length);
            if (checksum(rest.first(12), content) != rest.sliced(12, kChecksum)) {
                recording.damage = u"a checksum is wrong"_s;
            } else if (kind == DescriptionChunk) {
                const auto document = QJsonDocument::fromJson(content.toByteArray());
                described = document.isObject();
                recording.description = document.object();
                if (!described)
                    recording.damage = u"the description is not JSON"_s;
            } else if (kind == PiecesChunk && !readPieces(content, recording.pieces)) {
                recording.damage = u"a chunk holds something else than pieces"_s;
            }  // other kinds belong to a later version and are ignored
            rest = rest.sliced(kChunkHeader + length);
        }
    }
    if (!described)
        return failure(ErrorCode::BadFile, u"the recording is damaged at its very beginning"_s);
    if (recording.damage.isEmpty())
        recording.damageAt = 0;
    return recording;
}

Result<RecordingWriter> RecordingWriter::create(const QString &path, const QJsonObject &description)
{
    auto file = std::make_unique<QFile>(path);
    if (!file->open(QIODevice::WriteOnly | QIODevice::Truncate | QIODevice::Unbuffered))
        return failure(ErrorCode::BadFile, u"%1: %2"_s.arg(path, file->errorString()));
    RecordingWriter writer(std::move(file));
    if (writer.m_file->write(kMagic.data(), kMagic.size()) != kMagic.size())
        return failure(ErrorCode::BadFile, u"%1: %2"_s.arg(path, writer.m_file->errorString()));
    writer.m_end = kMagic.size();
    if (const auto written = writer.writeChunk(DescriptionChunk, QJsonDocument(description).toJson());
        !written)
        return tl::unexpected(written.error());
    return writer;
}

Result<void> RecordingWriter::append(const RecordedPiece &piece)
{
    if (m_waiting.size() + kPieceHeader + piece.bytes.size() > qsizetype(kLongestChunk)) {
        if (const auto flushed = flush(); !flushed)
            return flushed;
    }
    const auto at = quint64(piece.at);
    m_waiting += ByteWriter()
                     .u8(quint8(piece.kind))
                     .u32(quint32(piece.bytes.size()))
                     .u32(quint32(at))
                     .u32(quint32(at >> 32))
                     .take();
    m_waiting += piece.bytes;
    return m_waiting.size() >= kChunkSize ? flush() : Result<void>();
}

Result<void> RecordingWriter::flush()
{
    if (m_waiting.isEmpty())
        return {};
    return writeChunk(PiecesChunk, std::exchange(m_waiting, {}));
}

Result<void> RecordingWriter::writeChunk(quint8 kind, const QByteArray &content)
{
    if (!m_file)
        return failure(ErrorCode::BadFile, u"the recording has ended"_s);
    const QByteArray head = chunkHead(kind, content.size());
    const QByteArray chunk = head + checksum(head, content) + content;
    if (m_file->write(chunk) == chunk.size()) {
        m_end += chunk.size();
        return {};
    }
    const Error error{ErrorCode::BadFile, u"%1: %2"_s.arg(m_file->fileName(), m_file->errorString()), 0};
    m_file->resize(m_end);  // remove an incomplete chunk
    m_file.reset();
    return tl::unexpected(error);
}
