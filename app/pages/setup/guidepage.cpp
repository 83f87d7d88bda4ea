// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/setup/guidepage.h"

#include "app/pages/setup/livefigures.h"
#include "app/pages/setup/stickinputs.h"
#include "app/workspace/question.h"
#include "app/workspace/wizardparts.h"
#include "protocol/base/filefault.h"
#include "protocol/client/whendone.h"
#include "protocol/configuration/aftermath.h"
#include "protocol/guide/setupguide.h"
#include "widgets/forms/argumentform.h"
#include "widgets/forms/keyboard.h"
#include "widgets/models/errortext.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"
#include "widgets/views/inputbars.h"

#include <QBuffer>
#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPdfWriter>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QTextBrowser>
#include <QTextDocument>
#include <QVBoxLayout>

#include <algorithm>

using namespace Qt::StringLiterals;

namespace {

constexpr int kStepListWidth = 200;
// % of a usual imbalance, in a simulated world.
constexpr int kUnbalanced = 500;
constexpr int kBalanced = 5;

QString wordsOf(const char *text)
{
    return tableText(text);
}

QString markOf(SetupResult::State state)
{
    switch (state) {
    case SetupResult::State::Done: return u"✓"_s;
    case SetupResult::State::Poor: return u"!"_s;
    case SetupResult::State::Failed: return u"✗"_s;
    case SetupResult::State::Skipped: return u"–"_s;
    case SetupResult::State::Open: break;
    }
    return u"○"_s;
}

SetupValueWords valueWords(const std::shared_ptr<const ParameterSet> &parameters)
{
    return [parameters](const QString &key, const QString &value) {
        const ParameterSpec *spec = parameters ? parameters->find(key) : nullptr;
        const auto raw = spec ? spec->parse(value) : std::nullopt;
        return raw ? parameterValueText(*spec, *raw) : value;
    };
}

}  // namespace

GuidePage::GuidePage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"guide"_s, tr("Gimbal setup"), parent)
    , m_list(new QListWidget)
    , m_title(new QLabel)
    , m_help(new QLabel)
    , m_needs(new QLabel)
    , m_formHolder(new QVBoxLayout)
    , m_confirm(new QCheckBox)
    , m_begin(new QPushButton)
    , m_skip(new QPushButton(tr("Leave out")))
    , m_cancel(new QPushButton(tr("Cancel")))
    , m_next(new QPushButton)
    , m_elsewhere(new QPushButton)
    , m_forget(new QPushButton(tr("From the beginning…")))
    , m_certificate(new QPushButton(tr("Certificate…")))
    , m_doing(new QLabel)
    , m_progress(new QProgressBar)
    , m_findings(new QTextBrowser)
    , m_hands(new SimulatedHands(workspace, this))
    , m_remote(new StickInputs(workspace))
    , m_live(new LiveFigures(workspace))
{
    header()->addWidget(m_forget);
    header()->addWidget(m_certificate);
    m_certificate->setToolTip(tr("One page with all that was measured and set, and what was left out."));
    m_list->setAccessibleName(tr("Steps"));
    m_list->setFixedWidth(kStepListWidth);
    m_findings->setAccessibleName(tr("What was found"));
    m_findings->setPlaceholderText(tr("What the step finds appears here."));
    m_hands->add(u"hand"_s, tr("What the hand does with the camera"),
                 {{tr("camera: let go"), 0},
                  {tr("camera: held level"), 1},
                  {tr("camera: right side down"), 4},
                  {tr("camera: nose down"), 3},
                  {tr("camera: moved as far as it goes"), 2}});
    m_hands->add(u"shake"_s, tr("Where the frame is"),
                 {{tr("frame: in your hand"), 1}, {tr("frame: on a stand"), 0}}, 1);
    m_hands->add(
        u"imbalance"_s, tr("How the camera is mounted"),
        {{tr("camera: far out of balance"), kUnbalanced}, {tr("camera: balanced on its plate"), kBalanced}},
        kUnbalanced);
    auto *cards = new QWidget;
    auto *right = new QVBoxLayout(cards);
    right->setContentsMargins(0, 0, 0, 0);
    right->setSpacing(12);
    right->addWidget(makeStep());
    right->addWidget(m_live);
    right->addWidget(m_remote);
    right->addWidget(m_findings, 1);
    right->addWidget(m_hands);
    auto *row = new QHBoxLayout;
    row->setSpacing(12);
    row->addWidget(m_list);
    auto *scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidget(cards);
    scroll->setFocusPolicy(Qt::NoFocus);
    row->addWidget(scroll, 1);
    body()->addLayout(row, 1);

    connect(m_list, &QListWidget::currentRowChanged, this, [this](int at) {
        if (at >= 0 && at < int(m_steps.size()))
            choose(m_steps[std::size_t(at)]);
    });
    connect(m_begin, &QPushButton::clicked, this, &GuidePage::begin);
    connect(m_skip, &QPushButton::clicked, this, &GuidePage::skip);
    connect(m_next, &QPushButton::clicked, this, &GuidePage::goToNext);
    connect(m_cancel, &QPushButton::clicked, &workspace.client(), &DeviceClient::cancelMovingJobs);
    connect(m_confirm, &QCheckBox::toggled, this, &GuidePage::updateButtons);
    connect(m_elsewhere, &QPushButton::clicked, this,
            [this] { emit pageWanted(QLatin1String(setupStep(m_chosen).elsewhere)); });
    connect(m_forget, &QPushButton::clicked, this, &GuidePage::forget);
    connect(m_certificate, &QPushButton::clicked, this, [this] {
        askSavePath(this, tr("Save the certificate"), u"certificate.pdf"_s,
                    tr("PDF files (*.pdf);;Web pages (*.html)"), [this](const QString &path) {
                        this->workspace().notifications().reportSaved(saveCertificate(path), path);
                    });
    });
    DeviceClient &client = workspace.client();
    connect(&client, &DeviceClient::progressChanged, this, &GuidePage::onProgress);
    connect(&client, &DeviceClient::stateChanged, this, &GuidePage::load);
    connect(&workspace.live(), &LiveModel::heldChanged, this, &GuidePage::updateButtons);
    connect(&workspace, &Workspace::guidedChanged, this, &GuidePage::updateButtons);
    connect(&workspace.configuration(), &ConfigurationModel::boardReset, this, &GuidePage::compare);
    refreshWhileShown(
        StickInputs::kAsk,
        [this] {
            m_live->refresh();
            if (!m_remote->isHidden() && !m_running)
                m_remote->ask();
        },
        [this] { return !this->workspace().client().isConnected(); });
    load();
}

