// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/bcflight/picturesettings.h"

#include "app/families/bcflight/cardlabels.h"
#include "app/families/bcflight/quietquestion.h"
#include "protocol/client/whendone.h"
#include "widgets/forms/argumentform.h"
#include "widgets/forms/panel.h"
#include "widgets/models/parametermodel.h"
#include "widgets/theme/theme.h"
#include "widgets/views/card.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

// The entries of the action "camera.step".
enum PictureStep {
    BrightnessUp,
    BrightnessDown,
    ContrastUp,
    ContrastDown,
    SaturationUp,
    SaturationDown,
    IsoUp,
    IsoDown,
    ShutterUp,
    ShutterDown
};

}  // namespace

PictureSettings::PictureSettings(Workspace &workspace, QWidget *parent)
    : QWidget(parent)
    , m_workspace(workspace)
    , m_question(new QuietQuestion(
          workspace, u"camera"_s, [this](const Result<ActionOutcome> &outcome) { onTold(outcome); }, this))
{
    auto *column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(12);
    column->addWidget(makePicture());
    column->addWidget(makeLight());
    column->addWidget(makeOnDrone());
    connect(&workspace.client(), &DeviceClient::stateChanged, this, &PictureSettings::updateState);
    updateState();
}

QWidget *PictureSettings::makePicture()
{
    auto *card = new Card(tr("Picture"));
    auto *grid = new QGridLayout;
    grid->setColumnStretch(1, 1);
    addSteps(*grid, tr("Brightness"), u"brightness"_s, BrightnessDown);
    addSteps(*grid, tr("Contrast"), u"contrast"_s, ContrastDown);
    addSteps(*grid, tr("Saturation"), u"saturation"_s, SaturationDown);
    addSteps(*grid, tr("Sensitivity (ISO)"), u"iso"_s, IsoDown, tr("By 100. 0 is automatic."));
    addSteps(*grid, tr("Shutter"), u"shutter"_s, ShutterDown, tr("By 100. Today's driver does nothing."));
    card->content()->addLayout(grid);
    card->content()->addWidget(wrappedLabel(
        tr("The drone does not tell brightness, contrast and saturation: judge by the picture. Nothing "
           "here outlasts a restart."),
        "muted"));
    return card;
}

QWidget *PictureSettings::makeLight()
{
    auto *card = new Card(tr("Colour and light"));
    auto *grid = new QGridLayout;
    grid->setColumnStretch(1, 1);
    grid->addWidget(new QLabel(tr("White balance")), 0, 0);
    grid->addWidget(addValue(u"white_balance"_s), 0, 1);
    grid->addWidget(addButton(u"camera.white_balance"_s, tr("Next"), tr("Next white balance"),
                              tr("Switches to the next one; the drone tells which."),
                              [this] { perform(u"camera.white_balance"_s); }),
                    0, 2);
    grid->addWidget(addButton(u"camera.lock"_s, tr("Lock"), tr("Lock white balance"),
                              tr("Keeps the present gains of red and blue; the drone tells them."),
                              [this] { perform(u"camera.lock"_s); }),
                    0, 3);
    grid->addWidget(new QLabel(tr("Exposure")), 1, 0);
    grid->addWidget(addValue(u"exposure"_s), 1, 1);
    grid->addWidget(addButton(u"camera.exposure"_s, tr("Next"), tr("Next exposure mode"),
                              tr("Switches to the next one. Today's driver does not tell which."),
                              [this] { perform(u"camera.exposure"_s); }),
                    1, 2);
    grid->addWidget(new QLabel(tr("Night mode")), 2, 0, 1, 2);
    const QString night = tr("Runs the drone's own script for it, if there is one. No proof comes back.");
    grid->addWidget(addButton(u"night.on"_s, tr("On"), tr("Night mode on"), night,
                              [this] {
                                  perform(u"camera.night"_s, {{u"on"_s, true}});
                              }),
                    2, 2);
    grid->addWidget(addButton(u"night.off"_s, tr("Off"), tr("Night mode off"), night,
                              [this] {
                                  perform(u"camera.night"_s, {{u"on"_s, false}});
                              }),
                    2, 3);
    grid->addWidget(new QLabel(tr("Lens shading")), 3, 0, 1, 2);
    grid->addWidget(addButton(u"camera.lens.set"_s, tr("Set…"), tr("Set lens shading"),
                              tr("Today's driver does nothing with it."), [this] { editLens(); }),
                    3, 2);
    card->content()->addLayout(grid);
    return card;
}

