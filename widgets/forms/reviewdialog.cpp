// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/forms/reviewdialog.h"

#include "protocol/configuration/linediff.h"
#include "widgets/models/leaptext.h"
#include "widgets/models/missingtext.h"
#include "widgets/models/parametermodel.h"
#include "widgets/theme/tablelook.h"
#include "widgets/theme/theme.h"

#include <QComboBox>
#include <QFontDatabase>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTableView>
#include <QTextBlock>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace {

constexpr int kAround = 2;  // lines that are the same, before and after a change
constexpr int kMostLines = 300;
constexpr std::size_t kMostDoubts = 6;
constexpr int kTabWidth = 4;
constexpr QSize kSize(760, 460);
constexpr QSize kSizeWithLines(760, 600);

// Its number in the text that has it, and a sign: what changes is bold beside.
QString reviewLine(const DiffLine &line)
{
    const QString number = u"%1 "_s.arg(line.after > 0 ? line.after : line.before, 4);
    switch (line.kind) {
    case DiffLine::Kind::Same: return number + u"  "_s + line.text;
    case DiffLine::Kind::Added: return number + u"+ "_s + line.text;
    case DiffLine::Kind::Removed: return number + u"− "_s + line.text;
    case DiffLine::Kind::Gap: return u"   …"_s;
    }
    return {};
}

}  // namespace

ReviewDialog::ReviewDialog(const Configuration &board, const Configuration &edited, const LiveValues &live,
                           QWidget *parent)
    : QDialog(parent)
    , m_changes(board, edited)
    , m_table(new QTableView)
    , m_risk(new QLabel)
    , m_doubts(new QLabel)
    , m_live(live)
    , m_othersText(new QLabel)
    , m_others(new QComboBox)
    , m_effect(new QLabel)
    , m_write(new QPushButton)
{
    setWindowTitle(tr("Review and write"));
    auto *intro = new QLabel(
        board.missing().empty()
            ? tr("These values go to the board. They are read back and compared, and a copy of all "
                 "settings of the board is kept before the first write.")
            : tr("These values go to the board. They are read back and compared, and a copy of what could be "
                 "read of the board is kept before the first write."));
    intro->setWordWrap(true);
    m_table->setModel(&m_changes);
    m_table->setAccessibleName(tr("Changes to write"));
    setPlainRows(*m_table);
    m_table->setColumnHidden(ChangeModel::ProfileColumn, board.identity().profileCount <= 1);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setSectionResizeMode(ChangeModel::NameColumn, QHeaderView::Stretch);
    m_risk->setObjectName(u"warning"_s);
    m_risk->setWordWrap(true);
    m_riskText = tr("⚠ Some of these values are in the risk class. They act at once where motors run, "
                    "otherwise when they start: hold the camera, or take it off.");
    m_doubts->setWordWrap(true);
    m_effect->setWordWrap(true);
    m_othersText->setObjectName(u"warning"_s);
    m_othersText->setWordWrap(true);
    m_others->setAccessibleName(tr("Other values in use"));
    m_others->addItem(tr("Leave them in use, without storing them"), int(OtherValues::Keep));
    m_others->addItem(tr("Store them too"), int(OtherValues::Store));
    m_others->addItem(tr("Put the stored values into use first"), int(OtherValues::PutBack));
    auto *missing = new QLabel;
    missing->setObjectName(u"muted"_s);
    missing->setWordWrap(true);
    missing->setVisible(!board.missing().empty());
    missing->setText(
        tr("Not compared, because it could not be read: %1.").arg(missingText(board, board.missing())));
    auto *back = new QPushButton(tr("Back"));
    auto *buttons = new QHBoxLayout;
    buttons->setSpacing(Metric::kGap);
    buttons->addStretch(1);
    buttons->addWidget(back);
    buttons->addWidget(m_write);
    for (QPushButton *button : {m_write, back})
        button->setAutoDefault(false);
    connect(m_write, &QPushButton::clicked, this, &QDialog::accept);
    connect(back, &QPushButton::clicked, this, &QDialog::reject);

    makeLines(board, edited);
    resize(m_lines ? kSizeWithLines : kSize);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(Metric::kMargin, Metric::kMargin, Metric::kMargin, Metric::kMargin);
    layout->setSpacing(Metric::kGap);
    layout->addWidget(intro);
    layout->addWidget(m_table, 1);
    if (m_lines)
        layout->addWidget(m_lines, 2);
    layout->addWidget(m_doubts);
    layout->addWidget(m_risk);
    layout->addWidget(m_effect);
    layout->addWidget(m_othersText);
    layout->addWidget(m_others, 0, Qt::AlignLeft);
    layout->addWidget(missing);
    layout->addLayout(buttons);
    connect(&m_changes, &ChangeModel::ticksChanged, this, &ReviewDialog::updateButton);
    updateButton();
    m_table->setFocus();
    m_table->selectRow(0);
}

