// SPDX-License-Identifier: GPL-3.0-or-later
// Which values may be in a servo's RAM only: a reading alone does not distinguish them from kept
// values. Based on the journal's entries for this servo's kind and ID; the job's thread.
// Not known: writes by another program, by this one with another data folder, or to the servo while
// it had another ID. A power cycle since then is not known either, but then writing the value once
// more changes nothing.
#pragma once

#include "base/journal.h"
#include "device/servo.h"

#include <map>
#include <vector>

namespace device {
/// By key, the value of each register whose last write was temporary, or may not have been kept.
/// Errors: those of the journal.
using TemporaryValues = std::map<QString, std::int64_t>;
base::Result<TemporaryValues> temporaryValues(const base::Journal& journal, const Servo& servo);
/// The same from the servo's entries, oldest first; any thread.
TemporaryValues temporaryValues(const std::vector<base::JournalEntry>& entries, const Servo& servo);

/// Whether the value the servo shows now is among them.
bool mayBeTemporary(const TemporaryValues& temporary, const QString& key,
                    std::optional<std::int64_t> now);
} // namespace device
