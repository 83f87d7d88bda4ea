// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/parametermodel.h"

#include "widgets/models/numbertext.h"
#include "widgets/models/refusedtexts.h"

#include <QCoreApplication>

using namespace Qt::StringLiterals;

QString tableText(const char *text)
{
    return withNumbers(QCoreApplication::translate("Tables", text));
}

QString axisLabel(Axis axis)
{
    switch (axis) {
    case Axis::Roll: return QCoreApplication::translate("Tables", "Roll");
    case Axis::Pitch: return QCoreApplication::translate("Tables", "Pitch");
    case Axis::Yaw: return QCoreApplication::translate("Tables", "Yaw");
    case Axis::None: break;
    }
    return {};
}

QString parameterLabel(const ParameterSpec &spec, bool withAxis)
{
    QString label = tableText(spec.row->label);
    if (spec.index >= 0)
        label = label.arg(spec.index);
    if (withAxis && spec.axis != Axis::None)
        label += u" · "_s + axisLabel(spec.axis);
    return label;
}

QString profileLabel(const Configuration &configuration, int profile)
{
    const QString name = configuration.profileNames().value(profile).trimmed();
    return name.isEmpty() ? QCoreApplication::translate("Tables", "Profile %1").arg(profile + 1) : name;
}

QString changePlace(const Configuration &configuration, const ParameterChange &change)
{
    const bool isOfOne
        = change.spec->row->scope == Scope::Profile && configuration.identity().profileCount > 1;
    return isOfOne ? profileLabel(configuration, change.profile) + u": "_s : QString();
}

QStringList changePlaces(const ConfigurationModel &model, const QMap<int, int> &counts)
{
    QStringList places;
    if (model.isEmpty() || model.board().identity().profileCount < 2)
        return places;
    for (auto each = counts.begin(); each != counts.end(); ++each) {
        const QString where = each.key() == ConfigurationModel::kAllProfiles
            ? QCoreApplication::translate("Tables", "all profiles")
            : profileLabel(model.edited(), each.key());
        places.append(u"%1: %2"_s.arg(where).arg(each.value()));
    }
    return places;
}

QString choicesText(std::span<const Choice> choices, double raw, bool areBits)
{
    QStringList names;
    for (const Choice &choice : choices) {
        if (areBits ? (flagBits(raw) & (1U << choice.value)) != 0 : choice.value == raw)
            names.append(tableText(choice.name));
    }
    if (areBits)
        return names.isEmpty() ? QCoreApplication::translate("Tables", "None") : names.join(u", "_s);
    return names.join(u" / "_s);
}

QString parameterValueText(const ParameterSpec &spec, double raw)
{
    if (std::isnan(raw))
        return QCoreApplication::translate("Tables", "no number");
    switch (spec.row->kind) {
    case ValueKind::Toggle:
        return raw != 0 ? QCoreApplication::translate("Tables", "On")
                        : QCoreApplication::translate("Tables", "Off");
    case ValueKind::Choice: {
        const QString name = choicesText(spec.row->choices, raw, false);
        return name.isEmpty() ? QString::number(qint64(raw)) : name;
    }
    case ValueKind::Flags: return choicesText(spec.row->choices, raw, true);
    case ValueKind::Number: break;
    }
    return numberText(spec.rounded(raw));
}

QString parameterQuantityText(const ParameterSpec &spec, double raw)
{
    const QString text = parameterValueText(spec, raw);
    return *spec.row->unit && !std::isnan(raw) ? text + u' ' + QString::fromUtf8(spec.row->unit) : text;
}

QString unknownText()
{
    return QCoreApplication::translate("Tables", "not known");
}

QString parameterRangeText(const ParameterSpec &spec)
{
    if (spec.row->kind != ValueKind::Number)
        return {};
    QString text = QCoreApplication::translate("Tables", "%1 to %2")
                       .arg(numberText(spec.rounded(spec.row->min)), numberText(spec.rounded(spec.row->max)));
    if (*spec.row->unit)
        text += u' ' + QString::fromUtf8(spec.row->unit);
    return text;
}

QString inactiveReason(const ConfigurationModel &configuration, const ParameterSpec &spec, int profile)
{
    const QString key = spec.inactiveKey();
    const ParameterSpec *other = key.isEmpty() ? nullptr : configuration.edited().parameters().find(key);
    if (!other || !sameValue(configuration.value(*other, profile), spec.row->inactive.value))
        return {};
    return QCoreApplication::translate("Tables", "No effect while “%1” is “%2”.")
        .arg(parameterLabel(*other), parameterValueText(*other, spec.row->inactive.value));
}

QString contradictionText(const ConfigurationModel &configuration, const ParameterSpec &spec, int profile)
{
    const auto [rule, other] = configuration.edited().findContradiction(spec, profile);
    if (!rule)
        return {};
    const QString why = tableText(rule->why);
    if (!other)
        return QCoreApplication::translate("Tables", "⚠ Not possible: %1.").arg(why);
    return QCoreApplication::translate("Tables", "⚠ Contradicts “%1” (%2): %3.")
        .arg(parameterLabel(*other),
             parameterValueText(*other, configuration.value(*other, profile).value_or(0)), why);
}

QString parameterSearchText(const ParameterSpec &spec)
{
    return (parameterLabel(spec) + u' ' + spec.key + u' ' + tableText(spec.row->group) + u' '
            + tableText(spec.row->help))
        .toLower();
}

