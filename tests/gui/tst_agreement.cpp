// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/bars.h"
#include "app/mainwindow/footbar.h"
#include "app/mainwindow/messagebar.h"
#include "app/pages/board/consolepage.h"
#include "app/pages/setup/parameterspage.h"
#include "app/pages/tune/tuningpage.h"
#include "protocol/simplebgc/commands.h"
#include "protocol/simulator/simplebgc/board.h"
#include "protocol/simulator/storm32/board.h"
#include "tests/support/boardhost.h"
#include "tests/support/named.h"
#include "tests/support/patience.h"
#include "tests/support/windowrig.h"
#include "widgets/forms/liveslider.h"
#include "widgets/forms/numberbox.h"
#include "widgets/forms/parameterform.h"
#include "widgets/forms/reviewdialog.h"
#include "widgets/forms/valueeditor.h"
#include "widgets/models/parametermodel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSignalSpy>
#include <QUndoStack>

using namespace Qt::StringLiterals;

/// After every kind of operation the screen says of the board what the board holds: what is in use, what is
/// stored, and whether the two differ. Both memories are read past all models and past the link.
class TestAgreement : public QObject
{
    Q_OBJECT
private slots:
    void typedIntoABrokenLinkIsTold();
    void cleanup();
    void storm_data();
    void storm();
    void stormOfEachLayout_data();
    void stormOfEachLayout();
    void stormByMavlink_data();
    void stormByMavlink();
    void stormReviewOffersEveryWay_data();
    void stormReviewOffersEveryWay();
    void stormSetBeforeTheLink_data();
    void stormSetBeforeTheLink();
    void storingListsWhatElseIsInUse();
    void steeringThatNobodyEndedIsToldAndEnded();
    void simplebgc_data();
    void simplebgc();
    void whatChangedBehindTheLinkIsNamed();

private:
    /// Screen and board agree at first and after each operation of the row.
    void agreeAfterEach();
    /// @param usb a board on USB answers plain commands even with its heartbeat on
    bool openStorm(int firmware = 96, bool usb = true);
    /// Another program has set words in RAM before this one connects.
    bool openStormSetBefore(const QMap<int, int> &words);
    bool openSimplebgc();
    bool open(std::unique_ptr<SimulatedBoard> board, const SimulatorOptions &options);
    int valueInUse(int word)
    {
        return m_host->with<storm32::SimulatedBoard>([word](auto &board) { return board.inUse(word); });
    }
    int storedValue(int word)
    {
        return m_host->with<storm32::SimulatedBoard>([word](auto &board) { return board.stored(word); });
    }
    // The first thing that the screen says otherwise than the board; empty if it agrees in all.
    QString stormDisagreement(const storm32::SimulatedBoard &storm);
    QString simplebgcDisagreement(const simplebgc::SimulatedBoard &simplebgc);
    // The window's side stands still meanwhile.
    QString disagreement()
    {
        return m_isStorm ? m_host->with<storm32::SimulatedBoard>(
                   [this](const auto &board) { return stormDisagreement(board); })
                         : m_host->with<simplebgc::SimulatedBoard>(
                             [this](const auto &board) { return simplebgcDisagreement(board); });
    }
    void perform(const QString &operation);

    LiveModel &live() { return m_rig->workspace().live(); }
    bool setLive(const QString &key, double raw)
    {
        live().setValue(m_rig->spec(key).id, raw);
        return QTest::qWaitFor([this] { return live().isSettled(); }, kPatience);
    }
    bool write(OtherValues others = OtherValues::Keep)
    {
        QSignalSpy finished(&m_rig->workspace(), &Workspace::writeFinished);
        m_rig->window().review();
        ReviewDialog *review = m_rig->window().reviewDialog();
        if (!review)
            return false;
        review->othersChoice()->setCurrentIndex(review->othersChoice()->findData(int(others)));
        review->accept();
        return QTest::qWaitFor([&finished] { return finished.count() == 1; }, kPatience)
            && m_rig->workspace().lastReport()->isComplete();
    }
    bool act(const QString &key, const QVariantMap &arguments = {})
    {
        const auto done = std::make_shared<std::optional<bool>>();
        m_rig->workspace()
            .perform(key, arguments)
            .then(&m_rig->window(),
                  [done](const Result<ActionOutcome> &outcome) { *done = outcome.has_value(); });
        return QTest::qWaitFor([done] { return done->has_value(); }, kPatience) && **done;
    }
    bool reconnect()
    {
        m_rig->client().disconnectFromBoard();
        if (!QTest::qWaitFor([this] { return !m_rig->client().isConnected(); }, kPatience))
            return false;
        m_rig->window().openLink(m_host->address());
        return QTest::qWaitFor([this] { return m_rig->client().isConnected(); }, kPatience);
    }

