// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/families/bcflight/benchpage.h"
#include "app/families/simplebgc/scriptslotspage.h"
#include "app/families/simplebgc/wholeboardpage.h"
#include "app/families/storm32/sensorpage.h"
#include "app/pages/board/backupspage.h"
#include "app/pages/board/consolepage.h"
#include "app/pages/setup/documentspage.h"
#include "app/pages/setup/guidepage.h"
#include "app/pages/setup/profilespage.h"
#include "app/pages/setup/scriptspage.h"
#include "app/pages/tune/responsepage.h"
#include "app/pages/watch/monitorpage.h"
#include "app/workspace/filedialogs.h"
#include "tests/support/filedialog.h"
#include "tests/support/named.h"
#include "tests/support/patience.h"
#include "tests/support/toyfamily/toycomposition.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/panel.h"
#include "widgets/views/scripteditor.h"

#include <QDirIterator>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPointer>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalSpy>
#include <QTableWidget>

using namespace Qt::StringLiterals;

namespace {

/// Shows the page and presses that button of it.
template <typename P> void press(WindowRig &rig, const char16_t *button)
{
    named<QPushButton>(rig.page<P>(), QString::fromUtf16(button))->click();
}

/// Chooses that entry of a menu of the Monitor.
void chooseOnMonitor(WindowRig &rig, const char16_t *entry)
{
    for (const QMenu *menu : rig.page<MonitorPage>()->findChildren<QMenu *>()) {
        for (QAction *action : menu->actions()) {
            if (action->text() == QString::fromUtf16(entry))
                action->trigger();
        }
    }
}

void exportSnapshot(WindowRig &rig)
{
    auto *page = rig.page<BackupsPage>();
    rig.workspace().takeSnapshot();
    auto *table = named<QTableWidget>(page, u"Snapshots of this board"_s);
    if (QTest::qWaitFor([table] { return table->rowCount() > 0; }, kPatience))
        table->selectRow(0);
    named<QPushButton>(page, u"Export…"_s)->click();
}

QString written(const QString &path, const QByteArray &text)
{
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
        qFatal("%s cannot be written", qPrintable(path));
    return path;
}

void exportResponse(WindowRig &rig)
{
    QByteArray text = "in;out\n";
    double state = 0;
    unsigned noise = 1;
    for (int i = 0; i < 30000; ++i) {
        noise = noise * 1664525U + 1013904223U;
        const double input = double(noise >> 16) / 65536.0 - 0.5;
        state += (input - state) * 0.016;
        text += QByteArray::number(input) + ';' + QByteArray::number(state) + '\n';
    }
    std::ignore = rig.page<ResponsePage>()->importCsv(written(rig.filePath(u"lag.csv"_s), text));
    press<ResponsePage>(rig, u"Export…");
}

void saveCalibration(WindowRig &rig)
{
    const QString path = written(rig.filePath(u"imu.cal"_s),
                                 "IMUNAME: Imu\nAXZERO: 1\nAYZERO: 2\nAZZERO: 3\nAXSCALE: 8190\n"
                                 "AYSCALE: 8191\nAZSCALE: 8200\nCALIBRATIONMETHOD: 1 point\n");
    std::ignore = rig.page<SensorPage>()->loadFile(path);
    press<SensorPage>(rig, u"Save…");
}

void saveScript(WindowRig &rig)
{
    rig.page<ScriptsPage>()->editor()->setText(u"WAIT 5\n"_s);
    press<ScriptsPage>(rig, u"Save…");
}

void saveOffline(WindowRig &rig)
{
    rig.client().disconnectFromBoard();
    if (QTest::qWaitFor([&rig] { return rig.client().state() == DeviceClient::State::Disconnected; },
                        kPatience))
        QTest::keyClick(&rig.window(), Qt::Key_S, Qt::ControlModifier);
}

void sharePicture(WindowRig &rig)
{
    press<BackupsPage>(rig, u"Share…");
    named<QPushButton>(rig.window().panels()->newest(), u"Save…"_s)->click();
}

/// A place in the sources that asks for a path, and how the operator gets there.
// A slot of a board whose scripts have been read holds a script.
void pressInSlot(WindowRig &rig, const char16_t *button)
{
    QFile script(rig.filePath(u"placed.bin"_s));
    if (!script.open(QIODevice::WriteOnly) || script.write("script") <= 0)
        qFatal("no file");
    script.close();
    rig.client().submit<ActionReply>([path = script.fileName()](Channel &channel, Device &device) {
        return device.perform(channel, u"file.load"_s, {{u"type"_s, 1}, {u"number"_s, 0}, {u"file"_s, path}});
    });
    auto *page = rig.page<ScriptSlotsPage>();
    QVERIFY(QTest::qWaitFor([page] { return named<QPushButton>(page, u"Save…"_s)->isEnabled(); }, kPatience));
    press<ScriptSlotsPage>(rig, button);
}

struct Caller
{
    const char *name;
    const char *place;  // file and title
    bool saves;
    const char *family;
    void (*open)(WindowRig &);
    bool takesAny = false;  // what it is for can only be told from the whole
};

// clang-format off
const Caller kCallers[]{
    {"save by key", "app/mainwindow/mainwindow.cpp Save the configuration", true, "simplebgc", saveOffline},
    {"open by key", "app/mainwindow/mainwindow.cpp Open a configuration or a recording", false, "simplebgc", [](WindowRig &rig) { QTest::keyClick(&rig.window(), Qt::Key_O, Qt::ControlModifier); }},
    {"backup", "app/pages/board/backupspage.cpp Save the configuration", true, "simplebgc", [](WindowRig &rig) { press<BackupsPage>(rig, u"Save to a file…"); }},
    {"load", "app/pages/board/backupspage.cpp Load a configuration", false, "storm32", [](WindowRig &rig) { press<BackupsPage>(rig, u"Load a file…"); }},
    {"snapshot", "app/pages/board/backupspage.cpp Export snapshot", true, "simplebgc", exportSnapshot},
    {"share", "app/pages/board/sharedialog.cpp Save the picture", true, "storm32", sharePicture},
    {"frames", "app/pages/board/consolepage.cpp Save frames", true, "simplebgc", [](WindowRig &rig) { press<ConsolePage>(rig, u"Save…"); }},
    {"record", "app/pages/watch/monitorpage.cpp Record to a file", true, "simplebgc", [](WindowRig &rig) { chooseOnMonitor(rig, u"Record from now on…"); }},
    {"last minutes", "app/pages/watch/monitorpage.cpp Save the last minutes", true, "storm32", [](WindowRig &rig) { chooseOnMonitor(rig, u"Save the last minutes…"); }},
    {"samples", "app/pages/watch/monitorpage.cpp Save samples", true, "simplebgc", [](WindowRig &rig) { chooseOnMonitor(rig, u"Samples as CSV…"); }},
    {"plots", "app/pages/watch/monitorpage.cpp Save picture", true, "simplebgc", [](WindowRig &rig) { chooseOnMonitor(rig, u"Picture…"); }},
    {"import", "app/pages/tune/responsepage.cpp Import a measurement", false, "simplebgc", [](WindowRig &rig) { press<ResponsePage>(rig, u"Import…"); }},
    {"response", "app/pages/tune/responsepage.cpp Export a measurement", true, "simplebgc", exportResponse},
    {"certificate", "app/pages/setup/guidepage.cpp Save the certificate", true, "simplebgc", [](WindowRig &rig) { press<GuidePage>(rig, u"Certificate…"); }},
    {"profile", "app/pages/setup/profilespage.cpp Load a profile", false, "simplebgc", [](WindowRig &rig) { press<ProfilesPage>(rig, u"Load from file…"); }},
    {"all profiles", "app/pages/setup/profilespage.cpp Load all profiles", false, "simplebgc", [](WindowRig &rig) { press<ProfilesPage>(rig, u"Load all profiles…"); }},
    {"profiles", "app/pages/setup/profilespage.cpp Save profiles", true, "simplebgc", [](WindowRig &rig) { press<ProfilesPage>(rig, u"Save to file…"); }},
    {"load script", "app/pages/setup/scriptspage.cpp Load a script", false, "storm32", [](WindowRig &rig) { press<ScriptsPage>(rig, u"Load…"); }},
    {"save script", "app/pages/setup/scriptspage.cpp Save the script", true, "storm32", saveScript},
    {"load calibration", "app/families/storm32/sensorpage.cpp Load a calibration", false, "storm32", [](WindowRig &rig) { press<SensorPage>(rig, u"Load a calibration…"); }},
    {"save calibration", "app/families/storm32/sensorpage.cpp Save the calibration", true, "storm32", saveCalibration},
    {"firmware", "app/families/bcflight/benchcards.cpp Firmware", false, "bcflight", [](WindowRig &rig) { press<BenchPage>(rig, u"Choose a file…"); }, true},
    {"copy of a board", "app/families/simplebgc/copycard.cpp Copy into a file", true, "simplebgc", [](WindowRig &rig) { press<WholeBoardPage>(rig, u"Copy the board…"); }},
    {"board compared", "app/families/simplebgc/copycard.cpp Choose a copy", false, "simplebgc", [](WindowRig &rig) { press<WholeBoardPage>(rig, u"Compare…"); }},
    {"load compiled script", "app/families/simplebgc/scriptslotspage.cpp Load a script", false, "simplebgc", [](WindowRig &rig) { pressInSlot(rig, u"Load…"); }, true},
    {"save compiled script", "app/families/simplebgc/scriptslotspage.cpp Save the script", true, "simplebgc", [](WindowRig &rig) { pressInSlot(rig, u"Save…"); }, true},
    {"load document", "app/pages/setup/documentspage.cpp Load a document", false, "toy", [](WindowRig &rig) { press<DocumentsPage>(rig, u"Load file…"); }},
    {"save document", "app/pages/setup/documentspage.cpp Save the document", true, "toy", [](WindowRig &rig) { press<DocumentsPage>(rig, u"Save file…"); }},
};
// clang-format on

}  // namespace

