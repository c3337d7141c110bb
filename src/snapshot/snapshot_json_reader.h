// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a snapshot that is part of a larger document (a bundle, a test run). What is wrong goes to
// the reader's complaint. Pure; any thread.
#pragma once

#include "files/json_reader.h"
#include "snapshot/snapshot.h"

namespace snapshot {
Snapshot readSnapshot(const files::JsonReader& json);
} // namespace snapshot
