// SPDX-License-Identifier: GPL-3.0-or-later
// The legs of a sweep test as CSV: a header `servo,leg,cycle,at[ms],…` with the unit behind each
// name, then one line per leg, servo by servo; decimal points in every locale, an empty cell where
// nothing was measured, 0 or 1 for missed and flag_wrong, alarms as the number of the status bits.
// Any thread. Saving fails with FileUnwritable or DiskFull.
#pragma once

#include "results/sweep_run.h"

namespace results {
base::Result<void> saveSweepLegs(const SweepRun& run, const QString& path);
} // namespace results
