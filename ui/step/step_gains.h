// SPDX-License-Identifier: GPL-3.0-or-later
// The registers of a servo's control loop: present values and values to try, side by side. Values
// stay inside the register's range. Sends nothing. Owned by its page; main thread.
#pragma once

#include "results/step_run.h"
#include "session/servos/servo_entry.h"

#include <QWidget>

class QGridLayout;
class QLabel;
class QSpinBox;

namespace ui {
class StepGains final : public QWidget {
    Q_OBJECT

public:
    explicit StepGains(QWidget* parent);

    /// For another servo the values to try are the present ones; for the same servo they stay,
    /// unless the present value has changed.
    void showServo(const session::ServoEntry* entry);

    /// The values that differ from the present ones.
    std::vector<results::StepGain> trial() const;
    void setTrial(const QString& key, std::int64_t raw); ///< into what is tried
    void reset();                                        ///< what is tried becomes what is now

Q_SIGNALS:
    void changed();

private:
    struct Row {
        const catalog::Register* reg = nullptr;
        QLabel* name = nullptr;
        QLabel* now = nullptr;
        QSpinBox* trial = nullptr;
        std::optional<std::int64_t> raw{};
    };
    void build(const session::ServoEntry& entry);
    void clear();
    void markChanged(Row& row);
    void retranslate();

    session::ServoRef m_servo = 0;
    catalog::ProfilePtr m_profile; ///< the registers are its
    QGridLayout* m_grid;
    QLabel* m_nowTitle;
    QLabel* m_trialTitle;
    QLabel* m_none;
    std::vector<Row> m_rows;
};
} // namespace ui
