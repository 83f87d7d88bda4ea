// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/tour.h"

#include "app/mainwindow/mainwindow.h"
#include "app/pages/parameterspage.h"
#include "widgets/forms/reviewdialog.h"

#include <QDir>

using namespace Qt::StringLiterals;

namespace {

// Long enough for traces to fill their windows and for the board to settle.
constexpr auto kSettle = 6s;
constexpr auto kBetween = 1500ms;
constexpr auto kLimit = 60s;

} // namespace

Tour::Tour(MainWindow &window, QString folder, QString suffix, QObject *parent)
    : QObject(parent)
    , m_window(window)
    , m_folder(std::move(folder))
    , m_suffix(std::move(suffix))
{
    m_step.setSingleShot(true);
    connect(&m_step, &QTimer::timeout, this, &Tour::next);
    m_limit.setSingleShot(true);
    connect(&m_limit, &QTimer::timeout, this, [this] { fail(u"the simulated board did not come alive"_s); });
    m_limit.start(kLimit);
    if (!QDir().mkpath(m_folder)) {
        QTimer::singleShot(0, this, [this] { fail(u"cannot make the folder %1"_s.arg(m_folder)); });
        return;
    }
    QTimer::singleShot(300, this, [this] { save(&m_window, u"start"_s); });
    connect(&m_window.workspace(), &Workspace::boardRead, this, [this] {
        if (m_stage < 0) {
            m_stage = 0;
            m_window.showPage(u"monitor"_s);
            m_step.start(kSettle);
        }
    });
}

void Tour::fail(const QString &error)
{
    m_step.stop();
    emit finished({}, error);
}

bool Tour::save(QWidget *widget, const QString &name)
{
    const QString path = QDir(m_folder).filePath(name + m_suffix + u".png"_s);
    if (!widget->grab().save(path)) {
        fail(u"cannot write %1"_s.arg(path));
        return false;
    }
    m_pictures.append(path);
    return true;
}

void Tour::next()
{
    m_limit.start(kLimit);
    // The monitor was shown while everything settled; then each page in its turn, then edits and their review.
    switch (m_stage++) {
    case 0:
        if (!save(&m_window, u"monitor"_s))
            return;
        m_window.showPage(u"dashboard"_s);
        break;
    case 1:
        if (!save(&m_window, u"dashboard"_s))
            return;
        m_window.showPage(u"parameters"_s);
        break;
    case 2: {
        if (!save(&m_window, u"parameters"_s))
            return;
        EditStack &edits = m_window.workspace().edits();
        ConfigurationModel &model = m_window.workspace().configuration();
        const auto change = [&](const QString &key, int profile, int raw) {
            if (const ParameterSpec *spec = model.edited().parameters().find(key))
                edits.edit(spec->id, profile, raw);
        };
        const int profile = model.shownProfile();
        change(u"pid.roll.p"_s, profile, 42);
        change(u"pid.roll.d"_s, profile, 36);
        change(u"motor.yaw.power"_s, profile, 170);
        change(u"follow.yaw.speed"_s, 1, 40);
        static_cast<ParametersPage *>(m_window.page(u"parameters"_s))->showParameter(u"pid.roll.p"_s);
        break;
    }
    case 3:
        if (!save(&m_window, u"parameters-edited"_s))
            return;
        m_window.review();
        break;
    case 4:
        if (m_window.reviewDialog() && !save(m_window.reviewDialog(), u"review"_s))
            return;
        if (m_window.reviewDialog())
            m_window.reviewDialog()->accept();
        break;
    case 5:
        if (!save(&m_window, u"written"_s))
            return;
        break;
    default:
        m_limit.stop();
        emit finished(m_pictures, {});
        return;
    }
    m_step.start(kBetween);
}
