// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/refusedtexts.h"

#include <QJsonObject>

using namespace Qt::StringLiterals;

RefusedTexts::RefusedTexts(const ConfigurationModel &configuration, QObject *parent)
    : QObject(parent)
    , m_configuration(configuration)
{
    connect(&configuration, &ConfigurationModel::valueChanged, this, &RefusedTexts::dropOutdated);
    connect(&configuration, &ConfigurationModel::boardReset, this, &RefusedTexts::dropOutdated);
}

RefusedTexts::Place RefusedTexts::placeOf(const ParameterSpec &spec, int profile)
{
    return {spec.key, spec.row->scope == Scope::Profile ? profile : 0};
}

std::optional<double> RefusedTexts::valueAt(const Place &place) const
{
    const ParameterSpec *spec
        = m_configuration.isEmpty() ? nullptr : m_configuration.edited().parameters().find(place.first);
    return spec ? m_configuration.value(*spec, place.second) : std::nullopt;
}

std::optional<QString> RefusedTexts::text(const ParameterSpec &spec, int profile) const
{
    const auto it = m_texts.find(placeOf(spec, profile));
    return it == m_texts.end() ? std::nullopt : std::optional(it->text);
}

void RefusedTexts::set(const ParameterSpec &spec, int profile, const std::optional<QString> &text)
{
    if (this->text(spec, profile) == text)
        return;
    const Place place = placeOf(spec, profile);
    if (text)
        m_texts.insert(place, {*text, valueAt(place)});
    else
        m_texts.remove(place);
    emit changed();
}

std::optional<RefusedTexts::Place> RefusedTexts::first() const
{
    return m_texts.isEmpty() ? std::nullopt : std::optional(m_texts.firstKey());
}

void RefusedTexts::clear()
{
    if (m_texts.isEmpty())
        return;
    m_texts.clear();
    emit changed();
    emit replaced();
}

QJsonArray RefusedTexts::toJson() const
{
    QJsonArray texts;
    for (auto it = m_texts.begin(); it != m_texts.end(); ++it)
        texts.append(
            QJsonObject{{u"key"_s, it.key().first}, {u"profile"_s, it.key().second}, {u"text"_s, it->text}});
    return texts;
}

void RefusedTexts::restore(const QJsonArray &texts)
{
    const auto before = m_texts.size();
    for (const auto &each : texts) {
        const QJsonObject text = each.toObject();
        const Place place{text.value(u"key"_s).toString(), text.value(u"profile"_s).toInt()};
        if (const auto value = valueAt(place); value && !m_texts.contains(place))
            m_texts.insert(place, {text.value(u"text"_s).toString(), value});
    }
    if (m_texts.size() == before)
        return;
    emit changed();
    emit replaced();
}

void RefusedTexts::dropOutdated()
{
    const auto dropped = m_texts.removeIf([this](const std::pair<const Place &, Entry &> &each) {
        const auto now = valueAt(each.first);
        return now && !sameValue(now, each.second.value);
    });
    if (dropped > 0)
        emit changed();
}
