// SPDX-License-Identifier: GPL-3.0-or-later
// Writes one snapshot or template to several servos, or a bundle to the servos of a bus: the choice
// of servos, a dry run, the writing with a verdict for each servo, and the results as a file. When
// it is closed, writing continues and ends with an entry in the message log. Main thread, never
// waits.
#pragma once

#include "session/snapshot/restore_request.h"
#include "session/snapshot/snapshots.h"
#include "ui/widgets/task_result.h"

#include <QDialog>

#include <map>

class QCheckBox;
class QLabel;
class QPushButton;
class QTableWidget;
class QTableWidgetItem;

namespace ui {
struct ApplySource {
    QString name{};                     ///< as the user sees it
    session::SharedSnapshot snapshot{}; ///< or
    session::SharedBundle bundle{};
    QStringList only{};             ///< keys; empty: all that a restore selects
    bool dangerous = false;         ///< `only` has dangerous rows
    QStringList otherModelLimits{}; ///< limits that were ticked for another model
};

class ApplyDialog final : public QDialog {
    Q_OBJECT

public:
    ApplyDialog(session::Workbench& workbench, session::Snapshots& snapshots, ApplySource source,
                QWidget* parent);

private:
    enum Column : int { Servo, Model, Rows, Verdict, Count };
    struct Row {
        int id = -1;
        QString model{};
        std::optional<jobs::ApplyResult> applied{};
    };
    void build();
    void retranslate();
    void fillServos();
    void fillRow(int row);
    std::vector<int> selected() const;
    bool dangerous() const;
    void askForConfirmation();
    void run(bool dryRun);
    void addResult(const jobs::ApplyResult& one);
    void onFinished(const session::ApplyCompletion& end, bool dryRun);
    void updateControls();
    void askForSavePath();

    session::Workbench& m_workbench;
    session::Snapshots& m_snapshots;
    const ApplySource m_source;
    std::vector<Row> m_rows;
    bool m_running = false;
    bool m_written = false; ///< there are results to save
    QLabel* m_summary = nullptr;
    QTableWidget* m_table = nullptr;
    QCheckBox* m_rollBack = nullptr;
    QCheckBox* m_otherModel = nullptr;
    QCheckBox* m_dangerous = nullptr; ///< of a bundle; otherwise the ticks decide

    TaskResult* m_result = nullptr;
    QPushButton* m_dryRun = nullptr;
    QPushButton* m_write = nullptr;
    QPushButton* m_stop = nullptr;
    QPushButton* m_save = nullptr;
    QPushButton* m_close = nullptr;
};
} // namespace ui
