// SPDX-License-Identifier: GPL-3.0-or-later
// The servos that a scan has found: each is listed once, identified if that is wanted, and reported
// as soon as it is known and again when more is known. Used by scan() only; its thread. Never
// writes.
#pragma once

#include "jobs/scan/rate_scan.h"
#include "jobs/scan/scan_progress.h"

namespace jobs {
class FoundServos {
public:
    using OnFound = std::function<void(const FoundServo&)>;

    /// All arguments must outlive it.
    FoundServos(const device::Context& context, const ScanSpec& spec, const OnFound& onFound,
                ScanProgress& progress);

    bool isEmpty() const { return m_servos.empty(); }
    bool hasIdentified() const;
    bool hasIdentifiedAt(int baud) const;
    /// Those whose replies collide, or cannot be read.
    std::vector<FoundServo> unidentifiedAt(int baud) const;
    int countAt(int baud, base::Protocol protocol) const;

    /// What the search knows about this ID now. Errors of the link only: a servo that cannot be
    /// identified is listed as well.
    base::Result<void> add(int id, int baud, const RateScan& search);

    /// The list of the report: sorted, and without servos heard at a neighboring rate. Leaves this
    /// empty. Notice: MixedFamilies.
    std::vector<FoundServo> takeSorted(const std::vector<int>& rates);

private:
    FoundServo* findListed(int id, int baud, base::Protocol protocol);
    base::Result<void> identify(FoundServo& found) const;
    base::Result<void> readState(device::Servo& servo) const;

    const device::Context& m_context;
    const ScanSpec& m_spec;
    const OnFound& m_onFound;
    ScanProgress& m_progress;
    std::vector<FoundServo> m_servos;
};
} // namespace jobs
