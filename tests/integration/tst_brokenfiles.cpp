// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Files of every kind, broken in every way: what is said of them is true, names the file and the remedy, and
// nothing of them is taken.
#include "app/composition/composition.h"
#include "protocol/base/filefault.h"
#include "protocol/base/responsecsv.h"
#include "protocol/record/configurationformats.h"
#include "protocol/record/recording.h"
#include "tests/support/patience.h"
#include "widgets/models/errortext.h"
#include "widgets/plot/plotlayout.h"

#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QTest>

using namespace Qt::StringLiterals;

namespace {

constexpr int kCuts = 50;
constexpr int kFlips = 200;
constexpr qint64 kLargest = 1 << 24;

QString data(const QString &name)
{
    return QStringLiteral(GIMBAL_SOURCE_DIR "/tests/data/version-0.1/") + name;
}

QByteArray bytesOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

using Reader = std::function<std::optional<Error>(const QString &path)>;

/// A kind of file: a good one, and how the program reads it.
struct Kind
{
    const char *name;
    QString sample;
    Reader read;
};

template <class Value> std::optional<Error> errorOf(const Result<Value> &result)
{
    return result ? std::nullopt : std::optional(result.error());
}

std::optional<Error> readConfigurationFile(const QString &path)
{
    return errorOf(loadConfiguration(path, allFamilies()));
}

const QList<Kind> &kinds()
{
    static const QList<Kind> all{
        {"simplebgc", u"configurations/simplebgc-2.73.8.json"_s, readConfigurationFile},
        {"storm32", u"configurations/storm32-0.96.json"_s, readConfigurationFile},
        {"settings", u"configurations/storm32-0.96.cfg"_s, readConfigurationFile},
        {"recording", u"recordings/storm32-0.96.gimbalrec"_s,
         [](const QString &path) { return errorOf(Recording::load(path)); }},
        {"black box", u"../blackbox/blackbox_000001.csv"_s,
         [](const QString &path) { return errorOf(Recording::load(path)); }},
        {"response", u"responses/simplebgc-sweep.csv"_s,
         [](const QString &path) -> std::optional<Error> {
             const auto bytes = readWhole(path, FileKind::Measurement, kLargest);
             if (!bytes)
                 return bytes.error();
             const auto samples = readResponseCsv(*bytes, 100);
             return samples ? std::nullopt : std::optional(inFile(samples.error(), path));
         }},
    };
    return all;
}

// What is damaged is left out, and told.
bool leavesOut(const Kind &kind)
{
    return qstrcmp(kind.name, "recording") == 0 || qstrcmp(kind.name, "black box") == 0;
}

bool isText(const Kind &kind)
{
    return qstrcmp(kind.name, "recording") != 0;
}

}  // namespace

class TestBrokenFiles : public QObject
{
    Q_OBJECT
private slots:
    void everyKindIsRead_data() { listKinds(); }
    void everyKindIsRead();
    void aCutFileIsNeverTakenForAWholeOne_data() { listKinds(); }
    void aCutFileIsNeverTakenForAWholeOne();
    void flippedBytesAreSurvived_data() { listKinds(); }
    void flippedBytesAreSurvived();
    void otherFilesAreNamed_data() { listKinds(); }
    void otherFilesAreNamed();
    void whatIsWrongIsSaid_data();
    void whatIsWrongIsSaid();
    void aLayoutOfPlotsIsChecked();
    void theCommandLineSaysTheSame();

private:
    static void listKinds()
    {
        QTest::addColumn<int>("index");
        for (int i = 0; i < kinds().size(); ++i)
            QTest::newRow(kinds()[i].name) << i;
    }
    QString put(const QString &name, const QByteArray &bytes) const
    {
        const QString path = m_dir.filePath(name);
        QFile file(path);
        if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size())
            qFatal("no room for a test file");
        return path;
    }
    /// Empty if these are all the words that an operator needs.
    static QString missingWords(const Error &error, const QString &name)
    {
        const ErrorText text = describe(error);
        if (error.code != ErrorCode::BadFile || !error.file)
            return u"no fault of a file: "_s + error.detail;
        if (!text.what.contains(name))
            return u"does not name the file: "_s + text.what;
        if (text.meaning.isEmpty() || text.cure.isEmpty())
            return u"no meaning or no cure: "_s + text.oneLine();
        return {};
    }

    QTemporaryDir m_dir;
};

