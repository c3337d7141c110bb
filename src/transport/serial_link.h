// SPDX-License-Identifier: GPL-3.0-or-later
// A serial port through QSerialPort, opened for one user only: canonical name, lease inside the
// process, TIOCEXCL and flock outside it. See openPort() for the errors.
#pragma once

#include "transport/link.h"

namespace transport {
base::Result<std::unique_ptr<Link>> openSerial(const PortSpec& spec);

/// Why the system refused a device file: in use (`accessible`, the detail names the program) or not
/// allowed (the detail names the group that is).
base::Error accessDeniedError(const QString& path, bool accessible);
} // namespace transport
