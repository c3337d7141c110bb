// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with the history server, by the kind in the detail of record/history_server.h:
// sentence, cause and remedy, untranslated. Internal to text; pure look-up, any thread.
#pragma once

#include "text/refusal_text.h"

namespace text {
/// Null: this error is not about the server.
const RefusalText* serverText(const base::Error& error);

/// The server's own words about it, in whatever language; empty: none.
QString serverMessage(const base::Error& error);
} // namespace text
