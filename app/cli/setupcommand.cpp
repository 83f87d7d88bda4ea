// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/actioncommand.h"
#include "protocol/base/filefault.h"
#include "protocol/guide/setupguide.h"
#include "protocol/guide/setuplive.h"
#include "protocol/procedure/trialnote.h"

#include <QJsonDocument>

#include <algorithm>
#include <atomic>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kLivePeriod = 200ms;
const QString kNext = u"next"_s;
const QString kPage = u".html"_s;
const QString kData = u".json"_s;

QString english(const char *text)
{
    return QString::fromUtf8(text);
}

QString resultText(const SetupResult &result)
{
    QString text;
    for (const SetupFigure &figure : result.figures)
        text
            += u"%1 %2\n"_s.arg(setupFigureLabel(figure, english).leftJustified(32), setupFigureText(figure));
    for (const SetupChange &change : result.changes)
        text += u"%1 %2 -> %3\n"_s.arg(change.key.leftJustified(32), change.from, change.to);
    for (const QString &key : result.remarks) {
        if (const SetupRemarkSpec *remark = findSetupRemark(key))
            text += english(remark->text) + u'\n';
    }
    return text;
}

/// Leads from an unpacked gimbal to a tuned one, step by step.
class SetupCommand final : public BoardCommand
{
public:
    using BoardCommand::BoardCommand;
    const char *name() const override { return "setup"; }
    const char *words() const override { return "[STEP|next [ANSWER=VALUE...]]"; }
    QString help() const override
    {
        return u"gimbal setup, step by step; without a step: what they are, and how far it has come"_s;
    }
    const char *example() const override { return "--link serial:/dev/ttyUSB0 setup power cells=3"; }
    QList<CommandOption> options() override
    {
        return {switchOption(u"confirmed"_s, u"what the step asks to be confirmed is so"_s, m_confirmed),
                switchOption(u"skip"_s, u"leave the step out; the certificate says so"_s, m_skip),
                switchOption(u"anew"_s, u"forget what was done before"_s, m_anew),
                textOption(u"certificate"_s, u"FILE"_s,
                           u"write all that was found into a page (.html) or as .json"_s, m_certificate)};
    }
    QString check() const override
    {
        if (!m_certificate.isEmpty() && !m_certificate.endsWith(kPage) && !m_certificate.endsWith(kData))
            return u"setup writes the certificate as a page or as data: give it a name that ends in .html or "
                   ".json"_s;
        if (arguments().isEmpty())
            return m_skip ? u"setup --skip needs the step to leave out"_s : QString();
        if (arguments().first() == kNext || findSetupStep(arguments().first()))
            return {};
        QStringList names;
        for (const SetupStepSpec &spec : setupSteps())
            names.append(QLatin1String(spec.action.key));
        return u"there is no step '%1'; there are: %2, and next"_s.arg(arguments().first(),
                                                                       names.join(u", "_s));
    }
    bool moves() const override { return !arguments().isEmpty() && !m_skip; }
    void start(DeviceClient &client) override
    {
        connect(&m_live, &QTimer::timeout, this, &SetupCommand::showLive);
        connect(this, &Command::finished, &m_live, &QTimer::stop);
        m_live.start(kLivePeriod);
        BoardCommand::start(client);
    }

protected:
    QList<int> awaits(const Device &device) const override
    {
        return moves() ? SetupGuide::channels(device) : QList<int>();
    }
    Result<CommandOutcome> run(Channel &channel, Device &device) override
    {
        const std::vector<SetupStep> steps = stepsOf(device);
        if (steps.empty())
            return failure(ErrorCode::Unsupported, u"no set-up is known for this board"_s);
        const QString file = history().setupFile(device.identity().serial);
        auto record = m_anew ? SetupRecord(device.identity()) : SetupRecord::load(file, device.identity());
        if (!record)
            return tl::unexpected(record.error());
        CommandOutcome outcome;
        auto board = device.readConfiguration(channel);
        const auto undone = board && device.identity().writable
            ? makeTrialGood(channel, device, history(), *board)
            : Result<QStringList>(QStringList());
        if (!undone)
            return tl::unexpected(undone.error());
        if (!undone->isEmpty()) {
            emit told(u"a trial was cut off, and what was tried was still on the board: the old values are "
                      "written back (%1)"_s.arg(undone->join(u", "_s)));
            board = device.readConfiguration(channel);
        }
        if (board && record->compare(*board))
            emit told(
                u"the board holds other values than some steps had written: they are to be done again"_s);
        if (!arguments().isEmpty()) {
            const auto done = step(channel, device, steps, *record, outcome);
            if (!done)
                return tl::unexpected(done.error());
        }
        if (m_anew || !arguments().isEmpty()) {
            if (const auto saved = record->save(file); !saved)
                return tl::unexpected(saved.error());
        }
        if (arguments().isEmpty())
            list(steps, *record, outcome);
        if (!m_certificate.isEmpty()) {
            const QByteArray whole = m_certificate.endsWith(kData)
                ? QJsonDocument(record->toJson()).toJson()
                : setupCertificate(
                      *record, steps, english, [](const QString &key) { return key; },
                      setupValueNames(device.parameters()))
                      .toUtf8();
            if (const auto saved = writeWhole(m_certificate, whole); !saved)
                return tl::unexpected(saved.error());
            outcome.note += u"the certificate is in %1\n"_s.arg(m_certificate);
        }
        return outcome;
    }

private:
    Result<void> step(Channel &channel, Device &device, const std::vector<SetupStep> &steps,
                      SetupRecord &record, CommandOutcome &outcome)
    {
        const auto next = record.next(steps);
        if (arguments().first() == kNext && !next) {
            outcome.text = u"every step is done or left out\n"_s;
            outcome.json = record.toJson();
            return {};
        }
        const SetupStepSpec &spec
            = arguments().first() == kNext ? setupStep(*next) : *findSetupStep(arguments().first());
        const QString key = QLatin1String(spec.action.key);
        SetupResult result;
        if (m_skip) {
            result.state = SetupResult::State::Skipped;
            result.at = QDateTime::currentDateTimeUtc();
        } else {
            const auto answers = parseAnswers(spec);
            if (!answers)
                return tl::unexpected(answers.error());
            if (*spec.action.confirm && !m_confirmed)
                return failure(ErrorCode::InvalidArgument,
                               u"%1 has to be confirmed with --confirmed each time: \"%2\""_s.arg(
                                   key, english(spec.action.confirm)));
            if (*spec.needs)
                emit told(u"%1: %2"_s.arg(key, english(spec.needs)));
            m_step = &spec;
            const auto done = SetupGuide(channel, device, *telemetry(), history())
                                  .run(spec.step, *answers, record.result(SetupStep::Motors).isOver());
            m_step = nullptr;
            if (!done) {
                result.state = SetupResult::State::Failed;
                result.at = QDateTime::currentDateTimeUtc();
                Error error = done.error();
                error.after.reset();  // of the moment
                result.why = error.code == ErrorCode::Cancelled ? u"It was cancelled."_s
                                                                : consoleText(error).oneLine();
                if (error.code != ErrorCode::Cancelled || !record.result(spec.step).isOver())
                    record.set(spec.step, result);
                std::ignore = record.save(history().setupFile(device.identity().serial));
                return tl::unexpected(done.error());
            }
            result = *done;
        }
        record.add(spec.step, result);
        outcome.text = u"%1: %2\n"_s.arg(key, setupStateKey(result.state)) + resultText(result);
        outcome.json = record.toJson().value(u"steps"_s).toObject().value(key);
        outcome.exitCode = result.state == SetupResult::State::Poor ? Refused : Done;
        if (const auto after = record.next(steps))
            outcome.note = u"next: %1\n"_s.arg(QLatin1String(setupStep(*after).action.key));
        if (!result.snapshot.isEmpty())
            outcome.note += u"snapshot: %1\n"_s.arg(result.snapshot);
        return {};
    }

