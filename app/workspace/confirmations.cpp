// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/confirmations.h"

#include "widgets/models/parametermodel.h"

#include <algorithm>

using namespace Qt::StringLiterals;

Confirmations::Confirmations(Notifications &notifications)
    : m_notifications(notifications)
{
}

// The text of the button that proceeds states what is being confirmed.
QFuture<Confirmations::Outcome> Confirmations::ask(const ActionSpec &action, const QVariantMap &arguments,
                                                   std::function<QFuture<Outcome>()> perform)
{
    withdraw();
    auto question = std::make_shared<Promise>();
    question->start();
    m_questions.push_back(question);
    m_asked = question;
    const auto goOn = [this, question, perform = std::move(perform)] {
        if (m_asked != question)
            return;  // cancelled meanwhile
        m_asked.reset();
        perform().then(this, [this, question](const Outcome &outcome) { answer(question, outcome); });
    };
    QString label = tableText(action.label);
    for (const ArgumentSpec &argument : action.arguments) {
        if (const QVariant value = arguments.value(QLatin1String(argument.key)); value.isValid())
            label += u", %1 %2"_s.arg(tableText(argument.label), value.toString());
    }
    Offer asked;
    asked.topic = Topic::Action;
    asked.text = tr("“%1” has to be confirmed each time.").arg(label);
    asked.choices.append(
        {u"%1: %2"_s.arg(tableText(action.confirm), label), goOn, action.risk == ActionRisk::Destroys});
    asked.choices.append(
        {tr("Cancel"), [this, question] { answer(question, failure(ErrorCode::Cancelled)); }});
    m_notifications.ask(asked);
    return question->future();
}

void Confirmations::answer(const std::shared_ptr<Promise> &question, const Outcome &outcome)
{
    if (m_asked == question)
        m_asked.reset();
    if (std::erase(m_questions, question) == 0)
        return;
    question->addResult(outcome);
    question->finish();
}

void Confirmations::withdraw()
{
    m_notifications.withdrawOffer(Topic::Action);
    if (const auto question = std::exchange(m_asked, nullptr))
        answer(question, failure(ErrorCode::Cancelled));
}

void Confirmations::forget()
{
    withdraw();
    for (const auto &question : std::vector(m_questions))
        answer(question, failure(ErrorCode::Cancelled));
}
