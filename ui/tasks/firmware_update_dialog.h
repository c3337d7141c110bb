// SPDX-License-Identifier: GPL-3.0-or-later
// Gives servos a new firmware from the vendor's file, one after the other: first the checks, each
// of which must be good or accepted, then the update. What was accepted counts for the servos after
// it as far as it is the same risk; a check that fails there is asked about. An update that fails
// ends the list, and so do Stop and closing the dialog. See TaskDialog.
#pragma once

#include "base/firmware_update.h"
#include "ui/tasks/firmware_report_text.h"
#include "ui/tasks/task_dialog.h"

#include <set>
#include <vector>

class QGridLayout;

namespace ui {
class FirmwareFileRow;

class FirmwareUpdateDialog final : public TaskDialog {
    Q_OBJECT

public:
    /// `servos`: at least one; in this order.
    FirmwareUpdateDialog(session::Workbench& workbench, std::vector<session::ServoRef> servos,
                         session::Settings& settings, QWidget* parent);

protected:
    QString servoText() const override;
    QString closeTip() const override;
    void retranslate() override;
    void refresh() override;
    void runAction() override;

private:
    void check();
    void checked(const std::vector<base::FirmwareCheckResult>& results,
                 const std::optional<base::Error>& error);
    void update();
    void updated(FirmwareUpdate done);
    void end(FirmwareUpdate last);
    void showDone();
    void onFileChanged();
    void keepSameRisks(const catalog::Profile& updated);
    void showRefusal();
    void showChecks();
    void addCheck(int row, const base::FirmwareCheckResult& result);
    bool isChecked() const { return !m_checks.empty(); }
    bool isGood() const;
    const session::ServoEntry* next() const; ///< null: it is gone
    std::vector<int> ids(std::size_t first = 0) const;

    const std::vector<session::ServoRef> m_servos;
    std::vector<FirmwareUpdate> m_done; ///< as many of the first servos; all but the last updated
    FirmwareFileRow* m_file;
    QWidget* m_list;
    QLabel* m_untried;
    std::vector<base::FirmwareCheckResult> m_checks; ///< of the next servo; empty: not done yet
    std::set<base::FirmwareCheck> m_accepted;        ///< although they have failed
};
} // namespace ui