/// Dialogs for files, opened the operator's way and served by keyboard.
class TestFileDialogs : public QObject
{
    Q_OBJECT
private slots:
    void cleanup() { m_rig.reset(); }
    void eachCallerIsTried();
    void keysServeEachDialog_data();
    void keysServeEachDialog();
    void escClosesIt_data();
    void escClosesIt();
    void whatIsThereIsReplacedOnlyWhenSaid();
    void whatIsNotThereIsSaidInTheDialog();
    void closesWithThePageThatAsked();

private:
    MainWindow &window() { return m_rig->window(); }
    bool open(const QByteArray &family);
    /// Some label says that.
    [[nodiscard]] bool isSaid(const QString &text)
    {
        const auto labels = window().findChildren<QLabel *>();
        return std::any_of(labels.begin(), labels.end(), [&text](const QLabel *label) {
            return label->text().contains(text) || label->toolTip().contains(text);
        });
    }

    std::unique_ptr<WindowRig> m_rig;
};

bool TestFileDialogs::open(const QByteArray &family)
{
    m_rig = family == "toy" ? std::make_unique<WindowRig>(toyLinks(), toyFamilies())
                            : std::make_unique<WindowRig>();
    return m_rig->open(u"sim:"_s + QString::fromLatin1(family)) && m_rig->boardGoesOn(1.0)
        && m_rig->jobsAreDone();
}

