// SPDX-License-Identifier: GPL-3.0-or-later
// Resets a servo to factory defaults: saves the memory table first and shows where, then reports
// ID, baud rate and settings. Main thread.
#pragma once

#include "jobs/change/change.h"
#include "ui/tasks/task_dialog.h"

namespace ui {
class RestoreDefaultsDialog final : public TaskDialog {
    Q_OBJECT

public:
    RestoreDefaultsDialog(session::Workbench& workbench, session::ServoRef servo, QWidget* parent);

protected:
    void retranslate() override;
    void refresh() override;
    void runAction() override;

private:
    struct Outcome {
        QString path; ///< empty: the table was not saved
        std::optional<jobs::RestoreDefaultsReport> report;
    };
    TaskText outcomeText(const Outcome& outcome, const session::TaskCompletion& end) const;
    bool canRun() const;

    QLabel* m_summary;
};
} // namespace ui
