// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/workspace.h"

#include "protocol/record/configurationformats.h"
#include "widgets/models/missingtext.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"

#include <QFileInfo>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

namespace {

// Telemetry older than this says nothing about the present.
constexpr auto kStale = 1500ms;

}  // namespace

QString temperatureText(double celsius, bool fahrenheit)
{
    if (std::isnan(celsius))
        return {};
    return fahrenheit ? Workspace::tr("%1 °F").arg(numberText(celsius * 1.8 + 32.0, 0))
                      : Workspace::tr("%1 °C").arg(numberText(celsius, 0));
}

Workspace::Workspace(Links links, QList<Family> families, Theme &theme, Settings &settings, QObject *parent)
    : QObject(parent)
    , m_theme(theme)
    , m_settings(settings)
    , m_links(std::move(links))
    , m_client(m_links.transports, std::move(families))
    , m_live(m_client, m_configuration)
    , m_notifications(m_client, m_configuration)
    , m_telemetry(m_client)
    , m_freshness(m_client)
    , m_edits(m_configuration)
    , m_journal(m_configuration, m_edits, m_history)
    , m_naming(m_client, m_history, m_journal, m_notifications)
    , m_recorder(m_client)
    , m_linkMarks(m_client, m_configuration, m_live, m_marks)
    , m_alarms(m_client, m_configuration, m_live, m_telemetry, m_linkMarks, m_settings)
    , m_writer(m_client, m_configuration, m_live, m_edits, m_history, m_notifications)
    , m_confirmations(m_notifications)
{
    connect(&m_journal, &EditJournal::leftoverFound, this, &Workspace::offerLeftover);
    m_notifications.follow(m_journal);
    m_notifications.follow(m_recorder);
    connect(&m_writer, &BoardWriter::completed, this,
            [this] { setUnstored(false); });  // a write ends with storing
    connect(&m_live, &LiveModel::changeCountChanged, this, &Workspace::unstoredChanged);
    connect(&m_writer, &BoardWriter::conflicted, this, &Workspace::readBoard);
    connect(&m_writer, &BoardWriter::finished, this, &Workspace::writeFinished);
    connect(this, &Workspace::boardRead, &m_notches, &NotchAdviser::makeGood);
    connect(&m_notches, &NotchAdviser::readWanted, this, &Workspace::readBoard);
    connect(this, &Workspace::writeFinished, this, [this] {
        if (lastReport())
            m_linkMarks.addWritten(*lastReport());
    });
    connect(this, &Workspace::worldChanged, &m_linkMarks, &LinkMarks::addWorld);
    connect(&m_client, &DeviceClient::statisticsChanged, this,
            [this] { m_linkMarks.look(latest(roles().activeProfile), faults()); });
    connect(&m_writer, &BoardWriter::snapshotTaken, this, &Workspace::snapshotTaken);
    connect(&m_settings, &Settings::changed, this, &Workspace::applySettings);
    connect(&m_client, &DeviceClient::stateChanged, this, &Workspace::onState);
    connect(&m_client, &DeviceClient::statisticsChanged, this, &Workspace::followActiveProfile);
}

Workspace::~Workspace()
{
    shutDown();
}

void Workspace::shutDown()
{
    m_journal.flush();
    m_recorder.stop();
    m_confirmations.forget();
    m_client.shutDown();
}

void Workspace::connectTo(const LinkAddress &address, const QString &family)
{
    m_settings.setLastAddress(address.toString());
    m_client.connectTo(address, family);
}

void Workspace::onState(DeviceClient::State state)
{
    if (state != DeviceClient::State::Connected) {
        m_confirmations.forget();
        if (state == DeviceClient::State::Disconnected && std::exchange(m_stopWhenConnected, false))
            m_notifications.reportMotorsMayRun(tr("No board was reached: the motors were not switched off."));
        if (state == DeviceClient::State::Disconnected)
            setGuided(false);
        return;
    }
    if (std::exchange(m_stopWhenConnected, false))
        m_client.motorsOff();
    m_writer.beginLink();
    m_reading = false;
    m_heldSpan.reset();
    if (m_client.identity().serial != m_unstoredSerial)
        setUnstored(false);  // another board; what the same one did meanwhile is not known
    offerWayOut();
    applySettings();
    readBoard();
}

