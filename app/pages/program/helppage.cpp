// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/pages/program/helppage.h"

#include <QFile>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QShortcut>
#include <QTextBrowser>
#include <QTextTable>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace {

constexpr int kCellPadding = 6;
constexpr int kTopicRole = Qt::UserRole;
constexpr int kTextRole = Qt::UserRole + 1;

// The text in the program's language, in English where there is none.
QString helpText(const QString &topic)
{
    // Translators set this to the folder of their help texts.
    const QString folder = HelpPage::tr("en", "folder of the help texts");
    for (const QString &language : {folder, u"en"_s}) {
        QFile file(u":/help/%1/%2.md"_s.arg(language, topic));
        if (file.open(QIODevice::ReadOnly))
            return QString::fromUtf8(file.readAll());
    }
    return {};
}

// Tables of Markdown come without lines, and without room between their cells.
void ruleTables(QTextDocument &document, const QColor &color)
{
    for (QTextFrame *frame : document.rootFrame()->childFrames()) {
        auto *table = qobject_cast<QTextTable *>(frame);
        if (!table)
            continue;
        QTextTableFormat format = table->format();
        format.setCellPadding(kCellPadding);
        format.setCellSpacing(0);
        format.setBorder(1);
        format.setBorderCollapse(true);
        format.setBorderStyle(QTextFrameFormat::BorderStyle_Solid);
        format.setBorderBrush(color);
        table->setFormat(format);
    }
}

}  // namespace

QStringList HelpPage::allTopics()
{
    return {u"start"_s,      u"dashboard"_s,  u"monitor"_s, u"camera"_s,      u"debug"_s,
            u"parameters"_s, u"profiles"_s,   u"setup"_s,   u"calibration"_s, u"signals"_s,
            u"guide"_s,      u"sensor"_s,     u"scripts"_s, u"scriptslots"_s, u"documents"_s,
            u"backups"_s,    u"wholeboard"_s, u"tuning"_s,  u"spectrum"_s,    u"response"_s,
            u"autotune"_s,   u"variables"_s,  u"control"_s, u"flight"_s,      u"actions"_s,
            u"bench"_s,      u"console"_s,    u"gamepad"_s, u"system"_s,      u"recordings"_s,
            u"blackbox"_s,   u"settings"_s};
}

HelpPage::HelpPage(Workspace &workspace, std::function<bool(const QString &key)> isOffered, QWidget *parent)
    : Page(workspace, u"help"_s, tr("Help"), parent)
    , m_isOffered(std::move(isOffered))
    , m_search(new QLineEdit)
    , m_topics(new QListWidget)
    , m_text(new QTextBrowser)
{
    m_search->setPlaceholderText(tr("Search all texts (Ctrl+F)"));
    m_search->setAccessibleName(tr("Search help"));
    m_search->setClearButtonEnabled(true);
    m_search->setMinimumWidth(220);
    header()->addWidget(m_search);
    m_topics->setAccessibleName(tr("Topics"));
    m_topics->setFixedWidth(230);
    m_text->setAccessibleName(tr("Help text"));
    m_text->setOpenExternalLinks(false);
    m_text->document()->setDocumentMargin(20);
    for (const QString &topic : allTopics()) {
        const QString text = helpText(topic);
        auto *item = new QListWidgetItem(text.section(u'\n', 0, 0).remove(u'#').trimmed(), m_topics);
        item->setData(kTopicRole, topic);
        item->setData(kTextRole, text);
    }
    auto *row = new QHBoxLayout;
    row->setSpacing(12);
    row->addWidget(m_topics);
    row->addWidget(m_text, 1);
    body()->addLayout(row, 1);
    connect(m_topics, &QListWidget::currentRowChanged, this, &HelpPage::showCurrent);
    connect(m_search, &QLineEdit::textChanged, this, &HelpPage::refilter);
    new QShortcut(QKeySequence::Find, this, [this] { m_search->setFocus(); });
    connect(&workspace.configuration(), &ConfigurationModel::boardReset, this, &HelpPage::refilter);
    connect(&workspace.client(), &DeviceClient::stateChanged, this, &HelpPage::refilter);
    m_topics->setCurrentRow(0);
    refilter();
}

void HelpPage::showTopic(const QString &key)
{
    m_search->clear();
    const qsizetype row = allTopics().indexOf(key);
    m_topics->setCurrentRow(int(std::max<qsizetype>(0, row)));
}

QString HelpPage::topic() const
{
    return m_topics->currentItem() ? m_topics->currentItem()->data(kTopicRole).toString() : QString();
}

void HelpPage::showCurrent()
{
    if (m_topics->currentItem())
        m_text->setMarkdown(m_topics->currentItem()->data(kTextRole).toString());
    ruleTables(*m_text->document(), palette().color(QPalette::Mid));
    const QString words = m_search->text().trimmed();
    if (!words.isEmpty())
        m_text->find(words.section(u' ', 0, 0));
}

void HelpPage::refilter()
{
    const auto words = m_search->text().toLower().split(u' ', Qt::SkipEmptyParts);
    int first = -1;
    for (int i = 0; i < m_topics->count(); ++i) {
        const QString text = m_topics->item(i)->data(kTextRole).toString().toLower();
        const bool match = std::all_of(words.begin(), words.end(),
                                       [&text](const QString &word) { return text.contains(word); });
        const QString topic = m_topics->item(i)->data(kTopicRole).toString();
        const bool listed = match && (topic == u"start"_s || m_isOffered(topic));
        m_topics->item(i)->setHidden(!listed);
        if (listed && first < 0)
            first = i;
    }
    if (first >= 0 && (!m_topics->currentItem() || m_topics->currentItem()->isHidden()))
        m_topics->setCurrentRow(first);
    showCurrent();
}
