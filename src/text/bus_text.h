// SPDX-License-Identifier: GPL-3.0-or-later
// What there is on each simulated bus, in a few words, for the window's list of ports and the
// command line's. Any thread.
#pragma once

#include <QString>

namespace text {
/// For "sim:demo" and the others of session::simulatedPorts(); empty for any other port.
QString simulatedBusText(const QString& port);
} // namespace text
