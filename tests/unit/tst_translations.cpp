// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/patience.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QRegularExpression>
#include <QSet>
#include <QTest>
#include <QXmlStreamReader>

using namespace Qt::StringLiterals;

namespace {

// Of the families that the program was built with.
#if GIMBAL_WITH_SIMPLEBGC
constexpr int kMinTableTexts = 900;
#else
constexpr int kMinTableTexts = 450;
#endif

const QString kOtherAxes = uR"(\b(Nick|Nicken|Gier|Gieren|Rollen|Rollachse|Nickachse|Gierachse)\b)"_s;

struct Message
{
    QString context;
    QString source;
    QStringList translations;
    bool finished = true;
    bool plural = false;
};

QList<Message> readCatalogue(const QString &name)
{
    QFile file(QStringLiteral(GIMBAL_SOURCE_DIR "/translations/") + name);
    if (!file.open(QIODevice::ReadOnly))
        qFatal("no catalogue");
    QXmlStreamReader xml(&file);
    QList<Message> messages;
    QString context;
    while (!xml.atEnd()) {
        xml.readNext();
        if (!xml.isStartElement())
            continue;
        if (xml.name() == u"name"_s) {
            context = xml.readElementText();
        } else if (xml.name() == u"message"_s) {
            messages.append({context, {}, {}, true, xml.attributes().value(u"numerus"_s) == u"yes"_s});
        } else if (xml.name() == u"source"_s) {
            messages.last().source = xml.readElementText();
        } else if (xml.name() == u"translation"_s) {
            messages.last().finished = !xml.attributes().hasAttribute(u"type"_s);
            if (!messages.last().plural)
                messages.last().translations.append(xml.readElementText());
        } else if (xml.name() == u"numerusform"_s) {
            messages.last().translations.append(xml.readElementText());
        }
    }
    return messages;
}

QMap<QString, int> placeholders(const QString &text)
{
    static const QRegularExpression place(u"%(\\d|n|L\\d)"_s);
    QMap<QString, int> found;
    auto it = place.globalMatch(text);
    while (it.hasNext())
        ++found[it.next().captured()];
    return found;
}

}  // namespace

/// The catalogues hold every text, whole.
class TestTranslations : public QObject
{
    Q_OBJECT
private slots:
    void germanIsComplete();
    void placeholdersAreKept();
    void pluralsHaveTwoForms();
    void everyTableTextIsThere();
    void oneWordForEachThing_data();
    void oneWordForEachThing();
    void axesHaveOneNameEach();
    void helpUsesTheSameWords();
    void everyHelpTextHasBothLanguages();
};

void TestTranslations::germanIsComplete()
{
    const QList<Message> messages = readCatalogue(u"gimbaldesk_de.ts"_s);
    QVERIFY(messages.size() > 1400);
    for (const Message &message : messages) {
        QVERIFY2(message.finished, qPrintable(message.context + u": "_s + message.source));
        for (const QString &translation : message.translations)
            QVERIFY2(!translation.isEmpty(), qPrintable(message.source));
    }
}

void TestTranslations::placeholdersAreKept()
{
    for (const char *catalogue : {"gimbaldesk_de.ts", "gimbaldesk_en.ts"}) {
        for (const Message &message : readCatalogue(QLatin1String(catalogue))) {
            for (const QString &translation : message.translations)
                QVERIFY2(placeholders(translation) == placeholders(message.source),
                         qPrintable(message.source + u" -> "_s + translation));
        }
    }
}

void TestTranslations::pluralsHaveTwoForms()
{
    int plurals = 0;
    for (const char *catalogue : {"gimbaldesk_de.ts", "gimbaldesk_en.ts"}) {
        for (const Message &message : readCatalogue(QLatin1String(catalogue))) {
            if (!message.plural)
                continue;
            ++plurals;
            QVERIFY2(message.translations.size() == 2, qPrintable(message.source));
            for (const QString &form : message.translations)
                QVERIFY2(!form.contains(u"(s)"_s), qPrintable(form));
        }
    }
    QVERIFY(plurals > 30);
}