Card *GuidePage::makeStep()
{
    setHeadline(*m_title);
    m_help->setWordWrap(true);
    m_needs->setWordWrap(true);
    m_needs->setObjectName(u"warning"_s);
    m_doing->setWordWrap(true);
    setQuiet(*m_progress, tr("Progress of the step"));
    m_begin->setObjectName(u"primary"_s);
    setHarmless(*m_elsewhere);
    setHarmless(*m_skip);
    setHarmless(*m_next);
    auto *buttons = new QHBoxLayout;
    for (QPushButton *button : {m_begin, m_cancel, m_skip, m_next})
        buttons->addWidget(button);
    buttons->addStretch(1);
    buttons->addWidget(m_elsewhere);
    auto *card = new Card({});
    QVBoxLayout *content = card->content();
    content->setSpacing(12);
    content->addWidget(m_title);
    content->addWidget(m_help);
    content->addWidget(m_needs);
    content->addLayout(m_formHolder);
    content->addWidget(m_confirm);
    content->addLayout(buttons);
    content->addWidget(m_doing);
    content->addWidget(m_progress);
    return card;
}

std::any GuidePage::keep()
{
    return m_chosen;
}

void GuidePage::resume(const std::any &kept)
{
    choose(std::any_cast<SetupStep>(kept));
}

// Of the board that is connected now.
void GuidePage::load()
{
    const DeviceClient &client = workspace().client();
    const Device *device = client.isConnected() ? client.device() : nullptr;
    if (device && std::exchange(m_board, client.identity().serial) != client.identity().serial) {
        m_steps = stepsOf(*device);
        const auto kept = SetupRecord::load(workspace().history().setupFile(m_board), client.identity());
        if (!kept)
            workspace().notifications().report(kept.error());
        m_record = kept.value_or(SetupRecord(client.identity()));
        m_chosen = m_record.next(m_steps).value_or(m_steps.empty() ? SetupStep::Power : m_steps.front());
        fillList();
        showStep();
    }
    updateButtons();
}

