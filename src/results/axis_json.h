// SPDX-License-Identifier: GPL-3.0-or-later
// The axis of a sweep or step test in JSON, steps and tolerance in the units of the goal register;
// and durations in milliseconds. Faults go to the reader's error. Pure; any thread.
#pragma once

#include "files/json_reader.h"
#include "results/sweep_run.h"

namespace results {
enum class AxisFields {
    Range, ///< a step test: limits only
    Path   ///< a sweep test: its stops too
};
QByteArray encodeAxis(const SweepAxis& axis, AxisFields fields);
SweepAxis readAxis(const files::JsonReader& json, AxisFields fields);

/// Up to thirty years; longer durations are reported under `key`.
base::Duration readMilliseconds(const files::JsonReader& json, const char* key, double ms);
} // namespace results
