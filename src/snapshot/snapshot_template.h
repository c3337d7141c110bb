// SPDX-License-Identifier: GPL-3.0-or-later
// A snapshot with only the chosen rows, for giving the same settings to many servos. The file is a
// snapshot file and loads as one. Pure; any thread. Errors: UnknownRegister (registerKey: the one
// the snapshot has not), BadArgument with registerKey and a reason (IdentityRegister,
// ReadOnlyRegister, NoValue), or without one when nothing was chosen.
#pragma once

#include "snapshot/snapshot.h"

namespace snapshot {
/// Rows that make a servo this servo (ID, rate) get in only with `identity`: written to several
/// servos they would collide.
base::Result<Snapshot> makeTemplate(const Snapshot& from, const QStringList& keys,
                                    bool identity = false);

/// ID and baud rate, in every map.
bool isIdentityKey(const QString& key);
} // namespace snapshot
