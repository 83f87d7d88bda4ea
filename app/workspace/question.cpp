// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/question.h"

#include "app/workspace/workspace.h"
#include "protocol/client/whendone.h"
#include "protocol/configuration/leap.h"
#include "widgets/forms/panel.h"
#include "widgets/models/errortext.h"
#include "widgets/models/leaptext.h"
#include "widgets/models/parametermodel.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>

#include <algorithm>
#include <utility>

using namespace Qt::StringLiterals;

namespace {

struct Questions
{
    Q_DECLARE_TR_FUNCTIONS(Questions)
};

// What was asked belongs to this link.
void withdrawWithTheLink(Workspace &workspace, QDialog *panel)
{
    QObject::connect(&workspace.client(), &DeviceClient::stateChanged, panel, &QDialog::reject);
}

}  // namespace

QDialog *askInPanel(const Question &question, QWidget *parent)
{
    auto *box
        = new QMessageBox(QMessageBox::NoIcon, question.title, question.text, QMessageBox::NoButton, parent);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setToolTip(question.whole);
    for (const Question::Answer &answer : question.answers) {
        const auto role = answer.loses ? QMessageBox::DestructiveRole : QMessageBox::AcceptRole;
        QPushButton *button = box->addButton(answer.text, role);
        if (answer.loses)
            button->setObjectName(u"danger"_s);
        QObject::connect(button, &QPushButton::clicked, parent, answer.chosen);
    }
    QPushButton *stay = box->addButton(question.stay, QMessageBox::RejectRole);
    box->setDefaultButton(stay);
    box->setEscapeButton(stay);
    openPanel(*box);
    return box;
}

QString whyNotBehind(const QWidget &page)
{
    const auto dialogs = page.window()->findChildren<QDialog *>();
    const bool isCovered
        = std::any_of(dialogs.begin(), dialogs.end(), [](const QDialog *open) { return open->isVisible(); });
    return isCovered ? Questions::tr("Not armed: a question or a list is open over this page.") : QString();
}

void askAboutLeap(Workspace &workspace, const ParameterChange &change, QWidget *parent,
                  const std::function<void()> &goOn)
{
    const QString leap = leapText(change);
    if (workspace.isFlown()) {
        workspace.notifications().notify(
            Questions::tr("Not set while it is armed: %1. Disarm it first.").arg(leap), Notice::Attention);
        return;
    }
    const Question question{
        Questions::tr("Many times as much?"),
        Questions::tr("%1. With a value far too large it swings or runs away as soon as the motors run.")
            .arg(leap),
        {{Questions::tr("Use it all the same"), goOn, true}},
        Questions::tr("Leave it")};
    withdrawWithTheLink(workspace, askInPanel(question, parent));
}

void askToStartMotors(Workspace &workspace, QWidget *parent)
{
    Question question{Questions::tr("Start the motors?"),
                      Questions::tr("The gimbal moves at once. Keep hands and cables clear of it."),
                      {{Questions::tr("Start motors"), [&workspace] { workspace.setMotors(true); }}},
                      Questions::tr("Leave them off")};
    QDialog *panel = askInPanel(question, parent);
    withdrawWithTheLink(workspace, panel);
    // They may be started by something else meanwhile.
    QObject::connect(&workspace.client(), &DeviceClient::statisticsChanged, panel, [&workspace, panel] {
        if (workspace.motorsRunning().value_or(false) || workspace.isStarting())
            panel->reject();
    });
}

void askForMotorsOff(Workspace &workspace, QWidget *parent, const std::function<void()> &goOn)
{
    if (workspace.motorsRunning() == false) {
        goOn();
        return;
    }
    const auto switchOff = [&workspace, parent, goOn] {
        // The board's state proves it; what failed is told by the stop itself.
        auto *once = new QObject(parent);
        QObject::connect(&workspace.client(), &DeviceClient::motorsOffFinished, once,
                         [once, goOn](bool confirmed) {
                             once->deleteLater();
                             once->disconnect();
                             if (confirmed)
                                 goOn();
                         });
        workspace.setMotors(false);
    };
    Question question{
        Questions::tr("Stop the motors?"),
        Questions::tr("The sensor is turned over by hand, which motors would work against. Hold "
                      "the camera: it falls when they let go. They stay off until they are "
                      "started again."),
        {{Questions::tr("Stop motors"), switchOff}},
        Questions::tr("Leave them on")};
    withdrawWithTheLink(workspace, askInPanel(question, parent));
}

void askToLetGo(Workspace &workspace, const QString &what, QWidget *parent, const std::function<void()> &goOn)
{
    const std::optional<bool> run = workspace.motorsRunning();
    if (run == false) {
        goOn();
        return;
    }
    Question question{Questions::tr("%1: let the motors go?").arg(what),
                      run ? Questions::tr("The motors are running. They lose their current: hold the camera, "
                                          "it falls when they let go.")
                          : Questions::tr("The motors may be running. They lose their current: hold the "
                                          "camera, it falls when they let go."),
                      {{what, goOn}},
                      Questions::tr("Do nothing")};
    withdrawWithTheLink(workspace, askInPanel(question, parent));
}

void askToReload(Workspace &workspace, const QString &title, const QString &what, const QString &stay,
                 QWidget *parent, const std::function<void()> &goOn, const std::function<void()> &otherwise)
{
    const std::optional<bool> run = workspace.motorsRunning();
    const LiveValues live = workspace.live().unsaved();
    if (run == false && live.empty()) {
        goOn();
        return;
    }
    QStringList texts;
    if (run != false)
        texts.append(run ? Questions::tr("The motors are running: other settings act at once.")
                         : Questions::tr("The motors may be running: other settings act at once."));
    if (!live.empty())
        texts.append(
            Questions::tr("%n value(s) in use are not stored and will be lost: %1", nullptr, int(live.size()))
                .arg(liveText(std::as_const(workspace).configuration().board(), live)));
    Question question{title, texts.join(u"\n\n"_s), {}, stay};
    if (live.empty()) {
        question.answers = {{what, goOn}};
    } else {
        const auto store = [&workspace, parent, goOn] {
            whenDone(workspace.saveLive(*parent), parent, [goOn](bool stored) {
                if (stored)
                    goOn();
            });
        };
        question.answers = {{Questions::tr("Store, then go on"), store},
                            {Questions::tr("%1 without storing").arg(what), goOn, true}};
    }
    QDialog *panel = askInPanel(question, parent);
    withdrawWithTheLink(workspace, panel);
    if (otherwise)
        QObject::connect(panel, &QDialog::finished, parent, otherwise);
}

void askToUseProfile(Workspace &workspace, int profile, QWidget *parent,
                     const std::function<void()> &otherwise)
{
    const ConfigurationModel &model = std::as_const(workspace).configuration();
    const auto goOn = [&workspace, profile] { workspace.useProfile(profile); };
    if (!workspace.client().isConnected() || workspace.client().address().isReplay() || model.isEmpty()
        || profile == model.board().activeProfile()) {
        goOn();
        return;
    }
    askToReload(workspace,
                Questions::tr("Switch to profile %1, %2?")
                    .arg(profile + 1)
                    .arg(profileLabel(model.edited(), profile)),
                Questions::tr("Switch profile"),
                Questions::tr("Stay in profile %1").arg(model.board().activeProfile() + 1), parent, goOn,
                otherwise);
}
