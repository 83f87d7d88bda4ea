// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/workspace/workspace.h"

#include "protocol/base/filefault.h"
#include "protocol/record/configurationformats.h"
#include "widgets/gamepad/gamepadmodule.h"
#include "widgets/models/errortext.h"
#include "widgets/models/missingtext.h"
#include "widgets/models/numbertext.h"
#include "widgets/models/parametermodel.h"

#include <QFileInfo>

#include <algorithm>
#include <cmath>

using namespace Qt::StringLiterals;

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
    , m_leftSteering(m_client, m_notifications)
    , m_linkHealth(m_client, m_notifications)
    , m_writer(m_client, m_configuration, m_live, m_edits, m_history, m_notifications)
    , m_confirmations(m_client, m_notifications)
    , m_gamepad({[this](const QByteArray &key) { return m_settings.gamepad(key); },
                 [this](const QByteArray &key, const QByteArray &json) { m_settings.setGamepad(key, json); },
                 [this] {
                     const QString chosen = m_settings.chosenGamepad();
                     return Gamepad::Kind{chosen.section(u' ', 0, 0).toLatin1(), chosen.section(u' ', 1)};
                 },
                 [this](const Gamepad::Kind &kind) {
                     m_settings.setChosenGamepad(QString::fromLatin1(kind.guid) + u' ' + kind.name);
                 }},
                loadGamepadModule)
{
    connect(&m_journal, &EditJournal::leftoverFound, this, &Workspace::offerLeftover);
    connect(&m_client, &DeviceClient::stateChanged, this, [this] {
        if (m_client.isConnected())
            m_gamepad.setUse(m_client.device()->flight() ? GamepadUse::Flight : GamepadUse::Camera);
    });
    m_notifications.follow(m_journal);
    m_notifications.follow(m_recorder);
    // A write ends with storing; what else is in use it may leave so.
    connect(&m_writer, &BoardWriter::completed, this, [this] {
        const WriteReport &report = *lastReport();
        m_storedKnown |= canCompareStored();
        setUnstored(report.othersWere == OtherValues::Keep && !report.otherData.isEmpty());
    });
    connect(&m_live, &LiveModel::changeCountChanged, this, &Workspace::unstoredChanged);
    connect(&m_live, &LiveModel::notTaken, this, &Workspace::tellNotTaken);
    connect(&m_live, &LiveModel::setWithoutLink, this, [this](const LiveValues &values) {
        m_notifications.notify(
            tr("The link was gone when it was set: %1 is not in use. Set it again when the board is back.")
                .arg(liveText(std::as_const(m_configuration).board(), values)),
            Notice::Attention);
    });
    // After those who began it have heard of its end.
    connect(&m_live, &LiveModel::heldChanged, this,
            [this] { QTimer::singleShot(0, this, &Workspace::readWhenFree); });
    connect(&m_writer, &BoardWriter::conflicted, this, &Workspace::readBoard);
    connect(&m_writer, &BoardWriter::started, this, &Workspace::writeStarted);
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
    connect(&m_settings, &Settings::failed, &m_notifications,
            [this](const Error &error) { m_notifications.report(error, Concern::Settings); });
    // As soon as somebody listens.
    QTimer::singleShot(0, this, [this] {
        for (const Error &error : m_settings.problems())
            m_notifications.report(error, Concern::Settings);
    });
    connect(&m_client, &DeviceClient::stateChanged, this, &Workspace::onState);
    connect(&m_client, &DeviceClient::connectionLost, this, &Workspace::onLost);
    connect(&m_client, &DeviceClient::statisticsChanged, this, &Workspace::followActiveProfile);
    const auto noteProfile = [this] { m_profileKnownAt = Clock::now(); };
    connect(&m_configuration, &ConfigurationModel::boardReset, this, noteProfile);
    connect(&m_configuration, &ConfigurationModel::boardReset, this, &Workspace::compareWithText);
    connect(&m_configuration, &ConfigurationModel::storedChanged, this, &Workspace::compareWithText);
    connect(&m_configuration, &ConfigurationModel::activeProfileChanged, this, noteProfile);
    connect(&m_client, &DeviceClient::statisticsChanged, this, &Workspace::settleMotors);
    connect(&m_client, &DeviceClient::statisticsChanged, this, &Workspace::readUnknown);
    connect(&m_client, &DeviceClient::motorsOffBegun, &m_confirmations, &Confirmations::withdraw);
    connect(&m_client, &DeviceClient::motorsOffFinished, this, [this](bool isProven) {
        m_stopProvenAt = isProven ? std::optional(Clock::now()) : std::nullopt;
        m_stopUnprovenAt = isProven ? std::nullopt : std::optional(Clock::now());
        if (!isProven && m_client.state() == DeviceClient::State::Reconnecting)
            stopAtNextLink();
        if (!isProven)
            return;
        m_ranLast = false;
        m_notifications.settle(Concern::Silence);
    });
    connect(&m_client, &DeviceClient::connectionLost, this, [this] {
        if (m_client.isStopUnproven())
            stopAtNextLink();
    });
    connect(&m_freshness, &Freshness::silentChanged, this, [this](bool isSilent) {
        if (const auto since = m_freshness.silentSince(); isSilent && since && m_ranLast == true)
            m_notifications.reportSilence(*since);
        else
            m_notifications.settle(Concern::Silence);
    });
    connect(&m_client, &DeviceClient::alarmChanged, this, [this](const AlarmReport &report) {
        if (!report.isOver && report.alarm.kind <= AlarmKind::Oscillation)
            m_alarmedWith = m_live.unsaved();
    });
    connect(&m_notifications, &Notifications::boardReplaced, this, [this] { m_alarmedWith.clear(); });
    connect(&m_freshness, &Freshness::frozenChanged, this, [this](bool isFrozen) {
        if (isFrozen)
            m_notifications.report({tr("The board sends the same live data again and again."),
                                    tr("What they say of its motors is old."),
                                    m_notifications.flies()
                                        ? m_notifications.keepAwayText()
                                        : tr("Keep clear of the gimbal. Restart the board if it stays so."),
                                    {}},
                                   Concern::Frozen);
        else
            m_notifications.settle(Concern::Frozen);
    });
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
    followMotors(state);
    m_unread = true;
    if (state != DeviceClient::State::Connected) {
        m_confirmations.forget();
        if (state == DeviceClient::State::Disconnected && std::exchange(m_stopWhenConnected, false)) {
            m_notifications.settle(Concern::Motors);  // they are switched off no more
            m_notifications.reportMotorsMayRun(tr("No board was reached: the motors were not switched off."));
        }
        if (state == DeviceClient::State::Disconnected) {
            setGuided(false);
            m_usedBefore.clear();
            m_alarmedWith.clear();
        }
        return;
    }
    if (std::exchange(m_stopWhenConnected, false))
        m_client.motorsOff();
    m_writer.beginLink();
    m_reading = false;
    m_framesHeard.reset();
    m_rereads = 0;
    m_storedKnown = false;
    m_isDoubted = false;
    m_heldSpan.reset();
    if (m_client.identity().serial != m_unstoredSerial)
        setUnstored(false);  // another board; what the same one did meanwhile is not known
    offerWayOut();
    applySettings();
    readBoard();
}