// A place that asks for a path and is not in the list above is not tried: it belongs there.
void TestFileDialogs::eachCallerIsTried()
{
    static const QRegularExpression asks(
        u"(?:askSavePath|askOpenPath|askRecording)\\(\\s*(?:this,\\s*)?tr\\(\"([^\"]+)\""_s);
    const QDir root(QStringLiteral(GIMBAL_SOURCE_DIR));
    QStringList found;
    QDirIterator it(root.filePath(u"app"_s), {u"*.cpp"_s}, QDir::Files, QDirIterator::Subdirectories);
    while (it.hasNext()) {
        QFile file(it.next());
        QVERIFY(file.open(QIODevice::ReadOnly));
        auto match = asks.globalMatch(QString::fromUtf8(file.readAll()));
        while (match.hasNext())
            found.append(root.relativeFilePath(file.fileName()) + u' ' + match.next().captured(1));
    }
    found.sort();
    QStringList tried;
    for (const Caller &caller : kCallers)
        tried.append(QString::fromLatin1(caller.place));
    tried.sort();
    QCOMPARE(found.join(u'\n'), tried.join(u'\n'));
}

void TestFileDialogs::keysServeEachDialog_data()
{
    QTest::addColumn<int>("caller");
    for (int i = 0; i < int(std::size(kCallers)); ++i)
        QTest::newRow(kCallers[i].name) << i;
}

