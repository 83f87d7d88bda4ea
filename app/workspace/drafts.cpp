// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/drafts.h"

std::optional<QString> Drafts::text(const QString &name) const
{
    const auto it = m_texts.find(name);
    return it == m_texts.end() ? std::nullopt : std::optional(*it);
}

void Drafts::set(const QString &name, const QString &text)
{
    if (this->text(name) == text)
        return;
    m_texts.insert(name, text);
    emit changed();
}

void Drafts::remove(const QString &name)
{
    if (m_texts.remove(name) > 0)
        emit changed();
}

void Drafts::clear()
{
    if (m_texts.isEmpty())
        return;
    m_texts.clear();
    emit changed();
    emit replaced();
}

QJsonObject Drafts::toJson() const
{
    QJsonObject texts;
    for (auto it = m_texts.begin(); it != m_texts.end(); ++it)
        texts.insert(it.key(), it.value());
    return texts;
}

void Drafts::restore(const QJsonObject &texts)
{
    if (texts.isEmpty())
        return;
    for (auto it = texts.begin(); it != texts.end(); ++it) {
        if (!m_texts.contains(it.key()))
            m_texts.insert(it.key(), it.value().toString());
    }
    emit changed();
    emit replaced();
}
