// SPDX-License-Identifier: GPL-3.0-or-later
// A new baud rate for a servo: the rates of its family and what changes with it; the program then
// continues at the new rate. Main thread.
#pragma once

#include "ui/tasks/task_dialog.h"

class QComboBox;

namespace ui {
class SetBaudDialog final : public TaskDialog {
    Q_OBJECT

public:
    SetBaudDialog(session::Workbench& workbench, session::ServoRef servo, QWidget* parent);

protected:
    void retranslate() override;
    void refresh() override;
    void runAction() override;

private:
    void fillRates();
    void validate();
    int neighbors() const; ///< number of other servos at its present rate

    QLabel* m_label;
    QComboBox* m_rates;
    QLabel* m_state;
};
} // namespace ui
