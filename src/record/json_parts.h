// SPDX-License-Identifier: GPL-3.0-or-later
// What several kinds of document have in common: the name and version they begin with; and those
// that are files of their own and parts of a larger one, read from where they stand there. What is
// wrong goes to the reader's complaint. Pure; any thread.
#pragma once

#include "record/json_reader.h"
#include "record/snapshot.h"
#include "record/sweep_limits.h"

namespace record {
/// The head of a document: "format" is `name`, or the complaint is `mismatchText`; "version" is one
/// that this program knows.
void checkFormat(const JsonReader& json, QLatin1StringView name, int newest,
                 const QString& mismatchText);

Snapshot readSnapshot(const JsonReader& json);

/// Without lines they are allowed here: a test may have been run without limits.
SweepLimits readSweepLimits(const JsonReader& json);
} // namespace record
