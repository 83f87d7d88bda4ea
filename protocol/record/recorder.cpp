// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/record/recorder.h"

#include <QDateTime>

#include <algorithm>
#include <utility>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kDrainPeriod = 200ms;
constexpr std::size_t kSetupPieces = 2000;
constexpr std::size_t kSaidPieces = 20000;
constexpr quint64 kPiecesAtOnce = 5000;
constexpr qsizetype kOpeningBytes = 8 << 10;
constexpr qsizetype kPieceCost = 64;  // bytes of memory in addition to its content

// A simulated board is reached as its board says.
bool comesInPackets(const BoardIdentity &identity, const LinkAddress &address)
{
    return address.kind() == LinkAddress::Kind::Udp
        || (address.kind() == LinkAddress::Kind::Simulator
            && identity.extra.value(u"port"_s).toString() == u"network"_s);
}

}  // namespace

Recorder::Recorder(double seconds, qsizetype bytes)
    : m_seconds(seconds)
    , m_limit(bytes)
{
}

void Recorder::bytesReceived(QByteArrayView bytes, TimePoint at)
{
    add(RecordedPiece::Kind::Received, bytes, at);
}

void Recorder::bytesSent(QByteArrayView bytes, TimePoint at)
{
    add(RecordedPiece::Kind::Sent, bytes, at);
}

void Recorder::frameReceived(const FrameView &frame, TimePoint at, bool claimed)
{
    if (claimed && !frame.raw.empty())
        add(RecordedPiece::Kind::Reply,
            QByteArrayView(reinterpret_cast<const char *>(frame.raw.data()), qsizetype(frame.raw.size())),
            at);
}

void Recorder::add(RecordedPiece::Kind kind, QByteArrayView bytes, TimePoint at)
{
    const std::lock_guard lock(m_mutex);
    if (!m_origin)
        m_origin = at;
    const qint64 time = std::chrono::duration_cast<std::chrono::nanoseconds>(at - *m_origin).count();
    m_pieces.push_back({kind, time, bytes.toByteArray()});
    m_bytes += bytes.size() + kPieceCost;
    ++m_newest;
    const auto oldest = time - qint64(m_seconds * 1e9);
    while (!m_pieces.empty() && (m_pieces.front().at < oldest || m_bytes > m_limit)) {
        RecordedPiece &front = m_pieces.front();
        m_bytes -= front.bytes.size() + kPieceCost;
        if (front.kind != RecordedPiece::Kind::Received) {
            if (m_setup.size() < kSetupPieces)
                m_setup.push_back(std::move(front));
            else
                m_said.push_back(std::move(front));
            if (m_said.size() > kSaidPieces)
                m_said.pop_front();
        }
        m_pieces.pop_front();
    }
}

void Recorder::clear()
{
    const std::lock_guard lock(m_mutex);
    m_pieces.clear();
    m_setup.clear();
    m_said.clear();
    m_bytes = 0;
    m_origin.reset();
}

void Recorder::clearUntil(quint64 number)
{
    const std::lock_guard lock(m_mutex);
    m_setup.clear();
    m_said.clear();
    const quint64 fresh = m_newest - std::min(number, m_newest);
    while (m_pieces.size() > fresh) {
        m_bytes -= m_pieces.front().bytes.size() + kPieceCost;
        m_pieces.pop_front();
    }
}

std::pair<std::vector<RecordedPiece>, quint64> Recorder::after(quint64 number) const
{
    const std::lock_guard lock(m_mutex);
    std::vector<RecordedPiece> pieces;
    if (number == 0) {
        pieces = m_setup;
        pieces.insert(pieces.end(), m_said.begin(), m_said.end());
    }
    const quint64 fresh = std::min<quint64>(m_newest - std::min(number, m_newest), m_pieces.size());
    const quint64 taken = std::min<quint64>(fresh, kPiecesAtOnce);
    const auto first = m_pieces.end() - std::ptrdiff_t(fresh);
    pieces.insert(pieces.end(), first, first + std::ptrdiff_t(taken));
    return {std::move(pieces), m_newest - fresh + taken};
}

