// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/translations.h"
#include "app/pages/tune/spectrumpage.h"
#include "tests/support/patience.h"
#include "tests/support/windowrig.h"
#include "widgets/theme/theme.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractScrollArea>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QPushButton>
#include <QScrollBar>
#include <QTableWidget>

using namespace Qt::StringLiterals;

/// Everything that can be pressed or filled in has its whole width in the smallest window, in each language,
/// on boards of each family.
class TestSmallest : public QObject
{
    Q_OBJECT
private slots:
    void nothingIsCutAtTheSide_data();
    void nothingIsCutAtTheSide();
    void figuresOfTheSpectrumAreWhole_data() { nothingIsCutAtTheSide_data(); }
    void figuresOfTheSpectrumAreWhole();

private:
    // What is in reach by scrolling sideways is not cut.
    static bool isCut(const QWidget &widget)
    {
        QRect place = widget.rect();
        for (const QWidget *at = &widget; at->parentWidget() && !at->isWindow(); at = at->parentWidget()) {
            place.translate(at->pos());
            const QWidget *parent = at->parentWidget();
            const auto *area = qobject_cast<const QAbstractScrollArea *>(parent->parentWidget());
            if (area && area->viewport() == parent && area->horizontalScrollBar()->maximum() > 0
                && area->horizontalScrollBarPolicy() != Qt::ScrollBarAlwaysOff)
                return false;
            if (place.left() < 0 || place.right() > parent->width())
                return true;
        }
        return false;
    }
};

void TestSmallest::nothingIsCutAtTheSide_data()
{
    QTest::addColumn<QString>("address");
    QTest::addColumn<QString>("language");
    for (const char *family : {"simplebgc", "storm32", "bcflight"}) {
        for (const char *language : {"en", "de"})
            QTest::addRow("%s, %s", family, language)
                << u"sim:"_s + QLatin1String(family) << QString::fromLatin1(language);
    }
}

void TestSmallest::nothingIsCutAtTheSide()
{
    QFETCH(const QString, address);
    QFETCH(const QString, language);
    const Translations texts(language);
    WindowRig rig;
    rig.window().resize(1024, 640);
    QVERIFY(rig.open(address));
    QStringList wrong;
    for (const PageEntry &entry : pageTable()) {
        const QString key = QLatin1String(entry.key);
        if (!rig.window().navigation()->isOffered(key))
            continue;
        QVERIFY(rig.window().showPage(key));
        QVERIFY(rig.isSettled());
        for (const QWidget *widget : rig.window().page(key)->findChildren<QWidget *>()) {
            const bool isUsed = qobject_cast<const QAbstractButton *>(widget)
                || qobject_cast<const QComboBox *>(widget) || qobject_cast<const QAbstractSpinBox *>(widget);
            const bool isNarrow = qobject_cast<const QPushButton *>(widget)
                && widget->width() < widget->minimumSizeHint().width();
            if (isUsed && widget->isVisible() && (isNarrow || isCut(*widget)))
                wrong.append(u"%1: %2 %3"_s.arg(key, QLatin1String(widget->metaObject()->className()),
                                                widget->accessibleName() + widget->objectName()));
        }
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u"; "_s)));
}

void TestSmallest::figuresOfTheSpectrumAreWhole()
{
    QFETCH(const QString, address);
    QFETCH(const QString, language);
    const Translations texts(language);
    WindowRig rig;
    rig.window().resize(1024, 640);
    QVERIFY(rig.open(address));
    // What flies tells no rates before a calibration.
    if (rig.client().roles().calibrated >= 0) {
        const auto done = rig.workspace().perform(u"calibrate.all"_s, {});
        QTRY_VERIFY(done.isFinished());
        QVERIFY(done.result());
    }
    auto *page = rig.page<SpectrumPage>();
    QTRY_VERIFY(page->bands()->item(0, 1) && page->bands()->item(0, 1)->text().contains(u"RMS"_s));
    QVERIFY(rig.isSettled());
    // A weak line has the longest figures.
    const int weakest = page->peaks()->fontMetrics().size(0, u"0.000488 °/s"_s).width();
    QVERIFY(page->peaks()->columnWidth(2) >= weakest + 12);
    for (const QTableWidget *table : {page->bands(), page->peaks()}) {
        for (int column = 0; column < table->columnCount(); ++column) {
            const auto room = [table, column](const QString &text) {
                return table->columnWidth(column) - table->fontMetrics().size(0, text).width();
            };
            const QString title = table->horizontalHeaderItem(column)->text();
            QVERIFY2(room(title) >= 2 * Metric::kGap, qPrintable(title));  // the edges of a title
            for (int row = 0; row < table->rowCount(); ++row) {
                const QString text = table->item(row, column) ? table->item(row, column)->text() : QString();
                QVERIFY2(room(text) >= 12, qPrintable(text));
            }
        }
        QVERIFY(!table->horizontalScrollBar()->isVisible());
    }
}

QTEST_MAIN(TestSmallest)
#include "tst_smallest.moc"
