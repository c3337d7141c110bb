// SPDX-License-Identifier: GPL-3.0-or-later
// What only shows when the rows of a map are seen together: duplicate keys, registers that overlap
// for some series and firmware, references to registers that do not exist. Pure; any thread.
#pragma once

#include "catalog/definition.h"

#include <functional>

namespace catalog {
/// Removes the rows that cannot stay and reports each with the reason.
void removeConflicts(MapDef& map,
                     const std::function<void(const QString& key, const QString& reason)>& report);
} // namespace catalog
