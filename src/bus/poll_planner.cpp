// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/poll_planner.h"

#include <algorithm>
#include <cstddef>

namespace bus {
namespace {
/// Another READ costs 14 bytes of frames, a reply delay and a turn of the host.
constexpr int cheapGap = 12;
constexpr int longestBlock = 128;
/// A SYNC READ request is 8 bytes and one an ID; packets end at 250 bytes.
constexpr std::size_t mostInOneSync = 242;

struct Servo {
    int id = 0;
    std::vector<PollSpan> spans;
    bool sync = false;
    int group = 0;
};

std::vector<Servo> distinctServos(const PollPlan& plan)
{
    std::vector<Servo> servos;
    for (const PollServo& wanted : plan.servos) {
        const auto known = std::find_if(servos.begin(), servos.end(),
                                        [&](const Servo& s) { return s.id == wanted.id; });
        if (known == servos.end())
            servos.push_back({wanted.id, wanted.spans, wanted.syncRead, wanted.group});
        else
            known->spans.insert(known->spans.end(), wanted.spans.begin(), wanted.spans.end());
    }
    for (Servo& servo : servos)
        servo.spans = mergeSpans(std::move(servo.spans));
    return servos;
}
} // namespace

std::vector<PollSpan> mergeSpans(std::vector<PollSpan> spans)
{
    std::erase_if(spans, [](const PollSpan& span) { return span.count <= 0; });
    std::sort(spans.begin(), spans.end(),
              [](const PollSpan& a, const PollSpan& b) { return a.address < b.address; });
    std::vector<PollSpan> blocks;
    for (const PollSpan& span : spans) {
        if (!blocks.empty()) {
            PollSpan& last = blocks.back();
            const int end = std::max(last.address + last.count, span.address + span.count);
            const bool near = span.address <= last.address + last.count + cheapGap;
            if (near && end - last.address <= longestBlock) {
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
    for (const Servo& servo : distinctServos(plan)) {
        if (servo.spans.empty())
            continue;
        std::size_t place = 0;
        while (place < groups.size() &&
               !(servo.sync && groups[place].sync && families[place] == servo.group &&
                 groups[place].blocks == servo.spans && groups[place].ids.size() < mostInOneSync))
            ++place;
        if (place == groups.size()) {
            groups.push_back({{}, servo.spans, servo.sync});
            families.push_back(servo.group);
        }
        groups[place].ids.push_back(servo.id);
    }
    return groups;
}
} // namespace bus
