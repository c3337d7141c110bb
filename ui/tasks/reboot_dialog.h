// SPDX-License-Identifier: GPL-3.0-or-later
// Reboots a servo and waits until it answers again. Main thread.
#pragma once

#include "ui/tasks/task_dialog.h"

namespace ui {
class RebootDialog final : public TaskDialog {
    Q_OBJECT

public:
    RebootDialog(session::Workbench& workbench, session::ServoRef servo, QWidget* parent);

protected:
    void retranslate() override;
    void refresh() override;
    void runAction() override;

private:
    bool canRun() const;
};
} // namespace ui
