// SPDX-License-Identifier: GPL-3.0-or-later
// What was ever done on this bench: writes, snapshots, tests, alarms, recordings, servos, filtered
// by servo, time and register; from this computer or from the shop's server. A table as it was at
// any moment goes to the snapshots page, from where it can be restored. Writes nothing to servos.
// Owned by the window; main thread, never waits.
#pragma once

#include "session/settings.h"
#include "ui/common/app_context.h"
#include "ui/history/history_table_model.h"

#include <QPersistentModelIndex>
#include <QPointer>
#include <QTimer>
#include <QWidget>

class QCheckBox;
class QComboBox;
class QDateEdit;
class QLabel;
class QPushButton;
class QTableView;

namespace ui {
class Banner;
class FitColumns;

class HistoryPage final : public QWidget {
    Q_OBJECT

public:
    HistoryPage(AppContext& appContext, session::Settings& settings, QWidget* parent = nullptr);
    ~HistoryPage() override;

Q_SIGNALS:
    void snapshotRequested(std::int64_t number); ///< of the history of this computer
    void tableRequested(session::SharedSnapshot table, const QString& title);
    void previousTestsRequested(); ///< the window of earlier tests

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    // history_page_build.cpp
    void build();
    QWidget* buildFilters();
    QWidget* buildActions();
    void connectAll();
    void retranslate();

    // history_page.cpp
    session::HistoryService& historyService() const;
    bool isRemote() const;
    void onSourceChanged();
    void setViewing(bool viewing); ///< only this computer's history is watched for changes
    void scheduleQuery();
    void query();
    void loadFilterValues();
    record::HistoryFilter filter() const;
    std::optional<int> current() const; ///< the row; none
    void saveTopRow(int changedFrom);
    void restoreTopRow();
    void showState();
    void showServer();
    static QString sendErrorText(const session::SendState& state);

    // history_page_actions.cpp
    void openTable();
    void openSnapshot(std::int64_t number);
    void openTableAt(const HistoryLine& line);
    void editLabel();
    void exportList();
    void setServer();
    void showError(const base::Error& error);

    session::Desk& m_desk;
    session::HistoryService& m_local;
    QPointer<session::HistoryService> m_localGuard; ///< a window may hide its pages on its way out
    session::HistorySender& m_sender;
    session::Settings& m_settings;
    const catalog::Catalog& m_catalog;
    std::unique_ptr<session::HistoryService> m_server; ///< while it is looked at
    HistoryTableModel m_table;
    Banner* m_banner = nullptr;
    QComboBox* m_source = nullptr;
    QComboBox* m_kind = nullptr;
    QComboBox* m_servo = nullptr;
    QComboBox* m_register = nullptr;
    QComboBox* m_period = nullptr;
    QDateEdit* m_from = nullptr;
    QDateEdit* m_until = nullptr;
    QCheckBox* m_onlyErrors = nullptr;
    QLabel* m_identityHint = nullptr;
    QLabel* m_count = nullptr;
    QLabel* m_serverState = nullptr;
    QTableView* m_view = nullptr;
    FitColumns* m_columns = nullptr;
    QPushButton* m_open = nullptr;
    QPushButton* m_label = nullptr;
    QPushButton* m_export = nullptr;
    QPushButton* m_serverSet = nullptr;
    QTimer m_queryTimer;            ///< several changes, one question
    QPersistentModelIndex m_topRow; ///< the row to keep at the top; none: the list is at its top
    bool m_columnsUnsized = true;   ///< the columns; until there are rows
};
} // namespace ui
