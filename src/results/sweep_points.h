// SPDX-License-Identifier: GPL-3.0-or-later
// The list of targets of a sweep test, from CSV: a target a line, and how long to wait there in ms,
// if not as long as everywhere; '#' begins a comment, a header line may say "target,pause". Pure;
// any thread. FileFormat names the line; FileMissing, FileUnreadable.
#pragma once

#include "base/error.h"
#include "results/sweep_spec.h"

namespace record {
base::Result<std::vector<SweepPoint>> decodeSweepPoints(const QByteArray& text);
base::Result<std::vector<SweepPoint>> loadSweepPoints(const QString& path);
} // namespace record
