// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/register.h"

#include "base/enum_names.h"

namespace catalog {
namespace {
constexpr base::EnumName<Area> areaNames[]{
    {Area::Eprom, "EPROM"},
    {Area::Sram, "SRAM"},
    {Area::Feedback, "FEEDBACK"},
    {Area::Factory, "FACTORY"},
};
constexpr base::EnumName<Access> accessNames[]{
    {Access::ReadOnly, "ro"},
    {Access::ReadWrite, "rw"},
};
} // namespace

QString areaName(Area area)
{
    return base::nameOf(areaNames, area);
}

std::optional<Area> areaFromName(const QString& name)
{
    return base::valueOf(areaNames, name);
}

QString accessName(Access access)
{
    return base::nameOf(accessNames, access);
}

std::optional<Access> accessFromName(const QString& name)
{
    return base::valueOf(accessNames, name);
}
} // namespace catalog
