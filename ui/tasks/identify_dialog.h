// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the servo blink as soon as it is opened, and reports when its LED is as before. Closing it
// ends the blinking. Main thread.
#pragma once

#include "ui/tasks/task_dialog.h"

namespace ui {
class IdentifyDialog final : public TaskDialog {
    Q_OBJECT

public:
    IdentifyDialog(session::Workbench& workbench, session::ServoRef servo, QWidget* parent);

    void done(int result) override;

protected:
    void retranslate() override;
    void runAction() override;
};
} // namespace ui
