// SPDX-License-Identifier: GPL-3.0-or-later
// The safe write, the only way to change a register: check everything before the first byte,
// journal, torque off where required, unlock, write, wait, read back, save where the family has a
// command for it, lock, prove the lock. On every path out the lock is closed again, or LockLeftOpen
// is noted and the intent stays open. Registers that travel as a block are read, changed and
// written as one, so changing the minimum never disturbs the maximum.
#pragma once

#include "device/consent.h"
#include "device/reader.h"
#include "device/unlocked_eprom.h"

#include <functional>

namespace device {
/// The result of writing a register. NotSent: the write was never sent; Refused: it was sent, and
/// the servo did not take it.
enum class WriteOutcome : std::uint8_t {
    Kept,
    Temporary,
    Mismatch,
    Refused,
    NotSent,
    NoReply,
    Unknown
};
QString outcomeName(WriteOutcome outcome); ///< "kept", "temporary", … "no-answer", "unknown"
/// For a register that was not written because of `why`: Refused only where the servo itself
/// refused a step before it.
WriteOutcome outcomeBeforeSending(const base::Error& why);
/// The servo still has its old value.
inline bool isUntouched(WriteOutcome outcome)
{
    return outcome == WriteOutcome::Refused || outcome == WriteOutcome::NotSent;
}

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
    QString openIntent;        ///< uuid of the intent that stays open; empty: its end is recorded
    bool isSuccessful() const; ///< every outcome is kept or temporary, and the lock is not open
    std::vector<base::ItemResult> itemResults() const; ///< as the journal keeps it
};

struct WriteOptions {
    /// The lock stays closed, nothing is saved: acts at once, lost at power-off. NotSupported
    /// ("always-kept") where every write is kept.
    bool temporary = false;
    Consent consent{}; ///< to dangerous registers
    base::IntentKind kind = base::IntentKind::Write;
    /// Allows values that this servo had before: outside the documented range, or a pair in the
    /// wrong order.
    bool allowPreviousValues = false;
    /// Turns torque off before anything is written, even if no register requires it; it stays off.
    bool torqueOff = false;
    /// Writes the items as given, not by address; neighbors in the list still share a frame, and
    /// the lock is opened once for each run of items of one area.
    bool keepOrder = false;
    /// Stops at the first register that does not take its value; the rest is not sent
    /// ("after-failure").
    bool stopOnFailure = false;
    /// After each register that was written and read back.
    std::function<void(std::size_t done, std::size_t total)> onProgress{};
};

/// Errors (nothing was written): UnknownRegister, ReadOnly, OutOfRange, NeedsConsent, NotSupported,
/// FileUnwritable/DiskFull (journal), NoReply … of the reads before. Otherwise a report in
/// every case. ID and baud rate are not written here: see jobs/change/change.h.
base::Result<WriteReport> write(const Context& context, Servo& servo,
                                const std::vector<WriteItem>& items, const WriteOptions& options);
} // namespace device
