// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/bcflight/benchcards.h"

#include "app/families/bcflight/cardlabels.h"
#include "app/workspace/filedialogs.h"
#include "protocol/base/battery.h"
#include "protocol/base/checksum.h"
#include "protocol/bcflight/firmware.h"
#include "protocol/client/whendone.h"
#include "widgets/forms/keyboard.h"
#include "widgets/models/detailtext.h"
#include "widgets/models/errortext.h"
#include "widgets/models/numbertext.h"
#include "widgets/views/elidedlabel.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

using namespace Qt::StringLiterals;

namespace {

constexpr std::array<const char *, 3> kEscSteps{"escs-off", "escs-full", "escs-zero"};

}  // namespace

EscCard::EscCard(QWidget *parent)
    : Card(tr("Motor controllers"), parent)
    , m_start(new QPushButton(tr("Calibrate the controllers…")))
    , m_bar(new QProgressBar)
    , m_why(wrappedLabel({}, "muted"))
{
    content()->addWidget(wrappedLabel(
        tr("⚠ All motors get full throttle. Propellers off, drone fixed. It hears nothing for 26 s, also no "
           "stop: only its battery ends it."),
        "warning"));
    const std::array texts{tr("No signal, 10 s"), tr("Full throttle, 8 s"), tr("Zero, 8 s")};
    for (std::size_t i = 0; i < m_phases.size(); ++i) {
        m_phases[i] = new QLabel(tr("%1. %2").arg(i + 1).arg(texts[i]));
        content()->addWidget(m_phases[i]);
    }
    m_bar->setTextVisible(false);
    m_bar->setAccessibleName(tr("Progress of the calibration"));
    auto *row = new QHBoxLayout;
    row->addWidget(m_start);
    row->addStretch(1);
    content()->addLayout(row);
    content()->addWidget(m_why);
    content()->addWidget(m_bar);
    showState();
}

void EscCard::setObstacle(const QString &why)
{
    m_why->setText(why);
    showState();
}

void EscCard::take(const Progress &progress)
{
    for (std::size_t i = 0; i < kEscSteps.size(); ++i) {
        if (progress.step != QLatin1String(kEscSteps[i]))
            continue;
        m_bar->setRange(0, progress.total);
        m_bar->setValue(progress.done);
        if (std::exchange(m_phase, int(i)) != int(i))
            showState();
    }
}

void EscCard::setRunning(bool running)
{
    if (!running && std::exchange(m_phase, -1) >= 0)
        showState();
}

void EscCard::showState()
{
    m_start->setEnabled(m_why->text().isEmpty() && m_phase < 0);
    m_why->setVisible(!m_why->text().isEmpty() && m_phase < 0);
    m_bar->setVisible(m_phase >= 0);
    for (std::size_t i = 0; i < m_phases.size(); ++i) {
        m_phases[i]->setObjectName(int(i) != m_phase ? u"muted"_s : i == 1 ? u"error"_s : u""_s);
        repolish(m_phases[i]);
        QFont font = m_phases[i]->font();
        font.setBold(int(i) == m_phase);
        m_phases[i]->setFont(font);  // the style sheet would put the one from before back
    }
}

FirmwareCard::FirmwareCard(Workspace &workspace, QWidget *parent)
    : Card(tr("Firmware"), parent)
    , m_workspace(workspace)
    , m_file(new ElidedLabel)
    , m_about(wrappedLabel({}, "muted"))
    , m_choose(new QPushButton(tr("Choose a file…")))
    , m_upload(new QPushButton(tr("Upload…")))
    , m_cancel(new QPushButton(tr("Cancel")))
    , m_bar(new QProgressBar)
    , m_why(wrappedLabel({}, "muted"))
    , m_said(wrappedLabel())
{
    content()->addWidget(wrappedLabel(
        tr("Replaces the drone's program and restarts it. The drone tests nothing but the checksum: a file "
           "for another board ends it for good."),
        "warning"));
    m_upload->setObjectName(u"danger"_s);
    setHarmless(*m_cancel);
    m_bar->setAccessibleName(tr("Progress of the upload"));
    auto *row = new QHBoxLayout;
    row->addWidget(m_choose);
    row->addWidget(m_file, 1);
    auto *buttons = new QHBoxLayout;
    buttons->addWidget(m_upload);
    buttons->addWidget(m_cancel);
    buttons->addStretch(1);
    content()->addLayout(row);
    content()->addWidget(m_about);
    content()->addLayout(buttons);
    content()->addWidget(m_why);
    content()->addWidget(m_bar);
    content()->addWidget(m_said);
    connect(m_choose, &QPushButton::clicked, this, [this] {
        askOpenPath(this, tr("Firmware"), tr("All files (*)"), [this](const QString &path) { choose(path); });
    });
    connect(m_upload, &QPushButton::clicked, this, &FirmwareCard::upload);
    connect(m_cancel, &QPushButton::clicked, &workspace.client(), &DeviceClient::cancelMovingJobs);
    choose({});
}

// What cannot be uploaded is said before anybody confirms anything.
void FirmwareCard::choose(const QString &path)
{
    m_path.clear();
    m_file->setFullText(path.isEmpty() ? tr("No file is chosen.") : QFileInfo(path).fileName(), path);
    m_about->clear();
    say({}, "");
    if (!path.isEmpty()) {
        const auto image = bcflight::readFirmware(path);
        if (!image) {
            say(describe(image.error()).oneLine(), "error");
        } else {
            m_path = path;
            m_about->setText(tr("%1, checksum %2")
                                 .arg(sizeText(image->size()))
                                 .arg(crc32c(asBytes(*image)), 8, 16, QLatin1Char('0')));
        }
    }
    m_about->setVisible(!m_about->text().isEmpty());
    showState();
}

