// SPDX-License-Identifier: GPL-3.0-or-later
#include "device/temporary_values.h"

#include "device/persistence.h"

#include <algorithm>

namespace device {
namespace {
constexpr int maxJournalEntries = 1000;

/// The servo took what it had stored itself (0x06), so no value was known beforehand.
bool restoredUnchanged(const base::Intent& intent)
{
    return intent.kind == base::IntentKind::Restore &&
           std::none_of(intent.items.begin(), intent.items.end(),
                        [](const auto& item) { return item.oldRaw != item.newRaw; });
}

/// Follows one register through the entries.
class JournalReplay {
public:
    JournalReplay(TemporaryValues& values, const base::JournalEntry& entry)
        : m_values(values)
        , m_entry(entry)
    {}

    void apply(const base::JournalItem& item)
    {
        const base::ItemResult* end = endOf(item.key);
        const QString outcome = end != nullptr ? end->outcome
                                : m_entry.end  ? m_entry.end->outcome
                                               : QString();
        if (equals(outcome, "refused") || equals(outcome, "not-sent"))
            return;
        const std::int64_t shown = end != nullptr && end->readBack ? *end->readBack : item.newRaw;
        const bool temporary = m_entry.intent.temporary;
        if (equals(outcome, "undone")) {
            if (!temporary) // a value restored permanently has been written with the lock open
                m_values.erase(item.key);
            return;
        }
        if (!temporary && (equals(outcome, "kept") || equals(outcome, "done"))) {
            if (!restoredUnchanged(m_entry.intent) || shown != item.oldRaw)
                m_values.erase(item.key);
            return;
        }
        m_values[item.key] = shown;
    }

private:
    static bool equals(const QString& outcome, const char* word)
    {
        return outcome == QLatin1String(word);
    }
    const base::ItemResult* endOf(const QString& key) const
    {
        if (!m_entry.end)
            return nullptr;
        const auto& items = m_entry.end->items;
        const auto found = std::find_if(items.begin(), items.end(),
                                        [&](const auto& item) { return item.key == key; });
        return found == items.end() ? nullptr : &*found;
    }

    TemporaryValues& m_values;
    const base::JournalEntry& m_entry;
};
} // namespace

base::Result<TemporaryValues> temporaryValues(const base::Journal& journal, const Servo& servo)
{
    const auto entries = journal.entriesFor(servo.identity(), maxJournalEntries);
    if (!entries)
        return tl::unexpected(entries.error());
    return temporaryValues(*entries, servo);
}

TemporaryValues temporaryValues(const std::vector<base::JournalEntry>& entries, const Servo& servo)
{
    TemporaryValues values;
    for (const base::JournalEntry& entry : entries) {
        JournalReplay replay(values, entry);
        for (const base::JournalItem& item : entry.intent.items) {
            const catalog::Register* reg = servo.profile->find(item.key);
            if (reg != nullptr && isPersistent(*reg) && retentionOf(*reg) != Retention::Always)
                replay.apply(item);
        }
    }
    return values;
}

bool mayBeTemporary(const TemporaryValues& temporary, const QString& key,
                    std::optional<std::int64_t> now)
{
    const auto found = temporary.find(key);
    return found != temporary.end() && now == found->second;
}
} // namespace device
