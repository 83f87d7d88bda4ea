// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Prints every text of the tables as a line that lupdate understands: tables hold plain literals, translated
// in the context "Tables" where they are shown.
#if GIMBAL_WITH_BCFLIGHT
#include "protocol/bcflight/device.h"
#include "protocol/bcflight/tables.h"
#endif
#if GIMBAL_WITH_SIMPLEBGC
#include "protocol/guide/setuplive.h"
#include "protocol/guide/setuprecord.h"
#include "protocol/simplebgc/adjustables.h"
#include "protocol/simplebgc/faults.h"
#include "protocol/simplebgc/firmware.h"
#include "protocol/simplebgc/parametertables.h"
#include "protocol/simplebgc/telemetrytables.h"
#include "tests/support/virtualboard.h"
#endif
#if GIMBAL_WITH_STORM32
#include "protocol/storm32/device.h"
#include "protocol/storm32/parametertables.h"
#include "protocol/storm32/telemetrytables.h"
#endif

#include <QMap>
#include <QTextStream>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

class Texts
{
public:
    void add(const char *text)
    {
        const QString string = QString::fromUtf8(text);
        // Numbers and names of signals are the same in every language.
        const bool hasWord = std::any_of(string.begin(), string.end(), [](QChar c) { return c.isLower(); });
        if (hasWord && !m_texts.contains(string))
            m_texts.insert(string, int(m_texts.size()));
    }
    void add(std::span<const Choice> choices)
    {
        for (const Choice &choice : choices)
            add(choice.name);
    }
    void add(const ChannelSpec &channel)
    {
        add(channel.label);
        add(channel.group);
        add(channel.choices);
    }
    void add(const BoardFault &fault)
    {
        add(fault.name.toUtf8().constData());
        add(fault.meaning.toUtf8().constData());
        add(fault.cure.toUtf8().constData());
    }
    void add(std::span<const ActionSpec> actions)
    {
        for (const ActionSpec &action : actions) {
            for (const char *text : {action.label, action.help, action.group, action.confirm})
                add(text);
            for (const ArgumentSpec &argument : action.arguments) {
                add(argument.label);
                add(argument.choices);
            }
        }
    }

    void print() const
    {
        QTextStream out(stdout);
        for (auto it = m_texts.begin(); it != m_texts.end(); ++it) {
            QString escaped = it.key();
            escaped.replace(u'\\', u"\\\\"_s).replace(u'"', u"\\\""_s);
            out << "QT_TRANSLATE_NOOP(\"Tables\", \"" << escaped << "\")\n";
        }
    }

private:
    QMap<QString, int> m_texts;
};

#if GIMBAL_WITH_SIMPLEBGC
bool addSimpleBgc(Texts &texts)
{
    for (const ParameterRow &row : simplebgc::parameterRows()) {
        for (const char *text : {row.label, row.group, row.help})
            texts.add(text);
        texts.add(row.choices);
    }
    for (const ValueRule &rule : simplebgc::valueRules())
        texts.add(rule.why);
    for (const ChannelSpec &channel : simplebgc::channelTable())
        texts.add(channel);
    for (const int firmware : {2590, 99999}) {
        for (const AdjustableSpec &variable : simplebgc::adjustablesOf(firmware)) {
            texts.add(variable.label);
            texts.add(variable.group);
        }
    }
    for (unsigned bit = 0; bit < 16; ++bit) {
        for (unsigned detail = 0; detail < 64; ++detail) {
            for (const BoardFault &fault : simplebgc::faultsOf(1U << bit, detail))
                texts.add(fault);
        }
    }
    SimulatorOptions options;
    options.firmware = simplebgc::Device::kNewestFirmware;
    options.own = {{u"encoders"_s, 1}, {u"magnetometer"_s, 1}};  // with all that it can do
    VirtualBoard board(options);
    if (!board.identify())
        return false;
    texts.add(board.device.actions());
    for (const SteeringMode &mode : board.device.modes())
        texts.add(mode.label);
    for (const SetupStepSpec &step : setupSteps()) {
        texts.add(std::span(&step.action, 1));
        texts.add(step.needs);
    }
    for (const SetupLiveSpec &row : setupLive())
        texts.add(row.label);
    for (const SetupFigureSpec &figure : setupFigures())
        texts.add(figure.label);
    for (const SetupRemarkSpec &remark : setupRemarks())
        texts.add(remark.text);
    for (const char *word : setupCertificateWords())
        texts.add(word);
    for (const char *text : simplebgc::firmwareTexts())
        texts.add(text);
    return true;
}
#endif

#if GIMBAL_WITH_STORM32
void addStorm32(Texts &texts)
{
    for (const auto rows : {storm32::parameterRows(), storm32::rawRows(95)}) {
        for (const ParameterRow &row : rows) {
            for (const char *text : {row.label, row.group, row.help})
                texts.add(text);
            texts.add(row.choices);
        }
    }
    for (const ChannelSpec &channel : storm32::channelTable())
        texts.add(channel);
    for (const unsigned bits : {0U, 0x8000U, 0x9028U, 0x803CU}) {
        for (const BoardFault &fault : storm32::faultsOf(bits, 6))
            texts.add(fault);
    }
    const storm32::Device storm;
    texts.add(storm.actions());
    for (const SteeringMode &mode : storm.modes())
        texts.add(mode.label);
}
#endif

#if GIMBAL_WITH_BCFLIGHT
void addBcflight(Texts &texts)
{
    for (const ParameterRow &row : bcflight::parameterRows()) {
        for (const char *text : {row.label, row.group, row.help})
            texts.add(text);
    }
    for (const BlockSpec &block : bcflight::blocks())
        texts.add(block.data);
    for (const ChannelSpec &channel : bcflight::channels())
        texts.add(channel);
    texts.add(bcflight::actions());
    const bcflight::Device drone;
    for (const int state : {0, 1, 2, 4}) {
        texts.add(drone.statusText(state).toUtf8().constData());
        for (const BoardFact &fact : drone.facts([state](int) { return double(state); })) {
            texts.add(fact.name);
            for (const char *word : fact.words)
                texts.add(word);
        }
    }
    texts.add(bcflight::family().nouns.load);
}
#endif

}  // namespace

int main()
{
    Texts texts;
#if GIMBAL_WITH_BCFLIGHT
    addBcflight(texts);
#endif
#if GIMBAL_WITH_SIMPLEBGC
    if (!addSimpleBgc(texts))
        return 1;
#endif
#if GIMBAL_WITH_STORM32
    addStorm32(texts);
#endif
    for (const char *axis : {"Roll", "Pitch", "Yaw"})
        texts.add(axis);
    texts.print();
    return 0;
}
