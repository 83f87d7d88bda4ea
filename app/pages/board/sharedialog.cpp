// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/board/sharedialog.h"

#include "app/workspace/filedialogs.h"
#include "widgets/views/settingspicture.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QImageWriter>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

ShareDialog::ShareDialog(Workspace &workspace, QWidget *parent)
    : QDialog(parent)
    , m_image(settingsPicture(std::as_const(workspace.configuration()).edited(),
                              workspace.configuration().shownProfile(), workspace.theme(), 2.0))
{
    setWindowTitle(tr("Share settings"));
    resize(940, 580);
    auto *intro
        = new QLabel(tr("All values as they are shown now, edits included, for a forum or a colleague."));
    intro->setWordWrap(true);
    auto *picture = new QLabel;
    picture->setPixmap(QPixmap::fromImage(m_image));
    picture->setAccessibleName(tr("Picture of all values"));
    auto *scroll = new QScrollArea;
    scroll->setWidget(picture);
    auto *close = new QPushButton(tr("Close"));
    auto *copy = new QPushButton(tr("Copy"));
    auto *saveAs = new QPushButton(tr("Save…"));
    saveAs->setObjectName(u"primary"_s);
    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(Metric::kGap);
    buttons->addStretch(1);
    for (QPushButton *button : {close, copy, saveAs})
        buttons->addWidget(button);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(Metric::kMargin, Metric::kMargin, Metric::kMargin, Metric::kMargin);
    layout->setSpacing(Metric::kGap);
    layout->addWidget(intro);
    layout->addWidget(scroll, 1);
    layout->addLayout(buttons);
    connect(close, &QPushButton::clicked, this, &QDialog::reject);
    connect(copy, &QPushButton::clicked, this, [this, &workspace] {
        QGuiApplication::clipboard()->setImage(m_image);
        workspace.notifications().notify(tr("The picture is in the clipboard."));
    });
    connect(saveAs, &QPushButton::clicked, this, [this, &workspace] {
        askSavePath(this, tr("Save the picture"), u"settings.png"_s, tr("Pictures (*.png)"),
                    [this, &workspace](const QString &path) {
                        workspace.notifications().reportSaved(save(path), path);
                    });
    });
}

Result<void> ShareDialog::save(const QString &path) const
{
    QImageWriter writer(path, "png");
    if (!writer.write(m_image))
        return failure(ErrorCode::BadFile, u"%1: %2"_s.arg(path, writer.errorString()));
    return {};
}
