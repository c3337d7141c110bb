// SPDX-License-Identifier: GPL-3.0-or-later
// The list of servos at the end of a scan. Pure functions; used by scan() only.
#pragma once

#include "jobs/scan/scan.h"

namespace jobs {
/// So close that a receiver at one rate takes bytes that were sent at the other.
bool areNeighborRates(int a, int b);

/// A servo that answered at two rates a few percent apart is kept once, at the rate it reports.
void dropNeighborRates(std::vector<FoundServo>& found);

/// By rate as searched, then ID.
void sortFound(std::vector<FoundServo>& found, const std::vector<int>& rates);

/// Families of different byte order on one Feetech line: the vendor advises against it.
bool familiesMixed(const std::vector<FoundServo>& found);
} // namespace jobs
