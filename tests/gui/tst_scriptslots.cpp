// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/simplebgc/scriptslotspage.h"
#include "app/mainwindow/navigation.h"
#include "protocol/device/device.h"
#include "tests/support/named.h"
#include "tests/support/patience.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/panel.h"

#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QTableWidget>

using namespace Qt::StringLiterals;

namespace {

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

}  // namespace

#define SHOWS(text, words) QTRY_VERIFY2_WITH_TIMEOUT((text).contains(words), qPrintable(text), kPatience)

/// Compiled scripts of a SimpleBGC board on their page.
class TestScriptSlots final : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_rig = std::make_unique<WindowRig>(); }
    void cleanup() { m_rig.reset(); }
    void scriptsGoThereAndBack();
    void whatWasThereIsRestored();
    void olderBoardHasFiveSlots();
    void wrongFilesAreNotWritten();
    void whatIsRefusedIsTakenBack();
    void cancelTakesItBack();
    void brokenUploadIsKnown_data();
    void brokenUploadIsKnown();
    void runIsAskedForEachTime();
    void scriptIsFollowedToItsEnd();
    void stopMotorsEndsAFollowedScript();
    void firstBoardsHaveNone();

private:
    bool open(const QString &more = {})
    {
        if (!m_rig->open(u"sim:simplebgc?firmware=2.70.4"_s + more) || !m_rig->jobsAreDone())
            return false;
        m_page = m_rig->page<ScriptSlotsPage>();
        return isRead();
    }
    bool isRead()
    {
        return QTest::qWaitFor(
            [this] { return m_page->table()->rowCount() > 0 && button(u"Read again")->isEnabled(); },
            kPatience);
    }
    QPushButton *button(QStringView text) { return named<QPushButton>(m_page, text.toString()); }
    void click(const QString &text) { QTest::mouseClick(button(text), Qt::LeftButton); }
    [[nodiscard]] QString cell(int slot, int column = 1) const
    {
        return m_page->table()->item(slot - 1, column)->text();
    }
    QString put(const QString &name, const QByteArray &content)
    {
        QFile file(m_rig->filePath(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size())
            qFatal("no file");
        return file.fileName();
    }
    bool load(int slot, const QByteArray &content)
    {
        m_page->table()->selectRow(slot - 1);
        m_page->loadFrom(put(u"new.bin"_s, content));
        return isRead();
    }
    QMessageBox *question()
    {
        QMessageBox *box = nullptr;
        std::ignore = QTest::qWaitFor(
            [&] {
                box = qobject_cast<QMessageBox *>(m_rig->window().panels()->newest());
                return box != nullptr;
            },
            kPatience);
        return box;
    }
    void answer(const QString &name)
    {
        auto *box = question();
        QVERIFY(box);
        auto *yes = box->findChild<QPushButton *>(name);
        QVERIFY(yes);
        QTRY_VERIFY(yes->isEnabled());
        yes->click();
    }
    bool restore(int entry)
    {
        QMenu *menu = m_page->copies();
        emit menu->aboutToShow();
        if (menu->actions().size() <= entry)
            return false;
        menu->actions().at(entry)->trigger();
        return isRead();
    }

    std::unique_ptr<WindowRig> m_rig;
    ScriptSlotsPage *m_page = nullptr;
};

void TestScriptSlots::scriptsGoThereAndBack()
{
    QVERIFY(open());
    QCOMPARE(m_page->table()->rowCount(), 10);
    QCOMPARE(m_page->finding(), u"0 of 10 slots hold a script."_s);
    for (const char *text : {"Save…", "Restore", "Erase", "Run…", "Run and follow…"})
        QVERIFY(!button(QString::fromUtf8(text))->isEnabled());
    QVERIFY(load(2, QByteArray(500, 'a')));
    QCOMPARE(m_page->finding(), u"Slot 2 holds the script, read back byte for byte: 500 byte(s)."_s);
    QCOMPARE(cell(2), u"500 byte(s)"_s);
    QVERIFY(!button(u"Restore")->isEnabled());
    const QString path = m_rig->filePath(u"saved.bin"_s);
    m_page->saveTo(path);
    QVERIFY(isRead());
    QCOMPARE(contentOf(path), QByteArray(500, 'a'));
    // The same once more is nothing new.
    QVERIFY(load(2, QByteArray(500, 'a')));
    QCOMPARE(m_page->finding(), u"Slot 2 held this script already."_s);
}

