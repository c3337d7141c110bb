// SPDX-License-Identifier: GPL-3.0-or-later
// The joints of an arm as a table: position, recorded range and state, and offset and limits as the
// servo holds them, with the new ones beside them once they are known. Owned by its page; main
// thread.
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
        RangeColumn, ///< how far it has been moved, as a bar: jointRangeRole
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

    void update(); ///< the calibration or the language has changed

private:
    QString text(const session::ArmJoint& one, int column) const;
    QString stateText(const session::ArmJoint& one) const;
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

/// Low, high and present position as fractions of the bar; in a QVariantList of doubles, empty
/// where nothing has been recorded.
constexpr int jointRangeRole = Qt::UserRole + 40;
} // namespace ui
