// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/composition/composition.h"
#include "app/mainwindow/mainwindow.h"
#include "app/mainwindow/navigation.h"
#include "app/mainwindow/pagetable.h"
#include "app/mainwindow/translations.h"
#include "app/tour/tour.h"
#include "app/tour/tourrunner.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QTemporaryDir>
#include <QTextStream>
#include <QTimer>

using namespace Qt::StringLiterals;

namespace {

constexpr int kWrongArguments = 2;

int wrong(const QString &message)
{
    QTextStream(stderr) << "gimbaldesk: " << message << "\n";
    return kWrongArguments;
}

// "--demo FAMILY" with FAMILY left out is allowed; the parser knows only options that always have a value.
QStringList withDemoFamily(QStringList arguments)
{
    const qsizetype at = arguments.indexOf(u"--demo"_s);
    if (at < 0)
        return arguments;
    const QString next = arguments.value(at + 1);
    const bool named = !next.isEmpty() && !next.startsWith(u'-');
    arguments[at] = u"--demo="_s + (named ? next : allLinks().defaultFamily);
    if (named)
        arguments.removeAt(at + 1);
    return arguments;
}

int runWholeTour(const QString &folder, const QStringList &more)
{
    TourRunner runner(folder, more);
    QObject::connect(&runner, &TourRunner::finished, qApp, [](const QString &paths, const QString &error) {
        QTextStream(stdout) << paths;
        if (!error.isEmpty())
            QTextStream(stderr) << "gimbaldesk: " << error << "\n";
        QCoreApplication::exit(error.isEmpty() ? 0 : 1);
    });
    QTimer::singleShot(0, &runner, &TourRunner::start);
    return QApplication::exec();
}

// Pictures and help need no screen. False if there is none for what does.
bool prepareScreen(int argc, char **argv)
{
    for (const char *name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) {
        if (!qEnvironmentVariableIsEmpty(name))
            return true;
    }
    for (int i = 1; i < argc; ++i) {
        for (const char *option : {"--tour", "--help", "--help-all", "-h", "--version", "-v"}) {
            if (qstrcmp(argv[i], option) == 0) {
                qputenv("QT_QPA_PLATFORM", "offscreen");
                return true;
            }
        }
        if (qstrcmp(argv[i], "-platform") == 0)
            return true;
    }
    return false;
}

void addOptions(QCommandLineParser &parser)
{
    parser.setApplicationDescription(u"Configure, tune and watch gimbal controllers."_s);
    const QCommandLineOption link(u"link"_s, u"Connect to this address at start."_s, u"address"_s);
    QStringList families;
    for (const Family &family : allFamilies())
        families.append(family.key);
    const QCommandLineOption demo(
        u"demo"_s,
        u"Connect to a simulated board, of the first family if none is named: %1."_s.arg(
            families.join(u", "_s)),
        u"family"_s);
    const QCommandLineOption tour(u"tour"_s, u"Write a picture of each page to this folder and end."_s,
                                  u"dir"_s);
    const QCommandLineOption tourAll(
        u"tour-all"_s,
        u"With --tour: every page, wizard step and dialog, light and dark, at 100 and 200 %."_s);
    const QCommandLineOption everything(u"everything"_s,
                                        u"With --tour: every page, wizard step and dialog in one look."_s);
    const QCommandLineOption language(u"language"_s, u"en or de; without it, as set or as the system."_s,
                                      u"code"_s);
    const QCommandLineOption page(u"page"_s, u"Page to begin with: dashboard, parameters, monitor, ..."_s,
                                  u"name"_s);
    const QCommandLineOption themeOption(u"theme"_s, u"light or dark; without it, the system's."_s,
                                         u"theme"_s);
    parser.addOptions({link, demo, tour, tourAll, everything, page, themeOption, language});
    parser.addHelpOption();
    parser.addVersionOption();
}

QStringList pageKeys()
{
    QStringList keys;
    for (const PageEntry &entry : pageTable())
        keys.append(QLatin1String(entry.key));
    return keys;
}

// What is wrong with the command line; empty if nothing.
QString mistakeIn(const QCommandLineParser &parser)
{
    if (!parser.positionalArguments().isEmpty())
        return u"'%1' is not understood (gimbaldesk --help)"_s.arg(parser.positionalArguments().first());
    if ((parser.isSet(u"tour-all"_s) || parser.isSet(u"everything"_s)) && !parser.isSet(u"tour"_s))
        return u"--tour-all and --everything go with --tour DIR"_s;
    return {};
}

// The theme from the settings, overridden by the one on the command line. False if there is no such theme.
bool chooseTheme(Theme &theme, const Settings &settings, const QString &name)
{
    if (settings.theme() != Settings::ThemeChoice::System)
        theme.setMode(settings.theme() == Settings::ThemeChoice::Dark ? Theme::Mode::Dark
                                                                      : Theme::Mode::Light);
    if (name == u"light"_s)
        theme.setMode(Theme::Mode::Light);
    else if (name == u"dark"_s)
        theme.setMode(Theme::Mode::Dark);
    else if (!name.isEmpty())
        return false;
    theme.apply();
    return true;
}

// What to connect to at start; empty for nothing. Errors: InvalidArgument and those of the link.
Result<QString> startAddress(const QCommandLineParser &parser)
{
    QString address = parser.value(u"link"_s);
    const bool demo = parser.isSet(u"demo"_s);
    if (address.isEmpty() && (demo || parser.isSet(u"tour"_s)))
        address = u"sim:"_s + (demo ? parser.value(u"demo"_s) : allLinks().defaultFamily);
    if (address.isEmpty())
        return address;
    const auto parsed = LinkAddress::parse(address);
    if (!parsed)
        return tl::unexpected(parsed.error());
    if (parsed->kind() == LinkAddress::Kind::Simulator) {
        if (const auto transport = allLinks().transports(*parsed); !transport)
            return tl::unexpected(transport.error());
    }
    return address;
}

// Takes the pictures, then ends the program.
std::unique_ptr<Tour> beginTour(MainWindow &window, const QCommandLineParser &parser, const Theme &theme,
                                const QString &language)
{
    QString suffix = theme.isDark() ? u"-dark"_s : u"-light"_s;
    if (window.devicePixelRatioF() > 1.5)
        suffix += u"@2x"_s;
    if (!language.isEmpty() && language != u"en"_s)
        suffix += u'-' + language;
    auto tour = std::make_unique<Tour>(window, parser.value(u"tour"_s), suffix,
                                       parser.isSet(u"everything"_s) ? Tour::Extent::Everything
                                                                     : Tour::Extent::Pages,
                                       parser.value(u"demo"_s));
    QObject::connect(tour.get(), &Tour::finished, qApp,
                     [](const QStringList &pictures, const QString &error) {
                         QTextStream out(error.isEmpty() ? stdout : stderr);
                         for (const QString &picture : pictures)
                             out << picture << "\n";
                         if (!error.isEmpty())
                             out << "gimbaldesk: " << error << "\n";
                         out.flush();
                         QCoreApplication::exit(error.isEmpty() ? 0 : 1);
                     });
    tour->start();
    return tour;
}

}  // namespace

