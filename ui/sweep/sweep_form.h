// SPDX-License-Identifier: GPL-3.0-or-later
// The fields of a sweep test: its kind, range, pace, length, settings of the movement, early end,
// operator. Only the fields of the selected kind are shown. Range and delay are proposed until the
// user types them. Sends nothing. Owned by its page; main thread.
#pragma once

#include "results/sweep_spec.h"
#include "session/servos/servo_entry.h"
#include "session/settings.h"

#include <QWidget>

#include <array>
#include <optional>

class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QLineEdit;
class QSpinBox;
class QVBoxLayout;

namespace ui {
class SegmentedControl;
class SweepEndConditions;
class SweepGoalList;

class SweepForm final : public QWidget {
    Q_OBJECT

public:
    SweepForm(session::Settings& settings, QWidget* parent);

    /// Between the fields that are set for every test and those that seldom change.
    void insertServoList(QWidget* servos);
    /// While a test runs: all fields, but not the inserted list.
    void setLocked(bool locked);

    /// The fields its family and mode have. Null: as the last one.
    void showServo(const session::ServoEntry* entry);
    /// Fills in range and delay (or the period of a sine) unless the user has typed them; does
    /// nothing for 0.
    void propose(const results::SweepRange& range);
    void propose(base::Duration enough);
    void setPace(base::Duration enough); ///< at the user's request: replaces a typed one too
    /// What the user has typed into range, delay and period; the rest is proposed.
    struct UserInput {
        std::optional<results::SweepRange> range{};
        std::optional<int> pause{};     ///< ms
        std::optional<double> period{}; ///< s
    };
    UserInput userInput() const;
    /// For another servo: what was typed for it before. The other fields are proposed again.
    void setUserInput(const UserInput& values);

    /// As shown. A list that could not be read is empty; inputError() says why.
    results::SweepSpec spec() const;
    QString inputError() const;
    void saveSettings(); ///< for the next start of the program

Q_SIGNALS:
    void changed(); ///< typed, chosen, ticked; not by propose()

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
    void buildFields();
    void loadSettings(session::Settings& settings);
    void add(Cell cell, QWidget* field, const char* name, bool wide = false);
    QLineEdit* line(Cell cell, const char* name, bool wide = false);
    void arrange();
    void arrange(QGridLayout& grid, Cell first, Cell last);
    bool isShown(Cell cell) const;
    void selectShape(results::SweepShape shape);
    void retranslate();

    session::Settings& m_settings;
    results::SweepShape m_shape = results::SweepShape::Sweep;
    SegmentedControl* m_shapes = nullptr;
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
    SweepGoalList* m_list = nullptr;
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
    SweepEndConditions* m_endConditions = nullptr;

    std::array<bool, 3> m_moves{true, true, false}; ///< speed, acceleration, time
    bool m_rangeEdited = false;
    bool m_pauseEdited = false;
    bool m_periodEdited = false;
};
} // namespace ui
