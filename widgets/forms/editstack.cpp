// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/forms/editstack.h"

#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"

#include <QElapsedTimer>
#include <QHash>
#include <QJsonArray>
#include <QSet>
#include <QUndoCommand>

#include <algorithm>
#include <tuple>

using namespace Qt::StringLiterals;

namespace {

constexpr qint64 kMergeMs = 1000;
constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

/// A step that can be kept in a file.
class Edit : public QUndoCommand
{
public:
    [[nodiscard]] virtual QJsonObject toJson() const = 0;
    [[nodiscard]] virtual EditPlace place() const = 0;
};

EditPlace placeOf(const QUndoCommand &step)
{
    if (step.childCount() > 0)
        return placeOf(*step.child(0));
    const auto *edit = dynamic_cast<const Edit *>(&step);
    return edit ? edit->place() : EditPlace{};
}

class ValueEdit final : public Edit
{
public:
    ValueEdit(ConfigurationModel &configuration, const ParameterSpec &spec, int profile, double from,
              double to)
        : m_configuration(configuration)
        , m_key(spec.key)
        , m_profile(profile)
        , m_old(from)
        , m_new(to)
    {
        setText(parameterLabel(spec));
        m_age.start();
    }

    // What was there is put back even if nobody may set it: a write may have replaced it on the board.
    void undo() override
    {
        if (const ParameterSpec *spec = find())
            std::ignore = m_configuration.restoreValue(*spec, m_profile, m_old);
    }
    void redo() override
    {
        if (const ParameterSpec *spec = find())
            std::ignore = m_configuration.setValue(*spec, m_profile, m_new);
    }
    [[nodiscard]] int id() const override { return 1; }

    bool mergeWith(const QUndoCommand *other) override
    {
        const auto *next = static_cast<const ValueEdit *>(other);
        if (next->m_key != m_key || next->m_profile != m_profile || m_age.elapsed() > kMergeMs)
            return false;
        m_new = next->m_new;
        m_age.restart();
        setObsolete(sameValue(m_new, m_old));
        return true;
    }

    [[nodiscard]] QJsonObject toJson() const override
    {
        // NaN and infinity become null.
        return {{u"key"_s, m_key}, {u"profile"_s, m_profile}, {u"from"_s, m_old}, {u"to"_s, m_new}};
    }
    [[nodiscard]] EditPlace place() const override
    {
        return {EditPlace::Kind::Value, m_key, m_profile, 0, {}, {}};
    }

private:
    // By key: after reconnecting, the same parameter is another object.
    [[nodiscard]] const ParameterSpec *find() const
    {
        return m_configuration.edited().parameters().find(m_key);
    }