void Workspace::applySettings()
{
    if (const auto store = m_client.telemetry())
        store->setRetention(m_settings.retentionMinutes() * 60.0);
}

void Workspace::readBoard()
{
    readKnowing(std::nullopt);
}

// Values that are in use without being stored: those given, or those known when the answer comes.
void Workspace::readKnowing(const std::optional<LiveValues> &live)
{
    if (m_reading)
        return;
    m_reading = true;
    m_client
        .submit<Configuration>(
            [](Channel &channel, Device &device) { return device.readConfiguration(channel); })
        .then(this, [this, live](const Result<Configuration> &answer) {
            m_reading = false;
            if (!answer) {
                if (!isEndOfLink(answer.error()))
                    m_notifications.report(answer.error(), Concern::Reading);
                return;
            }
            m_notifications.settle(Concern::Reading);
            const bool sameBoard = !m_configuration.isEmpty()
                && answer->identity().serial == std::as_const(m_configuration).board().identity().serial;
            Configuration read = sameBoard ? withoutLive(*answer, live.value_or(m_live.unsaved())) : *answer;
            if (sameBoard)
                keepMissing(read);
            m_offlineFile.clear();
            if (!m_configuration.rebase(read)) {
                m_journal.flush();  // edits of another board stay in its journal
                m_edits.undoStack().clear();
                m_configuration.reset(read);
            }
            m_writer.offerRepair();
            tellMissing(read);
            emit boardRead();
        });
}

// Edits are kept in the parts that did not come this time: these stay as they were read before, but count as
// missing. What cannot be read over this link is told by its page.
void Workspace::keepMissing(Configuration &read) const
{
    const Configuration &before = std::as_const(m_configuration).board();
    if (before.identity().firmwareNumber != read.identity().firmwareNumber)
        return;
    const std::vector<MissingPart> missing = read.missing();
    for (const MissingPart &part : missing) {
        if (part.why.code == ErrorCode::Unsupported)
            continue;
        if (part.key.block == MissingPart::kProfileNames)
            read.setProfileNames(before.profileNames());
        else if (before.blocks().contains(part.key))
            read.setBlock(part.key, before.block(part.key));
        read.addMissing(part.key, part.why);
    }
}

void Workspace::tellMissing(const Configuration &configuration)
{
    std::vector<MissingPart> unknown;
    std::vector<MissingPart> kept;
    for (const MissingPart &part : configuration.missing()) {
        if (part.why.code == ErrorCode::Unsupported)
            continue;
        const bool isKept = part.key.block == MissingPart::kProfileNames
            ? !configuration.profileNames().isEmpty()
            : configuration.blocks().contains(part.key);
        (isKept ? kept : unknown).push_back(part);
    }
    if (!unknown.empty())
        m_notifications.report({ErrorCode::Incomplete, missingText(configuration, unknown), 0},
                               Concern::Reading);
    if (!kept.empty())
        m_notifications.report(
            ErrorText{tr("Parts of the board could not be read again."),
                      tr("What is shown there was read before."),
                      tr("Read the board again; if parts keep missing, check cable and power."),
                      missingText(configuration, kept)},
            Concern::Reading);
}

void Workspace::write(const Configuration &wanted, OtherValues others)
{
    m_writer.write(wanted, others);
}

void Workspace::discardUnsaved()
{
    m_edits.discardAll();
    m_journal.drafts().clear();
}

