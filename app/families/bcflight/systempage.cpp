// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/bcflight/systempage.h"

#include "protocol/bcflight/device.h"
#include "protocol/bcflight/infotext.h"
#include "protocol/client/whendone.h"
#include "widgets/models/errortext.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"

#include <QClipboard>
#include <QFontDatabase>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace {

constexpr int kNameWidth = 320;
constexpr std::array kQuestions{bcflight::Message::GetBoardInfos, bcflight::Message::GetSensorsInfos,
                                bcflight::Message::GetCamerasInfos};

void addNodes(QTreeWidgetItem &parent, const QList<bcflight::InfoNode> &nodes)
{
    for (const bcflight::InfoNode &node : nodes) {
        const QString value = node.value == u"nil"_s ? SystemPage::tr("none") : node.value;
        auto *item = new QTreeWidgetItem(&parent, {node.name, value});
        item->setToolTip(1, value);
        addNodes(*item, node.children);
    }
}

void addLines(const QTreeWidgetItem &item, int depth, QString &text)
{
    text += QString(2 * depth, u' ') + item.text(0);
    if (!item.text(1).isEmpty())
        text += u": "_s + item.text(1);
    text += u'\n';
    for (int i = 0; i < item.childCount(); ++i)
        addLines(*item.child(i), depth + 1, text);
}

}  // namespace

SystemPage::SystemPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"system"_s, tr("System"), parent)
    , m_tree(new QTreeWidget)
    , m_refresh(new QPushButton(tr("Read again")))
    , m_copy(new QPushButton(tr("Copy")))
    , m_message(new QLabel)
{
    m_refresh->setToolTip(tr("Ask the drone once more"));
    m_copy->setToolTip(tr("Copy all of it as text"));
    header()->addWidget(m_refresh);
    header()->addWidget(m_copy);
    m_tree->setAccessibleName(tr("What the drone tells of itself"));
    m_tree->setHeaderLabels({tr("Name"), tr("Value")});
    m_tree->header()->resizeSection(0, kNameWidth);
    m_tree->header()->setStretchLastSection(true);
    m_tree->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_tree->setAlternatingRowColors(true);
    m_tree->setTabKeyNavigation(false);
    for (int part = 0; part < PartCount; ++part)
        new QTreeWidgetItem(m_tree, {partName(Part(part))});
    m_message->setObjectName(u"muted"_s);
    m_message->setWordWrap(true);
    body()->addWidget(m_message);
    body()->addWidget(m_tree, 1);
    connect(m_refresh, &QPushButton::clicked, this, &SystemPage::read);
    connect(m_copy, &QPushButton::clicked, this, [this] { QGuiApplication::clipboard()->setText(text()); });
    connect(&workspace.client(), &DeviceClient::stateChanged, this, [this](DeviceClient::State state) {
        m_isRead = m_isRead && state == DeviceClient::State::Connected;
        if (state == DeviceClient::State::Connected && isVisible())
            read();
        showState();
    });
    showState();
}

QString SystemPage::partName(Part part)
{
    switch (part) {
    case Board: return tr("Board");
    case Sensors: return tr("Sensors");
    default: return tr("Cameras");
    }
}

void SystemPage::showEvent(QShowEvent *event)
{
    Page::showEvent(event);
    if (!m_isRead)
        read();
}

void SystemPage::read()
{
    if (!workspace().client().isConnected() || m_open > 0)
        return;
    m_isRead = true;
    m_readAt = QDateTime::currentDateTime();
    for (int part = 0; part < PartCount; ++part)
        readPart(Part(part));
    showState();
}

void SystemPage::readPart(Part part)
{
    ++m_open;
    whenDone(workspace().client().submit<QString>(
                 [id = kQuestions[std::size_t(part)]](Channel &channel, Device &device) {
                     // The page is only offered to this family's boards.
                     return static_cast<bcflight::Device &>(device).readInformation(channel, id);
                 }),
             this, [this, part](const Result<QString> &told) {
                 --m_open;
                 if (told)
                     showText(part, *told);
                 else if (!isEndOfLink(told.error()))
                     showNote(part, tr("not told: %1").arg(describe(told.error()).what));
                 showState();
             });
}

QTreeWidgetItem *SystemPage::clearedPart(Part part)
{
    QTreeWidgetItem *item = m_tree->topLevelItem(part);
    qDeleteAll(item->takeChildren());
    item->setText(1, {});
    return item;
}

void SystemPage::showNote(Part part, const QString &note)
{
    clearedPart(part)->setText(1, note);
}

void SystemPage::showText(Part part, const QString &text)
{
    QTreeWidgetItem *item = clearedPart(part);
    const auto nodes = bcflight::readInfo(text.toUtf8());
    if (nodes && nodes->isEmpty()) {
        item->setText(1, tr("none"));
    } else if (nodes) {
        addNodes(*item, *nodes);
    } else {
        item->setText(1, tr("It cannot be read as a table; this is what came:"));
        const QFont fixed = QFontDatabase::systemFont(QFontDatabase::FixedFont);
        for (const QString &line : text.split(u'\n', Qt::SkipEmptyParts)) {
            auto *row = new QTreeWidgetItem(item, {line});
            row->setFont(0, fixed);
            row->setFirstColumnSpanned(true);
        }
    }
    m_tree->expandAll();
}

QString SystemPage::text() const
{
    QString text;
    for (int part = 0; part < PartCount; ++part)
        addLines(*m_tree->topLevelItem(part), 0, text);
    return text;
}

// What is selected, or all of it.
void SystemPage::keyPressEvent(QKeyEvent *event)
{
    if (!event->matches(QKeySequence::Copy)) {
        Page::keyPressEvent(event);
        return;
    }
    QString chosen;
    for (QTreeWidgetItemIterator it(m_tree, QTreeWidgetItemIterator::Selected); *it; ++it) {
        const QString value = (*it)->text(1);
        chosen += (*it)->text(0) + (value.isEmpty() ? QString() : u": "_s + value) + u'\n';
    }
    QGuiApplication::clipboard()->setText(chosen.isEmpty() ? text() : chosen);
}

void SystemPage::showState()
{
    const bool isConnected = workspace().client().isConnected();
    m_refresh->setEnabled(isConnected && m_open == 0);
    m_copy->setEnabled(m_readAt.isValid());
    if (m_open > 0)
        m_message->setText(tr("Asking the drone…"));
    else if (!m_readAt.isValid())
        m_message->setText(tr("Connect a drone to see what it tells of its board, sensors and cameras."));
    else
        m_message->setText(
            isConnected ? tr("As the drone told it on %1.").arg(dateText(m_readAt))
                        : tr("As the drone told it on %1; it is not connected now.").arg(dateText(m_readAt)));
}