    ConfigurationModel &m_configuration;
    QString m_key;
    int m_profile;
    double m_old;
    double m_new;
    QElapsedTimer m_age;
};

class RenameEdit final : public Edit
{
public:
    RenameEdit(ConfigurationModel &configuration, int profile, const QString &from, const QString &to)
        : m_configuration(configuration)
        , m_profile(profile)
        , m_old(from)
        , m_new(to)
    {
        setText(EditStack::tr("Profile name"));
    }
    void undo() override { m_configuration.setProfileName(m_profile, m_old); }
    void redo() override { m_configuration.setProfileName(m_profile, m_new); }
    [[nodiscard]] QJsonObject toJson() const override
    {
        return {{u"profile"_s, m_profile}, {u"fromName"_s, m_old}, {u"toName"_s, m_new}};
    }
    [[nodiscard]] EditPlace place() const override
    {
        return {EditPlace::Kind::Name, {}, m_profile, 0, {}, {}};
    }

private:
    ConfigurationModel &m_configuration;
    int m_profile;
    QString m_old;
    QString m_new;
};

class DataEdit final : public Edit
{
public:
    DataEdit(ConfigurationModel &configuration, BlockKey key, const QString &name, const QByteArray &from,
             const QByteArray &to)
        : m_configuration(configuration)
        , m_key(key)
        , m_old(from)
        , m_new(to)
    {
        setText(name);
    }
    void undo() override { std::ignore = m_configuration.setData(m_key, m_old); }
    void redo() override { std::ignore = m_configuration.setData(m_key, m_new); }
    [[nodiscard]] QJsonObject toJson() const override
    {
        return {{u"profile"_s, m_key.profile},
                {u"block"_s, m_key.block},
                {u"fromData"_s, QString::fromLatin1(m_old.toHex())},
                {u"toData"_s, QString::fromLatin1(m_new.toHex())}};
    }
    [[nodiscard]] EditPlace place() const override
    {
        return {EditPlace::Kind::Data, {}, m_key.profile, m_key.block, m_old, m_new};
    }

private:
    ConfigurationModel &m_configuration;
    BlockKey m_key;
    QByteArray m_old;
    QByteArray m_new;
};

// Edits as they stand in a file.

QString placeName(const QJsonObject &edit)
{
    const int profile = edit.value(u"profile"_s).toInt(-1);
    if (edit.contains(u"toName"_s))
        return u"name/%1"_s.arg(profile);
    if (edit.contains(u"toData"_s))
        return u"data/%1/%2"_s.arg(edit.value(u"block"_s).toInt(-1)).arg(profile);
    return u"value/%1/%2"_s.arg(edit.value(u"key"_s).toString()).arg(profile);
}

QString valueName(const QJsonObject &edit, const QString &which)
{
    return which
        + (edit.contains(u"toName"_s)       ? u"Name"_s
               : edit.contains(u"toData"_s) ? u"Data"_s
                                            : QString());
}

QJsonValue wantedOf(const QJsonObject &edit)
{
    return edit.value(valueName(edit, u"to"_s));
}

QJsonValue beforeOf(const QJsonObject &edit)
{
    return edit.value(valueName(edit, u"from"_s));
}

QJsonObject withValues(QJsonObject edit, const QJsonValue &from, const QJsonValue &to)
{
    edit.insert(valueName(edit, u"from"_s), from);
    edit.insert(valueName(edit, u"to"_s), to);
    return edit;
}

/// What is at its place; undefined if there is no such place.
QJsonValue heldIn(const Configuration &configuration, const QJsonObject &edit)
{
    const int profile = edit.value(u"profile"_s).toInt(-1);
    if (profile < 0 || profile >= configuration.identity().profileCount)
        return QJsonValue::Undefined;
    if (edit.contains(u"toName"_s))
        return configuration.profileNames().value(profile);
    if (edit.contains(u"toData"_s)) {
        const BlockKey key{profile, edit.value(u"block"_s).toInt(-1)};
        return configuration.blocks().contains(key)
            ? QJsonValue(QString::fromLatin1(configuration.block(key).toHex()))
            : QJsonValue::Undefined;
    }
    const ParameterSpec *spec = configuration.parameters().find(edit.value(u"key"_s).toString());
    const auto raw = spec ? configuration.raw(*spec, profile) : std::nullopt;
    return raw ? QJsonValue(*raw) : QJsonValue::Undefined;
}

// NaN and infinity are null in a file.
bool isSame(const QJsonValue &a, const QJsonValue &b)
{
    const auto isNumber = [](const QJsonValue &value) { return value.isDouble() || value.isNull(); };
    if (isNumber(a) && isNumber(b))
        return sameValue(a.toDouble(kNoNumber), b.toDouble(kNoNumber));
    return a == b;
}

}  // namespace

EditStack::EditStack(ConfigurationModel &configuration, QObject *parent)
    : QObject(parent)
    , m_configuration(configuration)
    , m_refused(configuration)
{
}

bool EditStack::edit(int parameter, int profile, double raw)
{
    const ParameterSpec &spec = m_configuration.edited().parameters().at(parameter);
    const auto now = m_configuration.value(spec, profile);
    const double wanted = spec.nearest(raw);
    if (!now || !canHold(spec, profile, wanted) || spec.row->state)
        return false;
    if (!sameValue(*now, wanted))
        m_stack.push(new ValueEdit(m_configuration, spec, profile, *now, wanted));
    return true;
}

void EditStack::rename(int profile, const QString &name)
{
    const QString now = m_configuration.edited().profileNames().value(profile);
    const bool isBoards = name == m_configuration.board().profileNames().value(profile);
    if (now != name && (m_configuration.canRename() || isBoards))
        m_stack.push(new RenameEdit(m_configuration, profile, now, name));
}

void EditStack::editData(BlockKey key, const QByteArray &bytes)
{
    const QByteArray now = m_configuration.edited().block(key);
    const BlockSpec *spec = m_configuration.edited().parameters().block(key.block);
    if (spec && spec->isData() && spec->holds(bytes.size()) && now != bytes)
        m_stack.push(new DataEdit(m_configuration, key, tableText(spec->data), now, bytes));
}

void EditStack::undo()
{
    if (!m_stack.canUndo())
        return;
    const EditPlace place = placeOf(*m_stack.command(m_stack.index() - 1));
    m_stack.undo();
    emit acted(place);
}

void EditStack::redo()
{
    if (!m_stack.canRedo())
        return;
    const EditPlace place = placeOf(*m_stack.command(m_stack.index()));
    m_stack.redo();
    emit acted(place);
}

