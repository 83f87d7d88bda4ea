// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/simplebgc/signalspage.h"
#include "app/mainwindow/translations.h"
#include "app/pages/board/actionspage.h"
#include "app/pages/board/controlpage.h"
#include "protocol/device/device.h"
#include "protocol/simplebgc/parametertables.h"
#include "tests/support/patience.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/parameterform.h"
#include "widgets/views/inputbars.h"

#include <QComboBox>
#include <QPushButton>
#include <QStyleOptionComboBox>
#include <QTextBrowser>
#include <QTimer>

#include <cmath>

using namespace Qt::StringLiterals;

/// The page that shows what comes in at the inputs of a SimpleBGC board.
class TestSignals final : public QObject
{
    Q_OBJECT
private slots:
    void init() { m_rig = std::make_unique<WindowRig>(); }
    void cleanup() { m_rig.reset(); }
    void stickIsSeen_data();
    void stickIsSeen();
    void theStickThatMovesIsSeen();
    void channelsAreAModeOfControl();
    void answersAreWords();
    void fieldsCanBeRead_data();
    void fieldsCanBeRead();

private:
    void map(const QString &key, int raw);
    /// The second virtual channel is steered, as the page Control does it, until the timer is gone.
    std::unique_ptr<QTimer> steer(double percent);

    std::unique_ptr<WindowRig> m_rig;
};

void TestSignals::map(const QString &key, int raw)
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

std::unique_ptr<QTimer> TestSignals::steer(double percent)
{
    auto timer = std::make_unique<QTimer>();
    connect(timer.get(), &QTimer::timeout, this, [this, percent] {
        m_rig->client().setControl({256, {0, percent, 0, 0, 0, 0, 0, 0}, {}});
    });
    timer->start(20);
    return timer;
}

void TestSignals::stickIsSeen_data()
{
    QTest::addColumn<QString>("firmware");
    QTest::newRow("asked") << u"2.70.4"_s;
    QTest::newRow("by telemetry") << u"2.59b0"_s;
}

void TestSignals::stickIsSeen()
{
    QFETCH(QString, firmware);
    QVERIFY(m_rig->open(u"sim:simplebgc?firmware="_s + firmware));
    map(u"rc.map.pitch"_s, 130);
    map(u"slot.trigger2.source"_s, 130);
    map(u"slot.trigger2.action5"_s, 17);
    map(u"slot.analog3.source"_s, 130);
    map(u"slot.analog3.max"_s, 255);
    auto *page = m_rig->page<SignalsPage>();
    QVERIFY(page);
    QCOMPARE(page->form()->count(), qsizetype(6));
    QTRY_VERIFY(!page->effect(u"trigger2"_s).isEmpty());
    QVERIFY(std::isnan(page->signal(u"trigger2"_s)));
    {
        const auto steered = steer(90);
        QTRY_VERIFY(std::abs(page->signal(u"rc.map.pitch"_s) - 90) < 1);
        QTRY_VERIFY(std::abs(page->signal(u"trigger2"_s) - 90) < 1);
        QTRY_COMPARE(page->effect(u"trigger2"_s), u"Look down"_s);
        QTRY_VERIFY(page->effect(u"analog3"_s).contains(u"24"_s));  // 95 % of 255
    }
    m_rig->client().releaseControl();
    QTRY_VERIFY(std::isnan(page->signal(u"trigger2"_s)));
    map(u"slot.trigger2.source"_s, 0);
    map(u"slot.analog3.source"_s, 0);
    QTRY_VERIFY(page->effect(u"analog3"_s).isEmpty());
}

// Beside the map, whether something is mapped to it or not.
void TestSignals::theStickThatMovesIsSeen()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?firmware=2.70.4"_s));
    map(u"rc.input_mode"_s, 2);
    const auto *bars = m_rig->page<SignalsPage>()->inputs();
    QVERIFY(std::isnan(bars->value(u"RC channel 4"_s)));
    m_rig->workspace().changeWorld(u"receiver=3"_s);
    QTRY_VERIFY(std::abs(bars->value(u"RC channel 4"_s)) < 5);
    m_rig->workspace().changeWorld(u"stick=5"_s);
    QTRY_VERIFY(bars->isMoving(u"RC channel 4"_s));
    QVERIFY(!bars->isMoving(u"RC channel 1"_s));
    QTRY_VERIFY(std::abs(bars->value(u"RC channel 4"_s) - 96) < 3);
    m_rig->workspace().changeWorld(u"receiver=0"_s);
    QTRY_VERIFY(std::isnan(bars->value(u"RC channel 4"_s)));
}

void TestSignals::channelsAreAModeOfControl()
{
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<ControlPage>();
    auto *modes = page->findChild<QComboBox *>();
    const int at = modes->findData(256);
    QVERIFY(at >= 0);
    modes->setCurrentIndex(at);
    for (int channel = 4; channel <= 8; ++channel) {
        const QString name = u"Channel %1"_s.arg(channel);
        const auto all = page->findChildren<QAbstractSpinBox *>();
        QVERIFY2(std::any_of(all.begin(), all.end(),
                             [&name](QAbstractSpinBox *box) { return box->accessibleName() == name; }),
                 qPrintable(name));
    }
}

// In the operator's language, where the board's tables have words for it.
void TestSignals::answersAreWords()
{
    QVERIFY(m_rig->open(u"sim:simplebgc?firmware=2.70.4"_s));
    map(u"slot.trigger2.source"_s, 130);
    auto *page = m_rig->page<ActionsPage>();
    QVERIFY(page->showAction(u"i2c.scan"_s));
    page->runButton()->click();
    const QTextBrowser *reply = page->reply();
    QTRY_VERIFY2(reply->toPlainText().contains(u"Devices that answer"_s)
                     && reply->toPlainText().contains(u"0x68"_s),
                 qPrintable(reply->toPlainText()));
}

void TestSignals::fieldsCanBeRead_data()
{
    QTest::addColumn<QString>("language");
    QTest::newRow("English") << u"en"_s;
    QTest::newRow("German") << u"de"_s;
}

void TestSignals::fieldsCanBeRead()
{
    QFETCH(QString, language);
    m_rig.reset();
    const Translations translations(language);
    m_rig = std::make_unique<WindowRig>();
    m_rig->window().resize(1280, 800);
    QVERIFY(m_rig->open(u"sim:simplebgc?firmware=2.70.4"_s));
    auto *page = m_rig->page<SignalsPage>();
    QVERIFY(m_rig->isSettled());
    int seen = 0;
    for (const QComboBox *box : page->form()->findChildren<QComboBox *>()) {
        QStyleOptionComboBox option;
        option.initFrom(box);
        const QRect room
            = box->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, box);
        QVERIFY2(box->fontMetrics().horizontalAdvance(box->currentText()) <= room.width(),
                 qPrintable(u"%1: %2"_s.arg(box->currentText()).arg(room.width())));
        ++seen;
    }
    QCOMPARE(seen, 6);
    m_rig.reset();
}

QTEST_MAIN(TestSignals)
#include "tst_signals.moc"
