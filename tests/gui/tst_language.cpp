// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/bars.h"
#include "app/mainwindow/messagebar.h"
#include "app/mainwindow/translations.h"
#include "app/pages/program/settingspage.h"
#include "app/pages/tune/responsepage.h"
#include "app/pages/watch/monitorpage.h"
#include "tests/support/named.h"
#include "tests/support/patience.h"
#include "tests/support/windowrig.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QComboBox>
#include <QFile>
#include <QHeaderView>
#include <QLabel>
#include <QSet>
#include <QTableView>

#include <atomic>

using namespace Qt::StringLiterals;

namespace {

// What stands on the screen whatever the board does: no figures.
void addText(QSet<QString> &texts, const QString &text)
{
    const bool hasFigure
        = std::any_of(text.begin(), text.end(), [](QChar character) { return character.isDigit(); });
    if (!hasFigure && text.size() > 3)
        texts.insert(text);
}

QSet<QString> textsIn(const QWidget &window)
{
    QSet<QString> texts;
    for (const QWidget *each : window.findChildren<QWidget *>()) {
        addText(texts, each->toolTip());
        addText(texts, each->accessibleName());
        if (const auto *label = qobject_cast<const QLabel *>(each))
            addText(texts, label->text());
        if (const auto *button = qobject_cast<const QAbstractButton *>(each))
            addText(texts, button->text());
        const auto *view = qobject_cast<const QAbstractItemView *>(each);
        for (int column = 0; view && view->model() && column < view->model()->columnCount(); ++column)
            addText(texts, view->model()->headerData(column, Qt::Horizontal).toString());
    }
    return texts;
}

}  // namespace

/// Another language is there as soon as it is chosen, and nothing is lost by it.
class TestLanguage : public QObject
{
    Q_OBJECT
private slots:
    void init();
    void cleanup();
    void everyPageChangesAtOnce_data();
    void everyPageChangesAtOnce();
    void whatPagesHoldGoesOn();
    void questionsStayOpen();
    void whatRunsIsWaitedFor();
    void itComesBack();

private:
    void visitAll();
    /// As the operator does it.
    void choose(const QString &code);
    [[nodiscard]] bool isGerman()
    {
        return m_rig->window().navigation()->findItems(u"Einstellungen"_s, Qt::MatchStartsWith).size() == 1;
    }

    std::unique_ptr<Translations> m_translations;
    std::unique_ptr<WindowRig> m_rig;
};

void TestLanguage::init()
{
    m_translations = std::make_unique<Translations>(u"en"_s);
    m_rig = std::make_unique<WindowRig>();
    connect(&m_rig->window(), &MainWindow::languageDue, this,
            [this](const QString &code) { m_translations->setLanguage(code); });
}

void TestLanguage::cleanup()
{
    m_rig.reset();
    m_translations.reset();
}

void TestLanguage::visitAll()
{
    for (const PageEntry &entry : pageTable())
        m_rig->window().showPage(QLatin1String(entry.key));
}

void TestLanguage::choose(const QString &code)
{
    auto *page = m_rig->page<SettingsPage>();
    QVERIFY(page);
    auto *box = named<QComboBox>(page, code == u"de"_s ? u"Language"_s : u"Sprache"_s);
    QVERIFY(box);
    box->setFocus();
    box->setCurrentIndex(box->findData(code));
    emit box->activated(box->currentIndex());
}

void TestLanguage::everyPageChangesAtOnce_data()
{
    QTest::addColumn<QString>("address");
    QTest::newRow("simplebgc") << u"sim:simplebgc"_s;
    QTest::newRow("storm32") << u"sim:storm32"_s;
}

void TestLanguage::everyPageChangesAtOnce()
{
    QFETCH(QString, address);
    QVERIFY(m_rig->open(address));
    visitAll();
    const QSet<QString> english = textsIn(m_rig->window());
    choose(u"de"_s);
    QTRY_VERIFY(isGerman());
    QCOMPARE(m_rig->window().navigation()->currentPage(), u"settings"_s);
    QVERIFY(m_rig->client().isConnected());
    visitAll();
    const QSet<QString> renewed = textsIn(m_rig->window());
    // What is the same in a window that was German from the beginning is no leftover.
    m_rig.reset();
    m_rig = std::make_unique<WindowRig>();
    QVERIFY(m_rig->open(address));
    visitAll();
    QSet<QString> left = renewed;
    left.intersect(english).subtract(textsIn(m_rig->window()));
    QVERIFY2(left.isEmpty(), qPrintable(QStringList(left.values()).join(u" | "_s)));
    QVERIFY(renewed.size() > english.size() / 2);
}