void TestScriptSlots::whatWasThereIsRestored()
{
    QVERIFY(open());
    QVERIFY(load(1, "first"));
    QVERIFY(load(1, "second!"));
    QVERIFY(m_page->finding().endsWith(u"What was in it is kept, and can be restored."_s));
    click(u"Erase"_s);
    QVERIFY(isRead());
    QCOMPARE(cell(1), u"empty"_s);
    QVERIFY(!cell(1, 2).isEmpty());
    // The newest stands first.
    QVERIFY(restore(0));
    QCOMPARE(cell(1), u"7 byte(s)"_s);
    QVERIFY(restore(1));
    QCOMPARE(cell(1), u"5 byte(s)"_s);
    // They belong to the board, and are there after a restart of the program.
    m_rig->restart();
    QVERIFY(open());
    m_page->table()->selectRow(0);
    QVERIFY(button(u"Restore")->isEnabled());
}

void TestScriptSlots::olderBoardHasFiveSlots()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?firmware=2.59.0"_s) && m_rig->jobsAreDone());
    m_page = m_rig->page<ScriptSlotsPage>();
    QVERIFY(isRead());
    QCOMPARE(m_page->table()->rowCount(), 5);
    QVERIFY(load(5, QByteArray(8, 'x')));
    // Such firmware tells no events: nothing shows that it runs.
    click(u"Run…"_s);
    answer(u"danger"_s);
    SHOWS(m_page->running(), u"Script 5 was started"_s);
    SHOWS(m_page->about(), u"nothing shows whether it runs"_s);
}

void TestScriptSlots::wrongFilesAreNotWritten()
{
    QVERIFY(open());
    QVERIFY(load(1, "old"));
    QVERIFY(load(1, {}));
    QVERIFY2(m_page->finding().contains(u"empty"_s), qPrintable(m_page->finding()));
    QCOMPARE(cell(1), u"3 byte(s)"_s);
    QVERIFY(load(1, QByteArray(70000, 'x')));
    QVERIFY2(m_page->finding().contains(u"65535"_s) || m_page->finding().contains(u"large"_s),
             qPrintable(m_page->finding()));
    QCOMPARE(cell(1), u"3 byte(s)"_s);
    QVERIFY(button(u"Run…")->isEnabled());
}

void TestScriptSlots::whatIsRefusedIsTakenBack()
{
    QVERIFY(open());
    QVERIFY(load(1, QByteArray(60000, 'a')));
    QVERIFY(load(2, "old"));
    QVERIFY(load(2, QByteArray(20000, 'b')));
    QVERIFY2(m_page->finding().contains(u"no free space"_s), qPrintable(m_page->finding()));
    QVERIFY2(m_page->finding().contains(u"holds again what it held before"_s), qPrintable(m_page->finding()));
    QCOMPARE(cell(2), u"3 byte(s)"_s);
    QVERIFY(button(u"Run…")->isEnabled());
}

void TestScriptSlots::cancelTakesItBack()
{
    QVERIFY(open());
    QVERIFY(load(2, "old"));
    m_page->loadFrom(put(u"long.bin"_s, QByteArray(60000, 'b')));
    QSignalSpy progress(&m_rig->client(), &DeviceClient::progressChanged);
    QTRY_VERIFY(std::ranges::any_of(progress, [](const QVariantList &told) {
        return told.first().value<Progress>().step == u"write-file"_s;
    }));
    click(u"Cancel"_s);
    QVERIFY(isRead());
    QVERIFY2(m_page->finding().contains(u"holds again what it held before"_s), qPrintable(m_page->finding()));
    QCOMPARE(cell(2), u"3 byte(s)"_s);
}

void TestScriptSlots::brokenUploadIsKnown_data()
{
    QTest::addColumn<QString>("fault");
    QTest::newRow("link") << u"unplug=0"_s;
    QTest::newRow("restart") << u"reset=0"_s;
}

