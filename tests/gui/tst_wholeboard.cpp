// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/simplebgc/calibrationpage.h"
#include "app/families/simplebgc/copycard.h"
#include "app/families/simplebgc/wholeboardpage.h"
#include "protocol/configuration/memoryimage.h"
#include "protocol/device/device.h"
#include "tests/support/patience.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/panel.h"

#include <QCheckBox>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QTableWidget>

using namespace Qt::StringLiterals;

/// Copies of a SimpleBGC board and of its calibrations, on their pages.
class TestWholeBoard final : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_rig = std::make_unique<WindowRig>(); }
    void cleanup() { m_rig.reset(); }
    void boardIsCopiedComparedAndRestored();
    void anotherBoardIsAskedFor();
    void filesAreErasedOnceConfirmed();
    void linkThatBreaksIsTold();
    void calibrationsAreCompared();
    void boardWithoutCommandOffersNone();

private:
    bool open() { return m_rig->open(u"sim:simplebgc?firmware=2.70.4"_s) && m_rig->jobsAreDone(); }
    static bool isDone(const CopyCard &card)
    {
        return QTest::qWaitFor([&card] { return !card.isRunning(); }, kPatience);
    }
    bool answer(const char *name)
    {
        const auto box = [this] { return qobject_cast<QMessageBox *>(m_rig->window().panels()->newest()); };
        if (!QTest::qWaitFor([&box] { return box() != nullptr; }, kPatience))
            return false;
        auto *button = box()->findChild<QPushButton *>(QLatin1String(name));
        if (button)
            button->click();
        else
            box()->reject();
        return true;
    }
    void change(const QString &key, int raw)
    {
        const ParameterSpec spec = m_rig->spec(key);
        m_rig->client().submit<void>([spec, raw](Channel &channel, Device &device) -> Result<void> {
            auto bytes = device.readBlock(channel, {0, spec.row->block});
            if (!bytes)
                return tl::unexpected(bytes.error());
            spec.write(*bytes, raw);
            return device.writeBlock(channel, {0, spec.row->block}, *bytes);
        });
        QVERIFY(m_rig->jobsAreDone());
    }
    [[nodiscard]] static QStringList rows(const CopyCard &card)
    {
        QStringList all;
        for (int row = 0; row < card.table()->rowCount(); ++row) {
            QStringList cells;
            for (int column = 0; column < card.table()->columnCount(); ++column)
                cells.append(card.table()->item(row, column)->text());
            all.append(cells.join(u'|'));
        }
        return all;
    }

    std::unique_ptr<WindowRig> m_rig;
};

void TestWholeBoard::boardIsCopiedComparedAndRestored()
{
    QVERIFY(open());
    CopyCard &card = *m_rig->page<WholeBoardPage>()->card();
    const QString path = m_rig->filePath(u"board.bin"_s);
    card.run(card.ways()[WholeBoardPage::Save], path);
    QVERIFY(isDone(card));
    QCOMPARE(card.finding(), u"32768 byte(s) of memory are copied. 0 file(s) are copied."_s);
    card.run(card.ways()[WholeBoardPage::Compare], path);
    QVERIFY(isDone(card));
    QCOMPARE(card.finding(), u"The board holds what the copy does."_s);
    QVERIFY(!card.table()->isVisible());
    change(u"motor.pitch.power"_s, 99);
    card.run(card.ways()[WholeBoardPage::Compare], path);
    QVERIFY(isDone(card));
    QVERIFY2(card.finding().contains(u"of memory differ."_s), qPrintable(card.finding()));
    const QStringList told = rows(card).filter(QRegularExpression(u"^Profile 1: .*\\|150\\|99$"_s));
    QVERIFY2(told.size() == 1, qPrintable(rows(card).join(u'\n')));
    // Nothing is written without an answer.
    card.run(card.ways()[WholeBoardPage::RestoreAll], path);
    QVERIFY(answer("none"));
    QVERIFY(isDone(card));
    card.run(card.ways()[WholeBoardPage::RestoreAll], path);
    QVERIFY(answer("danger"));
    QVERIFY(isDone(card));
    QVERIFY2(card.finding().contains(u"byte(s) of memory were written."_s), qPrintable(card.finding()));
    QVERIFY(card.finding().contains(u"after a restart"_s));
}

