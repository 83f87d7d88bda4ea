// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// What a search that was broken off has left, and the way back.
#include "app/families/simplebgc/autotunepage.h"
#include "widgets/models/parametermodel.h"

using namespace Qt::StringLiterals;

// A board does not tell what it has stored of what it uses, so what was in use before is the way back.
void AutoTunePage::tellLeft(const Configuration &board, Left left)
{
    QStringList told;
    for (auto it = m_before.constBegin(); it != m_before.constEnd(); ++it) {
        const ParameterSpec &spec = board.parameters().at(it.key());
        const auto now = board.raw(spec, board.activeProfile());
        if (now && !sameValue(*now, *it))
            told.append(u"%1 %2 → %3"_s.arg(parameterLabel(spec), parameterValueText(spec, *it),
                                            parameterValueText(spec, *now)));
    }
    if (told.isEmpty()) {
        m_before.clear();
        workspace().notifications().notify(
            left == Left::Searching
                ? tr("The search that was broken off has been stopped; the gains are those from before.")
                : tr("The board uses the gains from before the search again."),
            left == Left::Searching ? Notice::Done : Notice::Attention);
        return;
    }
    told.sort();
    m_mayBeStored = true;
    m_live.read();
    setState(State::Finished);
    if (left == Left::Found) {
        m_mayBeStored = false;
        m_text->setText(tr("The link ended before the new gains were accepted or reverted. The board uses "
                           "them still: %1. Accept them, or revert to the old ones.")
                            .arg(told.join(u", "_s)));
        return;
    }
    m_text->setText(
        tr("The search was broken off and has been stopped. The board uses other gains than before, "
           "and may have stored them: %1. Revert and store the old gains, or accept the new ones.")
            .arg(told.join(u", "_s)));
    workspace().notifications().report(
        ErrorText{tr("After the search that was broken off the board uses other gains."),
                  tr("It may have stored them; it does not tell."),
                  tr("Revert to the old gains on the page Auto-tune and store them, or accept the new ones."),
                  told.join(u", "_s)},
        Concern::Interrupted);
}

// What is stored is not known then, so that nothing would mark the gains as not stored.
void AutoTunePage::offerToStore()
{
    workspace().notifications().ask(
        {tr("The old gains are in use again. If the board has stored those that it tried, they come back at "
            "its "
            "next start."),
         {{tr("Store the old gains"), [this] { workspace().saveLive(*this); }}, {tr("Leave it so"), [] {}}}});
}
