// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/watch/streamsdialog.h"

#include "widgets/forms/numberbox.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QRadioButton>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

StreamsDialog::StreamsDialog(Workspace &workspace, QWidget *parent)
    : QDialog(parent)
    , m_workspace(workspace)
    , m_automatic(new QRadioButton(tr("Automatic: what you look at, as fast as the line allows")))
    , m_byHand(new QRadioButton(tr("By hand")))
    , m_line(new QProgressBar)
    , m_verdict(new QLabel)
    , m_apply(new QPushButton(tr("Use")))
{
    setWindowTitle(tr("Data streams"));
    auto *grid = new QGridLayout;
    grid->setHorizontalSpacing(Metric::kMargin);
    grid->setVerticalSpacing(Metric::kGap);
    grid->setColumnStretch(2, 1);
    const QList<StreamChoice> now = workspace.telemetry().streams();
    (now.isEmpty() ? m_automatic : m_byHand)->setChecked(true);
    const QList<StreamSpec> offered = workspace.client().device()->streamControl()->streams();
    for (const StreamSpec &spec : offered) {
        Row row{spec, new QCheckBox(spec.label), new NumberBox(0, spec.maxRate, 0, tr(" samples/s")),
                new QLabel};
        const auto wish = std::find_if(now.begin(), now.end(),
                                       [&](const StreamChoice &each) { return each.key == spec.key; });
        row.check->setChecked(wish != now.end());
        row.check->setToolTip(
            spec.choosesChannels
                ? tr("Carries the channels that are shown, at the rate you choose")
                : tr("Carries %n channel(s), all of them each time", nullptr, int(spec.channels.size())));
        row.rate->setSpecialValueText(tr("as fast as possible"));
        row.rate->setValue(wish == now.end() ? 0 : wish->rate);
        row.rate->setAccessibleName(tr("Rate of %1").arg(spec.label));
        row.use->setObjectName(u"muted"_s);
        row.use->setWordWrap(true);
        const int line = grid->rowCount();
        grid->addWidget(row.check, line, 0);
        grid->addWidget(row.rate, line, 1);
        grid->addWidget(row.use, line, 2);
        connect(row.check, &QCheckBox::toggled, this, &StreamsDialog::update);
        connect(row.rate, &QDoubleSpinBox::valueChanged, this, &StreamsDialog::update);
        m_rows.push_back(row);
    }
    m_line->setRange(0, 100);
    m_line->setAccessibleName(tr("Share of the line"));
    m_verdict->setWordWrap(true);
    auto *cancel = new QPushButton(tr("Cancel"));
    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(Metric::kGap);
    buttons->addStretch(1);
    buttons->addWidget(cancel);
    buttons->addWidget(m_apply);
    m_apply->setObjectName(u"primary"_s);
    m_apply->setDefault(true);
    connect(m_apply, &QPushButton::clicked, this, [this] {
        if (NumberBox::refusedIn(*this) || !m_apply->isEnabled())  // a rate still being typed counts as well
            return;
        m_workspace.telemetry().setStreams(chosen());
        accept();
    });
    connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_byHand, &QRadioButton::toggled, this, &StreamsDialog::update);

    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(Metric::kMargin, Metric::kMargin, Metric::kMargin, Metric::kMargin);
    layout->setSpacing(Metric::kGap);
    layout->addWidget(m_automatic);
    layout->addWidget(m_byHand);
    layout->addLayout(grid);
    layout->addSpacing(Metric::kGap);
    layout->addWidget(m_line);
    layout->addWidget(m_verdict);
    layout->addStretch(1);
    layout->addLayout(buttons);
    setMinimumWidth(640);
    update();
}

// The texts were measured before the style sheet gave them their font.
void StreamsDialog::showEvent(QShowEvent *event)
{
    QDialog::showEvent(event);
    update();
}

QCheckBox *StreamsDialog::check(const QString &stream) const
{
    const auto row = std::find_if(m_rows.begin(), m_rows.end(),
                                  [&](const Row &each) { return each.spec.key == stream; });
    return row == m_rows.end() ? nullptr : row->check;
}

NumberBox *StreamsDialog::rate(const QString &stream) const
{
    const auto row = std::find_if(m_rows.begin(), m_rows.end(),
                                  [&](const Row &each) { return each.spec.key == stream; });
    return row == m_rows.end() ? nullptr : row->rate;
}

QList<StreamChoice> StreamsDialog::chosen() const
{
    QList<StreamChoice> streams;
    for (const Row &row : m_rows) {
        if (m_byHand->isChecked() && row.check->isChecked())
            streams.append({row.spec.key, row.rate->value(), {}});
    }
    return streams;
}

void StreamsDialog::update()
{
    const bool byHand = m_byHand->isChecked();
    for (const Row &row : m_rows) {
        row.check->setEnabled(byHand);
        row.rate->setEnabled(byHand && row.check->isChecked());
        row.use->clear();
        row.use->setMinimumHeight(2 * row.use->fontMetrics().lineSpacing());  // so that no row moves
    }
    const bool nothing = byHand && chosen().isEmpty();
    const auto budget = m_workspace.client().device()->streamControl()->streamBudget(
        m_workspace.telemetry().with(chosen()), m_workspace.client().line());
    QString text;
    bool fits = !nothing;
    if (nothing) {
        text = tr("Choose at least one stream.");
        m_line->setValue(0);
    } else if (!budget) {
        text = describe(budget.error()).oneLine();
        fits = false;
    } else {
        for (const StreamUse &use : budget->streams) {
            const auto row = std::find_if(m_rows.begin(), m_rows.end(),
                                          [&](const Row &each) { return each.spec.key == use.key; });
            row->use->setText(tr("%1 samples/s, %2 bytes each, %3 bytes/s")
                                  .arg(numberText(use.rate, 0))
                                  .arg(use.frameBytes)
                                  .arg(numberText(use.bytesPerSecond(), 0)));
        }
        const double used = budget->bytesPerSecond();
        fits = budget->fits();
        if (budget->capacity > 0) {
            const double share = 100.0 * used / budget->capacity;
            m_line->setValue(std::min(100, int(std::lround(share))));
            text = tr("%1 of %2 bytes/s, %3 % of the line.")
                       .arg(numberText(used, 0))
                       .arg(numberText(budget->capacity, 0))
                       .arg(numberText(share, 0));
        } else {
            m_line->setValue(0);
            text = tr("%1 bytes/s. This link sets no limit.").arg(numberText(used, 0));
        }
        if (!fits)
            text += u' '
                + tr("That is too much: %1 % may be used, the rest is kept for commands. Lower a rate, look "
                     "at fewer "
                     "channels, or set a faster serial speed.")
                      .arg(shortNumberText(StreamBudget::kShare * 100));
    }
    m_verdict->setText(text);
    m_verdict->setObjectName(fits ? u"muted"_s : u"warning"_s);
    repolish(m_verdict);
    m_apply->setEnabled(fits);
    if (isVisible()) {  // grows with its texts, which its minimum width would otherwise prevent
        layout()->activate();
        resize(size().expandedTo(layout()->totalMinimumSize()));
    }
}
