// SPDX-License-Identifier: GPL-3.0-or-later
// Interrupted writes of earlier sessions, each to be finished, undone, forgotten or left for later.
// Those that were begun on other ports are listed, and searched on this port on request, because an
// adapter may have come back under another name. Nothing is done without a request. Follows
// Workbench::openIntents while it is open. Main thread.
#pragma once

#include "session/workbench.h"
#include "ui/tasks/intents_model.h"
#include "ui/widgets/task_result.h"

#include <QDialog>

class QHBoxLayout;
class QLabel;
class QPushButton;
class QTableView;

namespace ui {
class FitColumns;
class IntentsDialog final : public QDialog {
    Q_OBJECT

public:
    IntentsDialog(session::Workbench& workbench, const std::vector<jobs::RecoveryResult>& found,
                  const std::vector<base::Intent>& elsewhere, QWidget* parent);

private:
    void build();
    QHBoxLayout* buildButtons();
    QString explanation() const;
    void retranslate();
    void updateFinishText();
    void updateButtons();
    const jobs::RecoveryResult* current() const;
    void recover(jobs::RecoveryAction action);
    void discardIntent();
    void setIntents(const std::vector<jobs::RecoveryResult>& all,
                    const std::vector<base::Intent>& elsewhere);
    void updateElsewhereText();
    void onRecovered(const std::vector<jobs::RecoveryResult>& one);
    void onRecoveryFailed(const session::Event& event);
    void reload();

    session::Workbench& m_workbench;
    IntentsModel* m_model;
    QLabel* m_explanation;
    QTableView* m_table;
    FitColumns* m_columns = nullptr;
    QLabel* m_otherPortText;
    QPushButton* m_searchHere;
    std::vector<base::Intent> m_otherPortIntents;
    bool m_searchedHere = false; ///< those begun elsewhere have been searched here
    TaskResult* m_result;
    QPushButton* m_finish;
    QPushButton* m_undo;
    QPushButton* m_forget;
    QPushButton* m_later;
    QString m_recovering; ///< uuid of the one being worked on
};
} // namespace ui
