// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/register_name.h"

#include "base/protocol.h"
#include "catalog/catalog.h"
#include "catalog/units.h"
#include "report/bilingual.h"
#include "report/sweep_text.h"

namespace report {
catalog::Text registerName(const snapshot::SnapshotServo& servo, const QString& key)
{
    static const catalog::Catalog builtIn = catalog::Catalog::load().catalog;
    return builtIn.registerName(servo.map, key).value_or(inBoth(key));
}

catalog::Text registerUnit(const QString& unit)
{
    return unitText(catalog::unitSuffix(unit).trimmed());
}

catalog::Text areaText(catalog::Area area)
{
    switch (area) {
    case catalog::Area::Feedback:
        return translate("text", "feedback");
    case catalog::Area::Factory:
        return translate("text", "factory");
    case catalog::Area::Eprom:
    case catalog::Area::Sram:
        break;
    }
    return inBoth(catalog::areaName(area));
}

catalog::Text protocolText(const QString& name)
{
    const auto protocol = base::protocolFromName(name);
    if (!protocol)
        return inBoth(name);
    switch (*protocol) {
    case base::Protocol::Modbus:
        return inBoth(QStringLiteral("Modbus"));
    case base::Protocol::Lx:
        return inBoth(QStringLiteral("LX"));
    case base::Protocol::Feetech:
        break;
    }
    return translate("BusText", "Feetech");
}
} // namespace report
