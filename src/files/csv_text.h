// SPDX-License-Identifier: GPL-3.0-or-later
// CSV as text: cells quoted where they must be. Pure; any thread.
#pragma once

#include <QByteArray>
#include <QStringList>

#include <cstdint>
#include <optional>

namespace files {
/// Whom a file is for. A spreadsheet shows Chinese only if the file begins with a byte order mark,
/// which programs take for a part of the first column's name.
enum class CsvReader : std::uint8_t { Program, Spreadsheet };
QByteArray csvStart(CsvReader reader);

/// A text that a spreadsheet would take for a formula is given an apostrophe, as it recommends.
QByteArray csvText(const QString& cell);
/// The fewest digits that read back as the same number; empty for none, or one that is not finite.
QByteArray csvNumber(std::optional<double> value);
QByteArray csvLine(const QStringList& cells); ///< with its line feed
} // namespace files
