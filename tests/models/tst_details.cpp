// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/models/detailtext.h"
#include "widgets/models/errortext.h"

#include <QCoreApplication>
#include <QDirIterator>
#include <QRegularExpression>
#include <QSet>
#include <QTest>
#include <QTranslator>

using namespace Qt::StringLiterals;

namespace {

/// A language in which every sentence stands in brackets, with its first two placeholders the other way
/// round.
class Bracketed final : public QTranslator
{
public:
    [[nodiscard]] bool isEmpty() const override { return false; }
    [[nodiscard]] QString translate(const char *context, const char *source, const char *, int) const override
    {
        return qstrcmp(context, "ErrorDetail") == 0 ? bracketed(QString::fromUtf8(source)) : QString();
    }
    static QString bracketed(QString sentence)
    {
        if (sentence.contains(u"%2"_s)) {
            sentence.replace(u"%1"_s, u"%9"_s);
            sentence.replace(u"%2"_s, u"%1"_s);
            sentence.replace(u"%9"_s, u"%2"_s);
        }
        return u'[' + sentence + u']';
    }
};

QString filled(QString sentence)
{
    for (int number = 1; number <= 9; ++number)
        sentence.replace(u'%' + QString::number(number), u"X%1"_s.arg(number));
    return sentence;
}

/// What stands between the brackets of each call.
QStringList argumentsOf(const QString &text, const QString &function)
{
    QStringList all;
    const QRegularExpression call(u"\\b"_s + function);
    for (const QRegularExpressionMatch &found : call.globalMatch(text)) {
        int depth = 1;
        bool quoted = false;
        qsizetype at = found.capturedEnd();
        for (; at < text.size() && depth > 0; ++at) {
            const QChar c = text[at];
            if (quoted && c == u'\\')
                ++at;
            else if (c == u'"')
                quoted = !quoted;
            else if (!quoted)
                depth += (c == u'(' || c == u'{') - (c == u')' || c == u'}');
        }
        all.append(text.mid(found.capturedEnd(), at - found.capturedEnd()));
    }
    return all;
}

/// Its literals, with those joined that follow each other.
QStringList literalsOf(const QString &code)
{
    static const QRegularExpression literal(u"u?\"((?:[^\"\\\\]|\\\\.)*)\"(?:_s)?"_s);
    QStringList all;
    qsizetype end = -1;
    for (const QRegularExpressionMatch &found : literal.globalMatch(code)) {
        if (end >= 0 && QStringView(code).mid(end, found.capturedStart() - end).trimmed().isEmpty())
            all.last() += found.captured(1);
        else
            all.append(found.captured(1));
        end = found.capturedEnd();
    }
    return all;
}

QStringList sources()
{
    QStringList texts;
    for (const QString &folder : {u"protocol"_s, u"app"_s, u"widgets"_s}) {
        QDirIterator files(QStringLiteral(GIMBAL_SOURCE_DIR "/") + folder, {u"*.cpp"_s, u"*.h"_s},
                           QDir::Files, QDirIterator::Subdirectories);
        while (files.hasNext()) {
            const QString path = files.next();
            QFile file(path);
            // The command line and the simulators speak English.
            if (path.contains(u"/simulator/"_s) || path.contains(u"/cli/"_s)
                || path.endsWith(u"detailtext.cpp"_s) || !file.open(QIODevice::ReadOnly))
                continue;
            texts.append(QString::fromUtf8(file.readAll()));
        }
    }
    return texts;
}

/// As a sentence stands in the table: without what joins it to another, and with the place of what follows.
QString rowOf(QString literal)
{
    static const QRegularExpression joint(u"^[; ]+|[; ]+$"_s);
    const bool goesOn = literal.endsWith(u": "_s);
    literal.remove(joint);
    if (literal.startsWith(u": "_s))
        literal.prepend(u"%1"_s);
    return goesOn ? literal + u" %1"_s : literal;
}

}  // namespace

