// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// BODE_TEST: the board shakes an axis and tells what went in and what came out (errata 3.23).
#include "protocol/analysis/frequencyresponse.h"
#include "protocol/base/filefault.h"
#include "protocol/base/responsecsv.h"
#include "protocol/session/channel.h"
#include "protocol/simplebgc/actions.h"
#include "protocol/simplebgc/messages.h"

#include <QBuffer>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace simplebgc {

namespace {

constexpr double kTestRate = 1250;  // samples per second, one in each cycle of 0.8 ms
constexpr auto kBetweenSamples = 2s;
constexpr auto kEndOfStop = 1s;
constexpr double kFullScale = 65534;
constexpr double kGoodCoherence = 0.6;
constexpr double kBandwidthDb = -3;
constexpr int kReportSize = 6;  // bytes of it that say something

struct ShakenAxis
{
    std::vector<float> in;
    std::vector<float> out;
    int missing = 0;  // frames
    int newest = -1;
};

// Numbers on a scale of their own in each frame.
bool addSamples(ShakenAxis &shaken, const QByteArray &payload)
{
    ByteReader reader(payload);
    const int counter = reader.u8();
    const double inMin = double(reader.f32()), outMin = double(reader.f32());
    const double inMax = double(reader.f32()), outMax = double(reader.f32());
    if (!reader.ok() || reader.remaining() % 4 != 0)
        return false;
    if (shaken.newest >= 0)
        shaken.missing += (counter - shaken.newest - 1) & 0xFF;
    shaken.newest = counter;
    while (reader.remaining() > 0) {
        shaken.in.push_back(float(reader.u16() / kFullScale * (inMax - inMin) + inMin));
        shaken.out.push_back(float(reader.u16() / kFullScale * (outMax - outMin) + outMin));
    }
    return true;
}

/// @param isLoop it is one that follows, so that it has a bandwidth
Result<ActionReply> foundResponse(const ShakenAxis &shaken, double from, double to, bool isLoop)
{
    const auto response = frequencyResponse(shaken.in, shaken.out, kTestRate);
    if (!response)
        return tl::unexpected(response.error());
    ActionReply reply{{u"samples"_s, int(shaken.in.size())}};
    double coherence = 0;
    int good = 0;
    std::optional<std::size_t> peak;
    std::optional<double> bandwidth;
    std::optional<double> first;
    for (std::size_t bin = 1; bin < response->gain.size(); ++bin) {
        const double hz = response->frequency(bin);
        if (hz < from || hz > to || response->coherence[bin] < kGoodCoherence)
            continue;
        coherence += response->coherence[bin];
        ++good;
        if (!peak || response->gainDb(bin) > response->gainDb(*peak))
            peak = bin;
        if (!first)
            first = response->gainDb(bin);
        if (!bandwidth && response->gainDb(bin) < *first + kBandwidthDb)
            bandwidth = hz;
    }
    if (!peak)
        return failure(ErrorCode::NoSamples,
                       u"what came out has nothing to do with what went in: the stimulus is too weak"_s);
    reply.insert(u"coherence"_s, coherence / good);
    reply.insert(u"peak.frequency"_s, response->frequency(*peak));
    reply.insert(u"peak.gain"_s, response->gainDb(*peak));
    if (isLoop && bandwidth)
        reply.insert(u"bandwidth.frequency"_s, *bandwidth);
    return reply;
}

}  // namespace

QByteArray Actions::frequencyTestPayload(const QVariantMap &arguments, quint32 samples)
{
    return ByteWriter()
        .u8(arguments.value(u"axis"_s).toInt())
        .u8(arguments.value(u"stimulus"_s).toInt())
        .u16(arguments.value(u"gain"_s).toInt())
        .u16(arguments.value(u"to"_s).toInt())
        .u8(arguments.value(u"system"_s).toInt())
        .u32(samples)
        .u8(0)
        .u16(arguments.value(u"from"_s).toInt())
        .zeros(16)
        .take();
}

// Ended early, the board would shake on; that it has ended shows in its report.
Error Actions::afterFrequencyTest(const Error &error, const QVariantMap &arguments)
{
    Error ended = error;
    const Unbroken unbroken(m_channel);
    const auto report = m_channel.listen(
        [](const FrameView &frame) { return frame.id == number(CommandId::BodeTestStartStop); });
    const auto stopped = m_channel.transact(
        confirmRequest(CommandId::BodeTestStartStop, frequencyTestPayload(arguments, 0), Device::kVersion));
    if (!stopped || !report->next(kEndOfStop))
        addDetail(ended.detail,
                  u"the board was told to stop shaking the axis, without proof: switch the motors off"_s);
    return ended;
}

Result<ActionReply> Actions::measureFrequencies(const QVariantMap &arguments)
{
    const int from = arguments.value(u"from"_s).toInt();
    const int to = arguments.value(u"to"_s).toInt();
    if (from >= to)
        return failure(ErrorCode::InvalidArgument, u"the highest frequency has to be above the lowest"_s);
    const auto on = m_device.areMotorsOn(m_channel);
    if (!on)
        return tl::unexpected(on.error());
    if (!*on)
        return failure(ErrorCode::ConditionUnmet, u"the motors are off, so nothing would move"_s);
    const auto total = quint32(std::lround(arguments.value(u"seconds"_s).toDouble() * kTestRate));
    const auto heard = m_channel.listen([](const FrameView &frame) {
        return frame.id == number(CommandId::BodeTestData)
            || frame.id == number(CommandId::BodeTestStartStop);
    });
    const auto begun = m_channel.transact(confirmRequest(
        CommandId::BodeTestStartStop, frequencyTestPayload(arguments, total), Device::kVersion));
    if (!begun && begun.error().code != ErrorCode::Timeout)
        return tl::unexpected(begun.error());
    Progress progress;
    progress.step = u"frequency-test"_s;
    progress.subject = axisName(std::size_t(arguments.value(u"axis"_s).toInt()));
    progress.total = int(total);
    ShakenAxis shaken;
    for (;;) {
        const auto frame = heard->next(kBetweenSamples);
        if (!frame)
            return tl::unexpected(afterFrequencyTest(frame.error(), arguments));
        if (frame->id == number(CommandId::BodeTestData)) {
            if (!addSamples(shaken, frame->payload))
                return tl::unexpected(
                    afterFrequencyTest({ErrorCode::BadReply, u"BODE_TEST_DATA"_s, 0}, arguments));
            progress.done = int(shaken.in.size());
            m_channel.progress(progress);
            continue;
        }
        if (frame->payload.size() < kReportSize)
            return failure(ErrorCode::BadReply, u"BODE_TEST_START_STOP"_s);
        ByteReader reader(frame->payload);
        reader.skip(4);
        if (const int code = reader.u16(); code != 0)
            return failure(ErrorCode::BoardError, errorCodeText(code), code);
        break;
    }
    // Samples that are lost would shift what follows.
    if (shaken.missing > 0)
        return failure(ErrorCode::BadReply, u"%1 of the frames with samples were lost"_s.arg(shaken.missing));
    QBuffer text;
    text.open(QIODevice::WriteOnly);
    if (const auto written = writeResponseCsv(text, shaken.in, shaken.out, kTestRate); !written)
        return tl::unexpected(written.error());
    if (const auto saved = writeWhole(arguments.value(u"file"_s).toString(), text.data()); !saved)
        return tl::unexpected(saved.error());
    constexpr int kLoops = 128 | 8;  // closed, and overall
    return foundResponse(shaken, from, to, arguments.value(u"system"_s).toInt() & kLoops);
}

}  // namespace simplebgc
