// SPDX-License-Identifier: GPL-3.0-or-later
// All writes, snapshots, tests, alarms, recordings and servos of this bench, filtered by servo,
// time and register; from this computer or from the history server. The memory table at the time of
// a write goes to the snapshots page, where it can be restored. Writes nothing to servos. Owned by
// the window; main thread, never waits.
#pragma once

#include "session/history/history_sender.h"
#include "session/history/history_service.h"
#include "session/settings.h"
#include "ui/common/app_context.h"
#include "ui/history/history_table_model.h"

#include <QPointer>
#include <QTimer>
#include <QWidget>

class QLabel;
class QPushButton;

namespace ui {
class Banner;
class HistoryDetails;
class HistoryFilterBar;
class HistoryListView;

class HistoryPage final : public QWidget {
    Q_OBJECT

public:
    HistoryPage(AppContext& appContext, session::Settings& settings, QWidget* parent = nullptr);
    ~HistoryPage() override;

Q_SIGNALS:
    void snapshotRequested(std::int64_t number); ///< of the history of this computer
    void tableRequested(session::SharedSnapshot table, const QString& title);
    void previousTestsRequested();                   ///< the window of earlier tests
    void stepResponseRequested(std::int64_t number); ///< of the history of this computer

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void build();
    QWidget* buildActions();
    void connectAll();
    void retranslate();

    session::HistoryService& historyService() const;
    bool isRemote() const { return m_server != nullptr; }
    void onSourceChanged();
    void setViewing(bool viewing); ///< only this computer's history is watched for changes
    void scheduleQuery();
    void query();
    void showState();
    QString emptyText() const;
    QString countText() const;
    bool isStepResponseSelected() const;
    const HistoryLine* selectedLine() const; ///< null: none
    void showActions();

    void openSelected();
    void openSnapshot(std::int64_t number);
    void openTableAt(const HistoryLine& line);
    void showTableNote(const history::TableState& table);
    void editLabel();
    void exportList();
    void exportTo(const QString& path);
    void editServer();
    void showError(const base::Error& error);

    session::Workbench& m_workbench;
    session::HistoryService& m_local;
    QPointer<session::HistoryService> m_localGuard; ///< the window may hide its pages after it
    session::Settings& m_settings;
    std::unique_ptr<session::HistoryService> m_server; ///< while its history is shown
    HistoryTableModel m_table;
    Banner* m_banner = nullptr;
    HistoryFilterBar* m_filters = nullptr;
    HistoryListView* m_view = nullptr;
    QLabel* m_identityHint = nullptr;
    HistoryDetails* m_details = nullptr;
    QPushButton* m_undo = nullptr;
    QPushButton* m_open = nullptr;
    QPushButton* m_ofServo = nullptr;
    QPushButton* m_label = nullptr;
    QPushButton* m_export = nullptr;
    QPushButton* m_serverSet = nullptr;
    QLabel* m_emptyLabel = nullptr;
    QLabel* m_count = nullptr;
    QTimer m_queryTimer; ///< several changes cause one query
};
} // namespace ui
