// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/translations.h"

#include "widgets/models/numbertext.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>

using namespace Qt::StringLiterals;

Translations::Translations(const QString &code)
{
    // Files and the wire have the point; the screen asks for its numbers (numbertext.h).
    QLocale::setDefault(QLocale::c());
    setLanguage(code);
}

Translations::~Translations()
{
    setNumberLocale(QLocale::c());
}

void Translations::setLanguage(const QString &code)
{
    const QLocale locale = code.isEmpty() ? QLocale::system() : QLocale(code);
    const bool english = locale.language() == QLocale::English;
    setNumberLocale(english ? QLocale::c() : locale);
    for (QTranslator *each : {&m_english, &m_qt, &m_program})
        QCoreApplication::removeTranslator(each);
    if (m_english.load(u":/translations/gimbaldesk_en.qm"_s))
        QCoreApplication::installTranslator(&m_english);
    if (english)
        return;
    if (m_qt.load(locale, u"qtbase"_s, u"_"_s, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(&m_qt);
    if (m_program.load(locale, u"gimbaldesk"_s, u"_"_s, u":/translations"_s))
        QCoreApplication::installTranslator(&m_program);
}