    std::unique_ptr<BoardHost> m_host;
    std::unique_ptr<WindowRig> m_rig;
    bool m_isStorm = false;
};

void TestAgreement::cleanup()
{
    m_rig.reset();
    m_host.reset();
}

bool TestAgreement::open(std::unique_ptr<SimulatedBoard> board, const SimulatorOptions &options)
{
    m_host = std::make_unique<BoardHost>(std::make_unique<SimulatedPort>(
        std::move(board), options,
        options.usb ? std::nullopt : std::optional(LineSettings{115200, Parity::None})));
    if (!m_host->start())
        return false;
    m_rig = std::make_unique<WindowRig>();
    return m_rig->open(m_host->address());
}

bool TestAgreement::openStorm(int firmware, bool usb)
{
    m_isStorm = true;
    SimulatorOptions options;
    options.firmware = firmware;
    options.usb = usb;
    return open(std::make_unique<storm32::SimulatedBoard>(options), options);
}

bool TestAgreement::openStormSetBefore(const QMap<int, int> &words)
{
    m_isStorm = true;
    SimulatorOptions options;
    options.firmware = 96;
    auto board = std::make_unique<storm32::SimulatedBoard>(options);
    for (auto it = words.begin(); it != words.end(); ++it)
        board->set(it.key(), it.value());
    return open(std::move(board), options);
}

bool TestAgreement::openSimplebgc()
{
    m_isStorm = false;
    SimulatorOptions options;
    return open(std::make_unique<simplebgc::SimulatedBoard>(options), options);
}

QString TestAgreement::stormDisagreement(const storm32::SimulatedBoard &storm)
{
    const Configuration &board = std::as_const(m_rig->model()).board();
    int differs = 0;
    for (const ParameterSpec &spec : board.parameters().all()) {
        const int word = spec.offset / 2;
        const auto raw
            = [&spec](int bits) { return spec.row->wire == WireType::I16 ? std::int16_t(bits) : bits; };
        const double inUse = raw(storm.inUse(word));
        const double stored = raw(storm.stored(word));
        differs += inUse != stored;
        if (board.raw(spec, 0) != stored)
            return u"%1: stored %2, said to be %3"_s.arg(spec.key).arg(stored).arg(
                board.raw(spec, 0).value_or(-1));
        if (live().value(spec.id) != inUse)
            return u"%1: %2 in use, said to be %3"_s.arg(spec.key).arg(inUse).arg(
                live().value(spec.id).value_or(-1));
    }
    const bool said = m_rig->window().findChild<UnstoredBar *>()->isVisible();
    if (said != (differs > 0) || live().changeCount() != differs)
        return u"%1 differ, said to be %2, bar %3"_s.arg(differs).arg(live().changeCount()).arg(said);
    return {};
}

