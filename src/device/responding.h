// SPDX-License-Identifier: GPL-3.0-or-later
// Finds out quickly which of several servos answer, so that a silent one does not delay the
// requests to the others. The job's thread.
#pragma once

#include "device/context.h"

#include <vector>

namespace device {
/// Sends each ID one PING in each of these protocols, with the short timeout of a search, then
/// waits for late replies no longer than Bus::maxReplyLateness(). In the order given. A servo that
/// is not among them may still answer a repeated request. Ends early on stop.
std::vector<int> findResponding(const Context& context, const std::vector<int>& ids,
                                const std::vector<base::Protocol>& protocols);
} // namespace device
