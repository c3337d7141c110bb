// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/poll_planner.h"

#include <algorithm>
#include <cstddef>

namespace bus {
namespace {
/// A SYNC READ request is 8 bytes and one an ID; packets end at 250 bytes.
constexpr std::size_t mostInOneSync = 242;

std::vector<PollServo> distinctServos(const PollPlan& plan)
{
    std::vector<PollServo> servos;
    for (const PollServo& wanted : plan.servos) {
        const auto known = std::find_if(servos.begin(), servos.end(), [&](const PollServo& s) {
            return s.id == wanted.id && s.protocol == wanted.protocol;
        });
        if (known == servos.end())
            servos.push_back(wanted);
        else
            known->spans.insert(known->spans.end(), wanted.spans.begin(), wanted.spans.end());
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
            const bool near = mergeGap >= 0 ? span.address <= last.address + last.count + mergeGap
                                            : sameBlock(span, last);
            if (near && end - last.address <= maxBlock) {
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
    std::vector<int> families;
    for (const PollServo& servo : distinctServos(plan)) {
        if (servo.spans.empty())
            continue;
        std::size_t place = 0;
        while (place < groups.size() &&
               !(servo.syncRead && groups[place].sync && families[place] == servo.group &&
                 groups[place].protocol == servo.protocol && groups[place].blocks == servo.spans &&
                 groups[place].ids.size() < mostInOneSync))
            ++place;
        if (place == groups.size()) {
            groups.push_back({servo.protocol, {}, servo.spans, servo.syncRead});
            families.push_back(servo.group);
        }
        groups[place].ids.push_back(servo.id);
    }
    return groups;
}
} // namespace bus
