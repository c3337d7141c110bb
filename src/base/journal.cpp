// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/journal.h"

#include "base/enum_names.h"

#include <algorithm>

namespace base {
namespace {
constexpr EnumName<IntentKind> kindNames[]{
    {IntentKind::Write, "write"},         {IntentKind::SetId, "set-id"},
    {IntentKind::SetBaud, "set-baud"},    {IntentKind::Mode, "mode"},
    {IntentKind::Calibrate, "calibrate"}, {IntentKind::Restore, "restore"},
    {IntentKind::Identify, "identify"},   {IntentKind::Trial, "trial"},
    {IntentKind::Undo, "undo"},
};

bool concerns(const Intent& intent, const ServoIdentity& identity)
{
    if (!intent.servo.isSameKind(identity))
        return false;
    const bool becomesThis = intent.kind == IntentKind::SetId && !intent.items.empty() &&
                             intent.items.front().newRaw == identity.id;
    return intent.servo.id == identity.id || becomesThis;
}
} // namespace

QString intentKindName(IntentKind kind)
{
    return nameOf(kindNames, kind);
}

std::optional<IntentKind> intentKindFromName(const QString& name)
{
    return valueOf(kindNames, name);
}

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

Result<std::vector<JournalEntry>> Journal::entriesFor(const ServoIdentity& servo,
                                                      int maxCount) const
{
    auto all = entries();
    if (!all)
        return all;
    std::vector<JournalEntry> matching;
    std::copy_if(all->begin(), all->end(), std::back_inserter(matching),
                 [&](const JournalEntry& entry) { return concerns(entry.intent, servo); });
    if (matching.size() > std::size_t(maxCount))
        matching.erase(matching.begin(), matching.end() - maxCount);
    return matching;
}
} // namespace base
