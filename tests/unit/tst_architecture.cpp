// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDirIterator>
#include <QFile>
#include <QMap>
#include <QRegularExpression>
#include <QTest>

using namespace Qt::StringLiterals;

namespace {

constexpr qsizetype kMaxLines = 600;

// Families know each other nowhere; who may know one of them is said in one place.
const QStringList &families()
{
    static const QStringList list{u"simplebgc"_s, u"storm32"_s, u"mavlink"_s, u"bcflight"_s};
    return list;
}

// Which folders each folder may see (beside itself): what it includes, and whatever comes along with that.
// The house plan, as a test.
const QMap<QString, QStringList> &allowed()
{
    // clang-format off
    static const QStringList session{u"protocol/base"_s, u"protocol/transport"_s, u"protocol/session"_s};
    static const QStringList device = session + QStringList{u"protocol/analysis"_s, u"protocol/configuration"_s, u"protocol/telemetry"_s};
    static const QStringList family = device + QStringList{u"protocol/device"_s};
    static const QStringList board{u"protocol/base"_s, u"protocol/transport"_s, u"protocol/simulator/world"_s};
    static const QStringList shown{u"protocol/base"_s, u"protocol/analysis"_s, u"protocol/telemetry"_s, u"protocol/device"_s,
                                   u"protocol/configuration"_s, u"protocol/supervisor"_s, u"protocol/client"_s};
    static const QStringList drawn = shown + QStringList{u"widgets/models"_s, u"widgets/theme"_s};
    static const QStringList core = family + QStringList{u"protocol/supervisor"_s, u"protocol/client"_s, u"protocol/record"_s, u"protocol/procedure"_s, u"protocol/guide"_s};
    static const QStringList shared = core + QStringList{u"app/composition"_s, u"widgets/models"_s, u"widgets/theme"_s, u"widgets/forms"_s,
                                                         u"widgets/plot"_s, u"widgets/views"_s, u"widgets/gamepad"_s, u"protocol/video"_s};
    static const QStringList page = shared + QStringList{u"app/workspace"_s};
    static const QStringList window = page + QStringList{u"app/pages/watch"_s, u"app/pages/setup"_s, u"app/pages/tune"_s, u"app/pages/board"_s,
                                                         u"app/pages/program"_s, u"app/families/simplebgc"_s, u"app/families/storm32"_s,
                                                         u"app/families/bcflight"_s,
                                                         u"app/families"_s};
    static const QMap<QString, QStringList> table{
        {u"protocol/base"_s, {}},
        {u"protocol/analysis"_s, {u"protocol/base"_s}},
        {u"protocol/transport"_s, {u"protocol/base"_s}},
        {u"protocol/session"_s, {u"protocol/base"_s, u"protocol/transport"_s}},
        {u"protocol/configuration"_s, {u"protocol/base"_s}},
        {u"protocol/telemetry"_s, session},
        {u"protocol/device"_s, device},
        {u"protocol/supervisor"_s, family},
        {u"protocol/client"_s, family + QStringList{u"protocol/supervisor"_s}},
        {u"protocol/simplebgc"_s, family},
        {u"protocol/mavlink"_s, {u"protocol/base"_s}},
        {u"protocol/storm32"_s, family + QStringList{u"protocol/mavlink"_s}},
        {u"protocol/bcflight"_s, family},
        {u"protocol/blackbox"_s, family},
        {u"protocol/record"_s, family},
        {u"protocol/procedure"_s, family + QStringList{u"protocol/record"_s}},
        {u"protocol/guide"_s, family + QStringList{u"protocol/record"_s, u"protocol/procedure"_s}},
        {u"protocol/video"_s, {u"protocol/base"_s}},
        {u"protocol/simulator/world"_s, {u"protocol/base"_s, u"protocol/transport"_s}},
        {u"protocol/simulator/video"_s, {u"protocol/base"_s, u"protocol/transport"_s, u"protocol/video"_s, u"protocol/simulator/world"_s}},
        {u"protocol/simulator/link"_s, board + QStringList{u"protocol/session"_s, u"protocol/video"_s, u"protocol/simulator/video"_s}},
        {u"protocol/simulator/simplebgc"_s, board + family + QStringList{u"protocol/simplebgc"_s}},
        {u"protocol/simulator/storm32"_s, board + family + QStringList{u"protocol/storm32"_s, u"protocol/mavlink"_s}},
        {u"protocol/simulator/bcflight"_s, board + family + QStringList{u"protocol/bcflight"_s}},
        {u"widgets/models"_s, shown},
        {u"widgets/gamepad"_s, {u"protocol/base"_s}},
        {u"widgets/theme"_s, {u"protocol/base"_s}},
        {u"widgets/forms"_s, drawn},
        {u"widgets/plot"_s, drawn},
        {u"widgets/views"_s, drawn + QStringList{u"protocol/video"_s}},
        // The one place that knows which families and boards there are.
        {u"app/composition"_s, core + board + QStringList{u"protocol/video"_s, u"protocol/simulator/video"_s, u"protocol/simplebgc"_s, u"protocol/storm32"_s, u"protocol/mavlink"_s, u"protocol/bcflight"_s, u"protocol/blackbox"_s,
            u"protocol/simulator/link"_s, u"protocol/simulator/simplebgc"_s, u"protocol/simulator/storm32"_s, u"protocol/simulator/bcflight"_s}},
        // gimbalsim's command line is a client of the simulator.
        {u"app/cli"_s, core + board + QStringList{u"app/composition"_s, u"widgets/models"_s, u"protocol/simulator/link"_s, u"protocol/simulator/video"_s, u"protocol/video"_s}},
        {u"app/workspace"_s, shared},
        // Loaded by the program when it is needed, so it links no floor.
        {u"app/modules/gamepad"_s, {u"protocol/base"_s, u"widgets/gamepad"_s}},
        {u"app/modules/video"_s, {u"protocol/base"_s, u"protocol/video"_s}},
        {u"app/pages/watch"_s, page},
        {u"app/pages/setup"_s, page},
        {u"app/pages/tune"_s, page},
        {u"app/pages/board"_s, page},
        {u"app/pages/program"_s, page},
        {u"app/families/simplebgc"_s, page + QStringList{u"protocol/simplebgc"_s}},
        {u"app/families/storm32"_s, page + QStringList{u"protocol/storm32"_s, u"protocol/mavlink"_s}},
        {u"app/families/bcflight"_s, page + QStringList{u"protocol/bcflight"_s}},
        {u"app/families"_s, page + QStringList{u"app/families/simplebgc"_s, u"app/families/storm32"_s, u"app/families/bcflight"_s}},
        {u"app/mainwindow"_s, window},
        {u"app/tour"_s, window + QStringList{u"app/mainwindow"_s}},
        // The three programs.
        {u"app"_s, window + board + QStringList{u"app/mainwindow"_s, u"app/tour"_s, u"app/cli"_s, u"protocol/simulator/link"_s, u"protocol/simulator/video"_s}},
    };
    // clang-format on
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

/// What each file includes itself.
using Includes = QMap<QString, QStringList>;

Includes includesOf(const QList<Source> &files)
{
    Includes includes;
    for (const Source &file : files)
        includes.insert(file.path, includesOf(file));
    return includes;
}

QString folderOf(const QString &path)
{
    return path.section(u'/', 0, -2);
}

// A header, its source and what both keep to themselves (_p) are one thing to whoever draws arrows between
// things.
QString pairOf(const QString &path)
{
    const QString stem = path.section(u'.', 0, -2);
    return stem.endsWith(u"_p"_s) ? stem.chopped(2) : stem;
}

bool isForeign(const QString &include)
{
    return !include.startsWith(u"protocol/"_s) && !include.startsWith(u"widgets/"_s)
        && !include.startsWith(u"app/"_s) && !include.startsWith(u"tests/"_s);
}

// Libraries that are the business of one floor.
QString foreignViolation(const QString &path, const QString &include)
{
    static const QMap<QString, QString> owners{{u"Eigen/"_s, u"protocol/analysis"_s},
                                               {u"Qsci/"_s, u"widgets/views"_s},
                                               {u"libav"_s, u"app/modules/video"_s},
                                               {u"libsw"_s, u"app/modules/video"_s},
                                               {u"SDL2/"_s, u"app/modules/gamepad"_s}};
    for (auto it = owners.begin(); it != owners.end(); ++it) {
        if (include.contains(it.key()) && folderOf(path) != it.value())
            return u"%1 includes %2"_s.arg(path, include);
    }
    return {};
}

// Everything a file sees that it may not see, each with the file that includes it.
QStringList forbiddenIncludes(const Includes &includes)
{
    QStringList wrong;
    for (auto file = includes.begin(); file != includes.end(); ++file) {
        const QString folder = folderOf(file.key());
        if (!allowed().contains(folder)) {
            wrong.append(file.key() + u" lies in a folder without a floor"_s);
            continue;
        }
        const QStringList &seen = allowed()[folder];
        QSet<QString> known{file.key()};
        QStringList open{file.key()};
        while (!open.isEmpty()) {
            const QString from = open.takeFirst();
            for (const QString &include : includes.value(from)) {
                if (isForeign(include)) {
                    if (const QString violation = foreignViolation(from, include);
                        from == file.key() && !violation.isEmpty())
                        wrong.append(violation);
                    continue;
                }
                if (known.contains(include))
                    continue;
                known.insert(include);
                open.append(include);
                const QString target = folderOf(include);
                const bool isSeen = target == folder || seen.contains(target) || seen.contains(include);
                if (!isSeen)
                    wrong.append(from == file.key()
                                     ? u"%1 includes %2"_s.arg(file.key(), include)
                                     : u"%1 sees %2 through %3"_s.arg(file.key(), include, from));
            }
        }
    }
    return wrong;
}

// Rings of pairs of header and source that include each other, each ring once.
QStringList ringsAmong(const Includes &includes)
{
    QMap<QString, QSet<QString>> arrows;
    for (auto file = includes.begin(); file != includes.end(); ++file) {
        for (const QString &include : file.value()) {
            if (includes.contains(include) && pairOf(include) != pairOf(file.key()))
                arrows[pairOf(file.key())].insert(pairOf(include));
        }
    }
    QMap<QString, QSet<QString>> reached;
    const auto reach = [&](const QString &from) {
        QStringList open{from};
        while (!open.isEmpty()) {
            for (const QString &next : arrows.value(open.takeLast())) {
                if (!reached[from].contains(next)) {
                    reached[from].insert(next);
                    open.append(next);
                }
            }
        }
    };
    for (const QString &pair : arrows.keys())
        reach(pair);
    QStringList rings;
    QSet<QString> told;
    for (const QString &pair : arrows.keys()) {
        if (!reached[pair].contains(pair) || told.contains(pair))
            continue;
        QStringList ring{pair};
        for (const QString &other : reached[pair]) {
            if (other != pair && reached[other].contains(pair))
                ring.append(other);
        }
        ring.sort();
        told.unite(QSet<QString>(ring.begin(), ring.end()));
        rings.append(ring.join(u" and "_s) + u" include each other"_s);
    }
    return rings;
}

QStringList tooLong(const QList<Source> &files)
{
    QStringList wrong;
    for (const Source &file : files) {
        const qsizetype lines = file.text.count(u'\n');
        if (lines > kMaxLines)
            wrong.append(u"%1 has %2 lines"_s.arg(file.path).arg(lines));
    }
    return wrong;
}

// What a row of the table may not say, however it is edited: a family is known to its own folders and to the
// composition only, pages know no other group's pages.
QStringList wrongRows(const QMap<QString, QStringList> &table)
{
    QStringList wrong;
    for (auto row = table.begin(); row != table.end(); ++row) {
        const QString own = row.key().section(u'/', -1);
        for (const QString &target : row.value()) {
            const QString family = target.section(u'/', -1);
            const bool isMavlinkOfStorm = family == u"mavlink"_s && own == u"storm32"_s;
            if (target.startsWith(u"protocol/"_s) && families().contains(family) && own != family
                && !isMavlinkOfStorm && row.key() != u"app/composition"_s)
                wrong.append(u"%1 may see the family %2"_s.arg(row.key(), target));
            const bool between
                = row.key().startsWith(u"app/pages/"_s) || row.key().startsWith(u"app/families/"_s);
            if (between && (target.startsWith(u"app/pages/"_s) || target.startsWith(u"app/families/"_s)))
                wrong.append(u"%1 may see other pages: %2"_s.arg(row.key(), target));
        }
    }
    return wrong;
}

// What a source or header declares outside of types and functions, and in which namespace: all of a header,
// the file-local part of a source.
QMap<QString, QString> declaredNames(const Source &source)
{
    static const QRegularExpression opens(u"^namespace (\\w[\\w:]*) \\{"_s);
    static const QRegularExpression type(
        u"^(?:template <.*> ?)?(?:struct|class|enum(?: class)?) (\\w+)(?! *;)"_s);
    static const QRegularExpression alias(u"^using (\\w+) ="_s);
    static const QRegularExpression constant(
        u"^[\\w:<>,&* \\[\\]]* (k[A-Z]\\w*)(?:\\[\\w*\\])? *(?:=|\\{|;|$)"_s);
    static const QRegularExpression function(u"^[\\w:<>,&* \\[\\]]*?[ *&](\\w+)\\("_s);
    const bool header = source.path.endsWith(u".h"_s);
    QMap<QString, QString> names;
    QString inside;
    bool local = header;
    for (const QString &line : source.text.split(u'\n')) {
        if (const auto opening = opens.match(line); opening.hasMatch()) {
            inside = opening.captured(1);
        } else if (line == u"namespace {"_s) {
            local = true;
        } else if (line == u"}  // namespace"_s) {
            local = header;
        } else if (local && !line.isEmpty() && (line[0].isLetter() || line[0] == u'[')) {
            for (const QRegularExpression &each : {type, alias, constant, function}) {
                if (const auto match = each.match(line); match.hasMatch()) {
                    names.insert(match.captured(1), inside);
                    break;
                }
            }
        }
    }
    return names;
}

// The sources of a folder are compiled together: a local name that a neighbour or a header of the same
// namespace has as well is an error at best. At worst it hides the other, or joins its overloads, without a
// word.
QStringList clashingNames(const QList<Source> &all)
{
    QStringList wrong;
    QMap<QPair<QString, QString>, QString> heads;  // namespace and name: header
    QMap<QPair<QString, QString>, QString> locals;  // folder and name: source
    for (const Source &source : all) {
        const auto names = declaredNames(source);
        for (auto name = names.begin(); source.path.endsWith(u".h"_s) && name != names.end(); ++name)
            heads.insert({name.value(), name.key()}, source.path);
    }
    for (const Source &source : all) {
        const auto names = declaredNames(source);
        for (auto name = names.begin(); source.path.endsWith(u".cpp"_s) && name != names.end(); ++name) {
            QString &first = locals[{source.path.section(u'/', 0, -2), name.key()}];
            const QString head = heads.value({name.value(), name.key()});
            for (const QString &other : {first, head}) {
                if (!other.isEmpty())
                    wrong.append(u"%1 is in %2 and %3"_s.arg(name.key(), other, source.path));
            }
            first = source.path;
        }
    }
    return wrong;
}

/// Whether a source opens a window that blocks the others.
bool blocksWindow(const QString &text)
{
    static const QRegularExpression always(
        u"[.>]exec\\(\\)|setModal|setWindowModality|QInputDialog::get|QFileDialog::get|"
        "QMessageBox::(question|warning|information|critical)\\("_s);
    static const QRegularExpression open(
        u"dialog->open\\(\\);|\\w[dD]ialog\\.open\\(\\);|box->open\\(\\);"_s);
    return always.match(text).hasMatch() || open.match(text).hasMatch();
}

}  // namespace

class TestArchitecture : public QObject
{
    Q_OBJECT
private slots:
    void floorsAreKept();
    void filesIncludeEachOtherOneWay();
    void protocolNeedsNoScreen();
    void widgetsNameNoFamily();
    void filesAreOfReadableLength();
    void everyFileNamesItsLicence();
    void localNamesAreUnique();
    void nothingBlocksOutsideTheWorker();
    void resultsReachOnlyWhoIsThere();
    void dialogsBlockNoWindow();
    void numbersAreTypedIntoOneKindOfField();
    void numbersInTablesHaveAFieldOfTheirOwn();
    void numbersAreWrittenInOnePlace();
    void theTestItselfFindsViolations_data();
    void theTestItselfFindsViolations();
    void theTestItselfFindsLongFilesAndWrongRows();
    void theTestItselfFindsClashingNames_data();
    void theTestItselfFindsClashingNames();
};

void TestArchitecture::floorsAreKept()
{
    const auto all = sources({u"protocol"_s, u"widgets"_s, u"app"_s});
    QVERIFY(all.size() > 60);
    const QStringList wrong = forbiddenIncludes(includesOf(all)) + wrongRows(allowed());
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
}

void TestArchitecture::filesIncludeEachOtherOneWay()
{
    const QStringList rings = ringsAmong(includesOf(sources({u"protocol"_s, u"widgets"_s, u"app"_s})));
    QVERIFY2(rings.isEmpty(), qPrintable(rings.join(u'\n')));
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
    for (const Source &source : sources({u"widgets"_s})) {
        // Sentences that an operator reads may.
        const bool isWords
            = source.path.endsWith(u"errortext.cpp"_s) || source.path.endsWith(u"detailtext.cpp"_s);
        QVERIFY2(isWords || !family.match(source.text).hasMatch(),
                 qPrintable(source.path + u" names a family"_s));
    }
}

void TestArchitecture::filesAreOfReadableLength()
{
    const QStringList wrong = tooLong(sources({u"protocol"_s, u"widgets"_s, u"app"_s}));
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
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

void TestArchitecture::localNamesAreUnique()
{
    const auto all = sources({u"protocol"_s, u"widgets"_s, u"app"_s});
    qsizetype found = 0;
    for (const Source &source : all)
        found += declaredNames(source).size();
    QVERIFY2(found > 1500, qPrintable(QString::number(found)));
    const QStringList wrong = clashingNames(all);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
}

void TestArchitecture::nothingBlocksOutsideTheWorker()
{
    static const QRegularExpression blocking(
        u"processEvents|QEventLoop|waitForReadyRead|waitForBytesWritten|waitForConnected|"
        "QThread::m?u?sleep"_s);
    for (const Source &source : sources({u"protocol"_s, u"widgets"_s, u"app"_s}))
        QVERIFY2(!blocking.match(source.text).hasMatch(), qPrintable(source.path));
}

// Pages and their models may end before what they asked for (protocol/client/whendone.h).
void TestArchitecture::resultsReachOnlyWhoIsThere()
{
    static const QRegularExpression unguarded(u"\\.then\\(\\s*(this|parent)\\b"_s);
    for (const Source &source :
         sources({u"widgets"_s, u"app/pages"_s, u"app/families"_s, u"app/mainwindow"_s}))
        QVERIFY2(!unguarded.match(source.text).hasMatch(), qPrintable(source.path));
    QVERIFY(unguarded.match(u"client().submit(read)\n    .then(\n        this, [this] {})"_s).hasMatch());
}

// A dialog is a panel, beneath which the motors can still be switched off (widgets/forms/panel.h). Files are
// asked for by the platform.
void TestArchitecture::dialogsBlockNoWindow()
{
    const auto all = sources({u"widgets"_s, u"app"_s});
    for (const Source &source : all) {
        if (source.path != u"widgets/forms/panel.cpp"_s && source.path != u"app/workspace/filedialogs.cpp"_s)
            QVERIFY2(!blocksWindow(source.text), qPrintable(source.path));
    }
    QVERIFY(std::count_if(all.begin(), all.end(),
                          [](const Source &source) { return source.text.contains(u"openPanel(*"_s); })
            >= 5);
    QVERIFY(blocksWindow(u"auto *dialog = new QDialog(this);\ndialog->open();"_s));
    QVERIFY(blocksWindow(u"QMessageBox box(this);\nbox.exec();"_s));
    QVERIFY(blocksWindow(u"if (QMessageBox::question(this, title, text) == QMessageBox::Yes)"_s));
    QVERIFY(blocksWindow(u"auto *dialog = new QFileDialog(this);\ndialog->open();"_s));
    QVERIFY(!blocksWindow(u"openPanel(*dialog);\nport->open();\nQApplication::exec();"_s));
}

// Qt's own fields drop and clip what is typed (widgets/forms/numberbox.h).
void TestArchitecture::numbersAreTypedIntoOneKindOfField()
{
    static const QRegularExpression others(
        u"new Q(Double)?SpinBox|public Q(Double)?SpinBox|Q(Int|Double)Validator"_s);
    for (const Source &source : sources({u"widgets"_s, u"app"_s})) {
        if (source.path != u"widgets/forms/numberbox.h"_s)
            QVERIFY2(!others.match(source.text).hasMatch(), qPrintable(source.path));
        else
            QVERIFY(others.match(source.text).hasMatch());
    }
}

// Qt's own delegate makes a field of its own for a number (widgets/forms/celldelegate.h): a model whose cells
// can be edited says which of them hold numbers, or is one of texts; tables that come with their items are
// not edited. Which fields come of it is checked by tst_refused, on all pages.
void TestArchitecture::numbersInTablesHaveAFieldOfTheirOwn()
{
    static const QStringList texts{u"widgets/models/profilemodel.cpp"_s};
    int editable = 0;
    for (const Source &source : sources({u"widgets"_s, u"app"_s})) {
        const bool isEdited = source.text.contains(u"ItemIsEditable"_s);
        editable += isEdited;
        QVERIFY2(!isEdited || source.text.contains(u"NumberRole"_s) || texts.contains(source.path),
                 qPrintable(source.path));
        QVERIFY2(!source.text.contains(u"new QTableWidget"_s) || source.text.contains(u"NoEditTriggers"_s),
                 qPrintable(source.path));
        // A view that says how cells are opened says in what.
        const bool isOpened
            = source.text.contains(u"setEditTriggers"_s) && !source.text.contains(u"NoEditTriggers"_s);
        QVERIFY2(!isOpened || source.text.contains(u"setItemDelegate"_s)
                     || source.text.contains(u"new FilterTable"_s),
                 qPrintable(source.path));
    }
    QVERIFY(editable >= 3);
}

// On screen a number is written as the operator's language does (widgets/models/numbertext.h). Two write for
// the wire and for files.
void TestArchitecture::numbersAreWrittenInOnePlace()
{
    static const QRegularExpression written(u", '[efg]'[,)]|asprintf|QLocale::c\\(\\)\\.|setNum\\("_s);
    static const QStringList own{u"widgets/models/numbertext.cpp"_s, u"widgets/models/framelogmodel.cpp"_s,
                                 u"widgets/forms/argumentform.cpp"_s};
    for (const Source &source : sources({u"widgets"_s, u"app"_s})) {
        const bool screen = !source.path.startsWith(u"app/cli/"_s) && !own.contains(source.path);
        QVERIFY2(!screen || !written.match(source.text).hasMatch(), qPrintable(source.path));
    }
    QVERIFY(written.match(u"tr(\"%1 V\").arg(volts, 0, 'f', 1)"_s).hasMatch());
    QVERIFY(written.match(u"QString::number(value, 'g')"_s).hasMatch());
    QVERIFY(!written.match(u"numberText(volts, 1)"_s).hasMatch());
}

void TestArchitecture::theTestItselfFindsViolations_data()
{
    QTest::addColumn<QStringList>("files");  // PATH: INCLUDE INCLUDE ...
    QTest::addColumn<QString>("violation");  // none: the files are as they should be

    // clang-format off
    QTest::newRow("a header of one's own") << QStringList{u"widgets/plot/x.cpp: widgets/plot/x.h"_s, u"widgets/plot/x.h:"_s} << QString();
    QTest::newRow("a floor above") << QStringList{u"widgets/plot/x.h: widgets/models/y.h"_s, u"widgets/models/y.h: protocol/telemetry/z.h"_s, u"protocol/telemetry/z.h:"_s} << QString();
    QTest::newRow("a family in a widget") << QStringList{u"widgets/plot/x.cpp: protocol/simplebgc/framer.h"_s}
        << u"widgets/plot/x.cpp includes protocol/simplebgc/framer.h"_s;
    QTest::newRow("a session that comes along") << QStringList{u"widgets/plot/x.cpp: protocol/client/y.h"_s, u"protocol/client/y.h: protocol/device/z.h"_s, u"protocol/device/z.h: protocol/session/session.h"_s}
        << u"widgets/plot/x.cpp sees protocol/session/session.h through protocol/device/z.h"_s;
    QTest::newRow("what comes along in protocol") << QStringList{u"protocol/configuration/x.cpp: protocol/base/y.h"_s, u"protocol/base/y.h: protocol/transport/z.h"_s}
        << u"protocol/configuration/x.cpp sees protocol/transport/z.h through protocol/base/y.h"_s;
    QTest::newRow("a floor below") << QStringList{u"protocol/session/x.h: protocol/device/y.h"_s} << u"protocol/session/x.h includes protocol/device/y.h"_s;
    QTest::newRow("a folder without a floor") << QStringList{u"protocol/attic/x.h:"_s} << u"protocol/attic/x.h lies in a folder without a floor"_s;
    QTest::newRow("a test in the program") << QStringList{u"app/workspace/x.cpp: tests/support/rig.h"_s} << u"app/workspace/x.cpp includes tests/support/rig.h"_s;
    QTest::newRow("linear algebra elsewhere") << QStringList{u"protocol/device/x.cpp: unsupported/Eigen/FFT"_s} << u"protocol/device/x.cpp includes unsupported/Eigen/FFT"_s;
    QTest::newRow("linear algebra at home") << QStringList{u"protocol/analysis/x.cpp: unsupported/Eigen/FFT"_s} << QString();
    QTest::newRow("the editor elsewhere") << QStringList{u"app/pages/setup/x.cpp: Qsci/qscistyle.h"_s} << u"app/pages/setup/x.cpp includes Qsci/qscistyle.h"_s;
    QTest::newRow("composition knows the command line") << QStringList{u"app/composition/x.h: app/cli/y.h"_s} << u"app/composition/x.h includes app/cli/y.h"_s;
    QTest::newRow("the workspace knows a page") << QStringList{u"app/workspace/x.cpp: app/pages/watch/y.h"_s} << u"app/workspace/x.cpp includes app/pages/watch/y.h"_s;
    QTest::newRow("a page knows another group's") << QStringList{u"app/pages/watch/x.cpp: app/pages/tune/y.h"_s} << u"app/pages/watch/x.cpp includes app/pages/tune/y.h"_s;
    QTest::newRow("a page knows the window") << QStringList{u"app/pages/watch/x.cpp: app/mainwindow/mainwindow.h"_s} << u"app/pages/watch/x.cpp includes app/mainwindow/mainwindow.h"_s;
    QTest::newRow("the window knows the tour") << QStringList{u"app/mainwindow/x.cpp: app/tour/tour.h"_s} << u"app/mainwindow/x.cpp includes app/tour/tour.h"_s;
    QTest::newRow("the command line draws") << QStringList{u"app/cli/x.cpp: widgets/plot/y.h"_s} << u"app/cli/x.cpp includes widgets/plot/y.h"_s;
    QTest::newRow("a page knows a family's pages") << QStringList{u"app/pages/setup/x.cpp: app/families/storm32/y.h"_s} << u"app/pages/setup/x.cpp includes app/families/storm32/y.h"_s;
    QTest::newRow("a family's pages know another's") << QStringList{u"app/families/simplebgc/x.cpp: app/families/storm32/y.h"_s} << u"app/families/simplebgc/x.cpp includes app/families/storm32/y.h"_s;
    QTest::newRow("a family's pages know another family") << QStringList{u"app/families/simplebgc/x.cpp: protocol/storm32/y.h"_s} << u"app/families/simplebgc/x.cpp includes protocol/storm32/y.h"_s;
    QTest::newRow("a family's pages know their family") << QStringList{u"app/families/storm32/x.cpp: protocol/storm32/y.h"_s, u"protocol/storm32/y.h: protocol/mavlink/z.h"_s, u"protocol/mavlink/z.h:"_s} << QString();
    QTest::newRow("a page knows a family") << QStringList{u"app/pages/board/x.cpp: protocol/simplebgc/y.h"_s} << u"app/pages/board/x.cpp includes protocol/simplebgc/y.h"_s;
    QTest::newRow("a family that comes along") << QStringList{u"app/pages/board/x.cpp: app/composition/y.h"_s, u"app/composition/y.h: protocol/mavlink/z.h"_s} << u"app/pages/board/x.cpp sees protocol/mavlink/z.h through app/composition/y.h"_s;
    QTest::newRow("a page knows the simulator") << QStringList{u"app/pages/board/x.cpp: protocol/simulator/world/y.h"_s} << u"app/pages/board/x.cpp includes protocol/simulator/world/y.h"_s;
    QTest::newRow("a procedure knows a family") << QStringList{u"protocol/procedure/x.cpp: protocol/storm32/y.h"_s} << u"protocol/procedure/x.cpp includes protocol/storm32/y.h"_s;
    QTest::newRow("a family knows another") << QStringList{u"protocol/simplebgc/x.cpp: protocol/storm32/y.h"_s} << u"protocol/simplebgc/x.cpp includes protocol/storm32/y.h"_s;
    QTest::newRow("a simulated board knows another") << QStringList{u"protocol/simulator/simplebgc/x.cpp: protocol/simulator/storm32/y.h"_s} << u"protocol/simulator/simplebgc/x.cpp includes protocol/simulator/storm32/y.h"_s;
    QTest::newRow("the simulator's link knows a board") << QStringList{u"protocol/simulator/link/x.cpp: protocol/simulator/storm32/y.h"_s} << u"protocol/simulator/link/x.cpp includes protocol/simulator/storm32/y.h"_s;
    QTest::newRow("composition knows everything") << QStringList{u"app/composition/x.cpp: protocol/simulator/storm32/y.h protocol/simplebgc/z.h"_s} << QString();
    QTest::newRow("a ring of two pairs") << QStringList{u"app/tour/a.h:"_s, u"app/tour/a.cpp: app/tour/a.h app/tour/b.h"_s, u"app/tour/b.h:"_s, u"app/tour/b.cpp: app/tour/b.h app/tour/a.h"_s}
        << u"app/tour/a and app/tour/b include each other"_s;
    QTest::newRow("a ring of three") << QStringList{u"app/tour/a.h: app/tour/b.h"_s, u"app/tour/b.h: app/tour/c.h"_s, u"app/tour/c.h: app/tour/a.h"_s}
        << u"app/tour/a and app/tour/b and app/tour/c include each other"_s;
    QTest::newRow("two ways to one file") << QStringList{u"app/tour/a.h: app/tour/b.h app/tour/c.h"_s, u"app/tour/b.h: app/tour/c.h"_s, u"app/tour/c.h:"_s} << QString();
    // clang-format on
}

void TestArchitecture::theTestItselfFindsViolations()
{
    QFETCH(QStringList, files);
    QFETCH(QString, violation);
    Includes includes;
    for (const QString &file : files) {
        // As the reader of files would see it.
        QString text;
        for (const QString &include : file.section(u':', 1).split(u' ', Qt::SkipEmptyParts))
            text += u"#include \"%1\"\n"_s.arg(include);
        const QString path = file.section(u':', 0, 0);
        includes.insert(path, includesOf(Source{path, text}));
    }
    const QStringList found = forbiddenIncludes(includes) + ringsAmong(includes);
    if (violation.isEmpty())
        QCOMPARE(found.join(u'\n'), QString());
    else
        QVERIFY2(found.contains(violation), qPrintable(found.join(u'\n')));
}

void TestArchitecture::theTestItselfFindsLongFilesAndWrongRows()
{
    QVERIFY(tooLong({{u"app/tour/x.cpp"_s, QString(kMaxLines, u'\n')}}).isEmpty());
    QCOMPARE(tooLong({{u"app/tour/x.cpp"_s, QString(kMaxLines + 1, u'\n')}}),
             QStringList{u"app/tour/x.cpp has 601 lines"_s});

    auto table = allowed();
    table[u"widgets/models"_s].append(u"protocol/storm32"_s);
    table[u"app/pages/watch"_s].append(u"app/pages/tune"_s);
    QCOMPARE(wrongRows(table),
             (QStringList{u"app/pages/watch may see other pages: app/pages/tune"_s,
                          u"widgets/models may see the family protocol/storm32"_s}));
}

void TestArchitecture::theTestItselfFindsClashingNames_data()
{
    QTest::addColumn<QString>("mine");
    QTest::addColumn<QString>("other");
    QTest::addColumn<QString>("otherPath");
    QTest::addColumn<bool>("clash");
    const QString source = u"app/tour/b.cpp"_s;
    const QString elsewhere = u"widgets/plot/b.cpp"_s;
    const QString header = u"widgets/theme/b.h"_s;
    const auto local = [](const char *line) {
        return u"namespace {\n\n"_s + QLatin1String(line) + u"\n\n}  // namespace\n"_s;
    };
    // clang-format off
    QTest::newRow("constants") << local("constexpr int kMost = 3;") << local("const QString kMost{};") << source << true;
    QTest::newRow("tables") << local("constexpr Choice kRows[] = {") << local("constexpr std::array<int, kCount> kRows{1};") << source << true;
    QTest::newRow("a size is no name") << local("constexpr std::array<int, kCount> kRows{1};") << local("constexpr int kCount = 1;") << source << false;
    QTest::newRow("a table on two lines") << local("constexpr Choice kRows[]\n    = {};") << local("constexpr int kRows = 1;") << source << true;
    QTest::newRow("functions") << local("double decibel(double power)") << local("QString decibel(const QString &text)") << source << true;
    QTest::newRow("returned by pointer") << local("const Row *rowOf(int a)") << local("Result<Row> rowOf(double b)") << source << true;
    QTest::newRow("types") << local("struct Column\n{") << local("enum Column { A, B };") << source << true;
    QTest::newRow("an alias") << local("using Table = QMap<int, int>;") << local("class Table : public QObject") << source << true;
    QTest::newRow("another folder") << local("struct Column\n{") << local("struct Column\n{") << elsewhere << false;
    QTest::newRow("hides a header's") << local("constexpr int kGap = 3;") << u"inline constexpr int kGap = 8;"_s << header << true;
    QTest::newRow("overloads a header's") << local("int wordsOf(const QString &line)") << u"[[nodiscard]] int wordsOf(int layout);"_s << header << true;
    QTest::newRow("a header's of a namespace") << local("constexpr int kGap = 3;") << u"namespace storm32 {\ninline constexpr int kGap = 8;\n}"_s << header << false;
    QTest::newRow("of the same namespace") << u"namespace storm32 {\n"_s + local("constexpr int kGap = 3;") << u"namespace storm32 {\ninline constexpr int kGap = 8;\n}"_s << header << true;
    QTest::newRow("a member") << local("struct A\n{\n    int b(int c);\n};") << local("int b(int c)") << source << false;
    QTest::newRow("not local") << u"int Tour::b(int c)"_s << local("int b(int c)") << source << false;
    // clang-format on
}

void TestArchitecture::theTestItselfFindsClashingNames()
{
    QFETCH(QString, mine);
    QFETCH(QString, other);
    QFETCH(QString, otherPath);
    QFETCH(bool, clash);
    QCOMPARE(!clashingNames({{u"app/tour/a.cpp"_s, mine}, {otherPath, other}}).isEmpty(), clash);
}

QTEST_APPLESS_MAIN(TestArchitecture)
#include "tst_architecture.moc"
