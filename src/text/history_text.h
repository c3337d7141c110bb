// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of the history database, without which nothing is written to a servo: sentence, cause and
// remedy, untranslated. Internal to text; pure look-up, any thread.
#pragma once

#include "text/refusal_text.h"

namespace text {
/// Null: this error is not about the history, or has no text of its own.
const RefusalText* historyText(const base::Error& error);
} // namespace text
