// SPDX-License-Identifier: GPL-3.0-or-later
// Which servos are on the bus of a commissioning line. Short rounds over the likely rates find a
// factory servo within a fraction of a second; before anything is done to it, all IDs are asked.
// Sends only PINGs and READs. Internal to jobs; the job's thread. Errors: LinkLost, Stopped,
// Preempted, Held, RateUnsupported.
#pragma once

#include "jobs/change/change.h"
#include "jobs/commission/commission.h"
#include "jobs/scan/scan.h"

namespace jobs {
class CommissionDetector {
public:
    CommissionDetector(const device::Context& context, const CommissionSpec& spec);

    struct BusLocation {
        base::Protocol protocol = base::Protocol::Feetech;
        int id = -1; ///< −1: the reply was corrupt
        int baud = 0;
    };

    /// One round; the first reply ends it. `known` are asked first.
    base::Result<std::optional<BusLocation>> scanRound(const std::vector<BusLocation>& known);

    /// All servos that reply after `first` did: every ID at its rate and at the rate it will get,
    /// the common IDs at other rates.
    base::Result<std::vector<FoundServo>> findAll(const BusLocation& first);

    /// As before every write: more thorough than a search.
    base::Result<bool> hasDuplicateId(const device::Servo& servo);

    /// Waits long enough for a slow reply. Leaves the bus at that rate.
    base::Result<bool> isPresent(const BusLocation& place);

private:
    enum class BusPresence { Silent, Clean, Broken };
    struct PingResult {
        BusPresence presence = BusPresence::Silent;
        int id = -1;
    };
    base::Result<PingResult> ping(base::Protocol protocol, int id, base::Duration timeout) const;
    base::Result<bool> setRate(int baud) const; ///< false: the adapter cannot
    std::vector<base::Protocol> protocolsFor(int baud) const;
    base::Result<std::optional<BusLocation>> scanCommonIds(int baud);
    base::Result<std::optional<BusLocation>> pingEach(base::Protocol protocol,
                                                      const std::vector<int>& ids, int baud);
    std::optional<BusLocation> findLateReply(const std::vector<bus::UnexpectedFrame>& strays,
                                             base::Protocol protocol, int baud) const;
    base::Result<std::optional<BusLocation>> scanNextSlice();
    base::Result<void> checkAlone(const BusLocation& first, std::vector<FoundServo>& found);
    base::Result<void> addOtherRates(const BusLocation& first, std::vector<FoundServo>& found);

    const device::Context& m_context;
    const CommissionSpec& m_spec;
    std::vector<int> m_likelyRates;
    std::vector<int> m_otherRates;
    std::size_t m_nextOtherRate = 0; ///< the rate that is searched next
    std::size_t m_scanRate = 0;
    int m_scanId = 0;
    bool m_hasReplied = false;         ///< a servo has replied
    bool m_expectsLateReplies = false; ///< a reply has come too late on this link
};
} // namespace jobs
