// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTranslator>

/// The catalogues of one language, installed for as long as this lives: the program's own and Qt's.
class Translations
{
public:
    /// @param code "de", "en"; empty = the system's language
    explicit Translations(const QString &code);

private:
    QTranslator m_english;  // plural forms; also what another language leaves out
    QTranslator m_program;
    QTranslator m_qt;
};