// A board that was reset, or another one with the same number, holds nothing of it.
void GuidePage::compare()
{
    const ConfigurationModel &shown = workspace().configuration();
    if (m_running || !workspace().client().isConnected() || shown.isEmpty()
        || !m_record.compare(shown.board()))
        return;
    fillList();
    showStep();
}

void GuidePage::save()
{
    if (const auto saved = m_record.save(workspace().history().setupFile(m_board)); !saved)
        workspace().notifications().report(saved.error());
}

void GuidePage::fillList()
{
    const QSignalBlocker quiet(m_list);
    m_list->clear();
    for (const SetupStep step : m_steps) {
        const SetupResult result = m_record.result(step);
        auto *item = new QListWidgetItem(
            u"%1  %2"_s.arg(markOf(result.state), tableText(setupStep(step).action.label)), m_list);
        item->setToolTip(setupStateWord(result.state, wordsOf));
        if (step == m_chosen)
            m_list->setCurrentItem(item);
    }
}

void GuidePage::choose(SetupStep step)
{
    if (m_running || std::find(m_steps.begin(), m_steps.end(), step) == m_steps.end())
        return;
    m_chosen = step;
    fillList();
    showStep();
}

void GuidePage::showStep()
{
    const SetupStepSpec &spec = setupStep(m_chosen);
    const auto place = std::find(m_steps.begin(), m_steps.end(), m_chosen);
    m_title->setText(tr("%1 of %2: %3")
                         .arg(place - m_steps.begin() + 1)
                         .arg(m_steps.size())
                         .arg(tableText(spec.action.label)));
    m_help->setText(tableText(spec.action.help));
    QStringList open;
    for (auto step = m_steps.begin(); step != place; ++step) {
        if (!m_record.result(*step).isOver())
            open.append(tableText(setupStep(*step).action.label));
    }
    QStringList needs;
    if (*spec.needs)
        needs.append(tr("Before it: %1").arg(tableText(spec.needs)));
    if (!open.isEmpty())
        needs.append(tr("Steps before it are open: %1.").arg(open.join(u", "_s)));
    m_needs->setText(needs.join(u' '));
    m_needs->setVisible(!needs.isEmpty());
    delete std::exchange(m_form, nullptr);
    m_form = new ArgumentForm(spec.action);
    m_formHolder->addWidget(m_form);
    m_form->setVisible(!spec.action.arguments.empty());
    m_confirm->setText(*spec.action.confirm ? tableText(spec.action.confirm) : QString());
    m_confirm->setVisible(*spec.action.confirm);
    m_confirm->setChecked(false);
    QWidget *before = m_list;
    for (const ArgumentSpec &argument : spec.action.arguments) {
        QWidget *field = m_form->field(QLatin1String(argument.key));
        QWidget::setTabOrder(before, field);
        before = field;
    }
    for (QWidget *widget : std::initializer_list<QWidget *>{m_confirm, m_begin, m_cancel, m_skip, m_next,
                                                            m_elsewhere, m_findings})
        QWidget::setTabOrder(std::exchange(before, widget), widget);
    const QString page = pageTitle(QLatin1String(spec.elsewhere));
    m_elsewhere->setText(tr("More about it: %1…").arg(page));
    m_elsewhere->setVisible(!page.isEmpty());
    m_live->showStep(m_chosen);
    m_remote->setVisible(m_chosen == SetupStep::Remote);
    showFindings();
    updateButtons();
}

// Pages that lead further, by their keys.
QString GuidePage::pageTitle(const QString &key)
{
    return key == u"parameters"_s ? tr("Parameters")
        : key == u"calibration"_s ? tr("Calibration")
        : key == u"actions"_s     ? tr("Actions")
        : key == u"autotune"_s    ? tr("Auto-tune")
        : key == u"spectrum"_s    ? tr("Spectrum")
        : key == u"signals"_s     ? tr("Signals")
                                  : QString();
}

