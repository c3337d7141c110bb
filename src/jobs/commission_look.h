// SPDX-License-Identifier: GPL-3.0-or-later
// Who is on the wire of a commissioning line? Short rounds over the likely rates find a factory
// servo within a fraction of a second; before anything is done to it, everybody is asked. Sends
// nothing but PINGs and READs. Internal to jobs; its thread. Errors: LinkLost, Stopped, Preempted,
// Held, RateUnsupported.
#pragma once

#include "jobs/commission.h"
#include "jobs/scan.h"

namespace jobs {
constexpr int factoryId = 1;

class CommissionLook {
public:
    CommissionLook(const device::Context& context, const CommissionSpec& spec);

    struct Place {
        base::Protocol protocol = base::Protocol::Feetech;
        int id = -1; ///< −1: the answer was broken
        int baud = 0;
    };

    /// One round; the first that is heard ends it. `known` are asked first.
    base::Result<std::optional<Place>> round(const std::vector<Place>& known);

    /// All that can be heard once `first` was: every ID at its rate and at the one it is to get,
    /// the usual ones elsewhere.
    base::Result<std::vector<Found>> everybody(const Place& first);

    /// As before every write: more thorough than a search is.
    base::Result<bool> twins(const device::Servo& servo);

    /// Does somebody answer there, with patience? Leaves the bus at that rate.
    base::Result<bool> present(const Place& place);

private:
    enum class Voice { Silent, Clean, Broken };
    struct Answer {
        Voice voice = Voice::Silent;
        int id = -1;
    };
    base::Result<Answer> ask(base::Protocol protocol, int id, base::Duration patience) const;
    base::Result<bool> tune(int baud) const; ///< false: the adapter cannot
    std::vector<base::Protocol> languages(int baud) const;
    base::Result<std::optional<Place>> quickly(int baud);
    base::Result<std::optional<Place>> questions(base::Protocol protocol,
                                                 const std::vector<int>& ids, int baud);
    std::optional<Place> lateAnswer(const std::vector<bus::Stray>& strays, base::Protocol protocol,
                                    int baud) const;
    base::Result<std::optional<Place>> slowly();
    base::Result<void> addAlone(const Place& first, std::vector<Found>& found);
    base::Result<void> addElsewhere(const Place& first, std::vector<Found>& found);

    const device::Context& m_context;
    const CommissionSpec& m_spec;
    std::vector<int> m_likely;
    std::vector<int> m_others;
    std::size_t m_other = 0; ///< whose turn it is
    std::size_t m_sweptRate = 0;
    int m_sweptId = 0;
    bool m_heard = false;      ///< a servo has answered
    bool m_awaitsLate = false; ///< something has come after its time on this link
};
} // namespace jobs
