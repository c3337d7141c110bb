// SPDX-License-Identifier: GPL-3.0-or-later
// The goal of the present mode: a slider with the servo's limits and a number for positions and
// signed speeds, PWM and currents; a step with ↻ ↺ and "again" in step mode; a stop button where
// the servo turns on by itself. Says what is wanted; sends nothing. Owned by the control panel;
// main thread.
#pragma once

#include "device/move_limits.h"
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
    QString complaint() const;
    /// The goal as the servo has it, or as it is being dragged.
    std::optional<std::int64_t> shown() const { return m_shown; }
    /// It is on its way: shown until it is there or given up. Nothing is on its way any more.
    void isSending(std::int64_t raw);
    void endSending();
    /// It is there, and shown until a newer reading.
    void wasSent(std::int64_t raw, base::Duration at);
    void forgetSent();
    /// What was typed is dropped.
    void forgetEdit();
    /// As if it had been typed: nothing is sent.
    void type(std::int64_t raw);
    /// What was being dragged did not get there. What is typed stays, to be corrected.
    void giveUp();
    /// From the dial: as if the slider had been dragged there, and let go.
    void put(std::int64_t raw);
    void endPut();

Q_SIGNALS:
    void moved(std::int64_t raw, bool dragged);
    void dragEnded();
    void entered(); ///< Enter in the box
    void stopWanted();
    void stepWanted(std::int64_t raw);
    void againWanted();
    void goalShown(std::int64_t raw);

private:
    void buildSteps();
    QString turning(const QString& sign, const QString& words) const;
    void fillSlider(const session::ServoEntry& entry);
    void fillSteps(const Steps& steps);
    void show(std::optional<std::int64_t> raw);
    std::optional<std::int64_t> standing(const session::ServoEntry& entry) const;

    ControlSlider* m_slider;
    ControlField* m_field;
    QWidget* m_steps;
    QPushButton* m_minus;
    QPushButton* m_plus;
    QPushButton* m_again;
    QLabel* m_left;
    QPushButton* m_stop;
    QLabel* m_way; ///< which way + and − turn

    std::optional<device::GoalKind> m_kind;
    device::Positive m_positive = device::Positive::Forward;
    session::ServoRef m_servo = 0;
    std::optional<std::int64_t> m_shown;
    bool m_dialDrag = false;
    std::optional<std::int64_t> m_sending; ///< on its way
};
} // namespace ui
