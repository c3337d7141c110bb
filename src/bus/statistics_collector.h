// SPDX-License-Identifier: GPL-3.0-or-later
// Counts what happens on one wire. Fed by the bus, copied out by any thread. An event without a
// servo (broadcast, noise while no request is open) has ID -1 and counts in the sum only. A PING
// that stays unanswered is no time-out: it asks whether a servo is there.
#pragma once

#include "bus/round_trip_histogram.h"
#include "bus/statistics.h"

#include <atomic>
#include <map>
#include <mutex>

namespace bus {
class StatisticsCollector {
public:
    enum class Event : std::uint8_t { Sent, Timeout, BadChecksum, Foreign, Late, Retried };

    explicit StatisticsCollector(base::Duration start);

    void count(Event event, int id);
    void replyReceived(int id, base::Duration roundTrip);
    void addNoise(int id, std::size_t bytes);
    /// Bytes of no valid frame that came while no reply was awaited.
    void addUnsolicitedNoise(std::size_t bytes) { m_unsolicitedNoise += bytes; }
    std::uint64_t unsolicitedNoise() const { return m_unsolicitedNoise; }
    void bytesSent(std::size_t bytes, base::Duration wireTime);
    void bytesReceived(std::size_t bytes, base::Duration wireTime);

    /// The caller fills in the timeout and the lost samples.
    Statistics snapshot(base::Duration now) const;

private:
    struct Entry {
        Counters counters;
        RoundTripHistogram roundTrips;
    };
    template <typename Function>
    void update(int id, Function&& function);

    mutable std::mutex m_mutex;
    base::Duration m_start;
    Entry m_total;
    std::map<int, Entry> m_byId;
    std::uint64_t m_bytesOut = 0;
    std::uint64_t m_bytesIn = 0;
    base::Duration m_wireTime{};
    std::atomic<std::uint64_t> m_unsolicitedNoise = 0;
};
} // namespace bus