// What changes in texts, that they differ says too little.
void ReviewDialog::makeLines(const Configuration &board, const Configuration &edited)
{
    for (const DataChange &change : board.dataChangesTo(edited)) {
        if (!change.spec->isText() || board.findMissing(change.key))
            continue;
        if (!m_lines) {
            m_lines = new QPlainTextEdit;
            m_lines->setReadOnly(true);
            m_lines->setTabChangesFocus(true);
            m_lines->setLineWrapMode(QPlainTextEdit::NoWrap);
            m_lines->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
            m_lines->setTabStopDistance(kTabWidth * m_lines->fontMetrics().horizontalAdvance(u' '));
            m_lines->setAccessibleName(tr("Lines that change"));
        }
        const auto add = [this](const QString &text, bool isChanged) {
            QTextCursor cursor(m_lines->document());
            cursor.movePosition(QTextCursor::End);
            if (!m_lines->document()->isEmpty())
                cursor.insertBlock();
            QTextCharFormat format;
            format.setFontWeight(isChanged ? QFont::Bold : QFont::Normal);
            cursor.insertText(text, format);
        };
        const auto around = aroundChanges(lineDiff(change.from, change.to), kAround);
        const auto told = std::min<std::size_t>(around.size(), kMostLines);
        add(tableText(change.spec->data) + u':', false);
        for (std::size_t i = 0; i < told; ++i)
            add(reviewLine(around[i]),
                around[i].kind == DiffLine::Kind::Added || around[i].kind == DiffLine::Kind::Removed);
        if (told < around.size())
            add(tr("and %n more", nullptr, int(around.size() - told)), false);
    }
    if (m_lines)
        m_lines->moveCursor(QTextCursor::Start);
}

void ReviewDialog::setFlies(bool flies)
{
    if (!flies)
        return;
    m_riskText = tr("⚠ Some of these values are in the risk class: with a wrong one the drone swings at "
                    "once when it is armed. Try them with the propellers off, or in a test stand.");
    updateButton();
}

void ReviewDialog::setTextLeaps(const std::vector<ParameterChange> &leaps)
{
    m_textLeaps = leaps;
    updateButton();
}

QString ReviewDialog::riskText() const
{
    return m_risk->text();
}

// Whoever has slipped by a digit sees it here at the latest.
QString ReviewDialog::leapsText() const
{
    auto leaps = m_changes.tickedLeaps();
    leaps.insert(leaps.end(), m_textLeaps.begin(), m_textLeaps.end());
    QStringList texts;
    for (const ParameterChange &leap : leaps)
        texts.append(leapText(leap));
    return texts.join(u'\n');
}

void ReviewDialog::setDoubtsOf(const DoubtsOf &doubtsOf)
{
    m_doubtsOf = doubtsOf;
    updateButton();
}

QString ReviewDialog::doubts() const
{
    return m_doubts->text();
}

