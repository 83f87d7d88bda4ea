// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/composition/composition.h"
#include "app/workspace/editjournal.h"
#include "app/workspace/settings.h"
#include "protocol/record/configurationformats.h"
#include "protocol/record/replaystore.h"
#include "tests/support/patience.h"
#include "widgets/plot/plotlayout.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QProcess>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace Qt::StringLiterals;

namespace {

QString data(const QString &name)
{
    return QStringLiteral(GIMBAL_SOURCE_DIR "/tests/data/version-0.1/") + name;
}

QStringList names(const QString &folder, const QString &suffix)
{
    QStringList found;
    const QDir dir(data(folder));
    for (const QString &name : dir.entryList({u"*."_s + suffix}, QDir::Files, QDir::Name))
        found.append(name.chopped(suffix.size() + 1));
    return found;
}

QByteArray bytes(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QStringList lines(const QString &path)
{
    return QString::fromUtf8(bytes(path)).split(u'\n', Qt::SkipEmptyParts);
}

// As version 0.1 said it: numbers with the decimals of the screen.
QString told(const ParameterSpec &spec, const Configuration &configuration, int profile)
{
    const auto raw = configuration.raw(spec, profile);
    if (!raw)
        return u"nothing"_s;
    return spec.row->kind == ValueKind::Number ? spec.rounded(*raw) : spec.format(*raw);
}

/// The word of version 0.1 that has become these.
QString toldTogether(const QList<const ParameterSpec *> &parts, const Configuration &configuration,
                     int profile)
{
    unsigned word = 0;
    for (const ParameterSpec *part : parts)
        word |= unsigned(configuration.raw(*part, profile).value_or(0)) << part->row->bitShift;
    return parts.isEmpty() ? u"no such parameter"_s : u"0x%1"_s.arg(word, 2, 16, QChar(u'0'));
}

/// What differs from the values that version 0.1 read: "profile, key, value, unit" in each line.
QString differences(const Configuration &configuration, const QString &valuesFile)
{
    QStringList wrong;
    int profiles = 0;
    int count = 0;
    for (const QString &line : lines(valuesFile)) {
        const QStringList fields = line.split(u'\t');
        const int profile = fields[0].toInt() - 1;
        profiles = std::max(profiles, profile + 1);
        ++count;
        const ParameterSpec *spec = configuration.parameters().find(fields.value(1));
        const QString now = spec
            ? told(*spec, configuration, profile)
            : toldTogether(configuration.parameters().partsOf(fields.value(1)), configuration, profile);
        if (now != fields.value(2) || (spec && QString::fromUtf8(spec->row->unit) != fields.value(3)))
            wrong.append(u"%1 is %2"_s.arg(line, now));
    }
    if (count < 100 || configuration.identity().profileCount != profiles)
        wrong.append(u"%1 values of %2 profiles"_s.arg(count).arg(profiles));
    return wrong.join(u'\n');
}

struct Run
{
    int exitCode = -1;
    QByteArray out;
    QString err;
};

Run ctl(const QStringList &arguments)
{
    QProcess process;
    process.start(QStringLiteral(GIMBAL_BIN_DIR "/gimbalctl"), arguments);
    if (!QTest::qWaitFor([&process] { return process.state() == QProcess::NotRunning; }, kPatience))
        process.kill();
    return {process.exitCode(), process.readAllStandardOutput(),
            QString::fromUtf8(process.readAllStandardError())};
}

/// The numbers of a text, whatever is said around them.
QStringList numbers(const QString &text)
{
    QStringList found;
    static const QRegularExpression number(u"\\d+(\\.\\d+)?"_s);
    for (auto each = number.globalMatch(text); each.hasNext();)
        found.append(each.next().captured());
    return found;
}

/// Columns of a CSV by their headings.
QMap<QString, QStringList> columns(const QByteArray &csv)
{
    const QStringList rows = QString::fromUtf8(csv).split(u'\n', Qt::SkipEmptyParts);
    const QStringList headings = rows.value(0).split(u',');
    QMap<QString, QStringList> found;
    for (qsizetype row = 1; row < rows.size(); ++row) {
        const QStringList cells = rows[row].split(u',');
        for (qsizetype i = 0; i < headings.size(); ++i)
            found[headings[i]].append(cells.value(i));
    }
    return found;
}

// Version 0.1 exported a STorM32's recordings without knowing the firmware: with the scales of o323BGC 0.90,
// and with the times of arrival where the board has a clock (storm32 errata 3.9). Its factor, and how near
// the truth is to what it wrote, for the columns that were wrong.
std::optional<std::pair<double, double>> scaleOfVersion01(const QString &name, const QString &column)
{
    if (column == u"time_s"_s && (name == u"storm32-0.90"_s || name == u"storm32-0.96"_s))
        return std::pair{1.0, 0.02};
    if (name == u"storm32-0.96"_s && column.startsWith(u"gyro."_s))
        return std::pair{2.048, 1e-5};
    if (name == u"storm32-0.96"_s && column.startsWith(u"acc."_s) && column.endsWith(u"[g]"_s))
        return std::pair{8192.0 / 10000.0, 1e-5};
    return {};
}

/// Decimals that the shortest text of a number has; one at least, as version 0.1 wrote them.
int decimals(double number)
{
    const QString text = QString::number(number, 'f', QLocale::FloatingPointShortest);
    return std::max(1, int(text.section(u'.', 1).size()));
}

const QRegularExpression kSplitWord(u"^mavlink\\.channel\\d\\.flags$"_s);

// Everything that was in the old value is in the new one; numbers as exact as version 0.1 told them.
bool holds(const QJsonValue &now, const QJsonValue &old)
{
    if (old.isObject()) {
        const QJsonObject object = old.toObject();
        for (auto each = object.begin(); each != object.end(); ++each) {
            const bool isSplit = kSplitWord.match(each.key()).hasMatch();  // differences() compares its parts
            if (!isSplit && !holds(now.toObject().value(each.key()), each.value()))
                return false;
        }
        return now.isObject();
    }
    if (old.isArray()) {
        const QJsonArray array = old.toArray();
        for (qsizetype i = 0; i < array.size(); ++i) {
            if (!holds(now.toArray().at(i), array[i]))
                return false;
        }
        return now.isArray() && now.toArray().size() == array.size();
    }
    if (old.isDouble()) {
        // Version 0.1 rounded to the decimals of the screen: what is exact now, rounded like that, is the
        // old.
        return now.isDouble()
            && QString::number(now.toDouble(), 'f', decimals(old.toDouble())).toDouble() == old.toDouble();
    }
    return now == old;
}

}  // namespace

/// Files of version 0.1 open and say what they said.
class TestOldFiles : public QObject
{
    Q_OBJECT
private slots:
    void configurations_data();
    void configurations();
    void originalSettings_data();
    void originalSettings();
    void differencesOfFiles_data();
    void differencesOfFiles();
    void recordingsAreExported_data();
    void recordingsAreExported();
    void recordingsAreReplayed_data();
    void recordingsAreReplayed();
    void responses_data();
    void responses();
    void history_data();
    void history();
    void unsavedEditsComeBack_data();
    void unsavedEditsComeBack();
    void settings_data();
    void settings();
    void calibrations();

private:
    static void compareValues(const QString &file, const QString &name);
};

void TestOldFiles::compareValues(const QString &path, const QString &name)
{
    const auto file = loadConfiguration(path, allFamilies());
    QVERIFY2(file, file ? "" : qPrintable(file.error().detail));
    QVERIFY(file->unknownKeys.isEmpty() && file->missingKeys.isEmpty());
    QCOMPARE(differences(file->configuration, data(name + u".values"_s)), QString());
}

void TestOldFiles::configurations_data()
{
    QTest::addColumn<QString>("name");
    const QStringList files = names(u"configurations"_s, u"json"_s);
    QCOMPARE(files.size(), 6);
    for (const QString &name : files)
        QTest::newRow(qPrintable(name)) << name;
}

void TestOldFiles::configurations()
{
    QFETCH(QString, name);
    const QString path = data(u"configurations/%1.json"_s.arg(name));
    compareValues(path, u"configurations/"_s + name);
    if (QTest::currentTestFailed())
        return;
    const auto file = loadConfiguration(path, allFamilies());
    const Configuration &configuration = file->configuration;
    QCOMPARE(configuration.identity().family, name.section(u'-', 0, 0));
    QVERIFY(configuration.identity().firmware.startsWith(name.section(u'-', 1)));
    QCOMPARE(file->reason, u"dump"_s);
    QCOMPARE(file->savedAt.date(), QDate(2026, 11, 22));

    // "* 2  Studio": the active one is marked.
    const QStringList profiles = lines(data(u"configurations/%1.profiles"_s.arg(name)));
    QCOMPARE(configuration.identity().profileCount, profiles.size());
    for (int i = 0; i < profiles.size(); ++i) {
        QCOMPARE(configuration.profileNames().value(i), profiles[i].mid(5));
        QCOMPARE(configuration.activeProfile() == i, profiles[i].startsWith(u'*'));
    }

    // What is written anew holds the same, byte by byte.
    const QByteArray json = ConfigurationFile::toJson(configuration, file->reason, file->savedAt);
    const QJsonObject before = QJsonDocument::fromJson(bytes(path)).object();
    const QJsonObject after = QJsonDocument::fromJson(json).object();
    QVERIFY(!before.value(u"blocks"_s).toObject().isEmpty());
    QCOMPARE(after.value(u"blocks"_s), before.value(u"blocks"_s));
    QVERIFY(holds(after, before));
}

void TestOldFiles::originalSettings_data()
{
    QTest::addColumn<QString>("name");
    const QStringList files = names(u"configurations"_s, u"cfg"_s);
    QCOMPARE(files.size(), 3);
    for (const QString &name : files)
        QTest::newRow(qPrintable(name)) << name;
}

void TestOldFiles::originalSettings()
{
    QFETCH(QString, name);
    compareValues(data(u"configurations/%1.cfg"_s.arg(name)), u"configurations/"_s + name);
    if (QTest::currentTestFailed())
        return;
    // Both kinds of files hold the same scripts.
    for (const QString &suffix : {u".cfg"_s, u".json"_s}) {
        const auto file = loadConfiguration(data(u"configurations/"_s + name + suffix), allFamilies());
        QVERIFY(file);
        const auto families = allFamilies();
        const Family *family = findFamily(families, u"storm32"_s);
        QString texts;
        for (int script = 0; script < family->scripts->count(); ++script)
            texts += u"script %1\n"_s.arg(script + 1) + family->scripts->text(file->configuration, script);
        QCOMPARE(texts.toUtf8(), bytes(data(u"configurations/%1.scripts"_s.arg(name))));
    }
}

void TestOldFiles::differencesOfFiles_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QStringList>("files");
    QTest::newRow("simplebgc") << u"simplebgc-2.59+simplebgc-2.73.8"_s
                               << QStringList{u"simplebgc-2.59.json"_s, u"simplebgc-2.73.8.json"_s};
    QTest::newRow("storm32") << u"storm32-0.96+storm32-0.79"_s
                             << QStringList{u"storm32-0.96.json"_s, u"storm32-0.79.cfg"_s};
}

