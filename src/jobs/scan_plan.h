// SPDX-License-Identifier: GPL-3.0-or-later
// What a scan is going to do: at which rates, in which languages, for how long. Pure functions;
// used by scan() only.
#pragma once

#include "jobs/scan.h"

namespace jobs {
/// BadArgument when there is nothing to ask, or no such rate or ID.
base::Result<void> checkSpec(const device::Context& context, const ScanSpec& spec);

std::vector<int> ratesToSearch(const ScanSpec& spec, int presentBaud);
std::vector<base::Protocol> languagesAt(const device::Context& context, const ScanSpec& spec,
                                        int baud);

/// Of everything at one rate.
base::Duration estimateAt(const device::Context& context, const ScanSpec& spec, int baud);
} // namespace jobs
