// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/fault_dice.h"

namespace sim {
namespace {
constexpr std::size_t maxGarbage = 4;
}

bool FaultDice::happens(double probability)
{
    return probability > 0 && std::uniform_real_distribution<>(0.0, 1.0)(m_generator) < probability;
}

std::size_t FaultDice::below(std::size_t limit)
{
    return std::uniform_int_distribution<std::size_t>(0, limit - 1)(m_generator);
}

std::optional<base::Duration> FaultDice::spoil(base::Bytes& frame, const FaultPlan& plan)
{
    if (happens(plan.drop))
        return std::nullopt;
    if (happens(plan.corrupt)) {
        std::uint8_t& victim = frame[below(frame.size())];
        victim = static_cast<std::uint8_t>(victim ^ (1U << below(8)));
    }
    if (happens(plan.truncate))
        frame.resize(1 + below(frame.size() - 1));
    if (happens(plan.garbage)) {
        base::Bytes garbage(1 + below(maxGarbage));
        for (std::uint8_t& byte : garbage)
            byte = static_cast<std::uint8_t>(below(256));
        frame.insert(frame.begin(), garbage.begin(), garbage.end());
    }
    return happens(plan.late) ? plan.lateBy : base::Duration{};
}
} // namespace sim