void FirmwareCard::setObstacle(const QString &why)
{
    m_why->setText(why);
    showState();
}

QString FirmwareCard::said() const
{
    return m_said->text();
}

void FirmwareCard::say(const QString &text, const char *look)
{
    sayIn(*m_said, text, look);
}

void FirmwareCard::showState()
{
    m_choose->setEnabled(!m_isRunning);
    m_upload->setEnabled(m_why->text().isEmpty() && !m_isRunning && !m_path.isEmpty());
    m_why->setVisible(!m_why->text().isEmpty() && !m_isRunning && !m_path.isEmpty());
    m_cancel->setVisible(m_isRunning);
    m_cancel->setEnabled(!m_isRestarting);
    m_bar->setVisible(m_hasBegun && m_isRunning);
}

void FirmwareCard::setRunning(bool running)
{
    m_isRunning = running;
    m_isRestarting = false;
    showState();
    emit runningChanged(running);
}

// The drone is asked as well (uploadFirmware()): here is said at once what is lacking.
bool FirmwareCard::refusesBattery()
{
    const double volts = m_workspace.latest(m_workspace.roles().battery);
    const double counted = m_workspace.latest(m_workspace.roles().batteryCells);
    const int cells = std::max(batteryCells(volts), std::isnan(counted) ? 0 : int(counted));
    const auto low = lowBattery(cells, kLowCellVolts, {});
    if (!low || volts >= *low)
        return false;
    say(tr("✖ Not begun: the battery is low (%1 V). A drone that loses its power while its program is "
           "replaced does not start any more. Charge or change the battery first.")
            .arg(numberText(volts, 1)),
        "error");
    return true;
}

void FirmwareCard::upload()
{
    if (refusesBattery())
        return;
    m_hasBegun = false;
    say({}, "");
    setRunning(true);
    whenDone(m_workspace.perform(u"firmware.upload"_s, {{u"file"_s, m_path}}, true), this,
             [this](const Result<ActionOutcome> &outcome) { onDone(outcome); });
}

void FirmwareCard::take(const Progress &progress)
{
    if (!m_isRunning || !progress.step.startsWith(u"firmware-"_s))
        return;
    m_hasBegun = true;
    m_isRestarting = progress.step == u"firmware-restart"_s;
    if (m_isRestarting) {
        m_bar->setRange(0, 0);
        say(tr("All of it is on the drone, which replaces its program and restarts. That cannot be called "
               "back and takes up to a minute: do not switch it off."),
            "warning");
    } else {
        m_bar->setRange(0, progress.total);
        m_bar->setValue(progress.done);
        say(tr("%1 of %2")
                .arg(sizeText(qint64(progress.values.value(u"bytes"_s))),
                     sizeText(qint64(progress.values.value(u"all"_s)))),
            "");
    }
    showState();
}

void FirmwareCard::onDone(const Result<ActionOutcome> &outcome)
{
    const bool wasRestarting = m_isRestarting;
    setRunning(false);
    if (outcome) {
        const QString before = outcome->reply.value(u"before"_s).toString();
        const QString now = outcome->reply.value(u"firmware"_s).toString();
        if (outcome->answered)
            say(tr("✓ The drone is back with firmware %1 (before: %2). Calibrate it before it flies.")
                    .arg(now, before),
                "ok");
        else
            say(tr("⚠ The drone is back and tells the same version as before, %1: whether it runs the new "
                   "firmware is not known.")
                    .arg(now),
                "warning");
        // What it says of itself is learned when a link begins.
        QTimer::singleShot(0, this, [this] {
            m_workspace.connectTo(m_workspace.client().address(), m_workspace.client().identity().family);
        });
        return;
    }
    const Error &error = outcome.error();
    if (!m_hasBegun) {
        if (error.code != ErrorCode::Cancelled)
            m_workspace.notifications().report(error);
        return;
    }
    const QString silent = tr("Its data stream stays silent until it is restarted: switch it off and on.");
    if (wasRestarting) {
        say(tr("✖ The drone was not seen to restart with the new firmware.") + u' '
                + withNumbers(detailText(error.detail)),
            "error");
    } else {
        say((error.code == ErrorCode::Cancelled
                 ? tr("⚠ The upload was cancelled; the drone runs the firmware that it had.")
                 : tr("✖ The upload has failed; the drone runs the firmware that it had."))
                + u' ' + silent,
            error.code == ErrorCode::Cancelled ? "warning" : "error");
    }
    if (error.code == ErrorCode::Cancelled)
        return;
    ErrorText text = describe(error);
    text.what = tr("The firmware was not replaced as far as is known.") + u' ' + text.what;
    if (!wasRestarting) {
        text.meaning = tr("The drone runs the firmware that it had.");
        if (error.code == ErrorCode::BoardError)
            text.meaning += u' '
                + tr("It refused a piece and may have taken its bytes for commands, arming included: keep "
                     "clear, and look at its state.");
        text.cure = silent;
    }
    m_workspace.notifications().report(text);
}
