// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/forms/editstack.h"

#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"

#include <QElapsedTimer>
#include <QJsonArray>
#include <QUndoCommand>

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
    [[nodiscard]] EditPlace place() const override { return {EditPlace::Kind::Value, m_key, m_profile, 0}; }

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
    [[nodiscard]] EditPlace place() const override { return {EditPlace::Kind::Name, {}, m_profile, 0}; }

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
        return {EditPlace::Kind::Data, {}, m_key.profile, m_key.block};
    }

private:
    ConfigurationModel &m_configuration;
    BlockKey m_key;
    QByteArray m_old;
    QByteArray m_new;
};

}  // namespace

EditStack::EditStack(ConfigurationModel &configuration, QObject *parent)
    : QObject(parent)
    , m_configuration(configuration)
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
    if (now != name)
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
    return spec.accepts(raw) || sameValue(m_configuration.boardValue(spec, profile), raw);
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
    return {{u"steps"_s, steps}, {u"done"_s, m_stack.index()}};
}

bool EditStack::restore(const QJsonObject &steps)
{
    m_stack.clear();
    const QJsonArray list = steps.value(u"steps"_s).toArray();
    int undone = int(list.size()) - steps.value(u"done"_s).toInt();
    for (const auto &step : list) {
        m_stack.beginMacro(step.toObject().value(u"text"_s).toString());
        for (const auto &value : step.toObject().value(u"edits"_s).toArray())
            restoreEdit(value.toObject());
        m_stack.endMacro();
    }
    for (; undone > 0; --undone)
        m_stack.undo();
    return m_configuration.changeCount() > 0 || m_stack.canRedo();
}

void EditStack::restoreEdit(const QJsonObject &edit)
{
    const int profile = edit.value(u"profile"_s).toInt(-1);
    if (profile < 0 || profile >= m_configuration.board().identity().profileCount)
        return;
    if (edit.contains(u"toName"_s)) {
        m_stack.push(new RenameEdit(m_configuration, profile, edit.value(u"fromName"_s).toString(),
                                    edit.value(u"toName"_s).toString()));
        return;
    }
    if (edit.contains(u"toData"_s)) {
        const BlockKey key{profile, edit.value(u"block"_s).toInt(-1)};
        const BlockSpec *block = m_configuration.edited().parameters().block(key.block);
        const auto bytes = [&edit](const QString &name) {
            return QByteArray::fromHex(edit.value(name).toString().toLatin1());
        };
        const QByteArray from = bytes(u"fromData"_s);
        const QByteArray to = bytes(u"toData"_s);
        if (block && block->isData() && m_configuration.edited().blocks().contains(key)
            && block->holds(to.size()) && block->holds(from.size()))
            m_stack.push(new DataEdit(m_configuration, key, tableText(block->data), from, to));
        return;
    }
    const ParameterSpec *spec = m_configuration.edited().parameters().find(edit.value(u"key"_s).toString());
    const double to = edit.value(u"to"_s).toDouble(kNoNumber);
    const double from = edit.value(u"from"_s).toDouble(kNoNumber);
    if (spec && !spec->row->state && canHold(*spec, profile, to) && m_configuration.value(*spec, profile))
        m_stack.push(new ValueEdit(m_configuration, *spec, profile, from, to));
}
