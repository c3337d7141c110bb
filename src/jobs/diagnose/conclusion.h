// SPDX-License-Identifier: GPL-3.0-or-later
// From what was observed on a bus to the cause. Pure; any thread; used by diagnose() only.
#pragma once

#include "jobs/diagnose/servo_probe.h"

#include <map>
#include <numeric>

namespace jobs {
struct Observations {
    int homeRate = 0;
    std::vector<base::Protocol> protocols; ///< selected; empty: all
    bool isShared = false;                 ///< another program has the port open
    bool hasEcho = false;
    bool hasGarbledReplies = false;
    std::map<int, int> bytesAt; ///< by rate that was listened to: received, without the echo
    QString text;               ///< if that is what came
    bool hasBootloader = false; ///< one has replied
    std::vector<int> busyRates;
    std::vector<FoundServo> found;
    std::vector<ServoProbe> probes; ///< of the same servos

    int bytesReceivedAt(int baud) const
    {
        const auto entry = bytesAt.find(baud);
        return entry != bytesAt.end() ? entry->second : 0;
    }
    int totalBytes() const
    {
        return std::accumulate(bytesAt.begin(), bytesAt.end(), 0,
                               [](int sum, const auto& entry) { return sum + entry.second; });
    }
};

/// Without the evidence.
base::Diagnosis conclude(const Observations& seen);
} // namespace jobs
