// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/program/supervisorform.h"

#include "app/workspace/settings.h"
#include "protocol/client/deviceclient.h"
#include "widgets/forms/numberbox.h"
#include "widgets/models/alarmtext.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>

using namespace Qt::StringLiterals;

SupervisorForm::SupervisorForm(Settings &settings, const DeviceClient &client, const AddRow &row,
                               QFormLayout &form, QObject *parent)
    : QObject(parent)
    , m_settings(settings)
    , m_runaway(new NumberBox(5, 90, 0, tr(" °")))
    , m_oscillation(new NumberBox(1, 100, 1, tr(" °/s")))
    , m_cell(new NumberBox(2.5, 4.2, 2, tr(" V")))
    , m_hot(new NumberBox(30, 120, 0, tr(" °C")))
    , m_sound(new QCheckBox(tr("An alarm makes a sound")))
    , m_missing(new QLabel)
{
    auto *intro = new QLabel(
        tr("The program watches live data on every page and tells what goes wrong, with its cause. It can do "
           "something about it as well; a board that flies is only warned of."));
    intro->setObjectName(u"muted"_s);
    intro->setWordWrap(true);
    form.addRow(intro);
    const std::array<QString, 4> names{tr("Warn"), tr("Revert the last live change"),
                                       tr("Take it back, else motors off"), tr("Motors off")};
    const SupervisorRules rules = settings.supervisorRules();
    for (std::size_t kind = 0; kind < kAlarmKinds; ++kind) {
        auto *box = new QComboBox;
        for (int action = 0; action < int(names.size()); ++action) {
            if (SupervisorRules::offers(AlarmKind(kind), AlarmAction(action)))
                box->addItem(names[std::size_t(action)], action);
        }
        box->setCurrentIndex(box->findData(int(rules.actions[kind])));
        row(alarmName(AlarmKind(kind)), box);
        connect(box, &QComboBox::activated, this, &SupervisorForm::apply);
        m_actions[kind] = box;
    }
    m_missing->setWordWrap(true);
    row(tr("Not watched"), m_missing);
    const auto showMissing = [this, &client] {
        m_missing->setText(!client.isConnected()            ? tr("No board is connected")
                               : client.unwatched().empty() ? tr("Nothing: all of these can be seen")
                                                            : unwatchedText(client.unwatched()));
    };
    connect(&client, &DeviceClient::unwatchedChanged, this, showMissing);
    connect(&client, &DeviceClient::stateChanged, this, showMissing);
    showMissing();
    m_runaway->setValue(rules.runawayDeg);
    m_oscillation->setValue(rules.oscillation);
    m_cell->setValue(rules.cellVolts);
    m_hot->setValue(rules.hotCelsius);
    row(tr("Runaway: away from the target by"), m_runaway);
    row(tr("Oscillation: rate of more than (RMS)"), m_oscillation);
    row(tr("Low battery: less per cell than"), m_cell);
    row(tr("Overheating: sensor or motor hotter than"), m_hot);
    for (NumberBox *box : {m_runaway, m_oscillation, m_cell, m_hot})
        connect(box, &NumberBox::valueChanged, this, &SupervisorForm::apply);
    m_sound->setChecked(settings.alarmSound());
    connect(m_sound, &QCheckBox::toggled, this, [this](bool on) { m_settings.setAlarmSound(on); });
    form.addRow(m_sound);
}

void SupervisorForm::apply()
{
    SupervisorRules rules;
    for (std::size_t kind = 0; kind < kAlarmKinds; ++kind)
        rules.actions[kind] = AlarmAction(m_actions[kind]->currentData().toInt());
    rules.runawayDeg = m_runaway->value();
    rules.oscillation = m_oscillation->value();
    rules.cellVolts = m_cell->value();
    rules.hotCelsius = m_hot->value();
    m_settings.setSupervisorRules(rules);
}
