// SPDX-License-Identifier: GPL-3.0-or-later
// Who is on the wire of a commissioning line? Short rounds over the likely rates find a factory
// servo within a fraction of a second; before anything is done to it, everybody is asked. Sends
// nothing but PINGs and READs. Internal to jobs; its thread. Errors: LinkLost, Stopped, Preempted,
// Held, RateUnsupported.
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
        int id = -1; ///< −1: the answer was broken
        int baud = 0;
    };

    /// One round; the first that is heard ends it. `known` are asked first.
    base::Result<std::optional<BusLocation>> scanRound(const std::vector<BusLocation>& known);

    /// All that can be heard once `first` was: every ID at its rate and at the one it is to get,
    /// the usual ones elsewhere.
    base::Result<std::vector<FoundServo>> findAll(const BusLocation& first);

    /// As before every write: more thorough than a search is.
    base::Result<bool> hasDuplicateId(const device::Servo& servo);

    /// Does somebody answer there, with patience? Leaves the bus at that rate.
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
    std::size_t m_nextOtherRate = 0; ///< whose turn it is
    std::size_t m_scanRate = 0;
    int m_scanId = 0;
    bool m_hasReplied = false;         ///< a servo has answered
    bool m_expectsLateReplies = false; ///< something has come after its time on this link
};
} // namespace jobs
