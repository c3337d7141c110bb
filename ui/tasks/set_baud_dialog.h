// SPDX-License-Identifier: GPL-3.0-or-later
// A new baud rate for a servo: the rates its family has, what changes with it, and following it
// there. Main thread.
#pragma once

#include "ui/tasks/task_dialog.h"

class QComboBox;

namespace ui {
class SetBaudDialog final : public TaskDialog {
    Q_OBJECT

public:
    SetBaudDialog(session::Desk& desk, session::ServoRef servo, QWidget* parent);

protected:
    void retranslate() override;
    void refresh() override;
    void runAction() override;

private:
    void fillRates();
    void validate();
    void onDeskEvent(const session::Event& event);
    int neighbors() const; ///< other servos at its present rate

    QLabel* m_label;
    QComboBox* m_rates;
    QLabel* m_state;
    bool m_writing = false;
};
} // namespace ui
