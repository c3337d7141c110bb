// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/poll_runner.h"

#include <algorithm>

namespace bus {
using base::Duration;
using namespace std::chrono_literals;

namespace {
constexpr int maxMisses = 5;
constexpr Duration absentInterval = 1s;
/// A plan of which no servo may be asked at the moment is looked at again after this time.
constexpr Duration idlePause = 5ms;
} // namespace

void PollRunner::start(PollId id, const PollPlan& plan, Duration now)
{
    Plan newPlan;
    newPlan.id = id;
    newPlan.period = plan.period;
    newPlan.due = now;
    for (PollGroup& reads : planGroups(plan)) {
        const std::size_t count = reads.ids.size();
        newPlan.groups.push_back({std::move(reads), std::vector<Servo>(count)});
    }
    if (!newPlan.groups.empty())
        m_plans.push_back(std::move(newPlan));
}

void PollRunner::stop(PollId id)
{
    std::erase_if(m_plans, [id](const Plan& plan) { return plan.id == id; });
}

std::optional<Duration> PollRunner::nextDue() const
{
    std::optional<Duration> due;
    for (const Plan& plan : m_plans)
        due = due ? std::min(*due, plan.due) : plan.due;
    return due;
}

std::optional<PollRead> PollRunner::next(Duration now, const ReadyAt& readyAt)
{
    for (;;) {
        const auto plan =
            std::min_element(m_plans.begin(), m_plans.end(),
                             [](const Plan& a, const Plan& b) { return a.due < b.due; });
        if (plan == m_plans.end() || plan->due > now)
            return std::nullopt;
        if (!plan->inRound()) {
            beginRound(*plan, now, readyAt);
            continue;
        }
        PollRead read = std::move(plan->round[plan->position++]);
        if (!plan->inRound())
            plan->due = std::max(plan->due + plan->period, now);
        // Its earlier reads in this round may have made a servo unavailable.
        std::erase_if(read.ids, [&](int id) { return readyAt(id) > now; });
        if (!read.ids.empty())
            return read;
    }
}

/// Leaves the plan with a round to do, or due later.
void PollRunner::beginRound(Plan& plan, Duration now, const ReadyAt& readyAt)
{
    plan.round.clear();
    plan.position = 0;
    Duration earliest = Duration::max();
    bool anyDue = false;
    for (std::size_t g = 0; g < plan.groups.size(); ++g) {
        const Group& group = plan.groups[g];
        std::vector<int> syncIds;
        std::vector<int> singleIds;
        for (std::size_t i = 0; i < group.servos.size(); ++i) {
            const int id = group.reads.ids[i];
            const Duration from = std::max(group.servos[i].notBefore, readyAt(id));
            if (from > now)
                earliest = std::min(earliest, from);
            else
                (group.reads.sync && !group.servos[i].single ? syncIds : singleIds).push_back(id);
        }
        anyDue = anyDue || !syncIds.empty() || !singleIds.empty();
        std::vector<PollSpan> due;
        std::copy_if(group.reads.blocks.begin(), group.reads.blocks.end(), std::back_inserter(due),
                     [&](const PollSpan& block) {
                         return plan.rounds % std::uint64_t(std::max(block.every, 1)) == 0;
                     });
        for (const PollSpan& block : due) {
            const bool last = block == due.back();
            if (!syncIds.empty())
                plan.round.push_back({plan.id, g, group.reads.protocol, syncIds, block, last});
            for (const int id : singleIds)
                plan.round.push_back({plan.id, g, group.reads.protocol, {id}, block, last});
        }
    }
    // A round in which nothing is due counts too, or the next one would be the same again.
    if (anyDue)
        ++plan.rounds;
    if (!anyDue)
        plan.due = std::max({plan.due + plan.period, now + idlePause, earliest});
    else if (!plan.inRound())
        plan.due = std::max(plan.due + plan.period, now);
}

void PollRunner::finished(const PollRead& read, const std::vector<int>& missing, Duration now)
{
    const auto plan = std::find_if(m_plans.begin(), m_plans.end(),
                                   [&](const Plan& p) { return p.id == read.plan; });
    if (plan == m_plans.end())
        return;
    Group& group = plan->groups[read.group];
    for (std::size_t i = 0; i < group.servos.size(); ++i) {
        const int id = group.reads.ids[i];
        const auto isId = [id](int other) { return other == id; };
        if (std::none_of(read.ids.begin(), read.ids.end(), isId))
            continue;
        const bool sync = read.ids.size() > 1;
        if (std::any_of(missing.begin(), missing.end(), isId))
            countMiss(group.servos[i], sync, now);
        else
            countReply(group.servos[i], sync);
    }
}

void PollRunner::countMiss(Servo& servo, bool sync, Duration now)
{
    if (sync) {
        if (++servo.syncMisses >= maxMisses) {
            servo.single = true;
            servo.misses = 0;
        }
        return;
    }
    if (++servo.misses >= maxMisses)
        servo.notBefore = now + absentInterval;
}

void PollRunner::countReply(Servo& servo, bool sync)
{
    servo.syncMisses = sync ? 0 : servo.syncMisses;
    if (!sync && servo.single && !servo.noSyncRead) {
        // Missed singly too: it was away and has come back.
        servo.noSyncRead = servo.misses == 0;
        servo.single = servo.noSyncRead;
        servo.syncMisses = 0;
    }
    servo.misses = 0;
}
} // namespace bus
