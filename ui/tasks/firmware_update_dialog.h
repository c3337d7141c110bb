// SPDX-License-Identifier: GPL-3.0-or-later
// Gives the servo a new firmware from the vendor's file: first the checks, each of which must be
// good or accepted, then the update. See TaskDialog.
#pragma once

#include "base/firmware_update.h"
#include "ui/tasks/task_dialog.h"

#include <set>

class QGridLayout;

namespace ui {
class FirmwareFileRow;

class FirmwareUpdateDialog final : public TaskDialog {
    Q_OBJECT

public:
    FirmwareUpdateDialog(session::Workbench& workbench, session::ServoRef servo,
                         session::Settings& settings, QWidget* parent);

protected:
    void retranslate() override;
    void refresh() override;
    void runAction() override;

private:
    void check();
    void update();
    void forgetChecks();
    void showRefusal();
    void showChecks();
    void addCheck(int row, const base::FirmwareCheckResult& result);
    bool isChecked() const { return !m_checks.empty(); }

    FirmwareFileRow* m_file;
    QWidget* m_list;
    QLabel* m_untried;
    std::vector<base::FirmwareCheckResult> m_checks; ///< of the selected file; empty: not done yet
    std::set<base::FirmwareCheck> m_accepted;        ///< although they have failed
};
} // namespace ui
