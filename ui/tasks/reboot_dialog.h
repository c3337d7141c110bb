// SPDX-License-Identifier: GPL-3.0-or-later
// Restarts a servo and waits until it answers again. Main thread.
#pragma once

#include "ui/tasks/task_dialog.h"

namespace ui {
class RebootDialog final : public TaskDialog {
    Q_OBJECT

public:
    RebootDialog(session::Desk& desk, session::ServoRef servo, QWidget* parent);

protected:
    void retranslate() override;
    void refresh() override;
    void runAction() override;

private:
    bool canRun() const;
};
} // namespace ui
