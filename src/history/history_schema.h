// SPDX-License-Identifier: GPL-3.0-or-later
// The schema of the history, as the statements that lead from each version to the next. Internal
// to history/history_file.h. Published statements never change.
#pragma once

#include <QStringList>

#include <vector>

namespace history {
/// The first element makes version 1 of an empty file, and so on.
const std::vector<QStringList>& historyMigrations();

/// The tables whose rows have a uuid and a revision; referenced tables come first.
const QStringList& syncedTables();
} // namespace history
