// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of the memory table: cells, headers and states, in the language of the interface. Pure
// functions of a row; main thread. A number that was not really read has no text.
#pragma once

#include "ui/editors/register_text.h"
#include "ui/memory/memory_row.h"

namespace ui {
enum class Tone : std::uint8_t; ///< ui/common/theme.h

enum class MemoryColumn : std::uint8_t {
    Address,
    Name,
    Value,
    Physical,
    Area,
    Access,
    Default,
    Range,
    State,
    Count,
};
constexpr int memoryColumns = static_cast<int>(MemoryColumn::Count);

QString memoryHeader(MemoryColumn column);
QString memoryHeaderHelp(MemoryColumn column);

/// What stands in the cell. `physicalFirst`: default and range in the unit as well.
QString memoryText(const MemoryRow& row, MemoryColumn column, bool physicalFirst);
/// All texts about the cell; never empty.
QString memoryTip(const MemoryRow& row, MemoryColumn column, bool physicalFirst);

QString registerName(const MemoryRow& row); ///< without the mark of a changed row
QString stateText(const MemoryRow& row);    ///< with its sign: "✓ kept"
QString stateHelp(const MemoryRow& row);    ///< a sentence, with the error's cause and remedy
QString ageText(RowAge age);                ///< "now", "5 s", "2 min"; empty: never read
Tone stateTone(RowState state);
} // namespace ui
