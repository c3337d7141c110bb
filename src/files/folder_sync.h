// SPDX-License-Identifier: GPL-3.0-or-later
// A new file survives a power cut only if its folder has been synced as well, and a new folder only
// if the one above it has. Any thread; blocks for the disk.
#pragma once

#include <QString>

namespace files {
/// All from the file up to `existingAncestor`; false: the system refuses.
bool syncFolders(const QString& file, const QString& existingAncestor);
/// The deepest folder above `file` that exists.
QString existingFolder(const QString& file);
} // namespace files
