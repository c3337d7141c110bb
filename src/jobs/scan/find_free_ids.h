// SPDX-License-Identifier: GPL-3.0-or-later
// Which of some IDs nobody answers to at the present rate, in any language that can exist there: a
// quick look for proposals. It proves nothing; changeId() does, with more questions. Sends PINGs
// only.
#pragma once

#include "jobs/job.h"

#include <vector>

namespace jobs {
/// Of `ids`, in their order, the silent ones; the first `wanted` are enough. Whatever answers, were
/// it noise, has the ID. Errors: LinkLost, Stopped, Held, Preempted.
base::Result<std::vector<int>> findFreeIds(const device::Context& context, base::Protocol protocol,
                                           const std::vector<int>& ids, std::size_t maxCount);
} // namespace jobs
