// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/translations.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>

using namespace Qt::StringLiterals;

Translations::Translations(const QString &code)
{
    const QLocale locale = code.isEmpty() ? QLocale::system() : QLocale(code);
    // Numbers have the same format everywhere: on the screen, in files and on the command line.
    QLocale::setDefault(QLocale::c());
    if (m_english.load(u":/translations/gimbaldesk_en.qm"_s))
        QCoreApplication::installTranslator(&m_english);
    if (locale.language() == QLocale::English)
        return;
    if (m_qt.load(locale, u"qtbase"_s, u"_"_s, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(&m_qt);
    if (m_program.load(locale, u"gimbaldesk"_s, u"_"_s, u":/translations"_s))
        QCoreApplication::installTranslator(&m_program);
}
