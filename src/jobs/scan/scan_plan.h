// SPDX-License-Identifier: GPL-3.0-or-later
// What a scan is going to do: at which rates, in which languages, for how long. Pure functions;
// used by scan() only.
#pragma once

#include "jobs/scan/scan.h"

namespace jobs {
/// BadArgument when there is nothing to ask, or no such rate or ID.
base::Result<void> checkSpec(const device::Context& context, const ScanSpec& spec);

std::vector<int> ratesToScan(const ScanSpec& spec, int currentBaud);
std::vector<base::Protocol> protocolsToScan(const device::Context& context, const ScanSpec& spec,
                                            int baud);

/// Of everything at one rate.
base::Duration estimateRate(const device::Context& context, const ScanSpec& spec, int baud);
} // namespace jobs
