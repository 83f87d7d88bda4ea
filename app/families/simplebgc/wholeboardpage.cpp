// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/simplebgc/wholeboardpage.h"

#include "app/families/simplebgc/copycard.h"

#include <QVBoxLayout>

using namespace Qt::StringLiterals;

WholeBoardPage::WholeBoardPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"wholeboard"_s, tr("Whole board"), parent)
    , m_card(new CopyCard(
          workspace, tr("Copies of the whole board"),
          tr("A copy holds the board's memory and its files byte for byte: settings, calibrations, licence, "
             "scripts, and what no document describes. All of it is read twice. What is broken off goes on "
             "when it is begun again with the same file."),
          u"board.bin"_s,
          {{tr("Copy the board…"),
            tr("Into a file; nothing on the board is changed"),
            u"memory.save"_s,
            true,
            {{u"files"_s, true}}},
           {tr("Compare…"), tr("Tell what differs between a copy and the board"), u"memory.compare"_s},
           {tr("Restore settings…"),
            tr("Write the settings of a copy; calibrations, licence and what no document describes stay"),
            u"memory.restore"_s,
            false,
            {{u"part"_s, 1}},
            true},
           {tr("Restore everything…"),
            tr("Write memory and files as they are in a copy"),
            u"memory.restore"_s,
            false,
            {{u"part"_s, 0}},
            true},
           {tr("Erase all files…"),
            tr("Copy the board into a new file, then clear its file system"),
            u"file.erase_all"_s,
            true,
            {},
            true}}))
{
    body()->addWidget(m_card, 1);
}

bool WholeBoardPage::isUnderWay() const
{
    return m_card->isRunning();
}