void Workspace::offerLeftover(int steps, int texts)
{
    if (m_client.isConnected() && !m_client.identity().writable)
        return;  // they are kept until the board itself is connected
    Offer question;
    if (steps > 0)
        question.text = tr("%n unsaved step(s) of an earlier run belong to this board.", nullptr, steps);
    if (texts > 0)
        question.text += (steps > 0 ? u" "_s : QString())
            + tr("%n unfinished text(s) of an earlier run belong to this board.", nullptr, texts);
    question.choices.append({tr("Restore them"), [this] {
                                 if (!m_journal.restoreLeftover())
                                     m_notifications.notify(tr("None of it fits this board any more."),
                                                            Notice::Attention);
                             }});
    question.choices.append({tr("Throw them away"), [this] { m_journal.dropLeftover(); }});
    m_notifications.ask(question);
}

Result<ConfigurationFile> Workspace::loadFile(const QString &path) const
{
    return loadConfiguration(path, m_client.families());
}

Result<void> Workspace::openFile(const QString &path)
{
    if (m_client.isConnected())
        return failure(ErrorCode::Busy, u"disconnect first"_s);
    if (const auto recording = Recording::describe(path)) {
        connectTo(LinkAddress::replay(path), recording->value(u"family"_s).toString());
        return {};
    }
    const auto file = loadFile(path);
    if (!file)
        return tl::unexpected(file.error());
    m_journal.flush();
    m_edits.undoStack().clear();
    m_offlineFile = path;
    m_configuration.reset(file->configuration);
    tellMissing(file->configuration);
    if (!file->unknownKeys.isEmpty()) {
        m_notifications.notify(tr("%n entry(s) of the file are unknown and were left out.", nullptr,
                                  int(file->unknownKeys.size())),
                               Notice::Attention);
    }
    return {};
}

Result<void> Workspace::applyFile(const QString &path, std::optional<int> from, int to)
{
    if (m_configuration.isEmpty())
        return failure(ErrorCode::NotConnected);
    const auto file = loadFile(path);
    if (!file)
        return tl::unexpected(file.error());
    if (file->configuration.identity().family != std::as_const(m_configuration).board().identity().family)
        return failure(ErrorCode::BadFile, tr("The file is of another family of boards."));
    QStringList skipped;
    const Configuration wanted
        = applied(std::as_const(m_configuration).edited(), file->configuration, skipped);
    const QString name = QFileInfo(path).fileName();
    if (from)
        skipped
            += m_edits.applyProfile(wanted, *from, to, tr("Load profile %1 from %2").arg(to + 1).arg(name));
    else
        m_edits.apply(wanted, tr("Load %1").arg(name));
    skipped += file->unknownKeys;
    tellMissing(file->configuration);
    if (!file->missingKeys.isEmpty()) {
        m_notifications.notify(tr("%n value(s) are not in the file and got their defaults: %1", nullptr,
                                  int(file->missingKeys.size()))
                                   .arg(file->missingKeys.mid(0, 8).join(u", "_s)),
                               Notice::Attention);
    }
    if (!skipped.isEmpty()) {
        m_notifications.notify(tr("%n value(s) of the file do not fit this board and were left out: %1",
                                  nullptr, int(skipped.size()))
                                   .arg(withNumbers(skipped.mid(0, 8).join(u", "_s))),
                               Notice::Attention);
    }
    return {};
}

Result<void> Workspace::saveFile(const QString &path) const
{
    return saveConfiguration(path, m_configuration.edited(), u"saved by the operator"_s, m_client.families());
}

void Workspace::takeSnapshot()
{
    const auto saved = m_history.save(std::as_const(m_configuration).board(), u"by the operator"_s);
    if (!saved) {
        m_notifications.report(saved.error());
        return;
    }
    const Configuration &board = std::as_const(m_configuration).board();
    if (board.missing().empty())
        m_notifications.notify(tr("Snapshot taken."));
    else
        m_notifications.report(
            ErrorText{tr("The snapshot is incomplete."),
                      tr("It lacks what could not be read: %1.").arg(missingText(board, board.missing())),
                      tr("Read the board again, then take another."),
                      {}});
    emit snapshotTaken();
}

