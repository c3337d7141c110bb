// SPDX-License-Identifier: GPL-3.0-or-later
// A link with a witness: notes every frame the host writes before it passes it on, may call a hook
// at each, plays an adapter that cannot run some rates, and a device that answers in bytes of its
// own. The notes outlive the link. One thread.
#pragma once

#include "transport/link.h"

#include <functional>
#include <optional>
#include <set>
#include <vector>

namespace support {
struct LinkTap {
    std::vector<base::Bytes> written; ///< one entry a write, that is a frame
    std::function<void(const base::Bytes&)> onWrite;
    std::function<void()> onWait; ///< about to wait for an answer
    std::function<void()> onOpen; ///< about to try
    std::set<int> refusedRates;
    bool rateIsFixed = false; ///< like a network bridge, whose other end sets the rate
    /// The reply of a device outside the simulator to a frame: the bytes that come back,
    /// maybe none. nullopt: the frame goes to the simulator.
    std::function<std::optional<base::Bytes>(const base::Bytes&)> replyOverride;
};

/// `tap` and `link`'s own context must outlive the result.
std::unique_ptr<transport::Link> tapped(std::unique_ptr<transport::Link> link, LinkTap& tap);
} // namespace support
