// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tour/tourrunner.h"

#include <QCoreApplication>
#include <QProcessEnvironment>

#include <array>

using namespace Qt::StringLiterals;

namespace {

struct Look
{
    const char *theme;
    const char *scale;
};
constexpr std::array<Look, 4> kLooks{{{"light", "1"}, {"dark", "1"}, {"light", "2"}, {"dark", "2"}}};

}  // namespace

TourRunner::TourRunner(QString folder, QStringList moreArguments, QObject *parent)
    : QObject(parent)
    , m_folder(std::move(folder))
    , m_more(std::move(moreArguments))
{
    m_process.setProcessChannelMode(QProcess::SeparateChannels);
    connect(&m_process, &QProcess::finished, this, [this](int code, QProcess::ExitStatus status) {
        m_paths += QString::fromLocal8Bit(m_process.readAllStandardOutput());
        if (code != 0 || status != QProcess::NormalExit) {
            emit finished(m_paths, QString::fromLocal8Bit(m_process.readAllStandardError()).trimmed());
            return;
        }
        ++m_at;
        next();
    });
    connect(&m_process, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
        if (error == QProcess::FailedToStart)
            emit finished(m_paths, m_process.errorString());
    });
}

void TourRunner::start()
{
    next();
}

void TourRunner::next()
{
    if (std::size_t(m_at) >= kLooks.size()) {
        emit finished(m_paths, {});
        return;
    }
    const Look &look = kLooks[std::size_t(m_at)];
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(u"QT_SCALE_FACTOR"_s, QLatin1String(look.scale));
    m_process.setProcessEnvironment(environment);
    m_process.start(
        QCoreApplication::applicationFilePath(),
        QStringList{u"--tour"_s, m_folder, u"--everything"_s, u"--theme"_s, QLatin1String(look.theme)}
            + m_more);
}
