// SPDX-License-Identifier: GPL-3.0-or-later
// The list of targets of a sweep test, from CSV: one target per line, and the pause there in ms
// if it differs from the common one; '#' begins a comment, a header line "target,pause" is allowed.
// Pure; any thread. FileFormat names the line; FileMissing, FileUnreadable.
#pragma once

#include "base/error.h"
#include "results/sweep_spec.h"

namespace results {
base::Result<std::vector<SweepPoint>> decodeSweepPoints(const QByteArray& text);
base::Result<std::vector<SweepPoint>> loadSweepPoints(const QString& path);
} // namespace results
