// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/main_window.h"

#include "session/history/history_sender.h"
#include "session/history/history_server_choice.h"
#include "session/history/history_service.h"
#include "ui/app/about_dialog.h"
#include "ui/app/appearance_buttons.h"
#include "ui/app/auto_selection.h"
#include "ui/app/close_confirmation.h"
#include "ui/app/help_window.h"
#include "ui/app/menus.h"
#include "ui/app/message_line.h"
#include "ui/app/message_log.h"
#include "ui/app/pages.h"
#include "ui/app/shortcuts_dialog.h"
#include "ui/app/stop_banner.h"
#include "ui/app/stop_key.h"
#include "ui/app/task_status.h"
#include "ui/app/undo_button.h"
#include "ui/app/undo_redo.h"
#include "ui/common/dialog_sizes.h"
#include "ui/common/follow_language.h"
#include "ui/connect/connect_bar.h"
#include "ui/connect/find_servos_dialog.h"
#include "ui/connect/link_error_banner.h"
#include "ui/search/diagnosis_dialog.h"
#include "ui/search/search_panel.h"
#include "ui/sweep/runs_dialog.h"
#include "ui/tasks/firmware_rescue_dialog.h"
#include "ui/tasks/firmware_update_dialog.h"
#include "ui/tasks/servo_tasks.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/floating_overlay.h"
#include "ui/widgets/welcome.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QMenuBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>

