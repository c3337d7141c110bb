// SPDX-License-Identifier: GPL-3.0-or-later
// What LeRobot needs of the arm: what it would refuse or change, and its calibration file beside
// the servos, with both ways to make them agree. A file is read when it is selected; writing to
// servos is asked about. Owned by the arm page; main thread.
#pragma once

#include "session/arm/arm_calibration.h"
#include "session/settings.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace ui {
class LerobotCard final : public QWidget {
    Q_OBJECT

public:
    LerobotCard(session::Workbench& workbench, session::Settings& settings, QWidget* parent);

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
    void askToPrepare();
    void save();
    void saveTo(const QString& path);
    QString stateText() const;
    QString remarksText() const;
    /// "elbow_flex: offset is −1024 in the file, 87 in the servo"; one line per difference.
    QStringList differences() const;
    bool hasEveryJoint() const;

    session::ArmCalibration& m_calibration;
    session::Settings& m_settings;
    QString m_path;
    jobs::LerobotFile m_file;
    QLabel* m_title;
    QWidget* m_texts = nullptr; ///< scrolls the next three
    QLabel* m_remarks;
    QLabel* m_state;
    QLabel* m_details;
    QPushButton* m_prepare;
    QPushButton* m_select;
    QPushButton* m_apply;
    QPushButton* m_save;
};
} // namespace ui
