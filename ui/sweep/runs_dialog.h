// SPDX-License-Identifier: GPL-3.0-or-later
// Earlier sweep tests: found again, labeled, held against each other, one of a model marked as
// the reference, their reports saved, deleted. Stays open beside the window; follows the archive,
// which must outlive it. Main thread, never waits.
#pragma once

#include "session/history/history_service.h"
#include "session/settings.h"
#include "ui/sweep/runs_model.h"
#include "ui/widgets/task_result.h"

#include <QDialog>

class QLabel;
class QLineEdit;
class QPushButton;
class QTableView;

namespace ui {
class RunsDialog final : public QDialog {
    Q_OBJECT

public:
    RunsDialog(session::HistoryService& historyService, session::Settings& settings,
               QWidget* parent);

protected:
    void changeEvent(QEvent* event) override;

private:
    void build();
    void retranslate();
    void query();
    void fill(const base::Result<std::vector<record::TestRun>>& runs);
    static QString noReferenceReason(const record::TestRun& run, const record::TestServo& servo);
    void updateButtons();
    std::vector<int> rows() const; ///< the selected ones, from the top
    void openReport();
    void saveReport(const RunRow& row, const QString& path, const QStringList& files);
    void compare();
    void markReference();
    void editLabel();
    void removeRuns();
    void showError(const base::Error& error);
    void showSaved(const QString& path);

    session::HistoryService& m_historyService;
    session::Settings& m_settings;
    RunsModel* m_model;
    QLabel* m_hint;
    QLineEdit* m_filter;
    QTableView* m_table;
    TaskResult* m_result;
    QPushButton* m_report;
    QPushButton* m_compare;
    QPushButton* m_reference;
    QPushButton* m_label;
    QPushButton* m_delete;
    QPushButton* m_close;
    int m_queryId = 0; ///< only the latest list is shown
    bool m_loaded = false;
};

/// "Hysteresis, both sides +5 step (worse)", after "Compared with reference STS3215 (test of 12
/// Nov):"; what the sweep page shows after a run. Empty: no reference.
QString referenceText(const session::ReferenceResult& result);
} // namespace ui