QString TestAgreement::simplebgcDisagreement(const simplebgc::SimulatedBoard &simplebgc)
{
    const Configuration &board = std::as_const(m_rig->model()).board();
    const int active = simplebgc.activeProfile();
    if (board.activeProfile() != active)
        return u"profile %1, said to be %2"_s.arg(active).arg(board.activeProfile());
    int differs = 0;
    for (const ParameterSpec &spec : board.parameters().all()) {
        if (spec.row->wire == WireType::F32 || spec.row->state)
            continue;
        for (int profile = 0; profile < board.identity().profileCount; ++profile) {
            const double stored = simplebgc.stored(spec.key, profile);
            if (board.raw(spec, profile).has_value() && board.raw(spec, profile) != stored)
                return u"%1 of profile %2: stored %3, said to be %4"_s.arg(spec.key)
                    .arg(profile + 1)
                    .arg(stored)
                    .arg(*board.raw(spec, profile));
        }
        if (!live().parameters().contains(spec.id))
            continue;
        const double inUse = simplebgc.inUse(spec.key);
        differs += inUse != simplebgc.stored(spec.key, active);
        if (live().value(spec.id) != inUse)
            return u"%1: %2 in use, said to be %3"_s.arg(spec.key).arg(inUse).arg(
                live().value(spec.id).value_or(-1));
    }
    const bool said = m_rig->window().findChild<UnstoredBar *>()->isVisible();
    if (said != (differs > 0))
        return u"%1 differ, bar %2"_s.arg(differs).arg(said);
    return {};
}

void TestAgreement::perform(const QString &operation)
{
    if (operation == u"live"_s)
        QVERIFY(setLive(u"pid.roll.p"_s, 45));
    else if (operation == u"live other"_s)
        QVERIFY(setLive(u"pid.yaw.p"_s, 55));
    else if (operation == u"revert"_s)
        live().revert();
    else if (operation == u"edit"_s)
        m_rig->edit(u"pid.pitch.p"_s, m_rig->model().shownProfile(), 47);
    else if (operation == u"edit the same"_s)
        m_rig->edit(u"pid.roll.p"_s, m_rig->model().shownProfile(), 48);
    else if (operation == u"undo"_s)
        m_rig->workspace().edits().undoStack().undo();
    else if (operation == u"redo"_s)
        m_rig->workspace().edits().undoStack().redo();
    else if (operation == u"lock out"_s) {
        m_rig->edit(u"mavlink.heartbeat"_s, 0, 1);
        QVERIFY(write());
    } else if (operation == u"write"_s)
        QVERIFY(write());
    else if (operation == u"reconnect"_s)
        QVERIFY(reconnect());
    else if (operation == u"read"_s)
        m_rig->workspace().readBoard();
    else if (operation == u"save live"_s)
        m_rig->workspace().saveLive(m_rig->window());
    else if (operation == u"slot"_s)
        live().useSlot(live().slot() == LiveModel::Slot::A ? LiveModel::Slot::B : LiveModel::Slot::A);
    else if (operation.startsWith(u"profile "_s))
        m_rig->workspace().useProfile(operation.mid(8).toInt() - 1);
    else if (operation.startsWith(u"poles"_s))
        QVERIFY(act(u"setup.poles"_s, {{u"pitch"_s, 16}, {u"roll"_s, 16}, {u"yaw"_s, 16}}));
    else if (operation == u"restore one"_s)
        QVERIFY(act(u"restore"_s, {{u"word"_s, 6}}));
    else if (operation == u"console"_s) {
        auto *page = m_rig->page<ConsolePage>();
        named<QCheckBox>(page, u"Allow commands that change something"_s)->setChecked(true);
        page->input()->setText(u"setparameter index=18 value=3"_s);
        page->send();
    } else if (operation == u"set a variable"_s)
        QVERIFY(act(u"variables.write"_s, {{u"id"_s, 0}, {u"value"_s, 33}}));
    else if (operation == u"defaults of the profile"_s)
        QVERIFY(act(u"defaults"_s, {{u"what"_s, 0}}));
    else
        QVERIFY2(act(operation), qPrintable(operation));
}

