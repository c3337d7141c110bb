// SPDX-License-Identifier: GPL-3.0-or-later
// The tests of one kind that are stored in the history: listed, filtered, labeled, deleted. The
// base of the windows of earlier sweep tests and of earlier step responses, which add their own
// buttons. Stays open beside the window and follows the history, which must outlive it. Main
// thread, never waits.
#pragma once

#include "session/history/history_service.h"
#include "ui/widgets/runs_model.h"
#include "ui/widgets/task_result.h"

#include <QDialog>

class QHBoxLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableView;

namespace ui {
class RunListDialog : public QDialog {
    Q_OBJECT

public:
    RunListDialog(session::HistoryService& historyService, const QString& kind, QWidget* parent);

protected:
    QPushButton* addButton(const char* name); ///< before Label…
    static void setButtonText(QPushButton* button, const QString& text, const QString& tip);
    void hideColumns(std::initializer_list<RunColumn> columns);
    std::vector<int> rows() const; ///< the selected ones, from the top
    void query();                  ///< once at the end of the constructor of the class below
    void showError(const base::Error& error);
    void showHint(const QString& hint); ///< below the list

    virtual void retranslate();
    virtual void updateButtons(); ///< other rows, or another selection
    virtual QString deletionText() const = 0;

    session::HistoryService& m_historyService;
    RunsModel* m_model;
    QLabel* m_hint;
    QTableView* m_table;
    TaskResult* m_result;

private:
    void build();
    void fill(const base::Result<std::vector<history::TestRun>>& runs);
    void editLabel();
    void removeRuns();

    const QString m_kind; ///< history::TestRun::kind
    QLineEdit* m_filter;
    QHBoxLayout* m_buttons;
    int m_ownButtons = 0; ///< how many of its buttons belong to the class below
    QPushButton* m_label;
    QPushButton* m_delete;
    QPushButton* m_close;
    int m_queryId = 0; ///< only the latest list is shown
    bool m_hasList = false;
    bool m_loaded = false;
};
} // namespace ui
