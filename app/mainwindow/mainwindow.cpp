// SPDX-FileCopyrightText: 2026 The GimbalDesk contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/mainwindow/mainwindow.h"

#include "app/mainwindow/bars.h"
#include "app/mainwindow/linkbar.h"
#include "app/mainwindow/startpage.h"
#include "app/pages/dashboardpage.h"
#include "app/pages/monitorpage.h"
#include "app/pages/parameterspage.h"

#include <QApplication>
#include <QCloseEvent>
#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QListWidget>
#include <QLoggingCategory>
#include <QMessageBox>
#include <QPushButton>
#include <QShortcut>
#include <QStackedWidget>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

Q_LOGGING_CATEGORY(logStart, "gimbal.start", QtWarningMsg)

MainWindow::MainWindow(TransportFactory transports, QList<Family> families, Theme &theme, QWidget *parent)
    : QMainWindow(parent)
    , m_workspace(std::make_unique<Workspace>(std::move(transports), std::move(families), theme))
    , m_linkBar(new LinkBar(*m_workspace))
    , m_messages(new MessageBar)
    , m_navigation(new QListWidget)
    , m_stack(new QStackedWidget)
    , m_start(new StartPage)
    , m_unsavedBar(new UnsavedBar(*m_workspace))
    , m_status(new StatusStrip(*m_workspace))
{
    setWindowTitle(u"GimbalDesk"_s);
    setMinimumSize(1024, 640);
    resize(1280, 800);

    m_navigation->setObjectName(u"navigation"_s);
    m_navigation->setAccessibleName(tr("Pages"));
    m_navigation->setFixedWidth(168);
    m_navigation->setIconSize({20, 20});
    m_navigation->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_stack->addWidget(m_start);
    addPage(new DashboardPage(*m_workspace));
    addPage(new ParametersPage(*m_workspace));
    addPage(new MonitorPage(*m_workspace));
    m_navigation->setCurrentRow(0);

    auto *messageHolder = new QWidget;
    auto *messageLayout = new QVBoxLayout(messageHolder);
    messageLayout->setContentsMargins(Metric::kMargin, Metric::kGap, Metric::kMargin, 0);
    messageLayout->addWidget(m_messages);
    auto *right = new QVBoxLayout;
    right->setContentsMargins(0, 0, 0, 0);
    right->setSpacing(0);
    right->addWidget(messageHolder);
    right->addWidget(m_stack, 1);
    auto *middle = new QHBoxLayout;
    middle->setContentsMargins(0, 0, 0, 0);
    middle->setSpacing(0);
    middle->addWidget(m_navigation);
    middle->addLayout(right, 1);
    auto *central = new QWidget;
    auto *layout = new QVBoxLayout(central);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_linkBar);
    layout->addLayout(middle, 1);
    layout->addWidget(m_unsavedBar);
    layout->addWidget(m_status);
    setCentralWidget(central);

    connect(m_workspace.get(), &Workspace::problem, m_messages, &MessageBar::showProblem);
    connect(m_workspace.get(), &Workspace::notice, m_messages, &MessageBar::showNotice);
    connect(m_unsavedBar, &UnsavedBar::reviewRequested, this, &MainWindow::review);
    connect(m_start, &StartPage::connectRequested, this, [this] {
        m_linkBar->addressBox()->setFocus();
        m_linkBar->addressBox()->showPopup();
    });
    connect(m_start, &StartPage::demoRequested, this,
            [this] { openLink(u"sim:"_s + m_workspace->client().families().first().key); });
    connect(m_navigation, &QListWidget::currentRowChanged, this, [this] { updateStart(); });
    connect(&m_workspace->configuration(), &ConfigurationModel::boardReset, this, &MainWindow::updateStart);
    connect(&m_workspace->client(), &DeviceClient::stateChanged, this, [this](DeviceClient::State state) {
        if (state == DeviceClient::State::Connecting)
            m_messages->hide();
        updateStart();
    });
    addShortcuts();
    // F12 stops the motors from every window and dialog, whatever has the focus.
    qApp->installEventFilter(this);
    updateStart();
}

MainWindow::~MainWindow()
{
    // Dialog and pages refer to the workspace, which goes first otherwise.
    delete m_review;
    delete takeCentralWidget();
}

void MainWindow::addPage(Page *page)
{
    m_pages.append(page);
    m_stack->addWidget(page);
    auto *item = new QListWidgetItem(QIcon(u":/icons/%1.svg"_s.arg(page->key())), page->title(), m_navigation);
    item->setToolTip(tr("%1 (Ctrl+%2)").arg(page->title()).arg(m_pages.size()));
    item->setSizeHint({160, 40});
    connect(page, &Page::changesChanged, this, &MainWindow::updateMarks);
}

