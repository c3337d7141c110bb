// SPDX-License-Identifier: GPL-3.0-or-later
// The joints of an arm as a table: position, range (as it is recorded, else the limits) and state,
// and offset and limits as the servo holds them, with the new ones beside them once they are known.
// Owned by its page; main thread.
#pragma once

#include "session/arm/arm_calibration.h"

#include <QAbstractTableModel>

namespace ui {
class ArmModel final : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column {
        IdColumn,
        JointColumn,
        PositionColumn,
        RangeColumn, ///< as a bar: jointBarRole
        DegreesColumn,
        StateColumn,
        OffsetColumn,
        MinColumn,
        MaxColumn,
        columns
    };

    ArmModel(session::Workbench& workbench, QObject* parent);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

    void update();      ///< after a change of joints or readings; rows change only here
    void retranslate(); ///< the headings

private:
    QString text(const session::ArmJoint& one, int column) const;
    QString stateText(const session::ArmJoint& one) const;
    QVariant barOf(const session::ArmJoint& one) const;
    bool isRecording(const session::ArmJoint& one) const; ///< has readings, and gets more
    std::optional<std::int64_t> positionOf(const session::ArmJoint& one) const;
    bool isSilent(const session::ArmJoint& one) const;
    QString travelText(const session::ArmJoint& one) const;
    QVariant toneOf(const session::ArmJoint& one) const;
    static QVariant toneOfTest(base::MoveTestState state);

    session::Workbench& m_workbench;
    session::ArmCalibration& m_calibration;
    int m_rows = 0;
};

/// What is written beside offset and limits: "elbow: Operating mode speed → position"; one line per
/// joint that changes.
QStringList positionChanges(const session::ArmCalibration& calibration, bool isPlannedOnly);
/// Likewise, for LeRobot.
QStringList lerobotChanges(const session::ArmCalibration& calibration);

/// Fractions of a turn.
struct JointBar {
    double low = 0;
    double high = 0;
    std::optional<double> now{}; ///< none: not read
    bool isRecorded = false;     ///< else the limits
};
constexpr int jointBarRole = Qt::UserRole + 40; ///< a JointBar; invalid: nothing is known
} // namespace ui

Q_DECLARE_METATYPE(ui::JointBar)