void GuidePage::showFindings()
{
    const SetupResult result = m_record.result(m_chosen);
    if (result.state == SetupResult::State::Open && result.changes.isEmpty()) {
        m_findings->clear();
        return;
    }
    QString html = u"<p><b>%1</b></p>"_s.arg(setupStateWord(result.state, wordsOf).toHtmlEscaped());
    if (!result.why.isEmpty())
        html += u"<p>%1</p>"_s.arg(result.why.toHtmlEscaped());
    for (const QString &key : result.remarks) {
        if (const SetupRemarkSpec *remark = findSetupRemark(key))
            html += u"<p>%1</p>"_s.arg(tableText(remark->text).toHtmlEscaped());
    }
    html += u"<table>"_s;
    const auto add = [&html](const QString &left, const QString &right) {
        html += u"<tr><td style='padding:2px 24px 2px 0'>%1</td><td style='padding:2px 0'>%2</td></tr>"_s.arg(
            left.toHtmlEscaped(), withNumbers(right).toHtmlEscaped());
    };
    for (const SetupFigure &figure : result.figures)
        add(setupFigureLabel(figure, wordsOf), setupFigureText(figure));
    const auto parameters = workspace().tables() ? workspace().tables()->parameters() : nullptr;
    for (const SetupChange &change : result.changes) {
        const ParameterSpec *spec = parameters ? parameters->find(change.key) : nullptr;
        add(spec ? parameterLabel(*spec) : change.key, setupChangeText(change, valueWords(parameters)));
    }
    html += u"</table>"_s;
    if (!result.snapshot.isEmpty())
        html += u"<p>%1</p>"_s.arg(tr("The settings as they were are kept in Backups."));
    m_findings->setHtml(html);
}

void GuidePage::updateButtons()
{
    const DeviceClient &client = workspace().client();
    const bool isConnected = client.isConnected() && !m_steps.empty();
    const bool isHeld = workspace().live().isHeld() && !m_running;
    const SetupStepSpec &spec = setupStep(m_chosen);
    m_begin->setText(m_record.result(m_chosen).state == SetupResult::State::Open ? tr("Begin")
                                                                                 : tr("Do it again"));
    m_begin->setEnabled(isConnected && !m_running && !isHeld && !workspace().isGuided()
                        && client.identity().writable && (!*spec.action.confirm || m_confirm->isChecked()));
    m_begin->setToolTip(*spec.action.confirm && !m_confirm->isChecked() ? tr("Tick what has to be so first.")
                                                                        : QString());
    m_skip->setEnabled(isConnected && !m_running);
    const auto next = m_record.next(m_steps);
    m_next->setVisible(isConnected && !m_running && next && *next != m_chosen
                       && m_record.result(m_chosen).isOver());
    if (next)
        m_next->setText(tr("Next: %1").arg(tableText(setupStep(*next).action.label)));
    m_cancel->setVisible(m_running.has_value());
    m_doing->setVisible(m_running.has_value());
    m_progress->setVisible(m_running.has_value());
    m_list->setEnabled(!m_running);
    m_confirm->setEnabled(!m_running);
    m_forget->setEnabled(isConnected && !m_running);
    m_certificate->setEnabled(!m_steps.empty());
    if (m_form)
        m_form->setEnabled(!m_running);
}

void GuidePage::begin()
{
    const auto answers = m_form->arguments();
    if (!answers) {
        workspace().notifications().report(answers.error());
        return;
    }
    DeviceClient &client = workspace().client();
    const auto store = client.telemetry();
    if (!store || workspace().refusesToBegin())
        return;
    m_running = m_chosen;
    m_progress->setValue(0);
    m_doing->setText(QString());
    m_findings->clear();  // what was found before is not of this time
    m_findings->setFocus(Qt::OtherFocusReason);
    workspace().beginWork();
    workspace().live().hold();
    updateButtons();
    const bool areMotorsKnown = m_record.result(SetupStep::Motors).isOver();
    whenDone(
        client.submit<SetupResult>(
            [step = m_chosen, answers = *answers, areMotorsKnown, store, history = workspace().history(),
             live = workspace().live().unsaved()](Channel &channel, Device &device) {
                return SetupGuide(channel, device, *store, history, live).run(step, answers, areMotorsKnown);
            },
            DeviceClient::JobKind::Moving),
        this, [this, step = m_chosen](const Result<SetupResult> &result) { finished(step, result); });
}

