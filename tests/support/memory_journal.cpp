// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/memory_journal.h"

#include <algorithm>

namespace support {
namespace {
QString nameOf(const base::ServoIdentity& servo, const QString& name)
{
    return QStringLiteral("%1/%2.%3/%4.%5/%6")
        .arg(servo.id)
        .arg(servo.modelMajor)
        .arg(servo.modelMinor)
        .arg(servo.firmwareMajor)
        .arg(servo.firmwareMinor)
        .arg(name);
}
} // namespace

base::Result<void> MemoryJournal::writable() const
{
    if (m_failure)
        return base::fail(*m_failure, QStringLiteral("journal"));
    return {};
}

base::Result<QString> MemoryJournal::begin(const base::Intent& intent)
{
    if (const auto good = writable(); !good)
        return tl::unexpected(good.error());
    base::JournalEntry entry{intent, std::nullopt};
    entry.intent.uuid = QStringLiteral("intent-%1").arg(m_entries.size() + 1);
    entry.intent.at = QDateTime::currentDateTimeUtc();
    m_entries.push_back(entry);
    return entry.intent.uuid;
}

base::Result<void> MemoryJournal::end(const QString& uuid, const base::IntentResult& end)
{
    if (const auto good = writable(); !good)
        return good;
    const auto entry = std::find_if(m_entries.begin(), m_entries.end(),
                                    [&](const auto& e) { return e.intent.uuid == uuid; });
    if (entry == m_entries.end())
        return base::fail(base::ErrorCode::BadArgument, QStringLiteral("journal"), uuid);
    entry->end = end;
    return {};
}

base::Result<void> MemoryJournal::saveServoValues(const base::ServoIdentity& servo,
                                                  const QString& name,
                                                  const std::vector<std::int64_t>& values)
{
    if (const auto good = writable(); !good)
        return good;
    m_kept[nameOf(servo, name)] = values;
    return {};
}

base::Result<std::optional<std::vector<std::int64_t>>>
MemoryJournal::servoValues(const base::ServoIdentity& servo, const QString& name) const
{
    const auto found = m_kept.find(nameOf(servo, name));
    if (found == m_kept.end())
        return std::nullopt;
    return found->second;
}
} // namespace support
