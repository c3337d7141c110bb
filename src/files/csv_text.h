// SPDX-License-Identifier: GPL-3.0-or-later
// One cell of CSV as text: quoted where it must be. Pure; any thread.
#pragma once

#include <QByteArray>
#include <QStringList>

#include <optional>

namespace record {
/// A text that a spreadsheet would take for a formula is given an apostrophe, as it recommends.
QByteArray csvText(const QString& cell);
/// As many digits as tell the number; empty for none, or one that is not finite.
QByteArray csvNumber(std::optional<double> value);
QByteArray csvLine(const QStringList& cells); ///< with its line feed
} // namespace record
