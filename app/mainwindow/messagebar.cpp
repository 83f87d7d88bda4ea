// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/messagebar.h"

#include "app/mainwindow/messagerow.h"
#include "widgets/forms/clickshield.h"
#include "widgets/theme/theme.h"

#include <QCursor>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kNoticeTime = 8s;
constexpr auto kPointerPause = 1s;
constexpr int kMostAttention = 3;  // notices that stay

}  // namespace

MessageBar::MessageBar(QWidget *parent)
    : QFrame(parent)
    , m_layout(new QVBoxLayout(this))
{
    setObjectName(u"messageBar"_s);
    m_layout->setContentsMargins(12, Metric::kGap, Metric::kGap, Metric::kGap);
    m_layout->setSpacing(Metric::kGap);
    m_hide.setSingleShot(true);
    connect(&m_hide, &QTimer::timeout, this, &MessageBar::closeTransient);
    hide();
}

template <typename Predicate> void MessageBar::removeIf(Predicate predicate)
{
    for (Shown &message : m_messages) {
        if (!predicate(message))
            continue;
        // Its own button may be what closes it.
        message.row->hide();
        message.row->setParent(nullptr);
        std::exchange(message.row, nullptr)->deleteLater();
    }
    std::erase_if(m_messages, [](const Shown &message) { return !message.row; });
}

void MessageBar::add(const Message &message)
{
    auto *row = new MessageRow(message.text, message.notice, message.circumstances);
    m_layout->addWidget(row);
    row->show();  // a layout would do so later, and be measured before
    connect(row, &MessageRow::closed, this, [this, row] {
        // The second click in a hurry would meet the row that has come up.
        new ClickShield(*this);
        remove(row);
    });
    m_messages.push_back({message, row});
    update();
}

void MessageBar::remove(const MessageRow *row)
{
    removeIf([row](const Shown &message) { return message.row == row; });
    update();
}

void MessageBar::update()
{
    const bool severe
        = std::any_of(m_messages.begin(), m_messages.end(), [](const Message &each) { return !each.notice; });
    const bool warns = std::any_of(m_messages.begin(), m_messages.end(),
                                   [](const Message &each) { return each.notice == Notice::Attention; });
    if (property("severe") != severe || property("warns") != warns) {
        setProperty("severe", severe);
        setProperty("warns", warns);
        repolish(this);
    }
    setVisible(!m_messages.empty());
}

void MessageBar::showProblem(const ErrorText &text, Concern concern, const QString &circumstances)
{
    // Of a concern of its own may stand several; the same twice says no more.
    removeIf([&text, concern](const Message &message) {
        return !message.notice && message.concern == concern
            && (concern == Concern::None || message.text.oneLine() == text.oneLine());
    });
    add({text, concern, circumstances, std::nullopt});
}

void MessageBar::showNotice(const QString &text, Notice kind, Concern concern, const QString &motors)
{
    int attention = kind == Notice::Attention ? 1 : 0;
    for (const Message &message : m_messages)
        attention += message.notice == Notice::Attention ? 1 : 0;
    removeIf([&](const Message &message) {
        if (!message.notice)
            return false;
        const bool isTooMuch = message.notice == Notice::Attention && attention > kMostAttention;
        attention -= isTooMuch ? 1 : 0;
        return isTooMuch || message.notice != Notice::Attention || message.text.what == text;
    });
    add({ErrorText{text, {}, {}, {}, motors}, concern, {}, kind});
    if (kind != Notice::Attention)
        m_hide.start(kNoticeTime);
}

void MessageBar::closeTransient()
{
    // Not from under the pointer, which may be on its way to a button of it.
    if (rect().contains(mapFromGlobal(QCursor::pos()))) {
        m_hide.start(kPointerPause);
        return;
    }
    removeIf([](const Message &message) { return message.notice && message.notice != Notice::Attention; });
    update();
}

void MessageBar::withdraw(Concern concern)
{
    removeIf([concern](const Message &message) { return message.concern == concern; });
    for (Shown &message : m_messages) {
        if (concern == Concern::Motors && !message.text.motors.isEmpty()) {
            message.text.motors.clear();
            message.row->setText(message.text);
        }
    }
    update();
}

void MessageBar::keepOnly(const QList<Concern> &concerns)
{
    removeIf([&concerns](const Message &message) {
        return message.notice || !concerns.contains(message.concern);
    });
    update();
}

void MessageBar::closeNewest()
{
    if (!m_messages.empty())
        remove(m_messages.back().row);
}

QList<MessageBar::Message> MessageBar::messages() const
{
    return {m_messages.begin(), m_messages.end()};
}

void MessageBar::show(const QList<Message> &messages)
{
    for (const Message &message : messages)
        add(message);
    m_hide.start(kNoticeTime);
}

void MessageBar::setVisible(bool visible)
{
    if (!visible)
        removeIf([](const Message &) { return true; });
    QFrame::setVisible(visible);
}

QString MessageBar::text() const
{
    QStringList lines;
    for (const Message &message : m_messages)
        lines.append(message.text.oneLine());
    return lines.join(u'\n');
}