void TestAgreement::storm_data()
{
    QTest::addColumn<QStringList>("operations");
    // The one that failed first: Roll P live, then Pitch P written.
    QTest::newRow("write over a live change") << QStringList{u"live"_s, u"edit"_s, u"write"_s};
    QTest::newRow("write the live value") << QStringList{u"live"_s, u"edit the same"_s, u"write"_s};
    QTest::newRow("write, then revert") << QStringList{u"live"_s, u"edit"_s, u"write"_s, u"revert"_s};
    QTest::newRow("live, store") << QStringList{u"live"_s, u"save live"_s};
    QTest::newRow("store by the action") << QStringList{u"live"_s, u"store"_s};
    QTest::newRow("retrieve") << QStringList{u"live"_s, u"poles"_s, u"retrieve"_s};
    QTest::newRow("restore one") << QStringList{u"live"_s, u"live other"_s, u"restore one"_s};
    QTest::newRow("defaults") << QStringList{u"live"_s, u"defaults"_s, u"edit"_s, u"store"_s};
    QTest::newRow("setup") << QStringList{u"poles"_s, u"live"_s, u"edit"_s, u"write"_s};
    QTest::newRow("trims") << QStringList{u"trim"_s, u"start.take"_s, u"directions.take"_s};
    QTest::newRow("restart") << QStringList{u"live"_s, u"restart"_s};
    QTest::newRow("compare") << QStringList{u"live"_s, u"stored.compare"_s};
    QTest::newRow("reconnect") << QStringList{u"live"_s, u"poles"_s, u"reconnect"_s};
    QTest::newRow("read") << QStringList{u"live"_s, u"poles"_s, u"read"_s};
    QTest::newRow("undo") << QStringList{u"live"_s,  u"edit"_s, u"write"_s, u"undo"_s,
                                         u"write"_s, u"redo"_s, u"write"_s};
    QTest::newRow("slots") << QStringList{u"live"_s, u"slot"_s, u"live other"_s,
                                          u"slot"_s, u"edit"_s, u"write"_s};
}

void TestAgreement::agreeAfterEach()
{
    QFETCH(QStringList, operations);
    QTRY_COMPARE(disagreement(), QString());
    for (const QString &operation : operations) {
        perform(operation);
        if (QTest::currentTestFailed())
            return;
        // What an operation leads to may itself ask the board again.
        for (int round = 0; round < 3; ++round)
            QVERIFY(m_rig->jobsAreDone());
        QTRY_COMPARE(operation + u' ' + disagreement(), operation + u' ');
    }
}

void TestAgreement::storm()
{
    QVERIFY(openStorm());
    agreeAfterEach();
}

void TestAgreement::stormOfEachLayout_data()
{
    QTest::addColumn<int>("firmware");
    QTest::addColumn<QStringList>("operations");
    for (const int firmware : {79, 90, 96}) {
        QTest::addRow("0.%d, connected", firmware)
            << firmware << QStringList{u"live"_s, u"edit"_s, u"write"_s, u"reconnect"_s};
        QTest::addRow("0.%d, by the console", firmware)
            << firmware << QStringList{u"console"_s, u"edit"_s, u"write"_s};
    }
}

void TestAgreement::stormOfEachLayout()
{
    QFETCH(int, firmware);
    QVERIFY(openStorm(firmware));
    agreeAfterEach();
}

void TestAgreement::stormByMavlink_data()
{
    QTest::addColumn<int>("firmware");
    QTest::addColumn<QStringList>("operations");
    for (const int firmware : {79, 90, 96}) {
        QTest::addRow("0.%d, live and back", firmware)
            << firmware << QStringList{u"lock out"_s, u"live"_s, u"revert"_s};
        QTest::addRow("0.%d, written", firmware)
            << firmware << QStringList{u"lock out"_s, u"edit"_s, u"write"_s, u"read"_s};
    }
    QTest::newRow("0.96, live, stored") << 96 << QStringList{u"lock out"_s, u"live"_s, u"store"_s};
    QTest::newRow("0.96, live, written") << 96 << QStringList{u"lock out"_s, u"edit the same"_s, u"write"_s};
    QTest::newRow("0.96, let in again")
        << 96 << QStringList{u"lock out"_s, u"heartbeat.off"_s, u"live"_s, u"edit"_s, u"write"_s};
}

// Its heartbeat is on: it answers no plain command.
void TestAgreement::stormByMavlink()
{
    QFETCH(int, firmware);
    QVERIFY(openStorm(firmware, false));
    agreeAfterEach();
}

