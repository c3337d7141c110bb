// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/feed_plan.h"

#include "bus/poll_planner.h"
#include "device/reader.h"
#include "jobs/poll_spans.h"

#include <algorithm>

namespace session {
using catalog::Register;
using catalog::Role;
using Spans = std::vector<bus::PollSpan>;
using Keys = std::set<QString>;

namespace {
/// A read costs about as much as so many bytes: request, header, the servo's delay.
constexpr int readCost = 24;
constexpr base::Duration slowPace = std::chrono::milliseconds(500);

/// What is asked of one servo, by key, so that servos of a family can be compared.
struct Need {
    const ServoEntry* entry = nullptr;
    int family = 0;
    Keys fast;
    Keys slow;
    Keys beside;
    const device::Servo& servo() const { return entry->servo; }
    const catalog::Profile& profile() const { return *entry->servo.profile; }
};

void take(const device::Servo& servo, const QStringList& wanted, Keys& into)
{
    for (const QString& key : wanted) {
        const Register* reg = servo.profile->find(key);
        if (reg != nullptr && servo.measures(*reg))
            into.insert(key);
    }
}

void takeRole(const device::Servo& servo, Role role, Keys& into)
{
    if (const Register* reg = servo.profile->byRole(role))
        into.insert(reg->key);
}

/// Alarms are seen whatever is watched, also where replies do not carry them.
void takeEvidence(Need& need)
{
    const device::Servo& servo = need.servo();
    if (servo.repliesCarryStatus())
        return;
    takeRole(servo, Role::Status, need.fast);
    if (servo.profile->byRole(Role::Status) == nullptr) {
        takeRole(servo, Role::PresentTemperature, need.fast);
        takeRole(servo, Role::PresentVoltage, need.fast);
    }
}

std::vector<Need> needsOf(const std::vector<FeedWish>& wishes,
                          const std::vector<const ServoEntry*>& present)
{
    std::vector<Need> needs;
    jobs::PollFamilies families;
    for (const ServoEntry* entry : present) {
        Need need;
        need.entry = entry;
        need.family = families.of(need.profile());
        for (const FeedWish& wish : wishes) {
            for (const FeedPart& part : wish.parts) {
                if (part.servo != entry->ref)
                    continue;
                take(need.servo(), part.keys, need.fast);
                take(need.servo(), part.slowKeys, need.slow);
            }
        }
        if (need.fast.empty() && need.slow.empty())
            continue;
        takeEvidence(need);
        needs.push_back(std::move(need));
    }
    return needs;
}

std::vector<const Register*> registersOf(const Need& need, const Keys& keys)
{
    std::vector<const Register*> registers;
    for (const QString& key : keys) {
        if (const Register* reg = need.profile().find(key))
            registers.push_back(reg);
    }
    return registers;
}

Spans spansOf(const Need& need, const Keys& keys, base::Duration period)
{
    return jobs::pollSpans(need.profile(), registersOf(need, keys), period);
}

int cost(const Spans& spans)
{
    int bytes = 0;
    for (const bus::PollSpan& span : spans)
        bytes += span.every == 1 ? span.count + readCost : 0;
    return bytes;
}

bool covers(const Spans& spans, const Register& reg)
{
    return std::any_of(spans.begin(), spans.end(), [&](const bus::PollSpan& span) {
        return reg.offset >= span.address && reg.offset + reg.size <= span.address + span.count;
    });
}

Keys uncovered(const Need& need, const Keys& keys, const Spans& by)
{
    Keys left;
    for (const QString& key : keys) {
        const Register* reg = need.profile().find(key);
        if (reg != nullptr && !covers(by, *reg))
            left.insert(key);
    }
    return left;
}

/// Servos of a family are read by one packet where they are read alike. Where that costs none of
/// them much, all read what any of them needs; else what all need, and each its rest beside it.
void alike(std::vector<Need*>& family, base::Duration period)
{
    Keys all;
    Keys slow;
    Keys shared = family.front()->fast;
    for (const Need* need : family) {
        all.insert(need->fast.begin(), need->fast.end());
        slow.insert(need->slow.begin(), need->slow.end());
        std::erase_if(shared, [&](const QString& key) { return need->fast.count(key) == 0; });
    }
    const bool cheap = std::all_of(family.begin(), family.end(), [&](const Need* need) {
        return cost(spansOf(*need, all, period)) <=
               cost(spansOf(*need, need->fast, period)) + readCost;
    });
    for (Need* need : family) {
        need->slow = slow;
        if (cheap) {
            need->fast = all;
        } else if (!shared.empty()) {
            need->beside = uncovered(*need, need->fast, spansOf(*need, shared, period));
            need->fast = shared;
        }
    }
}

void makeAlike(std::vector<Need>& needs, base::Duration period)
{
    std::map<int, std::vector<Need*>> families;
    for (Need& need : needs) {
        if (need.profile().syncRead)
            families[need.family].push_back(&need);
    }
    for (auto& [number, family] : families) {
        if (family.size() > 1)
            alike(family, period);
    }
}

/// What a round takes on the wire, roughly.
base::Duration roundTime(const std::vector<Need>& needs, int baud)
{
    std::int64_t bytes = 0;
    for (const Need& need : needs)
        bytes += cost(spansOf(need, need.fast, {}));
    constexpr std::int64_t bitsPerByte = 10;
    constexpr std::int64_t usual = 1'000'000;
    return base::Duration(bytes * bitsPerByte * usual / (baud > 0 ? baud : usual));
}

Spans slowSpans(const Need& need, const Spans& fast, base::Duration round)
{
    Spans slow =
        device::planSpans(need.profile(), registersOf(need, uncovered(need, need.slow, fast)));
    for (bus::PollSpan& span : slow)
        span.every = jobs::everyNth(round, slowPace, 1);
    return slow;
}

bus::PollServo asked(const Need& need, Spans& spans)
{
    const catalog::Profile& profile = need.profile();
    spans = bus::mergeSpans(std::move(spans), profile.readGap, profile.maxRead);
    return {need.servo().id,       spans,           profile.syncRead, need.family,
            need.servo().protocol, profile.readGap, profile.maxRead};
}

base::Duration shortest(const std::vector<FeedWish>& wishes)
{
    const auto first =
        std::min_element(wishes.begin(), wishes.end(),
                         [](const FeedWish& a, const FeedWish& b) { return a.period < b.period; });
    return first == wishes.end() ? base::Duration{} : first->period;
}
} // namespace

FeedPlan planFeed(const std::vector<FeedWish>& wishes,
                  const std::vector<const ServoEntry*>& present, int baud)
{
    FeedPlan plan;
    plan.common.period = plan.beside.period = shortest(wishes);
    std::vector<Need> needs = needsOf(wishes, present);
    makeAlike(needs, plan.common.period);
    // Rounds in which nothing is due take no time: somebody has to set the pace.
    const bool onlySlow =
        std::all_of(needs.begin(), needs.end(), [](const Need& need) { return need.fast.empty(); });
    if (onlySlow)
        plan.common.period = std::max(plan.common.period, slowPace);
    const base::Duration round =
        std::max({plan.common.period, roundTime(needs, baud), base::Duration(1)});
    for (const Need& need : needs) {
        FeedTarget target{need.entry->ref,      need.servo().id, need.servo().profile, {}, {}, {},
                          need.servo().protocol};
        target.common = spansOf(need, need.fast, plan.common.period);
        const Spans slow = slowSpans(need, target.common, round);
        target.common.insert(target.common.end(), slow.begin(), slow.end());
        plan.common.servos.push_back(asked(need, target.common));
        target.beside = spansOf(need, need.beside, plan.common.period);
        if (!target.beside.empty())
            plan.beside.servos.push_back(asked(need, target.beside));
        Keys read = need.fast;
        read.insert(need.slow.begin(), need.slow.end());
        read.insert(need.beside.begin(), need.beside.end());
        target.registers = registersOf(need, read);
        plan.targets.push_back(std::move(target));
    }
    return plan;
}
} // namespace session
