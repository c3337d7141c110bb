// SPDX-License-Identifier: GPL-3.0-or-later
// Opens a link by its port name. Called on the thread that will own the link. Openers for device
// paths and tcp:// live here; the session adds the one for sim:.
#pragma once

#include "transport/link.h"

namespace transport {
/// Serial device path or tcp://host:port. Errors: PortMissing, PortBusy, PortPermission,
/// PortFailed, RateUnsupported.
base::Result<std::unique_ptr<Link>> openPort(const PortSpec& spec, base::Clock& clock);

/// The rates of the facts, highest first: 1000000 … 4800, with 256000, 250000, 128000, 76800,
/// 14400.
const std::vector<int>& standardBaudRates();
} // namespace transport
