// SPDX-License-Identifier: GPL-3.0-or-later
// The left card of the operate page: torque, mode, goal and what belongs to a move of the chosen
// servos. Dragging a slider or the dial sends goals as it goes, the latest one wins; what is typed
// is sent by Enter or Set. Selecting a servo or opening the page reads and writes nothing that
// moves. Everything goes through session::Drive. Owned by the page; main thread, never waits.
#pragma once

#include "session/motion/motion_controller.h"
#include "session/settings.h"
#include "ui/common/commands.h"

#include <QTimer>
#include <QWidget>

class QButtonGroup;
class QLabel;
class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace ui {
class Banner;
class ControlFields;
class ControlGoal;
class TorqueHint;
class ControlLimit;
class ControlMode;
class ControlTorque;

class ControlPanel final : public QWidget {
    Q_OBJECT

public:
    ControlPanel(session::Desk& desk, Commands& commands, Selection& selection,
                 session::Settings& settings, session::MotionController& drive,
                 QWidget* parent = nullptr);
    ~ControlPanel() override;

    /// Between the mode and the slider; the panel becomes its parent. Shown in every mode that has
    /// a goal: where the shaft stands matters while it turns, too.
    void setDial(QWidget* dial);
    /// What it has to say, and the question before the first torque. Stands below the controls
    /// until the page gives it a place; whatever appears in it must not move a control.
    QWidget* messages() const { return m_messages; }
    /// The goal as the servo has it, or as it is being dragged; nullopt: none that means a place.
    std::optional<std::int64_t> positionGoal() const;
    /// The dial's goal may be dragged now.
    bool isGoalMovable() const;

public Q_SLOTS:
    /// As dragging the slider there; a short rest ends the drag.
    void setGoalFromDial(std::int64_t raw);

Q_SIGNALS:
    void goalShown(std::int64_t raw);
    void goalStateChanged(); ///< positionGoal() or isGoalMovable() may have changed

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void build(session::Settings& settings);
    QScrollArea* buildScroll();
    void buildMessages(session::Settings& settings);
    QWidget* buildHeader(QWidget* body);
    QWidget* buildWrite(QWidget* body);
    void connectParts();
    void connectDesk();
    void retranslate();

    const session::ServoEntry* entry() const;
    std::size_t otherCount() const;
    void onSelectionChanged();
    void readUnreadTables();
    void refresh();
    void scheduleRefresh();
    void showTitle();
    void showWrite();
    void selectWriteMode(const session::ServoEntry& known);
    void showStopped();
    QString emptyReason() const;
    bool isUsable() const;

    using HintTargets =
        std::vector<std::pair<session::ServoRef, QString>>; ///< servos and mode keys
    HintTargets currentTargets() const;
    bool isUnchanged(const HintTargets& targets) const;
    bool confirmHint(std::function<void()> action);
    bool confirmEnergize(std::function<void()> action);
    void dragTo(std::int64_t raw, bool dragged);
    void sendGoalFromField();
    void sendGoal(std::int64_t raw, bool dragged);
    void step(std::int64_t raw);
    void onGoalSent(const session::MoveRequest& request);
    void requestTorque(device::Torque torque);
    void stopMove();
    void confirmModeSwitch(const device::ModePlan& plan);
    void showError(const base::Error& error);
    void showNotices(const device::Notices& notices);
    void showResult();
    void reserveResultHeight();
    void clearResult();
    void showInputError(const std::function<QString()>& wrong);
    device::MoveMethod writeMode() const;

    session::Desk& m_desk;
    Commands& m_commands;
    Selection& m_selection;
    session::MotionController& m_motion;

    QLabel* m_title = nullptr;
    ControlTorque* m_torque = nullptr;
    QLabel* m_stopped = nullptr;
    QWidget* m_messages = nullptr;
    Banner* m_banner = nullptr;
    TorqueHint* m_hint = nullptr;
    QLabel* m_empty = nullptr;
    QWidget* m_content = nullptr;
    ControlMode* m_mode = nullptr;
    QVBoxLayout* m_dialLayout = nullptr;
    QWidget* m_dial = nullptr;
    ControlGoal* m_goal = nullptr;
    ControlFields* m_fields = nullptr;
    QWidget* m_write = nullptr;
    QButtonGroup* m_writeMode = nullptr;
    QPushButton* m_execute = nullptr;
    QPushButton* m_set = nullptr;
    ControlLimit* m_limit = nullptr;
    QLabel* m_resultLabel = nullptr;

    std::optional<HintTargets> m_hintTargets; ///< what the hint's action was asked for
    device::Notices m_notices;                ///< how the latest action was done
    catalog::ProfilePtr m_resultProfile;
    bool m_isDragging = false;
    bool m_selectionChanged = false; ///< the way of writing is not settled yet for these servos
    QTimer m_refresh;
    QTimer m_dialDragTimer;
};
} // namespace ui
