// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
// The table of SimpleBGC's commands in CONTRIBUTING.md, made from the program's tables and held against them.
#include "app/cli/command.h"
#include "protocol/simplebgc/actiontable.h"
#include "protocol/simplebgc/commands.h"
#include "protocol/simplebgc/device.h"
#include "protocol/simplebgc/messages.h"
#include "tests/unit/sbgcproofs.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QTest>

using namespace Qt::StringLiterals;
using namespace simplebgc;

namespace {

/// What `gimbalctl` offers for a place on screen that is no action; where reading and writing differ, for
/// each.
struct Way
{
    const char *where;
    const char *command;
    const char *writing = nullptr;
};

// clang-format off
constexpr Way kWays[] = {
    {"connecting", "info"},
    {"Parameters", "get", "set"},
    {"Monitor", "monitor"},
    {"Profiles", "profiles", "rename"},
    {"Auto-tune", "autotune"},
    {"Control", "do steer"},
    {"Start motors", "motors on"},
    {"Stop motors", "motors off"},
    {"everywhere", "raw"},
};
// clang-format on

QString contentOf(const QString &path)
{
    QFile file(QStringLiteral(GIMBAL_SOURCE_DIR "/") + path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

// "Monitor, Actions (attitude, feed)" is "Monitor" and "do attitude", "do feed".
QStringList placesOf(const MessageSpec &message)
{
    static const QRegularExpression kActions(u"(, )?Actions \\(([^)]*)\\)"_s);
    return QString::fromLatin1(message.where).remove(kActions).split(u", "_s, Qt::SkipEmptyParts);
}

QStringList actionsOf(const MessageSpec &message)
{
    static const QRegularExpression kActions(u"Actions \\(([^)]*)\\)"_s);
    const auto match = kActions.match(QLatin1String(message.where));
    return match.captured(1).split(u", "_s, Qt::SkipEmptyParts);
}

QStringList commandsOf(const MessageSpec &message)
{
    if (!*message.where)
        return message.toBoard || !message.isPublic ? QStringList{u"raw "_s + QLatin1String(message.name)}
                                                    : QStringList();
    QStringList commands;
    for (const QString &action : actionsOf(message))
        commands.append(u"do "_s + action);
    if (!commands.isEmpty())
        return commands;
    for (const QString &place : placesOf(message)) {
        for (const Way &way : kWays) {
            if (place == QLatin1String(way.where))
                commands.append(QLatin1String(
                    message.risk == ActionRisk::Writes && way.writing ? way.writing : way.command));
        }
    }
    return commands;
}

const SbgcProof *proofOf(int id)
{
    const auto it = std::find_if(std::begin(kSbgcProofs), std::end(kSbgcProofs),
                                 [id](const SbgcProof &proof) { return proof.id == id; });
    return it == std::end(kSbgcProofs) ? nullptr : &*it;
}

QString testOf(const MessageSpec &message)
{
    if (!message.isPublic)
        return {};
    const SbgcProof *proof = proofOf(message.id);
    return proof ? u"%1 %2"_s.arg(QLatin1String(proof->test), QLatin1String(proof->function))
                 : u"tst_sbgcmessages"_s;
}

QString rowOf(const MessageSpec &message)
{
    const QString ways = message.toBoard && message.fromBoard ? u"both"_s
        : message.toBoard                                     ? u"to the board"_s
        : message.fromBoard                                   ? u"from the board"_s
                                                              : u"?"_s;
    const QString state = !message.isPublic ? u"raw: no public layout"_s
        : *message.where                    ? u"in use"_s
                                            : u"by hand"_s;
    const QString where = *message.where ? QString::fromLatin1(message.where) : u"Console"_s;
    return u"| %1 | %2 | %3 | %4 | %5 | %6 | %7 | %8 |"_s.arg(message.id)
        .arg(QLatin1String(message.name), ways,
             message.since == 0 ? QString() : QString::number(message.since), state, where,
             commandsOf(message).join(u", "_s), testOf(message));
}

// What a test calls the message: its name, its number's word or its block's, its actions.
QRegularExpression wordsFor(const MessageSpec &message, const QStringList &actions)
{
    static const QString kNumbers = contentOf(u"protocol/simplebgc/commands.h"_s);
    QStringList words{u"\\b%1\\b"_s.arg(QLatin1String(message.name))};
    const QRegularExpression entry(u"(\\w+) = %1,"_s.arg(message.id));
    for (auto it = entry.globalMatch(kNumbers); it.hasNext();)
        words.append(u"\\bCommandId::%1\\b"_s.arg(it.next().captured(1)));
    for (const QString &action : actions)
        words.append(u"\"%1\""_s.arg(QRegularExpression::escape(action)));
    return QRegularExpression(words.join(u'|'));
}

// The function and what supplies its rows; empty: there is none.
QString bodyOf(const QString &test, const QString &function)
{
    QString text;
    for (const char *folder : {"unit", "integration", "gui"}) {
        text = contentOf(u"tests/%1/%2.cpp"_s.arg(QLatin1String(folder), test));
        if (!text.isEmpty())
            break;
    }
    QString bodies;
    bool isThere = false;
    for (const QString &name : {function, function + u"_data"_s}) {
        const qsizetype from = text.indexOf(QRegularExpression(u"\\nvoid \\w+::%1\\(\\)\\n"_s.arg(name)));
        isThere |= from >= 0 && name == function;
        bodies += from < 0 ? QString() : text.mid(from, text.indexOf(u"\n}\n"_s, from) - from);
    }
    return isThere ? bodies : QString();
}

}  // namespace

class TestSbgcTable : public QObject
{
    Q_OBJECT
private slots:
    void placesAreThere();
    void commandsAreThere();
    void testsNameTheirMessage();
    void tableIsInTheHandbook();
};

void TestSbgcTable::placesAreThere()
{
    const QString pages
        = contentOf(u"app/mainwindow/pagetable.cpp"_s) + contentOf(u"app/families/familypages.cpp"_s);
    const QStringList elsewhere{u"connecting"_s, u"Start motors"_s, u"Stop motors"_s, u"everywhere"_s};
    QVERIFY(pages.contains(u"\"Actions\""_s) && pages.contains(u"\"Console\""_s));
    for (const MessageSpec &message : messages()) {
        for (const QString &place : placesOf(message))
            QVERIFY2(elsewhere.contains(place) || pages.contains(u"(\"Pages\", \"%1\")"_s.arg(place)),
                     qPrintable(place));
        QVERIFY2(!*message.where || !commandsOf(message).isEmpty(), message.name);
    }
}

// Every command is one of gimbalctl's, every action one of the newest firmware's.
void TestSbgcTable::commandsAreThere()
{
    CommandContext context;
    context.families.append(family());
    QStringList known;
    for (const auto &command : allCommands(context))
        known.append(QLatin1String(command->name()));
    BoardIdentity newest;
    newest.firmwareNumber = simplebgc::Device::kNewestFirmware;
    for (const char *fitted :
         {"yaw-axis", "battery", "encoders", "bode", "scripting", "current", "magnetometer", "can"})
        newest.capabilities.insert(QLatin1String(fitted));
    QStringList actions;
    for (const ActionSpec &action : availableActions(newest))
        actions.append(QLatin1String(action.key));
    for (const MessageSpec &message : messages()) {
        for (const QString &command : commandsOf(message)) {
            QVERIFY2(known.contains(command.section(u' ', 0, 0)), qPrintable(command));
            if (command.startsWith(u"do "_s))
                QVERIFY2(actions.contains(command.mid(3)), qPrintable(command));
        }
    }
}

void TestSbgcTable::testsNameTheirMessage()
{
    for (const MessageSpec &message : messages()) {
        const SbgcProof *proof = proofOf(message.id);
        QVERIFY2(!*message.where == !proof, message.name);
        if (!proof)
            continue;
        const QString body = bodyOf(QLatin1String(proof->test), QLatin1String(proof->function));
        QVERIFY2(!body.isEmpty(), proof->function);
        QVERIFY2(body.contains(wordsFor(message, actionsOf(message))),
                 qPrintable(u"%1 in %2"_s.arg(QLatin1String(message.name), QLatin1String(proof->function))));
    }
}

// GIMBAL_WRITE_TABLES=1 writes it.
void TestSbgcTable::tableIsInTheHandbook()
{
    QStringList rows{u"| Number | Command | Way | Since | State | Where | gimbalctl | Test |"_s,
                     u"|---|---|---|---|---|---|---|---|"_s};
    for (const MessageSpec &message : messages())
        rows.append(rowOf(message));
    const QString begin = u"<!-- commands of SimpleBGC -->\n"_s;
    const QString end = u"\n<!-- end of commands -->"_s;
    QString text = contentOf(u"CONTRIBUTING.md"_s);
    const qsizetype from = text.indexOf(begin) + begin.size();
    const qsizetype to = text.indexOf(end);
    QVERIFY(from >= begin.size() && to >= from);
    const QString wanted = rows.join(u'\n');
    if (qEnvironmentVariableIsSet("GIMBAL_WRITE_TABLES")) {
        text.replace(from, to - from, wanted);
        QFile file(QStringLiteral(GIMBAL_SOURCE_DIR "/CONTRIBUTING.md"));
        QVERIFY(file.open(QIODevice::WriteOnly | QIODevice::Truncate));
        file.write(text.toUtf8());
        return;
    }
    QCOMPARE(text.mid(from, to - from), wanted);
}

QTEST_GUILESS_MAIN(TestSbgcTable)
#include "tst_sbgctable.moc"
