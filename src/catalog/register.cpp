// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/register.h"

namespace catalog {
QString areaName(Area area)
{
    switch (area) {
    case Area::Eprom:
        return QStringLiteral("EPROM");
    case Area::Sram:
        return QStringLiteral("SRAM");
    case Area::Feedback:
        return QStringLiteral("FEEDBACK");
    case Area::Factory:
        return QStringLiteral("FACTORY");
    }
    return {};
}

QString accessName(Access access)
{
    return access == Access::ReadWrite ? QStringLiteral("rw") : QStringLiteral("ro");
}
} // namespace catalog
