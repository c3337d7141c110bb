// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/watch/poll_spans.h"

#include "bus/poll_planner.h"
#include "device/reader.h"

#include <algorithm>

namespace jobs {
namespace {
constexpr base::Duration slowPeriod = std::chrono::seconds(1);
constexpr int slowRoundDivider = 100; ///< where rounds follow each other without a pause

/// Where each register is read by itself, slow ones would take time from fast ones.
bool isSlow(const catalog::Profile& profile, const catalog::Register* reg)
{
    return profile.readGap < 0 && (reg->role == catalog::Role::PresentTemperature ||
                                   reg->role == catalog::Role::PresentVoltage);
}
} // namespace

int everyNth(base::Duration period, base::Duration interval, int defaultDivider)
{
    return period > base::Duration{}
               ? int(std::clamp<base::Duration::rep>(interval / period, 1, 1000))
               : defaultDivider;
}

std::vector<bus::PollSpan> pollSpans(const catalog::Profile& profile,
                                     const std::vector<const catalog::Register*>& registers,
                                     base::Duration period)
{
    auto fast = registers;
    auto slow = registers;
    std::erase_if(fast, [&](const auto* reg) { return isSlow(profile, reg); });
    std::erase_if(slow, [&](const auto* reg) { return !isSlow(profile, reg); });
    if (fast.empty())
        fast.swap(slow);
    std::vector<bus::PollSpan> spans = device::planSpans(profile, fast);
    for (bus::PollSpan span : device::planSpans(profile, slow)) {
        span.every = everyNth(period, slowPeriod, slowRoundDivider);
        spans.push_back(span);
    }
    return bus::mergeSpans(std::move(spans), profile.readGap, profile.maxRead);
}

int SyncReadGroups::of(const catalog::Profile& profile)
{
    return m_numbers.try_emplace({profile.mapKey, profile.byteOrder}, int(m_numbers.size()))
        .first->second;
}

bus::PollServo pollServo(const device::Servo& servo, std::vector<bus::PollSpan> spans, int group)
{
    const catalog::Profile& profile = *servo.profile;
    return {servo.id,       std::move(spans), profile.syncRead, group,
            servo.protocol, profile.readGap,  profile.maxRead};
}
} // namespace jobs
