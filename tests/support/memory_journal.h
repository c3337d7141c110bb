// SPDX-License-Identifier: GPL-3.0-or-later
// A journal that lives as long as the test: outlasts reconnects and power cycles of the bench, as
// the file does. Can be set to refuse, as with a full disk. One thread.
#pragma once

#include "base/journal.h"

#include <map>

namespace support {
class MemoryJournal final : public base::Journal {
public:
    base::Result<QString> begin(const base::Intent& intent) override;
    base::Result<void> end(const QString& uuid, const base::IntentResult& end) override;
    base::Result<std::vector<base::JournalEntry>> entries() const override { return m_entries; }
    base::Result<void> saveServoValues(const base::ServoIdentity& servo, const QString& name,
                                       const std::vector<std::int64_t>& values) override;
    base::Result<std::optional<std::vector<std::int64_t>>>
    servoValues(const base::ServoIdentity& servo, const QString& name) const override;

    /// From now on every record fails with this code; nullopt: works again.
    void setError(std::optional<base::ErrorCode> code) { m_failure = code; }

private:
    base::Result<void> writable() const;

    std::vector<base::JournalEntry> m_entries;
    std::map<QString, std::vector<std::int64_t>> m_kept;
    std::optional<base::ErrorCode> m_failure;
};
} // namespace support
