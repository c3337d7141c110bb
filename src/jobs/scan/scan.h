// SPDX-License-Identifier: GPL-3.0-or-later
// Searches a bus by asking one ID at a time, at one or more rates, in every language that can be
// met there. Never writes. Every servo that answers is listed whatever its error byte. Where a
// language can ask everybody at once (LX, Modbus), that comes first: a servo that is alone is found
// at once. Quick searches go ahead of slow ones. A late reply counts for the ID it names; IDs heard
// late are confirmed singly with long patience. The bus ends at the rate it had before.
// Errors: LinkLost, Preempted, Held; RateUnsupported when the old rate cannot be set again.
// Notice: MixedFamilies.
#pragma once

#include "device/servo.h"
#include "jobs/job.h"

namespace jobs {
/// A servo that was there before, or that the user has asked for.
struct ExpectedServo {
    int id = -1;
    int baud = 0;
    std::optional<base::Protocol> protocol{}; ///< none: any
    bool operator==(const ExpectedServo&) const = default;
};

struct ScanSpec {
    int firstId = 0;
    int lastId = 253;
    std::vector<int> bauds;                  ///< empty: the rate the bus has
    std::vector<base::Protocol> protocols{}; ///< empty: those that can be met at each rate
    bool slowPass = false;                   ///< ask silent IDs again with long patience
    bool identify = true;
    /// Asked again, with long patience, before their silence counts.
    std::vector<ExpectedServo> expected{};
};

struct FoundServo {
    device::Servo servo; ///< profile null when it answered and could not be identified
    /// Checksums failed repeatedly, more replies came than were asked for, or repeated reads
    /// disagreed. False proves nothing: twins in the same state sound like one servo.
    bool duplicateSuspected = false;
    bool lateReplySeen = false;
};

struct ScanReport {
    QString port;
    std::vector<FoundServo> found; ///< by rate as searched, then ID; each language has its own IDs
    base::Duration elapsed{};
    int lateReplies = 0;
    bool slowPassAdvised = false;   ///< two or more replies came late: silent IDs may exist
    bool hasGarbledReplies = false; ///< noise or broken frames came where no servo was proven
    bool stopped = false;
    std::vector<int> rates;            ///< searched
    std::vector<int> unsupportedRates; ///< the adapter cannot
    std::vector<int> busyRates; ///< the line never fell silent, so servos may have been missed
};

/// Duration of a scan that finds nothing, for telling the user before it starts.
base::Duration estimateScanTime(const device::Context& context, const ScanSpec& spec);

/// LineBusy where that is why nothing was found. `onFound` comes for each servo as soon as it is
/// known, and again when more is known about it (twins, late answers). The report may hold fewer:
/// one that was heard at a rate a few per cent off as well (256000 and 250000) is kept at its own
/// rate only.
base::Result<ScanReport> scan(const device::Context& context, const ScanSpec& spec,
                              const ProgressFn& progress = {},
                              const std::function<void(const FoundServo&)>& onFound = {});
} // namespace jobs