void TestAgreement::stormReviewOffersEveryWay_data()
{
    QTest::addColumn<int>("others");
    QTest::addColumn<int>("inUse");
    QTest::addColumn<int>("stored");
    QTest::newRow("keep") << int(OtherValues::Keep) << 450 << 400;
    QTest::newRow("store") << int(OtherValues::Store) << 450 << 450;
    QTest::newRow("put back") << int(OtherValues::PutBack) << 400 << 400;
}

void TestAgreement::stormReviewOffersEveryWay()
{
    QFETCH(int, others);
    QFETCH(int, inUse);
    QFETCH(int, stored);
    QVERIFY(openStorm());
    QTRY_COMPARE(disagreement(), QString());
    perform(u"edit"_s);
    m_rig->window().review();
    QVERIFY(!m_rig->window().reviewDialog()->othersChoice()->isVisible());  // nothing else is in use
    m_rig->window().reviewDialog()->reject();
    QTRY_VERIFY(!m_rig->window().reviewDialog());
    QVERIFY(setLive(u"pid.roll.p"_s, 450));
    m_rig->window().review();
    QVERIFY(m_rig->window().reviewDialog()->othersChoice()->isVisible());
    m_rig->window().reviewDialog()->reject();
    QTRY_VERIFY(!m_rig->window().reviewDialog());
    QVERIFY(write(OtherValues(others)));
    QTRY_COMPARE(disagreement(), QString());
    QCOMPARE(valueInUse(6), inUse);
    QCOMPARE(storedValue(6), stored);
    QCOMPARE(storedValue(0), 47);
}

void TestAgreement::stormSetBeforeTheLink_data()
{
    QTest::addColumn<QString>("way");
    for (const QString &way : {u"the button"_s, u"the action"_s, u"a write"_s})
        QTest::newRow(qPrintable(way)) << way;
}

// Nobody knows what is stored until it is compared, and nothing else is said.
void TestAgreement::stormSetBeforeTheLink()
{
    QFETCH(QString, way);
    QVERIFY(openStormSetBefore({{6, 450}}));
    QVERIFY(m_rig->jobsAreDone());
    auto *parameters = m_rig->page<ParametersPage>();
    auto *page = m_rig->page<TuningPage>();
    QTRY_VERIFY(page->compareButton()->isVisible() && page->compareButton()->isEnabled());
    QVERIFY2(page->stateText().contains(u"not known"_s), qPrintable(page->stateText()));
    // On every page.
    const auto footSays = [this](const QString &text) {
        const auto labels = m_rig->window().findChild<FootBar *>()->findChildren<QLabel *>();
        return std::any_of(labels.begin(), labels.end(), [&text](const QLabel *label) {
            return label->isVisible() && label->text().contains(text);
        });
    };
    QTRY_VERIFY(footSays(u"is stored is not known"_s));
    if (way == u"the button"_s) {
        page->compareButton()->click();
    } else if (way == u"the action"_s) {
        QVERIFY(act(u"stored.compare"_s));
    } else {
        perform(u"edit"_s);
        QVERIFY(write());
    }
    QTRY_COMPARE(disagreement(), QString());
    QVERIFY(!page->stateText().contains(u"not known"_s));
    QTRY_VERIFY(!footSays(u"not known"_s));
    QVERIFY2(page->stateText().contains(u"1 value"_s), qPrintable(page->stateText()));
    QCOMPARE(valueInUse(6), 450);
    QCOMPARE(storedValue(6), 400);
    const ValueEditor *editor = parameters->form()->editor(m_rig->spec(u"pid.roll.p"_s).id);
    QVERIFY(editor);
    const auto *box = qobject_cast<const QDoubleSpinBox *>(editor->control());
    QVERIFY(box);
    QCOMPARE(box->value(), 4.0);
    // On the next link it is not known again.
    QVERIFY(reconnect());
    QTRY_VERIFY(page->compareButton()->isVisible());
}

