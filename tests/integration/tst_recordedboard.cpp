// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/composition/composition.h"
#include "protocol/analysis/spectrum.h"
#include "protocol/client/deviceclient.h"
#include "protocol/client/replaycontrol.h"
#include "protocol/record/recordedboard.h"
#include "protocol/record/recorder.h"
#include "protocol/record/replaystore.h"
#include "protocol/telemetry/streams.h"
#include "protocol/telemetry/telemetryplan.h"
#include "protocol/telemetry/telemetrystore.h"
#include "protocol/telemetry/uniformsamples.h"
#include "protocol/transport/replay.h"
#include "tests/support/patience.h"
#include "widgets/models/channelmodel.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

using Kind = RecordedPiece::Kind;

constexpr double kAllTime = 1e12;

Family familyOf(const QString &key)
{
    for (const Family &family : allFamilies()) {
        if (family.key == key)
            return family;
    }
    qFatal("no such family");
}

/// The samples of a channel that are numbers, oldest first. What came before the subscription took effect may
/// be a track of its own.
std::vector<double> numbersOf(const TelemetryStore &store, int channel)
{
    std::vector<double> numbers;
    const auto tracks = store.tracks(channel);
    if (tracks.empty())
        return numbers;
    const TrackView &track
        = *std::max_element(tracks.begin(), tracks.end(), [](const TrackView &one, const TrackView &other) {
              return one.end() < other.end();
          });
    for (std::size_t row = track.begin(); row < track.end(); ++row) {
        if (!std::isnan(track.value(row)))
            numbers.push_back(track.value(row));
    }
    return numbers;
}

}  // namespace

/// Whoever reads a recording sees the values that were seen while it was made.
class TestRecordedBoard : public QObject
{
    Q_OBJECT
private slots:
    void readersAgree_data();
    void readersAgree();
    void readersMeasureTheSame_data() { readersAgree_data(); }
    void readersMeasureTheSame();
    void openingStandsIn();
    void lostPacketsHideNoAnswer();
    void holesAreTold_data();
    void holesAreTold();

private:
    /// What gimbalctl prints.
    QByteArray ctl(const QStringList &arguments)
    {
        QProcess process;
        process.start(u"" GIMBAL_BIN_DIR "/gimbalctl"_s, arguments);
        const bool isDone
            = QTest::qWaitFor([&] { return process.state() == QProcess::NotRunning; }, kPatience);
        if (!isDone || process.exitCode() != 0)
            qWarning() << process.readAllStandardError();
        return process.readAllStandardOutput();
    }
    /// Connects, watches for a while, and keeps what passed over the link.
    bool record(const QString &link, const QString &family, quint64 rows);

    QTemporaryDir m_dir;
    QString m_file = m_dir.filePath(u"r.gdrec"_s);
    std::shared_ptr<const TelemetryStore> m_live;
};

bool TestRecordedBoard::record(const QString &link, const QString &family, quint64 rows)
{
    Recorder recorder;
    DeviceClient client(allLinks().transports, allFamilies());
    client.addListener(recorder);
    client.connectTo(*LinkAddress::parse(link), family);
    if (!QTest::qWaitFor([&] { return client.isConnected(); }, kPatience))
        return false;
    const ChannelRoles roles = client.roles();
    client.subscribe({QList<int>(roles.gyro.begin(), roles.gyro.end()), 0});
    if (!QTest::qWaitFor([&] { return client.telemetry()->rows() > rows; }, kPatience))
        return false;
    m_live = client.telemetry();
    auto task = RecordingTask::start(recorder, m_file,
                                     recordingDescription(client.identity(), client.address()), true);
    client.shutDown();
    client.removeListener(recorder);
    return task && (*task)->finish();
}

void TestRecordedBoard::readersAgree_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<QString>("firmware");
    for (const char *firmware : {"2.40", "2.59", "2.66", "2.68", "2.73.8"})
        QTest::addRow("simplebgc %s", firmware) << u"simplebgc"_s << QString::fromLatin1(firmware);
    for (const char *firmware : {"0.79", "0.90", "0.96"})
        QTest::addRow("storm32 %s", firmware) << u"storm32"_s << QString::fromLatin1(firmware);
}

