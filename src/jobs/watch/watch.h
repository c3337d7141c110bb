// SPDX-License-Identifier: GPL-3.0-or-later
// Regular reading of several servos through the bus' poll plan, decoded into registers. Writes
// nothing. The caller gets rows in time order; sampling does not wait for it. Where every register
// costs a read of its own (LX), temperature and voltage are read about once a second beside faster
// ones. Servos that report no faults are judged by their limits: DerivedTemperature and
// DerivedVoltage are noted once each.
// Errors: BadArgument (no servo, servo not identified), UnknownRegister (a key no servo has, a
// servo without any of the keys), NotSupported (it has them, but measures none), LinkLost, and
// the error that onRow returns.
#pragma once

#include "device/servo.h"
#include "jobs/job.h"

namespace jobs {
struct WatchSpec {
    std::vector<device::Servo> servos; ///< settings read, so that units are right
    QStringList keys;                  ///< empty: the feedback block
    base::Duration period{};           ///< 0: as fast as the wire allows
    base::Duration length{};           ///< 0: until stop
};

/// Where servos give one register in different units (degrees here, steps there) each unit has a
/// column of its own, side by side; a servo fills the one in its unit. No column mixes units.
struct WatchColumn {
    QString key;
    QString unit;
    bool operator==(const WatchColumn&) const = default;
};

/// One reading of one servo. `values` follows the columns; nullopt: this servo has no such register
/// in this unit or the block was not read in this round. Registers that lie too far apart for one
/// block are read in several and joined in one row.
struct WatchRow {
    base::Duration at{}; ///< bus clock, when the last block of the row had arrived
    base::Protocol protocol = base::Protocol::Feetech;
    int id = 0;
    std::uint8_t status = 0;                   ///< as device::Servo::status
    bool answered = false;                     ///< at least one block was read
    std::vector<std::optional<double>> values; ///< physical
};

struct WatchReport {
    std::vector<WatchColumn> columns;
    std::uint64_t rows = 0;   ///< answered
    std::uint64_t missed = 0; ///< block reads without a good answer
    base::Duration elapsed{};
    bool stopped = false;
};

/// In the order of the keys; for the feedback block by address.
std::vector<WatchColumn> watchColumns(const WatchSpec& spec);

/// `onRow` sees unanswered rows too; it returns an error to end the watch (disk full).
base::Result<WatchReport> watch(const device::Context& context, const WatchSpec& spec,
                                const std::function<base::Result<void>(const WatchRow&)>& onRow);
} // namespace jobs
