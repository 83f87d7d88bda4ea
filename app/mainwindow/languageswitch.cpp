// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/languageswitch.h"

#include "app/workspace/settings.h"

#include <chrono>

using namespace std::chrono_literals;

namespace {

constexpr auto kLookAgain = 50ms;

}  // namespace

LanguageSwitch::LanguageSwitch(Settings &settings, std::function<bool()> isFree, QObject *parent)
    : QObject(parent)
    , m_settings(settings)
    , m_isFree(std::move(isFree))
    , m_language(settings.language())
{
    m_wait.setInterval(kLookAgain);
    connect(&m_wait, &QTimer::timeout, this, &LanguageSwitch::look);
    // Never at once: what was chosen is told by a page that would be gone before it has finished telling.
    connect(&settings, &Settings::changed, this, [this] {
        if (m_settings.language() != m_language)
            m_wait.start();
    });
}

void LanguageSwitch::look()
{
    const QString wanted = m_settings.language();
    if (wanted != m_language && !m_isFree())
        return;
    m_wait.stop();
    if (std::exchange(m_language, wanted) != wanted)
        emit due(wanted);
}
