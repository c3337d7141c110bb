// SPDX-License-Identifier: GPL-3.0-or-later
// A new ID for a servo: who has which is listed, free ones are proposed after a quick look, and the
// job proves it free before anything is written. Main thread.
#pragma once

#include "ui/tasks/task_dialog.h"

class QListWidget;
class QListWidgetItem;
class QSpinBox;

namespace ui {
class SetIdDialog final : public TaskDialog {
    Q_OBJECT

public:
    SetIdDialog(session::Desk& desk, session::ServoRef servo, QWidget* parent);

protected:
    void retranslate() override;
    void refresh() override;
    void runAction() override;

private:
    void findFreeIds();
    void fillList();
    void validate();
    void selectId(const QListWidgetItem* item);
    void onDeskEvent(const session::Event& event);
    const session::ServoEntry* servoWithId(int id) const;

    QLabel* m_label;
    QSpinBox* m_id;
    QListWidget* m_list;
    QLabel* m_state;
    std::vector<int> m_free;     ///< silent when last asked
    bool m_chosenByUser = false; ///< by the user, so proposals no longer change it
    int m_pendingId = -1;        ///< being written
};
} // namespace ui
