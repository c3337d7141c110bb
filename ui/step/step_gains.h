// SPDX-License-Identifier: GPL-3.0-or-later
// The registers of a servo's loop: what they are now and what is to be tried, side by side. Values
// stay inside the register's range. Sends nothing. Owned by its page; main thread.
#pragma once

#include "results/step_run.h"
#include "session/servo_entry.h"

#include <QWidget>

class QGridLayout;
class QLabel;
class QSpinBox;

namespace ui {
class StepGains final : public QWidget {
    Q_OBJECT

public:
    explicit StepGains(QWidget* parent);

    /// Another servo starts with nothing to try; for the same one what is tried stays, unless the
    /// value now has become another.
    void showServo(const session::ServoEntry* entry);

    /// What differs from now.
    std::vector<record::StepGain> trial() const;
    bool hasRegisters() const { return !m_rows.empty(); } ///< it has such registers
    void setTrial(const QString& key, std::int64_t raw);  ///< into what is tried
    void reset();                                         ///< what is tried becomes what is now

Q_SIGNALS:
    void changed();

protected:
    void changeEvent(QEvent* event) override;

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
