// SPDX-License-Identifier: GPL-3.0-or-later
// Back to the stored defaults: the table is saved first and the place shown, then said what became
// of ID, rate and settings. Main thread.
#pragma once

#include "jobs/change/change.h"
#include "ui/tasks/task_dialog.h"

namespace ui {
class RestoreDefaultsDialog final : public TaskDialog {
    Q_OBJECT

public:
    RestoreDefaultsDialog(session::Desk& desk, session::ServoRef servo, QWidget* parent);

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
