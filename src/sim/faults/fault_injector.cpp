// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/faults/fault_injector.h"

namespace sim {
namespace {
constexpr std::size_t maxGarbage = 4;
}

bool FaultInjector::occurs(double probability)
{
    return probability > 0 && std::uniform_real_distribution<>(0.0, 1.0)(m_generator) < probability;
}

std::size_t FaultInjector::randomBelow(std::size_t limit)
{
    return std::uniform_int_distribution<std::size_t>(0, limit - 1)(m_generator);
}

std::optional<base::Duration> FaultInjector::applyFaults(base::Bytes& frame, const FaultPlan& plan)
{
    if (occurs(plan.drop))
        return std::nullopt;
    if (occurs(plan.corrupt)) {
        std::uint8_t& target = frame[randomBelow(frame.size())];
        target = static_cast<std::uint8_t>(target ^ (1U << randomBelow(8)));
    }
    if (occurs(plan.truncate))
        frame.resize(1 + randomBelow(frame.size() - 1));
    if (occurs(plan.garbage)) {
        base::Bytes garbage(1 + randomBelow(maxGarbage));
        for (std::uint8_t& byte : garbage)
            byte = static_cast<std::uint8_t>(randomBelow(256));
        frame.insert(frame.begin(), garbage.begin(), garbage.end());
    }
    return occurs(plan.late) ? plan.lateBy : base::Duration{};
}
} // namespace sim
