// SPDX-License-Identifier: GPL-3.0-or-later
// The schema of the history, as the statements that lead from each version to the next. Internal
// to record/history_file.h. What has been published is never changed, only added to.
#pragma once

#include <QStringList>

#include <vector>

namespace record {
/// The first element makes version 1 of an empty file, and so on.
const std::vector<QStringList>& historyMigrations();

/// The tables whose rows have a uuid and a revision, those others refer to first.
const QStringList& syncedTables();
} // namespace record
