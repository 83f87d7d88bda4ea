// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/confirmations.h"

#include "protocol/device/device.h"
#include "protocol/device/flight.h"
#include "protocol/telemetry/telemetrystore.h"
#include "widgets/models/parametermodel.h"

#include <QApplication>
#include <QFontMetrics>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

constexpr int kTextWidth = 360;  // of a path, which is cut in its middle

}  // namespace

Confirmations::Confirmations(DeviceClient &client, Notifications &notifications)
    : m_client(client)
    , m_notifications(notifications)
{
    connect(&client, &DeviceClient::statisticsChanged, this, &Confirmations::followBoard);
}

// What it does is said in words; the button says only that it is done.
QFuture<Confirmations::Outcome> Confirmations::ask(const ActionSpec &action, const QVariantMap &arguments,
                                                   std::function<QFuture<Outcome>()> perform)
{
    withdraw();
    auto promise = std::make_shared<Promise>();
    promise->start();
    m_questions.push_back(promise);
    m_asked = promise;
    m_action = action;
    const auto goOn = [this, promise, perform = std::move(perform)] {
        if (m_asked != promise)
            return;  // cancelled meanwhile
        m_asked.reset();
        perform().then(this, [this, promise](const Outcome &outcome) { answer(promise, outcome); });
    };
    const auto over = [this, promise] {
        if (m_asked == promise)
            answer(promise, failure(ErrorCode::Cancelled));
    };
    Question question;
    question.title = tableText(action.label);
    QString verb = question.title;
    QStringList said;
    for (const ArgumentSpec &argument : action.arguments) {
        const QVariant value = arguments.value(QLatin1String(argument.key));
        if (!value.isValid())
            continue;
        const QString text = value.toString();
        if (argument.kind != ArgumentKind::Text) {
            verb += verb == question.title ? u": "_s : u", "_s;
            verb += u"%1 %2"_s.arg(tableText(argument.label), text);
            continue;
        }
        const QFontMetrics metrics(QApplication::font());
        said.append(u"%1: %2"_s.arg(tableText(argument.label),
                                    metrics.elidedText(text, Qt::ElideMiddle, kTextWidth)));
        question.whole = text;
    }
    said.append(tableText(action.help));
    const FlyingMachine *machine = m_client.device() ? m_client.device()->flight() : nullptr;
    const char *doubt = machine ? machine->doubt(QLatin1String(action.key), arguments) : "";
    if (*doubt)
        said.append(tableText(doubt));
    if (action.silence > 0ms)
        said.append(tr("Nothing stops it meanwhile, neither “STOP MOTORS” nor F12: only taking its battery "
                       "away does."));
    said.append(tr("Whoever goes on confirms: “%1”.").arg(tableText(action.confirm)));
    question.text = said.join(u"\n\n"_s);
    const bool isRed = action.risk == ActionRisk::Moves || action.risk == ActionRisk::Destroys;
    question.answers = {{verb, goOn, isRed}};
    question.stay = tr("Do nothing");
    emit asked(question, over);
    return promise->future();
}

// Armed, or its motors driven, since it was asked.
void Confirmations::followBoard()
{
    const auto store = m_client.telemetry();
    if (!m_asked || !store)
        return;
    const bool isOtherwise
        = std::any_of(m_action.needs.begin(), m_action.needs.end(), [this, &store](Condition condition) {
              const int channel = channelOf(condition, m_client.roles());
              const double value = channel < 0 ? qQNaN() : store->latest(channel);
              return !std::isnan(value) && (value != 0) != (condition == Condition::Calibrated);
          });
    if (!isOtherwise)
        return;
    m_notifications.notify(tr("“%1” is not asked any more: the board is not as it has to be for that.")
                               .arg(tableText(m_action.label)),
                           Notice::Attention);
    withdraw();
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
    if (const auto question = std::exchange(m_asked, nullptr)) {
        emit withdrawn();
        answer(question, failure(ErrorCode::Cancelled));
    }
}

void Confirmations::forget()
{
    withdraw();
    for (const auto &question : std::vector(m_questions))
        answer(question, failure(ErrorCode::Cancelled));
}
