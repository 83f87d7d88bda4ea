// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/editguide.h"

#include "app/pages/setup/parameterspage.h"
#include "app/pages/setup/profilespage.h"

#include <QTableView>

using namespace Qt::StringLiterals;

EditGuide::EditGuide(Workspace &workspace, ShowPage showPage, QObject *parent)
    : QObject(parent)
    , m_workspace(workspace)
    , m_showPage(std::move(showPage))
{
    connect(&workspace.edits(), &EditStack::acted, this, &EditGuide::show);
}

void EditGuide::show(const EditPlace &place)
{
    ConfigurationModel &model = m_workspace.configuration();
    if (model.isEmpty())
        return;
    const ParameterSet &set = std::as_const(model).edited().parameters();
    if (place.kind == EditPlace::Kind::Name) {
        if (auto *profiles = qobject_cast<ProfilesPage *>(m_showPage(u"profiles"_s)))
            profiles->table()->selectRow(place.profile);
    } else if (place.kind == EditPlace::Kind::Data) {
        const BlockSpec *block = set.block(place.block);
        m_showPage(block && block->isText() ? u"documents"_s : u"scripts"_s);
    } else if (const ParameterSpec *spec = set.find(place.key)) {
        // Only shown: which profile the board uses is not undone with an edit.
        if (spec->row->scope == Scope::Profile)
            model.setShownProfile(place.profile);
        if (auto *parameters = qobject_cast<ParametersPage *>(m_showPage(u"parameters"_s)))
            parameters->reveal(*spec);
    }
}
