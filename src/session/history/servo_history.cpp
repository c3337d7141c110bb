// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/history/servo_history.h"

#include <algorithm>

namespace session {
namespace {
constexpr int maxMoves = 16; ///< from ID to ID that are followed

using Entries = std::vector<base::JournalEntry>;

/// Simulated servos of two buses are never the same, however alike they are.
bool isSameBus(const base::ServoIdentity& a, const base::ServoIdentity& b)
{
    const QLatin1StringView simulated("sim:");
    return !(a.port.startsWith(simulated) || b.port.startsWith(simulated)) || a.port == b.port;
}

/// The change of ID by which it came to the one it has.
Entries::const_iterator arrivalIn(const Entries& entries, int id)
{
    const auto found =
        std::find_if(entries.rbegin(), entries.rend(), [id](const base::JournalEntry& entry) {
            const base::Intent& intent = entry.intent;
            return intent.kind == base::IntentKind::SetId && intent.servo.id != id && entry.end &&
                   entry.end->outcome == QLatin1StringView("done") && !intent.items.empty() &&
                   intent.items.front().newRaw == id;
        });
    return found == entries.rend() ? entries.end() : std::prev(found.base());
}
/// After the last servo that had this ID has left it: what is here now came later.
Entries::const_iterator afterDeparture(const Entries& entries, Entries::const_iterator from, int id)
{
    for (auto entry = entries.end(); entry != from;) {
        --entry;
        const base::Intent& intent = entry->intent;
        if (intent.kind == base::IntentKind::SetId && intent.servo.id == id && entry->end &&
            entry->end->outcome == QLatin1StringView("done") && !intent.items.empty() &&
            intent.items.front().newRaw != id)
            return std::next(entry);
    }
    return from;
}
} // namespace

base::Result<std::vector<base::JournalEntry>>
servoHistory(const base::Journal& journal, const base::ServoIdentity& servo, int maxEntries)
{
    Entries history;
    base::ServoIdentity identity = servo;
    std::optional<QDateTime> until; ///< it left this ID then
    for (int moves = 0; moves < maxMoves; ++moves) {
        auto own = journal.entriesFor(identity, maxEntries);
        if (!own)
            return tl::unexpected(own.error());
        std::erase_if(*own, [&](const base::JournalEntry& entry) {
            return !isSameBus(entry.intent.servo, servo) || (until && entry.intent.at >= *until);
        });
        const auto arrival = arrivalIn(*own, identity.id);
        const bool came = arrival != own->cend();
        const auto first = came ? arrival : own->cbegin();
        const auto from = afterDeparture(*own, first, identity.id);
        const bool moved = came && from == first;
        const int before = moved ? arrival->intent.servo.id : identity.id;
        if (moved)
            until = arrival->intent.at;
        // What was written to this ID before it came was another servo's.
        history.insert(history.begin(), from, own->cend());
        if (!moved)
            break;
        identity.id = before;
    }
    return history;
}
} // namespace session