void TestBrokenFiles::everyKindIsRead()
{
    QFETCH(int, index);
    const auto error = kinds()[index].read(data(kinds()[index].sample));
    QVERIFY2(!error, error ? qPrintable(error->detail) : "");
}

// Wherever it was cut. A list of measurements has no end by which it could be known: only a cut line shows.
void TestBrokenFiles::aCutFileIsNeverTakenForAWholeOne()
{
    QFETCH(int, index);
    const Kind &kind = kinds()[index];
    const QByteArray whole = bytesOf(data(kind.sample)).trimmed();
    const bool isEndless
        = qstrcmp(kind.name, "response") == 0 || qstrcmp(kind.name, "black box") == 0 || !isText(kind);
    const QString name = u"cut."_s + QFileInfo(kind.sample).suffix();  // by which a kind is known
    int told = 0;
    QList<qsizetype> lengths;
    if (!isText(kind))
        lengths = {1, 2, 3, 5, 8, 13, 21, 34, 55, 89};  // in what it begins with as well
    for (int i = 0; i < kCuts; ++i)
        lengths.append(whole.size() * i / kCuts);
    for (const qsizetype length : std::as_const(lengths)) {
        const QString path = put(name, whole.first(length));
        const auto error = kind.read(path);
        if (!error) {
            QVERIFY2(isEndless, qPrintable(u"cut at %1 of %2, and read"_s.arg(length).arg(whole.size())));
            continue;
        }
        ++told;
        const QString missing = missingWords(*error, name);
        QVERIFY2(missing.isEmpty(), qPrintable(missing));
        const FileProblem problem = error->file->problem;
        QVERIFY2(length == 0 ? problem == FileProblem::Empty
                             : problem == FileProblem::Truncated || problem == FileProblem::MissingEntry,
                 qPrintable(u"cut at %1: %2"_s.arg(length).arg(describe(*error).oneLine())));
    }
    QVERIFY(told > 0);
}

void TestBrokenFiles::flippedBytesAreSurvived()
{
    QFETCH(int, index);
    const Kind &kind = kinds()[index];
    const QByteArray whole = bytesOf(data(kind.sample));
    const QString name = u"flipped."_s + QFileInfo(kind.sample).suffix();
    QRandomGenerator random(1);
    int told = 0;
    for (int i = 0; i < kFlips; ++i) {
        QByteArray broken = whole;
        const qsizetype at = random.bounded(qint64(broken.size()));
        broken[at] = char(broken[at] ^ (1 << random.bounded(8)));
        const QString path = put(name, broken);
        const auto error = kind.read(path);
        if (!error)
            continue;  // a digit became another one, or a part of a recording is left out
        ++told;
        const QString missing = missingWords(*error, name);
        QVERIFY2(missing.isEmpty(), qPrintable(missing));
        // Its end is where it was: to call it cut off would send the operator the wrong way.
        QVERIFY2(
            error->file->problem != FileProblem::Truncated || at + 3 >= whole.trimmed().size(),
            qPrintable(u"byte %1 of %2: %3"_s.arg(at).arg(whole.size()).arg(describe(*error).oneLine())));
    }
    QVERIFY(told > 0 || leavesOut(kind));
}