void TestOldFiles::differencesOfFiles()
{
    QFETCH(QString, name);
    QFETCH(QStringList, files);
    const Run run = ctl({u"--json"_s, u"diff"_s, data(u"configurations/"_s + files[0]),
                         data(u"configurations/"_s + files[1])});
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    QStringList found;
    const QJsonArray changes = QJsonDocument::fromJson(run.out).array();
    for (const QJsonValue change : changes) {
        const QString profile
            = change[u"profile"_s].isDouble() ? QString::number(change[u"profile"_s].toInt()) : QString();
        const QString key
            = change[u"key"_s].isString() ? change[u"key"_s].toString() : change[u"data"_s].toString();
        found.append(
            QStringList{profile, key, change[u"from"_s].toString(), change[u"to"_s].toString()}.join(u'\t'));
    }
    QStringList wanted = lines(data(u"differences/%1.differences"_s.arg(name)));
    QVERIFY(wanted.size() > 50);
    found.sort();
    wanted.sort();
    QCOMPARE(found, wanted);
}

void TestOldFiles::recordingsAreExported_data()
{
    QTest::addColumn<QString>("name");
    const QStringList files = names(u"recordings"_s, u"gimbalrec"_s);
    QCOMPARE(files.size(), 7);
    for (const QString &name : files)
        QTest::newRow(qPrintable(name)) << name;
}