void EditStack::discardAll()
{
    m_refused.clear();
    apply(m_configuration.board(), tr("Discard all changes"));
}

void EditStack::apply(const Configuration &wanted, const QString &text)
{
    const auto changes = m_configuration.edited().changesTo(wanted);
    const auto data = m_configuration.edited().dataChangesTo(wanted);
    if (changes.empty() && data.empty() && wanted.profileNames() == m_configuration.edited().profileNames())
        return;
    m_stack.beginMacro(text);
    for (const ParameterChange &change : changes)
        push(change);
    for (const DataChange &change : data)
        editData(change.key, change.to);
    for (int profile = 0; profile < wanted.identity().profileCount; ++profile)
        rename(profile, wanted.profileNames().value(profile));
    m_stack.endMacro();
}

bool EditStack::canHold(const ParameterSpec &spec, int profile, double raw) const
{
    const auto held = m_configuration.boardValue(spec, profile);
    return spec.accepts(raw, held) || sameValue(held, raw);
}

// What nobody may set, only the board's own value brings back.
void EditStack::push(const ParameterChange &change)
{
    if (!canHold(*change.spec, change.profile, change.to))
        return;
    m_stack.push(new ValueEdit(m_configuration, *change.spec, change.profile, change.from, change.to));
}

QStringList EditStack::copyProfile(int from, int to)
{
    return applyProfile(m_configuration.edited(), from, to,
                        tr("Copy profile %1 onto profile %2").arg(from + 1).arg(to + 1));
}

QStringList EditStack::applyProfile(const Configuration &wanted, int from, int to, const QString &text)
{
    std::vector<ParameterChange> changes;
    QStringList leftOut;
    for (const ParameterSpec &spec : m_configuration.edited().parameters().all()) {
        if (spec.row->scope != Scope::Profile || spec.row->state)
            continue;
        const auto now = m_configuration.value(spec, to);
        const auto then = wanted.raw(wanted.parameters().at(spec.id), from);
        if (!now || !then || sameValue(*now, *then))
            continue;
        if (canHold(spec, to, *then))
            changes.push_back({&spec, to, *now, *then});
        else
            leftOut.append(
                withNumbers(u"%1 = %2, allowed %3"_s.arg(spec.key, spec.format(*then), spec.allowedText())));
    }
    if (changes.empty())
        return leftOut;
    m_stack.beginMacro(text);
    for (const ParameterChange &change : changes)
        push(change);
    m_stack.endMacro();
    return leftOut;
}

QJsonObject EditStack::toJson() const
{
    QJsonArray steps;
    for (int i = 0; i < m_stack.count(); ++i) {
        const QUndoCommand *command = m_stack.command(i);
        QJsonArray edits;
        const auto append = [&edits](const QUndoCommand *one) {
            if (const auto *edit = dynamic_cast<const Edit *>(one))
                edits.append(edit->toJson());
        };
        append(command);
        for (int child = 0; child < command->childCount(); ++child)
            append(command->child(child));
        steps.append(QJsonObject{{u"text"_s, command->text()}, {u"edits"_s, edits}});
    }
    return openSteps({{u"steps"_s, steps}, {u"done"_s, m_stack.index()}}, &m_configuration.edited());
}

QJsonObject EditStack::opened(const QJsonObject &steps) const
{
    return openSteps(steps, nullptr);
}