// Live, decoded at once, played back, and exported by the other program: the same to the last digit.
void TestRecordedBoard::readersAgree()
{
    QFETCH(QString, family);
    QFETCH(QString, firmware);
    QVERIFY(record(u"sim:%1?firmware=%2&seed=5"_s.arg(family, firmware), family, 40));

    const auto recording = Recording::load(m_file);
    QVERIFY(recording);
    const Family made = familyOf(family);
    const auto device = made.makeDevice();
    const auto decoded = readTelemetry(*recording, made, *device);
    QVERIFY2(decoded, qPrintable(decoded ? QString() : decoded.error().detail));
    QCOMPARE(device->identity().firmware.section(u'b', 0, 0), firmware);

    DeviceClient player(allLinks().transports, allFamilies());
    player.connectTo(*LinkAddress::parse(u"replay:%1?speed=20"_s.arg(m_file)), family);
    QTRY_VERIFY(player.isConnected());
    QTRY_VERIFY(player.telemetry()->rows() >= m_live->rows());

    const QString csv = m_dir.filePath(u"r.csv"_s);
    QProcess ctl;
    ctl.start(u"" GIMBAL_BIN_DIR "/gimbalctl"_s, {u"export"_s, m_file, u"--csv"_s, csv});
    QVERIFY(ctl.waitForFinished(kPatience));
    QVERIFY2(ctl.exitCode() == 0, ctl.readAllStandardError());
    QFile file(csv);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QStringList heading = QString::fromUtf8(file.readLine()).trimmed().split(u',');
    std::vector<QStringList> exported(std::size_t(heading.size()));
    while (!file.atEnd()) {
        const QStringList cells = QString::fromUtf8(file.readLine()).trimmed().split(u',');
        for (qsizetype i = 0; i < cells.size(); ++i) {
            if (!cells[i].isEmpty())
                exported.at(std::size_t(i)).append(cells[i]);
        }
    }

    int compared = 0;
    const ChannelTable channels = device->channels();
    for (int channel = 0; channel < int(channels.size()); ++channel) {
        const auto live = numbersOf(*m_live, channel);
        const QString key = QString::fromLatin1(channels[std::size_t(channel)].key);
        const auto one = numbersOf(**decoded, channel);
        const auto two = numbersOf(*player.telemetry(), channel);
        QVERIFY2(one.size() >= live.size() && two.size() >= live.size(), qPrintable(key));
        // What came before the data were asked for is in the recording too.
        const auto holdsLive = [&live](const std::vector<double> &all) {
            return live.empty() || std::search(all.begin(), all.end(), live.begin(), live.end()) != all.end();
        };
        QVERIFY2(holdsLive(one) && holdsLive(two), qPrintable(key));
        const auto column = std::find_if(heading.begin(), heading.end(), [&key](const QString &name) {
            return name == key || name.startsWith(key + u' ');
        });
        if (live.empty())
            continue;
        QVERIFY2(column != heading.end(), qPrintable(key));
        const auto &cells = exported[std::size_t(column - heading.begin())];
        // A channel of two streams stands in one column.
        qsizetype at = -1;
        for (const double value : live) {
            at = cells.indexOf(QString::number(value, 'g', 7), at + 1);
            QVERIFY2(at >= 0, qPrintable(key));
        }
        ++compared;
    }
    QVERIFY2(compared >= 3, qPrintable(QString::number(compared)));
}

