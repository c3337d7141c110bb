// SPDX-License-Identifier: GPL-3.0-or-later
// How the name, value and range of a register are written in tables, fields and messages, in the
// language of the interface. Pure; main thread.
#pragma once

#include "base/error.h"
#include "catalog/value.h"

#include <QString>

namespace ui {
/// A list or check boxes: the values have names instead of a unit.
bool hasNamedValues(const catalog::ValueFormat& meaning);
/// The error with the register's name, as the table has it, in place of its key.
base::Error withName(base::Error error, const catalog::Register* reg);

/// "0–254", "±2047", physical with its unit if wanted; empty where there is no range.
QString rangeText(const catalog::Register& reg, const catalog::ValueFormat& meaning, bool physical);
/// A number as the table shows it: "44", "1 — on", "8.5 V".
QString rawWord(std::int64_t raw, const catalog::Register& reg,
                const catalog::ValueFormat& meaning);
QString physicalText(std::int64_t raw, const catalog::Register& reg,
                     const catalog::ValueFormat& meaning);
} // namespace ui
