// SPDX-License-Identifier: GPL-3.0-or-later
// Which servos of the list reply, and whether they are still the ones that were identified: a servo
// can be exchanged on the open line, and its ID does not tell. Owned by the workbench; main thread;
// identification runs on the search thread.
#pragma once

#include "session/servos/servo_registry.h"

#include <set>

namespace session {
class Workbench;
struct Work;

class PresenceMonitor final : public QObject {
    Q_OBJECT

public:
    explicit PresenceMonitor(Workbench& bench);

    bool isIdentifying() const { return !m_identifying.empty(); }
    void reset()
    {
        m_counters.clear();
        m_askUntil = {};
    }
    void update(); ///< counts replies of the open port
    /// The port was open before: no servo counts as present until it has replied. Those of the
    /// port's rate are asked for a while, until they do.
    void askAll();
    void identifyReturned();
    void replace(ServoRef ref, const jobs::FoundServo& now);
    void suspectReplacement(const Work& ended);

private:
    struct ReplyCounters { ///< of one ID
        std::uint64_t ok = 0;
        std::uint64_t missed = 0; ///< when it last replied, or was last not counted
    };
    void reidentify(ServoRef ref);
    void reidentified(ServoRef ref, const base::Result<device::Servo>& now);

    Workbench& m_bench;
    std::map<int, ReplyCounters> m_counters; ///< by ID, when the bus was looked at last
    std::set<ServoRef> m_identifying;        ///< on the search thread
    base::Duration m_askUntil{};
    base::Duration m_nextAsk{};
};
} // namespace session