// Half a script must not run, also not after the program was started anew.
void TestScriptSlots::brokenUploadIsKnown()
{
    QFETCH(QString, fault);
    QVERIFY(open());
    QVERIFY(load(2, "old"));
    QSignalSpy progress(&m_rig->client(), &DeviceClient::progressChanged);
    m_page->loadFrom(put(u"long.bin"_s, QByteArray(60000, 'b')));
    QTRY_VERIFY(std::ranges::any_of(progress, [](const QVariantList &told) {
        const auto step = told.first().value<Progress>();
        return step.step == u"write-file"_s && step.done > 1000;
    }));
    m_rig->workspace().changeWorld(fault);
    QTRY_VERIFY_WITH_TIMEOUT(!m_page->isUnderWay(), kPatience);
    QTRY_VERIFY_WITH_TIMEOUT(m_rig->client().isConnected(), kPatience);
    QVERIFY(isRead());
    SHOWS(m_page->finding(), u"Writing slot 2 was broken off"_s);
    QVERIFY2(cell(2).contains(u"60000 byte(s), not certain"_s), qPrintable(cell(2)));
    m_page->table()->selectRow(1);
    QVERIFY(!button(u"Run…")->isEnabled() && !button(u"Run and follow…")->isEnabled());
    QVERIFY(restore(0));
    QCOMPARE(cell(2), u"3 byte(s)"_s);
    QVERIFY2(!m_page->finding().contains(u"broken off"_s), qPrintable(m_page->finding()));
    QVERIFY(button(u"Run…")->isEnabled());
}

void TestScriptSlots::runIsAskedForEachTime()
{
    QVERIFY(open());
    QVERIFY(load(3, QByteArray(200, 'x')));
    QTRY_COMPARE_WITH_TIMEOUT(m_rig->workspace().motorsRunning(), std::optional(true), kPatience);
    click(u"Run…"_s);
    QVERIFY(question());
    QVERIFY2(question()->text().contains(u"The motors are running."_s), qPrintable(question()->text()));
    question()->reject();
    QTRY_VERIFY(!m_rig->window().panels()->newest());
    QVERIFY(!m_page->isUnderWay());
    QCOMPARE(m_page->running(), u"Not known"_s);
    click(u"Run…"_s);
    answer(u"danger"_s);
    SHOWS(m_page->running(), u"Script 3 runs"_s);
    QVERIFY(isRead());
    click(u"Stop script"_s);
    SHOWS(m_page->running(), u"Stopped"_s);
    QVERIFY(isRead());
    click(u"Stop script"_s);
    SHOWS(m_page->running(), u"Told to stop"_s);
}

void TestScriptSlots::scriptIsFollowedToItsEnd()
{
    QVERIFY(open());
    QVERIFY(load(3, QByteArray(20, 'x')));
    click(u"Run and follow…"_s);
    answer(u"danger"_s);
    SHOWS(m_page->running(), u"Script 3: command 5"_s);
    SHOWS(m_page->running(), u"Script 3 has ended"_s);
    QVERIFY2(m_page->about().startsWith(u"Its last command was 20."_s), qPrintable(m_page->about()));
    const QListWidget *told = m_page->commands();
    QVERIFY(told->count() > 5 && told->count() <= 20);
    QVERIFY(told->item(told->count() - 1)->text().endsWith(u"s: command 20"_s));
    // And one that is stopped.
    QVERIFY(load(4, QByteArray(600, 'x')));
    click(u"Run and follow…"_s);
    answer(u"danger"_s);
    SHOWS(m_page->running(), u"Script 4: command 3"_s);
    click(u"Stop script"_s);
    SHOWS(m_page->running(), u"Script 4 was stopped"_s);
    QVERIFY(isRead());
}

void TestScriptSlots::stopMotorsEndsAFollowedScript()
{
    QVERIFY(open());
    QVERIFY(load(4, QByteArray(600, 'x')));
    click(u"Run and follow…"_s);
    answer(u"danger"_s);
    SHOWS(m_page->running(), u"Script 4: command 3"_s);
    QTest::keyClick(&m_rig->window(), Qt::Key_F12);
    SHOWS(m_page->running(), u"Script 4 was stopped"_s);
    QTRY_COMPARE_WITH_TIMEOUT(m_rig->workspace().motorsRunning(), std::optional(false), kPatience);
}

void TestScriptSlots::firstBoardsHaveNone()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?legacy=1"_s));
    QVERIFY(!m_rig->window().navigation()->isOffered(u"scriptslots"_s));
}

QTEST_MAIN(TestScriptSlots)
#include "tst_scriptslots.moc"