bool Workspace::isSimulated() const
{
    return m_client.isConnected() && m_client.address().kind() == LinkAddress::Kind::Simulator;
}

void Workspace::changeWorld(const QString &assignment)
{
    if (const auto changed = m_links.changeWorld(m_client.address(), assignment); !changed)
        m_notifications.report(changed.error());
    else
        emit worldChanged(assignment);
}

QFuture<bool> Workspace::saveLive()
{
    if (m_guided) {
        tellGuided();
        return QtFuture::makeReadyFuture(false);
    }
    return perform(m_client.device() && m_client.device()->live() ? m_client.device()->live()->storeAction()
                                                                  : QString(),
                   {})
        .then(this, [this](const Result<ActionOutcome> &saved) {
            if (!saved)
                return false;
            m_notifications.notify(
                tr("Stored on the board. The board as it was is kept in %1").arg(saved->snapshotPath));
            return true;
        });
}

void Workspace::useProfile(int profile)
{
    if (!m_client.isConnected() || m_client.address().isReplay()) {
        m_configuration.setShownProfile(profile);
        return;
    }
    m_switchingProfile = true;
    m_client
        .submit<bool>([profile](Channel &channel, Device &device) -> Result<bool> {
            if (!device.profiles())
                return failure(ErrorCode::Unsupported, u"this board has one profile"_s);
            const auto selected = device.profiles()->selectProfile(channel, profile);
            return selected ? Result<bool>(true) : tl::unexpected(selected.error());
        })
        .then(this, [this, profile](const Result<bool> &done) {
            m_switchingProfile = false;
            if (!done) {
                m_notifications.report(done.error());
                emit m_configuration.activeProfileChanged(m_configuration.board().activeProfile());
                return;
            }
            m_configuration.setActiveProfile(profile);
            m_configuration.setShownProfile(profile);
        });
}

void Workspace::setGuided(bool guided)
{
    if (std::exchange(m_guided, guided) != guided)
        emit guidedChanged();
}

void Workspace::tellGuided()
{
    m_notifications.report({tr("The gimbal is being set up."),
                            tr("Storing and starting the motors are steps of the setup."),
                            tr("Go on with it, or cancel it first."),
                            {}});
}

void Workspace::setMotors(bool on)
{
    if (m_client.address().isReplay() && m_client.isConnected()) {
        m_notifications.notify(tr("This is a recording: there are no motors to switch."), Notice::Hint);
        return;
    }
    const DeviceClient::State state = m_client.state();
    if (!on && (state == DeviceClient::State::Connecting || state == DeviceClient::State::Reconnecting)) {
        m_stopWhenConnected = true;
        m_notifications.notify(
            tr("There is no link yet. The motors are switched off as soon as there is one."),
            Notice::Attention);
        return;
    }
    if (!on) {
        m_client.motorsOff();
        return;
    }
    if (m_guided) {
        tellGuided();
        return;
    }
    // As a moving job: a stop that comes meanwhile cancels a start that still waits for its turn.
    m_client
        .submit<void>(
            [](Channel &channel, Device &device) -> Result<void> {
                if (!device.motorSwitch())
                    return failure(ErrorCode::Unsupported,
                                   u"this board has no command that switches its motors on"_s);
                return device.motorSwitch()->switchMotorsOn(channel);
            },
            DeviceClient::JobKind::Moving)
        .then(this, [this](const Result<void> &done) {
            if (!done && done.error().code != ErrorCode::Cancelled)
                m_notifications.report(done.error());
        });
}

double Workspace::latest(int channel) const
{
    const auto store = m_client.telemetry();
    return store ? double(store->latest(channel)) : std::nan("");
}

bool Workspace::hasAction(const QString &key) const
{
    if (!tables())
        return false;
    const auto actions = tables()->actions();
    return std::any_of(actions.begin(), actions.end(),
                       [&key](const ActionSpec &action) { return key == QLatin1String(action.key); });
}

