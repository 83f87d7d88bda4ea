// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/editguide.h"

#include "app/pages/setup/documentspage.h"
#include "app/pages/setup/parameterspage.h"
#include "app/pages/setup/profilespage.h"
#include "app/pages/setup/scriptspage.h"
#include "widgets/forms/parameterbox.h"
#include "widgets/models/parametermodel.h"
#include "widgets/views/scripteditor.h"

#include <utility>

using namespace Qt::StringLiterals;

namespace {

constexpr int kShownChars = 40;  // of what was typed, in a message about it

}  // namespace

EditGuide::EditGuide(Workspace &workspace, ShowPage showPage, QObject *parent)
    : QObject(parent)
    , m_workspace(workspace)
    , m_showPage(std::move(showPage))
{
    connect(&workspace.edits(), &EditStack::acted, this, &EditGuide::show);
    connect(&workspace, &Workspace::textWanted, this, [this](const TextPlace &place) {
        if (auto *documents = qobject_cast<DocumentsPage *>(m_showPage(u"documents"_s)))
            documents->showText(place.block, place.line);
    });
    connect(&workspace.edits().refused(), &RefusedTexts::changed, this, &EditGuide::withdrawWhatIsMended);
}

void EditGuide::show(const EditPlace &place)
{
    ConfigurationModel &model = m_workspace.configuration();
    if (model.isEmpty())
        return;
    const ParameterSet &set = std::as_const(model).edited().parameters();
    if (place.kind == EditPlace::Kind::Name) {
        if (auto *profiles = qobject_cast<ProfilesPage *>(m_showPage(u"profiles"_s)))
            profiles->showName(place.profile);
    } else if (place.kind == EditPlace::Kind::Data) {
        showData(place);
    } else if (const ParameterSpec *spec = set.find(place.key)) {
        // Only shown: which profile the board uses is not undone with an edit.
        if (spec->row->scope == Scope::Profile)
            model.setShownProfile(place.profile);
        if (auto *parameters = qobject_cast<ParametersPage *>(m_showPage(u"parameters"_s)))
            parameters->reveal(*spec);
    }
}

// All scripts lie in one block: the first that differs is where the step acted.
void EditGuide::showData(const EditPlace &place)
{
    const Configuration &edited = std::as_const(m_workspace.configuration()).edited();
    const BlockSpec *block = edited.parameters().block(place.block);
    if (block && block->isText()) {
        if (auto *documents = qobject_cast<DocumentsPage *>(m_showPage(u"documents"_s)))
            documents->showText(place.block);
        return;
    }
    auto *scripts = qobject_cast<ScriptsPage *>(m_showPage(u"scripts"_s));
    const Family *family = m_workspace.family();
    if (!scripts || !family || !family->scripts)
        return;
    const auto with = [&](const QByteArray &bytes) {
        Configuration configuration = edited;
        configuration.setBlock({place.profile, place.block}, bytes);
        return configuration;
    };
    const Configuration before = with(place.before);
    const Configuration after = with(place.after);
    for (int script = 0; script < family->scripts->count(); ++script) {
        if (family->scripts->text(before, script) != family->scripts->text(after, script)) {
            scripts->showScript(script);
            break;
        }
    }
    scripts->editor()->setFocus();
}

bool EditGuide::showRefused()
{
    const RefusedTexts &refused = m_workspace.edits().refused();
    const auto place = refused.first();
    const ConfigurationModel &model = m_workspace.configuration();
    const ParameterSpec *spec = place ? model.edited().parameters().find(place->first) : nullptr;
    if (!spec)
        return false;
    const QString text = refused.text(*spec, place->second).value_or(QString());
    show({EditPlace::Kind::Value, place->first, place->second, 0, {}, {}});
    m_told = text;
    m_toldOf = *place;
    const bool isOfProfile = spec->row->scope == Scope::Profile && m_workspace.profileCount() > 1;
    const QString name = isOfProfile
        ? u"%1 (%2)"_s.arg(parameterLabel(*spec), profileLabel(model.edited(), place->second))
        : parameterLabel(*spec);
    m_workspace.notifications().notify(
        tr("%1: “%2” is no value of it (%3). Change it, or press Esc in its field; then review.")
            .arg(name, text.left(kShownChars), ParameterBox(*spec).rangeSentence(text)),
        Notice::Attention, Concern::Entry);
    return true;
}

// In the words of its page, where it is shown as well.
bool EditGuide::showContradiction()
{
    const ConfigurationModel &model = std::as_const(m_workspace).configuration();
    const auto checked = model.edited().checkRules(model.board());
    if (checked)
        return false;
    if (const auto place = checked.error().place) {
        m_workspace.notifications().report(ErrorText{
            (place->line > 0 ? tr("The text has a mistake in line %1, so it is not written.").arg(place->line)
                             : tr("The text has a mistake, so it is not written.")),
            tr("Nothing was changed."),
            tr("Its page shows the place: mend it there, then try again."),
            {},
            {}});
        emit m_workspace.textWanted(*place);
        return true;
    }
    for (const ParameterSpec &spec : model.edited().parameters().all()) {
        for (int profile = 0; profile < model.edited().identity().profileCount; ++profile) {
            const bool isNew = !sameValue(model.boardValue(spec, profile), model.value(spec, profile));
            const QString text = isNew ? contradictionText(model, spec, profile) : QString();
            if (text.isEmpty())
                continue;
            show({EditPlace::Kind::Value, spec.key, profile, 0, {}, {}});
            m_workspace.notifications().report(
                ErrorText{u"%1: %2"_s.arg(parameterLabel(spec), text),
                          tr("Nothing was changed."),
                          tr("Change one of the two so that both can hold, then write again."),
                          {},
                          {}});
            return true;
        }
    }
    m_workspace.notifications().report(checked.error());
    return true;
}

void EditGuide::withdrawWhatIsMended()
{
    const ConfigurationModel &model = std::as_const(m_workspace).configuration();
    const ParameterSpec *spec = model.isEmpty() ? nullptr : model.edited().parameters().find(m_toldOf.first);
    if (m_told && (!spec || m_workspace.edits().refused().text(*spec, m_toldOf.second) != m_told)) {
        m_told.reset();
        m_workspace.notifications().settle(Concern::Entry);
    }
}
