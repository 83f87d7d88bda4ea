// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/record/recording.h"

#include "protocol/base/bytes.h"
#include "protocol/base/filefault.h"
#include "protocol/telemetry/blackbox.h"

#include <QCryptographicHash>
#include <QJsonDocument>
#include <QRegularExpression>

#include <algorithm>
#include <limits>

using namespace Qt::StringLiterals;

namespace {

constexpr QByteArrayView kMagic = "GIMBALREC 1\n";
constexpr QByteArrayView kName = "GIMBALREC ";
constexpr int kRecordingVersion = 1;
constexpr QByteArrayView kChunkMark = "GDCK";
constexpr qsizetype kChunkHeader = 20;
constexpr qsizetype kChecksum = 8;
constexpr qsizetype kPieceHeader = 13;
constexpr quint32 kLongestChunk = 16U << 20;
constexpr qsizetype kChunkSize = 64 << 10;
constexpr qsizetype kLongestDescription = 64 << 10;
constexpr qint64 kSearchBase = 64 << 20;  // bytes spent on what only looks like a chunk, in addition to
constexpr qint64 kSearchFactor = 4;  // so many times the file
constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

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

void appendPiece(QByteArray &bytes, const RecordedPiece &piece)
{
    const auto at = quint64(piece.at);
    bytes += ByteWriter()
                 .u8(quint8(piece.kind))
                 .u32(quint32(piece.bytes.size()))
                 .u32(quint32(at))
                 .u32(quint32(at >> 32))
                 .take();
    bytes += piece.bytes;
}

struct Chunk
{
    quint8 kind = 0;
    QByteArrayView content;
    [[nodiscard]] qsizetype size() const { return kChunkHeader + content.size(); }
};

/// Reads the bytes of a recording chunk by chunk, and past those that are damaged.
class RecordingReader
{
public:
    explicit RecordingReader(const QByteArray &bytes)
        : m_bytes(bytes)
        , m_budget(kSearchBase + kSearchFactor * bytes.size())
    {
    }

    Result<Recording> read()
    {
        qsizetype at = kMagic.size();
        if (!m_bytes.startsWith(kMagic)) {
            // Another version is another format; what is no recording at all has no whole chunk there.
            const bool otherVersion = m_bytes.startsWith(kName) && m_bytes.size() > kName.size()
                && m_bytes[kName.size()] != kMagic[kName.size()];
            if (otherVersion)
                return fileFailure(versionFault());
            if (m_bytes.size() <= at || !chunkAt(at))
                return fileFailure(strangerFault());
            leaveOut(0, at, GapCause::FirstLine);
        }
        while (at < m_bytes.size()) {
            const auto chunk = chunkAt(at);
            const std::optional<GapCause> problem = chunk ? take(*chunk) : chunk.error();
            const qsizetype next = chunk ? at + chunk->size() : nextWhole(at + 1);
            if (problem)
                leaveOut(at, next, *problem);
            at = next;
        }
        if (!m_described && !describeFromRemains())
            return fileFailure(m_recording.pieces.empty()
                                       && m_bytes.size() < kMagic.size() + kLongestDescription
                                   ? FileFault{.problem = FileProblem::Truncated, .kind = FileKind::Recording}
                                   : FileFault{.problem = FileProblem::Damaged,
                                               .kind = FileKind::Recording,
                                               .said = u"the recording is damaged at its very beginning"_s});
        return std::move(m_recording);
    }

private:
    /// Another version: a later one, unless it is no number at all.
    [[nodiscard]] FileFault versionFault() const
    {
        const QByteArrayView rest = m_bytes.sliced(kName.size());
        const QByteArray version
            = rest.first(std::min<qsizetype>(rest.size(), 12)).toByteArray().split('\n').first();
        bool isNumber = false;
        const bool isNewer = version.toInt(&isNumber) > kRecordingVersion && isNumber;
        return {.problem = isNewer ? FileProblem::NewerVersion : FileProblem::Damaged,
                .kind = FileKind::Recording,
                .line = 1,
                .value = QString::fromLatin1(version),
                .expected = QString::number(kRecordingVersion)};
    }

