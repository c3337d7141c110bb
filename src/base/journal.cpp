// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/journal.h"

#include <algorithm>
#include <array>

namespace base {
namespace {
struct KindName {
    IntentKind kind;
    QLatin1String name;
};

constexpr std::array kindNames{
    KindName{IntentKind::Write, QLatin1String("write")},
    KindName{IntentKind::SetId, QLatin1String("set-id")},
    KindName{IntentKind::SetBaud, QLatin1String("set-baud")},
    KindName{IntentKind::Mode, QLatin1String("mode")},
    KindName{IntentKind::Calibrate, QLatin1String("calibrate")},
    KindName{IntentKind::Restore, QLatin1String("restore")},
    KindName{IntentKind::Identify, QLatin1String("identify")},
    KindName{IntentKind::Trial, QLatin1String("trial")},
    KindName{IntentKind::Undo, QLatin1String("undo")},
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
    for (const KindName& entry : kindNames) {
        if (entry.kind == kind)
            return entry.name;
    }
    Q_UNREACHABLE();
}

std::optional<IntentKind> intentKindFromName(const QString& name)
{
    for (const KindName& entry : kindNames) {
        if (name == entry.name)
            return entry.kind;
    }
    return std::nullopt;
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