    void showLive()
    {
        const SetupStepSpec *spec = m_step;
        if (!spec || !telemetry() || !client().device())
            return;
        emit shown(setupLiveText(spec->step, client().device()->channels(), client().roles(), *telemetry()));
    }

    Result<QVariantMap> parseAnswers(const SetupStepSpec &spec) const
    {
        QMap<QString, QString> texts;
        for (const QString &word : arguments().mid(1)) {
            if (word.indexOf(u'=') < 1)
                return failure(ErrorCode::InvalidArgument, u"'%1' is not ANSWER=VALUE"_s.arg(word));
            texts.insert(word.section(u'=', 0, 0), word.section(u'=', 1));
        }
        return parseArguments(spec.action, texts);
    }

    static void list(const std::vector<SetupStep> &steps, const SetupRecord &record, CommandOutcome &outcome)
    {
        for (const SetupStep step : steps) {
            const SetupStepSpec &spec = setupStep(step);
            // With its name on the page.
            outcome.text += u"%1 %2 %3: %4\n"_s.arg(QString::fromLatin1(spec.action.key).leftJustified(12),
                                                    setupStateKey(record.result(step).state).leftJustified(9),
                                                    english(spec.action.label), english(spec.action.help));
            for (const ArgumentSpec &answer : spec.action.arguments) {
                QStringList words;
                for (const Choice &choice : answer.choices)
                    words.append(QLatin1String(choice.name));
                outcome.text += u"%1 %2=%3  %4\n"_s.arg(QString(22, u' '), QLatin1String(answer.key),
                                                        words.isEmpty() ? QLatin1String(answer.defaultText)
                                                                        : words.join(u'|'),
                                                        english(answer.label));
            }
        }
        const auto next = record.next(steps);
        outcome.json = record.toJson();
        outcome.note = next ? u"next: %1\n"_s.arg(QLatin1String(setupStep(*next).action.key))
                            : u"every step is done or left out\n"_s;
    }

    bool m_confirmed = false;
    bool m_skip = false;
    bool m_anew = false;
    QString m_certificate;
    std::atomic<const SetupStepSpec *> m_step = nullptr;  // that goes on, on the worker
    QTimer m_live;
};

}  // namespace

Commands setupCommands(const CommandContext &context)
{
    return makeCommands<SetupCommand>(context);
}
