// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with a file, in the operator's words.
#include "protocol/base/filefault.h"
#include "widgets/models/errortext.h"
#include "widgets/models/numbertext.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QRegularExpression>

#include <array>

using namespace Qt::StringLiterals;

namespace {

/// The context of the catalogue.
class FileWords
{
    Q_DECLARE_TR_FUNCTIONS(FileFault)
};

// In the order of FileKind.
constexpr std::array<const char *, 13> kKinds{
    QT_TRANSLATE_NOOP("FileFault", "a configuration"),
    QT_TRANSLATE_NOOP("FileFault", "a recording"),
    QT_TRANSLATE_NOOP("FileFault", "a settings file of the manufacturer's program"),
    QT_TRANSLATE_NOOP("FileFault", "a sensor calibration"),
    QT_TRANSLATE_NOOP("FileFault", "a measurement (two columns of numbers)"),
    QT_TRANSLATE_NOOP("FileFault", "a script"),
    QT_TRANSLATE_NOOP("FileFault", "a text in UTF-8"),
    QT_TRANSLATE_NOOP("FileFault", "a firmware"),
    QT_TRANSLATE_NOOP("FileFault", "a list of unwritten edits"),
    QT_TRANSLATE_NOOP("FileFault", "the list of boards"),
    QT_TRANSLATE_NOOP("FileFault", "a layout of plots"),
    QT_TRANSLATE_NOOP("FileFault", "the program's settings"),
    QT_TRANSLATE_NOOP("FileFault", "a file of this program"),
};
static_assert(kKinds.size() == std::size_t(FileKind::Other) + 1);

/// What is said of one problem.
struct ProblemRow
{
    FileProblem problem;
    const char *what;  ///< %1: the file, with its line
    const char *cure;
};

// clang-format off
constexpr auto kProblems = std::to_array<ProblemRow>({
    {FileProblem::Missing,
     QT_TRANSLATE_NOOP("FileFault", "%1 does not exist."),
     QT_TRANSLATE_NOOP("FileFault", "Check the name and the folder.")},
    {FileProblem::NotReadable,
     QT_TRANSLATE_NOOP("FileFault", "%1 may not be read by this user."),
     QT_TRANSLATE_NOOP("FileFault", "Change the file's permissions, or choose another file.")},
    {FileProblem::NotWritable,
     QT_TRANSLATE_NOOP("FileFault", "%1 may not be written by this user."),
     QT_TRANSLATE_NOOP("FileFault", "Change the permissions, or choose another folder.")},
    {FileProblem::DiskFull,
     QT_TRANSLATE_NOOP("FileFault", "The disk is full: %1 could not be written."),
     QT_TRANSLATE_NOOP("FileFault", "Free some space or choose another disk, then save again.")},
    {FileProblem::System,
     QT_TRANSLATE_NOOP("FileFault", "%1 could not be read or written: %2."),
     QT_TRANSLATE_NOOP("FileFault", "Check the file and the disk, then try again.")},
    {FileProblem::Empty,
     QT_TRANSLATE_NOOP("FileFault", "%1 is empty."),
     QT_TRANSLATE_NOOP("FileFault", "Use another copy, or save the file again.")},
    {FileProblem::Truncated,
     QT_TRANSLATE_NOOP("FileFault", "%1 is cut off: its end is missing."),
     QT_TRANSLATE_NOOP("FileFault", "Use another copy: this one was not saved or copied completely.")},
    {FileProblem::OtherKind,
     QT_TRANSLATE_NOOP("FileFault", "%1 is not %2."),
     QT_TRANSLATE_NOOP("FileFault", "Choose another file.")},
    {FileProblem::OtherFamily,
     QT_TRANSLATE_NOOP("FileFault", "%1 belongs to boards of another family: %2 instead of %3."),
     QT_TRANSLATE_NOOP("FileFault", "Choose a file that was saved from a board of the right family.")},
    {FileProblem::NewerVersion,
     QT_TRANSLATE_NOOP("FileFault", "%1 was written by a newer version of the program (format %2; this version reads up to %3)."),
     QT_TRANSLATE_NOOP("FileFault", "Update the program.")},
    {FileProblem::OutOfRange,
     QT_TRANSLATE_NOOP("FileFault", "%1: %2 is %3, allowed: %4."),
     QT_TRANSLATE_NOOP("FileFault", "Correct the value in the file, or use another copy.")},
    {FileProblem::BadValue,
     QT_TRANSLATE_NOOP("FileFault", "%1: %2 is “%3”, which is not understood; expected: %4."),
     QT_TRANSLATE_NOOP("FileFault", "Correct the entry in the file, or use another copy.")},
    {FileProblem::MissingEntry,
     QT_TRANSLATE_NOOP("FileFault", "%1 lacks the entry “%2”."),
     QT_TRANSLATE_NOOP("FileFault", "Add the entry, or use another copy.")},
    {FileProblem::Doubled,
     QT_TRANSLATE_NOOP("FileFault", "%1: %2 stands there twice, first in line %3."),
     QT_TRANSLATE_NOOP("FileFault", "Remove the one that is wrong, or use another copy.")},
    {FileProblem::Damaged,
     QT_TRANSLATE_NOOP("FileFault", "%1 is damaged."),
     QT_TRANSLATE_NOOP("FileFault", "Use another copy.")},
    {FileProblem::TooLarge,
     QT_TRANSLATE_NOOP("FileFault", "%1 is too large for %2."),
     QT_TRANSLATE_NOOP("FileFault", "Choose another file.")},
    {FileProblem::Same,
     QT_TRANSLATE_NOOP("FileFault", "%1 is the very file that is to be copied."),
     QT_TRANSLATE_NOOP("FileFault", "Choose another name or folder.")},
});
// clang-format on

constexpr bool everyProblemHasItsRow()
{
    for (std::size_t i = 0; i < kProblems.size(); ++i) {
        if (std::size_t(kProblems[i].problem) != i)
            return false;
    }
    return kProblems.size() == std::size_t(FileProblem::Same) + 1;
}
static_assert(everyProblemHasItsRow(), "one row for each problem, in the order of FileProblem");

QString meaningText(const FileFault &fault)
{
    if (fault.problem == FileProblem::Same)
        return FileWords::tr("Nothing was copied.");
    if (fault.writing)
        return FileWords::tr("What was to be saved is not, or not completely, in it.");
    switch (fault.kind) {
    case FileKind::Journal:
        return FileWords::tr("Unwritten edits of an earlier run cannot be restored from it.");
    case FileKind::BoardNames:
        return FileWords::tr("Which snapshots belong to which board without a serial number is not known.");
    case FileKind::ProgramSettings: return FileWords::tr("Default settings are used in their place.");
    default: return FileWords::tr("Nothing was taken from it.");
    }
}

// Ranges come as "1.5 to 3".
QString allowedText(const QString &expected)
{
    static const QRegularExpression range(u"(\\S+) to (\\S+)"_s);
    return withNumbers(QString(expected).replace(range, FileWords::tr("\\1 to \\2")));
}

// What is wrong in one line, not with the file as a whole.
bool concernsLine(FileProblem problem)
{
    return problem == FileProblem::Truncated || problem == FileProblem::Damaged
        || problem == FileProblem::OutOfRange || problem == FileProblem::BadValue
        || problem == FileProblem::Doubled;
}

QString placeText(const FileFault &fault)
{
    const QString name = QFileInfo(fault.path).fileName();
    const bool inLine = fault.line > 0 && concernsLine(fault.problem);
    if (name.isEmpty())
        return inLine ? FileWords::tr("The file, line %1,").arg(fault.line) : FileWords::tr("The file");
    return inLine ? FileWords::tr("“%1”, line %2,").arg(name, QString::number(fault.line))
                  : FileWords::tr("“%1”").arg(name);
}

QString whatText(const FileFault &fault)
{
    QString place = placeText(fault);
    QString key = fault.key;
    if (fault.profile >= 0)
        key = FileWords::tr("%1 of profile %2").arg(key).arg(fault.profile + 1);
    QString pattern = FileWords::tr(kProblems.at(std::size_t(fault.problem)).what);
    QStringList values;
    switch (fault.problem) {
    case FileProblem::Missing:
        if (fault.writing)
            pattern = FileWords::tr("The folder of %1 does not exist.");
        break;
    case FileProblem::System: values = {fault.said}; break;
    case FileProblem::OtherKind:
    case FileProblem::TooLarge: values = {FileWords::tr(kKinds.at(std::size_t(fault.kind)))}; break;
    case FileProblem::OtherFamily:
        values = {fault.value, fault.expected};
        if (fault.expected.isEmpty()) {
            values = {fault.value};
            pattern
                = FileWords::tr("%1 belongs to boards of the family “%2”, which this program does not know.");
        }
        break;
    case FileProblem::NewerVersion: values = {fault.value, fault.expected}; break;
    case FileProblem::OutOfRange:
    case FileProblem::BadValue:
        values = {key, withNumbers(fault.value), allowedText(fault.expected)};
        if (key.isEmpty()) {
            values.removeFirst();
            pattern = FileWords::tr("%1: “%2” is not understood; expected: %3.");
        }
        break;
    case FileProblem::MissingEntry: values = {key}; break;
    case FileProblem::Doubled: values = {key, fault.expected}; break;
    default: break;
    }
    // After a line stands a comma, before a colon there is none.
    if (pattern.startsWith(u"%1:"_s) && place.endsWith(u','))
        place.chop(1);
    // All in one call: what is in the file may itself look like a placeholder.
    values.prepend(place);
    switch (values.size()) {
    case 1: return pattern.arg(values[0]);
    case 2: return pattern.arg(values[0], values[1]);
    case 3: return pattern.arg(values[0], values[1], values[2]);
    default: return pattern.arg(values[0], values[1], values[2], values[3]);
    }
}

}  // namespace

ErrorText describe(const FileFault &fault)
{
    QStringList details;
    if (!fault.path.isEmpty())
        details.append(fault.path);
    if (!fault.said.isEmpty() && fault.problem != FileProblem::System)
        details.append(fault.said);
    if (!fault.key.isEmpty() && fault.problem == FileProblem::Damaged)
        details.append(fault.key);
    return {whatText(fault), meaningText(fault), FileWords::tr(kProblems.at(std::size_t(fault.problem)).cure),
            details.join(u": "_s)};
}
