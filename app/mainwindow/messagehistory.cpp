// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/messagehistory.h"

#include "app/mainwindow/messagerow.h"
#include "widgets/theme/theme.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QLocale>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

MessageHistory::MessageHistory(const Notifications &notifications, QWidget *parent)
    : QDialog(parent)
{
    setWindowTitle(tr("Messages"));
    setAttribute(Qt::WA_DeleteOnClose);
    resize(720, 440);
    QStringList lines;
    for (const ToldMessage &message : notifications.history())
        lines.prepend(u"%1  %2%3"_s.arg(QLocale().toString(message.at.time(), u"HH:mm:ss"_s),
                                        messageSign(message.kind), message.text));
    auto *text = new QPlainTextEdit(lines.join(u'\n'));
    text->setReadOnly(true);
    text->setTabChangesFocus(true);
    text->setAccessibleName(windowTitle());
    text->setPlaceholderText(tr("Nothing was told yet."));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    const auto *copy = buttons->addButton(tr("Copy"), QDialogButtonBox::ActionRole);
    auto *layout = new QVBoxLayout(this);
    layout->setSpacing(Metric::kGap);
    layout->addWidget(text, 1);
    layout->addWidget(buttons);
    connect(copy, &QPushButton::clicked, this,
            [text] { QGuiApplication::clipboard()->setText(text->toPlainText()); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}
