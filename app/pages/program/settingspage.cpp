// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/program/settingspage.h"

#include "app/pages/program/supervisorform.h"
#include "widgets/forms/numberbox.h"
#include "widgets/models/numbertext.h"
#include "widgets/views/card.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kPatience = 400ms;
constexpr int kLabelWidth = 230;
constexpr int kMaxWidth = 720;  // of the cards
constexpr double kBytesPerSample = 4.9;  // with its share of the index
constexpr double kPolledRate = 100;  // samples per second that no polled board reaches

}  // namespace

SettingsPage::SettingsPage(Workspace &workspace, QWidget *parent)
    : Page(workspace, u"settings"_s, tr("Settings"), parent)
    , m_theme(new QComboBox)
    , m_language(new QComboBox)
    , m_temperature(new QComboBox)
    , m_retention(new NumberBox(1, 60, 0, tr(" min")))
    , m_escape(new NumberBox(0, 3000, 0, tr(" ms")))
    , m_speed(new NumberBox(1, 360, 0, tr(" °/s")))
    , m_disarm(new NumberBox(2, 120, 0, tr(" s")))
    , m_offOnQuit(new QCheckBox(tr("Stop the motors when the program is closed")))
    , m_askMotors(new QCheckBox(tr("Ask before the link ends while motors run")))
    , m_scroll(new QScrollArea)
    , m_memory(new QLabel)
    , m_madeIn(workspace.settings().language())
    , m_wait(
          new QLabel(tr("The language changes as soon as what runs, or is half done on a page, has ended.")))
{
    fillFields();
    makeBody();
    connectAll();
    updateNotes();
}

void SettingsPage::fillFields()
{
    const Settings &settings = workspace().settings();
    m_theme->addItem(tr("As the system"), int(Settings::ThemeChoice::System));
    m_theme->addItem(tr("Light"), int(Settings::ThemeChoice::Light));
    m_theme->addItem(tr("Dark"), int(Settings::ThemeChoice::Dark));
    m_theme->setCurrentIndex(m_theme->findData(int(settings.theme())));
    m_language->addItem(tr("As the system"), QString());
    m_language->addItem(u"English"_s, u"en"_s);
    m_language->addItem(u"Deutsch"_s, u"de"_s);
    m_language->setCurrentIndex(std::max(0, m_language->findData(settings.language())));
    m_temperature->addItem(tr("Degrees Celsius"), false);
    m_temperature->addItem(tr("Degrees Fahrenheit"), true);
    m_temperature->setCurrentIndex(settings.fahrenheit() ? 1 : 0);
    m_retention->setValue(settings.retentionMinutes());
    m_escape->setSingleStep(100);
    m_escape->setSpecialValueText(tr("not by Esc"));
    m_escape->setValue(settings.escapeHoldMs());
    m_speed->setValue(settings.controlSpeedLimit());
    m_disarm->setValue(settings.disarmSeconds());
    m_offOnQuit->setChecked(settings.motorsOffOnQuit());
    m_askMotors->setChecked(settings.askAboutMotors());
}

