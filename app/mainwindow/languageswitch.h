// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>

#include <functional>

class Settings;

/// Waits with another language until nothing would be lost by making all pages anew.
class LanguageSwitch final : public QObject
{
    Q_OBJECT
public:
    /// @param isFree whether pages may be made anew now; asked until they may
    LanguageSwitch(Settings &settings, std::function<bool()> isFree, QObject *parent);

signals:
    /// The language that was chosen is to be used from now on. @param code "de", "en"; empty = the system's
    void due(const QString &code);

private:
    void look();

    Settings &m_settings;
    std::function<bool()> m_isFree;
    QString m_language;  // in use
    QTimer m_wait;
};
