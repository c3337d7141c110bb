// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/app/main_window.h"

#include "session/history/history_server_choice.h"
#include "ui/app/about_dialog.h"
#include "ui/app/close_confirmation.h"
#include "ui/app/help_window.h"
#include "ui/app/menus.h"
#include "ui/app/message_line.h"
#include "ui/app/message_log.h"
#include "ui/app/redo.h"
#include "ui/app/shortcuts_dialog.h"
#include "ui/app/stop_key.h"
#include "ui/commissioning/commission_page.h"
#include "ui/common/language_switch.h"
#include "ui/common/theme.h"
#include "ui/connect/connect_bar.h"
#include "ui/connect/link_error_banner.h"
#include "ui/history/history_page.h"
#include "ui/memory/memory_page.h"
#include "ui/operate/operate_page.h"
#include "ui/snapshots/snapshots_page.h"
#include "ui/step/step_page.h"
#include "ui/sweep/runs_dialog.h"
#include "ui/sweep/sweep_page.h"
#include "ui/tasks/servo_tasks.h"
#include "ui/trends/trend_panel.h"
#include "ui/widgets/banner.h"

#include <QCloseEvent>
#include <QDockWidget>
#include <QPushButton>
#include <QStackedWidget>
#include <QTabWidget>
#include <QToolButton>

#include <algorithm>
#include <utility>

