// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/filedialogs.h"

#include "app/workspace/question.h"

#include <QCoreApplication>
#include <QDialog>
#include <QFileDialog>
#include <QFileInfo>

#include <memory>

namespace {

struct FileDialogs
{
    Q_DECLARE_TR_FUNCTIONS(FileDialogs)
};

// Says beside its field what it does not find: a box of Qt's own would keep clicks from the main window.
class FileDialog final : public QFileDialog
{
public:
    // Its parent is the window: what belongs to the page is disabled along with it.
    FileDialog(const QWidget &owner, const QString &title, const QString &folder, const QString &filter)
        : QFileDialog(owner.window(), title, folder, filter)
    {
        setAttribute(Qt::WA_DeleteOnClose);
        setOptions(DontUseNativeDialog | DontConfirmOverwrite);
    }

protected:
    void accept() override
    {
        const QStringList files = selectedFiles();
        if (fileMode() == ExistingFile && !files.isEmpty() && !QFileInfo::exists(files.first()))
            setLabelText(FileName, FileDialogs::tr("There is no such file:"));
        else
            QFileDialog::accept();
    }
};

// A modal window would keep keys and clicks from the one that has the red button, and a dialog of the desktop
// keys from this program. So it is neither, and a panel keeps the rest of the window out of reach meanwhile.
void openBeside(FileDialog *dialog, QWidget *owner, const PathChosen &chosen)
{
    QDialog *panel
        = askInPanel({dialog->windowTitle(),
                      FileDialogs::tr("The file is chosen in a window of its own. The motors can be stopped "
                                      "meanwhile, here and there."),
                      {},
                      FileDialogs::tr("Cancel")},
                     owner);
    const auto path = std::make_shared<QString>();
    QObject::connect(dialog, &QFileDialog::fileSelected, dialog,
                     [path](const QString &file) { *path = file; });
    QObject::connect(panel, &QDialog::finished, dialog, &QDialog::reject);
    QObject::connect(owner, &QObject::destroyed, panel, &QDialog::reject, Qt::QueuedConnection);
    QObject::connect(dialog, &QDialog::finished, panel, [dialog, panel] {
        panel->disconnect(dialog);
        if (!panel->isHidden())
            panel->reject();
    });
    QObject::connect(dialog, &QDialog::finished, owner, [path, chosen](int result) {
        if (result == QDialog::Accepted && !path->isEmpty())
            chosen(*path);
    });
    dialog->show();
    dialog->activateWindow();
}

// What to do about a file that is there already.
void askToReplace(QWidget *owner, const QString &path, const std::function<void()> &replace,
                  const std::function<void()> &chooseAgain)
{
    const QFileInfo file(path);
    askInPanel({FileDialogs::tr("Replace “%1”?").arg(file.fileName()),
                FileDialogs::tr("The folder %1 has a file of this name; what it holds is lost.")
                    .arg(file.absolutePath()),
                {{FileDialogs::tr("Replace"), replace, true},
                 {FileDialogs::tr("Choose another name…"), chooseAgain}},
                FileDialogs::tr("Keep it")},
               owner);
}

}  // namespace

void askSavePath(QWidget *owner, const QString &title, const QString &name, const QString &filter,
                 const PathChosen &chosen)
{
    auto *dialog = new FileDialog(*owner, title, {}, filter);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QFileInfo(name).suffix());
    dialog->selectFile(name);
    // "Settings (*.cfg)" sets the suffix "cfg".
    QObject::connect(dialog, &QFileDialog::filterSelected, dialog, [dialog](const QString &chosenFilter) {
        dialog->setDefaultSuffix(chosenFilter.section(QStringLiteral("*."), 1).chopped(1));
    });
    openBeside(dialog, owner, [owner, title, filter, chosen](const QString &path) {
        if (QFileInfo::exists(path))
            askToReplace(
                owner, path, [chosen, path] { chosen(path); },
                [owner, title, path, filter, chosen] { askSavePath(owner, title, path, filter, chosen); });
        else
            chosen(path);
    });
}

void askOpenPath(QWidget *owner, const QString &title, const QString &filter, const PathChosen &chosen,
                 const QString &folder)
{
    auto *dialog = new FileDialog(*owner, title, folder, filter);
    dialog->setFileMode(QFileDialog::ExistingFile);
    openBeside(dialog, owner, chosen);
}