// What the operator has not been shown is listed before it is stored, and can be kept out.
void TestAgreement::storingListsWhatElseIsInUse()
{
    QVERIFY(openStormSetBefore({{6, 450}, {12, 500}}));
    QVERIFY(m_rig->jobsAreDone());
    const auto review = [this] { return m_rig->window().findChild<ReviewDialog *>(); };
    const auto store = [this] {
        const auto done = std::make_shared<std::optional<bool>>();
        m_rig->workspace().saveLive(m_rig->window()).then(&m_rig->window(), [done](bool stored) {
            *done = stored;
        });
        return done;
    };
    auto done = store();
    QTRY_VERIFY(review());
    QCOMPARE(review()->table()->model()->rowCount(), 2);
    review()->reject();
    QTRY_VERIFY(*done == false && !review());
    QCOMPARE(storedValue(6), 400);
    // Shown as in use and not stored since: but another program sets one more.
    QTRY_COMPARE(disagreement(), QString());
    m_host->with<storm32::SimulatedBoard>([](auto &board) { board.set(0, 555); });
    done = store();
    QTRY_VERIFY(review());
    QAbstractItemModel *model = review()->table()->model();
    QCOMPARE(model->rowCount(), 3);
    for (int row = 0; row < model->rowCount(); ++row) {
        if (model->index(row, 0).data().toString().endsWith(parameterLabel(m_rig->spec(u"pid.yaw.p"_s))))
            QVERIFY(model->setData(model->index(row, 0), Qt::Unchecked, Qt::CheckStateRole));
    }
    review()->accept();
    QTRY_VERIFY(*done == true);
    QTRY_COMPARE(disagreement(), QString());
    QCOMPARE(storedValue(0), 555);
    QCOMPARE(storedValue(6), 450);
    QCOMPARE(storedValue(12), 400);
    QCOMPARE(valueInUse(12), 500);
    // What is shown is stored without a question.
    done = store();
    QTRY_VERIFY(*done == true);
    QCOMPARE(storedValue(12), 500);
}

// By another program, or because it was in use only and the board has restarted.
void TestAgreement::whatChangedBehindTheLinkIsNamed()
{
    QVERIFY(openSimplebgc());
    QVERIFY(m_rig->jobsAreDone());
    m_rig->client().disconnectFromBoard();
    QTRY_VERIFY(!m_rig->client().isConnected());
    m_host->with<simplebgc::SimulatedBoard>([](auto &board) {
        board.store(u"pid.roll.p"_s, 0, 51);
        board.store(u"pid.roll.p"_s, 1, 52);
    });
    QVERIFY(reconnect());
    QVERIFY(m_rig->jobsAreDone());
    const QString told = m_rig->window().messageBar()->text();
    QVERIFY2(told.contains(u"from what was read"_s) && told.contains(u"35 → 51"_s), qPrintable(told));
    // Of which profile.
    const Configuration &board = std::as_const(m_rig->model()).board();
    for (const auto &[profile, value] : {std::pair(0, 51), std::pair(1, 52)}) {
        const QString place = profileLabel(board, profile) + u": "_s;
        const qsizetype at = told.indexOf(place);
        QVERIFY2(at >= 0 && told.mid(at, 80).section(u", "_s, 0, 0).endsWith(u"→ %1"_s.arg(value)),
                 qPrintable(told));
    }
}

// Whoever steered it is gone, and it turns on.
void TestAgreement::steeringThatNobodyEndedIsToldAndEnded()
{
    m_host = std::make_unique<BoardHost>(std::make_unique<SimulatedPort>(
        std::make_unique<simplebgc::SimulatedBoard>(SimulatorOptions{}), SimulatorOptions{}, std::nullopt));
    QVERIFY(m_host->start());
    m_host->with<simplebgc::SimulatedBoard>([](auto &board) {
        ByteWriter control;
        control.u8(1);  // by rate
        for (const int rate : {0, 0, 123})  // of 0.122 deg/s
            control.u16(rate).u16(0);
        const QByteArray frame = simplebgc::encodeFrame(67, control.take());
        board.receive(asBytes(frame));
        return 0;
    });
    m_rig = std::make_unique<WindowRig>();
    QVERIFY(m_rig->open(m_host->address()));
    // What waits already can wait.
    m_rig->workspace().notifications().ask({u"Which?"_s, {{u"This"_s, [] {}}}});
    const OfferBar *offers = m_rig->window().offerBar();
    QTRY_VERIFY_WITH_TIMEOUT(!offers->buttons().isEmpty()
                                 && offers->buttons().first()->text().contains(u"End the command"_s),
                             kPatience);
    const int target = m_rig->workspace().roles().target[2];
    QVERIFY(target >= 0);
    offers->buttons().first()->click();
    double last = m_rig->workspace().latest(target);
    QTRY_VERIFY_WITH_TIMEOUT(!m_rig->client().isSteering()
                                 && std::abs(std::exchange(last, m_rig->workspace().latest(target)) - last)
                                     < 0.01,
                             kPatience);
    QVERIFY(m_rig->boardGoesOn(1));
    QVERIFY(std::abs(m_rig->workspace().latest(target) - last) < 1);
}

