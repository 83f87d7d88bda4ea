// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/models/configurationmodel.h"
#include "widgets/models/tablemodel.h"

class RefusedTexts;

/// Before what changed in one of several profiles, "Studio: "; empty for what is the same in all of them.
[[nodiscard]] QString changePlace(const Configuration &configuration, const ParameterChange &change);
/// "Studio: 2", "all profiles: 1", in the order of the profiles. Empty for a board with one profile.
[[nodiscard]] QStringList changePlaces(const ConfigurationModel &model, const QMap<int, int> &counts);

/// All parameters of the shown profile as rows.
class ParameterModel final : public TableModel
{
    Q_OBJECT
public:
    enum Column {
        NameColumn,
        ValueColumn,
        UnitColumn,
        BoardColumn,
        DefaultColumn,
        RangeColumn,
        KeyColumn,
        ColumnCount
    };
    enum Role {
        IdRole = Qt::UserRole,
        ChangedRole,
        RedRole,
        DiffersFromDefaultRole,
        LevelRole,
        SearchRole,
        GroupRole
    };

    /// @param refused where texts are kept that are no values; without it they are not
    explicit ParameterModel(ConfigurationModel &configuration, RefusedTexts *refused = nullptr,
                            QObject *parent = nullptr);

    [[nodiscard]] QVariant data(const QModelIndex &index, int role = Qt::DisplayRole) const override;
    bool setData(const QModelIndex &index, const QVariant &value, int role = Qt::EditRole) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex &index) const override;

signals:
    /// Somebody typed a value; whoever owns the undo stack makes an edit of it.
    void editRequested(int parameter, double raw);
    /// Somebody typed what is no value of this parameter.
    void refused(int parameter, const QString &text);

private:
    [[nodiscard]] int rows() const override { return m_rows; }
    [[nodiscard]] const ParameterSpec &specAt(int row) const;
    void reset();

    ConfigurationModel &m_configuration;
    RefusedTexts *m_refused;
    int m_rows = 0;
};

/// Texts of a parameter for people, translated: label with its index, axis, value with choice name.
[[nodiscard]] QString parameterLabel(const ParameterSpec &spec, bool withAxis = true);
[[nodiscard]] QString axisLabel(Axis axis);
[[nodiscard]] QString tableText(const char *text);
/// What a value means: its bits, "None" without any; or the choice that it is, empty where it is none of
/// them, several where firmwares differ.
[[nodiscard]] QString choicesText(std::span<const Choice> choices, double raw, bool areBits);
/// The profile's name, or its number where it has none.
[[nodiscard]] QString profileLabel(const Configuration &configuration, int profile);
[[nodiscard]] QString parameterValueText(const ParameterSpec &spec, double raw);
/// The same with its unit.
[[nodiscard]] QString parameterQuantityText(const ParameterSpec &spec, double raw);
/// The word for what a board holds that could not be read, or not since something was sent.
[[nodiscard]] QString unknownText();
[[nodiscard]] QString parameterRangeText(const ParameterSpec &spec);
/// Why the parameter has no effect now, as a sentence; empty: it has one.
[[nodiscard]] QString inactiveReason(const ConfigurationModel &configuration, const ParameterSpec &spec,
                                     int profile);
/// What contradicts the parameter's value now, as a sentence; empty: nothing.
[[nodiscard]] QString contradictionText(const ConfigurationModel &configuration, const ParameterSpec &spec,
                                        int profile);
/// Lower-case text in which a search looks: label, key, group, help.
[[nodiscard]] QString parameterSearchText(const ParameterSpec &spec);
