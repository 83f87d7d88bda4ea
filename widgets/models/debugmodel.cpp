// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/debugmodel.h"

#include "protocol/client/whendone.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"

#include <cmath>
#include <limits>

using namespace Qt::StringLiterals;

namespace {

QString variableText(double value)
{
    return std::isnan(value) ? u"–"_s : shortNumberText(value, 7);
}

struct DebugRead
{
    std::vector<DebugVariable> variables;  // empty when they were known
    std::vector<std::vector<double>> values;
    TimePoint at{};
};

}  // namespace

DebugModel::DebugModel(DeviceClient &client, QObject *parent)
    : TableModel({tr("Variable"), tr("Type"), tr("Axis"), tr("Now"), tr("Lowest"), tr("Highest")}, parent)
    , m_client(client)
{
}

void DebugModel::reset()
{
    resetWith([this] {
        m_rows.clear();
        m_listed = m_asking = false;
        ++m_generation;
    });
}

void DebugModel::refresh()
{
    if (m_asking || !m_client.isConnected() || !m_client.device()->innerVariables())
        return;
    m_asking = true;
    whenDone(
        m_client.submit<DebugRead>([list = !m_listed](Channel &channel, Device &device) -> Result<DebugRead> {
            DebugRead read;
            if (list) {
                const auto variables = device.innerVariables()->debugVariables(channel);
                if (!variables)
                    return tl::unexpected(variables.error());
                read.variables = *variables;
            }
            const auto values = device.innerVariables()->readDebugVariables(channel);
            if (!values)
                return tl::unexpected(values.error());
            read.values = *values;
            read.at = Clock::now();
            return read;
        }),
        this, [this, generation = m_generation](const Result<DebugRead> &read) {
            if (generation != m_generation)
                return;
            m_asking = false;
            if (!read) {
                emit failed(read.error());
                return;
            }
            if (!m_listed)
                resetWith([&] { setVariables(read->variables); });
            setValues(read->values, read->at);
            emit refreshed();
        });
}

void DebugModel::setVariables(const std::vector<DebugVariable> &variables)
{
    m_rows.clear();
    for (const DebugVariable &variable : variables) {
        for (int element = 0; element < variable.elements; ++element) {
            Row row;
            row.name = variable.elements > 1 ? u"%1[%2]"_s.arg(variable.name).arg(element) : variable.name;
            row.type = variable.type.section(u'[', 0, 0);
            row.axis = variable.axis;
            row.known = row.type != u"?"_s;
            row.value = row.low = row.high = std::numeric_limits<double>::quiet_NaN();
            m_rows.push_back(std::move(row));
        }
    }
    QList<int> channels;
    m_names.clear();
    m_table.clear();
    for (const Row &row : m_rows) {
        m_names.push_back(row.name.toUtf8());
        channels.append(int(channels.size()));
    }
    for (std::size_t i = 0; i < m_rows.size(); ++i)
        m_table.push_back({m_names[i].constData(), m_names[i].constData(), "", "", 3, m_rows[i].axis, -1, 1});
    m_store = std::make_shared<TelemetryStore>(int(m_rows.size()));
    m_group = m_store->defineGroup(channels, 0.0);
    m_listed = true;
}

void DebugModel::setValues(const std::vector<std::vector<double>> &values, TimePoint time)
{
    std::vector<float> sample(m_rows.size(), std::numeric_limits<float>::quiet_NaN());
    std::size_t at = 0;
    for (const std::vector<double> &elements : values) {
        for (const double value : elements) {
            if (at >= m_rows.size())
                break;
            sample[at] = float(value);
            Row &row = m_rows[at++];
            row.value = value;
            row.low = std::isnan(row.low) ? value : std::min(row.low, value);
            row.high = std::isnan(row.high) ? value : std::max(row.high, value);
        }
    }
    if (m_group)
        m_store->append(*m_group, time, sample);
    tellAllChanged(ValueColumn, HighColumn, {Qt::DisplayRole});
}

void DebugModel::clearBounds()
{
    for (Row &row : m_rows)
        row.low = row.high = row.value;
    tellAllChanged(ValueColumn, HighColumn, {Qt::DisplayRole});
}

QString DebugModel::name(int row) const
{
    return m_rows[std::size_t(row)].name;
}

QVariant DebugModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    const Row &row = m_rows[std::size_t(index.row())];
    if (role == Qt::TextAlignmentRole && index.column() >= ValueColumn)
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    switch (index.column()) {
    case NameColumn: return row.name;
    case TypeColumn: return row.known ? row.type : tr("unknown type");
    case AxisColumn: return row.axis == Axis::None ? QString() : axisLabel(row.axis);
    case ValueColumn: return variableText(row.value);
    case LowColumn: return variableText(row.low);
    case HighColumn: return variableText(row.high);
    default: return {};
    }
}
