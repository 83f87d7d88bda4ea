// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDirIterator>
#include <QFile>
#include <QMap>
#include <QRegularExpression>
#include <QTest>

using namespace Qt::StringLiterals;

namespace {

// Which folders each folder may include (beside itself). The house plan, as a test.
const QMap<QString, QStringList> &allowed()
{
    static const QStringList device{u"protocol/base"_s, u"protocol/analysis"_s, u"protocol/transport"_s,
                                    u"protocol/session"_s};
    static const QStringList family = device + QStringList{u"protocol/device"_s};
    static const QStringList shown{u"protocol/base"_s, u"protocol/device"_s, u"protocol/analysis"_s};
    static const QMap<QString, QStringList> table{
        {u"protocol/base"_s, {}},
        {u"protocol/analysis"_s, {u"protocol/base"_s}},
        {u"protocol/transport"_s, {u"protocol/base"_s}},
        {u"protocol/session"_s, {u"protocol/base"_s, u"protocol/transport"_s}},
        {u"protocol/device"_s, device},
        {u"protocol/simplebgc"_s, family},
        {u"protocol/mavlink"_s, {u"protocol/base"_s}},
        {u"protocol/storm32"_s, family + QStringList{u"protocol/mavlink"_s}},
        {u"protocol/record"_s, family},
        {u"protocol/procedure"_s, family + QStringList{u"protocol/record"_s}},
        {u"protocol/simulator"_s,
         family + QStringList{u"protocol/simplebgc"_s, u"protocol/storm32"_s, u"protocol/mavlink"_s}},
        // Progress reports reach the screen through the channel's header; everything else stays behind the
        // client.
        {u"widgets/models"_s, shown + QStringList{u"protocol/session/channel.h"_s}},
        {u"widgets/theme"_s, {u"protocol/base"_s}},
        {u"widgets/forms"_s, shown + QStringList{u"widgets/models"_s, u"widgets/theme"_s}},
        {u"widgets/plot"_s, shown + QStringList{u"widgets/models"_s, u"widgets/theme"_s}},
        {u"widgets/views"_s, shown + QStringList{u"widgets/models"_s, u"widgets/theme"_s}},
    };
    return table;
}

struct Source
{
    QString path;
    QString text;
};

QList<Source> sources(const QStringList &roots)
{
    QList<Source> list;
    for (const QString &root : roots) {
        QDirIterator it(QStringLiteral(GIMBAL_SOURCE_DIR "/") + root, {u"*.h"_s, u"*.cpp"_s}, QDir::Files,
                        QDirIterator::Subdirectories);
        while (it.hasNext()) {
            QFile file(it.next());
            if (file.open(QIODevice::ReadOnly)) {
                list.append({QDir(QStringLiteral(GIMBAL_SOURCE_DIR)).relativeFilePath(file.fileName()),
                             QString::fromUtf8(file.readAll())});
            }
        }
    }
    return list;
}

QStringList includesOf(const Source &source)
{
    static const QRegularExpression include(u"^\\s*#\\s*include\\s*[\"<]([^\">]+)[\">]"_s,
                                            QRegularExpression::MultilineOption);
    QStringList list;
    auto it = include.globalMatch(source.text);
    while (it.hasNext())
        list.append(it.next().captured(1));
    return list;
}

QString folderOf(const QString &path)
{
    return path.section(u'/', 0, 1);
}

}  // namespace

class TestArchitecture : public QObject
{
    Q_OBJECT
private slots:
    void floorsAreKept();
    void protocolNeedsNoScreen();
    void widgetsNameNoFamily();
    void filesAreOfReadableLength();
    void everyFileNamesItsLicence();
    void nothingBlocksOutsideTheWorker();
    void theTestItselfFindsViolations();
};