void MainWindow::addShortcuts()
{
    for (int i = 0; i < m_pages.size(); ++i) {
        connect(new QShortcut(QKeySequence(Qt::CTRL | Qt::Key(Qt::Key_1 + i)), this), &QShortcut::activated, this,
                [this, i] { m_navigation->setCurrentRow(i); });
    }
    QUndoStack *stack = &m_workspace->edits().undoStack();
    connect(new QShortcut(QKeySequence::Undo, this), &QShortcut::activated, stack, &QUndoStack::undo);
    connect(new QShortcut(QKeySequence::Redo, this), &QShortcut::activated, stack, &QUndoStack::redo);
    connect(new QShortcut(QKeySequence(Qt::CTRL | Qt::Key_S), this), &QShortcut::activated, this, &MainWindow::review);
    connect(new QShortcut(QKeySequence::Refresh, this), &QShortcut::activated, m_workspace.get(), &Workspace::readBoard);
}

bool MainWindow::eventFilter(QObject *watched, QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress) {
        const auto *key = static_cast<QKeyEvent *>(event);
        if (key->key() == Qt::Key_F12 && !key->isAutoRepeat()) {
            if (event->type() == QEvent::KeyPress && watched->isWidgetType())
                m_workspace->setMotors(false);
            event->accept();
            return event->type() == QEvent::KeyPress && watched->isWidgetType();
        }
    }
    return QMainWindow::eventFilter(watched, event);
}

void MainWindow::openLink(const QString &address)
{
    m_linkBar->setAddress(address);
    const auto parsed = LinkAddress::parse(address);
    if (!parsed) {
        m_messages->showProblem(describe(parsed.error()));
        return;
    }
    m_workspace->connectTo(*parsed, m_workspace->client().families().first().key);
}

bool MainWindow::showPage(const QString &key)
{
    for (int i = 0; i < m_pages.size(); ++i) {
        if (m_pages[i]->key() == key) {
            m_navigation->setCurrentRow(i);
            return true;
        }
    }
    return false;
}

// Pages come alive with the first board; until then there is one card that says how to begin.
void MainWindow::updateStart()
{
    const bool begin = m_workspace->configuration().isEmpty() && !m_workspace->client().isConnected();
    QWidget *wanted = begin ? static_cast<QWidget *>(m_start) : m_pages.value(m_navigation->currentRow());
    if (wanted && m_stack->currentWidget() != wanted)
        m_stack->setCurrentWidget(wanted);
}

void MainWindow::updateMarks()
{
    for (int i = 0; i < m_pages.size(); ++i) {
        const bool changed = m_pages[i]->hasChanges();
        m_navigation->item(i)->setText(changed ? m_pages[i]->title() + u"  •"_s : m_pages[i]->title());
    }
}

void MainWindow::review()
{
    ConfigurationModel &model = m_workspace->configuration();
    if (m_review || model.isEmpty() || model.changeCount() == 0 || !m_workspace->client().isConnected()
        || !m_workspace->client().identity().writable)
        return;
    // A value still being typed belongs to the edits as well.
    if (QWidget *focus = QApplication::focusWidget())
        focus->clearFocus();
    m_review = new ReviewDialog(model.board(), model.edited(), this);
    m_review->setAttribute(Qt::WA_DeleteOnClose);
    connect(m_review, &QDialog::accepted, this, [this] { m_workspace->write(m_review->chosen()); });
    m_review->open();
}

void MainWindow::paintEvent(QPaintEvent *event)
{
    QMainWindow::paintEvent(event);
    static bool first = true;
    if (std::exchange(first, false))
        qCDebug(logStart) << "first paint";
}

void MainWindow::closeEvent(QCloseEvent *event)
{
    if (m_workspace->configuration().changeCount() > 0) {
        auto *box = new QMessageBox(QMessageBox::Question, tr("Unsaved changes"),
                                    tr("%n change(s) are not on the board. They are lost when the program ends.", nullptr,
                                       m_workspace->configuration().changeCount()),
                                    QMessageBox::NoButton, this);
        box->setAttribute(Qt::WA_DeleteOnClose);
        auto *leave = box->addButton(tr("Discard and quit"), QMessageBox::DestructiveRole);
        auto *stay = box->addButton(tr("Stay"), QMessageBox::RejectRole);
        box->setDefaultButton(stay);
        box->setEscapeButton(stay);
        connect(leave, &QPushButton::clicked, this, [this] {
            m_workspace->edits().discardAll();
            close();
        });
        box->open();
        event->ignore();
        return;
    }
    m_workspace->client().disconnectFromBoard();
    QMainWindow::closeEvent(event);
}
