// SPDX-License-Identifier: GPL-3.0-or-later
// Which of some IDs no servo answers to at the present rate, in any protocol that can exist there:
// a quick check for proposals. It proves nothing; changeId() does, with more requests. Sends PINGs
// only.
#pragma once

#include "jobs/job.h"

#include <vector>

namespace jobs {
/// The silent ones of `ids`, in their order, up to `wanted` of them. An ID counts as used if any
/// byte comes, even noise. Errors: LinkLost, Stopped, Held, Preempted.
base::Result<std::vector<int>> findFreeIds(const device::Context& context, base::Protocol protocol,
                                           const std::vector<int>& ids, std::size_t maxCount);
} // namespace jobs
