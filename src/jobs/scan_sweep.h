// SPDX-License-Identifier: GPL-3.0-or-later
// One rate and language of a scan: asks everybody at once where that is possible, then every ID
// with short patience, collects late replies, and asks again singly where something was heard. Used
// by scan() only; its thread.
#pragma once

#include "jobs/scan_manner.h"

#include <map>

namespace jobs {
/// What one ID has said at one rate.
struct Contact {
    int pings = 0;
    int replies = 0; ///< valid ones, late ones included
    int garbled = 0; ///< asked, and bytes came that were no reply
    bool late = false;
    bool maybeEcho = false; ///< what came late may have been the question itself
    std::uint8_t status = 0;
    base::Duration askedAt{};

    /// One broken answer may be noise; a second one at the same ID is somebody.
    bool present() const { return replies > 0 || garbled > 1; }
    bool twins() const { return replies > pings || (replies == 0 && garbled > 1); }
};

/// Of the question to all and of the sweep.
base::Duration questionEstimate(int baud, base::Protocol protocol);
base::Duration sweepEstimate(const ScanSpec& spec, int baud, base::Protocol protocol);

class RateSweep {
public:
    /// `onAsked` gets the planned time of every step of the sweep when it is done, and how many IDs
    /// have been heard so far.
    using OnAsked = std::function<void(base::Duration planned, int heard)>;
    /// Where one ID takes long, whoever answers in time is told while the sweep goes on; an error
    /// ends it.
    using OnAnswer = std::function<base::Result<void>(const RateSweep& sweep, int id)>;
    RateSweep(const device::Context& context, const ScanSpec& spec, base::Protocol protocol,
              OnAsked onAsked, OnAnswer onAnswer = {});

    /// The ID of a servo that answered the question to all and, asked by itself, once more. Errors
    /// as run().
    base::Result<std::optional<int>> askAll();
    /// Somebody answered the question to all, however badly: the sweep is worth while.
    bool heardSomebody() const { return m_heardSomebody; }

    /// Stopped, LinkLost, Preempted, Held; LineBusy where bytes that answer no request leave no
    /// room for a reply.
    base::Result<void> run();

    base::Protocol protocol() const { return m_protocol; }
    const std::map<int, Contact>& contacts() const { return m_contacts; }
    int lateReplies() const { return m_lateReplies; }
    /// The line never fell silent while IDs were asked.
    bool lineBusy() const { return m_lineBusy; }
    bool garbledUnexplained() const { return m_garbledUnexplained; }

private:
    struct Garble {
        int id = 0; ///< asked when the bytes came
        base::Duration at{};
    };

    base::Result<void> askEach();
    base::Result<void> confirmLate();
    base::Result<void> explainGarbles();
    base::Result<bool> findSource(const Garble& garble);
    base::Result<bool> askUntilKnown(int id, bool persistent);
    base::Result<void> askExpected();
    base::Result<void> askSilent();
    base::Result<void> ask(int id, base::Duration patience);
    base::Result<bus::Outcome> question(int id, base::Duration patience);
    base::Result<void> listen(base::Duration span);
    base::Result<void> noteBusy(Contact& contact, const base::Error& error);
    void collectStrays();
    void tell(base::Duration planned) const;

    const device::Context& m_context;
    const ScanSpec& m_spec;
    base::Protocol m_protocol;
    const Manner& m_manner;
    IdRange m_ids;
    OnAsked m_onAsked;
    OnAnswer m_onAnswer;
    std::map<int, Contact> m_contacts;
    std::vector<Garble> m_garbles; ///< heard while all IDs were asked
    int m_lateReplies = 0;
    bool m_garbledUnexplained = false;
    bool m_heardSomebody = false;
    bool m_lineBusy = false;
};
} // namespace jobs
