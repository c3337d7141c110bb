// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/poll_runner.h"

#include <algorithm>

namespace bus {
using base::Duration;
using namespace std::chrono_literals;

namespace {
constexpr int patienceInTurns = 5;
constexpr Duration absentPause = 1s;
/// A plan of which no servo may be asked at the moment is looked at again after this time.
constexpr Duration idlePause = 5ms;
} // namespace

void PollRunner::start(PollId id, const PollPlan& plan, Duration now)
{
    Plan made;
    made.id = id;
    made.period = plan.period;
    made.due = now;
    for (PollGroup& reads : planGroups(plan)) {
        const std::size_t count = reads.ids.size();
        made.groups.push_back({std::move(reads), std::vector<Servo>(count)});
    }
    if (!made.groups.empty())
        m_plans.push_back(std::move(made));
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

std::optional<PollRead> PollRunner::next(Duration now, const FreeFrom& freeFrom)
{
    for (;;) {
        const auto plan =
            std::min_element(m_plans.begin(), m_plans.end(),
                             [](const Plan& a, const Plan& b) { return a.due < b.due; });
        if (plan == m_plans.end() || plan->due > now)
            return std::nullopt;
        if (!plan->inRound()) {
            beginRound(*plan, now, freeFrom);
            continue;
        }
        PollRead read = std::move(plan->round[plan->position++]);
        if (!plan->inRound())
            plan->due = std::max(plan->due + plan->period, now);
        // Its earlier reads in this round may have made a servo unavailable.
        std::erase_if(read.ids, [&](int id) { return freeFrom(id) > now; });
        if (!read.ids.empty())
            return read;
    }
}

/// Leaves the plan with a round to do, or due later.
void PollRunner::beginRound(Plan& plan, Duration now, const FreeFrom& freeFrom)
{
    plan.round.clear();
    plan.position = 0;
    Duration earliest = Duration::max();
    bool anybody = false;
    for (std::size_t g = 0; g < plan.groups.size(); ++g) {
        const Group& group = plan.groups[g];
        std::vector<int> together;
        std::vector<int> singly;
        for (std::size_t i = 0; i < group.servos.size(); ++i) {
            const int id = group.reads.ids[i];
            const Duration from = std::max(group.servos[i].notBefore, freeFrom(id));
            if (from > now)
                earliest = std::min(earliest, from);
            else
                (group.reads.sync && !group.servos[i].single ? together : singly).push_back(id);
        }
        anybody = anybody || !together.empty() || !singly.empty();
        std::vector<PollSpan> due;
        std::copy_if(group.reads.blocks.begin(), group.reads.blocks.end(), std::back_inserter(due),
                     [&](const PollSpan& block) {
                         return plan.rounds % std::uint64_t(std::max(block.every, 1)) == 0;
                     });
        for (const PollSpan& block : due) {
            const bool last = block == due.back();
            if (!together.empty())
                plan.round.push_back({plan.id, g, group.reads.protocol, together, block, last});
            for (const int id : singly)
                plan.round.push_back({plan.id, g, group.reads.protocol, {id}, block, last});
        }
    }
    // A round in which nothing is due counts too, or the next one would be the same again.
    if (anybody)
        ++plan.rounds;
    if (!anybody)
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
            missed(group.servos[i], sync, now);
        else
            answered(group.servos[i], sync);
    }
}

void PollRunner::missed(Servo& servo, bool sync, Duration now)
{
    if (sync) {
        if (++servo.syncMisses >= patienceInTurns) {
            servo.single = true;
            servo.misses = 0;
        }
        return;
    }
    if (++servo.misses >= patienceInTurns)
        servo.notBefore = now + absentPause;
}

void PollRunner::answered(Servo& servo, bool sync)
{
    servo.syncMisses = sync ? 0 : servo.syncMisses;
    if (!sync && servo.single && !servo.singleOnly) {
        // Missed singly too: it was away and has come back.
        servo.singleOnly = servo.misses == 0;
        servo.single = servo.singleOnly;
        servo.syncMisses = 0;
    }
    servo.misses = 0;
}
} // namespace bus