    /// What is no recording: nothing at all, the beginning of one, or something else.
    [[nodiscard]] FileFault strangerFault() const
    {
        const bool isBegun = m_bytes.startsWith(kMagic.first(std::min(m_bytes.size(), kMagic.size())));
        return {.problem = m_bytes.isEmpty() ? FileProblem::Empty
                    : isBegun                ? FileProblem::Truncated
                                             : FileProblem::OtherKind,
                .kind = FileKind::Recording};
    }

    /// The chunk that begins here, or what is wrong with it.
    [[nodiscard]] tl::expected<Chunk, GapCause> chunkAt(qsizetype at) const
    {
        const QByteArrayView rest = m_bytes.sliced(at);
        if (rest.size() < kChunkHeader)
            return tl::unexpected(GapCause::EndsWithin);
        const auto length = lengthOf(rest);
        if (!rest.startsWith(kChunkMark) || length > kLongestChunk)
            return tl::unexpected(GapCause::NoChunk);
        if (qsizetype(length) > rest.size() - kChunkHeader)
            return tl::unexpected(GapCause::EndsWithin);
        const QByteArrayView content = rest.sliced(kChunkHeader, length);
        if (checksum(rest.first(12), content) != rest.sliced(12, kChecksum))
            return tl::unexpected(GapCause::Checksum);
        return Chunk{quint8(rest[4]), content};
    }

    static quint32 lengthOf(QByteArrayView chunk) { return quint32(readLittleEndian(chunk.sliced(8, 4))); }

    // Anything may look like the beginning of a chunk and claim a long one: what is spent on finding out that
    // it is none has its limit.
    [[nodiscard]] qsizetype nextWhole(qsizetype from)
    {
        for (from = m_bytes.indexOf(kChunkMark, from); from >= 0 && m_budget > 0;
             from = m_bytes.indexOf(kChunkMark, from + 1)) {
            if (chunkAt(from))
                return from;
            const QByteArrayView rest = m_bytes.sliced(from);
            const qint64 claimed = rest.size() < kChunkHeader ? 0 : qint64(lengthOf(rest));
            m_budget -= kChunkHeader + (claimed <= rest.size() - kChunkHeader ? claimed : 0);
        }
        return m_bytes.size();
    }

    void leaveOut(qsizetype from, qsizetype to, GapCause cause)
    {
        m_recording.gaps.push_back({from, to - from, cause, m_recording.pieces.size()});
    }

    // What is wrong with the content, if anything. Unknown kinds belong to a later version.
    std::optional<GapCause> take(const Chunk &chunk)
    {
        if (chunk.kind == DescriptionChunk) {
            const auto document = QJsonDocument::fromJson(chunk.content.toByteArray());
            if (!document.isObject())
                return GapCause::Description;
            m_described = true;
            m_recording.description = document.object();
            const auto opening
                = QByteArray::fromBase64(m_recording.description.value(u"opening"_s).toString().toLatin1());
            if (!readPieces(opening, m_recording.opening))
                m_recording.opening.clear();
        } else if (chunk.kind == PiecesChunk) {
            const std::size_t before = m_recording.pieces.size();
            if (!readPieces(chunk.content, m_recording.pieces)) {
                m_recording.pieces.resize(before);
                return GapCause::Pieces;
            }
        }
        return {};
    }

