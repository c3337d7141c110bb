// SPDX-License-Identifier: GPL-3.0-or-later
// What every operation on a servo needs: the bus, the journal, the user's stop request and a list
// for notices. Borrowed references for the duration of one job; the job's thread only.
#pragma once

#include "base/journal.h"
#include "base/stop_token.h"
#include "bus/bus.h"
#include "catalog/catalog.h"
#include "device/notice.h"

#include <functional>

namespace device {
struct Context {
    bus::Bus& bus;
    const catalog::Catalog& catalog;
    base::Journal& journal;
    const base::StopToken& stop;
    Notices& notices;
    bus::Priority priority = bus::Priority::Job;
    std::uint64_t hold = 0; ///< token of the bus::Hold that owns the servos for this work
    /// bus::Bus::emergencies() when the work was requested: after a later one nothing is started.
    std::optional<std::uint64_t> epoch{};
    /// Part of an emergency stop: writes without checking for a second servo on the ID.
    bool emergencyStop = false;
    /// Believes silence only after a stall of this computer is excluded; not for those who ask many
    /// absent servos again and again.
    bool patient = true;

    /// The same work, inside a hold.
    Context within(const bus::Hold& owned) const
    {
        return {bus,      catalog,       journal, stop,          notices,
                priority, owned.token(), epoch,   emergencyStop, patient};
    }

    void note(NoticeCode code, int id, QString key = {}, std::int64_t a = 0,
              std::int64_t b = 0) const
    {
        notices.push_back({code, id, std::move(key), a, b});
    }

    /// Ends the intent of a change that was made. False when that cannot be recorded: the change is
    /// still reported, with a notice, and the intent stays open.
    bool record(const QString& uuid, int id, const base::IntentResult& end) const
    {
        const auto ended = journal.end(uuid, end);
        if (!ended)
            note(NoticeCode::NotRecorded, id, ended.error().detail);
        return ended.has_value();
    }
};

/// A context that owns its servos, together with the hold. An operation inside another one uses the
/// outer hold: taking it twice would wait for itself.
struct Owned {
    bus::Hold hold;
    Context context;
};

/// Empty `ids`: the whole bus.
inline Owned own(const Context& outer, const std::vector<int>& ids)
{
    if (outer.hold != 0)
        return {bus::Hold(), outer};
    bus::Hold hold = outer.bus.hold(ids, outer.epoch);
    Context inner = outer.within(hold);
    return {std::move(hold), inner};
}
} // namespace device
