// SPDX-License-Identifier: GPL-3.0-or-later
// What the window is made of, and where it stands.
#include "ui/app/main_window.h"
#include "ui/app/menus.h"
#include "ui/app/message_line.h"
#include "ui/app/message_log.h"
#include "ui/commissioning/commission_page.h"
#include "ui/common/language_switch.h"
#include "ui/common/theme.h"
#include "ui/connect/connect_bar.h"
#include "ui/history/history_page.h"
#include "ui/memory/memory_page.h"
#include "ui/operate/operate_page.h"
#include "ui/search/search_panel.h"
#include "ui/snapshots/snapshots_page.h"
#include "ui/step/step_page.h"
#include "ui/sweep/sweep_page.h"
#include "ui/widgets/banner.h"
#include "ui/widgets/floating_overlay.h"
#include "ui/widgets/welcome.h"

#include <QDockWidget>
#include <QHBoxLayout>
#include <QMenuBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QStatusBar>
#include <QTabWidget>
#include <QToolBar>
#include <QToolButton>

namespace ui {
namespace {
constexpr int maxUndoChars = 26;
}

void MainWindow::build()
{
    setObjectName(QStringLiteral("mainWindow"));
    setMinimumSize(1024, 700);
    resize(1280, 800);
    auto* top = new QToolBar(this);
    top->setObjectName(QStringLiteral("topBar"));
    top->setMovable(false);
    top->toggleViewAction()->setVisible(false);
    top->addWidget(buildTopBar());
    addToolBar(top);
    setContextMenuPolicy(Qt::NoContextMenu); // its only entry would hide the bar
    setCentralWidget(buildCenter());
    buildDocks();
    buildStatusBar();
    m_menus = new Menus(*menuBar(), m_commands,
                        {m_searchDock->toggleViewAction(), m_commands.action(Command::MessageLog)});
    // Actions in no menu that is open still answer to their keys.
    for (int i = 0; i < static_cast<int>(Command::Count); ++i)
        addAction(m_commands.action(static_cast<Command>(i)));
}

QWidget* MainWindow::buildTopBar()
{
    auto* bar = new QWidget(this);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(4, 4, 4, 4);
    m_connectBar = new ConnectBar(m_desk, m_commands, m_settings, m_ports, bar);
    m_languageButton = new QToolButton(bar);
    m_languageButton->setObjectName(QStringLiteral("languageButton"));
    m_themeButton = new QToolButton(bar);
    m_themeButton->setObjectName(QStringLiteral("themeButton"));
    row->addWidget(m_connectBar, 1);
    row->addWidget(m_languageButton);
    row->addWidget(m_themeButton);
    return bar;
}

QWidget* MainWindow::buildCenter()
{
    auto* center = new QWidget(this);
    auto* column = new QVBoxLayout(center);
    column->setContentsMargins(6, 6, 6, 6);
    m_banner = new Banner(center);
    m_pages = new QTabWidget(center);
    m_pages->setObjectName(QStringLiteral("pages"));
    m_pages->setDocumentMode(true);
    m_operate = new OperatePage(m_context, m_settings, m_pages);
    m_memory = new MemoryPage(m_desk, m_commands, m_selection, m_settings, m_pages);
    m_sweep = new SweepPage(m_context, m_settings, m_pages);
    m_step = new StepPage(m_context, m_settings, m_pages);
    m_snapshots = new SnapshotsPage(m_context, m_settings, m_pages);
    m_commission = new CommissionPage(m_context, m_settings, m_pages);
    m_history = new HistoryPage(m_context, m_settings, m_pages);
    for (QWidget* page : std::initializer_list<QWidget*>{m_operate, m_memory, m_sweep, m_step,
                                                         m_snapshots, m_commission, m_history})
        m_pages->addTab(page, QString());
    m_center = new QStackedWidget(center);
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
        new SearchPanel(m_desk, m_commands, m_selection, m_settings, m_searchDock));
    addDockWidget(Qt::LeftDockWidgetArea, m_searchDock);
    m_logDock = new QDockWidget(this);
    m_logDock->setObjectName(QStringLiteral("logDock"));
    m_log = new MessageLog(m_desk, m_logDock);
    m_logDock->setWidget(m_log);
    addDockWidget(Qt::BottomDockWidgetArea, m_logDock);
    m_logDock->hide();
}