// A board that restarts loses what was in use without being stored.
void Workspace::onLost()
{
    const DeviceClient::Loss loss = m_client.loss();
    m_wereOff = !m_ranLast.value_or(!m_wereOff) && loss != DeviceClient::Loss::OrderedRestart;
    m_usedBefore = loss == DeviceClient::Loss::Link ? m_live.unsaved() : LiveValues();
    if (loss == DeviceClient::Loss::Link)
        return;
    tellLost(m_live.unsaved());
    m_live.forget();
    setUnstored(false);
}

void Workspace::tellLost(const LiveValues &lost)
{
    if (!lost.empty())
        m_notifications.notify(tr("%n value(s) that were in use without being stored are lost: the board "
                                  "restarted. In use before: %1",
                                  nullptr, int(lost.size()))
                                   .arg(liveText(std::as_const(m_configuration).board(), lost)),
                               Notice::Attention);
}

void Workspace::tellNotTaken(const LiveValues &values)
{
    LiveValues used = values;
    for (LiveValue &value : used)
        value.inUse = value.stored;
    const Configuration &board = std::as_const(m_configuration).board();
    m_notifications.notify(tr("The board did not get what was set while it was silent: %1. It uses %2.")
                               .arg(liveText(board, values), liveText(board, used)),
                           Notice::Attention);
}

