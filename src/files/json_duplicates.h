// SPDX-License-Identifier: GPL-3.0-or-later
// Names that an object of a JSON text has twice: the parser would silently take the last one, and
// the person who edited the file meant both. Pure; any thread.
#pragma once

#include <QByteArray>
#include <QString>

namespace files {
/// For a text that parses. "line 12: "raw" is there twice", or empty.
QString findDuplicateKey(const QByteArray& text);
} // namespace files
