// SPDX-License-Identifier: GPL-3.0-or-later
// The window as a shell: connect bar on top, search at the left, the pages in the middle, message
// line and stop button below. Knows which page stands where and nothing of what they do. Owns the
// pages; bench, settings and switches must outlive it. Main thread.
#pragma once

#include "session/settings.h"
#include "ui/app/options.h"
#include "ui/common/app_context.h"

#include <QMainWindow>

class QDockWidget;
class QPushButton;
class QStackedWidget;
class QTabWidget;
class QToolButton;

namespace ui {
class Banner;
class ConnectBar;
class LanguageSwitch;
class CloseConfirmation;
class MemoryPage;
class Menus;
class MessageLine;
class MessageLog;
class OperatePage;
class HistoryPage;
class CommissionPage;
class SnapshotsPage;
class StepPage;
class SweepPage;
class ThemeSwitch;

class MainWindow final : public QMainWindow {
    Q_OBJECT

public:
    MainWindow(AppContext& appContext, session::Settings& settings, ThemeSwitch& theme,
               LanguageSwitch& language, QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Page, port and selection as the command line wants them.
    void start(const Options& options);

protected:
    void closeEvent(QCloseEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool event(QEvent* event) override;

private:
    void build();
    QWidget* buildTopBar();
    QWidget* buildCenter();
    void buildDocks();
    void buildStatusBar();
    void connectCommands();
    void connectPages();
    void connectHistory();
    void connectDesk();
    void connectSwitches();
    void retranslate();
    void updateCenter();
    void linkChanged();
    void reportStartupErrors();
    void happened(const session::Event& event);
    void showStopBanner(const session::Event& event);
    void hideCloseCanceled();
    void undo();
    void redoLast();
    void selectRequested(session::ServoRef added);
    void searchEnded();

    AppContext& m_context;
    session::Settings& m_settings;
    ThemeSwitch& m_theme;
    LanguageSwitch& m_language;
    session::Desk& m_desk;
    session::PortWatcher& m_ports;
    Selection& m_selection;
    Commands& m_commands;

    ConnectBar* m_connectBar = nullptr;
    Banner* m_banner = nullptr;
    QStackedWidget* m_center = nullptr;
    QTabWidget* m_pages = nullptr;
    OperatePage* m_operate = nullptr;
    MemoryPage* m_memory = nullptr;
    SweepPage* m_sweep = nullptr;
    StepPage* m_step = nullptr;
    SnapshotsPage* m_snapshots = nullptr;
    CommissionPage* m_commission = nullptr;
    HistoryPage* m_history = nullptr;
    bool m_pagesRequested = false; ///< although no port was ever open
    QDockWidget* m_searchDock = nullptr;
    QDockWidget* m_logDock = nullptr;
    MessageLine* m_message = nullptr;
    MessageLog* m_log = nullptr;
    QToolButton* m_undo = nullptr;
    QPushButton* m_stop = nullptr;
    QToolButton* m_languageButton = nullptr;
    QToolButton* m_themeButton = nullptr;
    Menus* m_menus = nullptr;
    CloseConfirmation* m_closeConfirmation = nullptr;
    bool m_stopShown = false; ///< the banner says that a stop was not sent
    /// Of a banner that says nothing but that their EPROM locks stayed open.
    std::vector<session::ServoRef> m_unlockedShown;

    std::optional<int> m_requestedId; ///< of the command line; selected when it is found
    bool m_selectFirst = false;       ///< a screenshot without a wish selects the first servo found
    bool m_wasOpen = false;
    bool m_canClose = false; ///< the desk has been closed
};
} // namespace ui
