// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/filedialogs.h"

#include <QFileDialog>
#include <QFileInfo>

void askSavePath(QWidget *owner, const QString &title, const QString &name, const QString &filter,
                 const PathChosen &chosen)
{
    auto *dialog = new QFileDialog(owner, title, {}, filter);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QFileInfo(name).suffix());
    dialog->selectFile(name);
    // "Settings (*.cfg)" sets the suffix "cfg".
    QObject::connect(dialog, &QFileDialog::filterSelected, dialog, [dialog](const QString &chosenFilter) {
        dialog->setDefaultSuffix(chosenFilter.section(QStringLiteral("*."), 1).chopped(1));
    });
    QObject::connect(dialog, &QFileDialog::fileSelected, owner, chosen);
    dialog->open();
}

void askOpenPath(QWidget *owner, const QString &title, const QString &filter, const PathChosen &chosen,
                 const QString &folder)
{
    auto *dialog = new QFileDialog(owner, title, folder, filter);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    QObject::connect(dialog, &QFileDialog::fileSelected, owner, chosen);
    dialog->open();
}
