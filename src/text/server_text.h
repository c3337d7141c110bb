// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of the history server, by the kind in their detail (history/server/history_server.h):
// sentence, cause and remedy, untranslated. Internal to text; pure look-up, any thread.
#pragma once

#include "text/refusal_text.h"

namespace text {
/// Null: this error is not about the server.
const RefusalText* serverText(const base::Error& error);

/// The message of the server, in its own language; empty: none.
QString serverMessage(const base::Error& error);
} // namespace text
