// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/composition/composition.h"
#include "app/mainwindow/mainwindow.h"
#include "app/mainwindow/tour.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QTextStream>
#include <QTranslator>

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
    arguments[at] = u"--demo="_s + (named ? next : allFamilies().first().key);
    if (named)
        arguments.removeAt(at + 1);
    return arguments;
}

} // namespace

int main(int argc, char **argv)
{
    // Pictures need no screen.
    const bool hasScreen = qEnvironmentVariableIsSet("DISPLAY") || qEnvironmentVariableIsSet("WAYLAND_DISPLAY");
    for (int i = 1; i < argc; ++i) {
        if (qstrcmp(argv[i], "--tour") == 0 && !hasScreen && !qEnvironmentVariableIsSet("QT_QPA_PLATFORM"))
            qputenv("QT_QPA_PLATFORM", "offscreen");
    }
    QApplication application(argc, argv);
    QApplication::setApplicationName(u"gimbaldesk"_s);
    QApplication::setApplicationDisplayName(u"GimbalDesk"_s);
    QApplication::setApplicationVersion(QStringLiteral(GIMBAL_VERSION));
    QApplication::setDesktopFileName(u"gimbaldesk"_s);

    QTranslator translator;
    if (translator.load(u":/translations/gimbaldesk_en.qm"_s))
        QApplication::installTranslator(&translator);

    QCommandLineParser parser;
    parser.setApplicationDescription(u"Configure, tune and watch gimbal controllers."_s);
    const QCommandLineOption link(u"link"_s, u"Connect to this address at start."_s, u"address"_s);
    const QCommandLineOption demo(u"demo"_s, u"Connect to a simulated board (of this family)."_s, u"family"_s);
    const QCommandLineOption tour(u"tour"_s, u"Write a picture of each page to this folder and end."_s, u"dir"_s);
    const QCommandLineOption page(u"page"_s, u"Page to begin with: dashboard, parameters, monitor, ..."_s, u"name"_s);
    const QCommandLineOption themeOption(u"theme"_s, u"light or dark; without it, the system's."_s, u"theme"_s);
    parser.addOptions({link, demo, tour, page, themeOption});
    parser.addHelpOption();
    parser.addVersionOption();
    if (!parser.parse(withDemoFamily(QApplication::arguments())))
        return wrong(parser.errorText());
    if (parser.isSet(u"help"_s) || parser.isSet(u"version"_s))
        parser.process(withDemoFamily(QApplication::arguments()));
    if (!parser.positionalArguments().isEmpty())
        return wrong(u"'%1' is not understood (gimbaldesk --help)"_s.arg(parser.positionalArguments().first()));

    Settings settings;
    Theme theme;
    if (settings.theme() != Settings::ThemeChoice::System)
        theme.setMode(settings.theme() == Settings::ThemeChoice::Dark ? Theme::Mode::Dark : Theme::Mode::Light);
    const QString themeName = parser.value(themeOption);
    if (themeName == u"light"_s)
        theme.setMode(Theme::Mode::Light);
    else if (themeName == u"dark"_s)
        theme.setMode(Theme::Mode::Dark);
    else if (!themeName.isEmpty())
        return wrong(u"--theme is light or dark, not '%1'"_s.arg(themeName));
    theme.apply();

    QString address = parser.value(link);
    if (parser.isSet(demo) || parser.isSet(tour)) {
        if (address.isEmpty())
            address = u"sim:"_s + (parser.isSet(demo) ? parser.value(demo) : allFamilies().first().key);
    }
    if (!address.isEmpty()) {
        const auto parsed = LinkAddress::parse(address);
        if (!parsed)
            return wrong(parsed.error().detail);
        if (parsed->kind() == LinkAddress::Kind::Simulator) {
            if (const auto transport = allLinks().transports(*parsed); !transport)
                return wrong(transport.error().detail);
        }
    }

    MainWindow window(allLinks(), allFamilies(), theme, settings);
    if (parser.isSet(page) && !window.showPage(parser.value(page)))
        return wrong(u"there is no page '%1'"_s.arg(parser.value(page)));
    window.show();
    std::unique_ptr<Tour> guide;
    if (parser.isSet(tour)) {
        guide = std::make_unique<Tour>(window, parser.value(tour), theme.isDark() ? u"-dark"_s : u"-light"_s);
        QObject::connect(guide.get(), &Tour::finished, &application,
                         [](const QStringList &pictures, const QString &error) {
                             QTextStream out(error.isEmpty() ? stdout : stderr);
                             for (const QString &picture : pictures)
                                 out << picture << "\n";
                             if (!error.isEmpty())
                                 out << "gimbaldesk: " << error << "\n";
                             out.flush();
                             QCoreApplication::exit(error.isEmpty() ? 0 : 1);
                         });
        QTimer::singleShot(1000, &window, [&window, address] { window.openLink(address); });
    } else if (!address.isEmpty()) {
        window.openLink(address);
    }
    return QApplication::exec();
}
