// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/journal.h"

namespace base {
Result<std::vector<Intent>> Journal::open() const
{
    const auto all = entries();
    if (!all)
        return tl::unexpected(all.error());
    std::vector<Intent> intents;
    for (const JournalEntry& entry : *all) {
        if (!entry.end)
            intents.push_back(entry.intent);
    }
    return intents;
}
} // namespace base
