// SPDX-License-Identifier: GPL-3.0-or-later
// The plan of a scan: its rates, protocols and duration. Pure functions;
// used by scan() only.
#pragma once

#include "jobs/scan/scan.h"

namespace jobs {
/// BadArgument when there is nothing to ask, or no such rate or ID.
base::Result<void> checkSpec(const device::Context& context, const ScanSpec& spec);

std::vector<int> ratesToScan(const ScanSpec& spec, int currentBaud);
std::vector<base::Protocol> protocolsToScan(const device::Context& context, const ScanSpec& spec,
                                            int baud);

/// Where an LX servo is looked for once nothing else was found: at all rates that are not its own.
std::vector<int> ratesForLxAtTheEnd(const device::Context& context, const ScanSpec& spec);

/// The duration of everything at one rate.
base::Duration estimateRate(const device::Context& context, const ScanSpec& spec, int baud);
} // namespace jobs