void Workspace::applySettings()
{
    if (const auto store = m_client.telemetry())
        store->setRetention(m_settings.retentionMinutes() * 60.0);
}

void Workspace::write(const Configuration &wanted, OtherValues others)
{
    if (m_guided)
        tellGuided();  // it would be stored
    else if (!refusesMeanwhile())
        m_writer.write(wanted, others);
}

void Workspace::discardUnsaved()
{
    m_edits.discardAll();
    m_journal.drafts().clear();
}

Result<ConfigurationFile> Workspace::loadFile(const QString &path) const
{
    return loadConfiguration(path, m_client.families());
}

Result<void> Workspace::openFile(const QString &path)
{
    if (m_client.isConnected())
        return failure(ErrorCode::Busy, u"disconnect first"_s);
    const auto recording = Recording::describe(path);
    if (recording) {
        connectTo(LinkAddress::replay(path), recording->value(u"family"_s).toString());
        return {};
    }
    const auto file = loadFile(path);
    if (!file) {  // what began as a recording is a broken recording
        const bool isRecording = file.error().file && file.error().file->problem == FileProblem::OtherKind
            && recording.error().file && recording.error().file->problem != FileProblem::OtherKind;
        return tl::unexpected(isRecording ? recording.error() : file.error());
    }
    m_journal.flush();
    m_edits.undoStack().clear();
    m_offlineFile = path;
    m_configuration.reset(withOwnSerial(file->configuration, path));
    m_journal.remind();
    tellMissing(file->configuration);
    if (!file->missingKeys.isEmpty()) {
        m_notifications.notify(tr("%n value(s) are not in the file; what is shown for them are defaults: %1",
                                  nullptr, int(file->missingKeys.size()))
                                   .arg(file->missingKeys.join(u", "_s)),
                               Notice::Attention);
    }
    if (!file->unknownKeys.isEmpty()) {
        m_notifications.notify(tr("%n entry(s) of the file are unknown and were left out: %1", nullptr,
                                  int(file->unknownKeys.size()))
                                   .arg(file->unknownKeys.mid(0, 8).join(u", "_s)),
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
    if (const auto same
        = checkSameFamily(file->configuration, path, std::as_const(m_configuration).board().identity().family,
                          m_client.families());
        !same)
        return same;
    QStringList skipped;
    const Configuration wanted = applied(std::as_const(m_configuration).edited(), *file, skipped);
    const QString name = QFileInfo(path).fileName();
    if (from)
        skipped
            += m_edits.applyProfile(wanted, *from, to, tr("Load profile %1 from %2").arg(to + 1).arg(name));
    else
        m_edits.apply(wanted, tr("Load %1").arg(name));
    skipped += file->unknownKeys;
    tellMissing(file->configuration);
    if (!file->missingKeys.isEmpty()) {
        m_notifications.notify(tr("%n value(s) are not in the file and stay as they are: %1", nullptr,
                                  int(file->missingKeys.size()))
                                   .arg(file->missingKeys.join(u", "_s)),
                               Notice::Attention);
    }
    if (!file->rounded.isEmpty()) {
        m_notifications.notify(tr("%n value(s) of the file were rounded to what the board can hold: %1",
                                  nullptr, int(file->rounded.size()))
                                   .arg(file->rounded.join(u"; "_s)),
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

Result<void> Workspace::saveFile(const QString &path)
{
    // What is in a file only is what the file is about; beside a board it must be told from what that holds.
    const int edits = m_client.isConnected() ? m_configuration.changeCount() : 0;
    const auto saved
        = saveConfiguration(path, withoutOwnSerial(m_configuration.edited()),
                            edits == 0 ? u"saved by the operator"_s
                                       : u"saved by the operator, with %1 unwritten changes"_s.arg(edits),
                            m_client.families());
    if (saved && edits > 0)
        m_notifications.notify(
            tr("The file holds %n unwritten change(s): it is not what the board holds.", nullptr, edits),
            Notice::Attention);
    return saved;
}

void Workspace::takeSnapshot()
{
    const bool isInUse = canCompareStored() && !m_storedKnown;
    const auto saved = m_history.save(std::as_const(m_configuration).board(),
                                      isInUse ? u"by the operator, in use"_s : u"by the operator"_s);
    if (!saved) {
        m_notifications.report(saved.error(), Concern::Saving);
        return;
    }
    const Configuration &board = std::as_const(m_configuration).board();
    if (isInUse)
        m_notifications.notify(tr("Snapshot taken of what is in use: it has not been compared with what is "
                                  "stored, which may differ."),
                               Notice::Attention);
    else if (board.missing().empty())
        m_notifications.notify(tr("Snapshot taken."));
    if (!board.missing().empty())
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

void Workspace::useProfile(int profile)
{
    if (!m_client.isConnected() || m_client.address().isReplay()) {
        m_configuration.setShownProfile(profile);
        return;
    }
    if (refusesMeanwhile()) {
        emit m_configuration.activeProfileChanged(m_configuration.board().activeProfile());
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

void Workspace::setGuided(bool guided, const QString &steps)
{
    m_guidedSteps = steps;
    if (std::exchange(m_guided, guided) != guided)
        emit guidedChanged();
}

bool Workspace::refusesToBegin()
{
    if (refusesMeanwhile())
        return true;
    if (isWriting())
        m_notifications.report({ErrorCode::Busy, {}, 0});
    return isWriting();
}

bool Workspace::refusesMeanwhile()
{
    if (m_flown)
        m_notifications.report({tr("It is armed from here."),
                                tr("Nothing is written, stored or begun while its motors may turn."),
                                tr("Disarm it first, on the page “Flight”."),
                                {}});
    else if (m_live.isHeld())
        m_notifications.report(
            {tr("A search, measurement or calibration is running."),
             tr("A change made now would only take effect afterwards, and replace what was "
                "found."),
             tr("Wait until it is over, or end it first. F12 and the button STOP MOTORS switch the "
                "motors off at once."),
             {}});
    return m_flown || m_live.isHeld();
}

void Workspace::tellGuided()
{
    m_notifications.report({tr("The gimbal is being set up."),
                            tr("Storing and starting the motors are steps of the setup."),
                            tr("Go on with it, or cancel it first."),
                            {}});
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
    QStringList endings{u"*.json"_s, u"*.gimbalrec"_s, u"*.rec"_s, u"*.csv"_s};
    for (const Family &each : m_client.families()) {
        if (each.settingsFile)
            endings.append(u"*."_s + each.settingsFile->suffix);
    }
    return tr("Configurations and recordings (%1)").arg(endings.join(u' '));
}

void Workspace::setUnstored(bool unstored)
{
    m_unstoredSerial = m_client.identity().serial;
    m_unstored = unstored;
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
    question.topic = Topic::WayOut;
    m_notifications.ask(question);
}

const ChannelRoles &Workspace::roles() const
{
    return m_client.roles();
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

void Workspace::setVideoRecording(const QString &path)
{
    if (std::exchange(m_videoRecording, path) != path)
        emit videoRecordingChanged();
}

// A menu button, a radio or another program can change the profile as well. A sample from before the last
// change says nothing about it: on a slow line it is the newest one for a while.
void Workspace::followActiveProfile()
{
    const auto store = m_client.telemetry();
    const int channel = roles().activeProfile;
    const double active = latest(channel);
    if (std::isnan(active) || store->latestAt(channel) <= m_profileKnownAt || m_switchingProfile
        || isWriting() || m_reading || m_configuration.isEmpty() || !m_client.isConnected()
        || int(active) == m_configuration.board().activeProfile())
        return;
    m_configuration.setActiveProfile(int(active));
}
