// SPDX-License-Identifier: GPL-3.0-or-later
// The safe write, the only way a register is changed: check everything before the first byte,
// journal, torque off where asked, unlock, write, wait, read back, lock, prove the lock. On every
// path out the lock is closed again, or LockLeftOpen is noted and the intent stays open.
#pragma once

#include "device/reader.h"

namespace device {
/// The six words for how a register ended, everywhere.
enum class WriteOutcome : std::uint8_t { Kept, Temporary, Mismatch, Refused, NoAnswer, Unknown };
QString outcomeName(WriteOutcome outcome); ///< "kept", "temporary", … "no-answer", "unknown"

enum class LockState : std::uint8_t { Closed, Open, Unknown, None };
QString lockName(LockState lock); ///< "closed", "open", "unknown", "none"

struct WriteItem {
    QString key;
    std::int64_t raw = 0;
};

struct WriteResult {
    QString key;
    int address = 0;
    std::optional<std::int64_t> oldRaw;
    std::int64_t newRaw = 0;
    std::optional<std::int64_t> readBack;
    WriteOutcome outcome = WriteOutcome::Unknown;
    std::optional<base::Error> error;
};

struct WriteReport {
    int id = -1;
    std::vector<WriteResult> writes;
    LockState lock = LockState::None;
    bool allGood() const; ///< every outcome is kept or temporary, and the lock is not open
};

struct WriteOptions {
    bool temporary = false; ///< the lock stays closed: acts at once, lost at power-off
    bool dangerous = false; ///< the user's consent to dangerous registers
    base::IntentKind kind = base::IntentKind::Write;
};

/// Errors (nothing was written): UnknownRegister, ReadOnly, OutOfRange, NeedsConsent, NotSupported,
/// FileUnwritable/DiskFull (journal), NoAnswer … of the reads before. Otherwise a report, whatever
/// happened. ID and baud rate are not written here: see jobs/change_id.h and change_baud.h.
base::Result<WriteReport> write(const Context& context, Servo& servo,
                                const std::vector<WriteItem>& items, const WriteOptions& options);

/// One EPROM-unlocked stretch, for manoeuvres that are more than register writes. The destructor
/// closes the lock. Used by write() itself.
class UnlockedEprom {
public:
    static base::Result<UnlockedEprom> open(const Context& context, Servo& servo);
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
    UnlockedEprom(const Context& context, Servo& servo)
        : m_context(&context)
        , m_servo(&servo)
    {}
    const Context* m_context = nullptr; ///< outlives this
    Servo* m_servo = nullptr;
    bool m_stayedOpen = false;
};

/// Closes the lock if its flag reads open; LockState::None where the map has no lock.
LockState closeLock(const Context& context, Servo& servo);
} // namespace device
