// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/numbertext.h"

#include <QRegularExpression>

#include <cmath>

using namespace Qt::StringLiterals;

namespace {

QLocale &screenLocale()
{
    static QLocale locale = QLocale::c();
    return locale;
}

}  // namespace

void setNumberLocale(const QLocale &locale)
{
    screenLocale() = locale;
    screenLocale().setNumberOptions(QLocale::OmitGroupSeparator | QLocale::OmitLeadingZeroInExponent);
}

QLocale numberLocale()
{
    return screenLocale();
}

QString numberText(const QString &plain)
{
    return QString(plain).replace(u'.', screenLocale().decimalPoint());
}

QString numberText(double value, int decimals)
{
    QString text = QString::number(value, 'f', decimals);
    if (text.startsWith(u'-') && text.toDouble() == 0.0)
        text.remove(0, 1);
    return numberText(text);
}

QString shortNumberText(double value, int digits)
{
    return numberText(QString::number(value, 'g', digits));
}

QString withNumbers(const QString &sentence)
{
    if (screenLocale().decimalPoint() == u"."_s)
        return sentence;
    static const QRegularExpression number(
        u"(?<![\\w.:/\\\\])(?<!ware |sion )([+-]?\\d+)\\.(\\d+)(?![\\w:/\\\\]|\\.\\w)"_s);
    return QString(sentence).replace(number, u"\\1"_s + screenLocale().decimalPoint() + u"\\2"_s);
}

QString dateText(const QDateTime &time)
{
    return numberLocale().toString(time, QLocale::ShortFormat);
}

QString sizeText(qint64 bytes)
{
    return screenLocale().formattedDataSize(bytes);
}

std::optional<double> groupedNumber(const QString &text)
{
    static const QRegularExpression grouped(u"^[+\\-\\x{2212}]?[1-9]\\d{0,2}[.,]\\d{3}$"_s);
    QString plain = text.trimmed();
    if (!grouped.match(plain).hasMatch())
        return {};
    return typedNumber(plain.remove(u',').remove(u'.'));
}

double typedNumber(const QString &text)
{
    static const QRegularExpression number(u"^[+\\-\\x{2212}]?(\\d+([.,]\\d*)?|[.,]\\d+)$"_s);
    QString plain = text.trimmed();
    if (!number.match(plain).hasMatch())
        return std::nan("");
    return plain.replace(u',', u'.').replace(QChar(0x2212), u'-').toDouble();
}