int main(int argc, char **argv)
{
    if (!prepareScreen(argc, argv))
        return wrong(
            u"there is no display (DISPLAY and WAYLAND_DISPLAY are empty): start it on a desktop, take "
            "pictures with --tour DIR, or use gimbalctl"_s);
    const QApplication application(argc, argv);
    QApplication::setApplicationName(u"gimbaldesk"_s);
    QApplication::setApplicationDisplayName(u"GimbalDesk"_s);
    QApplication::setApplicationVersion(QStringLiteral(GIMBAL_VERSION));
    QApplication::setDesktopFileName(u"gimbaldesk"_s);

    QCommandLineParser parser;
    addOptions(parser);
    if (!parser.parse(withDemoFamily(QApplication::arguments())))
        return wrong(parser.errorText());
    if (parser.isSet(u"help"_s) || parser.isSet(u"version"_s))
        parser.process(withDemoFamily(QApplication::arguments()));
    if (const QString mistake = mistakeIn(parser); !mistake.isEmpty())
        return wrong(mistake);
    const QString language = parser.value(u"language"_s);
    if (parser.isSet(u"tour-all"_s))
        return runWholeTour(parser.value(u"tour"_s),
                            parser.isSet(u"language"_s) ? QStringList{u"--language"_s, language}
                                                        : QStringList());

    // Pictures show the program as it is before first use.
    const bool tour = parser.isSet(u"tour"_s);
    QTemporaryDir pristine;
    if (tour)
        qputenv("XDG_DATA_HOME", pristine.path().toLocal8Bit());
    Settings settings(tour ? pristine.filePath(u"gimbaldesk.ini"_s) : Settings::defaultPath());
    const QString code = parser.isSet(u"language"_s) ? language : settings.language();
    if (!code.isEmpty() && code != u"en"_s && code != u"de"_s)
        return wrong(u"--language is en or de, not '%1'"_s.arg(code));
    Translations translations(code);
    Theme theme;
    if (const QString name = parser.value(u"theme"_s); !chooseTheme(theme, settings, name))
        return wrong(u"--theme is light or dark, not '%1'"_s.arg(name));
    const auto address = startAddress(parser);
    if (!address)
        return wrong(address.error().detail);

    MainWindow window(allLinks(), allFamilies() + recordedFamilies(), theme, settings);
    QObject::connect(&window, &MainWindow::languageDue, &window,
                     [&translations](const QString &wanted) { translations.setLanguage(wanted); });
    // What only some boards have is shown once such a board is connected.
    if (const QString page = parser.value(u"page"_s);
        parser.isSet(u"page"_s) && !window.showPage(page) && !window.navigation()->awaitPage(page))
        return wrong(u"there is no page '%1', only %2"_s.arg(page, pageKeys().join(u", "_s)));
    window.show();
    const auto guide = tour ? beginTour(window, parser, theme, code) : nullptr;
    if (!tour && !address->isEmpty())
        window.openLink(*address);
    return QApplication::exec();
}
