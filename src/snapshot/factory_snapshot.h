// SPDX-License-Identifier: GPL-3.0-or-later
// What a servo of this kind leaves the factory with, as a column to compare with: the sheet's
// defaults. A row whose default is not documented has no value and is unknown, never "different".
// Pure values; any thread.
#pragma once

#include "catalog/catalog.h"
#include "snapshot/snapshot.h"

namespace snapshot {
/// No time, no port; servo.id is -1. Model and firmware are those of the profile. Never saved.
Snapshot factorySnapshot(const catalog::Profile& profile);

/// The kind of servo in a file, as the present catalog knows it; null when its model, firmware
/// and language lead to another map than the one the file names.
catalog::ProfilePtr profileOf(const Snapshot& snapshot, const catalog::Catalog& catalog);
} // namespace snapshot
