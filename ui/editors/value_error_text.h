// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with a typed value, in the language of the interface: what, why, and what to type
// instead. Pure; main thread.
#pragma once

#include "base/error.h"
#include "catalog/value.h"

namespace ui {
/// Three short sentences. `typed` is shown back, shortened if it is long.
QString inputErrorText(const base::Error& error, const QString& inputText,
                       const catalog::Register& reg, const catalog::ValueFormat& meaning);
} // namespace ui
