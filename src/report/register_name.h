// SPDX-License-Identifier: GPL-3.0-or-later
// How registers, their units and areas, and protocols are called in reports, in both languages.
// Any thread.
#pragma once

#include "catalog/register.h"
#include "snapshot/snapshot.h"

namespace report {
/// By its name in the built-in maps; the key itself where the maps do not know it, as with a map of
/// the user's own. The maps are loaded at the first call.
catalog::Text registerName(const snapshot::SnapshotServo& servo, const QString& key);
/// "degC" → "°C", "step" → "step" / "步".
catalog::Text registerUnit(const QString& unit);
catalog::Text areaText(catalog::Area area);
/// `name` as files have it: "feetech".
catalog::Text protocolText(const QString& name);
} // namespace report
