// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/models/configurationmodel.h"

#include <QJsonArray>

#include <utility>

/// Texts that were typed for values of the configuration and are none, as "300" where 255 is the highest.
/// They belong to a parameter and a profile, not to the field that happens to show it, and stay until there
/// is another value.
class RefusedTexts final : public QObject
{
    Q_OBJECT
public:
    /// Of a parameter, and the profile; 0 for a value of the board as a whole.
    using Place = std::pair<QString, int>;

    explicit RefusedTexts(const ConfigurationModel &configuration, QObject *parent = nullptr);

    /// Empty without one; what was typed may be an empty text itself.
    [[nodiscard]] std::optional<QString> text(const ParameterSpec &spec, int profile) const;
    /// No text: what was typed is a value now, or gone.
    void set(const ParameterSpec &spec, int profile, const std::optional<QString> &text);
    [[nodiscard]] int count() const { return int(m_texts.size()); }
    [[nodiscard]] std::optional<Place> first() const;
    void clear();

    [[nodiscard]] QJsonArray toJson() const;
    /// Adds those that are not there yet and belong to this configuration.
    void restore(const QJsonArray &texts);

signals:
    void changed();
    /// Texts came back, or all of them were thrown away: fields show them anew.
    void replaced();

private:
    struct Entry
    {
        QString text;
        std::optional<double> value;  // in whose place it was typed
    };
    [[nodiscard]] static Place placeOf(const ParameterSpec &spec, int profile);
    [[nodiscard]] std::optional<double> valueAt(const Place &place) const;
    void dropOutdated();

    const ConfigurationModel &m_configuration;
    QMap<Place, Entry> m_texts;
};
