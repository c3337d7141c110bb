// SPDX-License-Identifier: GPL-3.0-or-later
// The memory table as a sheet for copying, exporting and printing: what the screen shows, in the
// language of the interface; a value that was not read stays empty. Pure; main thread.
#pragma once

#include "ui/memory/memory_model.h"
#include "ui/memory/table_export.h"

#include <QDateTime>

namespace ui {
/// `rows` are rows of the model, in the order wanted.
TableSheet memorySheet(const MemoryModel& model, const std::vector<int>& rows,
                       const session::ServoEntry& entry, const QDateTime& at);

/// "STS3215-id1-2026-11-21", without characters that a file system minds.
QString memoryFileName(const session::ServoEntry& entry, const QDateTime& at);
} // namespace ui
