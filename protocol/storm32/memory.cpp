// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What is in use and what is stored (errata 3.4, 4, 13): a board answers with the former and stores all of
// it.
#include "protocol/session/channel.h"
#include "protocol/storm32/device.h"
#include "protocol/storm32/parametertables.h"
#include "protocol/storm32/scripts.h"

#include <algorithm>
#include <tuple>

using namespace Qt::StringLiterals;

namespace storm32 {

namespace {

constexpr int kAwakeState = 6;
constexpr auto kFallingAsleep = 1s;
constexpr auto kWakingUp = 3s;
constexpr int kLoads = 3;
constexpr qsizetype kFew = 8;  // words that are asked one by one

int wordAt(const QByteArray &stream, int word)
{
    return ByteReader(QByteArrayView(stream).sliced(2 * word, 2)).u16();
}

void setWord(QByteArray &stream, int word, int raw)
{
    stream.replace(2 * word, 2, ByteWriter().u16(raw & 0xFFFF).take());
}

// As a stop leaves them, and a board fresh from defaults.
bool areMotorsDisabled(const QByteArray &stream)
{
    for (int word = MotorStop::kFirstWord; word < MotorStop::kFirstWord + MotorStop::kWords; ++word) {
        if (stream.size() < 2 * word + 2 || wordAt(stream, word) != MotorStop::kDisabled)
            return false;
    }
    return true;
}

// What is not as wanted, but for what scripts move. @param value of a key, what was wanted and what is
// @param data of scripts and the like
QStringList otherThan(const Device &device, const Configuration &wanted, const Configuration &is,
                      const QString &value, const QString &data)
{
    const auto moved = device.movedBy(wanted);
    QStringList different;
    for (const ParameterChange &change : wanted.changesTo(is)) {
        if (!moved.contains(change.spec->key))
            different.append(value.arg(change.spec->key, change.spec->format(change.from),
                                       change.spec->format(change.to)));
    }
    for (const DataChange &change : wanted.dataChangesTo(is))
        different.append(data.arg(QLatin1String(change.spec->data)));
    return different;
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

// The firmware does not check them.
Result<void> Device::checkAdjustable(const AdjustableValue &wanted) const
{
    for (const ParameterSpec &spec : m_parameters->all()) {
        if (spec.row->block == Parameters && spec.offset == 2 * wanted.id && !spec.accepts(wanted.value))
            return failure(
                ErrorCode::OutOfRange,
                u"%1 = %2, allowed %3"_s.arg(spec.key, spec.format(wanted.value), spec.allowedText()));
    }
    return {};
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

// Values in use that differ from the stored ones, or from the defaults if those are not known; and the one
// that was marked, which may not be in use.
QString Device::inUseText(const QByteArray &inUse, const Result<QByteArray> &stored, int marked) const
{
    const Configuration use = configurationOf(inUse);
    const Configuration kept = stored ? configurationOf(*stored) : use;
    QStringList values;
    for (const ParameterSpec &spec : use.parameters().all()) {
        const auto raw = use.raw(spec, 0);
        const bool isMarked = spec.row->block == Parameters && spec.offset == 2 * marked;
        if (raw
            && (isMarked || !sameValue(*raw, stored ? kept.raw(spec, 0).value_or(*raw) : spec.defaultRaw)))
            values.append(u"%1=%2"_s.arg(spec.key, spec.format(*raw)));
    }
    return values.join(u' ');
}

// What is not in use any more, and what is instead; scripts and the like are named.
QString Device::lostText(const QByteArray &inUse, const QByteArray &now) const
{
    const Configuration before = configurationOf(inUse);
    const Configuration after = configurationOf(now);
    const QStringList lost = otherThan(*this, before, after, u"%1=%2 (%3 is in use now)"_s, u"%1"_s);
    return lost.join(u' ');
}

Result<int> Device::readState(Channel &channel)
{
    const auto reply = channel.transact(simple(Simple::Status));
    if (!reply)
        return tl::unexpected(reply.error());
    return ByteReader(reply->payload).u16();
}

// A board that has just left standby, or ends its start, is on its way (errata 3.7).
Result<int> Device::settledState(Channel &channel)
{
    auto state = readState(channel);
    for (const TimePoint until = channel.now() + kWakingUp;
         state && *state == kAwakeState - 1 && channel.now() < until;)
        state = readState(channel);
    return state;
}

// Loading would start motors that are stored otherwise. Motors that run would let the camera fall here, but
// there are none.
Result<bool> Device::enterStandby(Channel &channel, const QByteArray &inUse)
{
    if (!areMotorsDisabled(inUse))
        return false;
    const auto state = settledState(channel);
    if (!state)
        return tl::unexpected(state.error());
    if (isStandby(*state, m_firmware))
        return false;
    // Standby is ignored while the board starts (errata 13, row 1).
    if (*state != kAwakeState)
        return failure(ErrorCode::Unready,
                       u"the board is starting, with motors disabled; what is stored can be read once it "
                       "works normally"_s);
    if (const auto sent = channel.transact(standbyRequest(true)); !sent)
        return tl::unexpected(sent.error());
    const auto asleep = comesToStandby(channel, true);
    if (!asleep)
        return tl::unexpected(asleep.error());
    if (*asleep)
        return true;
    std::ignore = channel.transact(standbyRequest(false));  // nor shall it later
    return failure(ErrorCode::Unready, u"the board does not go into standby"_s);
}

Result<bool> Device::comesToStandby(Channel &channel, bool wanted)
{
    for (const TimePoint until = channel.now() + kFallingAsleep;;) {
        const auto state = readState(channel);
        if (!state)
            return tl::unexpected(state.error());
        if (isStandby(*state, m_firmware) == wanted)
            return true;
        if (channel.now() > until)
            return false;
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

// A gain that no script moves: a change by a count or two does no harm for the moment.
int Device::markableWord(const Configuration &inUse) const
{
    const auto moved = movedBy(inUse);
    for (const QString &key : {u"pid.pitch.p"_s, u"pid.roll.p"_s, u"pid.yaw.p"_s}) {
        if (const ParameterSpec *spec = m_parameters->find(key); spec && !moved.contains(key))
            return spec->offset / 2;
    }
    return -1;
}

Result<void> Device::proveLoading(Channel &channel, int word, const std::function<Result<int>()> &load)
{
    if (word < 0)
        return load().map([](int) {});
    const auto use = readWord(channel, word);
    if (!use)
        return tl::unexpected(use.error());
    for (const int mark : {*use > 2 ? *use - 1 : *use + 1, *use > 2 ? *use - 2 : *use + 2}) {
        if (const auto marked = writeWord(channel, word, mark); !marked)
            return marked;
        const auto now = load();
        if (!now)
            return tl::unexpected(now.error());
        if (*now != mark)
            return {};
    }
    std::ignore = writeWord(channel, word, *use);
    return failure(ErrorCode::VerifyFailed,
                   u"the board confirms that it loads what is stored, and what was in use stays"_s);
}

Result<void> Device::loadStored(Channel &channel)
{
    const auto inUse = readStream(channel);
    if (!inUse)
        return tl::unexpected(inUse.error());
    const int word = markableWord(configurationOf(*inUse));
    const Unbroken unbroken(channel);  // no mark is left behind
    return proveLoading(channel, word, [&]() -> Result<int> {
        if (const auto loaded = channel.transact(simple(Simple::Retrieve)); !loaded)
            return tl::unexpected(loaded.error());
        if (const auto way = findWay(channel, 1); !way)
            return tl::unexpected(way.error());
        return word < 0 ? Result<int>(0) : readWord(channel, word);
    });
}

Result<QByteArray> Device::readStored(Channel &channel, const QByteArray &inUse)
{
    if (const auto free = checkNotStopping(); !free)
        return tl::unexpected(free.error());
    const auto asleep = enterStandby(channel, inUse);
    if (!asleep)
        return tl::unexpected(asleep.error());
    const Unbroken unbroken(channel);
    QByteArray loaded;
    const int mark = markableWord(configurationOf(inUse));
    const auto proven = proveLoading(channel, mark, [&]() -> Result<int> {
        auto read = retrieve(channel);
        if (!read)
            return tl::unexpected(read.error());
        loaded = *std::move(read);
        return mark < 0 ? 0 : wordAt(loaded, mark);
    });
    auto stored = proven ? Result<QByteArray>(loaded) : tl::unexpected(proven.error());
    // A running script may set a value between loading and reading; hardly twice in a row.
    for (int i = 0; i < kLoads && stored && !movedBy(configurationOf(*stored)).isEmpty(); ++i) {
        auto again = retrieve(channel);
        const bool isSame = again && *again == *stored;
        stored = std::move(again);
        if (isSame)
            break;
    }
    if (stored)
        m_lastStored = configurationOf(*stored);
    // Put back even if loading seems to have failed: perhaps only its answer was lost. A heartbeat, which
    // would lock plain commands out, follows once the rest is read back.
    const int heartbeat = wordAt(inUse, kHeartbeatWord);
    QByteArray silent = inUse;
    setWord(silent, kHeartbeatWord, 0);
    const auto put = putStream(channel, silent);
    const auto back = readStream(channel);  // whatever became of the answer
    if (heartbeat != 0) {
        if (const auto on = writeWord(channel, kHeartbeatWord, heartbeat); !on)
            return failure(ErrorCode::NotRestored,
                           u"mavlink.heartbeat=%1; "_s.arg(heartbeat) + on.error().detail);
    }
    if (!back)
        return failure(ErrorCode::NotRestored,
                       inUseText(inUse, stored, mark) + (*asleep ? u"; the board is in standby; "_s : u"; "_s)
                           + (put ? back.error().detail : put.error().detail));
    if (const QString lost = lostText(silent, *back); !lost.isEmpty())
        return failure(ErrorCode::NotRestored, lost + (*asleep ? u"; the board is in standby"_s : QString()));
    if (*asleep) {
        const auto sent = channel.transact(standbyRequest(false));
        const auto woken = sent ? comesToStandby(channel, false) : Result<bool>(tl::unexpected(sent.error()));
        if (!woken || !*woken)
            return failure(ErrorCode::NotRestored,
                           u"the board stays in standby"_s
                               + (woken ? QString() : u"; "_s + woken.error().detail));
    }
    return stored;
}

// A whole stream does not fit into MAVLink (errata 6), so the heartbeat is off in RAM meanwhile.
Result<WholeMemory::Contents> Device::readBoth(Channel &channel)
{
    m_lastStored.reset();
    if (!isKnownLayout(m_identity.firmwareNumber))
        return failure(ErrorCode::Unsupported, u"the board's memory is not known"_s);
    if (const auto free = checkNotStopping(); !free)
        return tl::unexpected(free.error());
    if (!isEmbedded())
        return readBothPlain(channel, {});
    const auto heartbeat = readWord(channel, kHeartbeatWord);
    if (!heartbeat)
        return tl::unexpected(heartbeat.error());
    const int way = m_way;
    const auto off = writeWord(channel, kHeartbeatWord, 0);
    if (!off)
        m_way = way;
    auto both = off ? readBothPlain(channel, *heartbeat)
                    : Result<Contents>(failure(ErrorCode::Unsupported,
                                               u"what is stored cannot be read while the heartbeat is on"_s));
    if (isEmbedded() && off)
        return both;  // it was put back with everything else
    if (const auto on = writeWord(channel, kHeartbeatWord, *heartbeat); !on)
        return failure(ErrorCode::NotRestored, u"mavlink.heartbeat=%1"_s.arg(*heartbeat));
    return both;
}

Result<WholeMemory::Contents> Device::readBothPlain(Channel &channel, std::optional<int> heartbeat)
{
    auto inUse = readStream(channel);
    if (!inUse)
        return tl::unexpected(inUse.error());
    if (heartbeat)
        setWord(*inUse, kHeartbeatWord, *heartbeat);
    const auto specOf = [this](int word) {
        return std::find_if(m_parameters->all().begin(), m_parameters->all().end(),
                            [word](const ParameterSpec &each) {
                                return each.row->block == Parameters && each.offset == 2 * word;
                            });
    };
    const auto differs = [&specOf](int word, int use, int kept) {
        const auto spec = specOf(word);
        return failure(ErrorCode::ConditionUnmet,
                       u"%1 is %2 in use and %3 where it is stored"_s.arg(spec->key, spec->format(use),
                                                                          spec->format(kept)));
    };
    // A motor that runs, but is stored as disabled, must not let its axis fall, nor one that is disabled
    // start: such a word is asked alone. Where no motor runs, standby keeps them so.
    const bool isStill = areMotorsDisabled(*inUse);
    for (int word = MotorStop::kFirstWord; word < MotorStop::kFirstWord + MotorStop::kWords && !isStill;
         ++word) {
        const int use = wordAt(*inUse, word);
        const Unbroken unbroken(channel);
        const auto asked = channel.transact(rc(Rc::RestoreParameter, ByteWriter().u16(word).take()));
        // Put back even if that seems to have failed: perhaps only its answer was lost.
        const auto kept = asked ? readWord(channel, word) : Result<int>(tl::unexpected(asked.error()));
        const bool isSame = kept && *kept == use;
        if (const auto back = isSame ? Result<void>() : writeWord(channel, word, use); !back)
            return failure(ErrorCode::NotRestored,
                           u"%1=%2; "_s.arg(specOf(word)->key, specOf(word)->format(use))
                               + back.error().detail);
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

// See enterStandby(): a board that starts, and holds its motors disabled, does not tell what it has stored.
Result<void> Device::checkUse(Channel &channel, const Configuration &whole)
{
    if (!areMotorsDisabled(whole.block({0, Parameters})))
        return {};
    const auto state = settledState(channel);
    if (!state)
        return tl::unexpected(state.error());
    if (isStandby(*state, m_firmware) || *state == kAwakeState)
        return {};
    return failure(ErrorCode::Unready,
                   u"the board is starting; all motors can be stored as disabled once it works normally"_s);
}

// A heartbeat, which would lock plain commands out, follows once the rest is read back.
Result<void> Device::use(Channel &channel, const Configuration &whole)
{
    QByteArray stream;
    for (const int block : {Parameters, Scripts})
        stream += whole.block({0, block});
    const int heartbeat = wordAt(stream, kHeartbeatWord);
    setWord(stream, kHeartbeatWord, 0);
    if (const auto put = putStream(channel, stream); !put)
        return put;
    const auto now = readStream(channel);
    if (!now)
        return tl::unexpected(now.error());
    QStringList different = otherThan(*this, configurationOf(stream), configurationOf(*now),
                                      u"%1 is %3 instead of %2"_s, u"%1 are others"_s);
    if (heartbeat != 0) {
        if (const auto on = writeWord(channel, kHeartbeatWord, heartbeat); !on)
            different.append(u"mavlink.heartbeat=%1; "_s.arg(heartbeat) + on.error().detail);
    }
    return different.isEmpty() ? Result<void>()
                               : failure(ErrorCode::VerifyFailed, different.mid(0, 8).join(u"; "_s));
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