void TestOldFiles::recordingsAreExported()
{
    QFETCH(QString, name);
    const QStringList whole{u"export"_s, data(u"recordings/%1.gimbalrec"_s.arg(name)), u"--csv"_s, u"-"_s};
    const Run run = ctl(whole + QStringList{u"--partial"_s});
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    // Duration, rows, losses, and where the damage is; how much is left out was not told then.
    const QStringList told = numbers(QString::fromUtf8(bytes(data(u"recordings/%1.note"_s.arg(name)))));
    QCOMPARE(numbers(run.err).first(told.size()), told);
    const bool isCut = run.err.contains(u"the file ends within a chunk"_s);
    QCOMPARE(isCut, name == u"cut"_s);
    QVERIFY(isCut || numbers(run.err).size() == told.size());
    QCOMPARE(ctl(whole).exitCode, isCut ? 1 : 0);
    const auto now = columns(run.out);
    const auto old = columns(bytes(data(u"recordings/%1.csv"_s.arg(name))));
    QVERIFY(old.size() > 5);
    static const QRegularExpression kSomething(u"."_s);
    for (auto column = old.begin(); column != old.end(); ++column) {
        QVERIFY2(now.contains(column.key()), qPrintable(column.key()));
        const QStringList values = now.value(column.key());
        // It gave zeros of sensors that were not there as values.
        if (values.filter(kSomething).isEmpty() && values.size() == column.value().size()) {
            for (const QString &value : column.value())
                QVERIFY2(value.isEmpty() || value.toDouble() == 0.0, qPrintable(column.key()));
            continue;
        }
        const auto wrong = scaleOfVersion01(name, column.key());
        if (!wrong) {
            QVERIFY2(values == column.value(), qPrintable(column.key()));
            continue;
        }
        QCOMPARE(values.size(), column.value().size());
        const auto [scale, near] = *wrong;
        for (qsizetype i = 0; i < values.size(); ++i) {
            const double truth = column.value()[i].toDouble() / scale;
            QVERIFY2(std::abs(values[i].toDouble() - truth) <= near, qPrintable(column.key()));
        }
    }
}

