// SPDX-License-Identifier: GPL-3.0-or-later
// LeRobot's calibration file beside the servos: which file, whether LeRobot would accept it, and
// both ways to make them agree. A file is read when it is selected and when servos have changed;
// writing to servos is asked about. Owned by the arm page; main thread.
#pragma once

#include "session/arm/arm_calibration.h"
#include "session/settings.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace ui {
class ArmFileCard final : public QWidget {
    Q_OBJECT

public:
    ArmFileCard(session::Workbench& workbench, session::Settings& settings, QWidget* parent);

    void update(); ///< the calibration has changed

Q_SIGNALS:
    void failed(const base::Error& error);
    void saved(const QString& path);

private:
    void build();
    void retranslate();
    void select();
    void load(const QString& path);
    void askToApply();
    void save();
    void saveTo(const QString& path);
    QString stateText() const;
    /// "elbow_flex: offset 87, in the file −1024"; one line per difference.
    QStringList differences() const;
    bool hasEveryJoint() const;

    session::Workbench& m_workbench;
    session::ArmCalibration& m_calibration;
    session::Settings& m_settings;
    QString m_path;
    jobs::LerobotFile m_file;
    QLabel* m_title;
    QLabel* m_state;
    QLabel* m_details;
    QPushButton* m_select;
    QPushButton* m_apply;
    QPushButton* m_save;
};
} // namespace ui
