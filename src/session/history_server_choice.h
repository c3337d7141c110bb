// SPDX-License-Identifier: GPL-3.0-or-later
// Which history server this bench sends its copies to and under which name, as the user has set it.
// SERVODESK_HISTORY_SERVER overrides the server. Main thread, like Settings.
#pragma once

#include "session/settings.h"

namespace session {
struct HistoryServerChoice {
    QString address{};  ///< connection string; empty: none. May hold a password: never shown
    QString bench{};    ///< for people; this machine's name if none was given
    bool fixed = false; ///< by the environment: what is set has no effect
};

HistoryServerChoice historyServerChoice(const Settings& settings);
/// Of `choice` address and bench.
void setHistoryServerChoice(Settings& settings, const HistoryServerChoice& choice);
} // namespace session