/// What errors tell in detail is read in the operator's language.
class TestDetails : public QObject
{
    Q_OBJECT
private slots:
    void everySentenceIsInTheTable();
    void theTableHasNoOther();
    void eachIsFoundAgain();
    void severalSentences();
    void errorsTellThem();

private:
    QSet<QString> m_table;
};

// A sentence of two words or more that comes into an error is translated.
void TestDetails::everySentenceIsInTheTable()
{
    static const QRegularExpression word(u"[a-z]{2,}"_s);
    static const QRegularExpression place(u"%\\d"_s);
    for (const char *sentence : detailSentences())
        m_table.insert(QString::fromUtf8(sentence));
    int seen = 0;
    QStringList missing;
    for (const QString &text : sources()) {
        for (const QString &function : {u"failure\\("_s, u"Error\\{"_s, u"addDetail\\("_s}) {
            for (const QString &arguments : argumentsOf(text, function)) {
                if (arguments.contains(u"tr("_s))
                    continue;
                for (const QString &literal : literalsOf(arguments)) {
                    const QString row = rowOf(literal);
                    if (!row.contains(u' '))
                        continue;
                    auto words = word.globalMatch(QString(row).remove(place));
                    int count = 0;
                    for (; words.hasNext(); words.next())
                        ++count;
                    seen += count > 1;
                    if (count > 1 && !m_table.contains(row) && !missing.contains(row))
                        missing.append(row);
                }
            }
        }
    }
    QVERIFY2(missing.isEmpty(), qPrintable(missing.join(u'\n')));
    QVERIFY2(seen > 200, qPrintable(QString::number(seen)));
}

void TestDetails::theTableHasNoOther()
{
    QSet<QString> used;
    for (const QString &text : sources()) {
        for (const QString &literal : literalsOf(text))
            used.insert(rowOf(literal));
    }
    for (const char *sentence : detailSentences())
        QVERIFY2(used.contains(QString::fromUtf8(sentence)), sentence);
}

// No sentence is taken for another, and what it names is kept.
void TestDetails::eachIsFoundAgain()
{
    for (const char *sentence : detailSentences())
        QCOMPARE(detailText(filled(QString::fromUtf8(sentence))), filled(QString::fromUtf8(sentence)));
    Bracketed language;
    QVERIFY(QCoreApplication::installTranslator(&language));
    for (const char *sentence : detailSentences()) {
        const QString text = QString::fromUtf8(sentence);
        QCOMPARE(detailText(filled(text)), filled(Bracketed::bracketed(text)));
    }
}

void TestDetails::severalSentences()
{
    Bracketed language;
    QVERIFY(QCoreApplication::installTranslator(&language));
    QCOMPARE(detailText({}), QString());
    QCOMPARE(detailText(u"GET_ANGLES"_s), u"GET_ANGLES"_s);
    QCOMPARE(detailText(u"a board's own words; the motors are off"_s),
             u"a board's own words; [the motors are off]"_s);
    // One with the same mark in it, between others.
    QCOMPARE(detailText(u"PING; 12 bytes; less than 9 are allowed; the motors are off"_s),
             u"PING; [9 bytes; less than 12 are allowed]; [the motors are off]"_s);
    // One within another, and what looks like a placeholder.
    QCOMPARE(detailText(u"nothing tells whether the board is armed"_s),
             u"[nothing tells [whether the board is armed]]"_s);
    QCOMPARE(detailText(u"there is no command '%1'"_s), u"[there is no command '%1']"_s);
}

void TestDetails::errorsTellThem()
{
    Bracketed language;
    QVERIFY(QCoreApplication::installTranslator(&language));
    const ErrorText off = describe(Error{ErrorCode::Unready, u"the motors are off"_s});
    QCOMPARE(off.detail, u"[the motors are off]"_s);
    const ErrorText entered = describe(Error{ErrorCode::InvalidArgument, u"there is no command 'X'"_s});
    QVERIFY2(entered.what.contains(u"[there is no command 'X']"_s), qPrintable(entered.what));
}

QTEST_GUILESS_MAIN(TestDetails)
#include "tst_details.moc"
