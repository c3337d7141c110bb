// SPDX-License-Identifier: GPL-3.0-or-later
// What leads from one page of the window to another.
#include "ui/app/main_window.h"
#include "ui/commissioning/commission_page.h"
#include "ui/history/history_page.h"
#include "ui/memory/memory_page.h"
#include "ui/operate/operate_page.h"
#include "ui/snapshots/snapshots_page.h"
#include "ui/step/step_page.h"
#include "ui/sweep/sweep_page.h"
#include "ui/trends/trend_panel.h"

#include <QTabWidget>

namespace ui {
/// What the chart shows belongs to the operate page; whoever asks for it is led there.
void MainWindow::connectPages()
{
    const auto on = [this](Command command, QWidget* page, auto slot) {
        connect(m_commands.action(command), &QAction::triggered, this, [this, page, slot] {
            m_pages->setCurrentWidget(page);
            slot();
        });
    };
    const auto nothing = [] {};
    TrendPanel* trend = m_operate->trend();
    on(Command::PageOperate, m_operate, nothing);
    on(Command::PageMemory, m_memory, nothing);
    on(Command::PageSweep, m_sweep, nothing);
    on(Command::PageStep, m_step, nothing);
    const auto withoutPort = [this] {
        m_pagesRequested = true;
        updateCenter();
    };
    on(Command::PageSnapshots, m_snapshots, withoutPort);
    on(Command::PageCommission, m_commission, nothing);
    on(Command::PageHistory, m_history, withoutPort);
    on(Command::TakeSnapshot, m_snapshots, [this] { m_snapshots->takeSnapshot(); });
    on(Command::PauseTrend, m_operate, [trend] { trend->toggleFollowing(); });
    on(Command::Record, m_operate, [trend] { trend->toggleRecording(); });
    on(Command::OpenRecording, m_operate, [trend] { trend->openRecording(); });
    connectHistory();
    // A recording can be looked at without a servo.
    connect(trend, &TrendPanel::replayShown, this, [this] { updateCenter(); });
}

/// What is found in the history is shown where it can be used; copies go to the server.
void MainWindow::connectHistory()
{
    connect(m_history, &HistoryPage::snapshotRequested, this, [this](std::int64_t number) {
        m_pages->setCurrentWidget(m_snapshots);
        m_snapshots->showHistorySnapshot(number);
    });
    connect(m_history, &HistoryPage::tableRequested, this,
            [this](const session::SharedSnapshot& table, const QString& title) {
                m_pages->setCurrentWidget(m_snapshots);
                m_snapshots->showTable(table, title);
            });
    connect(m_history, &HistoryPage::previousTestsRequested,
            m_commands.action(Command::PreviousTests), &QAction::trigger);
    connect(&m_context.history, &session::HistoryService::changed, &m_context.historySender,
            &session::HistorySender::notifyChanged);
    connect(&m_desk, &session::Desk::eventOccurred, &m_context.historySender,
            &session::HistorySender::notifyChanged);
}
} // namespace ui
