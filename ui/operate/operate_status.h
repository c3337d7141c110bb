// SPDX-License-Identifier: GPL-3.0-or-later
// The lights above the gauges: does the servo answer, does it move, which faults are there or have
// been since they were last acknowledged, how old the values are and how often they come. Owned by
// the page; main thread.
#pragma once

#include "session/desk.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace ui {
class FlowLayout;
class Pill;

class OperateStatus final : public QWidget {
    Q_OBJECT

public:
    explicit OperateStatus(QWidget* parent = nullptr);

    /// Null: no servo is selected.
    void show(const session::ServoEntry* entry, const session::Desk& desk);

Q_SIGNALS:
    void acknowledgeRequested();

protected:
    void changeEvent(QEvent* event) override;

private:
    void showLink(const session::ServoEntry& entry, const session::Desk& desk);
    void showMoving(const session::ServoEntry& entry, const session::Desk& desk);
    void showAlarms(const session::ServoEntry& entry, const session::Desk& desk);
    void showAge(const session::ServoEntry& entry, const session::Desk& desk);
    void retranslate();

    FlowLayout* m_row = nullptr;
    Pill* m_link = nullptr;
    Pill* m_moving = nullptr;
    Pill* m_noAlarm = nullptr;
    std::vector<Pill*> m_alarms;
    QPushButton* m_acknowledge = nullptr;
    QLabel* m_age = nullptr;
};
} // namespace ui
