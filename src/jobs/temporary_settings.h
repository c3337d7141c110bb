// SPDX-License-Identifier: GPL-3.0-or-later
// Registers set for the length of a job and put back at its end: gains that are tried out, the mode
// a test needs. Written with the lock closed, so that the EPROM keeps its own values; one intent in
// the journal holds the values before until reading has proved that they are back, so that after a
// crash or a lost link recovery (jobs/recover.h) finds and restores them. Writes no EPROM and no
// lasting fact. Owned by the job, which outlives nothing it borrows; its thread.
// Errors: those of device::write before its first byte, NotSupported ("always-kept") where every
// write is kept, the first register that did not take its value.
#pragma once

#include "device/writer.h"

#include <memory>

namespace jobs {
class TemporarySettings {
public:
    using CreateResult = base::Result<std::unique_ptr<TemporarySettings>>;

    /// On an error the servo is as it was, as far as it answers; see putBack().
    static CreateResult set(const device::Context& context, device::Servo& servo,
                            const std::vector<device::WriteItem>& items);
    /// The family's position mode. Torque is off afterwards. Null: the servo is in a mode with
    /// positions already. NotSupported ("not-position") where the family has no such mode.
    static CreateResult positionMode(const device::Context& context, device::Servo& servo);

    TemporarySettings(const TemporarySettings&) = delete;
    TemporarySettings& operator=(const TemporarySettings&) = delete;
    ~TemporarySettings(); ///< puts back what is not back yet

    /// The values before, proven by reading; again and again if need be. Stop does not keep it from
    /// that, and a link that is away is waited for. After an emergency stop gains go back, but not
    /// a mode: that would write the new mode's command. A mode goes back with torque off and that
    /// command at 0. What could not be put back is noted, and its intent stays open: LinkLost,
    /// NoReply, Preempted, Mismatch …
    base::Result<void> revert();

    /// The servo has restarted and loaded its own values: nothing is owed any more. Where that
    /// cannot be recorded it is noted.
    void forget();

    /// What differs from before; empty: everything was so already.
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
    QString m_uuid; ///< of the open intent; empty: nothing is owed
};
} // namespace jobs