void TestWholeBoard::anotherBoardIsAskedFor()
{
    QVERIFY(open());
    CopyCard &card = *m_rig->page<WholeBoardPage>()->card();
    const QString path = m_rig->filePath(u"board.bin"_s);
    card.run(card.ways()[WholeBoardPage::Save], path);
    QVERIFY(isDone(card));
    auto image = MemoryImage::load(path);
    QVERIFY(image);
    image->serial = u"0102"_s;
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(image->encode());
    file.close();
    const auto restore = [&](WholeBoardPage::Way way) {
        card.run(card.ways()[way], path);
        return answer("danger") && isDone(card);
    };
    QVERIFY(restore(WholeBoardPage::RestoreAll));
    QVERIFY2(card.finding().contains(u"another board"_s), qPrintable(card.finding()));
    QVERIFY(restore(WholeBoardPage::RestoreSettings));
    QVERIFY2(card.finding().contains(u"0 byte(s) of memory were written"_s), qPrintable(card.finding()));
    card.other()->setChecked(true);
    QVERIFY(restore(WholeBoardPage::RestoreAll));
    QVERIFY2(card.finding().contains(u"were written"_s), qPrintable(card.finding()));
}

void TestWholeBoard::filesAreErasedOnceConfirmed()
{
    QVERIFY(open());
    CopyCard &card = *m_rig->page<WholeBoardPage>()->card();
    const QString path = m_rig->filePath(u"before.bin"_s);
    card.run(card.ways()[WholeBoardPage::EraseFiles], path);
    QVERIFY(answer("none"));
    QVERIFY(isDone(card));
    QVERIFY(!QFile::exists(path));
    card.run(card.ways()[WholeBoardPage::EraseFiles], path);
    QVERIFY(answer("danger"));
    QVERIFY(isDone(card));
    QCOMPARE(card.finding(), u"0 file(s) were written or erased."_s);
    QVERIFY(MemoryImage::load(path));
}

void TestWholeBoard::linkThatBreaksIsTold()
{
    QVERIFY(open());
    CopyCard &card = *m_rig->page<WholeBoardPage>()->card();
    const QString path = m_rig->filePath(u"board.bin"_s);
    card.run(card.ways()[WholeBoardPage::Save], path);
    m_rig->workspace().changeWorld(u"unplug=0"_s);
    QVERIFY(isDone(card));
    QVERIFY(!QFile::exists(path));
    QVERIFY(!card.finding().isEmpty() && !card.finding().contains(u"copied"_s));
    QTRY_VERIFY_WITH_TIMEOUT(m_rig->client().isConnected() && card.button(0)->isEnabled(), 30000);
    card.run(card.ways()[WholeBoardPage::Save], path);
    QVERIFY(isDone(card));
    QVERIFY2(card.finding().contains(u"32768 byte(s) of memory are copied"_s), qPrintable(card.finding()));
}

void TestWholeBoard::calibrationsAreCompared()
{
    QVERIFY(open());
    CopyCard &card = *m_rig->page<CalibrationPage>()->copies();
    const QString path = m_rig->filePath(u"calibration.bin"_s);
    card.run(card.ways()[0], path);
    QVERIFY(isDone(card));
    QCOMPARE(card.finding(), u"0 file(s) are copied."_s);
    m_rig->workspace().perform(u"calibrate.gyro"_s, {{u"imu"_s, 1}, {u"action"_s, 1}, {u"form"_s, 0}});
    QVERIFY(m_rig->jobsAreDone());
    card.run(card.ways()[1], path);
    QVERIFY(isDone(card));
    QVERIFY2(card.finding().startsWith(u"1 file(s) differ."_s), qPrintable(card.finding()));
    QCOMPARE(rows(card), QStringList{u"File imu-calibration 0|not there|36 byte(s)"_s});
    card.run(card.ways()[2], path);
    QVERIFY(answer("danger"));
    QVERIFY(isDone(card));
    QVERIFY2(card.finding().contains(u"no calibration"_s), qPrintable(card.finding()));
}

void TestWholeBoard::boardWithoutCommandOffersNone()
{
    CopyCard &card = *m_rig->page<WholeBoardPage>()->card();
    for (int way = 0; way < int(card.ways().size()); ++way)
        QVERIFY(!card.button(way)->isEnabled());
    QVERIFY(open());
    QVERIFY(card.button(WholeBoardPage::Save)->isEnabled());
    QVERIFY(card.button(WholeBoardPage::EraseFiles)->isEnabled());
}

QTEST_MAIN(TestWholeBoard)
#include "tst_wholeboard.moc"
