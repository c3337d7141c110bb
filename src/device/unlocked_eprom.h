// SPDX-License-Identifier: GPL-3.0-or-later
// Opening the EPROM lock for a while, and closing it with proof. The job's thread; a lock that
// cannot be closed is noted as LockLeftOpen. Source: lock rules of the Feetech and Modbus sheets.
#pragma once

#include "device/context.h"
#include "device/servo.h"

namespace device {
enum class LockState : std::uint8_t { Closed, Open, Unknown, None };
QString lockName(LockState lock); ///< "closed", "open", "unknown", "none"

/// Keeps the EPROM unlocked during its lifetime, for procedures that are more than register writes.
/// The destructor closes the lock. write() itself uses it.
class UnlockedEprom {
public:
    /// Open for the area of `reg` (factory rows have a value of their own). Where writes to `reg`
    /// are kept without a lock, there is nothing to open, and close() returns None.
    static base::Result<UnlockedEprom> open(const Context& context, Servo& servo,
                                            const catalog::Register& reg);
    UnlockedEprom(UnlockedEprom&& other) noexcept;
    UnlockedEprom(const UnlockedEprom&) = delete;
    UnlockedEprom& operator=(const UnlockedEprom&) = delete;
    UnlockedEprom& operator=(UnlockedEprom&&) = delete;
    ~UnlockedEprom();

    /// Locks at `servo` (whose ID may have changed meanwhile) and proves it by reading.
    LockState close();

    /// After close(): the lock was still open until then. If not, the servo has restarted meanwhile
    /// (a brown-out closes it), and what was written may be lost at power-off.
    bool stayedOpen() const { return m_stayedOpen; }

private:
    UnlockedEprom() = default;
    UnlockedEprom(const Context& context, Servo& servo, std::int64_t needed)
        : m_context(&context)
        , m_servo(&servo)
        , m_needed(needed)
    {}
    const Context* m_context = nullptr; ///< outlives this
    Servo* m_servo = nullptr;           ///< null: there is no lock to close
    std::int64_t m_needed = 0;          ///< what the lock register shows while open
    bool m_stayedOpen = false;
};

/// Closes the lock if its flag reads open for any area; None where the map has no lock.
LockState closeLock(const Context& context, Servo& servo);
} // namespace device
