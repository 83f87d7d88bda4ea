// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/adjustablemodel.h"

#include "protocol/client/whendone.h"
#include "protocol/configuration/leap.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"

#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;

AdjustableModel::AdjustableModel(DeviceClient &client, QObject *parent)
    : TableModel(
        {tr("No."), tr("Variable"), tr("Group"), tr("In use"), tr("Meaning"), tr("Range"), tr("Key")}, parent)
    , m_client(client)
{
}

void AdjustableModel::reset()
{
    resetWith([this] {
        const LiveAccess *live = m_client.device() ? m_client.device()->live() : nullptr;
        m_specs = live ? live->adjustables() : std::span<const AdjustableSpec>();
        m_parameters = m_client.device() ? m_client.device()->parameters() : nullptr;
        m_values.assign(m_specs.size(), {});
        m_behind.assign(m_specs.size(), nullptr);
        m_asking = false;
        if (const QString serial = m_client.identity().serial; std::exchange(m_serial, serial) != serial)
            m_refused.clear();
        for (std::size_t row = 0; row < m_specs.size(); ++row) {
            for (const ParameterSpec &spec : m_parameters->all()) {
                if (spec.adjustable == m_specs[row].id)
                    m_behind[row] = &spec;
            }
        }
    });
}

void AdjustableModel::refresh()
{
    if (m_asking || !m_client.isConnected() || m_specs.empty())
        return;
    m_asking = true;
    QList<int> ids;
    for (const AdjustableSpec &spec : m_specs)
        ids.append(spec.id);
    whenDone(m_client.submit<std::vector<AdjustableValue>>([ids](Channel &channel, Device &device) {
        return device.live()->readAdjustables(channel, ids);
    }),
             this, [this, asked = m_specs.data()](const Result<std::vector<AdjustableValue>> &read) {
                 m_asking = false;
                 if (asked != m_specs.data())
                     return;
                 if (!read) {
                     emit failed(read.error());
                     return;
                 }
                 int first = -1;
                 int last = -1;
                 for (const AdjustableValue &variable : *read) {
                     for (std::size_t row = 0; row < m_specs.size(); ++row) {
                         const double value = isFloat(int(row)) ? variable.value : std::trunc(variable.value);
                         if (m_specs[row].id != variable.id || sameValue(m_values[row], value))
                             continue;
                         m_values[row] = value;
                         first = first < 0 ? int(row) : std::min(first, int(row));
                         last = std::max(last, int(row));
                     }
                 }
                 if (first >= 0)
                     emit dataChanged(index(first, ValueColumn), index(last, MeaningColumn));
             });
}

bool AdjustableModel::isFloat(int row) const
{
    const ParameterSpec *behind = m_behind[std::size_t(row)];
    return behind && behind->row->wire == WireType::F32;
}

QModelIndex AdjustableModel::refusedCell() const
{
    for (int row = 0; row < rows(); ++row) {
        if (m_refused.contains(keyOf(row)))
            return index(row, ValueColumn);
    }
    return {};
}

QString AdjustableModel::meaning(int row) const
{
    const ParameterSpec *behind = m_behind[std::size_t(row)];
    const auto value = m_values[std::size_t(row)];
    if (!behind || !value)
        return {};
    const QString text = parameterValueText(*behind, behind->rawOf(*value));
    return u"%1: %2"_s.arg(parameterLabel(*behind), text);
}

