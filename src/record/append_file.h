// SPDX-License-Identifier: GPL-3.0-or-later
// Appending to a file that several programs share so that a line is there entirely or not at all,
// and reading it while they do. Opens, locks and closes the file in each call. Any thread. Blocks
// for the disk, and at most some seconds for another program's lock.
#pragma once

#include "base/error.h"

#include <QByteArray>

namespace record {
/// Appends `line` and a line feed, on a line of its own even after a torn one, and returns when it
/// is on disk. On DiskFull and other failures the file is cut back to what it was.
base::Result<void> appendLine(const QString& path, const QByteArray& line);

/// A new file survives a power cut only if its folder has been synced as well, and a new folder
/// only if the one above it has: all from the file up to `topmostOld`.
bool syncFolders(const QString& file, const QString& topmostOld);
/// The deepest folder above `file` that exists.
QString existingFolder(const QString& file);

/// Tells a file that has grown from one that was replaced.
struct FileMark {
    quint64 device = 0;
    quint64 node = 0;
    bool operator==(const FileMark&) const = default;
};

struct Appended {
    FileMark mark;
    bool replaced = false; ///< another file than `known`, or cut: `bytes` start at its beginning
    QByteArray bytes;
};

/// What has come to the file since `from`. A missing file is an empty one.
base::Result<Appended> readAppended(const QString& path, const FileMark& known, qint64 from);
} // namespace record
