// SPDX-License-Identifier: GPL-3.0-or-later
#include "protocol/request.h"
#include "sim/host/presets.h"

#include <QStringList>

namespace sim {
namespace {
tl::unexpected<base::Error> invalidFault(const QString& detail)
{
    return base::fail(base::ErrorCode::BadArgument, QStringLiteral("fault"), detail);
}

double* probability(FaultPlan& plan, const QString& name)
{
    if (name == QLatin1String("drop"))
        return &plan.drop;
    if (name == QLatin1String("corrupt"))
        return &plan.corrupt;
    if (name == QLatin1String("garbage"))
        return &plan.garbage;
    if (name == QLatin1String("late"))
        return &plan.late;
    if (name == QLatin1String("truncate"))
        return &plan.truncate;
    if (name == QLatin1String("drop-request"))
        return &plan.dropRequest;
    return nullptr;
}

base::Result<void> setFault(FaultPlan& plan, const QString& item, const QString& name,
                            const QString& value)
{
    bool ok = false;
    if (double* target = probability(plan, name)) {
        *target = value.toDouble(&ok);
        if (!ok || !(*target >= 0 && *target <= 1))
            return invalidFault(QStringLiteral("%1: a probability is 0 to 1").arg(item));
    } else if (name == QLatin1String("mute")) {
        const int id = value.toInt(&ok);
        if (!ok || id < 0 || id > protocol::maxId)
            return invalidFault(QStringLiteral("%1: an ID is 0 to 253").arg(item));
        plan.muteIds.push_back(id);
    } else if (name == QLatin1String("late-ms")) {
        const int span = value.toInt(&ok);
        if (!ok || span < 0)
            return invalidFault(QStringLiteral("%1: milliseconds expected").arg(item));
        plan.lateBy = std::chrono::milliseconds(span);
    } else {
        return invalidFault(
            QStringLiteral("%1: no such fault; known are drop, corrupt, garbage, late, "
                           "late-ms, truncate, drop-request, mute")
                .arg(item));
    }
    return {};
}
} // namespace

base::Result<FaultPlan> parseFaults(const QString& text)
{
    FaultPlan plan;
    for (const QString& part : text.split(QLatin1Char(','), Qt::SkipEmptyParts)) {
        const QString item = part.trimmed();
        const auto equals = item.indexOf(QLatin1Char('='));
        if (equals <= 0)
            return invalidFault(QStringLiteral("%1: expected NAME=VALUE").arg(item));
        if (auto set = setFault(plan, item, item.left(equals), item.mid(equals + 1)); !set)
            return tl::unexpected(set.error());
    }
    return plan;
}
} // namespace sim