bool ReviewDialog::showDoubts()
{
    const bool isAsked = m_doubtsOf && m_changes.hasTickedText();
    m_doubts->setVisible(isAsked);
    const std::vector<ScriptMistake> found = isAsked ? m_doubtsOf(chosen()) : std::vector<ScriptMistake>();
    QStringList lines;
    for (std::size_t i = 0; i < std::min(found.size(), kMostDoubts); ++i) {
        const QString text = found[i].sentence(tableText(found[i].what));
        lines.append(found[i].line > 0 ? tr("Line %1: %2.").arg(QString::number(found[i].line), text)
                                       : tr("%1.").arg(text));
    }
    if (found.size() > kMostDoubts)
        lines.append(tr("and %n more", nullptr, int(found.size() - kMostDoubts)));
    m_doubts->setText(found.empty()
                          ? tr("Read without running it, nothing was found against the text. That does not "
                               "prove that the board starts or flies with it.")
                          : tr("⚠ This speaks against the text:") + u'\n' + lines.join(u'\n'));
    m_doubts->setObjectName(found.empty() ? u"muted"_s : u"warning"_s);
    repolish(m_doubts);
    return !found.empty();
}

void ReviewDialog::updateButton()
{
    const int count = m_changes.tickedCount();
    const int profiles = m_changes.tickedProfiles();
    const QString values = tr("%n value(s)", nullptr, count);
    m_write->setText(profiles > 1 ? tr("Write %1 to %2 profiles").arg(values).arg(profiles)
                                  : tr("Write %1").arg(values));
    m_write->setEnabled(count > 0);
    QStringList effects;
    if (m_changes.hasTicked(WriteEffect::Restarts))
        effects.append(tr("The board restarts when they are written."));
    if (m_changes.hasTicked(WriteEffect::Volatile))
        effects.append(tr("Some of them are in use only until the board restarts."));
    m_effect->setText(effects.join(u' '));
    m_effect->setVisible(!effects.isEmpty());
    updateOthers();
    const bool isRed = m_changes.hasTickedRed();
    const QString leaps = leapsText();
    m_risk->setText(leaps.isEmpty() ? m_riskText : leaps + u'\n' + m_riskText);
    m_risk->setVisible(isRed);
    const bool red = showDoubts() || isRed;
    m_write->setDefault(!red);  // what may start motors the wrong way takes more than one key
    m_write->setObjectName(red ? u"danger"_s : u"primary"_s);
    repolish(m_write);
}

void ReviewDialog::setReplaced(const LiveValues &replaced)
{
    if (replaced.empty())
        return;
    m_live = replaced;
    m_areReplaced = true;
    updateOthers();
}

OtherValues ReviewDialog::others() const
{
    return OtherValues(m_others->currentData().toInt());
}

// What else is in use is said before: the board stores all of it at once, or loads what is stored instead.
void ReviewDialog::updateOthers()
{
    const auto written = std::as_const(m_changes).ticked();
    QStringList values;
    for (const LiveValue &value : m_live) {
        const ParameterSpec *spec = written.parameters().find(value.key);
        if (!spec || !sameValue(written.raw(*spec, written.activeProfile()), value.stored))
            continue;  // it is written anyway
        values.append(tr("%1: %2 in use, %3 stored")
                          .arg(parameterLabel(*spec), parameterValueText(*spec, value.inUse),
                               parameterValueText(*spec, value.stored)));
    }
    constexpr qsizetype kTold = 6;
    const auto more = int(values.size() - kTold);
    const auto count = int(values.size());
    QString text
        = (m_areReplaced
               ? tr("%n other value(s) in use are not stored; the board goes back to the stored ones:",
                    nullptr, count)
               : tr("%n other value(s) in use are not stored:", nullptr, count))
        + u'\n' + values.mid(0, kTold).join(u'\n');
    if (more > 0)
        text += u'\n' + tr("and %n more", nullptr, more);
    m_othersText->setText(text);
    m_othersText->setVisible(!values.isEmpty());
    m_others->setVisible(!values.isEmpty() && !m_areReplaced);
}
