// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tour/tour.h"
#include "tests/support/windowrig.h"

#include <QImage>
#include <QSignalSpy>
#include <QTest>

using namespace Qt::StringLiterals;

/// The picture tour with a STorM32 board (that with a SimpleBGC board is in tst_mainwindow).
class TestTour : public QObject
{
    Q_OBJECT
private slots:
    void storm32HasEveryPicture();
};

void TestTour::storm32HasEveryPicture()
{
    WindowRig rig;
    const QString folder = rig.filePath(u"tour"_s);
    Tour tour(rig.window(), folder, u"-light"_s, Tour::Extent::Everything, u"storm32"_s);
    QSignalSpy finished(&tour, &Tour::finished);
    tour.start();
    QTRY_COMPARE_WITH_TIMEOUT(finished.count(), 1, 200000);
    QCOMPARE(finished.first().at(1).toString(), QString());
    const QStringList pictures = finished.first().at(0).toStringList();
    for (const char *name : {"dashboard",
                             "parameters",
                             "tuning",
                             "control",
                             "calibration",
                             "calibration-six",
                             "calibration-result",
                             "setup",
                             "setup-orientation",
                             "setup-yaw",
                             "setup-done",
                             "scripts",
                             "scripts-wrong",
                             "share",
                             "unstored",
                             "spectrum",
                             "response",
                             "response-armed",
                             "review",
                             "backups",
                             "console",
                             "variables"}) {
        const QString path = folder + u"/storm32-"_s + QLatin1String(name) + u"-light.png"_s;
        QVERIFY2(pictures.contains(path) && !QImage(path).isNull(), name);
    }
}

QTEST_MAIN(TestTour)
#include "tst_tour.moc"
