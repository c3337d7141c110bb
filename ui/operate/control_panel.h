// SPDX-License-Identifier: GPL-3.0-or-later
// The left card of the operate page: torque, mode, goal and the other values of a move of the
// selected servos. Selecting a servo or opening the page sends nothing that moves. GoalSender sends
// the goals; everything goes through session::MotionController. Owned by the page; main thread,
// never waits.
#pragma once

#include "session/motion/motion_controller.h"
#include "session/settings.h"
#include "ui/common/commands.h"

#include <QTimer>
#include <QWidget>

#include <memory>

class QScrollArea;
class QVBoxLayout;

namespace ui {
class ControlFields;
class ControlGoal;
class ControlHeader;
class ControlLimit;
class ControlMessages;
class ControlSend;
class GoalSender;
class MoveResult;
class ServoObstacle;
class TorqueConfirmation;

class ControlPanel final : public QWidget {
    Q_OBJECT

public:
    ControlPanel(session::Workbench& workbench, Commands& commands, Selection& selection,
                 session::Settings& settings, session::MotionController& motion,
                 QWidget* parent = nullptr);
    ~ControlPanel() override;

    /// Between the mode and the slider; the panel becomes its parent. Shown in every mode that has
    /// a goal: the position of the shaft matters while it turns, too.
    void setDial(QWidget* dial);
    /// Messages, and the question before the first torque. They are below the controls until the
    /// page places them elsewhere; whatever appears in them must not move a control.
    QWidget* messages() const;
    /// The goal in the servo, or the one that is being dragged; nullopt: none that is a position.
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
    void showEvent(QShowEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void build(session::Settings& settings);
    void buildContent(session::Settings& settings);
    void connectControls();
    void connectWorkbench();
    void connectMotion();
    void retranslate();

    const session::ServoEntry* entry() const;
    std::size_t otherCount() const;
    bool isPortOpen() const;
    void onSelectionChanged();
    void readUnreadTables();
    void refresh();
    void showControls(const session::ServoEntry& known);
    void scheduleRefresh();
    void fitDial();
    void requestTorque(device::Torque torque);
    void stopMove();
    void confirmModeSwitch(const device::ModePlan& plan);
    void onEvent(const session::Event& event);
    void showError(const base::Error& error);
    void showNotices(const device::Notices& notices);

    session::Workbench& m_workbench;
    Commands& m_commands;
    Selection& m_selection;
    session::MotionController& m_motion;

    ControlHeader* m_header = nullptr;
    ControlMessages* m_messages = nullptr;
    ServoObstacle* m_empty = nullptr;
    QScrollArea* m_scroll = nullptr;
    QWidget* m_content = nullptr;
    QVBoxLayout* m_dialLayout = nullptr;
    QWidget* m_dial = nullptr;
    ControlGoal* m_goal = nullptr;
    ControlFields* m_fields = nullptr;
    ControlSend* m_send = nullptr;
    ControlLimit* m_limit = nullptr;
    MoveResult* m_result = nullptr;
    std::unique_ptr<TorqueConfirmation> m_torqueConfirmation;
    GoalSender* m_sender = nullptr;
    QTimer m_refresh;
};
} // namespace ui
