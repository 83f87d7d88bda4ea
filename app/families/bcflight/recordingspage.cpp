// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/bcflight/recordingspage.h"

#include "protocol/bcflight/device.h"
#include "protocol/bcflight/infotext.h"
#include "protocol/client/whendone.h"
#include "widgets/models/numbertext.h"
#include "widgets/theme/tablelook.h"

#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace {

enum RecordingColumn { RecordingName, RecordingSize, RecordingColumns };

// Sorted as the number that it stands for.
class SizeCell final : public QTableWidgetItem
{
public:
    explicit SizeCell(qint64 bytes)
        : QTableWidgetItem(sizeText(bytes))
    {
        setData(Qt::UserRole, bytes);
        setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    }
    bool operator<(const QTableWidgetItem &other) const override
    {
        return data(Qt::UserRole).toLongLong() < other.data(Qt::UserRole).toLongLong();
    }
};

}  // namespace

RecordingsPage::RecordingsPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"recordings"_s, tr("Recordings"), parent)
    , m_table(new QTableWidget)
    , m_refresh(new QPushButton(tr("Read again")))
    , m_found(new QLabel)
{
    m_refresh->setToolTip(tr("Ask the drone for its list once more"));
    header()->addWidget(m_refresh);
    m_table->setAccessibleName(tr("Recordings on the drone"));
    m_table->setColumnCount(RecordingColumns);
    m_table->setHorizontalHeaderLabels({tr("Name"), tr("Size")});
    setSelectableRows(*m_table);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_table->setAlternatingRowColors(true);
    m_table->horizontalHeader()->setSectionResizeMode(RecordingName, QHeaderView::Stretch);
    m_table->horizontalHeader()->setSectionResizeMode(RecordingSize, QHeaderView::ResizeToContents);
    m_found->setWordWrap(true);
    auto *note = new QLabel(tr("The list is all that a drone offers: over this link recordings can neither "
                               "be downloaded nor deleted. "
                               "Take them from the memory card, or log in on the drone's computer."));
    note->setObjectName(u"muted"_s);
    note->setWordWrap(true);
    body()->addWidget(m_found);
    body()->addWidget(m_table, 1);
    body()->addWidget(note);
    connect(m_refresh, &QPushButton::clicked, this, &RecordingsPage::read);
    connect(&workspace.client(), &DeviceClient::stateChanged, this, [this](DeviceClient::State state) {
        m_isRead = m_isRead && state == DeviceClient::State::Connected;
        if (state == DeviceClient::State::Connected && isVisible())
            read();
        showState();
    });
    showState();
}

void RecordingsPage::showEvent(QShowEvent *event)
{
    Page::showEvent(event);
    if (!m_isRead)
        read();
}

void RecordingsPage::read()
{
    if (!workspace().client().isConnected() || m_isReading)
        return;
    m_isRead = m_isReading = true;
    showState();
    whenDone(workspace().client().submit<QByteArray>([](Channel &channel, Device &device) {
        // The page is only offered to this family's boards.
        return static_cast<bcflight::Device &>(device).readRecordingsList(channel);
    }),
             this, [this](const Result<QByteArray> &list) {
                 m_isReading = false;
                 if (list)
                     showList(*list);
                 else if (!isEndOfLink(list.error()))
                     workspace().notifications().report(list.error());
                 showState();
             });
}

void RecordingsPage::showList(const QByteArray &list)
{
    int damaged = 0;
    const QList<bcflight::RecordingEntry> entries = bcflight::readRecordings(list, damaged);
    m_table->setSortingEnabled(false);
    m_table->setRowCount(int(entries.size()));
    qint64 bytes = 0;
    for (int row = 0; row < int(entries.size()); ++row) {
        m_table->setItem(row, RecordingName, new QTableWidgetItem(entries[row].name));
        m_table->setItem(row, RecordingSize, new SizeCell(entries[row].bytes));
        bytes += entries[row].bytes;
    }
    m_table->setSortingEnabled(true);
    m_finding = entries.isEmpty()
        ? tr("The drone has recorded nothing.")
        : tr("%n recording(s), %1", nullptr, int(entries.size())).arg(sizeText(bytes));
    if (damaged > 0)
        m_finding += u' ' + tr("%n entry(s) of its list could not be read.", nullptr, damaged);
    showState();
}

void RecordingsPage::showState()
{
    const bool isConnected = workspace().client().isConnected();
    m_refresh->setEnabled(isConnected && !m_isReading);
    if (m_isReading)
        m_found->setText(tr("Asking the drone…"));
    else if (!m_finding.isEmpty())
        m_found->setText(isConnected ? m_finding : m_finding + u' ' + tr("It is not connected now."));
    else
        m_found->setText(isConnected ? tr("The drone has not told its list.")
                                     : tr("Connect a drone to see what it has recorded."));
}
