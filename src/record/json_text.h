// SPDX-License-Identifier: GPL-3.0-or-later
// Pieces of JSON text, for files whose order of lines matters to readers and version control.
// Pure; any thread. What is no number (NaN, infinity) is null.
#pragma once

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <optional>

namespace record {
QByteArray jsonText(const QString& text);
QByteArray jsonText(const QStringList& texts);
QByteArray jsonFlag(bool value);

/// The shortest text that reads as the same number again; with `digits`, not more of them.
QByteArray jsonNumber(std::optional<double> value, std::optional<int> digits = {});
} // namespace record
