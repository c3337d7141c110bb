// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/register_name.h"

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
} // namespace report