const Family *Workspace::family() const
{
    if (m_client.isConnected())
        return findFamily(m_client.families(), m_client.identity().family);
    return m_configuration.isEmpty()
        ? nullptr
        : findFamily(m_client.families(), std::as_const(m_configuration).board().identity().family);
}

const Family *Workspace::expectedFamily() const
{
    if (const Family *shown = family())
        return shown;
    return findFamily(m_client.families(), m_links.defaultFamily);
}

const Device *Workspace::tables() const
{
    if (m_client.isConnected())
        return m_client.device();
    const Family *shown = expectedFamily();
    if (std::exchange(m_tablesOf, shown->key) != shown->key || !m_tables)
        m_tables = shown->makeDevice();
    return m_tables.get();
}

int Workspace::profileCount() const
{
    if (m_client.isConnected())
        return m_client.identity().profileCount;
    return m_configuration.isEmpty() ? 0 : std::as_const(m_configuration).board().identity().profileCount;
}

QString Workspace::configurationFilter() const
{
    QString filter = tr("GimbalDesk configurations (*.json)");
    if (const Family *shown = family(); shown && shown->settingsFile)
        filter += u";;%1 (*.%2)"_s.arg(shown->settingsFile->name, shown->settingsFile->suffix);
    return filter;
}

QString Workspace::openFilter() const
{
    QStringList endings{u"*.json"_s, u"*.gimbalrec"_s};
    for (const Family &each : m_client.families()) {
        if (each.settingsFile)
            endings.append(u"*."_s + each.settingsFile->suffix);
    }
    return tr("Configurations and recordings (%1)").arg(endings.join(u' '));
}

void Workspace::setUnstored(bool unstored)
{
    m_unstoredSerial = m_client.identity().serial;
    if (unstored == std::exchange(m_unstored, unstored))
        return;
    emit unstoredChanged();
}

// Some boards can be reached only indirectly; offers what restores the direct connection.
void Workspace::offerWayOut()
{
    const StatusWords *words = m_client.device()->statusWords();
    const auto way = words ? words->connectOffer() : std::nullopt;
    if (!way || !m_client.identity().writable || m_client.address().isReplay())
        return;
    Offer question;
    question.text = tableText(way->text);
    question.choices.append({tableText(way->choice), [this, key = QString::fromLatin1(way->action)] {
                                 perform(key, {}).then(this, [this](const Result<ActionOutcome> &done) {
                                     if (done)
                                         readBoard();  // now including scripts
                                 });
                             }});
    question.choices.append({tr("Leave it as it is"), [] {}});
    m_notifications.ask(question);
}

const ChannelRoles &Workspace::roles() const
{
    return m_client.roles();
}

std::optional<bool> Workspace::motorsRunning() const
{
    const auto store = m_client.telemetry();
    if (!m_client.isConnected() || !store)
        return {};
    const TimePoint now = Clock::now();
    if (store->rows() != m_lastRows) {
        m_lastRows = store->rows();
        m_lastRowsAt = now;
    }
    const double value = latest(roles().outputs);
    if (std::isnan(value) || now - m_lastRowsAt > kStale)
        return {};
    return value != 0.0;
}

std::vector<BoardFault> Workspace::faults() const
{
    if (!m_client.isConnected())
        return {};
    const ChannelRoles channels = roles();
    const double bits = latest(channels.faults);
    const double detail = latest(channels.faultDetail);
    const FaultWords *words = m_client.device()->faultWords();
    if (std::isnan(bits) || !words)
        return {};
    return words->faults(unsigned(bits), std::isnan(detail) ? 0U : unsigned(detail));
}

// A menu button, a radio or another program can change the profile as well.
void Workspace::followActiveProfile()
{
    const double active = latest(roles().activeProfile);
    if (std::isnan(active) || m_switchingProfile || isWriting() || m_reading || m_configuration.isEmpty()
        || !m_client.isConnected() || int(active) == m_configuration.board().activeProfile())
        return;
    m_configuration.setActiveProfile(int(active));
}