    // Without the family nothing can be decoded, so it is looked for in what was left out before the first
    // piece.
    bool describeFromRemains()
    {
        static const QRegularExpression word(u"\"family\"\\s*:\\s*\"(\\w+)\""_s);
        for (const Recording::Gap &gap : m_recording.gaps) {
            if (gap.piece > 0 || m_recording.pieces.empty())
                break;
            const QByteArrayView remains
                = m_bytes.sliced(gap.offset, std::min<qint64>(gap.bytes, kLongestDescription));
            const auto match = word.match(QString::fromLatin1(remains));
            if (match.hasMatch())
                m_recording.description = {{u"family"_s, match.captured(1)}};
            if (match.hasMatch())
                return true;
        }
        return false;
    }

    QByteArrayView m_bytes;
    qint64 m_budget;
    Recording m_recording;
    bool m_described = false;
};

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
        return tl::unexpected(systemError(file, FileKind::Recording, false));
    auto recording = fromBytes(file.readAll());
    if (!recording)
        return tl::unexpected(inFile(recording.error(), path));
    return recording;
}

Result<QJsonObject> Recording::describe(const QString &path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return tl::unexpected(systemError(file, FileKind::Recording, false));
    const QByteArray bytes = file.read(kMagic.size() + kLongestDescription);
    auto beginning = fromBytes(bytes);
    if (!beginning && bytes.startsWith(kName))  // what describes it is damaged, and the next chunk is longer
        beginning = load(path);
    if (!beginning)
        return tl::unexpected(inFile(beginning.error(), path));
    return beginning->description;
}

Result<Recording> Recording::fromBytes(const QByteArray &bytes)
{
    if (bytes.startsWith(kName) || !BlackBox::isBegunBy(bytes))
        return RecordingReader(bytes).read();
    return BlackBox::read(bytes).map(recordingOf);
}

bool Recording::isPacketBased() const
{
    return description.value(u"packets"_s).toBool();
}

bool Recording::hasGapBefore(std::size_t piece) const
{
    const auto found
        = std::lower_bound(gaps.begin(), gaps.end(), piece,
                           [](const Gap &gap, std::size_t number) { return gap.piece < number; });
    return found != gaps.end() && found->piece == piece;
}

QList<ReplayGap> Recording::leftOut() const
{
    const qint64 first = begin();
    const auto timeOf = [this, first](std::size_t piece) { return double(pieces[piece].at - first) * 1e-9; };
    const auto isReceived
        = [this](std::size_t piece) { return pieces[piece].kind == RecordedPiece::Kind::Received; };
    QList<ReplayGap> list;
    double before = kUnknown;
    std::size_t next = 0;
    for (const Gap &gap : gaps) {
        for (; next < gap.piece; ++next)
            before = isReceived(next) ? timeOf(next) : before;
        list.append({gap.offset, gap.bytes, gap.cause, before, kUnknown});
    }
    double after = kUnknown;
    next = pieces.size();
    for (std::size_t i = gaps.size(); i-- > 0; list[qsizetype(i)].to = after) {
        for (; next > gaps[i].piece; --next)
            after = isReceived(next - 1) ? timeOf(next - 1) : after;
    }
    return list;
}

QByteArray toBytes(const std::vector<RecordedPiece> &pieces)
{
    QByteArray bytes;
    for (const RecordedPiece &piece : pieces)
        appendPiece(bytes, piece);
    return bytes;
}

Result<RecordingWriter> RecordingWriter::create(const QString &path, const QJsonObject &description)
{
    auto file = std::make_unique<QFile>(path);
    if (!file->open(QIODevice::WriteOnly | QIODevice::Truncate | QIODevice::Unbuffered))
        return tl::unexpected(systemError(*file, FileKind::Recording, true));
    RecordingWriter writer(std::move(file));
    if (writer.m_file->write(kMagic.data(), kMagic.size()) != kMagic.size())
        return tl::unexpected(systemError(*writer.m_file, FileKind::Recording, true));
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
    appendPiece(m_waiting, piece);
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
    const Error error = systemError(*m_file, FileKind::Recording, true);
    m_file->resize(m_end);  // remove an incomplete chunk
    m_file.reset();
    return tl::unexpected(error);
}
