// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/board/sharedialog.h"

#include "app/workspace/filedialogs.h"
#include "protocol/base/filefault.h"
#include "widgets/views/settingspicture.h"

#include <QBuffer>
#include <QCheckBox>
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
    , m_workspace(workspace)
    , m_edits(new QCheckBox(tr("With unwritten changes")))
    , m_picture(new QLabel)
{
    setWindowTitle(tr("Share settings"));
    resize(940, 580);
    auto *intro = new QLabel(tr("All values, for a forum or a colleague."));
    intro->setWordWrap(true);
    m_edits->setToolTip(tr("The picture says that they are on it and on no board"));
    m_edits->setChecked(true);
    m_edits->setVisible(workspace.configuration().changeCount() > 0);
    connect(m_edits, &QCheckBox::toggled, this, &ShareDialog::draw);
    draw();
    m_picture->setAccessibleName(tr("Picture of all values"));
    auto *scroll = new QScrollArea;
    scroll->setWidget(m_picture);
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
    layout->addWidget(m_edits);
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

void ShareDialog::draw()
{
    const ConfigurationModel &model = std::as_const(m_workspace).configuration();
    const int changes = m_edits->isChecked() ? model.changeCount() : 0;
    m_image = settingsPicture(changes > 0 ? model.edited() : model.board(), model.shownProfile(),
                              m_workspace.theme(), 2.0,
                              changes > 0 ? tr("with %n unwritten change(s)", nullptr, changes) : QString());
    m_picture->setPixmap(QPixmap::fromImage(m_image));
    m_picture->resize(m_picture->sizeHint());  // adjustSize() minds the screen while there is no parent
}

Result<void> ShareDialog::save(const QString &path) const
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QImageWriter writer(&buffer, "png");
    if (!writer.write(m_image))
        return fileFailure(
            {.problem = FileProblem::System, .path = path, .writing = true, .said = writer.errorString()});
    return writeWhole(path, bytes);
}
