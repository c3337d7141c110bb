// SPDX-License-Identifier: GPL-3.0-or-later
// The torque limit in percent (register 48; SCS: 16 until power-off), with kg·cm once the stall
// torque of this model has been entered, and advice for gripping. It is sent when the slider is
// released, or on Enter. Owned by the control panel; main thread.
#pragma once

#include "session/servos/servo_entry.h"
#include "session/settings.h"

#include <QWidget>

class QDoubleSpinBox;
class QLabel;
class QToolButton;

namespace ui {
class ControlSlider;

class ControlLimit final : public QWidget {
    Q_OBJECT

public:
    ControlLimit(session::Settings& settings, QWidget* parent);

    void showServo(const session::ServoEntry* entry, bool usable);
    /// What the details add while they are shown.
    int detailsHeight() const;
    /// What was typed or dragged and not sent is dropped.
    void discardEdit();
    void retranslate();

Q_SIGNALS:
    void limitRequested(std::int64_t raw);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void build();
    void showDetails(bool shown);
    void fill();
    void showForce();
    void edited();
    void request(std::int64_t raw);
    void send(std::int64_t raw);
    double stallTorque() const; ///< kg·cm; 0: not entered

    session::Settings& m_settings;
    QLabel* m_title;
    QToolButton* m_more;
    QWidget* m_details; ///< slider, stall torque and advice
    QDoubleSpinBox* m_percent;
    ControlSlider* m_slider;
    QLabel* m_force;
    QLabel* m_stallTitle;
    QDoubleSpinBox* m_stall;
    QLabel* m_advice;

    QString m_model;
    bool m_temporary = false;
    std::optional<std::int64_t> m_read;
    bool m_editing = false; ///< a number is being typed, stepped or dragged, and not sent
    session::ServoRef m_servo = 0;
    bool m_pending = false;             ///< the servo has not answered yet
    std::optional<std::int64_t> m_sent; ///< shown until it has
    std::optional<std::int64_t> m_next; ///< wanted meanwhile: the latest one goes out
};
} // namespace ui
