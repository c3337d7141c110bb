// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/firmware_update.h"

#include "base/enum_names.h"

#include <QStringList>

namespace base {
namespace {
constexpr EnumName<FirmwareCheck> checkNames[] = {
    {FirmwareCheck::OtherServos, "other-servos"}, {FirmwareCheck::FileName, "file-name"},
    {FirmwareCheck::FileSize, "file-size"},       {FirmwareCheck::Supply, "supply"},
    {FirmwareCheck::SavedTable, "saved-table"},   {FirmwareCheck::Battery, "battery"},
};
constexpr EnumName<FirmwareOutcome> outcomeNames[] = {
    {FirmwareOutcome::Updated, "updated"},
    {FirmwareOutcome::Unchanged, "unchanged"},
    {FirmwareOutcome::Incomplete, "incomplete"},
    {FirmwareOutcome::Unknown, "unknown"},
};
} // namespace

QString firmwareCheckName(FirmwareCheck check)
{
    return nameOf(checkNames, check);
}

std::optional<FirmwareCheck> firmwareCheckOf(const QString& name)
{
    return valueOf(checkNames, name);
}

QStringList firmwareCheckNames()
{
    QStringList names;
    for (const auto& row : checkNames)
        names << QLatin1StringView(row.name);
    return names;
}

QString firmwareOutcomeName(FirmwareOutcome outcome)
{
    return nameOf(outcomeNames, outcome);
}
} // namespace base
