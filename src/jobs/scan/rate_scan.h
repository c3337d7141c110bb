// SPDX-License-Identifier: GPL-3.0-or-later
// One rate and protocol of a scan: sends a broadcast where that is possible, then asks every ID
// with a short timeout, collects late replies, and asks again singly where bytes came. Used by
// scan() only; its thread.
#pragma once

#include "jobs/scan/scan_profile.h"

#include <map>

namespace jobs {
/// The replies of one ID at one rate.
struct IdResponse {
    int pings = 0;
    int replies = 0; ///< valid ones, late ones included
    int garbled = 0; ///< pings after which bytes came that were no reply
    bool late = false;
    bool isMaybeEcho = false; ///< the late frame may have been the echo of the request
    std::uint8_t status = 0;
    base::Duration askedAt{};

    /// One broken reply may be noise; a second one at the same ID is a servo.
    bool isPresent() const { return replies > 0 || garbled > 1; }
    bool hasDuplicateId() const { return replies > pings || (replies == 0 && garbled > 1); }
};

/// Of the broadcast, and of the search ID by ID.
base::Duration broadcastEstimate(int baud, base::Protocol protocol);
base::Duration idScanEstimate(const ScanSpec& spec, int baud, base::Protocol protocol);

class RateScan {
public:
    /// `onPinged` gets the planned time of every completed step of the search, and how many IDs
    /// have answered so far.
    using OnPinged = std::function<void(base::Duration planned, int foundCount)>;
    /// Where one ID takes long, a servo that answers in time is reported during the search; an
    /// error ends it.
    using OnReply = std::function<base::Result<void>(const RateScan& sweep, int id)>;
    RateScan(const device::Context& context, const ScanSpec& spec, base::Protocol protocol,
             OnPinged onPinged, OnReply onReply = {});

    /// The ID of a servo that answered the broadcast and then a PING of its own. Errors as run().
    base::Result<std::optional<int>> pingBroadcast();
    /// Some reply came to the broadcast, even a broken one: the search is worth its time.
    bool hasReply() const { return m_hasReply; }

    /// Stopped, LinkLost, Preempted, Held; LineBusy where bytes that answer no request leave no
    /// room for a reply.
    base::Result<void> run();

    base::Protocol protocol() const { return m_protocol; }
    const std::map<int, IdResponse>& responsesById() const { return m_responsesById; }
    int lateReplies() const { return m_lateReplies; }
    /// The line never fell silent while IDs were asked.
    bool isLineBusy() const { return m_lineBusy; }
    bool hasUnexplainedGarbled() const { return m_hasUnexplainedGarbled; }

private:
    struct GarbledReply {
        std::optional<int> id; ///< asked when the bytes came; none: they came after a request
        base::Duration at{};
    };

    base::Result<void> pingEachId();
    base::Result<void> listenForLateReplies();
    base::Result<void> confirmLateReplies();
    base::Result<void> resolveGarbled();
    base::Result<bool> findSource(const GarbledReply& garbledReply);
    std::vector<std::pair<base::Duration, int>> candidates(const GarbledReply& garbledReply,
                                                           base::Duration window) const;
    base::Result<bool> pingUntilKnown(int id, bool persistent, base::Duration timeout);
    base::Result<void> pingExpected();
    base::Result<void> pingSilent();
    base::Result<void> ping(int id, base::Duration timeout);
    base::Result<void> dropLateReplies();
    base::Result<bus::Outcome> sendPing(int id, base::Duration timeout);
    base::Result<void> listen(base::Duration span);
    base::Result<void> handleBusyLine(IdResponse& response, const base::Error& error);
    void collectStrays();
    void notify(base::Duration planned) const;

    const device::Context& m_context;
    const ScanSpec& m_spec;
    base::Protocol m_protocol;
    const ScanProfile& m_scanProfile;
    IdRange m_ids;
    OnPinged m_onPinged;
    OnReply m_onReply;
    std::map<int, IdResponse> m_responsesById;
    std::vector<GarbledReply> m_garbledReplies; ///< received while all IDs were asked
    int m_lateReplies = 0;
    bool m_hasUnexplainedGarbled = false;
    bool m_hasReply = false;
    bool m_lineBusy = false;
};
} // namespace jobs