QVariant AdjustableModel::data(const QModelIndex &index, int role) const
{
    if (!index.isValid())
        return {};
    const AdjustableSpec &spec = m_specs[std::size_t(index.row())];
    const auto value = m_values[std::size_t(index.row())];
    if (role == IdRole)
        return spec.id;
    if (role == SearchRole)
        return u"%1 %2 %3 %4"_s.arg(spec.id)
            .arg(tableText(spec.label), QLatin1String(spec.key), tableText(spec.group))
            .toLower();
    if (role == Qt::TextAlignmentRole && (index.column() == ValueColumn || index.column() == NumberColumn))
        return QVariant(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::EditRole && index.column() == ValueColumn)
        return value ? QVariant(*value) : QVariant();
    if (role == NumberRole && index.column() == ValueColumn) {
        const int decimals = isFloat(index.row()) ? m_behind[std::size_t(index.row())]->row->decimals : 0;
        return value ? QVariant::fromValue(NumberRange{spec.min, spec.max, decimals}) : QVariant();
    }
    if (role == RefusedRole && index.column() == ValueColumn) {
        const auto refused = m_refused.find(keyOf(index.row()));
        return refused == m_refused.end() ? QVariant() : QVariant(*refused);
    }
    if (role == Qt::ToolTipRole && index.column() == ValueColumn)
        return tr("Takes effect at once, in volatile memory, from %1 to %2")
            .arg(numberText(plainNumber(spec.min)), numberText(plainNumber(spec.max)));
    if (role != Qt::DisplayRole)
        return {};
    switch (index.column()) {
    case NumberColumn: return spec.id;
    case NameColumn: return tableText(spec.label);
    case GroupColumn: return tableText(spec.group);
    case ValueColumn:  // all digits of a fraction would only be cut off
        return !value                      ? u"–"_s
            : *value == std::trunc(*value) ? numberText(plainNumber(*value))
                                           : shortNumberText(*value);
    case MeaningColumn: return meaning(index.row());
    case RangeColumn:
        return tr("%1 to %2").arg(numberText(plainNumber(spec.min)), numberText(plainNumber(spec.max)));
    case KeyColumn: return QLatin1String(spec.key);
    default: return {};
    }
}

bool AdjustableModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if (role == RefusedRole && index.column() == ValueColumn) {
        if (value.isValid())
            m_refused.insert(keyOf(index.row()), value.toString());
        else
            m_refused.remove(keyOf(index.row()));
        emit dataChanged(index, index);
        return true;
    }
    if (role != Qt::EditRole || index.column() != ValueColumn || m_held)
        return false;
    if (!m_client.isConnected()) {
        emit failed({ErrorCode::NotConnected, {}, 0});
        return false;
    }
    const AdjustableSpec &spec = m_specs[std::size_t(index.row())];
    const double wanted
        = value.userType() == QMetaType::Double ? value.toDouble() : typedNumber(value.toString());
    if (std::isnan(wanted) || (!isFloat(index.row()) && wanted != std::trunc(wanted)) || wanted < spec.min
        || wanted > spec.max) {
        emit failed({ErrorCode::OutOfRange,
                     tr("%1: %2 to %3")
                         .arg(tableText(spec.label), numberText(plainNumber(spec.min)),
                              numberText(plainNumber(spec.max))),
                     0});
        return false;
    }
    const ParameterSpec *behind = m_behind[std::size_t(index.row())];
    if (const double now = m_values[std::size_t(index.row())].value_or(0);
        behind && isLeap(*behind, behind->rawOf(now), behind->rawOf(wanted))) {
        emit leapt({behind, 0, behind->rawOf(now), behind->rawOf(wanted)});
        return false;
    }
    write(spec.id, wanted);
    return true;
}

void AdjustableModel::agree(const ParameterChange &change)
{
    if (!m_held)
        write(change.spec->adjustable, change.to * change.spec->row->adjustableScale);
}

void AdjustableModel::write(int id, double value)
{
    whenDone(m_client.submit<bool>([id, value](Channel &channel, Device &device) -> Result<bool> {
        const auto done = device.live()->writeAdjustables(channel, {{id, value}});
        return done ? Result<bool>(true) : tl::unexpected(done.error());
    }),
             this, [this, id, value](const Result<bool> &done) {
                 if (!done)
                     emit failed(done.error());
                 else
                     emit written(id, value);
                 refresh();  // the value that the board accepted
             });
}

Qt::ItemFlags AdjustableModel::flags(const QModelIndex &index) const
{
    Qt::ItemFlags flags = TableModel::flags(index);
    if (index.isValid() && index.column() == ValueColumn && m_client.isConnected() && !m_held
        && m_client.identity().writable)
        flags |= Qt::ItemIsEditable;
    return flags;
}