void TestFileDialogs::keysServeEachDialog()
{
    QFETCH(int, caller);
    const Caller &site = kCallers[caller];
    QVERIFY(open(site.family));
    const QString path = m_rig->filePath(u"chosen.file"_s);
    if (!site.saves)
        written(path, QByteArray(100000, '\x01'));
    QSignalSpy told(&m_rig->workspace().notifications(), &Notifications::problem);
    site.open(*m_rig);
    const QPointer<QFileDialog> asked = fileDialog();
    QVERIFY(asked);
    QVERIFY(QString::fromLatin1(site.place).endsWith(asked->windowTitle()));
    typePath(path);
    QTRY_VERIFY(!asked);
    if (site.saves)
        QTRY_VERIFY(QFile::exists(path));
    else if (site.takesAny)
        QTRY_VERIFY(isSaid(u"chosen.file"_s));
    else
        QTRY_COMPARE(told.count(), 1);  // that this is no file of that kind
    m_rig->workspace().recorder().stop();
}

void TestFileDialogs::escClosesIt_data()
{
    keysServeEachDialog_data();
}

void TestFileDialogs::escClosesIt()
{
    QFETCH(int, caller);
    QVERIFY(open(kCallers[caller].family));
    kCallers[caller].open(*m_rig);
    const QPointer<QFileDialog> asked = fileDialog();
    QVERIFY(asked);
    const QDialog *panel = window().panels()->newest();
    QTest::keyClick(asked->windowHandle(), Qt::Key_Escape);
    QTRY_VERIFY(!asked);
    QVERIFY(window().panels()->newest() != panel);
}

void TestFileDialogs::whatIsThereIsReplacedOnlyWhenSaid()
{
    QVERIFY(open("simplebgc"));
    const QString path = written(m_rig->filePath(u"there.json"_s), "mine");
    const auto content = [path] {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    };
    for (const QString &answer : {u"Keep it"_s, u"Choose another name…"_s, u"Replace"_s}) {
        press<BackupsPage>(*m_rig, u"Save to a file…");
        QVERIFY(fileDialog());
        typePath(path);
        QTRY_VERIFY(!window().findChild<QFileDialog *>());
        QVERIFY(!QApplication::activeModalWidget());
        QTRY_VERIFY(window().panels()->newest());
        QCOMPARE(content(), QByteArray("mine"));
        named<QPushButton>(window().panels(), answer)->click();
        if (answer.startsWith(u"Choose"_s)) {
            QFileDialog *again = fileDialog();
            QVERIFY(again);
            QCOMPARE(again->selectedFiles(), QStringList{path});
            again->reject();
        }
        QTRY_VERIFY(!window().panels()->isOpen());
    }
    QVERIFY(content().contains("gimbaldesk-configuration"));
}

void TestFileDialogs::whatIsNotThereIsSaidInTheDialog()
{
    QVERIFY(open("simplebgc"));
    press<BackupsPage>(*m_rig, u"Load a file…");
    QFileDialog *asked = fileDialog();
    QVERIFY(asked);
    typePath(m_rig->filePath(u"nothing.json"_s));
    QVERIFY(asked->isVisible() && !QApplication::activeModalWidget());
    QCOMPARE(asked->labelText(QFileDialog::FileName), u"There is no such file:"_s);
}

void TestFileDialogs::closesWithThePageThatAsked()
{
    QVERIFY(open("simplebgc"));
    auto *asking = new QWidget(&window());
    askSavePath(asking, u"Save"_s, u"gimbal.json"_s, u"*.json"_s,
                [](const QString &) { QFAIL("asked nobody"); });
    const QPointer<QFileDialog> asked = fileDialog();
    QVERIFY(asked);
    delete asking;
    QTRY_VERIFY(!asked && !window().panels()->isOpen());
}

QTEST_MAIN(TestFileDialogs)
#include "tst_filedialogs.moc"
