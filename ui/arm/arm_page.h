// SPDX-License-Identifier: GPL-3.0-or-later
// The arm page: the joints of a robot arm with what their servos hold, their calibration by moving
// them by hand, their move test, and LeRobot's needs beside it. Opening it writes nothing; torque
// off, writing and moving are asked about. Owned by the window; main thread.
#pragma once

#include "session/arm/arm_calibration.h"
#include "ui/common/app_context.h"

#include <QPointer>
#include <QTimer>
#include <QWidget>

class QCheckBox;
class QLabel;
class QPushButton;
class QTableView;

namespace session {
class Settings;
}

namespace ui {
class ArmChoice;
class ArmModel;
class Banner;
class LerobotCard;

class ArmPage final : public QWidget {
    Q_OBJECT

public:
    ArmPage(AppContext& context, session::Settings& settings, QWidget* parent = nullptr);

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    QWidget* buildJoints();
    void connectAll();
    void runAction();
    void askToRecord();
    void askToWrite();
    void askToTest();
    void showResults(const std::vector<jobs::ApplyResult>& results);
    void showTestResults(bool isComplete);
    session::JointRows selectedRows() const;
    QString selectedNames() const; ///< "Only the selected joints: …"; empty: all
    void updateSoon();
    void update();
    void updateButtons();
    void updateSubscription();
    void retranslate();
    QString instruction() const;
    QStringList missingJoints() const;
    QStringList uncalibratedNames() const;

    session::Workbench& m_workbench;
    QPointer<session::Workbench> m_workbenchGuard; ///< a window may hide its pages on its way out
    session::ArmCalibration& m_calibration;
    std::vector<session::ServoRef> m_polled;
    session::ArmCalibration::Step m_shownStep = session::ArmCalibration::Step::Idle;
    QTimer m_updateTimer;  ///< readings arrive faster than they can be looked at
    QTimer m_refreshTimer; ///< what is not read any more gets old
    ArmModel* m_model;
    Banner* m_banner;
    QLabel* m_title;
    ArmChoice* m_arm;
    QCheckBox* m_isMiddleShown;
    QPushButton* m_test;
    QPushButton* m_cancel;
    QPushButton* m_action;
    QLabel* m_instruction;
    QTableView* m_table;
    LerobotCard* m_lerobot;
};
} // namespace ui
