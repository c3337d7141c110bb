// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/hold_table.h"

#include <algorithm>

namespace bus {
namespace {
/// A request to all servos, or to unknown ones, conflicts with every hold.
constexpr int anyServo = -1;

int targetId(const protocol::Request& request)
{
    return request.id == protocol::broadcastId ? anyServo : request.id;
}
} // namespace

bool HoldTable::Entry::covers(int id) const
{
    return id == anyServo || ids.empty() || std::find(ids.begin(), ids.end(), id) != ids.end();
}

std::uint64_t HoldTable::take(const std::vector<int>& ids, std::thread::id owner,
                              std::optional<std::uint64_t> epoch)
{
    const std::lock_guard lock(m_mutex);
    for (const Entry& entry : m_entries) {
        const bool overlaps = ids.empty() || std::any_of(ids.begin(), ids.end(),
                                                         [&](int id) { return entry.covers(id); });
        if (overlaps && entry.owner != owner)
            return 0;
    }
    m_entries.push_back(
        {++m_lastToken, ids, owner, epoch.value_or(m_emergencyCount) != m_emergencyCount});
    return m_lastToken;
}

void HoldTable::release(std::uint64_t token)
{
    const std::lock_guard lock(m_mutex);
    std::erase_if(m_entries, [token](const Entry& entry) { return entry.token == token; });
}

HoldTable::Access HoldTable::accessTo(int id, std::uint64_t token, std::thread::id caller) const
{
    bool held = false;
    bool allowed = false;
    for (const Entry& entry : m_entries) {
        if (!entry.covers(id))
            continue;
        held = true;
        if (token != 0 && entry.token == token)
            allowed = true;
        else if (entry.owner != caller)
            return Access::Wait;
    }
    return held && !allowed ? Access::Refused : Access::Pass;
}

HoldTable::Access HoldTable::access(const protocol::Request& request, std::uint64_t token,
                                    std::thread::id caller, std::optional<std::uint64_t> epoch)
{
    const std::lock_guard lock(m_mutex);
    if (token == 0 && epoch.value_or(m_emergencyCount) != m_emergencyCount)
        return Access::Preempted;
    if (m_entries.empty())
        return Access::Pass;
    for (Entry& entry : m_entries) {
        if (entry.token == token && std::exchange(entry.preempted, false))
            return Access::Preempted;
    }
    if (request.targets.empty())
        return accessTo(targetId(request), token, caller);
    for (const protocol::Target& target : request.targets) {
        const Access access = accessTo(target.id, token, caller);
        if (access != Access::Pass)
            return access;
    }
    return Access::Pass;
}

bool HoldTable::isHeld(int id) const
{
    const std::lock_guard lock(m_mutex);
    return std::any_of(m_entries.begin(), m_entries.end(),
                       [id](const Entry& entry) { return entry.covers(id); });
}

void HoldTable::preemptAll()
{
    const std::lock_guard lock(m_mutex);
    ++m_emergencyCount;
    for (Entry& entry : m_entries)
        entry.preempted = true;
}

std::uint64_t HoldTable::emergencyCount() const
{
    const std::lock_guard lock(m_mutex);
    return m_emergencyCount;
}

void HoldTable::clearPreemption(std::uint64_t token)
{
    const std::lock_guard lock(m_mutex);
    for (Entry& entry : m_entries) {
        if (entry.token == token)
            entry.preempted = false;
    }
}
} // namespace bus
