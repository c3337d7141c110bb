// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/poll_planner.h"

#include <algorithm>
#include <cstddef>

namespace bus {
namespace {
/// A SYNC READ request is 8 bytes and one an ID; packets end at 250 bytes.
constexpr std::size_t maxSyncReadIds = 242;

std::vector<PollServo> distinctServos(const PollPlan& plan)
{
    std::vector<PollServo> servos;
    for (const PollServo& requested : plan.servos) {
        const auto existing = std::find_if(servos.begin(), servos.end(), [&](const PollServo& s) {
            return s.id == requested.id && s.protocol == requested.protocol;
        });
        if (existing == servos.end())
            servos.push_back(requested);
        else
            existing->spans.insert(existing->spans.end(), requested.spans.begin(),
                                   requested.spans.end());
    }
    for (PollServo& servo : servos)
        servo.spans = mergeSpans(std::move(servo.spans), servo.mergeGap, servo.maxBlock);
    return servos;
}

bool sameBlock(const PollSpan& a, const PollSpan& b)
{
    return a.address == b.address && a.count == b.count;
}
} // namespace

std::vector<PollSpan> mergeSpans(std::vector<PollSpan> spans, int mergeGap, int maxBlock)
{
    std::erase_if(spans, [](const PollSpan& span) { return span.count <= 0; });
    std::sort(spans.begin(), spans.end(), [](const PollSpan& a, const PollSpan& b) {
        return std::pair(a.every, a.address) < std::pair(b.every, b.address);
    });
    std::vector<PollSpan> blocks;
    for (const PollSpan& span : spans) {
        if (!blocks.empty() && blocks.back().every == span.every) {
            PollSpan& last = blocks.back();
            const int end = std::max(last.address + last.count, span.address + span.count);
            const bool isNear = mergeGap >= 0 ? span.address <= last.address + last.count + mergeGap
                                              : sameBlock(span, last);
            if (isNear && end - last.address <= maxBlock) {
                last.count = end - last.address;
                continue;
            }
        }
        blocks.push_back(span);
    }
    return blocks;
}

std::vector<PollGroup> planGroups(const PollPlan& plan)
{
    std::vector<PollGroup> groups;
    std::vector<int> familyGroups;
    for (const PollServo& servo : distinctServos(plan)) {
        if (servo.spans.empty())
            continue;
        std::size_t index = 0;
        while (index < groups.size() &&
               !(servo.syncRead && groups[index].sync && familyGroups[index] == servo.group &&
                 groups[index].protocol == servo.protocol && groups[index].blocks == servo.spans &&
                 groups[index].ids.size() < maxSyncReadIds))
            ++index;
        if (index == groups.size()) {
            groups.push_back({servo.protocol, {}, servo.spans, servo.syncRead});
            familyGroups.push_back(servo.group);
        }
        groups[index].ids.push_back(servo.id);
    }
    return groups;
}
} // namespace bus