void TestArchitecture::floorsAreKept()
{
    const auto all = sources({u"protocol"_s, u"widgets"_s});
    QVERIFY(all.size() > 60);
    for (const Source &source : all) {
        const QString folder = folderOf(source.path);
        QVERIFY2(allowed().contains(folder),
                 qPrintable(source.path + u" lies in a folder without a floor"_s));
        for (const QString &include : includesOf(source)) {
            if (!include.contains(u'/') || include.startsWith(u"sys/"_s) || include.startsWith(u"asm/"_s)
                || include.startsWith(u"tl/"_s))
                continue;
            // Linear algebra and transforms are the business of one floor.
            if (include.contains(u"Eigen/"_s) && folder == u"protocol/analysis"_s)
                continue;
            // The editor component is the business of one floor.
            if (include.startsWith(u"Qsci/"_s) && folder == u"widgets/views"_s)
                continue;
            const QString target = folderOf(include);
            const bool ok = target == folder || allowed()[folder].contains(target)
                || allowed()[folder].contains(include);
            QVERIFY2(ok, qPrintable(u"%1 includes %2"_s.arg(source.path, include)));
        }
    }
}

void TestArchitecture::protocolNeedsNoScreen()
{
    static const QRegularExpression screen(
        u"^Q(Widget|Application|GuiApplication|Chart|Settings|Painter|Color|Icon|Dialog)$"_s);
    for (const Source &source : sources({u"protocol"_s, u"widgets/models"_s})) {
        for (const QString &include : includesOf(source))
            QVERIFY2(!screen.match(include).hasMatch(), qPrintable(source.path + u" includes "_s + include));
    }
}

void TestArchitecture::widgetsNameNoFamily()
{
    static const QRegularExpression family(u"simplebgc|sbgc|storm32|bcflight|mavlink"_s,
                                           QRegularExpression::CaseInsensitiveOption);
    for (const Source &source : sources({u"widgets"_s}))
        QVERIFY2(!family.match(source.text).hasMatch() || source.path.endsWith(u"errortext.cpp"_s),
                 qPrintable(source.path + u" names a family"_s));
}

void TestArchitecture::filesAreOfReadableLength()
{
    for (const Source &source : sources({u"protocol"_s, u"widgets"_s, u"app"_s})) {
        const qsizetype lines = source.text.count(u'\n');
        QVERIFY2(lines <= 650, qPrintable(u"%1 has %2 lines"_s.arg(source.path).arg(lines)));
    }
    QFile window(QStringLiteral(GIMBAL_SOURCE_DIR "/app/mainwindow/mainwindow.cpp"));
    QVERIFY(window.open(QIODevice::ReadOnly));
    QVERIFY(window.readAll().count('\n') < 400);
}

void TestArchitecture::everyFileNamesItsLicence()
{
    for (const Source &source : sources({u"protocol"_s, u"widgets"_s, u"app"_s, u"tests"_s}))
        QVERIFY2(source.text.contains(u"SPDX-License-Identifier: GPL-3.0-or-later"_s),
                 qPrintable(source.path));
}

void TestArchitecture::nothingBlocksOutsideTheWorker()
{
    static const QRegularExpression blocking(
        u"processEvents|QEventLoop|waitForReadyRead|waitForBytesWritten|waitForConnected|QThread::m?u?sleep"_s);
    for (const Source &source : sources({u"protocol"_s, u"widgets"_s, u"app"_s}))
        QVERIFY2(!blocking.match(source.text).hasMatch(), qPrintable(source.path));
}

void TestArchitecture::theTestItselfFindsViolations()
{
    const Source bad{u"widgets/plot/x.cpp"_s, u"#include \"protocol/simplebgc/framer.h\"\n"_s};
    QCOMPARE(includesOf(bad), QStringList{u"protocol/simplebgc/framer.h"_s});
    QVERIFY(!allowed()[folderOf(bad.path)].contains(folderOf(includesOf(bad).first())));
}

QTEST_APPLESS_MAIN(TestArchitecture)
#include "tst_architecture.moc"