QWidget *PictureSettings::makeOnDrone()
{
    auto *card = new Card(tr("On the drone"));
    auto *row = new QHBoxLayout;
    row->addWidget(addButton(u"record.on"_s, tr("Record"), tr("Record on the drone"), {}, [this] {
        perform(u"camera.record"_s, {{u"on"_s, true}});
    }));
    row->addWidget(addButton(u"record.off"_s, tr("Stop"), tr("Stop recording on the drone"), {}, [this] {
        perform(u"camera.record"_s, {{u"on"_s, false}});
    }));
    row->addWidget(addButton(u"camera.picture"_s, tr("Picture"), tr("Take a picture on the drone"),
                             tr("Today's driver does nothing."), [this] { perform(u"camera.picture"_s); }));
    card->content()->addLayout(row);
    card->content()->addWidget(wrappedLabel(
        tr("The drone confirms recording whatever it does: that is no proof. Its recordings are listed "
           "on the page Recordings. Use Record below the picture for a file here."),
        "muted"));
    return card;
}

void PictureSettings::addSteps(QGridLayout &grid, const QString &name, const QString &key, int down,
                               const QString &hint)
{
    const int row = grid.rowCount();
    grid.addWidget(new QLabel(name), row, 0);
    grid.addWidget(addValue(key), row, 1);
    const auto step = [this](int which) {
        return [this, which] {
            perform(u"camera.step"_s, {{u"step"_s, which}});
            if (which >= IsoUp)
                ask();
        };
    };
    grid.addWidget(addButton(key + u".down"_s, u"−"_s, tr("%1: less").arg(name), hint, step(down)), row, 2);
    grid.addWidget(addButton(key + u".up"_s, u"+"_s, tr("%1: more").arg(name), hint, step(down - 1)), row, 3);
}

QPushButton *PictureSettings::addButton(const QString &key, const QString &text, const QString &name,
                                        const QString &hint, std::function<void()> action)
{
    auto *button = new QPushButton(text);
    button->setAccessibleName(name);
    button->setToolTip(hint.isEmpty() ? name : name + u'\n' + hint);
    m_buttons.insert(key, button);
    connect(button, &QPushButton::clicked, this, std::move(action));
    return button;
}

QLabel *PictureSettings::addValue(const QString &what)
{
    auto *label = new QLabel;
    label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_values.insert(what, label);
    return label;
}

QString PictureSettings::told(const QString &what) const
{
    return m_values.value(what)->text();
}

void PictureSettings::ask()
{
    m_question->ask();
}

void PictureSettings::perform(const QString &key, const QVariantMap &arguments)
{
    whenDone(m_workspace.perform(key, arguments), this,
             [this](const Result<ActionOutcome> &outcome) { onTold(outcome); });
}

void PictureSettings::onTold(const Result<ActionOutcome> &outcome)
{
    if (!outcome)
        return;
    for (auto figure = outcome->reply.begin(); figure != outcome->reply.end(); ++figure) {
        QLabel *label = m_values.value(figure.key());
        if (!label)
            continue;
        const QString text = figure->toString();
        const bool isAutomatic = figure.key() == u"iso"_s && text == u"0"_s;
        label->setText(text.isEmpty() ? tr("not told") : isAutomatic ? tr("auto") : text);
        label->setToolTip(text);
    }
}

// The fields begin with what the drone tells, whatever that is worth.
void PictureSettings::editLens()
{
    whenDone(
        m_workspace.perform(u"camera.lens"_s, {}, true), this,
        [this](const Result<ActionOutcome> &outcome) { openLens(outcome ? outcome->reply : QVariantMap()); });
}

void PictureSettings::openLens(const QVariantMap &values)
{
    const Device *device = m_workspace.client().device();
    if (!device)
        return;
    const auto actions = device->actions();
    const auto action = std::find_if(actions.begin(), actions.end(), [](const ActionSpec &spec) {
        return QLatin1String(spec.key) == u"camera.lens.set"_s;
    });
    if (action == actions.end())
        return;
    auto *dialog = new QDialog(this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Lens shading"));
    auto *form = new ArgumentForm(*action);
    for (auto value = values.begin(); value != values.end(); ++value)
        form->setText(value.key(), value->toString());
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    QPushButton *set = buttons->addButton(tr("Set"), QDialogButtonBox::AcceptRole);
    set->setObjectName(u"primary"_s);
    auto *layout = new QVBoxLayout(dialog);
    layout->addWidget(wrappedLabel(tableText(action->help), "muted"));
    layout->addWidget(form);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    connect(buttons, &QDialogButtonBox::accepted, dialog, [this, dialog, form] {
        const auto arguments = form->arguments();
        if (!arguments) {
            m_workspace.notifications().report(arguments.error());
            return;
        }
        perform(u"camera.lens.set"_s, *arguments);
        dialog->accept();
    });
    openPanel(*dialog);
}

// Of another drone nothing is known.
void PictureSettings::updateState()
{
    const DeviceClient &client = m_workspace.client();
    const bool ready = client.isConnected() && client.identity().writable;
    for (QPushButton *button : std::as_const(m_buttons))
        button->setEnabled(ready);
    const QString board
        = client.isConnected() ? client.identity().serial + client.address().toString() : m_board;
    if (std::exchange(m_board, board) == board)
        return;
    for (QLabel *label : std::as_const(m_values))
        label->clear();
}
