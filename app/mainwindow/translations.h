// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTranslator>

/// The catalogues of one language, the program's and Qt's, and how it writes numbers: in use for the lifetime
/// of this object.
class Translations
{
public:
    /// @param code "de", "en"; empty = the system's language
    explicit Translations(const QString &code);
    Translations(const Translations &) = delete;
    Translations &operator=(const Translations &) = delete;
    ~Translations();

    /// Another one from now on. Texts that were made before stay as they are.
    void setLanguage(const QString &code);

private:
    QTranslator m_english;  // plural forms; also what another language leaves out
    QTranslator m_program;
    QTranslator m_qt;
};
