// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/liveline.h"

#include <QTextStream>

#include <sys/ioctl.h>
#include <unistd.h>

using namespace Qt::StringLiterals;

namespace {

constexpr auto kBetweenLines = 1s;
constexpr int kUsualColumns = 80;

int columnsOfTerminal()
{
    winsize size{};
    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : kUsualColumns;
}

}  // namespace

LiveLine::LiveLine(QTextStream &err)
    : m_err(err)
    , m_isTerminal(isatty(STDERR_FILENO) == 1)
{
}

void LiveLine::show(const QString &text)
{
    if (text.isEmpty() || text == m_text)
        return;
    const TimePoint now = Clock::now();
    if (!m_isTerminal && m_writtenAt && now - *m_writtenAt < kBetweenLines)
        return;
    m_text = text;
    m_writtenAt = now;
    m_isShown = m_isTerminal;
    // What is wider than the terminal would go on in the next line, which nobody takes away.
    if (m_isTerminal)
        m_err << "\r\x1b[K" << text.left(columnsOfTerminal() - 1);
    else
        m_err << text << "\n";
    m_err.flush();
}

void LiveLine::clear()
{
    if (m_isShown)
        m_err << "\r\x1b[K";
    m_isShown = false;
    m_text.clear();
}