void MainWindow::buildStatusBar()
{
    m_message = new MessageLine(m_desk, this);
    m_undo = new QToolButton(this);
    m_undo->setObjectName(QStringLiteral("undoButton"));
    m_undo->setDefaultAction(m_commands.action(Command::Undo));
    m_undo->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    // One width for all names: the button must not move under the pointer.
    m_undo->setFixedWidth(maxUndoChars * m_undo->fontMetrics().averageCharWidth() +
                          2 * m_undo->iconSize().width());
    const auto nameUndo = [this] {
        const QString name = m_commands.action(Command::Undo)->iconText();
        m_undo->setAccessibleName(name);
        m_undo->setText(m_undo->fontMetrics().elidedText(
            name, Qt::ElideRight, maxUndoChars * m_undo->fontMetrics().averageCharWidth()));
    };
    connect(m_commands.action(Command::Undo), &QAction::changed, m_undo, nameUndo);
    nameUndo();
    m_stop = new QPushButton(this);
    m_stop->setObjectName(QStringLiteral("stopButton"));
    m_stop->setProperty("stopAction", true);
    m_stop->setFocusPolicy(Qt::NoFocus); // pressing it must not close an editor first
    statusBar()->setSizeGripEnabled(false);
    statusBar()->setContentsMargins(0, 3, 8, 3);
    statusBar()->addWidget(m_message, 1);
    statusBar()->addPermanentWidget(m_undo);
    statusBar()->addPermanentWidget(m_stop);
}

void MainWindow::retranslate()
{
    setWindowTitle(tr("ServoDesk"));
    m_searchDock->setWindowTitle(tr("Search"));
    m_logDock->setWindowTitle(tr("Messages"));
    m_pages->setTabText(m_pages->indexOf(m_operate), tr("Operate"));
    m_pages->setTabToolTip(m_pages->indexOf(m_operate), tr("Drive the servo and watch it"));
    m_pages->setTabText(m_pages->indexOf(m_memory), tr("Memory"));
    m_pages->setTabToolTip(m_pages->indexOf(m_memory),
                           tr("The servo's memory table: every setting, read and written safely"));
    m_pages->setTabText(m_pages->indexOf(m_sweep), tr("Sweep test"));
    m_pages->setTabToolTip(m_pages->indexOf(m_sweep),
                           tr("Run servos through their paces and say whether they are good"));
    m_pages->setTabText(m_pages->indexOf(m_step), tr("Step response"));
    m_pages->setTabToolTip(m_pages->indexOf(m_step),
                           tr("See how a servo answers a step, and try other gains"));
    m_pages->setTabText(m_pages->indexOf(m_snapshots), tr("Snapshots"));
    m_pages->setTabToolTip(m_pages->indexOf(m_snapshots),
                           tr("Save, compare and restore what servos keep"));
    m_pages->setTabText(m_pages->indexOf(m_commission), tr("Commissioning"));
    m_pages->setTabToolTip(m_pages->indexOf(m_commission),
                           tr("Set up servos plugged in one after the other"));
    m_pages->setTabText(m_pages->indexOf(m_history), tr("History"));
    m_pages->setTabToolTip(m_pages->indexOf(m_history),
                           tr("What was ever written, saved, tested and alarmed"));
    m_pages->setAccessibleName(tr("Pages"));
    m_stop->setText(tr("Esc   Torque off — all"));
    m_stop->setToolTip(m_commands.action(Command::TorqueOffAll)->toolTip());
    m_stop->setAccessibleName(tr("Torque off for all servos"));
    const bool chinese = m_language.chinese();
    const bool letters = LanguageSwitch::canShowChinese();
    const QString name = letters ? QStringLiteral("中") : QStringLiteral("ZH");
    m_languageButton->setText(chinese ? name + QStringLiteral(" / EN")
                                      : QStringLiteral("EN / ") + name);
    m_languageButton->setToolTip(
        letters ? tr("Switch between English and Chinese")
                : tr("Switch between English and Chinese. No font for Chinese is installed "
                     "(Debian: fonts-noto-cjk)."));
    m_languageButton->setAccessibleName(tr("Language"));
    m_themeButton->setToolTip(tr("Switch between light and dark"));
    m_themeButton->setAccessibleName(tr("Theme"));
}
} // namespace ui