void TestOldFiles::recordingsAreReplayed_data()
{
    QTest::addColumn<QString>("name");
    for (const QString &name : names(u"recordings"_s, u"values"_s))
        QTest::newRow(qPrintable(name)) << name;
}

// A replay answers as the board did: who it is, and every value of every profile.
void TestOldFiles::recordingsAreReplayed()
{
    QFETCH(QString, name);
    const QString link = u"replay:"_s + data(u"recordings/%1.gimbalrec"_s.arg(name));
    const Run info = ctl({u"--link"_s, link, u"--json"_s, u"info"_s});
    QVERIFY2(info.exitCode == 0, qPrintable(info.err));
    const QJsonObject old = QJsonDocument::fromJson(bytes(data(u"recordings/%1.info"_s.arg(name)))).object();
    QVERIFY(!old.isEmpty());
    QVERIFY2(holds(QJsonDocument::fromJson(info.out).object(), old), info.out.constData());

    QTemporaryDir dir;
    const QString file = dir.filePath(u"replayed.json"_s);
    const Run dump = ctl({u"--link"_s, link, u"dump"_s, file});
    QVERIFY2(dump.exitCode == 0, qPrintable(dump.err));
    compareValues(file, u"recordings/"_s + name);
}

void TestOldFiles::responses_data()
{
    QTest::addColumn<QString>("name");
    const QStringList files = names(u"responses"_s, u"csv"_s);
    QCOMPARE(files.size(), 2);
    for (const QString &name : files)
        QTest::newRow(qPrintable(name)) << name;
}

void TestOldFiles::responses()
{
    QFETCH(QString, name);
    const Run run = ctl({u"--json"_s, u"analyze"_s, u"response"_s, data(u"responses/%1.csv"_s.arg(name))});
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    QJsonObject now = QJsonDocument::fromJson(run.out).object();
    QJsonArray some;
    const QJsonArray bins = now.value(u"bins"_s).toArray();
    for (qsizetype bin = 0; bin < bins.size(); bin += 64)
        some.append(bins[bin]);
    now.insert(u"bins"_s, some);
    const QJsonObject old = QJsonDocument::fromJson(bytes(data(u"responses/%1.json"_s.arg(name)))).object();
    QVERIFY(old.contains(u"phaseMarginDeg"_s));
    QVERIFY2(holds(now, old), QJsonDocument(now).toJson().constData());
}