void TestBrokenFiles::otherFilesAreNamed()
{
    QFETCH(int, index);
    const Kind &kind = kinds()[index];
    QByteArray picture("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16);
    picture.append(QByteArray(4000, '\x5a'));
    for (const auto &[name, bytes] : {std::pair{u"picture.png"_s, picture},
                                      std::pair{u"letter.txt"_s, QByteArray("Dear all,\nsee you.\n")},
                                      std::pair{u"page.html"_s, QByteArray("<html><body>x</body></html>")}}) {
        const auto error = kind.read(put(name, bytes));
        QVERIFY2(error, qPrintable(name));
        const QString missing = missingWords(*error, name);
        QVERIFY2(missing.isEmpty(), qPrintable(missing));
        QVERIFY2(
            error->file->problem == FileProblem::OtherKind
                || (qstrcmp(kind.name, "response") == 0 && error->file->problem == FileProblem::BadValue),
            qPrintable(describe(*error).oneLine()));
    }
    const auto missing = kind.read(m_dir.filePath(u"none.json"_s));
    QVERIFY(missing && missing->file);
    QCOMPARE(missing->file->problem, FileProblem::Missing);
    const auto folder = kind.read(m_dir.path());
    QVERIFY(folder && folder->file);
    QVERIFY(folder->file->problem == FileProblem::System || folder->file->problem == FileProblem::OtherKind);
}

void TestBrokenFiles::whatIsWrongIsSaid_data()
{
    QTest::addColumn<QString>("sample");
    QTest::addColumn<QByteArray>("find");
    QTest::addColumn<QByteArray>("replace");
    QTest::addColumn<QString>("what");
    const QString json = u"configurations/simplebgc-2.73.8.json"_s;
    QTest::newRow("newer version")
        << json << QByteArray("\"version\": 1") << QByteArray("\"version\": 9")
        << u"“broken.json” was written by a newer version of the program (format 9;"
           " this version reads up to 1)."_s;
    QTest::newRow("unknown family") << json << QByteArray("\"family\": \"simplebgc\"")
                                    << QByteArray("\"family\": \"other\"")
                                    << u"“broken.json” belongs to boards of the family “other”, which this"
                                       " program does not know."_s;
    QTest::newRow("a comma too much") << json << QByteArray("\"profileCount\": 5")
                                      << QByteArray("\"profileCount\": 5,") << u"is damaged."_s;
    QTest::newRow("too many profiles")
        << json << QByteArray("\"profileCount\": 5") << QByteArray("\"profileCount\": 77")
        << u"profileCount is 77, allowed: 1 to 32."_s;
}

void TestBrokenFiles::whatIsWrongIsSaid()
{
    QFETCH(QString, sample);
    QFETCH(QByteArray, find);
    QFETCH(QByteArray, replace);
    QFETCH(QString, what);
    QByteArray bytes = bytesOf(data(sample));
    QVERIFY(bytes.contains(find));
    bytes.replace(find, replace);
    const auto error = readConfigurationFile(put(u"broken.json"_s, bytes));
    QVERIFY(error);
    const QString said = describe(*error).what;
    QVERIFY2(said.contains(what), qPrintable(said));
    QCOMPARE(missingWords(*error, u"broken.json"_s), QString());
    // The line is that of the entry.
    if (error->file->line > 0) {
        const QByteArray line = bytes.split('\n').value(error->file->line - 1);
        QVERIFY2(line.contains(replace) || bytes.split('\n').value(error->file->line - 2).contains(replace),
                 qPrintable(u"line %1: %2"_s.arg(error->file->line).arg(QString::fromUtf8(line))));
    }
}

void TestBrokenFiles::aLayoutOfPlotsIsChecked()
{
    QVERIFY(PlotLayout::check(PlotLayout{.plots = {{.channels = {}}}, .seconds = 5}.toJson({}), u"mine"_s));
    for (const char *bytes : {"", "x", "[", "{\"plots\": ", "{}x"}) {
        const auto checked = PlotLayout::check(bytes, u"mine"_s);
        QVERIFY2(!checked, bytes);
        QCOMPARE(missingWords(checked.error(), u"mine"_s), QString());
    }
}

void TestBrokenFiles::theCommandLineSaysTheSame()
{
    const QString good = data(kinds()[0].sample);
    const QString cut = put(u"half.json"_s, bytesOf(good).first(3000));
    const QString empty = put(u"empty.gimbalrec"_s, {});
    const QList<std::pair<QStringList, QString>> calls{
        {{u"diff"_s, good, cut}, u"“half.json”"_s},
        {{u"export"_s, empty}, u"“empty.gimbalrec” is empty."_s},
        {{u"diff"_s, good, m_dir.filePath(u"none.json"_s)}, u"“none.json” does not exist."_s},
        {{u"export"_s, cut}, u"“half.json” is not a recording."_s},
        {{u"diff"_s, good, data(kinds()[1].sample)}, u"STorM32"_s},
    };
    for (const auto &[arguments, words] : calls) {
        QProcess process;
        process.start(QStringLiteral(GIMBAL_BIN_DIR "/gimbalctl"), arguments);
        QVERIFY(QTest::qWaitFor([&process] { return process.state() == QProcess::NotRunning; }, kPatience));
        const QString told = QString::fromUtf8(process.readAllStandardError());
        QVERIFY2(process.exitCode() != 0, qPrintable(arguments.join(u' ')));
        QVERIFY2(told.contains(words), qPrintable(told));
        QVERIFY2(!told.contains(u"does not make sense"_s), qPrintable(told));
    }
}

QTEST_GUILESS_MAIN(TestBrokenFiles)
#include "tst_brokenfiles.moc"
