// SPDX-License-Identifier: GPL-3.0-or-later
// The window as a shell: connect bar at the top, search at the left, the pages in the middle,
// message line and stop button below. It knows the places of its parts, not what they do. Owns its
// parts; context, settings and switches must outlive it. Main thread.
#pragma once

#include "session/settings.h"
#include "ui/app/options.h"
#include "ui/common/app_context.h"

#include <QMainWindow>

class QDockWidget;
class QPushButton;
class QStackedWidget;

namespace ui {
class AppearanceButtons;
class AutoSelection;
class Banner;
class CloseConfirmation;
class ConnectBar;
class LanguageSwitch;
class Menus;
class MessageLine;
class MessageLog;
class Pages;
class ThemeSwitch;

class MainWindow final : public QMainWindow {
    Q_OBJECT

public:
    MainWindow(AppContext& appContext, session::Settings& settings, ThemeSwitch& theme,
               LanguageSwitch& language, QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Page, port and selection as given on the command line.
    void start(const Options& options);

protected:
    void closeEvent(QCloseEvent* event) override;
    bool event(QEvent* event) override;

private:
    void build(ThemeSwitch& theme, LanguageSwitch& language);
    QWidget* buildTopBar(ThemeSwitch& theme, LanguageSwitch& language);
    QWidget* buildCenter();
    void buildDocks();
    void buildStatusBar();
    void connectCommands();
    void connectStop();
    void connectWorkbench();
    void connectHistorySender();
    void retranslate();
    void updateCenter();
    void linkChanged();
    void reportStartupErrors();
    void report(const session::Event& event);

    AppContext& m_context;
    session::Settings& m_settings;
    session::Workbench& m_workbench;
    Commands& m_commands;

    ConnectBar* m_connectBar = nullptr;
    AppearanceButtons* m_appearance = nullptr;
    Banner* m_banner = nullptr;
    QStackedWidget* m_center = nullptr;
    Pages* m_pages = nullptr;
    QDockWidget* m_searchDock = nullptr;
    QDockWidget* m_logDock = nullptr;
    MessageLine* m_message = nullptr;
    MessageLog* m_log = nullptr;
    QPushButton* m_stop = nullptr;
    Menus* m_menus = nullptr;
    AutoSelection* m_autoSelection = nullptr;
    CloseConfirmation* m_closeConfirmation = nullptr;

    bool m_wasOpen = false;
    bool m_canClose = false; ///< the workbench has been closed
};
} // namespace ui