// What `monitor` prints while the recording is played, what `analyze` finds in it, and what the screen shows
// at its end: made of the same values.
void TestRecordedBoard::readersMeasureTheSame()
{
    QFETCH(QString, family);
    QFETCH(QString, firmware);
    QVERIFY(record(u"sim:%1?firmware=%2&seed=5&fault=shake=3"_s.arg(family, firmware), family, 400));
    const auto recording = Recording::load(m_file);
    QVERIFY(recording);
    const Family made = familyOf(family);
    const auto device = made.makeDevice();
    const auto decoded = readTelemetry(*recording, made, *device);
    QVERIFY(decoded);
    const TelemetryStore &store = **decoded;
    const ChannelTable channels = device->channels();
    const ChannelRoles roles = rolesOf(*device);

    QStringList keys;
    for (const int gyro : roles.gyro)
        keys.append(QString::fromLatin1(channels[std::size_t(gyro)].key));
    const QByteArray printed = ctl(
        {u"--link"_s, u"replay:%1?speed=20"_s.arg(m_file), u"monitor"_s, u"--channels"_s, keys.join(u',')});
    const QJsonObject found = QJsonDocument::fromJson(ctl({u"--json"_s, u"analyze"_s, u"spectrum"_s, m_file,
                                                           u"--channels"_s, keys.join(u',')}))
                                  .object();
    for (std::size_t axis = 0; axis < roles.gyro.size(); ++axis) {
        const int gyro = roles.gyro[axis];
        const QString key = keys[qsizetype(axis)];
        const std::vector<double> live = numbersOf(*m_live, gyro);
        QVERIFY(live.size() > 100);
        QStringList cells;
        for (const QByteArray &line : printed.trimmed().split('\n').mid(1))
            cells.append(QString::fromLatin1(line.split(',').value(qsizetype(axis) + 1)));
        qsizetype at = -1;
        for (const double value : live) {
            at = cells.indexOf(QString::number(value, 'g', 7), at + 1);
            QVERIFY2(at >= 0, qPrintable(u"%1 %2"_s.arg(key).arg(value)));
        }

        const QJsonObject measured = found.value(key).toObject();
        const double resolution = measured.value(u"resolutionHz"_s).toDouble();
        QVERIFY2(resolution > 0, qPrintable(key));
        const auto samples = uniformSamples(store, gyro, -1, -kAllTime, kAllTime);
        QVERIFY(samples);
        const int length = int(std::lround(samples->rate / resolution));
        const auto wanted = spectrum(samples->values, samples->rate, {length, 0.5, WindowShape::Hann});
        QVERIFY(wanted);
        const QJsonArray density = measured.value(u"density"_s).toArray();
        QCOMPARE(std::size_t(density.size()), wanted->density.size());
        for (std::size_t bin = 0; bin < wanted->density.size(); ++bin)
            QCOMPARE(density[qsizetype(bin)].toDouble(), wanted->density[bin]);
    }

    DeviceClient player(allLinks().transports, allFamilies());
    player.connectTo(*LinkAddress::parse(u"replay:%1?speed=20"_s.arg(m_file)), family);
    QTRY_VERIFY(player.replay().state() && player.replay().state()->hasEnded());
    ChannelModel shown;
    shown.reset(player.device()->channels(), player.telemetry());
    int compared = 0;
    for (int group = 0; group < shown.rowCount(); ++group) {
        const QModelIndex parent = shown.index(group, 0);
        for (int row = 0; row < shown.rowCount(parent); ++row) {
            const int channel
                = shown.index(row, ChannelModel::NameColumn, parent).data(ChannelModel::ChannelRole).toInt();
            const float value = m_live->latest(channel);
            const ChannelSpec &spec = channels[std::size_t(channel)];
            if (std::isnan(value) || spec.elements > 1)
                continue;
            const QModelIndex now = shown.index(row, ChannelModel::ValueColumn, parent);
            const QString meaning
                = spec.choices.empty() ? QString() : choicesText(spec.choices, double(value), spec.areBits);
            QTRY_COMPARE(now.data().toString(),
                         meaning.isEmpty() ? numberText(double(value), spec.decimals) : meaning);
            ++compared;
        }
    }
    QVERIFY(compared >= 3);
}

// Damage at the place where the board said who it is takes that away from nobody.
void TestRecordedBoard::openingStandsIn()
{
    QVERIFY(record(u"sim:storm32?firmware=0.96&seed=5"_s, u"storm32"_s, 20));
    auto recording = Recording::load(m_file);
    QVERIFY(recording && !recording->opening.empty());
    std::erase_if(recording->pieces, [](const RecordedPiece &piece) { return piece.kind == Kind::Reply; });
    const Family family = familyOf(u"storm32"_s);
    const auto device = family.makeDevice();
    const auto identity = identifyRecorded(*recording, family, *device);
    QVERIFY(identity);
    QCOMPARE(identity->firmware, u"0.96"_s);
    QVERIFY(readTelemetry(*recording, family, *family.makeDevice()));

    // Without both, nothing is claimed.
    recording->opening.clear();
    const auto without = readTelemetry(*recording, family, *family.makeDevice());
    QVERIFY(!without);
    QCOMPARE(without.error().code, ErrorCode::BadFile);
}

