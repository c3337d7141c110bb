// SPDX-License-Identifier: GPL-3.0-or-later
// Searches a bus by asking one ID at a time, at one or more rates, in every protocol that is
// possible there. Never writes. Every servo that answers is listed, with or without an error in its
// reply. Where a protocol has a broadcast (LX, Modbus), that comes first: it finds a single servo
// at once. Quick searches go ahead of slow ones. A late reply counts for the ID it names; IDs with
// late replies are confirmed singly with a long timeout. The bus ends at the rate it had before.
// Errors: LinkLost, Preempted, Held; RateUnsupported when the old rate cannot be set again.
// Notice: MixedFamilies.
#pragma once

#include "device/servo.h"
#include "jobs/job.h"

namespace jobs {
/// A servo that was found before, or that the user has named.
struct ExpectedServo {
    int id = -1;
    int baud = 0;
    std::optional<base::Protocol> protocol{}; ///< none: any
    bool operator==(const ExpectedServo&) const = default;
};

struct ScanSpec {
    int firstId = 0;
    int lastId = 253;
    std::vector<int> bauds;                  ///< empty: the present rate of the bus
    std::vector<base::Protocol> protocols{}; ///< empty: those that are possible at each rate
    bool slowPass = false;                   ///< ask silent IDs again with a long timeout
    bool identify = true;
    /// Only which rate the servos have: ends with the first rate at which one could be identified,
    /// or at which an ID, and it alone, brings colliding replies each time it is asked; and does
    /// without the long searches of protocols to whose broadcast no servo replied.
    bool untilFound = false;
    /// Asked again, with a long timeout, before their silence counts.
    std::vector<ExpectedServo> expected{};
};

struct FoundServo {
    device::Servo servo; ///< profile null when it answered and could not be identified
    /// Checksums failed repeatedly, more replies than requests came, or repeated reads disagreed.
    /// False proves nothing: two servos in the same state look like one.
    bool duplicateSuspected = false;
    bool lateReplySeen = false;
};

struct ScanReport {
    QString port;
    std::vector<FoundServo> found; ///< by rate as searched, then ID; each protocol has its own IDs
    base::Duration elapsed{};
    int lateReplies = 0;
    bool slowPassAdvised = false;   ///< two or more replies came late: silent IDs may exist
    bool hasGarbledReplies = false; ///< noise or broken frames came where no servo was proven
    bool stopped = false;
    std::vector<int> rates;            ///< searched
    std::vector<int> unsupportedRates; ///< the adapter cannot
    std::vector<int> busyRates; ///< the line never fell silent, so servos may have been missed
};

/// Duration of a scan that finds nothing, to show it before the start.
base::Duration estimateScanTime(const device::Context& context, const ScanSpec& spec);

/// LineBusy where that is why nothing was found. `onFound` is called for each servo as soon as it
/// is known, and again when more is known about it (duplicates, late replies). The report may hold
/// fewer servos: one that also answered at a rate a few percent off (256000 and 250000) is listed
/// at its own rate only.
base::Result<ScanReport> scan(const device::Context& context, const ScanSpec& spec,
                              const ProgressFn& progress = {},
                              const std::function<void(const FoundServo&)>& onFound = {});
} // namespace jobs
