// SPDX-License-Identifier: GPL-3.0-or-later
// A new ID for a servo: lists the used IDs, proposes free ones after a quick search; the job checks
// that the ID is free before it writes. Main thread.
#pragma once

#include "ui/tasks/task_dialog.h"

class QListWidget;
class QListWidgetItem;
class QSpinBox;

namespace ui {
class SetIdDialog final : public TaskDialog {
    Q_OBJECT

public:
    SetIdDialog(session::Workbench& workbench, session::ServoRef servo, QWidget* parent);

protected:
    void retranslate() override;
    void refresh() override;
    void runAction() override;

private:
    void findFreeIds();
    void fillList();
    void validate();
    void selectId(const QListWidgetItem* item);
    const session::ServoEntry* servoWithId(int id) const;

    QLabel* m_label;
    QSpinBox* m_id;
    QListWidget* m_list;
    QLabel* m_state;
    std::vector<int> m_free;     ///< did not answer when last asked
    bool m_chosenByUser = false; ///< proposals no longer change it
};
} // namespace ui
