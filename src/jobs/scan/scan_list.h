// SPDX-License-Identifier: GPL-3.0-or-later
// What a scan does with its list of servos once all are in. Pure functions; used by scan() only.
#pragma once

#include "jobs/scan/scan.h"

namespace jobs {
/// One servo heard at two rates a few per cent apart is kept once, at the rate it names itself.
void dropNeighborRates(std::vector<FoundServo>& found);

/// By rate as searched, then ID.
void sortFound(std::vector<FoundServo>& found, const std::vector<int>& rates);

/// Families of different byte order on one Feetech line: the vendor advises against it.
bool familiesMixed(const std::vector<FoundServo>& found);
} // namespace jobs
