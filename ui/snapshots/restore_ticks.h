// SPDX-License-Identifier: GPL-3.0-or-later
// The ticks that the user has set on the rows of a restore. The plan is made anew whenever the
// servo has been read; the ticks stay while servo and snapshot are the same. A value of the restore
// panel; main thread.
#pragma once

#include "jobs/restore/restore_plan.h"
#include "session/servos/servo_entry.h"

#include <map>

namespace ui {
class RestoreTicks {
public:
    /// The plan with the ticks of the user. Without a servo or a source, or while the whole table
    /// has not been read: none, and the ticks are forgotten.
    std::optional<jobs::RestorePlan> plan(const session::ServoEntry* entry, session::ServoRef servo,
                                          const snapshot::Snapshot* source, bool identity);
    void remember(const jobs::RestorePlan& plan);
    void forget(const QString& key) { m_ticks.erase(key); }

private:
    std::map<QString, bool> m_ticks;              ///< by register
    const snapshot::Snapshot* m_source = nullptr; ///< that the ticks are about; only compared
    session::ServoRef m_servo = 0;
};
} // namespace ui
