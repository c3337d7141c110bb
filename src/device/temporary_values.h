// SPDX-License-Identifier: GPL-3.0-or-later
// Which values may stand in a servo's RAM only: a reading alone does not tell them from those that
// it keeps. What the journal knows of this servo's kind and ID; the job's thread.
// Cannot be known: what another program has written, or this one with another data folder, or to
// the servo while it had another ID. A power cycle since is not known either, but then writing the
// value once more only writes what is there.
#pragma once

#include "base/journal.h"
#include "device/servo.h"

#include <map>
#include <vector>

namespace device {
/// By key, the value of each register that was last written to last until power-off, or by a write
/// of which it is not known whether it was kept. Errors: those of the journal.
using TemporaryValues = std::map<QString, std::int64_t>;
base::Result<TemporaryValues> temporaryValues(const base::Journal& journal, const Servo& servo);
/// Of the servo's entries, oldest first; any thread.
TemporaryValues temporaryValues(const std::vector<base::JournalEntry>& entries, const Servo& servo);

/// Whether the servo reads this value now and it is among them.
bool mayBeTemporary(const TemporaryValues& temporary, const QString& key,
                    std::optional<std::int64_t> now);
} // namespace device