void TestOldFiles::history_data()
{
    QTest::addColumn<QString>("serial");
    const QStringList boards = names(u"history"_s, u"values"_s);
    QCOMPARE(boards.size(), 2);
    for (const QString &serial : boards)
        QTest::newRow(qPrintable(serial)) << serial;
}

void TestOldFiles::history()
{
    QFETCH(QString, serial);
    const BoardHistory history(data(u"history"_s));
    const QStringList snapshots = history.snapshots(serial);
    QCOMPARE(snapshots.size(), 1);
    compareValues(snapshots.first(), u"history/"_s + serial);
    if (QTest::currentTestFailed())
        return;
    const auto file = loadConfiguration(snapshots.first(), allFamilies());
    QCOMPARE(file->configuration.identity().serial, serial);
    QVERIFY(!file->reason.isEmpty());
    QVERIFY(std::abs(BoardHistory::timeOf(snapshots.first()).secsTo(file->savedAt)) <= 1);
    // What the unsaved edits of each board started from.
    QCOMPARE(history.unsavedBases().size(), 2);
    compareValues(data(u"history/%1/unsaved/board.json"_s.arg(serial)), u"history/"_s + serial);
}

void TestOldFiles::unsavedEditsComeBack_data()
{
    QTest::addColumn<QString>("serial");
    QTest::addColumn<int>("done");
    QTest::addColumn<QStringList>("texts");
    QTest::addColumn<QStringList>("values");  // profile from 1, key, value
    QTest::addColumn<QStringList>("redone");
    QTest::newRow("simplebgc") << u"474453494d01000000"_s << 5
                               << QStringList{u"P · Roll"_s,
                                              u"D · Yaw"_s,
                                              u"Profile name"_s,
                                              u"I · Pitch"_s,
                                              u"Copy profile 2 onto profile 5"_s,
                                              u"P · Roll"_s}
                               << QStringList{u"1 pid.roll.p 71"_s,      u"2 pid.yaw.d 12"_s,
                                              u"4 pid.pitch.i 2.00"_s,   u"5 pid.roll.p 45"_s,
                                              u"5 pid.yaw.p 50"_s,       u"5 pid.yaw.d 12"_s,
                                              u"5 follow.yaw.speed 25"_s}
                               << QStringList{u"3 pid.roll.p 5"_s};
    QTest::newRow("storm32") << u"storm32-4f6c6c6957203332334247432076312e333020463130335243"_s << 3
                             << QStringList{u"P · Pitch"_s, u"Angle offset · Pitch"_s, u"Scripts"_s,
                                            u"Mode · Yaw"_s}
                             << QStringList{u"1 pid.pitch.p 5.00"_s, u"1 motor.pitch.offset -2.50"_s}
                             << QStringList{u"1 rc.yaw.mode 3"_s};
}

void TestOldFiles::unsavedEditsComeBack()
{
    QFETCH(QString, serial);
    QFETCH(int, done);
    QFETCH(QStringList, texts);
    QFETCH(QStringList, values);
    QFETCH(QStringList, redone);
    // A copy: the journal writes.
    QTemporaryDir dir;
    QVERIFY(QDir(dir.path()).mkpath(serial + u"/unsaved"_s));
    for (const QString &name : {u"board.json"_s, u"edits.json"_s}) {
        const QString path = serial + u"/unsaved/"_s + name;
        QVERIFY(QFile::copy(data(u"history/"_s + path), dir.filePath(path)));
    }
    const BoardHistory history(dir.path());
    const auto base = loadConfiguration(history.unsavedBases().value(0), allFamilies());
    QVERIFY(base);
    ConfigurationModel model;
    EditStack edits(model);
    EditJournal journal(model, edits, history);
    const QSignalSpy found(&journal, &EditJournal::leftoverFound);
    model.reset(base->configuration);
    QCOMPARE(found.size(), 1);
    QVERIFY(journal.restoreLeftover().any);

    QUndoStack &stack = edits.undoStack();
    QStringList steps;
    for (int i = 0; i < stack.count(); ++i)
        steps.append(stack.text(i));
    QCOMPARE(steps, texts);
    QCOMPARE(stack.index(), done);
    const auto is = [&model](const QString &wanted) {
        const QStringList words = wanted.split(u' ');
        const ParameterSpec *spec = model.edited().parameters().find(words[1]);
        return spec && told(*spec, model.edited(), words[0].toInt() - 1) == words[2];
    };
    for (const QString &value : values)
        QVERIFY2(is(value), qPrintable(value));
    const auto changes = qsizetype(model.changes().size());
    QCOMPARE(changes, values.size());
    if (texts.contains(u"Profile name"_s))
        QCOMPARE(model.edited().profileName(2), u"Night ½"_s);
    if (texts.contains(u"Scripts"_s)) {
        const auto families = allFamilies();
        const Family *family = findFamily(families, u"storm32"_s);
        QCOMPARE(family->scripts->text(model.edited(), 0).simplified(),
                 u"WAIT 5 SETANGLEPITCH -12.34 STOP"_s);
        QCOMPARE(family->scripts->text(model.edited(), 1).simplified(), u"WAIT 7 STOP"_s);
    }
    stack.redo();
    for (const QString &value : redone)
        QVERIFY2(is(value), qPrintable(value));
    while (stack.canUndo())
        stack.undo();
    QCOMPARE(model.changeCount(), 0);
    QCOMPARE(differences(model.edited(), data(u"history/%1.values"_s.arg(serial))), QString());
}

