// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with the history database, without which nothing is written to a servo: sentence,
// cause and remedy, untranslated. Internal to text; pure look-up, any thread.
#pragma once

#include "text/refusal_text.h"

namespace text {
/// Null: this error is not about the history, or its code says all.
const RefusalText* historyText(const base::Error& error);
} // namespace text