void GuidePage::finished(SetupStep step, const Result<SetupResult> &result)
{
    m_running.reset();
    workspace().live().release();
    workspace().endWork();
    SetupResult kept;
    if (result) {
        kept = *result;
    } else {
        kept.state = SetupResult::State::Failed;
        kept.at = QDateTime::currentDateTimeUtc();
        Error error = result.error();
        error.after.reset();  // of the moment: the board is read again
        kept.why = error.code == ErrorCode::Cancelled ? tr("It was cancelled.") : describe(error).oneLine();
        if (result.error().code != ErrorCode::Cancelled)
            workspace().notifications().report(result.error());
        endWhatGoesOn(result.error());
    }
    // Broken off, it takes nothing away from what was done before.
    if (result || result.error().code != ErrorCode::Cancelled || !m_record.result(step).isOver())
        m_record.add(step, kept);
    save();
    emit workspace().snapshotTaken();
    if (workspace().client().isConnected() && setupStep(step).action.risk == ActionRisk::Writes)
        workspace().readBoard();
    m_confirm->setChecked(false);
    fillList();
    showFindings();
    updateButtons();
    if (kept.state == SetupResult::State::Done)
        goOn();
}

// Broken off here, it goes on on the board until that is told to end it, and proves it.
void GuidePage::endWhatGoesOn(const Error &error)
{
    const QString key = error.after ? error.after->endedBy : QString();
    if (!key.isEmpty() && workspace().client().isConnected())
        workspace().perform(key, {});  // which tells where it fails
}

// What a step has found stays in sight: the next one is offered in the list, and by a word.
void GuidePage::goOn()
{
    const auto next = m_record.next(m_steps);
    workspace().notifications().notify(
        next ? tr("“%1” is done. Next: %2.")
                   .arg(tableText(setupStep(m_chosen).action.label), tableText(setupStep(*next).action.label))
             : tr("Every step is done or left out: save the certificate."));
}

void GuidePage::skip()
{
    SetupResult left;
    left.state = SetupResult::State::Skipped;
    left.at = QDateTime::currentDateTimeUtc();
    m_record.set(m_chosen, left);
    save();
    goToNext();
    m_list->setFocus(Qt::OtherFocusReason);  // pressed twice, it leaves out one
}

void GuidePage::goToNext()
{
    if (const auto next = m_record.next(m_steps))
        m_chosen = *next;
    fillList();
    showStep();
}

void GuidePage::forget()
{
    QDialog *panel = askInPanel({tr("Begin the set-up anew?"),
                                 tr("What was found so far is forgotten. The board stays as it is."),
                                 {{tr("Forget it"),
                                   [this] {
                                       m_record.clear();
                                       save();
                                       m_chosen = m_steps.front();
                                       fillList();
                                       showStep();
                                   },
                                   true}},
                                 tr("Go on as it is")},
                                this);
    connect(&workspace().client(), &DeviceClient::stateChanged, panel, &QDialog::reject);
}

void GuidePage::onProgress(const Progress &progress)
{
    if (!m_running)
        return;
    m_asks = progress;
    m_doing->setText(describe(progress));
    if (!progress.values.isEmpty())
        m_remote->bars()->setValues(progress.values);
    if (progress.total > 0)
        m_progress->setValue(100 * progress.done / progress.total);
}

Result<void> GuidePage::saveCertificate(const QString &path) const
{
    const auto parameters = workspace().tables() ? workspace().tables()->parameters() : nullptr;
    const auto labelOf = [&parameters](const QString &key) {
        const ParameterSpec *spec = parameters ? parameters->find(key) : nullptr;
        return spec ? parameterLabel(*spec) : key;
    };
    const QString page = setupCertificate(m_record, m_steps, wordsOf, labelOf, valueWords(parameters),
                                          workspace().isSimulated() ? tr("A simulated gimbal.") : QString());
    if (!path.endsWith(u".pdf"_s, Qt::CaseInsensitive))
        return writeWhole(path, page.toUtf8());
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    {
        QPdfWriter writer(&buffer);
        writer.setTitle(tableText(setupCertificateWords()[0]));
        writer.setPageSize(QPageSize(QPageSize::A4));
        QTextDocument document;
        document.setHtml(page);
        document.print(&writer);
    }
    return writeWhole(path, buffer.data());
}

void GuidePage::showEvent(QShowEvent *event)
{
    Page::showEvent(event);
    workspace().telemetry().subscribe(this, [this] {
        const Device *device = workspace().tables();
        return device ? SetupGuide::channels(*device) : QList<int>();
    });
}

void GuidePage::hideEvent(QHideEvent *event)
{
    Page::hideEvent(event);
    // A step that nobody looks at does not go on.
    if (!m_running)
        return;
    workspace().client().cancelMovingJobs();
    workspace().notifications().notify(
        tr("“%1” was cancelled: its page was left.").arg(tableText(setupStep(*m_running).action.label)),
        Notice::Attention);
}
