// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/messagerow.h"

#include "widgets/theme/theme.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

QString messageSign(std::optional<Notice> kind)
{
    if (!kind)
        return u"✖ "_s;
    switch (*kind) {
    case Notice::Done: return u"✓ "_s;
    case Notice::Hint: return u"ℹ "_s;
    case Notice::Attention: return u"⚠ "_s;
    }
    return {};
}

MessageRow::MessageRow(const ErrorText &text, std::optional<Notice> kind, const QString &circumstances,
                       QWidget *parent)
    : QWidget(parent)
    , m_text(new QLabel)
    , m_detail(new QLabel)
    , m_more(new QToolButton)
    , m_copy(new QToolButton)
    , m_close(new QToolButton)
    , m_kind(kind)
    , m_circumstances(circumstances)
{
    m_detail->setObjectName(u"muted"_s);
    m_detail->setWordWrap(true);
    m_detail->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_detail->hide();
    m_more->setText(tr("Details"));
    m_more->setCheckable(true);
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::RichText);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_copy->setText(tr("Copy"));
    m_copy->setToolTip(tr("Copy everything that technical support needs"));
    m_close->setText(u"✕"_s);
    m_close->setAccessibleName(tr("Close message"));
    m_close->setToolTip(tr("Close (Esc); Ctrl+F6 leads here and back"));
    auto *layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    auto *texts = new QVBoxLayout;
    texts->setSpacing(Metric::kUnit);
    texts->addWidget(m_text);
    texts->addWidget(m_detail);
    layout->addLayout(texts, 1);
    // At the top: they stay where they are when details unfold.
    for (QToolButton *button : {m_more, m_copy, m_close})
        layout->addWidget(button, 0, Qt::AlignTop);
    connect(m_more, &QToolButton::toggled, m_detail, &QWidget::setVisible);
    connect(m_copy, &QToolButton::clicked, this, [this] { QGuiApplication::clipboard()->setText(m_full); });
    connect(m_close, &QToolButton::clicked, this, &MessageRow::closed);
    setText(text);
}

void MessageRow::setText(const ErrorText &text)
{
    m_full = text.oneLine();
    if (!m_circumstances.isEmpty())
        m_full += u'\n' + m_circumstances;
    QString html = messageSign(m_kind) + text.what.toHtmlEscaped();
    if (!m_kind)
        html = u"<b>%1</b>"_s.arg(html);
    for (const QString &part : {text.meaning, text.motors, text.cure}) {
        if (!part.isEmpty())
            html += u' ' + part.toHtmlEscaped();
    }
    m_text->setText(html);
    m_detail->setText(text.detail.trimmed());
    m_more->setVisible(!m_detail->text().isEmpty());
    m_detail->setVisible(!m_detail->text().isEmpty() && m_more->isChecked());
    m_copy->setVisible(!m_kind);
}
