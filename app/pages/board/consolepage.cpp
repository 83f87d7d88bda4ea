// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/board/consolepage.h"

#include "app/workspace/question.h"
#include "protocol/base/filefault.h"
#include "protocol/client/whendone.h"
#include "protocol/procedure/safeaction.h"
#include "widgets/forms/filtertable.h"

#include <QCheckBox>
#include <QCompleter>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTextBrowser>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kPeriod = 100ms;

}  // namespace

ConsolePage::ConsolePage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"console"_s, tr("Console"), parent)
    , m_model(workspace.client())
    , m_table(new FilterTable(m_model, FrameLogModel::SearchRole, workspace.theme()))
    , m_filter(m_table->makeFilterField(tr("Filter (Ctrl+F)"), tr("Filter frames"), this))
    , m_streams(new QCheckBox(tr("Live data too")))
    , m_pause(new QPushButton(tr("Pause")))
    , m_details(new QTextBrowser)
    , m_input(new QLineEdit)
    , m_allow(new QCheckBox(tr("Allow commands that change something")))
{
    m_filter->setMinimumWidth(160);
    m_streams->setToolTip(tr("Show the frames of streamed live data as well"));
    m_pause->setCheckable(true);
    auto *clear = new QPushButton(tr("Clear"));
    auto *save = new QPushButton(tr("Save…"));
    save->setToolTip(tr("Save all frames listed as text"));
    for (QWidget *widget :
         {static_cast<QWidget *>(m_streams), static_cast<QWidget *>(m_filter),
          static_cast<QWidget *>(m_pause), static_cast<QWidget *>(clear), static_cast<QWidget *>(save)})
        header()->addWidget(widget);

    const QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    m_table->setAccessibleName(tr("Frames"));
    m_table->setFont(fixed);
    m_details->setFont(fixed);
    m_details->setAccessibleName(tr("The chosen frame"));
    m_details->setPlaceholderText(tr("Choose a frame to see all of it."));
    m_details->setMaximumHeight(120);
    m_input->setAccessibleName(tr("Command to send"));
    m_input->setPlaceholderText(tr("Command: a name with fields or bytes, or a whole frame in hex"));
    m_input->setFont(fixed);
    m_allow->setToolTip(tr("Commands that write take a snapshot first; motors may move"));
    auto *sendButton = new QPushButton(tr("Send"));
    auto *row = new QHBoxLayout;
    row->setSpacing(Metric::kGap);
    row->addWidget(m_input, 1);
    row->addWidget(m_allow);
    row->addWidget(sendButton);
    body()->addWidget(m_table, 1);
    body()->addWidget(m_details);
    body()->addLayout(row);
    m_table->setColumnWidth(FrameLogModel::TimeColumn, 100);
    m_table->setColumnWidth(FrameLogModel::DirectionColumn, 90);
    m_table->setColumnWidth(FrameLogModel::NameColumn, 190);
    m_table->setColumnWidth(FrameLogModel::FieldsColumn, 380);

    connect(m_streams, &QCheckBox::toggled, this, [this](bool on) { m_model.setShowsStreams(on); });
    connect(m_pause, &QPushButton::toggled, this, [this](bool on) {
        m_pause->setText(on ? tr("Continue") : tr("Pause"));
        m_model.setPaused(on);
    });
    connect(clear, &QPushButton::clicked, &m_model, &FrameLogModel::clear);
    connect(save, &QPushButton::clicked, this, [this] {
        askSavePath(this, tr("Save frames"), u"frames.txt"_s, tr("Text files (*.txt)"),
                    [this](const QString &path) {
                        const auto saved = saveText(path);
                        if (!saved)
                            this->workspace().notifications().report(saved.error());
                    });
    });
    connect(sendButton, &QPushButton::clicked, this, &ConsolePage::send);
    connect(m_input, &QLineEdit::returnPressed, this, &ConsolePage::send);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            &ConsolePage::showDetails);
    connect(m_table->verticalScrollBar(), &QScrollBar::valueChanged, this,
            [this](int value) { m_follow = value >= m_table->verticalScrollBar()->maximum(); });
    connect(&workspace.client(), &DeviceClient::stateChanged, this, [this](DeviceClient::State state) {
        if (state != DeviceClient::State::Connected)
            return;
        const FrameInspector *inspector = this->workspace().client().device()->inspector();
        if (!inspector)
            return;
        auto *completer = new QCompleter(inspector->commandNames(), m_input);
        completer->setCaseSensitivity(Qt::CaseInsensitive);
        m_input->setCompleter(completer);
    });
    refreshWhileShown(
        kPeriod, [this] { refresh(); }, [this] { return m_pause->isChecked(); });
}

void ConsolePage::refresh()
{
    if (m_pause->isChecked())
        return;
    const bool follow = m_follow;
    m_model.refresh();
    if (follow)
        m_table->scrollToBottom();
}

void ConsolePage::showDetails(const QModelIndex &shown)
{
    if (!shown.isValid())
        return;
    const auto text = [&](int column) { return shown.siblingAtColumn(column).data().toString(); };
    m_details->setPlainText(
        u"%1 s  %2  %3\n%4\n%5"_s.arg(text(FrameLogModel::TimeColumn), text(FrameLogModel::DirectionColumn),
                                      text(FrameLogModel::NameColumn), text(FrameLogModel::FieldsColumn),
                                      text(FrameLogModel::BytesColumn)));
}

void ConsolePage::send()
{
    DeviceClient &client = workspace().client();
    if (!client.isConnected()) {
        workspace().notifications().report({ErrorCode::NotConnected, {}, 0});
        return;
    }
    const auto command = client.device()->inspector()->parseCommand(m_input->text());
    if (!command) {
        workspace().notifications().report(command.error(), Concern::Entry);
        return;
    }
    if (command->risk != ActionRisk::Safe && !m_allow->isChecked()) {
        ErrorText text;
        text.what = tr("%1 was not sent.").arg(command->name);
        text.meaning = tr("It can move motors or change settings.");
        text.cure = tr("Tick “Allow commands that change something” to send it all the same.");
        workspace().notifications().report(text, Concern::Entry);
        return;
    }
    workspace().notifications().settle(Concern::Entry);
    const RestartNotice *notice = client.device()->restartNotice();
    const auto goOn = [this, command = *command] { sendNow(command); };
    if (notice && notice->ordersReset(command->bytes))
        askToLetGo(workspace(), command->name, this, goOn);
    else
        goOn();
}

void ConsolePage::sendNow(const RawCommand &command)
{
    whenDone(workspace().client().submit<bool>(
                 [command, history = workspace().history(),
                  live = workspace().live().unsaved()](Channel &channel, Device &device) {
                     return sendRaw(channel, device, command, history, live);
                 }),
             this, [this, risk = command.risk](const Result<bool> &sent) {
                 if (!sent) {
                     workspace().notifications().report(sent.error());
                     return;
                 }
                 m_input->selectAll();
                 if (risk == ActionRisk::Safe || !workspace().client().isConnected())
                     return;
                 // Whatever it did, the screen says what the board holds.
                 workspace().live().read();
                 workspace().readBoard();
             });
}

Result<void> ConsolePage::saveText(const QString &path) const
{
    return writeWhole(path, m_model.text().toUtf8());
}