void TestOldFiles::settings_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("address");
    QTest::addColumn<QStringList>("rates");
    QTest::newRow("simplebgc") << u"simplebgc"_s << u"sim:simplebgc?firmware=2.59"_s
                               << QStringList{u"gyro.roll"_s, u"gyro.pitch"_s, u"gyro.yaw"_s};
    QTest::newRow("storm32") << u"storm32"_s << u"sim:storm32?firmware=0.96"_s
                             << QStringList{u"gyro.x"_s, u"gyro.y"_s, u"gyro.z"_s};
}

void TestOldFiles::settings()
{
    QFETCH(QString, name);
    QFETCH(QString, address);
    QFETCH(QStringList, rates);
    QTemporaryDir dir;
    const QString path = dir.filePath(u"gimbaldesk.ini"_s);
    QVERIFY(QFile::copy(data(u"settings/%1.ini"_s.arg(name)), path));
    const Settings settings(path);
    QCOMPARE(settings.theme(), Settings::ThemeChoice::Dark);
    QCOMPARE(settings.language(), u"de"_s);
    QVERIFY(settings.fahrenheit());
    QCOMPARE(settings.retentionMinutes(), 25);
    QCOMPARE(settings.escapeHoldMs(), 1200);
    QCOMPARE(settings.controlSpeedLimit(), 45);
    QCOMPARE(settings.disarmSeconds(), 33);
    QVERIFY(settings.motorsOffOnQuit());
    QCOMPARE(settings.lastAddress(), address);
    QVERIFY(LinkAddress::parse(settings.lastAddress()));
    QCOMPARE(settings.plotLayouts(), QStringList{u"My plots / 50 %"_s});

    const auto families = allFamilies();
    const auto device = findFamily(families, name)->makeDevice();
    const PlotLayout layout
        = PlotLayout::fromJson(settings.plotLayout(u"My plots / 50 %"_s), device->channels());
    QCOMPARE(layout.seconds, 10.0);
    QCOMPARE(layout.plots.size(), 2);
    QStringList shown;
    for (const PlotLayout::Plot &plot : layout.plots) {
        QVERIFY(!plot.ownScales && !plot.figures);
        for (const int channel : plot.channels)
            shown.append(QString::fromUtf8(device->channels()[std::size_t(channel)].key));
    }
    QCOMPARE(shown, (QStringList{u"imu.angle.roll"_s, u"imu.angle.pitch"_s, u"imu.angle.yaw"_s} + rates));
}

void TestOldFiles::calibrations()
{
    const auto families = allFamilies();
    const Family *family = findFamily(families, u"storm32"_s);
    const auto read = family->calibrationFile->read(bytes(data(u"calibrations/six-points.cal"_s)));
    QVERIFY2(read, read ? "" : qPrintable(read.error().detail));
    QCOMPARE(*read, (SensorCalibration{{-12, 130, 7}, {8192, 8100, 8301}, u"6 point"_s, 31.5}));
}

QTEST_MAIN(TestOldFiles)
#include "tst_oldfiles.moc"
