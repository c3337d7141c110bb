// SPDX-License-Identifier: GPL-3.0-or-later
// The legs of a sweep test as CSV: a header `servo,leg,cycle,at[ms],…` with the unit behind each
// name, then a line a leg, in the order they ended or servo after servo; decimal points whatever
// the locale, an empty cell where nothing was measured, 0 or 1 for missed and flag_wrong, alarms as
// the number of the status bits. Header and line each end with a line feed. Pure; any thread.
// Saving fails with FileUnwritable or DiskFull.
#pragma once

#include "results/sweep_run.h"

namespace record {
QByteArray sweepLegsHeader();
QByteArray sweepLegsLine(int servo, const SweepLeg& leg);
QByteArray encodeSweepLegs(const SweepRun& run);
base::Result<void> saveSweepLegs(const SweepRun& run, const QString& path);
} // namespace record
