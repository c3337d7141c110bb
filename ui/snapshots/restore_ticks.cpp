// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/snapshots/restore_ticks.h"

namespace ui {
std::optional<jobs::RestorePlan> RestoreTicks::plan(const session::ServoEntry* entry,
                                                    session::ServoRef servo,
                                                    const snapshot::Snapshot* source, bool identity)
{
    const bool known = entry != nullptr && entry->hasFullTable && source != nullptr;
    if (!known) {
        source = nullptr;
        servo = 0;
    }
    if (source != m_source || servo != m_servo)
        m_ticks.clear();
    m_source = source;
    m_servo = servo;
    if (!known)
        return std::nullopt;
    jobs::RestoreChoice choice;
    choice.identity = identity;
    jobs::RestorePlan made = jobs::planRestore(entry->servo, *source, choice);
    jobs::selectTemporary(made, device::temporaryValues(entry->history, entry->servo), {});
    for (const auto& [key, on] : m_ticks)
        (void)made.setSelected(key, on);
    return made;
}

void RestoreTicks::remember(const jobs::RestorePlan& plan)
{
    for (const jobs::RestoreRow& row : plan.rows)
        m_ticks[row.key] = row.selected;
}
} // namespace ui
