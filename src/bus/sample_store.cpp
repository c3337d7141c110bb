// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/sample_store.h"

#include <iterator>

namespace bus {
PollId SampleStore::open()
{
    const std::lock_guard lock(m_mutex);
    m_queues.try_emplace(++m_last);
    return m_last;
}

void SampleStore::add(PollId id, Sample sample)
{
    const std::lock_guard lock(m_mutex);
    const auto found = m_queues.find(id);
    if (found == m_queues.end())
        return;
    auto& samples = found->second.samples;
    if (samples.size() == capacity) {
        samples.pop_front();
        ++m_lost;
    }
    samples.push_back(std::move(sample));
}

void SampleStore::close(PollId id)
{
    const std::lock_guard lock(m_mutex);
    const auto found = m_queues.find(id);
    if (found == m_queues.end())
        return;
    if (found->second.samples.empty())
        m_queues.erase(found);
    else
        found->second.closed = true;
}

std::vector<Sample> SampleStore::take(PollId id)
{
    const std::lock_guard lock(m_mutex);
    const auto found = m_queues.find(id);
    if (found == m_queues.end())
        return {};
    auto& samples = found->second.samples;
    std::vector<Sample> taken(std::make_move_iterator(samples.begin()),
                              std::make_move_iterator(samples.end()));
    samples.clear();
    if (found->second.closed)
        m_queues.erase(found);
    return taken;
}

std::uint64_t SampleStore::lost() const
{
    const std::lock_guard lock(m_mutex);
    return m_lost;
}
} // namespace bus
