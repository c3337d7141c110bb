// SPDX-License-Identifier: GPL-3.0-or-later
// The fields of a step-response run: size, start, repeats, wait, speed, acceleration. Empty start,
// wait, speed and acceleration are chosen automatically. Sends nothing. Owned by its
// page; main thread.
#pragma once

#include "results/step_run.h"
#include "session/servos/servo_entry.h"
#include "session/settings.h"

#include <QWidget>

class QLabel;
class QLineEdit;
class QSpinBox;

namespace ui {
class StepForm final : public QWidget {
    Q_OBJECT

public:
    StepForm(session::Settings& settings, QWidget* parent);

    /// Proposes a size for this servo until the user types one; hides fields that it lacks.
    void showServo(const session::ServoEntry* entry);
    results::StepSpec spec() const; ///< without a trial
    void saveSettings();            ///< for the next start of the program

Q_SIGNALS:
    void changed();

private:
    QLineEdit* line(const char* name);
    void retranslate();

    session::Settings& m_settings;
    QLabel* m_sizeLabel;
    QLineEdit* m_size;
    QLabel* m_fromLabel;
    QLineEdit* m_from;
    QLabel* m_repeatsLabel;
    QSpinBox* m_repeats;
    QLabel* m_holdLabel;
    QSpinBox* m_hold;
    QLabel* m_speedLabel;
    QLineEdit* m_speed;
    QLabel* m_accelerationLabel;
    QLineEdit* m_acceleration;
    bool m_sizeEdited = false;
};
} // namespace ui
