// SPDX-License-Identifier: GPL-3.0-or-later
// Searches a bus by PING, one ID at a time, at one or more rates. Never writes. Every servo that
// answers is listed whatever its error byte. A late reply counts for the ID it names; IDs heard
// late are confirmed singly with long patience. The bus ends at the rate it had before.
// Errors: LinkLost, Preempted, Held; RateUnsupported when the old rate cannot be set again.
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
    device::Servo servo; ///< profile null when only the PING was answered, or only in garbles
    /// Checksums failed repeatedly, more replies came than were asked for, or repeated reads
    /// disagreed. False proves nothing: twins in the same state sound like one servo.
    bool twinsSuspected = false;
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

/// Duration of a scan that finds nothing, for telling the user before it starts. `presentBaud` is
/// the bus' rate, used when the spec names none.
base::Duration scanEstimate(const ScanSpec& spec, int presentBaud);

/// `onFound` comes at once for each servo. The report may hold fewer: one that was heard at a rate
/// a few per cent off as well (256000 and 250000) is kept at its own rate only.
base::Result<ScanReport> scan(const device::Context& context, const ScanSpec& spec,
                              const ProgressFn& progress = {},
                              const std::function<void(const Found&)>& onFound = {});
} // namespace jobs