namespace ui {
MainWindow::MainWindow(AppContext& appContext, session::Settings& settings, ThemeSwitch& theme,
                       LanguageSwitch& language, QWidget* parent)
    : QMainWindow(parent)
    , m_context(appContext)
    , m_settings(settings)
    , m_theme(theme)
    , m_language(language)
    , m_desk(appContext.desk)
    , m_ports(appContext.ports)
    , m_selection(appContext.selection)
    , m_commands(appContext.commands)
{
    build();
    connectCommands();
    connectPages();
    connectDesk();
    connectSwitches();
    new ServoTasks(m_desk, m_commands, m_selection, this);
    new LinkErrorBanner(m_desk, m_ports, *m_connectBar, *m_banner, this);
    restoreGeometry(m_settings.windowGeometry());
    restoreState(m_settings.windowState());
    retranslate();
    updateCenter();
    reportStartupErrors();
    const auto server = session::historyServerChoice(m_settings);
    m_context.historySender.setServer(server.address, server.bench);
}

/// Pages that are hidden end their polling and tell of the last readings, upon which others make
/// widgets: in the destructor of QWidget that crashes.
MainWindow::~MainWindow()
{
    hide();
}

/// What could not be used of the user's own files: it costs that row, never the start.
void MainWindow::reportStartupErrors()
{
    const auto showError = [this](const base::Error& error) {
        session::Event event;
        event.at = QDateTime::currentDateTime();
        event.error = error;
        m_message->show(event);
        m_log->add(event);
    };
    const auto tell = [&](const QString& detail) {
        showError({base::ErrorCode::FileFormat, QStringLiteral("start"), detail});
    };
    for (const catalog::LoadWarning& warning : m_desk.session().warnings())
        tell(QStringList{warning.file, warning.where, warning.detail}.join(QStringLiteral(": ")));
    if (!m_settings.brokenCopy().isEmpty())
        tell(m_settings.brokenCopy());
    if (const auto removed = session::removeStoredPassword(m_settings))
        showError(*removed);
}

void MainWindow::start(const Options& options)
{
    if (options.size.isValid())
        resize(options.size);
    m_requestedId = options.select;
    m_desk.setExpectedId(m_requestedId);
    m_selectFirst = !options.screenshot.isEmpty() && !options.select;
    const std::map<QString, QWidget*> pages{
        {QStringLiteral("operate"), m_operate},     {QStringLiteral("memory"), m_memory},
        {QStringLiteral("sweep"), m_sweep},         {QStringLiteral("step"), m_step},
        {QStringLiteral("snapshots"), m_snapshots}, {QStringLiteral("commission"), m_commission},
        {QStringLiteral("history"), m_history}};
    if (const auto page = pages.find(options.page); page != pages.end())
        m_pages->setCurrentWidget(page->second);
    m_pagesRequested = options.page == QLatin1StringView("snapshots") ||
                       options.page == QLatin1StringView("history");
    updateCenter();
    if (options.port) {
        m_connectBar->setRequest(*options.port);
        m_desk.connectTo(*options.port);
    }
}

void MainWindow::connectCommands()
{
    const auto on = [this](Command command, auto slot) {
        connect(m_commands.action(command), &QAction::triggered, this, slot);
    };
    on(Command::Disconnect, [this] { m_closeConfirmation->disconnectPort(); });
    on(Command::PowerCycle, [this] {
        m_desk.powerCycle();
        m_desk.readTable(m_selection.current());
    });
    on(Command::StopSearch, [this] { m_desk.stopSearch(); });
    on(Command::StopTask, [this] { m_desk.stopTask(); });
    on(Command::ReadTable, [this] { m_desk.readTable(m_selection.current()); });
    on(Command::Undo, [this] { undo(); });
    on(Command::Redo, [this] { redoLast(); });
    on(Command::TorqueOffAll, [this] { m_desk.emergencyStop(); });
    on(Command::ThemeSystem, [this] { m_theme.apply(session::Theme::System); });
    on(Command::ThemeLight, [this] { m_theme.apply(session::Theme::Light); });
    on(Command::ThemeDark, [this] { m_theme.apply(session::Theme::Dark); });
    on(Command::English, [this] { m_language.apply(QStringLiteral("en")); });
    on(Command::Chinese, [this] { m_language.apply(QStringLiteral("zh_CN")); });
    on(Command::MessageLog, [this](bool shown) { m_logDock->setVisible(shown); });
    on(Command::Help, [this] {
        auto* help = findChild<HelpWindow*>(); // one is enough
        help = help != nullptr ? help : new HelpWindow(this);
        help->show();
        help->raise();
        help->activateWindow();
    });
    on(Command::PreviousTests, [this] {
        auto* runs = findChild<RunsDialog*>(); // one is enough
        runs = runs != nullptr ? runs : new RunsDialog(m_context.history, m_settings, this);
        runs->show();
        runs->raise();
        runs->activateWindow();
    });
    connect(m_sweep, &SweepPage::previousTestsRequested, m_commands.action(Command::PreviousTests),
            &QAction::trigger);
    on(Command::Shortcuts, [this] { (new ShortcutsDialog(m_commands, this))->open(); });
    on(Command::About, [this] { (new AboutDialog(this))->open(); });
    on(Command::Quit, [this] { close(); });
    connect(m_logDock, &QDockWidget::visibilityChanged, this,
            [this] { m_commands.action(Command::MessageLog)->setChecked(!m_logDock->isHidden()); });
    connect(m_stop, &QPushButton::clicked, this, [this] { m_desk.emergencyStop(); });
    auto* stopKey = new StopKey([this] { return m_desk.isMotionPossible(); }, this);
    connect(stopKey, &StopKey::pressed, this, [this] { m_desk.emergencyStop(); });
}

void MainWindow::connectDesk()
{
    m_closeConfirmation = new CloseConfirmation(m_desk, this);
    connect(&m_desk, &session::Desk::eventOccurred, this, &MainWindow::happened);
    connect(m_banner, &Banner::dismissed, this, [this] { m_stopShown = false; });
    connect(&m_desk, &session::Desk::linkChanged, this, &MainWindow::linkChanged);
    connect(&m_desk, &session::Desk::servoChanged, this, &MainWindow::hideCloseCanceled);
    connect(&m_desk, &session::Desk::servoAdded, this, &MainWindow::selectRequested);
    connect(&m_desk, &session::Desk::servoAdded, this, [this] { updateCenter(); });
    connect(&m_desk, &session::Desk::searchChanged, this, [this] {
        if (!m_desk.isSearching())
            searchEnded();
    });
    connect(&m_desk, &session::Desk::servoRemoved, this,
            [this](session::ServoRef ref) { m_selection.remove(ref); });
    connect(&m_desk, &session::Desk::servosCleared, this, [this] { m_selection.select(0); });
    connect(&m_desk, &session::Desk::closed, this, [this] {
        m_canClose = true;
        close();
    });
}

void MainWindow::happened(const session::Event& event)
{
    m_message->show(event);
    m_log->add(event);
    showStopBanner(event);
}

/// A stop that has not reached the servos must not be one line among others.
void MainWindow::showStopBanner(const session::Event& event)
{
    using Kind = session::Event::Kind;
    const bool stops = event.kind == Kind::Stopped || event.kind == Kind::StopNotSent;
    const bool unsent =
        event.kind == Kind::StopNotSent || event.isPending || event.kind == Kind::CloseCanceled;
    if (stops && !unsent && std::exchange(m_stopShown, false))
        m_banner->hideMessage();
    if (!unsent)
        return;
    m_stopShown = true;
    m_unlockedShown = event.moving.empty() ? event.unlocked : std::vector<session::ServoRef>{};
    const QList<QAction*> actions = m_desk.state() == session::LinkState::Open && !event.isPending
                                        ? QList{m_commands.action(Command::TorqueOffAll)}
                                        : QList<QAction*>{};
    m_banner->showMessage(
        [this, event] {
            const EventText words = describe(event, m_desk);
            return BannerText{Tone::Bad, words.message, {}, words.details.join(QLatin1Char(' '))};
        },
        actions);
}

/// Once each lock that it names has been read as closed.
void MainWindow::hideCloseCanceled()
{
    const auto isOpen = [this](session::ServoRef ref) {
        const session::ServoEntry* entry = m_desk.servo(ref);
        return entry == nullptr || entry->isLockOpen().value_or(true);
    };
    if (!m_stopShown || m_unlockedShown.empty() ||
        std::any_of(m_unlockedShown.begin(), m_unlockedShown.end(), isOpen))
        return;
    m_unlockedShown.clear();
    m_stopShown = false;
    m_banner->hideMessage();
}

/// What is changed back is shown: it may belong to another servo than the one selected.
void MainWindow::undo()
{
    if (const session::UndoStep* step = m_desk.undoStep()) {
        if (step->servo != m_selection.current())
            m_selection.select(step->servo);
        m_desk.undo();
    }
}

void MainWindow::redoLast()
{
    if (const session::UndoStep* step = m_desk.redoStep()) {
        if (step->servo != m_selection.current())
            m_selection.select(step->servo);
        redo(m_desk, this);
    }
}

void MainWindow::connectSwitches()
{
    connect(m_languageButton, &QToolButton::clicked, this, [this] {
        m_language.apply(m_language.chinese() ? QStringLiteral("en") : QStringLiteral("zh_CN"));
    });
    connect(m_themeButton, &QToolButton::clicked, this, [this] {
        m_theme.apply(isDark(palette()) ? session::Theme::Light : session::Theme::Dark);
    });
    const auto languageChanged = [this] {
        m_settings.setLanguage(m_language.chinese() ? QStringLiteral("zh_CN")
                                                    : QStringLiteral("en"));
    };
    connect(&m_language, &LanguageSwitch::changed, this, languageChanged);
    const auto showSwitches = [this] {
        m_commands.action(Command::Chinese)->setChecked(m_language.chinese());
        m_commands.action(Command::English)->setChecked(!m_language.chinese());
        const session::Theme theme = m_theme.theme();
        m_commands.action(Command::ThemeSystem)->setChecked(theme == session::Theme::System);
        m_commands.action(Command::ThemeLight)->setChecked(theme == session::Theme::Light);
        m_commands.action(Command::ThemeDark)->setChecked(theme == session::Theme::Dark);
        m_themeButton->setIcon(QIcon::fromTheme(isDark(palette())
                                                    ? QStringLiteral("weather-clear")
                                                    : QStringLiteral("weather-clear-night")));
    };
    connect(&m_language, &LanguageSwitch::changed, this, showSwitches);
    connect(&m_theme, &ThemeSwitch::changed, this, [this, showSwitches] {
        m_settings.setTheme(m_theme.theme());
        m_commands.updateIcons();
        showSwitches();
    });
    showSwitches();
}

/// Pages stay as long as there is a servo to show, also after the port was closed.
void MainWindow::updateCenter()
{
    const bool something = m_desk.state() == session::LinkState::Open || !m_desk.servos().empty() ||
                           m_operate->trend()->isReplaying() || m_pagesRequested;
    m_center->setCurrentIndex(something ? 1 : 0);
}

void MainWindow::linkChanged()
{
    const bool open = m_desk.state() == session::LinkState::Open;
    if (open && !m_wasOpen)
        m_commands.action(Command::Search)->trigger();
    m_wasOpen = open;
    updateCenter();
}

void MainWindow::selectRequested(session::ServoRef added)
{
    const session::ServoEntry* servo = m_desk.servo(added);
    if (servo == nullptr || m_selection.current() != 0)
        return;
    if (m_requestedId ? servo->servo.id == *m_requestedId : m_selectFirst) {
        m_requestedId.reset();
        m_desk.setExpectedId(std::nullopt);
        m_selectFirst = false;
        m_selection.select(added);
    }
}

/// A servo that is alone is the one that is meant, unless another one was asked for.
void MainWindow::searchEnded()
{
    if (m_selection.current() == 0 && !m_requestedId && m_desk.servos().size() == 1)
        m_selection.select(m_desk.servos().front());
    const session::ServoEntry* shown = m_desk.servo(m_selection.current());
    if (shown != nullptr && shown->servo.profile && !shown->hasFullTable)
        m_desk.readTable(m_selection.current());
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    m_settings.setWindow(saveGeometry(), saveState());
    const bool nothingToAsk = m_canClose || !m_desk.hasOpenedPort();
    if (m_desk.state() == session::LinkState::Off && nothingToAsk) {
        event->accept();
        return;
    }
    event->ignore(); // closed() follows when the running write has ended and the lock is closed
    m_closeConfirmation->closeWindow();
}

/// A status tip would hide the latest result behind what the pointer happens to be on.
bool MainWindow::event(QEvent* event)
{
    return event->type() == QEvent::StatusTip || QMainWindow::event(event);
}

void MainWindow::changeEvent(QEvent* event)
{
    QMainWindow::changeEvent(event);
    if (event->type() != QEvent::LanguageChange || m_menus == nullptr)
        return;
    m_commands.retranslate();
    m_menus->retranslate();
    retranslate();
}
} // namespace ui
