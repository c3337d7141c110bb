// SPDX-License-Identifier: GPL-3.0-or-later
// A raw serial bridge on the network, such as ser2net's: bytes in, bytes out, rate set over there.
#pragma once

#include "transport/link.h"

namespace transport {
/// "tcp://host:port". BadArgument for anything else; PortMissing for an unknown host; PortFailed
/// with the system's message when no server accepts within three seconds.
base::Result<std::unique_ptr<Link>> openTcp(const PortSpec& spec);
} // namespace transport
