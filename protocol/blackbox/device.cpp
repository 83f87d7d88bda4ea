// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/blackbox/device.h"

#include "protocol/blackbox/framer.h"
#include "protocol/blackbox/table.h"
#include "protocol/session/channel.h"
#include "protocol/session/stopplan.h"
#include "protocol/telemetry/telemetryplan.h"

using namespace Qt::StringLiterals;

namespace blackbox {

namespace {

constexpr auto kAnswer = 500ms;
constexpr double kSlowest = 1;  // rows per second that are expected

// A configuration needs a block to be one.
constexpr BlockSpec kBlocks[] = {{.id = 0, .name = "BLACKBOX", .size = 1}};

std::shared_ptr<const ParameterSet> parametersOf(const BoardIdentity &)
{
    return std::make_shared<ParameterSet>(std::span<const ParameterRow>(), kBlocks, 0, Capabilities());
}

Request question()
{
    Request request;
    request.name = u"names"_s;
    request.bytes = blackboxwire::kQuestion;
    request.answer = [](const FrameView &frame) -> std::optional<Result<Frame>> {
        return frame.id == Framer::NamesFrame ? std::optional(Result<Frame>(Frame(frame))) : std::nullopt;
    };
    request.timeout = kAnswer;
    request.idempotent = true;
    return request;
}

/// Rows of each name, as they come.
class Decoder final : public TelemetryDecoder
{
public:
    explicit Decoder(const Table *table)
        : m_table(table)
    {
    }

    void decode(const FrameView &frame, TimePoint at, TelemetryStore &store) override
    {
        if (frame.id != Framer::RowFrame || !m_table)
            return;
        const QByteArrayView line(reinterpret_cast<const char *>(frame.payload.data()),
                                  qsizetype(frame.payload.size()));
        const qsizetype comma = line.indexOf(',');
        const Table::Columns *columns = comma < 0 ? nullptr : m_table->find(line.first(comma));
        if (!columns || columns->channels.isEmpty())
            return;
        std::vector<float> values = BlackBox::numbers(line.sliced(comma + 1));
        values.resize(std::size_t(columns->channels.size()), std::numeric_limits<float>::quiet_NaN());
        auto &group = m_groups[columns];
        if (!group)
            group = store.defineGroup(columns->channels, 0);
        store.append(*group, at, values);
    }

private:
    const Table *m_table;
    std::map<const Table::Columns *, std::shared_ptr<TelemetryGroup>> m_groups;
};

}  // namespace

Result<bool> Device::probe(Channel &channel)
{
    const auto names = channel.transact(question());
    if (!names && names.error().code != ErrorCode::Timeout)
        return tl::unexpected(names.error());
    return names.has_value();
}

Result<BoardIdentity> Device::identify(Channel &channel)
{
    const auto told = channel.transact(question());
    if (!told)
        return tl::unexpected(told.error());
    const auto names = blackboxwire::readNames(told->payload);
    if (!names)
        return failure(ErrorCode::BadReply, u"names"_s);
    m_table = &tableOf(*names);
    m_identity.family = QLatin1String(blackboxwire::kFamily);
    m_identity.model = u"Black box of a drone"_s;
    m_identity.firmware = u"?"_s;
    m_identity.serial = u"blackbox"_s;
    m_identity.writable = false;
    return m_identity;
}

std::shared_ptr<const ParameterSet> Device::parameters() const
{
    static const auto none = parametersOf({});
    return none;
}

Result<Configuration> Device::readConfiguration(Channel &)
{
    Configuration configuration(m_identity, parameters());
    configuration.setBlock({0, 0}, QByteArray(1, '\0'));
    return configuration;
}

Result<QByteArray> Device::readBlock(Channel &, BlockKey)
{
    return QByteArray(1, '\0');
}

Result<void> Device::writeBlock(Channel &, BlockKey, const QByteArray &)
{
    return failure(ErrorCode::ReadOnly);
}

Result<ActionReply> Device::perform(Channel &, const QString &key, const QVariantMap &)
{
    return failure(ErrorCode::Unsupported, key);
}

ChannelTable Device::channels() const
{
    return m_table ? ChannelTable(m_table->channels) : ChannelTable();
}

Result<TelemetryPlan> Device::subscribe(Channel &, const Subscription &subscription,
                                        std::optional<LineSettings>)
{
    if (!subscription.streams.isEmpty())
        return failure(ErrorCode::InvalidArgument, u"a black box has no streams"_s);
    TelemetryPlan plan;
    plan.decoder = replayDecoder();
    plan.rate = kSlowest;
    plan.isStreamedUnasked = true;
    return plan;
}

std::shared_ptr<TelemetryDecoder> Device::replayDecoder() const
{
    return std::make_shared<Decoder>(m_table);
}

StopPlan Device::stopPlan() const
{
    return {};
}

Family family()
{
    Family family;
    family.key = QLatin1String(blackboxwire::kFamily);
    family.name = u"Black box"_s;
    family.nouns.load = "drone";
    family.makeFramer = [] { return std::make_unique<Framer>(); };
    family.makeDevice = [] { return std::make_unique<Device>(); };
    family.makeParameters = parametersOf;
    return family;
}

}  // namespace blackbox
