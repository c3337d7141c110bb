// SPDX-License-Identifier: GPL-3.0-or-later
// Whole text files that people keep: snapshots, limits, reports. Saving replaces the file in one
// step: afterwards it is the old one or the new one, never half of one; pipes and devices are
// written in place. Pure; any thread. Fails with FileMissing, FileUnreadable (pipes and
// devices, which are not read, too), FileFormat (larger than it can be), FileUnwritable, DiskFull.
#pragma once

#include "base/error.h"

#include <QByteArray>

#include <functional>

namespace files {
base::Result<QByteArray> readTextFile(const QString& operation, const QString& path,
                                      qint64 maxSize);
base::Result<void> saveTextFile(const QString& operation, const QByteArray& text,
                                const QString& path);

/// Takes a piece of the text; false when it cannot, and then the caller stops.
using TextSink = std::function<bool(const QByteArray& piece)>;

/// For what is too large to be one text: `write` hands it over in pieces.
base::Result<void> saveTextFile(const QString& operation,
                                const std::function<void(const TextSink&)>& write,
                                const QString& path);
/// The same for a text that may fail to come about: then the file stays as it was.
base::Result<void>
saveTextFileIfValid(const QString& operation,
                    const std::function<base::Result<void>(const TextSink&)>& write,
                    const QString& path);
} // namespace files
