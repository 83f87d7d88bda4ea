// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/device/firmwareadvice.h"
#include "protocol/simplebgc/adjustables.h"
#include "protocol/simplebgc/firmware.h"
#include "tests/support/channelproxy.h"
#include "tests/support/sbgcrig.h"
#include "widgets/models/firmwaretext.h"

using namespace simplebgc;
using namespace Qt::StringLiterals;

namespace {

QStringList remarksOf(const simplebgc::Device &device)
{
    QStringList texts;
    for (const FirmwareRemark &remark : device.firmwareRemarks())
        texts.append((remark.isCaution ? u"! "_s : QString()) + QString::fromUtf8(remark.text));
    return texts;
}

QSet<QString> parametersOf(const simplebgc::Device &device)
{
    QSet<QString> keys;
    for (const ParameterSpec &spec : device.parameters()->all()) {
        if (device.parameters()->block(spec.row->block)->since <= device.identity().firmwareNumber)
            keys.insert(spec.key);
    }
    return keys;
}

QSet<QString> actionsOf(const simplebgc::Device &device)
{
    QSet<QString> keys;
    for (const ActionSpec &action : device.actions())
        keys.insert(QLatin1String(action.key));
    return keys;
}

}  // namespace

class TestSbgcFirmware : public QObject
{
    Q_OBJECT
private slots:
    void firmwareIsJudged_data();
    void firmwareIsJudged();
    void specialBuildIsTold();
    void stepsLeadToTheNewest_data();
    void stepsLeadToTheNewest();
    void whatAStepBringsIsNamed();
    void stepsHaveWords();
};

void TestSbgcFirmware::firmwareIsJudged_data()
{
    QTest::addColumn<int>("firmware");
    QTest::addColumn<bool>("isWritable");
    QTest::addColumn<QString>("first");
    QTest::addColumn<int>("remarks");
    QTest::newRow("older") << 2390 << false << u"! This firmware is older"_s << 4;
    QTest::newRow("oldest") << 2400 << true << u"This program knows this firmware."_s << 4;
    QTest::newRow("parity is found") << 2410 << true << u"This program knows this firmware."_s << 3;
    QTest::newRow("axes apart") << 2555 << true << u"This program knows this firmware."_s << 2;
    QTest::newRow("streams") << 2590 << true << u"This program knows this firmware."_s << 1;
    QTest::newRow("newest") << simplebgc::Device::kNewestFirmware << true
                            << u"This program knows this firmware."_s << 1;
    QTest::newRow("newer") << simplebgc::Device::kNewestFirmware + 1 << false << u"! This firmware is newer"_s
                           << 1;
}

void TestSbgcFirmware::firmwareIsJudged()
{
    QFETCH(int, firmware);
    QFETCH(bool, isWritable);
    QFETCH(QString, first);
    QFETCH(int, remarks);
    const SbgcRig rig(firmware);
    QCOMPARE(rig.device.identity().writable, isWritable);
    QCOMPARE(rig.device.firmwareAdvice(), static_cast<const FirmwareAdvice *>(&rig.device));
    const QStringList told = remarksOf(rig.device);
    QVERIFY2(told.first().startsWith(first), qPrintable(told.first()));
    QCOMPARE(told.size(), remarks);
    for (const FirmwareRemark &remark : rig.device.firmwareRemarks()) {
        const auto texts = firmwareTexts();
        QVERIFY(std::find(texts.begin(), texts.end(), remark.text) != texts.end());
    }
    QCOMPARE(rig.device.firmwareSteps().empty(), firmware >= 2740);
}

void TestSbgcFirmware::specialBuildIsTold()
{
    SbgcRig rig;
    Altering line(rig.channel, [](const Request &request, const Altering::Pass &pass) {
        auto frame = pass(request);
        if (frame && frame->id == number(CommandId::BoardInfo))
            frame->payload[7] = 5;  // FRW_EXTRA_ID
        return frame;
    });
    QVERIFY(rig.device.identify(line));
    QVERIFY(remarksOf(rig.device)
                .contains(u"! It is a special build, which may lack things or do them in another way."_s));
}

void TestSbgcFirmware::stepsLeadToTheNewest_data()
{
    QTest::addColumn<int>("firmware");
    for (const int firmware : {2400, 2439, 2554, 2590, 2612, 2704, 2731})
        QTest::addRow("%d", firmware) << firmware;
}

// What all steps bring and take makes of this firmware's tables those of the newest.
void TestSbgcFirmware::stepsLeadToTheNewest()
{
    QFETCH(int, firmware);
    const SbgcRig rig(firmware);
    SbgcRig newest(simplebgc::Device::kNewestFirmware);
    QSet<QString> parameters = parametersOf(rig.device);
    QSet<QString> actions = actionsOf(rig.device);
    qsizetype variables = qsizetype(adjustablesOf(firmware).size());
    QString last = rig.device.identity().firmware;
    for (const FirmwareStep &step : rig.device.firmwareSteps()) {
        QVERIFY2(step.firmware > last, qPrintable(step.firmware));
        last = step.firmware;
        for (const QString &key : step.gone)
            QVERIFY2(parameters.remove(key), qPrintable(key));
        for (const QString &key : step.parameters) {
            QVERIFY2(!parameters.contains(key), qPrintable(key));
            parameters.insert(key);
        }
        for (const QString &key : step.actions) {
            QVERIFY2(!actions.contains(key), qPrintable(key));
            actions.insert(key);
        }
        variables += step.variables.size();
    }
    QCOMPARE(parameters, parametersOf(newest.device));
    QCOMPARE(actions, actionsOf(newest.device));
    // Two of the oldest have other names later.
    QCOMPARE(variables,
             qsizetype(adjustablesOf(simplebgc::Device::kNewestFirmware).size()) + (firmware < 2600 ? 2 : 0));
}

void TestSbgcFirmware::whatAStepBringsIsNamed()
{
    const SbgcRig rig(2554);
    const auto steps = rig.device.firmwareSteps();
    const auto stepTo = [&steps](const QString &firmware) {
        const auto it = std::find_if(steps.begin(), steps.end(),
                                     [&](const FirmwareStep &step) { return step.firmware == firmware; });
        return it == steps.end() ? FirmwareStep() : *it;
    };
    QVERIFY(stepTo(u"2.59b0"_s).streams.contains(u"custom"_s));
    QVERIFY(stepTo(u"2.59b0"_s).actions.contains(u"beep"_s));
    QVERIFY(!stepTo(u"2.59b0"_s).isAbout);
    QVERIFY(stepTo(u"2.60b0"_s).isAbout && stepTo(u"2.60b0"_s).actions.contains(u"signals"_s));
    QVERIFY(stepTo(u"2.66b2"_s).modes.contains(u"rc-fine"_s));
    QVERIFY(stepTo(u"2.68b0"_s).commands.contains(u"CONTROL_EXT"_s));
    QVERIFY(stepTo(u"2.73.7"_s).variables.contains(u"outer_p.roll"_s));
}

void TestSbgcFirmware::stepsHaveWords()
{
    const SbgcRig rig(2704);
    const QString gain = gainText(rig.device.firmwareSteps());
    QVERIFY2(gain.startsWith(u"Newer firmware would bring: "_s) && gain.contains(u"live variable"_s),
             qPrintable(gain));
    const QString lines = stepsText(rig.device.firmwareSteps());
    QVERIFY2(lines.contains(u"2.73.8: "_s), qPrintable(lines));
    QVERIFY(gainText({}).isEmpty() && stepsText({}).isEmpty());
}

QTEST_GUILESS_MAIN(TestSbgcFirmware)
#include "tst_sbgcfirmware.moc"
