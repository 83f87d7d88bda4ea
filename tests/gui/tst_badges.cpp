// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/linkbar.h"
#include "app/mainwindow/messagebar.h"
#include "app/mainwindow/translations.h"
#include "protocol/telemetry/telemetrystore.h"
#include "tests/support/patience.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/panel.h"

#include <QLabel>

#include <cmath>

using namespace Qt::StringLiterals;

/// What is simulated, replayed, read from a file or recorded is marked in the frame, on every page and in
/// every window, and where a replayed board was silent there is nothing to see.
class TestBadges : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_rig = std::make_unique<WindowRig>(); }
    void cleanup() { m_rig.reset(); }

    void everySourceIsMarkedInEveryWindow_data();
    void everySourceIsMarkedInEveryWindow();
    void silenceOfARecordingIsAGap_data();
    void silenceOfARecordingIsAGap();

private:
    // Texts of the badges that can be read in full.
    [[nodiscard]] QStringList badges() const
    {
        const auto *bar = m_rig->window().findChild<LinkBar *>();
        QStringList found;
        for (const QLabel *label : bar->findChildren<QLabel *>(u"badge"_s)) {
            const QRect place(label->mapTo(bar, QPoint()), label->size());
            if (label->isVisible() && bar->rect().contains(place)
                && label->width() >= label->sizeHint().width()
                && !place.intersects(bar->motorsButton()->geometry()))
                found.append(label->text());
        }
        return found;
    }
    bool record(const QString &path, double seconds)
    {
        if (!m_rig->workspace().recorder().start(path) || !m_rig->boardGoesOn(seconds))
            return false;
        m_rig->workspace().recorder().stop();
        return true;
    }

    std::unique_ptr<WindowRig> m_rig;
};

void TestBadges::everySourceIsMarkedInEveryWindow_data()
{
    QTest::addColumn<QString>("language");
    QTest::addColumn<QSize>("size");
    for (const char *language : {"en", "de"}) {
        QTest::addRow("%s, smallest", language) << QString::fromLatin1(language) << QSize(1024, 640);
        QTest::addRow("%s, small screen", language) << QString::fromLatin1(language) << QSize(560, 320);
        QTest::addRow("%s, large", language) << QString::fromLatin1(language) << QSize(1920, 1080);
    }
}

void TestBadges::everySourceIsMarkedInEveryWindow()
{
    QFETCH(const QString, language);
    QFETCH(const QSize, size);
    const Translations texts(language);
    m_rig = std::make_unique<WindowRig>();
    m_rig->window().setMinimumSize(size);
    m_rig->window().resize(size);
    const auto marks = [this](int count) {
        for (const PageEntry &entry : pageTable()) {
            if (!m_rig->window().navigation()->isOffered(QLatin1String(entry.key)))
                continue;
            m_rig->window().showPage(QLatin1String(entry.key));
            if (!QTest::qWaitFor([this, count] { return badges().size() == count; }, kPatience))
                return QLatin1String(entry.key) + u": "_s + badges().join(u", "_s);
        }
        return QString();
    };
    QVERIFY(m_rig->open());
    QCOMPARE(marks(1), QString());  // simulated
    const QString path = m_rig->filePath(u"short.gimbalrec"_s);
    QVERIFY(m_rig->workspace().recorder().start(path));
    QCOMPARE(marks(2), QString());  // and recorded
    QVERIFY(m_rig->boardGoesOn(0.5));
    m_rig->workspace().recorder().stop();
    // What a recording holds otherwise is no news of the board.
    m_rig->edit(u"pid.roll.p"_s, 0, 44);
    m_rig->workspace().write(std::as_const(m_rig->model()).edited());
    QTRY_COMPARE(m_rig->model().changeCount(), 0);
    QVERIFY(m_rig->jobsAreDone());
    m_rig->client().disconnectFromBoard();
    QTRY_COMPARE(m_rig->client().state(), DeviceClient::State::Disconnected);
    QCOMPARE(marks(1), QString());  // offline
    QVERIFY(m_rig->open(u"replay:"_s + path));
    QTRY_COMPARE(m_rig->raw(u"pid.roll.p"_s), 35.0);
    QCOMPARE(marks(1), QString());  // replayed
    const auto said = [this] { return m_rig->window().messageBar()->text(); };
    QVERIFY2(!said().contains(u"differ"_s), qPrintable(said()));
    // It has no cable and no power, and nothing is lost when another one is opened.
    m_rig->workspace().notifications().report({ErrorCode::Timeout, u"READ_PARAMS_EXT"_s, 0});
    QVERIFY2(said().contains(u"READ_PARAMS_EXT"_s) && !said().contains(u"cable"_s)
                 && !said().contains(u"Kabel"_s),
             qPrintable(said()));
    m_rig->window().openFile(path);
    QVERIFY(!m_rig->window().panels()->isOpen());
    QTRY_VERIFY(m_rig->client().isConnected() && m_rig->client().address().isReplay());
    m_rig->client().disconnectFromBoard();
    QTRY_COMPARE(m_rig->client().state(), DeviceClient::State::Disconnected);
    QVERIFY(m_rig->open());
    QVERIFY2(!said().contains(u"differ"_s), qPrintable(said()));
}

void TestBadges::silenceOfARecordingIsAGap_data()
{
    QTest::addColumn<QString>("address");
    QTest::addColumn<QString>("stop");
    QTest::addColumn<QString>("goOn");
    QTest::newRow("polled") << u"sim:storm32"_s << u"deaf=100"_s << u"deaf=-1"_s;
}

void TestBadges::silenceOfARecordingIsAGap()
{
    QFETCH(const QString, address);
    QFETCH(const QString, stop);
    QFETCH(const QString, goOn);
    QVERIFY(m_rig->open(address));
    const QString path = m_rig->filePath(u"silent.gimbalrec"_s);
    QVERIFY(m_rig->boardGoesOn(0.5));
    QVERIFY(m_rig->workspace().recorder().start(path));
    QVERIFY(m_rig->boardGoesOn(0.5));
    m_rig->workspace().changeWorld(stop);
    QTRY_VERIFY(m_rig->workspace().freshness().staleSince());
    m_rig->workspace().changeWorld(goOn);
    QTRY_VERIFY(!m_rig->workspace().freshness().staleSince());
    QVERIFY(m_rig->boardGoesOn(0.5));
    m_rig->workspace().recorder().stop();
    m_rig->client().disconnectFromBoard();
    QTRY_COMPARE(m_rig->client().state(), DeviceClient::State::Disconnected);
    QVERIFY(m_rig->open(u"replay:"_s + path));
    // Between the two parts there is a row without values, which no line is drawn across.
    const auto gaps = [this] {
        const auto store = m_rig->client().telemetry();
        const int channel = m_rig->workspace().roles().angle[1];
        int found = 0;
        for (const TrackView &track : store ? store->tracks(channel) : std::vector<TrackView>()) {
            for (std::size_t row = track.begin(); row < track.end(); ++row)
                found += std::isnan(track.value(row)) ? 1 : 0;
        }
        return found;
    };
    QTRY_VERIFY(gaps() > 0);
}

QTEST_MAIN(TestBadges)
#include "tst_badges.moc"
