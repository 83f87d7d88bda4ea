// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Another firmware for a drone (errata 7.4).
#include "protocol/bcflight/firmware.h"

#include "protocol/base/battery.h"
#include "protocol/base/checksum.h"
#include "protocol/base/filefault.h"
#include "protocol/bcflight/device.h"
#include "protocol/bcflight/infotext.h"
#include "protocol/bcflight/messages.h"
#include "protocol/session/channel.h"

#include <QCoreApplication>

#include <algorithm>
#include <cctype>

using namespace Qt::StringLiterals;

namespace bcflight {

namespace {

constexpr qint64 kLargestImage = 4194304;  // offset and size of each piece lie below 4 MiB

constexpr qint64 kSmallestImage = 1024;  // no program is smaller that flies

/// What files that no drone runs have at one place: its program is taken as it is.
struct OtherFile
{
    QByteArrayView mark;
    const char *what;
    qsizetype at = 0;
};
constexpr OtherFile kOtherFiles[] = {{"PK\x03\x04", "a ZIP archive: unpack it"},
                                     {"\x1F\x8B", "packed by gzip: unpack it"},
                                     {"\xFD"
                                      "7zXZ",
                                      "packed by xz: unpack it"},
                                     {"BZh", "packed by bzip2: unpack it"},
                                     {"\x28\xB5\x2F\xFD", "packed by zstd: unpack it"},
                                     {"7z\xBC\xAF", "a 7z archive: unpack it"},
                                     {"Rar!", "a RAR archive: unpack it"},
                                     {"ustar", "a tar archive: unpack it", 257},
                                     {"!<arch>", "an archive: unpack it"},
                                     {"%PDF", "a PDF document"},
                                     {"\xD0\xCF\x11\xE0", "an office document"},
                                     {"SQLite format 3", "a database"},
                                     {"\x89PNG", "a picture"},
                                     {"\xFF\xD8\xFF", "a picture"},
                                     {"GIF8", "a picture"},
                                     {"II*", "a picture"},
                                     {"RIFF", "a picture, a sound or a video"},
                                     {"ID3", "a sound"},
                                     {"OggS", "a sound or a video"},
                                     {"ftyp", "a video", 4},
                                     {"\x1A\x45\xDF\xA3", "a video"},
                                     {"MZ", "a program for Windows"},
                                     {"\xCF\xFA\xED\xFE", "a program for macOS"},
                                     {"\xCA\xFE\xBA\xBE", "a program for macOS or for Java"},
                                     {"UF2\n", "a program for a microcontroller"},
                                     {"GIMBALREC", "a recording"},
                                     {"{", "a text in JSON"},
                                     {"--", "a text in Lua"},
                                     {":", "a text in Intel HEX: the drone takes the bytes themselves"},
                                     {"<", "a text in XML or HTML"}};

/// The head of a program for Linux (ELF).
constexpr QByteArrayView kElf("\x7F"
                              "ELF");
constexpr qsizetype kElfType = 16;
constexpr qsizetype kElfMachine = 18;
constexpr int kExecutable = 2;
constexpr int kShared = 3;
constexpr int kIntel = 3;
constexpr int kAmd64 = 62;
constexpr int kArm32 = 40;
constexpr int kArm64 = 183;

int elfWord(const QByteArray &image, qsizetype at)
{
    return std::uint8_t(image[at]) | std::uint8_t(image[at + 1]) << 8;
}

bool isText(const QByteArray &image)
{
    if (image.startsWith("\xFF\xFE") || image.startsWith("\xFE\xFF"))
        return true;  // UTF-16
    constexpr char kFirstLetter = ' ';
    return std::none_of(image.begin(), image.end(),
                        [](char byte) {
                            return (byte >= 0 && byte < kFirstLetter && !std::isspace(byte))
                                || byte == '\x7F';
                        })
        && QString::fromUtf8(image).toUtf8() == image;
}

// Null: it may be a drone's program.
const char *otherKind(const QByteArray &image)
{
    const auto other
        = std::find_if(std::begin(kOtherFiles), std::end(kOtherFiles), [&](const OtherFile &each) {
              return QByteArrayView(image).sliced(each.at).startsWith(each.mark);
          });
    if (other != std::end(kOtherFiles))
        return other->what;
    if (isText(image))
        return "a text";
    if (!image.startsWith(kElf))
        return nullptr;
    const int machine = elfWord(image, kElfMachine);
    const int type = elfWord(image, kElfType);
    if (machine == kIntel || machine == kAmd64)
        return "a program for a desktop computer";
    return type == kExecutable || type == kShared ? nullptr : "a part of a program";
}

constexpr qsizetype kPiece = 1024;
constexpr int kRepeats = 8;  // of what has no answer, as the original sends it
constexpr auto kBetweenRepeats = 50ms;
constexpr auto kPieceAnswer = 100ms;
constexpr int kPieceRetries = 30;  // three seconds without a word
constexpr auto kToldEvery = 100ms;
constexpr auto kReplaces = 15s;  // fixed waits of about 8 s before it restarts
constexpr auto kStartsAnew = 60s;
constexpr std::uint32_t kTaken = 1;
constexpr std::uint32_t kDamagedPiece = 2;

// What is wrong with a piece's head leaves the piece unread: the drone takes its bytes for commands.
std::optional<Result<Frame>> pieceAnswer(const FrameView &frame)
{
    if (frame.id != int(Message::UploadData))
        return {};
    const FieldSpec field{"code", FieldType::U32};
    const auto values = decodeFields({&field, 1}, frame.payload);
    const std::uint32_t code = values.empty() ? 0 : std::uint32_t(values.front().number);
    if (code == kTaken)
        return Result<Frame>(Frame(frame));
    if (code == kDamagedPiece)
        return tl::unexpected(Error{ErrorCode::Damaged, u"a piece of the firmware"_s, int(code)});
    return tl::unexpected(Error{ErrorCode::BoardError,
                                u"the drone did not take a piece of the firmware, and may have taken its "
                                "bytes for commands; look whether it is armed"_s,
                                int(code)});
}

// A drone that loses its power while it replaces its program has none afterwards.
Result<void> checkBattery(const Telemetry &now)
{
    if (now.voltage <= kNoBatteryVolts)
        return {};  // supplied otherwise, or not measured
    const int cells = std::max(batteryCells(now.voltage), countedCells(now.voltage, now.level / 100.0));
    const bool isLow = now.voltage < lowBattery(cells, kLowCellVolts, {}).value_or(0.0);
    return isLow ? failure(ErrorCode::ConditionUnmet,
                           u"the battery is low: %1 V, %2 %. A drone that loses its power while its program "
                           "is replaced does not start any more; charge or change the battery first"_s
                               .arg(now.voltage, 0, 'f', 1)
                               .arg(now.level))
                 : Result<void>();
}

// From the first message on its stream is silent, and nothing but a restart brings it back.
Error leftSilent(Error error)
{
    addDetail(error.detail,
              u"the drone runs the firmware that it had; its stream stays silent until it is restarted: "
              "switch it off and on"_s);
    return error;
}

}  // namespace

Result<QString> Device::firmwareVersion(Channel &channel)
{
    const auto told = channel.transact(ask(Message::GetBoardInfos));
    if (!told)
        return tl::unexpected(told.error());
    const auto info = readInfo(told->payload.left(told->payload.indexOf('\0')));
    if (!info)
        return QString();
    const auto it = std::find_if(info->begin(), info->end(),
                                 [](const InfoNode &node) { return node.name == u"Firmware version"_s; });
    return it == info->end() ? QString() : it->value;
}

Result<QByteArray> readFirmware(const QString &path)
{
    auto image = readWhole(path, FileKind::Firmware, kLargestImage);
    if (!image)
        return image;
    if (image->isEmpty())
        return fileFailure({.problem = FileProblem::Empty, .kind = FileKind::Firmware, .path = path});
    const QString other = image->size() < kSmallestImage
        ? u"too small for a drone's program: %1 bytes"_s.arg(image->size())
        : QLatin1String(otherKind(*image));
    if (!other.isEmpty())
        return fileFailure({.problem = FileProblem::OtherKind,
                            .kind = FileKind::Firmware,
                            .path = path,
                            .said = u"it is "_s + other});
    return image;
}

bool isDroneProgram(const QByteArray &image)
{
    if (!image.startsWith(kElf) || image.size() < kSmallestImage)
        return false;
    const int machine = elfWord(image, kElfMachine);
    return machine == kArm32 || machine == kArm64;
}

const char *Device::doubt(const QString &action, const QVariantMap &arguments) const
{
    if (action != u"firmware.upload"_s)
        return "";
    const auto image = readFirmware(arguments.value(u"file"_s).toString());
    if (!image || isDroneProgram(*image))
        return "";
    return QT_TRANSLATE_NOOP(
        "Tables",
        "Nothing in the file shows that it is a program for a drone. A drone whose program "
        "does not start cannot be reached any more.");
}

Result<ActionReply> Device::uploadFirmware(Channel &channel, const QString &path)
{
    const auto image = readFirmware(path);
    if (!image)
        return tl::unexpected(image.error());
    // Over a stream a piece may arrive in two parts, and the second would be taken for commands (2.6).
    if (!channel.observation().isPacketBased)
        return failure(ErrorCode::Unsupported, u"firmware is uploaded over UDP only"_s);
    if (const auto may = checkMaySend(channel, Message::UploadInit); !may)
        return tl::unexpected(may.error());
    const auto told = channel.transact(askState(Message::Telemetry));
    const auto telemetry = told ? Telemetry::decode(asBytes(told->payload)) : std::nullopt;
    if (!telemetry)
        return told ? failure(ErrorCode::BadReply, u"TELEMETRY"_s) : tl::unexpected(told.error());
    if (const auto lasts = checkBattery(*telemetry); !lasts)
        return tl::unexpected(lasts.error());
    const auto before = firmwareVersion(channel);
    if (!before)
        return tl::unexpected(before.error());
    for (int i = 0; i < kRepeats; ++i) {
        channel.post(order(Message::UploadInit));
        if (const auto slept = channel.sleep(kBetweenRepeats); !slept)
            return tl::unexpected(leftSilent(slept.error()));
    }
    if (const auto sent = sendPieces(channel, *image); !sent)
        return tl::unexpected(leftSilent(sent.error()));
    // It would restart in the air as well.
    if (const auto may = checkMaySend(channel, Message::UploadProcess); !may)
        return tl::unexpected(leftSilent(may.error()));
    if (channel.cancelled())
        return tl::unexpected(leftSilent({ErrorCode::Cancelled, {}, 0}));
    const Unbroken unbroken(channel);
    if (const auto replaced = replaceProgram(channel, crc32c(asBytes(*image))); !replaced)
        return tl::unexpected(status(channel) ? leftSilent(replaced.error()) : replaced.error());
    const auto after = firmwareVersion(channel);
    if (!after)
        return tl::unexpected(after.error());
    // Only another version shows that it is another firmware.
    ActionReply reply{{u"before"_s, *before}, {u"firmware"_s, *after}, {u"bytes"_s, image->size()}};
    reply.insert(u"confirmed"_s, *after != *before);
    if (*after == *before)
        reply.insert(u"unproven"_s,
                     u"the drone has restarted and tells the same version as before: whether it runs the "
                     "new firmware is not known"_s);
    return reply;
}

// In order, each its own packet, and the next one only once the drone has this one: a first piece that came
// again after later ones would erase them. Late answers to a piece that was sent twice are waited for
// (TransactionQueue), so that none is taken for that to the next.
Result<void> Device::sendPieces(Channel &channel, const QByteArray &image)
{
    Progress progress;
    progress.step = u"firmware-upload"_s;
    progress.total = int((image.size() + kPiece - 1) / kPiece);
    TimePoint told{};
    for (qsizetype at = 0; at < image.size(); at += kPiece) {
        Request request
            = ask(Message::UploadData,
                  encodeChunk(std::uint32_t(at),
                              QByteArrayView(image).sliced(at).first(std::min(kPiece, image.size() - at))));
        request.answer = pieceAnswer;
        request.timeout = kPieceAnswer;
        request.retries = kPieceRetries;
        if (const auto taken = channel.transact(request); !taken)
            return tl::unexpected(taken.error());
        ++progress.done;
        if (channel.now() - told >= kToldEvery || progress.done == progress.total) {
            told = channel.now();
            progress.values = {{u"bytes"_s, double(std::min(image.size(), at + kPiece))},
                               {u"all"_s, double(image.size())}};
            channel.progress(progress);
        }
    }
    return {};
}

// No answer. On a mismatch it only writes its own log, and goes on as it was.
Result<void> Device::replaceProgram(Channel &channel, std::uint32_t crc)
{
    channel.expectSilence(kReplaces + kStartsAnew);
    Progress progress;
    progress.step = u"firmware-restart"_s;
    channel.progress(progress);
    for (int i = 0; i < kRepeats; ++i) {
        channel.post(order(Message::UploadProcess, bigU32(crc)));
        if (const auto slept = channel.sleep(kBetweenRepeats); !slept)
            return slept;
    }
    return awaitReturn(channel, kReplaces, kStartsAnew);
}

}  // namespace bcflight
