// SPDX-License-Identifier: GPL-3.0-or-later
// The common steps of new ID, new rate, centering, restore and reboot. Internal to jobs.
#pragma once

#include "jobs/change/change.h"

namespace jobs {
/// PING, waited for as long as a reply may take on this link; true if a clean reply came from that
/// ID. Bytes that are no clean reply (collision, noise) are an error.
base::Result<bool> isAnswering(const device::Context& context, base::Protocol protocol, int id,
                               int retries = -1);

/// Is this ID free? Proven by silence that lasts as long as a reply may take on this link
/// (bus::Bus::maxReplyLateness), after each of the requests, of which one may be lost, and at the
/// end by one as long as any adapter may be late. A later reply still names its ID and counts. One
/// attempt is a guess only. Errors as isAnswering(), and Stopped.
base::Result<bool> isIdFree(const device::Context& context, base::Protocol protocol, int id,
                            int attempts = 3);

/// One write that is never repeated blindly. `lost` is true when its reply did not come.
struct SendResult {
    bool lost = false;
    int answeredBy = -1; ///< the ID in the acknowledgement
};
base::Result<SendResult> sendOnce(const device::Context& context, protocol::Request request);

/// An intent with the items known so far; its uuid.
base::Result<QString> beginIntent(const device::Context& context, const device::Servo& servo,
                                  base::IntentKind kind, std::vector<base::JournalItem> items);

/// Ends the intent as "done" or "failed" if nothing is unknown any more; leaves it open otherwise.
/// A failure to record it is noted.
void endIntent(const device::Context& context, const QString& uuid, int id, bool certain,
               bool good);
/// The same with the outcome of each item.
void endIntent(const device::Context& context, const QString& uuid,
               const device::WriteReport& report);

/// NotSupported with this detail when the servo's protocol has no such request. Before the first
/// byte.
base::Result<void> requireEncodable(const device::Servo& servo, const protocol::Request& request,
                                    const QString& operation, const QString& detail);

/// The result of a write that ended with `error`.
device::WriteResult failedResult(device::WriteResult result, const base::Error& error);

/// For a lock that had closed by itself: the servo restarted in the middle, or another one is here,
/// so the readings prove nothing and the outcome is unknown.
void markUncertain(device::WriteResult& result);

/// True when nothing is left open: every outcome is known and the lock is proven closed.
bool hasCertainOutcome(const device::WriteReport& report);
} // namespace jobs
