// SPDX-License-Identifier: GPL-3.0-or-later
// Where the program keeps things. Follows the application name. Pure look-ups; any thread.
#pragma once

#include <QString>

namespace session {
/// Journal, snapshots taken without being asked. SERVODESK_DATA_DIR overrides the place. Not
/// created by this.
QString dataFolder();

/// Of the database of history/history.h, in the data folder.
QString historyFile();

/// The user's own model files (*.json).
QString modelFolder();
} // namespace session
