// SPDX-License-Identifier: GPL-3.0-or-later
// How registers are called in reports: by their names in the built-in maps, in both languages. Any
// thread.
#pragma once

#include "catalog/register.h"
#include "snapshot/snapshot.h"

namespace report {
/// The key itself where the maps do not know it, as with a map of the user's own. The maps are
/// loaded at the first call.
catalog::Text registerName(const snapshot::SnapshotServo& servo, const QString& key);
/// "degC" → "°C", "step" → "step" / "步".
catalog::Text registerUnit(const QString& unit);
} // namespace report
