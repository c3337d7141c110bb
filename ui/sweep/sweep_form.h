// SPDX-License-Identifier: GPL-3.0-or-later
// The fields of a sweep test: its kind, range, pace, length, what the servo is told, when it ends
// early, who tests. Only the fields of the chosen kind are shown. Range and delay are proposed
// until somebody types them. Sends nothing. Owned by its page; main thread.
#pragma once

#include "results/sweep_spec.h"
#include "session/servo_entry.h"
#include "session/settings.h"

#include <QWidget>

#include <array>
#include <optional>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QPushButton;
class QSpinBox;
class QVBoxLayout;

namespace ui {
class FlowLayout;
class SegmentButton;

class SweepForm final : public QWidget {
    Q_OBJECT

public:
    SweepForm(session::Settings& settings, QWidget* parent);

    /// Between what is set for every test and what seldom changes.
    void insertServoList(QWidget* servos);
    /// While a test runs: all but what was inserted.
    void setLocked(bool locked);

    /// The fields its family and mode have. Null: as the last one.
    void showServo(const session::ServoEntry* entry);
    /// Into range and delay (or a sine's period) nobody has typed; nothing for 0.
    void propose(const record::SweepRange& range);
    void propose(base::Duration enough);
    void setPace(base::Duration enough); ///< asked for: typed or not
    /// What was typed into range, delay and period; the rest is proposed.
    struct UserInput {
        std::optional<record::SweepRange> range{};
        std::optional<int> pause{};     ///< ms
        std::optional<double> period{}; ///< s
    };
    UserInput userInput() const;
    /// Another servo: what was typed for it before. What was not is a proposal again.
    void setUserInput(const UserInput& values);

    /// As shown. A list that could not be read is empty; complaint() says why.
    record::SweepSpec spec() const;
    QString inputError() const { return m_listTrouble; }
    void saveSettings(); ///< for the next start of the program

Q_SIGNALS:
    void changed(); ///< typed, chosen, ticked; not by propose()

protected:
    void changeEvent(QEvent* event) override;

private:
    enum Cell : std::uint8_t {
        Start,
        End,
        Step,
        Period,
        Seed,
        List,
        Pace,
        Pause,
        Until,
        Cycles,
        Minutes,
        Speed,
        Acceleration,
        Time,
        WarmUp,
        Afterwards,
        Operator,
        Note,
        CellCount
    };
    struct FieldCell {
        QLabel* title = nullptr;
        QWidget* field = nullptr;
        bool wide = false; ///< both columns
    };
    void build();
    void buildShapes();
    void buildFields();
    void loadSettings(session::Settings& settings);
    void add(Cell cell, QWidget* field, const char* name, bool wide = false);
    QLineEdit* line(Cell cell, const char* name, bool wide = false);
    void arrange();
    void arrange(QGridLayout& grid, Cell first, Cell last);
    bool isShown(Cell cell) const;
    void selectShape(record::SweepShape shape);
    void openList();
    void readList(const QString& path);
    void retranslate();
    void onEdited();

    session::Settings& m_settings;
    record::SweepShape m_shape = record::SweepShape::Sweep;
    std::array<SegmentButton*, 6> m_shapes{};
    std::array<FieldCell, CellCount> m_cells{};
    QGridLayout* m_grid = nullptr;
    QGridLayout* m_extraGrid = nullptr; ///< below the servos
    QVBoxLayout* m_middle = nullptr;
    QWidget* m_inserted = nullptr;
    QLineEdit* m_start = nullptr;
    QLineEdit* m_end = nullptr;
    QLineEdit* m_step = nullptr;
    QDoubleSpinBox* m_period = nullptr;
    QSpinBox* m_seed = nullptr;
    QPushButton* m_list = nullptr;
    QComboBox* m_pace = nullptr;
    QSpinBox* m_pause = nullptr;
    QComboBox* m_until = nullptr;
    QSpinBox* m_cycles = nullptr;
    QDoubleSpinBox* m_minutes = nullptr;
    QLineEdit* m_speed = nullptr;
    QLineEdit* m_acceleration = nullptr;
    QLineEdit* m_time = nullptr;
    QSpinBox* m_warmUp = nullptr;
    QComboBox* m_afterwards = nullptr;
    QLineEdit* m_operator = nullptr;
    QLineEdit* m_note = nullptr;
    QLabel* m_earlyTitle = nullptr;
    QCheckBox* m_onAlarm = nullptr;
    QCheckBox* m_onStall = nullptr;
    QCheckBox* m_onFailure = nullptr;

    std::array<bool, 3> m_moves{true, true, false}; ///< speed, acceleration, time
    bool m_rangeEdited = false;
    bool m_pauseEdited = false;
    bool m_periodEdited = false;
    std::vector<record::SweepPoint> m_points;
    QString m_listPath;
    QString m_listTrouble;
};
} // namespace ui
