// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/polling/subscription_plan.h"

#include "bus/poll_planner.h"
#include "device/reader.h"
#include "jobs/watch/poll_spans.h"

#include <algorithm>

namespace session {
using catalog::Register;
using catalog::Role;
using Spans = std::vector<bus::PollSpan>;
using Keys = std::set<QString>;

namespace {
/// A read costs about as much as this number of bytes: request, header, the servo's delay.
constexpr int readCost = 24;
constexpr base::Duration slowPeriod = std::chrono::milliseconds(500);

/// What is asked of one servo, by key, so that servos of a family can be compared.
struct ReadRequirements {
    const ServoEntry* entry = nullptr;
    int family = 0;
    Keys fast;
    Keys slow;
    Keys beside;
    const device::Servo& servo() const { return entry->servo; }
    const catalog::Profile& profile() const { return *entry->servo.profile; }
};

void addKeys(const device::Servo& servo, const QStringList& requestedKeys, Keys& into)
{
    for (const QString& key : requestedKeys) {
        const Register* reg = servo.profile->find(key);
        if (reg != nullptr && servo.measures(*reg))
            into.insert(key);
    }
}

void addRole(const device::Servo& servo, Role role, Keys& into)
{
    if (const Register* reg = servo.profile->byRole(role))
        into.insert(reg->key);
}

/// Alarms are always seen, also where replies do not carry them.
void addAlarmRegisters(ReadRequirements& requirements)
{
    const device::Servo& servo = requirements.servo();
    if (servo.repliesCarryStatus())
        return;
    addRole(servo, Role::Status, requirements.fast);
    if (servo.profile->byRole(Role::Status) == nullptr) {
        addRole(servo, Role::PresentTemperature, requirements.fast);
        addRole(servo, Role::PresentVoltage, requirements.fast);
    }
}

std::vector<ReadRequirements> requirementsOf(const std::vector<Subscription>& subscriptions,
                                             const std::vector<const ServoEntry*>& present)
{
    std::vector<ReadRequirements> allRequirements;
    jobs::SyncReadGroups families;
    for (const ServoEntry* entry : present) {
        ReadRequirements requirements;
        requirements.entry = entry;
        requirements.family = families.of(requirements.profile());
        for (const Subscription& subscription : subscriptions) {
            for (const SubscriptionItem& part : subscription.parts) {
                if (part.servo != entry->ref)
                    continue;
                addKeys(requirements.servo(), part.keys, requirements.fast);
                addKeys(requirements.servo(), part.slowKeys, requirements.slow);
            }
        }
        if (requirements.fast.empty() && requirements.slow.empty())
            continue;
        addAlarmRegisters(requirements);
        allRequirements.push_back(std::move(requirements));
    }
    return allRequirements;
}

std::vector<const Register*> registersOf(const ReadRequirements& requirements, const Keys& keys)
{
    std::vector<const Register*> registers;
    for (const QString& key : keys) {
        if (const Register* reg = requirements.profile().find(key))
            registers.push_back(reg);
    }
    return registers;
}

Spans spansOf(const ReadRequirements& requirements, const Keys& keys, base::Duration period)
{
    return jobs::pollSpans(requirements.profile(), registersOf(requirements, keys), period);
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

Keys uncovered(const ReadRequirements& requirements, const Keys& keys, const Spans& by)
{
    Keys left;
    for (const QString& key : keys) {
        const Register* reg = requirements.profile().find(key);
        if (reg != nullptr && !covers(by, *reg))
            left.insert(key);
    }
    return left;
}

/// Servos of a family are read by one packet where they are read alike. Where that costs none of
/// them much, all read what any of them needs; else what all need, and each its rest beside it.
void alignFamily(std::vector<ReadRequirements*>& family, base::Duration period)
{
    Keys all;
    Keys slow;
    Keys shared = family.front()->fast;
    for (const ReadRequirements* requirements : family) {
        all.insert(requirements->fast.begin(), requirements->fast.end());
        slow.insert(requirements->slow.begin(), requirements->slow.end());
        std::erase_if(shared,
                      [&](const QString& key) { return requirements->fast.count(key) == 0; });
    }
    const bool cheap =
        std::all_of(family.begin(), family.end(), [&](const ReadRequirements* requirements) {
            return cost(spansOf(*requirements, all, period)) <=
                   cost(spansOf(*requirements, requirements->fast, period)) + readCost;
        });
    for (ReadRequirements* requirements : family) {
        requirements->slow = slow;
        if (cheap) {
            requirements->fast = all;
        } else if (!shared.empty()) {
            requirements->beside = uncovered(*requirements, requirements->fast,
                                             spansOf(*requirements, shared, period));
            requirements->fast = shared;
        }
    }
}

void alignFamilies(std::vector<ReadRequirements>& allRequirements, base::Duration period)
{
    std::map<int, std::vector<ReadRequirements*>> families;
    for (ReadRequirements& requirements : allRequirements) {
        if (requirements.profile().syncRead)
            families[requirements.family].push_back(&requirements);
    }
    for (auto& [number, family] : families) {
        if (family.size() > 1)
            alignFamily(family, period);
    }
}

/// What a round takes on the wire, roughly.
base::Duration roundTime(const std::vector<ReadRequirements>& allRequirements, int baud)
{
    std::int64_t bytes = 0;
    for (const ReadRequirements& requirements : allRequirements)
        bytes += cost(spansOf(requirements, requirements.fast, {}));
    constexpr std::int64_t bitsPerByte = 10;
    constexpr std::int64_t defaultBaud = 1'000'000;
    return base::Duration(bytes * bitsPerByte * defaultBaud / (baud > 0 ? baud : defaultBaud));
}

Spans slowSpans(const ReadRequirements& requirements, const Spans& fast, base::Duration round)
{
    Spans slow = device::planSpans(
        requirements.profile(),
        registersOf(requirements, uncovered(requirements, requirements.slow, fast)));
    for (bus::PollSpan& span : slow)
        span.every = jobs::everyNth(round, slowPeriod, 1);
    return slow;
}

bus::PollServo pollServoOf(const ReadRequirements& requirements, Spans& spans)
{
    const catalog::Profile& profile = requirements.profile();
    spans = bus::mergeSpans(std::move(spans), profile.readGap, profile.maxRead);
    return jobs::pollServo(requirements.servo(), spans, requirements.family);
}

base::Duration shortest(const std::vector<Subscription>& subscriptions)
{
    const auto first = std::min_element(
        subscriptions.begin(), subscriptions.end(),
        [](const Subscription& a, const Subscription& b) { return a.period < b.period; });
    return first == subscriptions.end() ? base::Duration{} : first->period;
}
} // namespace

SubscriptionPlan planSubscriptions(const std::vector<Subscription>& subscriptions,
                                   const std::vector<const ServoEntry*>& present, int baud)
{
    SubscriptionPlan plan;
    plan.primary.period = plan.secondary.period = shortest(subscriptions);
    std::vector<ReadRequirements> allRequirements = requirementsOf(subscriptions, present);
    alignFamilies(allRequirements, plan.primary.period);
    // Rounds in which nothing is due take no time: the period must limit them.
    const bool onlySlow =
        std::all_of(allRequirements.begin(), allRequirements.end(),
                    [](const ReadRequirements& requirements) { return requirements.fast.empty(); });
    if (onlySlow)
        plan.primary.period = std::max(plan.primary.period, slowPeriod);
    const base::Duration round =
        std::max({plan.primary.period, roundTime(allRequirements, baud), base::Duration(1)});
    for (const ReadRequirements& requirements : allRequirements) {
        PollTarget target{requirements.entry->ref,
                          requirements.servo().id,
                          requirements.servo().profile,
                          {},
                          {},
                          {},
                          requirements.servo().protocol};
        target.primary = spansOf(requirements, requirements.fast, plan.primary.period);
        const Spans slow = slowSpans(requirements, target.primary, round);
        target.primary.insert(target.primary.end(), slow.begin(), slow.end());
        plan.primary.servos.push_back(pollServoOf(requirements, target.primary));
        target.secondary = spansOf(requirements, requirements.beside, plan.primary.period);
        if (!target.secondary.empty())
            plan.secondary.servos.push_back(pollServoOf(requirements, target.secondary));
        Keys read = requirements.fast;
        read.insert(requirements.slow.begin(), requirements.slow.end());
        read.insert(requirements.beside.begin(), requirements.beside.end());
        target.registers = registersOf(requirements, read);
        plan.targets.push_back(std::move(target));
    }
    return plan;
}
} // namespace session
