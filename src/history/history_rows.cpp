// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/history_rows.h"

#include <array>

namespace record {
namespace {
struct ReasonName {
    SnapshotReason reason;
    QLatin1String name;
};

constexpr std::array reasonNames{
    ReasonName{SnapshotReason::Automatic, QLatin1String("automatic")},
    ReasonName{SnapshotReason::Manual, QLatin1String("asked")},
    ReasonName{SnapshotReason::Bundle, QLatin1String("bundle")},
    ReasonName{SnapshotReason::Commission, QLatin1String("commission")},
};
} // namespace

QString snapshotReasonName(SnapshotReason reason)
{
    for (const ReasonName& entry : reasonNames) {
        if (entry.reason == reason)
            return entry.name;
    }
    Q_UNREACHABLE();
}

std::optional<SnapshotReason> snapshotReasonFromName(const QString& name)
{
    for (const ReasonName& entry : reasonNames) {
        if (name == entry.name)
            return entry.reason;
    }
    return std::nullopt;
}

bool HistoryWrite::isGood() const
{
    return outcome == QLatin1String("kept") || outcome == QLatin1String("temporary") ||
           outcome == QLatin1String("done") || outcome == QLatin1String("undone");
}
} // namespace record
