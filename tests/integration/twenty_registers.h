// SPDX-License-Identifier: GPL-3.0-or-later
// Twenty registers of an STS3215, several in frames of their own, with other values than it leaves
// the factory with. For the tests that end a restore in its middle.
#pragma once

#include "integration/restore_support.h"
#include "jobs/restore/take_snapshot.h"

namespace support {
inline const TableValues& twentyRegisters()
{
    static const TableValues rows{
        {QStringLiteral("min_angle_limit"), 200},
        {QStringLiteral("max_angle_limit"), 3900},
        {QStringLiteral("max_temperature"), 65},
        {QStringLiteral("min_voltage"), 45},
        {QStringLiteral("max_torque"), 900},
        {QStringLiteral("unload_condition"), 36},
        {QStringLiteral("led_alarm_condition"), 37},
        {QStringLiteral("position_p"), 40},
        {QStringLiteral("position_d"), 41},
        {QStringLiteral("position_i"), 3},
        {QStringLiteral("min_startup_force"), 16},
        {QStringLiteral("cw_dead_zone"), 2},
        {QStringLiteral("ccw_dead_zone"), 3},
        {QStringLiteral("protection_current"), 400},
        {QStringLiteral("position_offset"), 77},
        {QStringLiteral("protection_torque"), 25},
        {QStringLiteral("protection_time"), 150},
        {QStringLiteral("overload_torque"), 70},
        {QStringLiteral("speed_p"), 20},
        {QStringLiteral("overcurrent_time"), 100},
    };
    return rows;
}

/// Of a servo that has them.
inline snapshot::Snapshot twentyRegisterSnapshot()
{
    SimFixture fixture(QStringLiteral("sts3215@1"));
    pokeAllPersistent(fixture, twentyRegisters());
    snapshot::Snapshot snapshot =
        jobs::snapshotOf(identifyWithTable(fixture), QStringLiteral("test 1"));
    snapshot.at = QDateTime({2026, 1, 2}, {3, 4, 5}, Qt::UTC);
    return snapshot;
}
} // namespace support
