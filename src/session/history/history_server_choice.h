// SPDX-License-Identifier: GPL-3.0-or-later
// Which history server this bench sends its copies to and under which name, as the user has set it.
// SERVODESK_HISTORY_SERVER overrides the server. Main thread, like Settings.
#pragma once

#include "session/settings.h"

namespace session {
struct HistoryServerChoice {
    /// Connection string; empty: none. As the user has typed it, so shown masked only.
    QString address{};
    QString bench{};                   ///< for people; this machine's name if none was given
    bool isFixedByEnvironment = false; ///< by the environment: what is set has no effect
};

HistoryServerChoice historyServerChoice(const Settings& settings);
/// Of `choice` address and bench; one that is fixed keeps the address that was set. Writes nothing
/// where history::ServerAddress refuses the address: BadArgument.
base::Result<void> setHistoryServerChoice(Settings& settings, const HistoryServerChoice& choice);
} // namespace session