std::vector<RecordedPiece> Recorder::opening() const
{
    std::vector<RecordedPiece> opening;
    qsizetype bytes = 0;
    for (RecordedPiece &piece : after(0).first) {
        if (piece.kind == RecordedPiece::Kind::Received)
            continue;
        bytes += piece.bytes.size() + kPieceCost;
        if (bytes > kOpeningBytes)
            break;
        opening.push_back(std::move(piece));
    }
    return opening;
}

quint64 Recorder::newest() const
{
    const std::lock_guard lock(m_mutex);
    return m_newest;
}

double Recorder::heldSeconds() const
{
    const std::lock_guard lock(m_mutex);
    return m_pieces.empty() ? 0.0 : double(m_pieces.back().at - m_pieces.front().at) * 1e-9;
}

qsizetype Recorder::heldBytes() const
{
    const std::lock_guard lock(m_mutex);
    return m_bytes;
}

QJsonObject recordingDescription(const BoardIdentity &identity, const LinkAddress &address)
{
    return {{u"family"_s, identity.family},
            {u"model"_s, identity.model},
            {u"firmware"_s, identity.firmware},
            {u"serial"_s, identity.serial},
            {u"address"_s, address.toString()},
            {u"packets"_s, comesInPackets(identity, address)},
            {u"program"_s, u"GimbalDesk " GIMBAL_VERSION ""_s},
            {u"started"_s, QDateTime::currentDateTimeUtc().toString(Qt::ISODate)}};
}

Result<std::unique_ptr<RecordingTask>> RecordingTask::start(const Recorder &recorder, const QString &path,
                                                            const QJsonObject &description, bool withPast)
{
    QJsonObject whole = description;
    whole.insert(u"opening"_s, QString::fromLatin1(toBytes(recorder.opening()).toBase64()));
    auto writer = RecordingWriter::create(path, whole);
    if (!writer)
        return tl::unexpected(writer.error());
    return std::unique_ptr<RecordingTask>(new RecordingTask(recorder, std::move(*writer), withPast));
}

RecordingTask::RecordingTask(const Recorder &recorder, RecordingWriter writer, bool withPast)
    : m_recorder(recorder)
    , m_writer(std::move(writer))
    , m_start(withPast ? 0 : recorder.newest())
    , m_bytes(m_writer.bytesWritten())
    , m_thread([this] { run(); })
{
}

RecordingTask::~RecordingTask()
{
    finish();
}

Result<void> RecordingTask::finish()
{
    {
        const std::lock_guard lock(m_mutex);
        m_stop = true;
    }
    m_wake.notify_all();
    if (m_thread.joinable())
        m_thread.join();
    return m_result;
}

void RecordingTask::run()
{
    std::unique_lock lock(m_mutex);
    for (bool stop = false; !stop && m_result;) {
        stop = m_wake.wait_for(lock, kDrainPeriod, [this] { return m_stop; });
        lock.unlock();
        drain();
        lock.lock();
    }
}

void RecordingTask::drain()
{
    const quint64 newest = std::min(m_recorder.newest(), m_last.load());
    while (m_number < newest && m_result) {
        const auto [pieces, number] = m_recorder.after(m_number);
        const quint64 before = number - std::min<quint64>(number, pieces.size());
        const auto beyond = std::size_t(number - std::min(number, newest));
        const std::size_t wanted = pieces.size() - std::min(pieces.size(), beyond);
        for (std::size_t i = 0; i < wanted && m_result; ++i) {
            // Of the past, only what was sent or answered is written.
            if (before + i >= m_start || pieces[i].kind != RecordedPiece::Kind::Received)
                m_result = m_writer.append(pieces[i]);
        }
        m_number = std::min(number, newest);
    }
    if (m_result)
        m_result = m_writer.flush();
    m_bytes = m_writer.bytesWritten();
    m_failed = !m_result;
}
