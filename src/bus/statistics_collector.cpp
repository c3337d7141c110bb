// SPDX-License-Identifier: GPL-3.0-or-later
#include "bus/statistics_collector.h"

namespace bus {
StatisticsCollector::StatisticsCollector(base::Duration start)
    : m_start(start)
{}

template <typename Function>
void StatisticsCollector::update(int id, Function&& function)
{
    const std::lock_guard lock(m_mutex);
    function(m_total);
    if (id >= 0)
        function(m_byId[id]);
}

void StatisticsCollector::count(Event event, int id)
{
    update(id, [event](Entry& entry) {
        Counters& counters = entry.counters;
        switch (event) {
        case Event::Sent:
            ++counters.sent;
            break;
        case Event::Timeout:
            ++counters.timeouts;
            break;
        case Event::BadChecksum:
            ++counters.badChecksums;
            break;
        case Event::Foreign:
            ++counters.foreign;
            break;
        case Event::Late:
            ++counters.late;
            break;
        case Event::Retried:
            ++counters.retried;
            break;
        }
    });
}

void StatisticsCollector::replyReceived(int id, base::Duration roundTrip)
{
    update(id, [roundTrip](Entry& entry) {
        ++entry.counters.ok;
        entry.roundTrips.add(roundTrip);
    });
}

void StatisticsCollector::addNoise(int id, std::size_t bytes)
{
    update(id, [bytes](Entry& entry) { entry.counters.noiseBytes += bytes; });
}

void StatisticsCollector::bytesSent(std::size_t bytes, base::Duration wireTime)
{
    const std::lock_guard lock(m_mutex);
    m_bytesOut += bytes;
    m_wireTime += wireTime;
}

void StatisticsCollector::bytesReceived(std::size_t bytes, base::Duration wireTime)
{
    const std::lock_guard lock(m_mutex);
    m_bytesIn += bytes;
    m_wireTime += wireTime;
}

Statistics StatisticsCollector::snapshot(base::Duration now) const
{
    const auto read = [](const Entry& entry) {
        Counters counters = entry.counters;
        counters.roundTripP50 = entry.roundTrips.percentile(0.50);
        counters.roundTripP99 = entry.roundTrips.percentile(0.99);
        return counters;
    };
    const std::lock_guard lock(m_mutex);
    Statistics statistics;
    statistics.total = read(m_total);
    for (const auto& [id, entry] : m_byId)
        statistics.byId.emplace(id, read(entry));
    statistics.bytesOut = m_bytesOut;
    statistics.bytesIn = m_bytesIn;
    statistics.wireTime = m_wireTime;
    statistics.since = now - m_start;
    return statistics;
}
} // namespace bus
