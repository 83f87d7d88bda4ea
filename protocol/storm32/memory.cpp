// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What is in use and what is stored (errata 3.4, 4, 13): a board answers with the former and stores all of
// it.
#include "protocol/session/channel.h"
#include "protocol/storm32/device.h"
#include "protocol/storm32/parametertables.h"
#include "protocol/storm32/scripts.h"

#include <algorithm>

using namespace Qt::StringLiterals;

namespace storm32 {

namespace {

constexpr int kSystemWord = 110;  // followed by the component
constexpr int kAwakeState = 6;
constexpr auto kFallingAsleep = 1s;
constexpr qsizetype kFew = 8;  // words that are asked one by one

int wordAt(const QByteArray &stream, int word)
{
    return ByteReader(QByteArrayView(stream).sliced(2 * word, 2)).u16();
}

void setWord(QByteArray &stream, int word, int raw)
{
    stream.replace(2 * word, 2, ByteWriter().u16(raw & 0xFFFF).take());
}

}  // namespace

int Device::variableOf(const ParameterSpec &spec) const
{
    return spec.row->block == Parameters ? spec.offset / 2 : -1;
}

Result<std::vector<AdjustableValue>> Device::readAdjustables(Channel &channel, const QList<int> &ids)
{
    QByteArray stream;
    if (ids.size() > kFew) {
        auto read = readStream(channel);
        if (!read)
            return tl::unexpected(read.error());
        stream = *std::move(read);
    }
    std::vector<AdjustableValue> values;
    for (const int id : ids) {
        if (id < 0 || id >= m_words)
            return failure(ErrorCode::InvalidArgument, u"no live value %1"_s.arg(id));
        const auto raw = stream.isEmpty() ? readWord(channel, id) : Result<int>(wordAt(stream, id));
        if (!raw)
            return tl::unexpected(raw.error());
        const auto spec = std::find_if(m_parameters->all().begin(), m_parameters->all().end(),
                                       [id](const ParameterSpec &each) {
                                           return each.row->block == Parameters && each.offset == 2 * id;
                                       });
        const bool isSigned = spec != m_parameters->all().end() && spec->row->wire == WireType::I16;
        values.push_back({id, isSigned ? double(std::int16_t(*raw)) : double(*raw)});
    }
    return values;
}

Result<void> Device::putAdjustables(Channel &channel, const std::vector<AdjustableValue> &values)
{
    for (const AdjustableValue &value : values) {
        const auto known = std::find_if(
            m_parameters->all().begin(), m_parameters->all().end(), [&value](const ParameterSpec &spec) {
                return spec.row->block == Parameters && spec.offset == 2 * value.id;
            });
        if (known == m_parameters->all().end())
            return failure(ErrorCode::InvalidArgument, u"no live value %1"_s.arg(value.id));
        // The firmware does not check the range, so it is checked here.
        const ParameterRow &row = *known->row;
        if (!(value.value >= row.min && value.value <= row.max))
            return failure(ErrorCode::OutOfRange,
                           u"%1 is outside %2 to %3"_s.arg(value.value).arg(row.min).arg(row.max));
        auto done = writeWord(channel, value.id, int(value.value));
        if (!done && done.error().code == ErrorCode::VerifyFailed)
            done.error().code = ErrorCode::NotInUse;
        if (!done)
            return done;
    }
    return {};
}

// The address at which the board would be reached through MAVLink.
void Device::learnAddress(const QByteArray &stream)
{
    if (!isKnownLayout(m_identity.firmwareNumber))
        return;
    m_address = (wordAt(stream, kSystemWord) & 0xFF) << 8 | (wordAt(stream, kSystemWord + 1) & 0xFF);
}

void Device::learnAddressWord(int word, int raw)
{
    if (word != kSystemWord && word != kSystemWord + 1)
        return;
    const int known = isEmbedded() ? m_way.load() : m_address;
    const int shift = word == kSystemWord ? 8 : 0;
    m_address = (known & ~(0xFF << shift)) | (raw & 0xFF) << shift;
    if (isEmbedded())
        m_way = m_address;
}

Configuration Device::configurationOf(const QByteArray &stream) const
{
    Configuration configuration(m_identity, m_parameters);
    for (const auto &[block, bytes] : splitStream(stream, m_words))
        configuration.setBlock({0, block}, bytes);
    return configuration;
}

// Values in use that differ from the stored ones, or from the defaults if those are not known.
QString Device::inUseText(const QByteArray &inUse, const Result<QByteArray> &stored) const
{
    const Configuration use = configurationOf(inUse);
    const Configuration kept = stored ? configurationOf(*stored) : use;
    QStringList values;
    for (const ParameterSpec &spec : use.parameters().all()) {
        const auto raw = use.raw(spec, 0);
        if (raw && !sameValue(*raw, stored ? kept.raw(spec, 0).value_or(*raw) : spec.defaultRaw))
            values.append(u"%1=%2"_s.arg(spec.key, spec.format(*raw)));
    }
    return values.join(u' ');
}

Result<int> Device::readState(Channel &channel)
{
    const auto reply = channel.transact(simple(Simple::Status));
    if (!reply)
        return tl::unexpected(reply.error());
    return ByteReader(reply->payload).u16();
}

Result<bool> Device::enterStandby(Channel &channel, const QByteArray &inUse)
{
    bool isDisabled = false;
    for (int i = 0; i < MotorStop::kWords; ++i)
        isDisabled |= wordAt(inUse, MotorStop::kFirstWord + i) == MotorStop::kDisabled;
    if (!isDisabled)
        return false;
    const auto before = readState(channel);
    if (!before)
        return tl::unexpected(before.error());
    if (isStandby(*before, m_firmware))
        return false;
    // Standby is ignored while the board starts (errata 13, row 1).
    if (*before != kAwakeState)
        return failure(ErrorCode::Unready, u"the board is starting, with motors disabled"_s);
    if (const auto sent = channel.transact(standbyRequest(true)); !sent)
        return tl::unexpected(sent.error());
    const TimePoint until = channel.now() + kFallingAsleep;
    for (;;) {
        const auto state = readState(channel);
        if (!state)
            return tl::unexpected(state.error());
        if (isStandby(*state, m_firmware))
            return true;
        if (channel.now() > until)
            return failure(ErrorCode::Unready, u"the board does not go into standby"_s);
    }
}

Result<void> Device::putStream(Channel &channel, const QByteArray &stream)
{
    // A whole stream does not fit into MAVLink (errata 6), so the heartbeat goes first.
    if (isEmbedded() && !writeWord(channel, kHeartbeatWord, 0))
        m_way = kPlain;  // it may be reached so all the same
    if (isEmbedded())
        return failure(ErrorCode::Unsupported, u"the board answers no plain commands"_s);
    const auto put = channel.transact(simple(Simple::PutParameters, stream));
    if (!put)
        return tl::unexpected(put.error());
    learnAddress(stream);
    const int heartbeat = wordAt(stream, kHeartbeatWord);
    return heartbeat == 0 ? Result<void>() : findWay(channel, heartbeat);
}

// What is stored is in use afterwards, but for a heartbeat, which would lock plain commands out.
Result<QByteArray> Device::retrieve(Channel &channel)
{
    const auto loaded = channel.transact(simple(Simple::Retrieve));
    if (!loaded)
        return tl::unexpected(loaded.error());
    if (const auto way = findWay(channel, 1); !way)
        return tl::unexpected(way.error());
    std::optional<int> heartbeat;
    if (isEmbedded()) {
        const auto word = readWord(channel, kHeartbeatWord);
        if (!word)
            return tl::unexpected(word.error());
        heartbeat = *word;
        if (const auto off = writeWord(channel, kHeartbeatWord, 0); !off)
            return tl::unexpected(off.error());
    }
    auto stored = readStream(channel);
    if (stored && heartbeat)
        setWord(*stored, kHeartbeatWord, *heartbeat);
    return stored;
}

Result<QByteArray> Device::readStored(Channel &channel, const QByteArray &inUse)
{
    if (const auto free = checkNotStopping(); !free)
        return tl::unexpected(free.error());
    const auto asleep = enterStandby(channel, inUse);
    if (!asleep)
        return tl::unexpected(asleep.error());
    auto stored = retrieve(channel);
    // Put back even if loading seems to have failed: perhaps only its answer was lost.
    if (const auto put = putStream(channel, inUse); !put)
        return failure(ErrorCode::NotRestored, inUseText(inUse, stored) + u"; "_s + put.error().detail);
    if (*asleep) {
        if (const auto woken = channel.transact(standbyRequest(false)); !woken)
            return tl::unexpected(woken.error());
    }
    return stored;
}

Result<WholeMemory::Contents> Device::readBoth(Channel &channel)
{
    if (isEmbedded())
        return failure(ErrorCode::Unsupported, u"what is stored cannot be read while the heartbeat is on"_s);
    if (!isKnownLayout(m_identity.firmwareNumber))
        return failure(ErrorCode::Unsupported, u"the board's memory is not known"_s);
    if (const auto free = checkNotStopping(); !free)
        return tl::unexpected(free.error());
    const auto inUse = readStream(channel);
    if (!inUse)
        return tl::unexpected(inUse.error());
    const auto differs = [this](int word, int use, int kept) {
        const auto spec = std::find_if(m_parameters->all().begin(), m_parameters->all().end(),
                                       [word](const ParameterSpec &each) { return each.offset == 2 * word; });
        return failure(ErrorCode::ConditionUnmet,
                       u"%1 is %2 in use and %3 where it is stored"_s.arg(spec->key, spec->format(use),
                                                                          spec->format(kept)));
    };
    // A motor that runs, but is stored as disabled, must not let its axis fall: such a word is asked alone.
    for (int word = MotorStop::kFirstWord; word < MotorStop::kFirstWord + MotorStop::kWords; ++word) {
        const int use = wordAt(*inUse, word);
        if (use == MotorStop::kDisabled)
            continue;
        if (const auto asked = channel.transact(rc(Rc::RestoreParameter, ByteWriter().u16(word).take()));
            !asked)
            return tl::unexpected(asked.error());
        const auto kept = readWord(channel, word);
        const bool isSame = kept && *kept == use;
        if (const auto back = isSame ? Result<void>() : writeWord(channel, word, use); !back)
            return failure(ErrorCode::NotRestored, u"word %1 was %2"_s.arg(word).arg(use));
        if (!kept)
            return tl::unexpected(kept.error());
        if (!isSame)
            return differs(word, use, *kept);
    }
    const auto stored = readStored(channel, *inUse);
    if (!stored)
        return tl::unexpected(stored.error());
    for (int word = MotorStop::kFirstWord; word < MotorStop::kFirstWord + MotorStop::kWords; ++word) {
        if (wordAt(*inUse, word) != wordAt(*stored, word))
            return differs(word, wordAt(*inUse, word), wordAt(*stored, word));
    }
    return Contents{configurationOf(*inUse), configurationOf(*stored)};
}

Result<void> Device::use(Channel &channel, const Configuration &whole)
{
    QByteArray stream;
    for (const int block : {Parameters, Scripts})
        stream += whole.block({0, block});
    if (const auto put = putStream(channel, stream); !put || isEmbedded())
        return put;
    const auto now = readStream(channel);
    if (!now)
        return tl::unexpected(now.error());
    const auto moved = movedBy(whole);
    for (const ParameterChange &change : configurationOf(stream).changesTo(configurationOf(*now))) {
        if (!moved.contains(change.spec->key))
            return failure(ErrorCode::VerifyFailed,
                           u"%1 is %2 instead of %3"_s.arg(change.spec->key, change.spec->format(change.to),
                                                           change.spec->format(change.from)));
    }
    return {};
}

// A script with an input runs at once (errata 13, row 18).
QMap<QString, QString> Device::movedBy(const Configuration &inUse) const
{
    QMap<QString, QString> moved;
    const QByteArray area = inUse.block({0, Scripts});
    const ScriptContext context = scriptContext(*m_parameters, m_firmware);
    for (int script = 0; script < kScriptCount && !area.isEmpty(); ++script) {
        const ParameterSpec *input = m_parameters->find(u"script%1.input"_s.arg(script + 1));
        if (!input || inUse.raw(*input, 0).value_or(0) == 0)
            continue;
        const ScriptEffect effect = scriptEffect(area, script, context);
        for (const ParameterSpec &spec : m_parameters->all()) {
            const bool isSet = std::find(effect.parameters.begin(), effect.parameters.end(), spec.offset / 2)
                != effect.parameters.end();
            if (spec.row->block == Parameters && (effect.all || isSet))
                moved.insert(spec.key, u"script %1"_s.arg(script + 1));
        }
    }
    return moved;
}

}  // namespace storm32
