// SPDX-License-Identifier: GPL-3.0-or-later
// The reasons to end a wait on the wire early, looked at in every slice. Bus thread only.
#pragma once

#include "base/clock.h"
#include "base/error.h"
#include "base/stop_token.h"

#include <atomic>
#include <optional>

namespace bus {
/// No wait on the wire is longer before the reasons are looked at again.
constexpr base::Duration waitSlice = std::chrono::milliseconds(10);

struct Interrupt {
    const std::atomic<bool>* emergency = nullptr;
    const base::StopToken* shutdown = nullptr; ///< the bus itself is to end
    const base::StopToken* caller = nullptr;   ///< the user stopped the job

    std::optional<base::ErrorCode> due() const
    {
        if (emergency != nullptr && emergency->load(std::memory_order_acquire))
            return base::ErrorCode::Preempted;
        if ((shutdown != nullptr && shutdown->isRequested()) ||
            (caller != nullptr && caller->isRequested()))
            return base::ErrorCode::Stopped;
        return std::nullopt;
    }
};
} // namespace bus