// From the newest step back to where the board is: what lies before is written, or came to nothing.
QJsonObject EditStack::openSteps(const QJsonObject &steps, const Configuration *edited) const
{
    const Configuration &board = m_configuration.board();
    const QJsonArray all = steps.value(u"steps"_s).toArray();
    const int done = std::min(steps.value(u"done"_s).toInt(), int(all.size()));
    QHash<QString, QJsonValue> reached;  // by place: where the edits that are kept begin
    QHash<QString, QJsonObject> samples;
    QSet<QString> closed;
    const auto meet = [&](const QJsonObject &edit) {
        const QString place = placeName(edit);
        if (reached.contains(place))
            return place;
        reached.insert(place, edited ? heldIn(*edited, edit) : wantedOf(edit));
        samples.insert(place, edit);
        if (isSame(reached.value(place), heldIn(board, edit)))
            closed.insert(place);
        return place;
    };
    QJsonArray open;
    for (int i = done - 1; i >= 0; --i) {
        const QJsonArray edits = all[i].toObject().value(u"edits"_s).toArray();
        QJsonArray kept;
        for (qsizetype k = edits.size() - 1; k >= 0; --k) {
            const QJsonObject edit = edits[k].toObject();
            const QString place = meet(edit);
            if (closed.contains(place))
                continue;
            if (!isSame(wantedOf(edit), reached.value(place))) {
                closed.insert(place);
                continue;
            }
            kept.prepend(edit);
            reached.insert(place, beforeOf(edit));
            if (isSame(beforeOf(edit), heldIn(board, edit)))
                closed.insert(place);
        }
        if (!kept.isEmpty())
            open.prepend(QJsonObject{{u"text"_s, all[i].toObject().value(u"text"_s)}, {u"edits"_s, kept}});
    }
    for (int i = done; edited && i < all.size(); ++i) {
        for (const auto &edit : all[i].toObject().value(u"edits"_s).toArray())
            meet(edit.toObject());
    }
    // What no step explains: one that was written has been undone, or the board has changed beneath it.
    QJsonArray rest;
    for (auto it = reached.begin(); edited && it != reached.end(); ++it) {
        const QJsonObject &sample = samples[it.key()];
        const QJsonValue held = heldIn(board, sample);
        if (!held.isUndefined() && !isSame(held, it.value()))
            rest.append(withValues(sample, held, it.value()));
    }
    if (!rest.isEmpty())
        open.prepend(QJsonObject{{u"text"_s, tr("Unwritten changes")}, {u"edits"_s, rest}});
    const int count = int(open.size());
    for (int i = done; i < all.size(); ++i)
        open.append(all[i]);
    return {{u"steps"_s, open}, {u"done"_s, count}};
}

EditStack::Restored EditStack::restore(const QJsonObject &steps)
{
    m_stack.clear();
    Restored restored;
    const QJsonArray list = steps.value(u"steps"_s).toArray();
    int undone = int(list.size()) - steps.value(u"done"_s).toInt();
    for (const auto &step : list) {
        m_stack.beginMacro(step.toObject().value(u"text"_s).toString());
        for (const auto &value : step.toObject().value(u"edits"_s).toArray())
            restored.leftOut += restoreEdit(value.toObject()) ? 0 : 1;
        m_stack.endMacro();
    }
    for (; undone > 0; --undone)
        m_stack.undo();
    restored.any = m_configuration.changeCount() > 0 || m_stack.canRedo();
    return restored;
}

bool EditStack::concernsMissing(const QJsonObject &steps) const
{
    const Configuration &board = m_configuration.board();
    for (const auto &step : steps.value(u"steps"_s).toArray()) {
        for (const auto &value : step.toObject().value(u"edits"_s).toArray()) {
            const QJsonObject edit = value.toObject();
            const int profile = edit.value(u"profile"_s).toInt(-1);
            const ParameterSpec *spec = board.parameters().find(edit.value(u"key"_s).toString());
            const bool isMissing = edit.contains(u"toName"_s)
                ? board.findMissing({0, MissingPart::kProfileNames}) != nullptr
                : edit.contains(u"toData"_s)
                ? board.findMissing({profile, edit.value(u"block"_s).toInt(-1)}) != nullptr
                : spec && board.findMissing(*spec, profile);
            if (isMissing)
                return true;
        }
    }
    return false;
}

bool EditStack::restoreEdit(const QJsonObject &edit)
{
    const int profile = edit.value(u"profile"_s).toInt(-1);
    if (profile < 0 || profile >= m_configuration.board().identity().profileCount)
        return false;
    if (edit.contains(u"toName"_s)) {
        m_stack.push(new RenameEdit(m_configuration, profile,
                                    m_configuration.edited().profileNames().value(profile),
                                    edit.value(u"toName"_s).toString()));
        return true;
    }
    if (edit.contains(u"toData"_s)) {
        const BlockKey key{profile, edit.value(u"block"_s).toInt(-1)};
        const BlockSpec *block = m_configuration.edited().parameters().block(key.block);
        const QByteArray from = m_configuration.edited().block(key);
        const QByteArray to = QByteArray::fromHex(edit.value(u"toData"_s).toString().toLatin1());
        if (!block || !block->isData() || !m_configuration.edited().blocks().contains(key)
            || !block->holds(to.size()))
            return false;
        m_stack.push(new DataEdit(m_configuration, key, tableText(block->data), from, to));
        return true;
    }
    const ParameterSpec *spec = m_configuration.edited().parameters().find(edit.value(u"key"_s).toString());
    const double to = edit.value(u"to"_s).toDouble(kNoNumber);
    if (!spec || spec->row->state || !canHold(*spec, profile, to) || !m_configuration.value(*spec, profile))
        return false;
    // Undone, it becomes what is there now: the board may have been changed meanwhile.
    m_stack.push(new ValueEdit(m_configuration, *spec, profile, *m_configuration.value(*spec, profile), to));
    return true;
}
