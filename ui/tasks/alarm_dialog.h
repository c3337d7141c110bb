// SPDX-License-Identifier: GPL-3.0-or-later
// The alarms of a servo by cause: each with its value and limits, read again and again until it is
// gone; what clears it, and a button where something can be done. Asks before the shaft moves or
// torque is turned on. Where only waiting helps it writes nothing. Main thread.
#pragma once

#include "jobs/change/clear_alarm.h"
#include "ui/tasks/task_dialog.h"

#include <QTimer>

class QTableWidget;

namespace ui {
class AlarmDialog final : public TaskDialog {
    Q_OBJECT

public:
    AlarmDialog(session::Workbench& workbench, session::ServoRef servo, QWidget* parent);

protected:
    void retranslate() override;
    void refresh() override;
    void runAction() override;

private:
    void reload();
    void onPlanRead(const base::Result<jobs::AlarmPlan>& plan);
    void fillTable();
    void fillRow(int row, const jobs::Alarm& alarm);
    void clearAlarms();
    void onCleared(const jobs::AlarmReport& report, const device::Notices& notices);
    QString actionText() const;
    QString positionText(const std::optional<std::int64_t>& raw) const;

    QTableWidget* m_table;
    QLabel* m_release;
    QTimer m_refreshTimer;
    std::optional<jobs::AlarmPlan> m_plan;
    bool m_hadAlarm = false;
    bool m_confirming = false; ///< the user reads the question
};
} // namespace ui
