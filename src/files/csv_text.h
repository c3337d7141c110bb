// SPDX-License-Identifier: GPL-3.0-or-later
// One cell of CSV as text: quoted where it must be. Pure; any thread.
#pragma once

#include <QByteArray>
#include <QStringList>

#include <optional>

namespace files {
/// A text that a spreadsheet would take for a formula is given an apostrophe, as it recommends.
QByteArray csvText(const QString& cell);
/// The fewest digits that read back as the same number; empty for none, or one that is not finite.
QByteArray csvNumber(std::optional<double> value);
QByteArray csvLine(const QStringList& cells); ///< with its line feed
} // namespace files
