// SPDX-License-Identifier: GPL-3.0-or-later
// Registers set for the duration of a job and restored at its end: gains that are tried out, the
// mode that a test needs. Written with the lock closed, so that the EPROM keeps its own values; one
// intent in the journal holds the old values until reading has proved that they are back, so that
// recovery (jobs/recover/recover.h) finds and restores them after a crash or a lost link. Writes no
// EPROM and saves nothing for later. Owned by the job, which must not outlive what it refers to;
// its thread. Errors: those of device::write before its first byte, NotSupported ("always-kept")
// where every write is kept, the first register that did not take its value.
#pragma once

#include "device/writer.h"

#include <memory>

namespace jobs {
class TemporarySettings {
public:
    using CreateResult = base::Result<std::unique_ptr<TemporarySettings>>;

    /// On an error the servo has its old values again, as far as it answers; see putBack().
    static CreateResult set(const device::Context& context, device::Servo& servo,
                            const std::vector<device::WriteItem>& items);
    /// The family's position mode. Torque is off afterwards. Null: the servo is in a mode with
    /// positions already. NotSupported ("not-position") where the family has no such mode.
    static CreateResult positionMode(const device::Context& context, device::Servo& servo);

    TemporarySettings(const TemporarySettings&) = delete;
    TemporarySettings& operator=(const TemporarySettings&) = delete;
    ~TemporarySettings(); ///< restores what is not restored yet

    /// Restores the old values, proven by reading, and may be called again. Stop does not prevent
    /// it, and a lost link is waited for. After an emergency stop gains are restored, but not a
    /// mode, because that would write the new mode's command. A mode is restored with torque off
    /// and that command at 0. Values that could not be restored are noted, and the intent stays
    /// open: LinkLost, NoReply, Preempted, Mismatch …
    base::Result<void> revert();

    /// The servo has restarted and loaded its own values: nothing is left to restore. If that
    /// cannot be recorded, it is noted.
    void forget();

    /// The registers that differ from before; empty: all had their new values already.
    const std::vector<base::JournalItem>& items() const { return m_items; }

private:
    TemporarySettings(const device::Context& context, device::Servo& servo, bool mode);
    static CreateResult create(const device::Context& context, device::Servo& servo,
                               const std::vector<device::WriteItem>& items, bool mode);
    base::Result<void> begin(const std::vector<device::WriteItem>& items);
    base::Result<void> write(const device::Context& context,
                             const std::vector<device::WriteItem>& items, bool allowPreviousValues,
                             bool& begun);
    base::Result<void> tryRevert();

    const device::Context m_context;
    device::Servo& m_servo;
    const bool m_mode;
    const std::uint64_t m_emergencyCount; ///< when it began
    std::vector<base::JournalItem> m_items;
    QString m_uuid; ///< of the open intent; empty: nothing to restore
};
} // namespace jobs
