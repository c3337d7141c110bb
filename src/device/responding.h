// SPDX-License-Identifier: GPL-3.0-or-later
// Which of several servos answer, found out quickly, so that a silent one does not delay what the
// others are to be told. The job's thread.
#pragma once

#include "device/context.h"

#include <vector>

namespace device {
/// Asks each ID once with a PING, in each of these protocols, as briefly as a search does, then
/// waits for late replies no longer than Bus::maxReplyLateness(). In the order given. A servo that
/// is not among them may still answer a question that is repeated. Ends early on stop.
std::vector<int> findResponding(const Context& context, const std::vector<int>& ids,
                                const std::vector<base::Protocol>& protocols);
} // namespace device