void SettingsPage::makeBody()
{
    m_memory->setObjectName(u"muted"_s);
    m_memory->setWordWrap(true);
    m_wait->setObjectName(u"muted"_s);
    m_wait->setWordWrap(true);
    m_wait->hide();
    auto *cards = new QWidget;
    cards->setMaximumWidth(kMaxWidth);
    auto *column = new QVBoxLayout(cards);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(12);
    const auto section = [column](const QString &title) {
        auto *card = new Card(title);
        auto *form = new QFormLayout;
        form->setSpacing(Metric::kGap);
        form->setFieldGrowthPolicy(QFormLayout::FieldsStayAtSizeHint);
        card->content()->addLayout(form);
        column->addWidget(card);
        return form;
    };
    const auto row = [](QFormLayout *form, const QString &label, QWidget *field) {
        field->setAccessibleName(label);
        field->setMinimumWidth(220);
        auto *name = new QLabel(label);
        name->setMinimumWidth(kLabelWidth);
        name->setBuddy(field);
        form->addRow(name, field);
    };
    QFormLayout *look = section(tr("Look and language"));
    row(look, tr("Colours"), m_theme);
    row(look, tr("Language"), m_language);
    look->addRow(QString(), m_wait);
    row(look, tr("Temperatures"), m_temperature);
    QFormLayout *live = section(tr("Live data"));
    row(live, tr("Keep in memory"), m_retention);
    live->addRow(m_memory);
    QFormLayout *safety = section(tr("Safety"));
    row(safety, tr("Hold Esc to stop the motors"), m_escape);
    row(safety, tr("Highest speed on Control"), m_speed);
    row(safety, tr("Disarm control after"), m_disarm);
    safety->addRow(m_offOnQuit);
    safety->addRow(m_askMotors);
    auto *fixed = new QLabel(
        tr("Always on, and cannot be switched off: a snapshot before the first write, reading back of every "
           "byte, F12 for motors off, and control that ends when the program does not refresh it."));
    fixed->setObjectName(u"muted"_s);
    fixed->setWordWrap(true);
    safety->addRow(fixed);
    QFormLayout *supervisor = section(tr("Supervisor"));
    new SupervisorForm(
        workspace().settings(), workspace().client(),
        [row, supervisor](const QString &label, QWidget *field) { row(supervisor, label, field); },
        *supervisor, this);
    auto *about = section(tr("About"));
    auto *text = new QLabel(
        tr("GimbalDesk %1, GPL 3.0 or later. Settings: %2. Snapshots: %3.")
            .arg(QStringLiteral(GIMBAL_VERSION), Settings::defaultPath(), BoardHistory::defaultRoot()));
    text->setWordWrap(true);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    about->addRow(text);
    column->addStretch(1);
    // Beside a stretch, because only a row asks for the height at the width that the cards really get.
    auto *holder = new QWidget;
    auto *line = new QHBoxLayout(holder);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(cards, 1);
    line->addStretch();
    m_scroll->setWidgetResizable(true);
    m_scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_scroll->setWidget(holder);
    body()->addWidget(m_scroll, 1);
}

void SettingsPage::connectAll()
{
    Settings &settings = workspace().settings();
    connect(m_theme, &QComboBox::activated, this,
            [this, &settings] { settings.setTheme(Settings::ThemeChoice(m_theme->currentData().toInt())); });
    connect(m_language, &QComboBox::activated, this,
            [this, &settings] { settings.setLanguage(m_language->currentData().toString()); });
    // Every page is made anew for another language. If this one is still there, something keeps it waiting.
    m_patience.setSingleShot(true);
    connect(&m_patience, &QTimer::timeout, this,
            [this, &settings] { m_wait->setVisible(settings.language() != m_madeIn); });
    connect(m_language, &QComboBox::activated, &m_patience, [this] { m_patience.start(kPatience); });
    connect(m_temperature, &QComboBox::activated, this,
            [this, &settings] { settings.setFahrenheit(m_temperature->currentData().toBool()); });
    connect(m_retention, &NumberBox::valueChanged, this, [this, &settings](double minutes) {
        settings.setRetentionMinutes(int(minutes));
        updateNotes();
    });
    connect(m_escape, &NumberBox::editingFinished, this, [this, &settings] {
        settings.setEscapeHoldMs(int(m_escape->value()));
        m_escape->setValue(settings.escapeHoldMs());
    });
    connect(m_speed, &NumberBox::valueChanged, this,
            [&settings](double value) { settings.setControlSpeedLimit(int(value)); });
    connect(m_disarm, &NumberBox::valueChanged, this,
            [&settings](double value) { settings.setDisarmSeconds(int(value)); });
    connect(m_offOnQuit, &QCheckBox::toggled, this,
            [&settings](bool on) { settings.setMotorsOffOnQuit(on); });
    connect(m_askMotors, &QCheckBox::toggled, this, [&settings](bool on) { settings.setAskAboutMotors(on); });
}

std::any SettingsPage::keep()
{
    return Kept{m_scroll->verticalScrollBar()->value(), m_language->hasFocus()};
}

void SettingsPage::resume(const std::any &kept)
{
    const auto &before = std::any_cast<const Kept &>(kept);
    // The height of the cards is known once they are laid out.
    QTimer::singleShot(0, this, [this, before] { m_scroll->verticalScrollBar()->setValue(before.scrolled); });
    if (before.languageHasFocus)
        m_language->setFocus();
}

void SettingsPage::updateNotes()
{
    const double rate = std::max(fullRate(workspace().client().families()), kPolledRate);
    const double bytesPerMinute = 24 * rate * 60 * kBytesPerSample;
    m_memory->setText(tr("At most %1 MB with 24 channels at full rate. The last ten minutes of the link "
                         "itself, for recordings, "
                         "take up to %2 MB more.")
                          .arg(numberText(m_retention->value() * bytesPerMinute / 1e6, 0))
                          .arg(numberText(double(Recorder::kMaxBytes) / 1e6, 0)));
}