namespace ui {
namespace {
/// Shows the window's only widget of this type; `make` makes it the first time.
template <typename Window, typename Make>
void showSingle(QWidget& parent, Make make)
{
    auto* window = parent.findChild<Window*>();
    if (window == nullptr)
        window = make();
    window->show();
    window->raise();
    window->activateWindow();
}

/// What could not be used of the user's own files: it never prevents the start.
std::vector<base::Error> startupErrors(const session::Session& session,
                                       const session::Settings& settings)
{
    std::vector<base::Error> errors;
    const auto add = [&](const QString& detail) {
        errors.push_back({base::ErrorCode::FileFormat, QStringLiteral("start"), detail});
    };
    for (const catalog::LoadWarning& warning : session.warnings())
        add(QStringList{warning.file, warning.where, warning.detail}.join(QStringLiteral(": ")));
    if (!settings.brokenCopy().isEmpty())
        add(settings.brokenCopy());
    return errors;
}
} // namespace

MainWindow::MainWindow(AppContext& appContext, session::Settings& settings, ThemeSwitch& theme,
                       LanguageSwitch& language, QWidget* parent)
    : QMainWindow(parent)
    , m_context(appContext)
    , m_settings(settings)
    , m_workbench(appContext.workbench)
    , m_commands(appContext.commands)
{
    build(theme, language);
    connectCommands();
    connectStop();
    connectWorkbench();
    connectHistorySender();
    new StopBanner(m_workbench, m_commands, *m_banner, this);
    new ServoTasks(m_workbench, m_commands, m_context.selection, this);
    new LinkErrorBanner(m_workbench.link(), m_context.ports, *m_connectBar, *m_banner, this);
    restoreGeometry(m_settings.windowGeometry());
    restoreState(m_settings.windowState());
    followLanguage(this, [this] {
        m_commands.retranslate();
        m_menus->retranslate();
        retranslate();
    });
    updateCenter();
    reportStartupErrors();
}

/// Pages that are hidden stop polling and deliver the last readings, for which other widgets make
/// new widgets: in the destructor of QWidget that would crash.
MainWindow::~MainWindow()
{
    hide();
}

void MainWindow::build(ThemeSwitch& theme, LanguageSwitch& language)
{
    setObjectName(QStringLiteral("mainWindow"));
    new DialogSizes(m_settings, this);
    setMinimumSize(1024, 700);
    resize(1280, 800);
    auto* top = new QToolBar(this);
    top->setObjectName(QStringLiteral("topBar"));
    top->setMovable(false);
    top->toggleViewAction()->setVisible(false);
    top->addWidget(buildTopBar(theme, language));
    addToolBar(top);
    setContextMenuPolicy(Qt::NoContextMenu); // its only entry would hide the bar
    setCentralWidget(buildCenter());
    buildDocks();
    buildStatusBar();
    m_menus = new Menus(*menuBar(), m_commands,
                        {m_searchDock->toggleViewAction(), m_commands.action(Command::MessageLog)});
    // The shortcuts of actions work although no menu with them is open.
    for (int i = 0; i < static_cast<int>(Command::Count); ++i)
        addAction(m_commands.action(static_cast<Command>(i)));
}

QWidget* MainWindow::buildTopBar(ThemeSwitch& theme, LanguageSwitch& language)
{
    auto* bar = new QWidget(this);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(4, 4, 4, 4);
    m_connectBar = new ConnectBar(m_workbench, m_commands, m_settings, m_context.ports, bar);
    m_appearance = new AppearanceButtons(theme, language, m_commands, m_settings, bar);
    row->addWidget(m_connectBar, 1);
    row->addWidget(m_appearance);
    return bar;
}

QWidget* MainWindow::buildCenter()
{
    auto* center = new QWidget(this);
    auto* column = new QVBoxLayout(center);
    column->setContentsMargins({});
    m_banner = new Banner(center);
    m_center = new QStackedWidget(center);
    m_pages = new Pages(m_context, m_settings, m_center);
    m_center->addWidget(new Welcome(m_commands, m_center));
    m_center->addWidget(m_pages);
    column->addWidget(m_center, 1);
    new FloatingOverlay(m_banner, center, FloatingOverlay::Corner::BottomRight);
    return center;
}

void MainWindow::buildDocks()
{
    m_searchDock = new QDockWidget(this);
    m_searchDock->setObjectName(QStringLiteral("searchDock"));
    m_searchDock->setWidget(
        new SearchPanel(m_workbench, m_commands, m_context.selection, m_settings, m_searchDock));
    addDockWidget(Qt::LeftDockWidgetArea, m_searchDock);
    m_logDock = new QDockWidget(this);
    m_logDock->setObjectName(QStringLiteral("logDock"));
    m_log = new MessageLog(m_workbench.registry(), m_logDock);
    m_logDock->setWidget(m_log);
    addDockWidget(Qt::BottomDockWidgetArea, m_logDock);
    m_logDock->hide();
}

void MainWindow::buildStatusBar()
{
    m_message = new MessageLine(m_workbench.registry(), this);
    auto* undoButton = new UndoButton(m_commands.action(Command::Undo), this);
    m_stop = new QPushButton(this);
    m_stop->setObjectName(QStringLiteral("stopButton"));
    m_stop->setProperty("stopAction", true);
    m_stop->setFocusPolicy(Qt::NoFocus); // pressing it must not close an editor first
    statusBar()->setSizeGripEnabled(false);
    statusBar()->setContentsMargins(0, 3, 8, 3);
    statusBar()->addWidget(m_message, 1);
    statusBar()->addPermanentWidget(
        new TaskStatus(m_workbench.tasks(), m_commands.action(Command::StopTask), this));
    statusBar()->addPermanentWidget(undoButton);
    statusBar()->addPermanentWidget(m_stop);
}

void MainWindow::connectCommands()
{
    const auto on = [this](Command command, auto slot) {
        connect(m_commands.action(command), &QAction::triggered, this, slot);
    };
    on(Command::Disconnect, [this] { m_closeConfirmation->disconnectPort(); });
    on(Command::FindServos, [this] {
        showSingle<FindServosDialog>(*this, [this] {
            auto* dialog = new FindServosDialog(m_workbench.session(), m_context.ports, this);
            connect(dialog, &FindServosDialog::connectRequested, this,
                    [this](const session::PortRequest& found) {
                        session::PortRequest request =
                            m_settings.lastRequestFor(m_context.ports.adapterKey(found.name));
                        request.name = found.name;
                        request.baud = found.baud;
                        request.protocol = found.protocol;
                        request.parity = found.parity;
                        m_connectBar->setRequest(request);
                        m_connectBar->connectNow();
                    });
            return dialog;
        });
    });
    on(Command::PowerCycle, [this] {
        m_workbench.link().powerCycle();
        m_workbench.writes().readTable(m_context.selection.current());
    });
    on(Command::StopSearch, [this] { m_workbench.search().stop(); });
    on(Command::Diagnose, [this] {
        showSingle<DiagnosisDialog>(*this, [this] {
            return new DiagnosisDialog(m_workbench.search(), m_workbench.link(), m_commands, this);
        });
    });
    on(Command::UpdateFirmware, [this] {
        // In the order of the list, and only those that are still there.
        std::vector<session::ServoRef> servos = m_workbench.registry().order();
        const auto& selected = m_context.selection.selected();
        std::erase_if(servos, [&](session::ServoRef ref) {
            return std::find(selected.begin(), selected.end(), ref) == selected.end();
        });
        if (!servos.empty())
            (new FirmwareUpdateDialog(m_workbench, std::move(servos), m_settings, this))->open();
    });
    on(Command::RescueFirmware, [this] {
        showSingle<FirmwareRescueDialog>(
            *this, [this] { return new FirmwareRescueDialog(m_workbench, m_settings, this); });
    });
    on(Command::StopTask, [this] { m_workbench.tasks().stop(); });
    on(Command::ReadTable,
       [this] { m_workbench.writes().readTable(m_context.selection.current()); });
    on(Command::Undo,
       [this] { undo(m_workbench.writes(), m_workbench.registry(), m_context.selection, this); });
    on(Command::Redo,
       [this] { redo(m_workbench.writes(), m_workbench.registry(), m_context.selection, this); });
    on(Command::MessageLog, [this](bool shown) { m_logDock->setVisible(shown); });
    on(Command::Help,
       [this] { showSingle<HelpWindow>(*this, [this] { return new HelpWindow(this); }); });
    on(Command::PreviousTests, [this] {
        showSingle<RunsDialog>(
            *this, [this] { return new RunsDialog(m_workbench.history(), m_settings, this); });
    });
    on(Command::Shortcuts, [this] { (new ShortcutsDialog(m_commands, this))->open(); });
    on(Command::About, [this] { (new AboutDialog(this))->open(); });
    on(Command::Quit, [this] { close(); });
    connect(m_logDock, &QDockWidget::visibilityChanged, this,
            [this] { m_commands.action(Command::MessageLog)->setChecked(!m_logDock->isHidden()); });
}

/// The command, the button and the Esc key do the same.
void MainWindow::connectStop()
{
    const auto stop = [this] { m_workbench.emergencyStop().trigger(); };
    auto* stopKey = new StopKey([this] { return m_workbench.closing().isMotionPossible(); }, this);
    connect(m_commands.action(Command::TorqueOffAll), &QAction::triggered, this, stop);
    connect(m_stop, &QPushButton::clicked, this, stop);
    connect(stopKey, &StopKey::pressed, this, stop);
}

void MainWindow::connectWorkbench()
{
    m_closeConfirmation = new CloseConfirmation(m_workbench, this);
    m_autoSelection = new AutoSelection(m_workbench, m_context.selection, this);
    connect(&m_workbench, &session::Workbench::eventOccurred, this, &MainWindow::report);
    connect(&m_workbench.link(), &session::LinkController::linkChanged, this,
            &MainWindow::linkChanged);
    connect(&m_workbench.registry(), &session::ServoRegistry::servoAdded, this,
            &MainWindow::updateCenter);
    connect(m_pages, &Pages::usableWithoutServo, this, &MainWindow::updateCenter);
    connect(&m_workbench.closing(), &session::CloseSequence::closed, this, [this] {
        m_canClose = true;
        close();
    });
}

/// What is new in the history is copied to the server.
void MainWindow::connectHistorySender()
{
    session::HistorySender& sender = m_workbench.historySender();
    connect(&m_workbench.history(), &session::HistoryService::changed, &sender,
            &session::HistorySender::notifyChanged);
    connect(&m_workbench, &session::Workbench::eventOccurred, &sender,
            &session::HistorySender::notifyChanged);
    const auto server = session::historyServerChoice(m_settings);
    sender.setServer(server.address, server.bench);
}

void MainWindow::start(const Options& options)
{
    if (options.size.isValid())
        resize(options.size);
    m_autoSelection->request(options.select, !options.screenshot.isEmpty());
    m_pages->open(options.page);
    for (const QString& file : options.files)
        m_pages->openFile(file);
    if (options.port) {
        m_connectBar->setRequest(*options.port);
        m_workbench.link().connectTo(*options.port);
    }
}

void MainWindow::reportStartupErrors()
{
    for (const base::Error& error : startupErrors(m_workbench.session(), m_settings)) {
        session::Event event;
        event.at = QDateTime::currentDateTime();
        event.error = error;
        report(event);
    }
}

void MainWindow::report(const session::Event& event)
{
    m_message->show(event);
    m_log->add(event);
}

/// The pages stay while there is a servo to show, also after the port was closed.
void MainWindow::updateCenter()
{
    const bool hasPages = m_workbench.link().state() == session::LinkState::Open ||
                          !m_workbench.registry().order().empty() ||
                          m_pages->isUsableWithoutServo();
    m_center->setCurrentIndex(hasPages ? 1 : 0);
}

void MainWindow::linkChanged()
{
    const bool open = m_workbench.link().state() == session::LinkState::Open;
    if (open && !m_wasOpen && !m_workbench.link().isReconnect())
        m_commands.action(Command::Search)->trigger();
    m_wasOpen = open;
    updateCenter();
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    m_settings.setWindow(saveGeometry(), saveState());
    const bool nothingToAsk = m_canClose || !m_workbench.link().hasOpenedPort();
    if (m_workbench.link().state() == session::LinkState::Off && nothingToAsk) {
        event->accept();
        return;
    }
    event->ignore(); // closed() follows when the running write has ended and the lock is closed
    m_closeConfirmation->closeWindow();
}

/// A status tip would replace the latest result by a text about what is under the pointer.
bool MainWindow::event(QEvent* event)
{
    return event->type() == QEvent::StatusTip || QMainWindow::event(event);
}

void MainWindow::retranslate()
{
    setWindowTitle(tr("ServoDesk"));
    m_searchDock->setWindowTitle(tr("Search"));
    m_logDock->setWindowTitle(tr("Messages"));
    m_pages->retranslate();
    m_appearance->retranslate();
    m_stop->setText(tr("Esc   All torque off"));
    m_stop->setToolTip(m_commands.action(Command::TorqueOffAll)->toolTip());
    m_stop->setAccessibleName(tr("Turn torque off on all servos"));
}
} // namespace ui
