// SPDX-License-Identifier: GPL-3.0-or-later
// The goal of the present mode: a slider with the servo's limits and a number for positions and
// signed speeds, PWM and currents; a step with ↻ ↺ and "Repeat" in step mode; a stop button where
// the servo keeps turning. Emits requests; sends nothing. Owned by the control panel; main thread.
#pragma once

#include "device/motion/move_limits.h"
#include "session/servos/servo_entry.h"

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

    /// The value of the box, which Set sends. Nullopt: invalid.
    std::optional<std::int64_t> goal() const;
    QString inputError() const;
    /// The goal in the servo, or the one that is being dragged.
    std::optional<std::int64_t> shownGoal() const { return m_shown; }
    /// The goal is being sent: shown until it is sent or canceled.
    void setPending(std::int64_t raw);
    void clearPending();
    /// The goal was sent: shown until a newer reading.
    void setSent(std::int64_t raw, base::Duration at);
    void clearSent();
    /// Discards what was typed.
    void discardEdit();
    /// As if the user had typed it; sends nothing.
    void enterValue(std::int64_t raw);
    /// The dragged goal was not sent. A typed goal stays, to be corrected.
    void cancelDrag();
    /// From the dial: as dragging the slider there.
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
    QLabel* m_directionLabel; ///< the directions of + and −

    std::optional<device::GoalKind> m_kind;
    device::PositiveDirection m_positive = device::PositiveDirection::Forward;
    session::ServoRef m_servo = 0;
    std::optional<std::int64_t> m_shown;
    bool m_dialDrag = false;
    std::optional<std::int64_t> m_pendingGoal; ///< being sent
};
} // namespace ui
