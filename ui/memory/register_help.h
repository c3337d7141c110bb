// SPDX-License-Identifier: GPL-3.0-or-later
// The facts about one register as sentences: unit, range, default, what it depends on and what
// depends on it, and whether a write to it is kept. Pure functions; main thread.
#pragma once

#include "ui/memory/memory_row.h"

#include <QStringList>

namespace ui {
/// Key, unit, range, default, area and access, one a line.
QStringList registerFacts(const MemoryRow& row);

/// What its meaning depends on, what depends on it, and what has to be done around a write.
QStringList registerRelations(const MemoryRow& row, const catalog::Profile& profile);

/// What becomes of a write at power-off, and what ServoDesk does for it.
QString persistenceText(const catalog::Register& reg);

/// False where every write is kept, or where none ever is.
bool canWriteTemporarily(const catalog::Register& reg);
} // namespace ui
