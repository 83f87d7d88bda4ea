// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// Whose history it is: boards without a serial number, and the names that the operator gave them.
#include "protocol/base/filefault.h"
#include "protocol/base/jsonplace.h"
#include "protocol/record/boardhistory.h"

#include <QDir>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QRegularExpression>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

const QString kNamesFile = u"boards.json"_s;
const QString kDamaged = u".damaged"_s;
constexpr qint64 kLargestNames = 1'048'576;

// The serial number comes from the board: it must not lead out of the folder.
QString plainName(const QString &serial)
{
    QString name = serial;
    name.replace(QRegularExpression(u"[^A-Za-z0-9-]"_s), u"_"_s);
    return name.isEmpty() ? u"unknown"_s : name.left(80);
}

}  // namespace

QList<BoardHistory::Named> BoardHistory::named() const
{
    const auto file = readJson(namesPath(), FileKind::BoardNames, kLargestNames, '[');
    if (!file)
        return {};
    QList<Named> all;
    for (const QJsonValue value : file->array()) {
        const QJsonObject board = value.toObject();
        const auto text = [&board](const QString &key) { return board.value(key).toString(); };
        // The file may have been edited: a folder stays inside.
        all.append({text(u"name"_s), text(u"family"_s), plainName(text(u"folder"_s)), text(u"look"_s),
                    text(u"before"_s)});
    }
    return all;
}

Result<void> BoardHistory::save(const QList<Named> &all) const
{
    QJsonArray boards;
    for (const Named &board : all) {
        QJsonObject object{{u"name"_s, board.name},
                           {u"family"_s, board.family},
                           {u"folder"_s, board.folder},
                           {u"look"_s, board.look}};
        if (!board.before.isEmpty())
            object.insert(u"before"_s, board.before);
        boards.append(object);
    }
    QDir().mkpath(m_root);
    if (!checkNames()) {  // what cannot be read is kept, not written over
        QFile::remove(namesPath() + kDamaged);
        QFile::rename(namesPath(), namesPath() + kDamaged);
    }
    return writeWhole(namesPath(), QJsonDocument(boards).toJson(), FileKind::BoardNames);
}

QString BoardHistory::namesPath() const
{
    return QDir(m_root).filePath(kNamesFile);
}

Result<void> BoardHistory::checkNames() const
{
    const auto file = readJson(namesPath(), FileKind::BoardNames, kLargestNames, '[');
    if (!file && file.error().file->problem != FileProblem::Missing)
        return tl::unexpected(file.error());
    return {};
}

// Of several boards that look the same it is the chosen one; without a choice it is none of them.
const BoardHistory::Named *BoardHistory::find(const QList<Named> &all, const QString &serial) const
{
    for (const bool renamed : {false, true}) {
        const Named *found = nullptr;
        int count = 0;
        for (const Named &board : all) {
            if ((renamed ? board.before : board.look) != serial)
                continue;
            if (board.name == m_chosen)
                return &board;
            found = &board;
            ++count;
        }
        if (count > 0)
            return count == 1 ? found : nullptr;
    }
    return nullptr;
}

// What no named board keeps under this look; the folder of that name may belong to one that looked so before.
QString BoardHistory::freeFolder(const QList<Named> &all, const QString &serial)
{
    const QString plain = plainName(serial);
    QString free = plain;
    const auto isTaken = [&] {
        return std::any_of(all.begin(), all.end(),
                           [&free](const Named &board) { return board.folder == free; });
    };
    for (int n = 2; isTaken(); ++n)
        free = u"%1-%2"_s.arg(plain).arg(n);
    return free;
}

QString BoardHistory::folderName(const QList<Named> &all, const QString &serial) const
{
    const Named *board = serial.isEmpty() ? nullptr : find(all, serial);
    return board ? board->folder : freeFolder(all, serial);
}

QString BoardHistory::folder(const QString &serial) const
{
    return m_root + u'/' + folderName(named(), serial);
}

BoardHistory::Acquaintance BoardHistory::acquaintance(const BoardIdentity &identity) const
{
    if (identity.isNumbered())
        return Acquaintance::Numbered;
    const QList<Named> all = named();
    if (find(all, identity.serial))
        return Acquaintance::Named;
    const bool alike = std::any_of(all.begin(), all.end(),
                                   [&identity](const Named &board) { return board.look == identity.serial; });
    return alike ? Acquaintance::Ambiguous : Acquaintance::Unnamed;
}

BoardHistory::Acquaintance BoardHistory::meet(const BoardIdentity &identity) const
{
    QList<Named> all = named();
    bool changed = false;
    for (Named &board : all) {
        if (board.before != identity.serial)
            continue;
        board.before.clear();
        changed = true;
    }
    if (changed)
        std::ignore = save(all);
    return acquaintance(identity);
}

QStringList BoardHistory::names(const BoardIdentity &identity) const
{
    QStringList alike;
    QStringList others;
    for (const Named &board : named()) {
        if (board.family == identity.family)
            (board.look == identity.serial ? alike : others).append(board.name);
    }
    return alike + others;
}

QString BoardHistory::nameOf(const QString &serial) const
{
    const QList<Named> all = named();
    const Named *board = find(all, serial);
    return board ? board->name : QString();
}

Result<void> BoardHistory::choose(const BoardIdentity &identity, const QString &name)
{
    const QString wanted = name.simplified();
    if (identity.isNumbered())
        return failure(ErrorCode::InvalidArgument, u"this board has a serial number, which names it"_s);
    if (wanted.isEmpty())
        return failure(ErrorCode::InvalidArgument, u"a board without a serial number needs a name"_s);
    QList<Named> all = named();
    const auto known = std::find_if(all.begin(), all.end(), [&](const Named &board) {
        return board.family == identity.family && board.name == wanted;
    });
    m_chosen = wanted;
    if (known == all.end()) {
        all.append({wanted, identity.family, freeFolder(all, identity.serial), identity.serial, {}});
    } else if (known->look != identity.serial) {
        known->look = identity.serial;
        known->before.clear();
    } else {
        return {};
    }
    return save(all);
}

Result<void> BoardHistory::follow(const BoardIdentity &identity, const QString &look,
                                  const QString &name) const
{
    QList<Named> all = named();
    if (const Named *found = find(all, identity.serial)) {
        Named &board = all[found - all.constData()];
        board.look = look;
        board.before = identity.serial;
    } else {
        all.append({name, identity.family, folderName(all, identity.serial), look, identity.serial});
    }
    return save(all);
}
