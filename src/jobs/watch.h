// SPDX-License-Identifier: GPL-3.0-or-later
// Regular reading of several servos through the bus' poll plan, decoded into registers. Writes
// nothing. The caller drains rows at its leisure; sampling does not wait for it.
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

struct WatchColumn {
    QString key;
    QString unit;
};

/// One reading of one servo. `values` follows the columns; nullopt: this servo has no such register
/// or the block was not read in this round.
struct WatchRow {
    base::Duration at{};
    int id = 0;
    std::uint8_t status = 0;
    bool answered = false;
    std::vector<std::optional<double>> values; ///< physical
};

struct WatchReport {
    std::vector<WatchColumn> columns;
    std::uint64_t rows = 0;
    std::uint64_t missed = 0;
    base::Duration elapsed{};
    bool stopped = false;
};

std::vector<WatchColumn> watchColumns(const WatchSpec& spec);

/// `onRow` returns an error to end the watch (disk full).
base::Result<WatchReport> watch(const device::Context& context, const WatchSpec& spec,
                                const std::function<base::Result<void>(const WatchRow&)>& onRow);
} // namespace jobs
