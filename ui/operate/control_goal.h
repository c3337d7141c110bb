// SPDX-License-Identifier: GPL-3.0-or-later
// The goal of the present mode: a slider with the servo's limits and a number for positions and
// signed speeds, PWM and currents; a step with ↻ ↺ and "again" in step mode; a stop button where
// the servo turns on by itself. Says what is wanted; sends nothing. Owned by the control panel;
// main thread.
#pragma once

#include "device/motion/move_limits.h"
#include "session/servo_entry.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace ui {
class ControlField;
class ControlSlider;

class ControlGoal final : public QWidget {
    Q_OBJECT

public:
    explicit ControlGoal(QWidget* parent);

    struct Steps {
        std::int64_t sum = 0; ///< made since connecting
        bool canRepeat = false;
    };
    void showServo(const session::ServoEntry& entry, const Steps& steps);
    void retranslate();

    /// What stands in the box: to be sent by Set. Nullopt: nothing that makes sense.
    std::optional<std::int64_t> goal() const;
    QString inputError() const;
    /// The goal as the servo has it, or as it is being dragged.
    std::optional<std::int64_t> shownGoal() const { return m_shown; }
    /// It is on its way: shown until it is there or given up. Nothing is on its way any more.
    void setPending(std::int64_t raw);
    void clearPending();
    /// It is there, and shown until a newer reading.
    void setSent(std::int64_t raw, base::Duration at);
    void clearSent();
    /// What was typed is dropped.
    void discardEdit();
    /// As if it had been typed: nothing is sent.
    void enterValue(std::int64_t raw);
    /// What was being dragged did not get there. What is typed stays, to be corrected.
    void cancelDrag();
    /// From the dial: as if the slider had been dragged there, and let go.
    void setFromDial(std::int64_t raw);
    void endDialDrag();

Q_SIGNALS:
    void goalMoved(std::int64_t raw, bool dragged);
    void dragEnded();
    void returnPressed(); ///< Enter in the box
    void stopRequested();
    void stepRequested(std::int64_t raw);
    void repeatRequested();
    void goalShown(std::int64_t raw);

private:
    void buildSteps();
    QString withDirection(const QString& sign, const QString& text) const;
    void fillSlider(const session::ServoEntry& entry);
    void fillSteps(const Steps& steps);
    void setShownGoal(std::optional<std::int64_t> raw);
    std::optional<std::int64_t> effectiveRaw(const session::ServoEntry& entry) const;

    ControlSlider* m_slider;
    ControlField* m_field;
    QWidget* m_steps;
    QPushButton* m_minus;
    QPushButton* m_plus;
    QPushButton* m_repeat;
    QLabel* m_stepsLeft;
    QPushButton* m_stop;
    QLabel* m_directionLabel; ///< which way + and − turn

    std::optional<device::GoalKind> m_kind;
    device::PositiveDirection m_positive = device::PositiveDirection::Forward;
    session::ServoRef m_servo = 0;
    std::optional<std::int64_t> m_shown;
    bool m_dialDrag = false;
    std::optional<std::int64_t> m_pendingGoal; ///< on its way
};
} // namespace ui
