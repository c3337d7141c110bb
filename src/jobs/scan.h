// SPDX-License-Identifier: GPL-3.0-or-later
// Searches a bus by PING, one ID at a time, at one or more rates. Never writes. Every servo that
// answers is listed whatever its error byte. A late reply counts for the ID it names; IDs heard
// late are confirmed singly with long patience.
#pragma once

#include "device/servo.h"
#include "jobs/job.h"

namespace jobs {
struct ScanSpec {
    int firstId = 0;
    int lastId = 253;
    std::vector<int> bauds; ///< empty: the rate the bus has
    bool slowPass = false;  ///< ask silent IDs again with long patience
    bool identify = true;
};

struct Found {
    device::Servo servo;         ///< profile null when only the PING was answered
    bool twinsSuspected = false; ///< checksums failed or repeated reads disagreed
    bool heardLate = false;
};

struct ScanReport {
    QString port;
    std::vector<Found> found; ///< by rate as searched, then ID
    base::Duration elapsed{};
    int lateReplies = 0;
    bool slowPassAdvised = false; ///< two or more replies came late: silent IDs may exist
    bool garbledHeard = false;    ///< noise or broken frames came where no servo was proven
    bool stopped = false;
    std::vector<int> rates;        ///< searched
    std::vector<int> ratesRefused; ///< the adapter cannot
};

base::Result<ScanReport> scan(const device::Context& context, const ScanSpec& spec,
                              const ProgressFn& progress = {},
                              const std::function<void(const Found&)>& onFound = {});
} // namespace jobs
