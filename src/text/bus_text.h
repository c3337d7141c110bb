// SPDX-License-Identifier: GPL-3.0-or-later
// What there is on a bus, in a few words: the protocol of its servos, and what a simulated one
// holds, for the window and the command line. Any thread.
#pragma once

#include "base/protocol.h"

#include <QString>

#include <vector>

namespace text {
QString protocolText(base::Protocol protocol);

/// "1–6, 9", of sorted IDs.
QString idRangesText(const std::vector<int>& ids);

/// For "sim:demo" and the others of session::simulatedPorts(); empty for any other port.
QString simulatedBusText(const QString& port);
} // namespace text
