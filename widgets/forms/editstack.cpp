// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/forms/editstack.h"

#include "widgets/models/parametermodel.h"

#include <QElapsedTimer>
#include <QUndoCommand>

#include <tuple>

namespace {

constexpr qint64 kMergeMs = 1000;

class ValueEdit final : public QUndoCommand
{
public:
    ValueEdit(ConfigurationModel &configuration, const ParameterSpec &spec, int profile, int raw)
        : m_configuration(configuration), m_key(spec.key), m_profile(profile),
          m_old(configuration.value(spec, profile).value_or(raw)), m_new(raw)
    {
        setText(parameterLabel(spec));
        m_age.start();
    }

    void undo() override { set(m_old); }
    void redo() override { set(m_new); }
    [[nodiscard]] int id() const override { return 1; }

    bool mergeWith(const QUndoCommand *other) override
    {
        const auto *next = static_cast<const ValueEdit *>(other);
        if (next->m_key != m_key || next->m_profile != m_profile || m_age.elapsed() > kMergeMs)
            return false;
        m_new = next->m_new;
        m_age.restart();
        setObsolete(m_new == m_old);
        return true;
    }

private:
    void set(int raw)
    {
        // By key: after reconnecting, the same parameter is another object.
        if (const ParameterSpec *spec = m_configuration.edited().parameters().find(m_key))
            std::ignore = m_configuration.setValue(*spec, m_profile, raw);
    }

    ConfigurationModel &m_configuration;
    QString m_key;
    int m_profile;
    int m_old;
    int m_new;
    QElapsedTimer m_age;
};

class RenameEdit final : public QUndoCommand
{
public:
    RenameEdit(ConfigurationModel &configuration, int profile, const QString &name)
        : m_configuration(configuration), m_profile(profile),
          m_old(configuration.edited().profileNames().value(profile)), m_new(name)
    {
        setText(QObject::tr("Profile name"));
    }
    void undo() override { m_configuration.setProfileName(m_profile, m_old); }
    void redo() override { m_configuration.setProfileName(m_profile, m_new); }

private:
    ConfigurationModel &m_configuration;
    int m_profile;
    QString m_old;
    QString m_new;
};

} // namespace

EditStack::EditStack(ConfigurationModel &configuration, QObject *parent)
    : QObject(parent)
    , m_configuration(configuration)
{
}

bool EditStack::edit(int parameter, int profile, int raw)
{
    const ParameterSpec &spec = m_configuration.edited().parameters().at(parameter);
    const auto now = m_configuration.value(spec, profile);
    if (!now || !spec.isInRange(raw) || spec.row->state)
        return false;
    if (*now != raw)
        m_stack.push(new ValueEdit(m_configuration, spec, profile, raw));
    return true;
}

void EditStack::rename(int profile, const QString &name)
{
    if (m_configuration.edited().profileNames().value(profile) != name)
        m_stack.push(new RenameEdit(m_configuration, profile, name));
}

void EditStack::discardAll()
{
    const auto changes = m_configuration.changes();
    if (changes.empty() && !m_configuration.namesChanged())
        return;
    m_stack.beginMacro(tr("Discard all changes"));
    for (const ParameterChange &change : changes)
        edit(change.spec->id, change.profile, change.from);
    for (int profile = 0; profile < m_configuration.board().identity().profileCount; ++profile)
        rename(profile, m_configuration.board().profileNames().value(profile));
    m_stack.endMacro();
}
