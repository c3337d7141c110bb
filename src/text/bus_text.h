// SPDX-License-Identifier: GPL-3.0-or-later
// What there is on a bus, in a few words: the protocol of its servos, and what a simulated one
// holds, for the window and the command line. Any thread.
#pragma once

#include "base/protocol.h"

#include <QString>

namespace text {
QString protocolText(base::Protocol protocol);

/// For "sim:demo" and the others of session::simulatedPorts(); empty for any other port.
QString simulatedBusText(const QString& port);
} // namespace text