void TestTranslations::oneWordForEachThing_data()
{
    QTest::addColumn<QString>("source");  // of the texts that it is about
    QTest::addColumn<QString>(
        "german");  // that their translation has to have; empty: there must be no such text
    QTest::newRow("save to a file") << uR"(^Saved? |^Save…$| saved to %)"_s << u"icher(n|t)"_s;
    QTest::newRow("store") << uR"(^Stores? )"_s << u"[Ss]peicher"_s;
    QTest::newRow("discard") << uR"(^&?Discard)"_s << u"erwerfen"_s;
    QTest::newRow("revert") << uR"(^Revert )"_s << u"zurücknehmen"_s;
    QTest::newRow("restore") << uR"(^Restore )"_s << u"[Ww]iederherstellen"_s;
    // Other words for the same.
    QTest::newRow("a board does not save")
        << uR"(\b[Ss]aved?\b.*\b(in use|memory|variables|gains|on the board)\b)"_s << QString();
    QTest::newRow("nor is it saved") << uR"(\b(in use|memory|variables|gains)\b.*\b[Ss]aved?\b)"_s
                                     << QString();
    QTest::newRow("retrieve") << uR"(\b[Rr]etriev|\bRecall|\b[Rr]oll(ed)? back)"_s << QString();
    QTest::newRow("go back") << uR"(\b[Gg]o back to (it|the board|the stored))"_s << QString();
    QTest::newRow("put back") << uR"(^(Put|Take|Bring)\b.*\bback$|^Undo: put)"_s << QString();
    QTest::newRow("unwritten") << uR"([Uu]nwritten)"_s << u"[Uu]ngeschrieben"_s;
    QTest::newRow("unsaved") << uR"([Uu]nsaved)"_s << QString();
    QTest::newRow("keep in the board") << uR"(^Keep (all|everything|the values)|^Keeps all)"_s << QString();
}

void TestTranslations::oneWordForEachThing()
{
    QFETCH(QString, source);
    QFETCH(QString, german);
    const QRegularExpression about(source);
    // Names of the board's own menu and flags are its own.
    const QRegularExpression theirs(u"^(Save (backup automatically|statistics))$"_s);
    int seen = 0;
    for (const Message &message : readCatalogue(u"gimbaldesk_de.ts"_s)) {
        if (!message.source.contains(about) || message.source.contains(theirs))
            continue;
        ++seen;
        QVERIFY2(!german.isEmpty(), qPrintable(message.source));
        for (const QString &translation : message.translations)
            QVERIFY2(translation.contains(QRegularExpression(german)),
                     qPrintable(message.source + u" -> "_s + translation));
    }
    QCOMPARE(seen > 0, !german.isEmpty());
}

// Roll, Pitch and Yaw, as on the scales.
void TestTranslations::axesHaveOneNameEach()
{
    const QRegularExpression others(kOtherAxes);
    for (const Message &message : readCatalogue(u"gimbaldesk_de.ts"_s)) {
        for (const QString &translation : message.translations)
            QVERIFY2(!translation.contains(others), qPrintable(translation));
    }
}

void TestTranslations::helpUsesTheSameWords()
{
    const QList<std::pair<QString, QRegularExpression>> others{
        {u"en"_s,
         QRegularExpression(
             uR"([Rr]etriev|[Rr]oll(ed)? back|\*\*Save( variables)?\*\* stores|not saved|[Uu]nsaved)"_s)},
        {u"de"_s,
         QRegularExpression(uR"(Alles zurück\*|Speichern\*\* legt|ngesichert)"_s + u'|' + kOtherAxes)}};
    for (const auto &[language, words] : others) {
        const QDir folder(QStringLiteral(GIMBAL_SOURCE_DIR "/resources/help/") + language);
        const auto names = folder.entryList({u"*.md"_s});
        QVERIFY(names.size() > 15);
        for (const QString &name : names) {
            QFile file(folder.filePath(name));
            QVERIFY(file.open(QIODevice::ReadOnly));
            const auto found = words.match(QString::fromUtf8(file.readAll()));
            QVERIFY2(!found.hasMatch(), qPrintable(language + u'/' + name + u": "_s + found.captured()));
        }
    }
}

void TestTranslations::everyTableTextIsThere()
{
    QProcess process;
    process.start(QStringLiteral(GIMBAL_BIN_DIR "/tabletexts"), QStringList());
    QVERIFY(process.waitForFinished(kPatience));
    QSet<QString> known;
    for (const Message &message : readCatalogue(u"gimbaldesk_de.ts"_s)) {
        if (message.context == u"Tables"_s)
            known.insert(message.source);
    }
    int count = 0;
    static const QRegularExpression text(u"\"Tables\", \"(.*)\"\\)$"_s, QRegularExpression::MultilineOption);
    auto it = text.globalMatch(QString::fromUtf8(process.readAllStandardOutput()));
    while (it.hasNext()) {
        QString source = it.next().captured(1);
        source.replace(u"\\\""_s, u"\""_s).replace(u"\\\\"_s, u"\\"_s);
        QVERIFY2(known.contains(source), qPrintable(source + u" (run translations/update)"_s));
        ++count;
    }
    QVERIFY(count > kMinTableTexts);
}

void TestTranslations::everyHelpTextHasBothLanguages()
{
    const QDir english(QStringLiteral(GIMBAL_SOURCE_DIR "/resources/help/en"));
    const QDir german(QStringLiteral(GIMBAL_SOURCE_DIR "/resources/help/de"));
    QVERIFY(english.entryList({u"*.md"_s}).size() >= 15);
    QCOMPARE(german.entryList({u"*.md"_s}), english.entryList({u"*.md"_s}));
}

QTEST_GUILESS_MAIN(TestTranslations)
#include "tst_translations.moc"
