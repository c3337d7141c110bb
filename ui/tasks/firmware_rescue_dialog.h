// SPDX-License-Identifier: GPL-3.0-or-later
// Gives a servo that hangs in its bootloader a firmware from the vendor's file: its ID is
// known only afterwards. See TaskDialog.
#pragma once

#include "ui/tasks/task_dialog.h"

namespace ui {
class FirmwareFileRow;

class FirmwareRescueDialog final : public TaskDialog {
    Q_OBJECT

public:
    FirmwareRescueDialog(session::Workbench& workbench, session::Settings& settings,
                         QWidget* parent);

protected:
    QString progressText(const jobs::Progress& progress) const override;
    void retranslate() override;
    void refresh() override;
    void runAction() override;

private:
    void search(const device::Servo& servo);

    FirmwareFileRow* m_file;
    QLabel* m_untried;
};
} // namespace ui
