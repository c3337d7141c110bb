// SPDX-License-Identifier: GPL-3.0-or-later
#include "history/history_rows.h"

#include "base/enum_names.h"

namespace history {
namespace {
constexpr base::EnumName<SnapshotReason> reasonNames[]{
    {SnapshotReason::Automatic, "automatic"},
    {SnapshotReason::Manual, "asked"},
    {SnapshotReason::Bundle, "bundle"},
    {SnapshotReason::Commission, "commission"},
};
} // namespace

QString snapshotReasonName(SnapshotReason reason)
{
    return base::nameOf(reasonNames, reason);
}

std::optional<SnapshotReason> snapshotReasonFromName(const QString& name)
{
    return base::valueOf(reasonNames, name);
}

bool isSuccess(const QString& outcome)
{
    return outcome == QLatin1String("kept") || outcome == QLatin1String("temporary") ||
           outcome == QLatin1String("done") || outcome == QLatin1String("undone");
}
} // namespace history
