// SPDX-License-Identifier: GPL-3.0-or-later
// The journal of one servo, as far as it can be distinguished from others of its kind: under the ID
// it has now since it got it or the one before it left, under the IDs it had before until it left
// them, and of a simulated servo only what was written on its own bus. Reads the journal; any
// thread; errors are the journal's.
#pragma once

#include "base/journal.h"

namespace session {
/// Oldest first, the latest `maxEntries` under each ID.
base::Result<std::vector<base::JournalEntry>>
servoHistory(const base::Journal& journal, const base::ServoIdentity& servo, int maxEntries);
} // namespace session