// In a network that loses packets, questions overlap: between one and its answer others are answered, and
// some never are. What is played tells the board all the same.
void TestRecordedBoard::lostPacketsHideNoAnswer()
{
    const QByteArray ping = QByteArray::fromHex("8100000000");
    const QByteArray beat = QByteArray::fromHex("8112340002");
    const QByteArray status = QByteArray::fromHex("85");
    const QByteArray state = QByteArray::fromHex("8500000005");
    Recording recording;
    recording.description = {{u"family"_s, u"bcflight"_s}, {u"packets"_s, true}};
    qint64 at = 0;
    const auto add = [&](Kind kind, const QByteArray &bytes) {
        recording.pieces.push_back({kind, at, bytes});
        at += 50'000'000;
    };
    const auto answer = [&](const QByteArray &bytes) {
        add(Kind::Received, bytes);
        add(Kind::Reply, bytes);
    };
    add(Kind::Sent, ping);
    add(Kind::Sent, beat);
    answer(beat);
    add(Kind::Sent, ping);
    add(Kind::Sent, status);
    add(Kind::Sent, beat);
    answer(state);
    answer(ping);
    QVERIFY(RecordedAnswers(recording).find(ping, at).contains(ping));
    QVERIFY(RecordedAnswers(recording).find(ping, 0).contains(ping));
    QVERIFY(RecordedAnswers(recording).find(status, 0).contains(state));
    QVERIFY(RecordedAnswers(recording).find(QByteArray("\x89"), 0).isEmpty());
    // Asked once more, while the answer was under way.
    add(Kind::Sent, ping);
    add(Kind::Sent, status);
    answer(state);
    QVERIFY(RecordedAnswers(recording).find(ping, at).contains(ping));
    QVERIFY(RecordedAnswers(recording).find(status, at).contains(state));
    std::swap(recording.opening, recording.pieces);
    std::erase_if(recording.opening, [](const RecordedPiece &piece) { return piece.kind == Kind::Received; });
    QVERIFY(RecordedAnswers(recording).find(ping, 0).contains(ping));
    QVERIFY(RecordedAnswers(recording).find(status, 0).contains(state));
}

void TestRecordedBoard::holesAreTold_data()
{
    QTest::addColumn<QString>("family");
    QTest::addColumn<int>("holes");
    for (const QString &family : {u"simplebgc"_s, u"storm32"_s}) {
        for (const int holes : {0, 1, 2})
            QTest::addRow("%s, %d", qPrintable(family), holes) << family << holes;
    }
}

// Times at which nothing came are in what is said of a recording, whoever reads it.
void TestRecordedBoard::holesAreTold()
{
    QFETCH(QString, family);
    QFETCH(int, holes);
    QVERIFY(record(u"sim:%1?seed=6"_s.arg(family), family, family == u"simplebgc"_s ? 4000 : 300));
    auto recording = Recording::load(m_file);
    QVERIFY(recording);
    auto writer = RecordingWriter::create(m_file, recording->description);
    QVERIFY(writer);
    const qint64 end = recording->end();
    for (const RecordedPiece &piece : recording->pieces) {
        const double left = double(end - piece.at) * 1e-9;
        const bool isInHole
            = (holes > 0 && left > 0.5 && left < 1.2) || (holes > 1 && left > 1.9 && left < 2.6);
        if (piece.kind == Kind::Sent || !isInHole)
            QVERIFY(writer->append(piece));
    }
    QVERIFY(writer->flush());
    const QRegularExpression told(holes == 0       ? u" rows, "_s
                                      : holes == 1 ? u"nothing came once, for 0[.][78] s"_s
                                                   : u"nothing came 2 times, for 1[.][45] s in all"_s);
    for (const QStringList &command : {QStringList{u"export"_s}, QStringList{u"analyze"_s, u"spectrum"_s},
                                       QStringList{u"analyze"_s, u"holding"_s}}) {
        QProcess ctl;
        ctl.start(u"" GIMBAL_BIN_DIR "/gimbalctl"_s,
                  QStringList{u"--json"_s} + command + QStringList{m_file});
        QVERIFY(ctl.waitForFinished(kPatience));
        const QString err = QString::fromUtf8(ctl.readAllStandardError());
        QVERIFY2(err.contains(told), qPrintable(err));
        QCOMPARE(err.contains(u"nothing came"_s), holes > 0);
        const QByteArray out = ctl.readAllStandardOutput();
        if (ctl.exitCode() == 0 && command.first() == u"analyze"_s)
            QCOMPARE(QJsonDocument::fromJson(out)[u"holes"_s][u"count"_s].toInt(), holes);
    }
}

QTEST_GUILESS_MAIN(TestRecordedBoard)
#include "tst_recordedboard.moc"
