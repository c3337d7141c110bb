// SPDX-License-Identifier: GPL-3.0-or-later
// The lights above the gauges: whether the servo answers and moves, present faults and those since
// the last acknowledgment, the age of the values and their rate. Owned by the page; main thread.
#pragma once

#include "session/workbench.h"

#include <QWidget>

class QLabel;
class QPushButton;
class QToolButton;

namespace ui {
class FlowLayout;
class Pill;

class OperateStatus final : public QWidget {
    Q_OBJECT

public:
    explicit OperateStatus(QWidget* parent = nullptr);

    /// Of the button; without room for them it is off.
    void setGauges(bool shown, bool hasRoom);
    /// Null: no servo is selected.
    void show(const session::ServoEntry* entry, const session::Workbench& workbench);

Q_SIGNALS:
    void acknowledgeRequested();
    void gaugesToggled(bool shown);

private:
    void showLink(const session::ServoEntry& entry, const session::Workbench& workbench);
    void showMoving(const session::ServoEntry& entry, const session::Workbench& workbench);
    void showAlarms(const session::ServoEntry& entry, const session::Workbench& workbench);
    void showAge(const session::ServoEntry& entry, const session::Workbench& workbench);
    void retranslate();

    FlowLayout* m_row = nullptr;
    Pill* m_link = nullptr;
    Pill* m_moving = nullptr;
    Pill* m_noAlarm = nullptr;
    std::vector<Pill*> m_alarms;
    QPushButton* m_acknowledge = nullptr;
    QToolButton* m_gauges = nullptr;
    QLabel* m_age = nullptr;
    session::ServoRef m_ageOf = 0; ///< whose age is shown, since when
    base::Duration m_ageShownAt{};
};
} // namespace ui
