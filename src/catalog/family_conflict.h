// SPDX-License-Identifier: GPL-3.0-or-later
// Do firmware, byte order flag and model list name one Feetech family? And the table of one whose
// family is not clear: bytes, since no number in it could be believed. Internal to the layer; pure
// functions; any thread.
#pragma once

#include "catalog/definition.h"

namespace catalog {
/// What contradicts itself; null: it all fits, or nothing is known that could contradict.
std::optional<FamilyFacts> familyConflict(const Catalog::Data& data, const Identity& identity);

/// Leaves the identity and what every Feetech table has as one byte; the rest becomes raw bytes.
void replaceWithRawBytes(Profile& profile);
} // namespace catalog
