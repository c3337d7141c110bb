// SPDX-License-Identifier: GPL-3.0-or-later
// Decides which named fault hits a reply. Seeded, so that a run with faults can be repeated.
// Owned by VirtualBus; one thread. A fault of probability 0 draws no number.
#pragma once

#include "sim/bus/virtual_bus.h"

#include <random>

namespace sim {
class FaultInjector {
public:
    explicit FaultInjector(std::uint64_t seed)
        : m_generator(seed)
    {}

    bool dropsRequest(const FaultPlan& plan) { return occurs(plan.dropRequest); }

    /// Damages `frame` in place. Returns how much later it is sent; nullopt: not at all.
    std::optional<base::Duration> applyFaults(base::Bytes& frame, const FaultPlan& plan);

private:
    bool occurs(double probability);
    std::size_t randomBelow(std::size_t limit);

    std::mt19937_64 m_generator;
};
} // namespace sim