void TestAgreement::simplebgc_data()
{
    QTest::addColumn<QStringList>("operations");
    QTest::newRow("write over a live change") << QStringList{u"live"_s, u"edit"_s, u"write"_s};
    QTest::newRow("write the live value") << QStringList{u"live"_s, u"edit the same"_s, u"write"_s};
    QTest::newRow("write, then revert") << QStringList{u"live"_s, u"edit"_s, u"write"_s, u"revert"_s};
    QTest::newRow("live, store") << QStringList{u"live"_s, u"save live"_s};
    QTest::newRow("store by the action") << QStringList{u"live"_s, u"variables.save"_s};
    QTest::newRow("profile and back")
        << QStringList{u"live"_s, u"profile 2"_s, u"live other"_s, u"profile 1"_s};
    QTest::newRow("write another profile")
        << QStringList{u"live"_s, u"profile 2"_s, u"edit"_s, u"profile 1"_s, u"live"_s, u"write"_s};
    QTest::newRow("variable by the action")
        << QStringList{u"set a variable"_s, u"live other"_s, u"edit"_s, u"write"_s};
    QTest::newRow("defaults") << QStringList{u"live"_s, u"edit"_s, u"write"_s, u"defaults of the profile"_s};
    QTest::newRow("reconnect") << QStringList{u"live"_s, u"reconnect"_s};
    QTest::newRow("read") << QStringList{u"live"_s, u"read"_s};
    QTest::newRow("undo") << QStringList{u"live"_s,  u"edit"_s, u"write"_s, u"undo"_s,
                                         u"write"_s, u"redo"_s, u"write"_s};
    QTest::newRow("slots") << QStringList{u"live"_s, u"slot"_s, u"live other"_s,
                                          u"slot"_s, u"edit"_s, u"write"_s};
}

void TestAgreement::simplebgc()
{
    QVERIFY(openSimplebgc());
    agreeAfterEach();
}

// What was typed, and not entered yet when the link went, is not lost without a word.
void TestAgreement::typedIntoABrokenLinkIsTold()
{
    m_rig = std::make_unique<WindowRig>();
    QVERIFY(m_rig->open());
    auto *page = m_rig->page<TuningPage>();
    QTRY_VERIFY(m_rig->workspace().live().value(m_rig->spec(u"pid.pitch.p"_s).id));
    auto *box = page->control(u"pid.pitch.p"_s)->editor()->findChild<NumberBox *>();
    QVERIFY(box);
    const QString before = box->typed();
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, u"77"_s);
    QCOMPARE(box->typed(), u"77"_s);
    m_rig->workspace().changeWorld(u"replug=2"_s);
    m_rig->workspace().changeWorld(u"unplug=0"_s);
    QTRY_VERIFY(m_rig->client().state() == DeviceClient::State::Reconnecting);
    QTRY_VERIFY2(m_rig->window().messageBar()->text().contains(u"77"_s),
                 qPrintable(m_rig->window().messageBar()->text()));
    QTRY_VERIFY(m_rig->client().isConnected());
    const auto shown = [page] {  // the page is made anew
        const LiveSlider *control = page->control(u"pid.pitch.p"_s);
        return control ? control->editor()->findChild<NumberBox *>()->typed() : QString();
    };
    QTRY_COMPARE(shown(), before);
}

QTEST_MAIN(TestAgreement)
#include "tst_agreement.moc"