ParameterModel::ParameterModel(ConfigurationModel &configuration, RefusedTexts *refused, QObject *parent)
    : TableModel(
        {tr("Parameter"), tr("Value"), tr("Unit"), tr("On the board"), tr("Default"), tr("Range"), tr("Key")},
        parent)
    , m_configuration(configuration)
    , m_refused(refused)
{
    connect(&m_configuration, &ConfigurationModel::boardReset, this, &ParameterModel::reset);
    connect(&m_configuration, &ConfigurationModel::shownProfileChanged, this,
            [this] { tellAllChanged(0, ColumnCount - 1); });
    connect(&m_configuration, &ConfigurationModel::valueChanged, this, [this](int parameter) {
        if (parameter < m_rows)
            emit dataChanged(index(parameter, 0), index(parameter, ColumnCount - 1));
    });
    if (m_refused)
        connect(m_refused, &RefusedTexts::changed, this, [this] {
            // Otherwise this is another board, and the model is about to learn of it.
            if (!m_configuration.isEmpty()
                && m_rows == int(m_configuration.edited().parameters().all().size()))
                tellAllChanged(ValueColumn, ValueColumn);
        });
    reset();
}

void ParameterModel::reset()
{
    resetWith([this] {
        m_rows = m_configuration.isEmpty() ? 0 : int(m_configuration.board().parameters().all().size());
    });
}

const ParameterSpec &ParameterModel::specAt(int row) const
{
    return m_configuration.edited().parameters().at(row);
}

QVariant ParameterModel::data(const QModelIndex &index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const ParameterSpec &spec = specAt(index.row());
    const int profile = m_configuration.shownProfile();
    const auto value = m_configuration.value(spec, profile);
    switch (role) {
    case IdRole: return spec.id;
    case ChangedRole: return m_configuration.isChanged(spec, profile);
    case RedRole: return spec.row->risk == Risk::Red;
    case DiffersFromDefaultRole: return value && !spec.row->state && !sameValue(*value, spec.defaultRaw);
    case LevelRole: return int(spec.row->level);
    case SearchRole: return parameterSearchText(spec);
    case GroupRole: return tableText(spec.row->group);
    case Qt::ToolTipRole: return tableText(spec.row->help);
    case Qt::TextAlignmentRole:
        if (index.column() == ValueColumn || index.column() == BoardColumn || index.column() == DefaultColumn)
            return QVariant(Qt::AlignRight | Qt::AlignVCenter);
        return {};
    case Qt::EditRole: {
        const bool isNumber = spec.row->kind == ValueKind::Number;
        return index.column() == ValueColumn && value
            ? QVariant(isNumber ? numberText(spec.format(*value)) : spec.format(*value))
            : QVariant();
    }
    case NumberRole:
        return index.column() == ValueColumn && spec.row->kind == ValueKind::Number
            ? QVariant::fromValue(
                NumberRange{spec.toDisplay(spec.row->min), spec.toDisplay(spec.row->max), spec.row->decimals})
            : QVariant();
    case RefusedRole: {
        const auto text
            = m_refused && index.column() == ValueColumn ? m_refused->text(spec, profile) : std::nullopt;
        return text ? QVariant(*text) : QVariant();
    }
    case Qt::DisplayRole: break;
    default: return {};
    }
    switch (index.column()) {
    case NameColumn: return parameterLabel(spec);
    case ValueColumn: return value ? parameterValueText(spec, *value) : QString();
    case UnitColumn: return QString::fromUtf8(spec.row->unit);
    case BoardColumn: {
        const auto board = m_configuration.boardValue(spec, profile);
        if (board && m_configuration.board().findMissing(spec, profile))
            return unknownText();
        return board ? parameterValueText(spec, *board) : QString();
    }
    case DefaultColumn: return spec.row->state ? QString() : parameterValueText(spec, spec.defaultRaw);
    case RangeColumn: return parameterRangeText(spec);
    case KeyColumn: return spec.key;
    default: return {};
    }
}

bool ParameterModel::setData(const QModelIndex &index, const QVariant &value, int role)
{
    if ((role != Qt::EditRole && role != RefusedRole) || index.column() != ValueColumn)
        return false;
    const ParameterSpec &spec = specAt(index.row());
    if (role == RefusedRole) {
        if (m_refused)
            m_refused->set(spec, m_configuration.shownProfile(),
                           value.isValid() ? std::optional(value.toString()) : std::nullopt);
        return m_refused;
    }
    const double number
        = value.userType() == QMetaType::Double ? value.toDouble() : typedNumber(value.toString());
    const auto raw = spec.row->kind == ValueKind::Number && !std::isnan(number)
        ? std::optional(spec.toRaw(number))
        : spec.parse(value.toString());
    if (!raw || !spec.accepts(*raw)) {
        emit refused(spec.id, value.toString());
        return false;
    }
    emit editRequested(spec.id, *raw);
    return true;
}

Qt::ItemFlags ParameterModel::flags(const QModelIndex &index) const
{
    Qt::ItemFlags flags = TableModel::flags(index);
    if (index.isValid() && index.column() == ValueColumn && !specAt(index.row()).row->state)
        flags |= Qt::ItemIsEditable;
    return flags;
}
