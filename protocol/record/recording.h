// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "protocol/base/clock.h"
#include "protocol/base/result.h"
#include "protocol/transport/replay.h"

#include <QFile>
#include <QJsonObject>

#include <vector>

class BlackBox;

/// Something that passed over the link.
struct RecordedPiece
{
    enum class Kind : quint8 {
        Received = 1,  ///< bytes as they came from the port
        Sent = 2,  ///< a write to the port: one or more whole frames
        Reply = 3,  ///< the frame among the received bytes that answered a request
    };

    Kind kind = Kind::Received;
    qint64 at
        = 0;  ///< nanoseconds since the link was opened; what was sent before the recording may be earlier
    QByteArray bytes;

    friend bool operator==(const RecordedPiece &, const RecordedPiece &) = default;
};

/// What passed over a link, as a file: "GIMBALREC 1\n", then chunks. A chunk is "GDCK", kind (1 byte: 1
/// description, 2 pieces), three zero bytes, length of the content (4 bytes), the first eight bytes of the
/// SHA-1 of all that and of the content, and the content. The description is JSON (family, identity, address,
/// when, whether what came were packets; "opening" repeats the first requests and answers, pieces in base 64,
/// so that damage to them does not take away whose values these are). Pieces follow each other without gaps:
/// kind (1 byte), length (4), time (8), bytes. Numbers are little-endian. A truncated file is valid up to its
/// last complete chunk; a damaged chunk is left out, and reading goes on with the next one whose checksum is
/// right.
struct Recording
{
    /// A part of the file that was left out.
    struct Gap
    {
        qint64 offset = 0;
        qint64 bytes = 0;
        GapCause cause = GapCause::Checksum;
        std::size_t piece = 0;  ///< how many pieces come before it
    };

    QJsonObject description;  ///< only the family where it is damaged
    std::vector<RecordedPiece> pieces;
    std::vector<RecordedPiece> opening;  ///< the first requests and answers, as the description repeats them
    std::vector<Gap> gaps;  ///< in the order of the file

    /// Time of the first and the last received bytes, in nanoseconds.
    [[nodiscard]] qint64 begin() const;
    [[nodiscard]] qint64 end() const;

    /// Each piece that was received is a packet, and no frame spans two of them.
    [[nodiscard]] bool isPacketBased() const;
    /// Whether something is missing before this piece.
    [[nodiscard]] bool hasGapBefore(std::size_t piece) const;
    /// What was left out, with the times between which it lies.
    [[nodiscard]] QList<ReplayGap> leftOut() const;

    /// Reads past any damage; the black box of a drone (BlackBox) is a recording as well. Errors: BadFile if
    /// it is none or nothing at all can be read.
    static Result<Recording> load(const QString &path);
    static Result<Recording> fromBytes(const QByteArray &bytes);
    /// Reads only the description, without the rest. Errors: BadFile.
    static Result<QJsonObject> describe(const QString &path);
};

/// A black box as a recording (recordedblackbox.cpp): its lines were "received" when they were written, and
/// what names there are is answered as if it had been asked for. protocol/blackbox decodes it.
[[nodiscard]] Recording recordingOf(const BlackBox &box);

/// Pieces as a chunk holds them, to be repeated in a description.
[[nodiscard]] QByteArray toBytes(const std::vector<RecordedPiece> &pieces);

/// Writes a recording, appending only. A full disk ends it with an error; what was already written stays
/// valid.
class RecordingWriter
{
public:
    /// Begins a new file. Errors: BadFile.
    static Result<RecordingWriter> create(const QString &path, const QJsonObject &description);

    /// Adds pieces; they are written once enough have been collected or flush() is called. Errors: BadFile;
    /// after an error nothing more is written.
    Result<void> append(const RecordedPiece &piece);
    Result<void> flush();
    [[nodiscard]] qint64 bytesWritten() const { return m_end; }

private:
    explicit RecordingWriter(std::unique_ptr<QFile> file)
        : m_file(std::move(file))
    {
    }
    Result<void> writeChunk(quint8 kind, const QByteArray &content);

    std::unique_ptr<QFile> m_file;
    QByteArray m_waiting;
    qint64 m_end = 0;  // of the last complete chunk
};
