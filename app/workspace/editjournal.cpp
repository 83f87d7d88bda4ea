// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/editjournal.h"

#include "protocol/base/filefault.h"

#include <QCryptographicHash>
#include <QFileInfo>
#include <QJsonArray>

#include <algorithm>
#include <tuple>

using namespace Qt::StringLiterals;

namespace {

// Long enough to make one write of one drag of a slider, short enough to lose next to nothing in a crash.
constexpr int kDelayMs = 150;
const QString kFileSerial = u"file-"_s;
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Configuration withOwnSerial(Configuration file, const QString &path)
{
    const QByteArray place = QFileInfo(path).absoluteFilePath().toUtf8();
    if (file.identity().serial.isEmpty())
        file.setSerial(kFileSerial
                       + QString::fromLatin1(
                           QCryptographicHash::hash(place, QCryptographicHash::Sha1).toHex().left(16)));
    return file;
}

Configuration withoutOwnSerial(Configuration file)
{
    if (file.identity().serial.startsWith(kFileSerial))
        file.setSerial({});
    return file;
}

EditJournal::EditJournal(ConfigurationModel &configuration, EditStack &edits, const BoardHistory &history,
                         QObject *parent)
    : QObject(parent)
    , m_configuration(configuration)
    , m_edits(edits)
    , m_history(history)
{
    m_timer.setSingleShot(true);
    m_timer.setInterval(kDelayMs);
    connect(&m_timer, &QTimer::timeout, this, &EditJournal::write);
    connect(&configuration, &ConfigurationModel::boardReset, this, &EditJournal::onBoard);
    connect(&configuration, &ConfigurationModel::changeCountChanged, &m_timer, qOverload<>(&QTimer::start));
    connect(&m_drafts, &Drafts::changed, &m_timer, qOverload<>(&QTimer::start));
    connect(&edits.refused(), &RefusedTexts::changed, &m_timer, qOverload<>(&QTimer::start));
    connect(&edits.undoStack(), &QUndoStack::indexChanged, &m_timer, qOverload<>(&QTimer::start));
}

EditJournal::~EditJournal()
{
    flush();
}

void EditJournal::onBoard()
{
    const QString serial = m_configuration.board().identity().serial;
    if (serial == m_serial) {
        if (m_isAwaited && m_leftover && !leftoverWaits())
            tellLeftover();
        return;
    }
    if (!m_serial.isEmpty()) {  // texts of the board before stay in its journal
        m_drafts.clear();
        m_edits.refused().clear();
        m_timer.stop();
    }
    m_serial = serial;
    m_hasFile = false;
    m_isTold = false;
    if (std::exchange(m_leftover, std::nullopt))
        emit leftoverGone();
    const auto left = m_history.unsaved(serial);
    if (left && !left->isEmpty())
        m_leftover = *left;
    if (m_leftover && !leftoverWaits()) {  // what was written, or is so already, is no leftover
        const QJsonObject open = m_edits.opened(*m_leftover);
        m_leftover->insert(u"steps"_s, open.value(u"steps"_s));
        m_leftover->insert(u"done"_s, open.value(u"done"_s));
        if (leftSteps() + leftTexts() == 0) {
            m_leftover.reset();
            m_history.dropUnsaved(serial);
        }
    }
    if (!left && left.error().file->problem != FileProblem::Missing)
        emit unreadable(left.error(), m_history.setAsideUnsaved(serial));
    if (m_leftover)
        tellLeftover();
}

void EditJournal::tellLeftover()
{
    m_isAwaited = false;
    m_isTold = true;
    emit leftoverFound(leftSteps(), leftTexts());
}

int EditJournal::leftSteps() const
{
    return m_leftover->value(u"done"_s).toInt();
}

int EditJournal::leftTexts() const
{
    return int(m_leftover->value(u"drafts"_s).toObject().size()
               + m_leftover->value(u"refused"_s).toArray().size());
}

void EditJournal::remind()
{
    if (!std::exchange(m_isTold, false) && m_leftover)
        tellLeftover();
    m_isTold = false;
}

EditStack::Restored EditJournal::restoreLeftover()
{
    m_isAwaited = leftoverWaits();
    if (!m_leftover || m_isAwaited)
        return {};
    const QJsonObject steps = *std::exchange(m_leftover, std::nullopt);
    m_hasFile = true;
    EditStack::Restored restored = m_edits.restore(steps);
    const QJsonObject texts = steps.value(u"drafts"_s).toObject();
    m_drafts.restore(texts);
    m_edits.refused().restore(steps.value(u"refused"_s).toArray());
    restored.any = restored.any || !texts.isEmpty() || m_edits.refused().count() > 0;
    return restored;
}

void EditJournal::dropLeftover()
{
    m_leftover.reset();
    m_history.dropUnsaved(m_serial);
}

void EditJournal::flush()
{
    if (m_timer.isActive())
        write();
}

void EditJournal::moveWith(const std::function<void()> &change)
{
    flush();
    if (std::exchange(m_hasFile, false) && !m_leftover)
        m_history.dropUnsaved(m_serial);
    if (std::exchange(m_leftover, std::nullopt))
        emit leftoverGone();
    m_serial.clear();
    change();
    if (m_configuration.isEmpty())
        return;
    onBoard();
    m_timer.start();
}

// New edits replace those of an earlier run that the operator has not decided about; these are kept as a
// snapshot.
void EditJournal::keepUndecided()
{
    if (leftoverWaits()) {
        m_leftover.reset();
        emit leftoverGone();
        emit setAside(m_history.setAsideUnsaved(m_serial));
        return;
    }
    const auto leftover = std::exchange(m_leftover, std::nullopt);
    if (!leftover)
        return;
    emit leftoverGone();
    m_drafts.restore(leftover->value(u"drafts"_s).toObject());  // what is typed now goes before
    m_edits.refused().restore(leftover->value(u"refused"_s).toArray());
    if (leftover->value(u"steps"_s).toArray().isEmpty())
        return;
    Configuration kept = m_configuration.board();
    const QJsonArray steps = leftover->value(u"steps"_s).toArray();
    for (int i = 0; i < std::min<int>(leftover->value(u"done"_s).toInt(), int(steps.size())); ++i) {
        for (const QJsonValue value : steps[i].toObject().value(u"edits"_s).toArray()) {
            const QJsonObject edit = value.toObject();
            const ParameterSpec *spec = kept.parameters().find(edit.value(u"key"_s).toString());
            const int profile = edit.value(u"profile"_s).toInt(-1);
            const BlockKey block{profile, edit.value(u"block"_s).toInt(-1)};
            const BlockSpec *data = kept.parameters().block(block.block);
            const QByteArray bytes = QByteArray::fromHex(edit.value(u"toData"_s).toString().toLatin1());
            if (data && data->isData() && data->holds(bytes.size()) && kept.blocks().contains(block))
                kept.setBlock(block, bytes);
            if (spec && profile >= 0 && profile < kept.identity().profileCount)
                std::ignore = kept.setRaw(*spec, profile, edit.value(u"to"_s).toDouble(kNoNumber));
        }
    }
    if (const auto saved = m_history.save(kept, u"unwritten edits of an earlier run"_s); saved)
        emit keptAside(*saved);
    else
        emit setAside(m_history.setAsideUnsaved(m_serial));
}

void EditJournal::write()
{
    m_timer.stop();
    if (m_configuration.isEmpty())
        return;
    if (m_configuration.changeCount() == 0 && m_drafts.count() == 0 && m_edits.refused().count() == 0) {
        // Edits left by an earlier run are kept until the operator has decided about them.
        if (m_hasFile && !m_leftover)
            m_history.dropUnsaved(m_serial);
        m_hasFile = false;
        return;
    }
    keepUndecided();
    m_hasFile = true;
    QJsonObject unsaved = m_edits.toJson();
    unsaved.insert(u"drafts"_s, m_drafts.toJson());
    unsaved.insert(u"refused"_s, m_edits.refused().toJson());
    if (const auto saved = m_history.saveUnsaved(m_configuration.board(), unsaved); !saved)
        emit failed(saved.error());
    else
        emit written();
}