void TestLanguage::whatPagesHoldGoesOn()
{
    QVERIFY(m_rig->open());
    m_rig->edit(u"pid.roll.p"_s, 0, 44);
    QFile csv(m_rig->filePath(
        u"the response of a gimbal with a name that is a long one, and the second of its kind.csv"_s));
    QVERIFY(csv.open(QIODevice::WriteOnly));
    csv.write("in;out\n");
    double state = 0;
    unsigned noise = 1;
    for (int i = 0; i < 30000; ++i) {
        noise = noise * 1664525U + 1013904223U;
        const double input = double(noise >> 16) / 65536.0 - 0.5;
        state += (input - state) * 0.016;
        csv.write(QByteArray::number(input) + ';' + QByteArray::number(state) + '\n');
    }
    csv.close();
    auto *response = m_rig->page<ResponsePage>();
    QVERIFY(response->importCsv(csv.fileName()));
    const std::size_t records = response->records().size();
    QVERIFY(records > 0);
    m_rig->window().showPage(u"response"_s);
    const QTableView *table = response->table();
    QTRY_VERIFY(table->isVisible() && table->model()->rowCount() > 0);
    QTRY_VERIFY(table->horizontalHeader()->length() <= table->viewport()->width());
    auto *monitor = m_rig->page<MonitorPage>();
    QTRY_VERIFY(monitor->plots().size() > 1);
    QVERIFY(monitor->publish(u"127.0.0.1:9"_s));
    monitor->stack()->setSeconds(33);
    const qsizetype plots = monitor->plots().size();
    choose(u"de"_s);
    QTRY_VERIFY(isGerman());
    QCOMPARE(m_rig->page<ResponsePage>()->records().size(), records);
    QCOMPARE(m_rig->model().changeCount(), 1);
    QTRY_VERIFY(m_rig->window().unsavedBar()->isVisible());
    m_rig->workspace().edits().undo();
    QCOMPARE(m_rig->window().navigation()->currentPage(), u"parameters"_s);
    QCOMPARE(m_rig->model().changeCount(), 0);
    monitor = m_rig->page<MonitorPage>();
    QCOMPARE(monitor->plots().size(), plots);
    QCOMPARE(monitor->window(), 33.0);
    QVERIFY(monitor->publication());
    const quint64 sent = monitor->publication()->sent();
    QTRY_VERIFY(monitor->publication()->sent() > sent);
}

void TestLanguage::questionsStayOpen()
{
    QVERIFY(m_rig->open());
    bool answered = false;
    m_rig->workspace().notifications().ask({u"Which?"_s, {{u"This"_s, [&answered] { answered = true; }}}});
    m_rig->workspace().notifications().report(ErrorText{u"It broke."_s, {}, {}, {}});
    choose(u"de"_s);
    QTRY_VERIFY(isGerman());
    QVERIFY(m_rig->window().messageBar()->text().contains(u"It broke."_s));
    QTRY_VERIFY(m_rig->window().messageBar()->isVisible());
    QCOMPARE(m_rig->window().offerBar()->text(), u"Which?"_s);
    m_rig->window().offerBar()->buttons().first()->click();
    QVERIFY(answered);
}

void TestLanguage::whatRunsIsWaitedFor()
{
    QVERIFY(m_rig->open());
    auto end = std::make_shared<std::atomic<bool>>(false);
    m_rig->client().submit<bool>([end](Channel &channel, Device &) -> Result<bool> {
        while (!*end && !channel.cancelled())
            std::ignore = channel.sleep(10ms);
        return true;
    });
    QTRY_VERIFY(m_rig->client().isBusy());
    choose(u"de"_s);
    auto *page = m_rig->page<SettingsPage>();
    const auto waits = [page] {
        const auto labels = page->findChildren<QLabel *>();
        return std::any_of(labels.begin(), labels.end(), [](const QLabel *label) {
            return label->isVisible() && label->text().startsWith(u"The language changes as soon as"_s);
        });
    };
    QTRY_VERIFY(waits());
    QVERIFY(!isGerman());
    *end = true;
    QTRY_VERIFY(isGerman());
}

void TestLanguage::itComesBack()
{
    choose(u"de"_s);
    QTRY_VERIFY(isGerman());
    choose(u"en"_s);
    QTRY_VERIFY(!isGerman());
    // The window is as it was made, without a board too.
    QVERIFY(m_rig->open());
    QCOMPARE(m_rig->window().navigation()->currentPage(), u"settings"_s);
}

QTEST_MAIN(TestLanguage)
#include "tst_language.moc"
