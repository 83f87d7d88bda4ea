// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QMap>
#include <QObject>

/// Texts that were typed for the board shown and are no edits yet: a script with a mistake, a document that
/// is too long. By names that their pages choose.
class Drafts final : public QObject
{
    Q_OBJECT
public:
    using QObject::QObject;

    /// Empty without one; a draft may be an empty text itself.
    [[nodiscard]] std::optional<QString> text(const QString &name) const;
    [[nodiscard]] int count() const { return int(m_texts.size()); }
    void set(const QString &name, const QString &text);
    void remove(const QString &name);
    void clear();

    [[nodiscard]] QJsonObject toJson() const;
    /// Adds those that are not there yet, and tells the pages.
    void restore(const QJsonObject &texts);

signals:
    void changed();
    /// Drafts came back, or all of them were thrown away: pages show them anew.
    void replaced();

private:
    QMap<QString, QString> m_texts;
};
