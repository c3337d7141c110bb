// SPDX-License-Identifier: GPL-3.0-or-later
// Whether this computer runs on a battery that is low, before work that must not be cut off. From
// what the Linux kernel says of its power supplies; elsewhere nothing is known. Any thread.
#pragma once

#include <QString>

#include <optional>

namespace session {
/// Its percentage; none: it is being charged, has at least a fifth left, or there is none.
std::optional<int>
lowBatteryPercent(const QString& folder = QStringLiteral("/sys/class/power_supply"));
} // namespace session
