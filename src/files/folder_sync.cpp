// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/folder_sync.h"

#include "files/file_handle.h"

#include <QDir>
#include <QFileInfo>

namespace files {
bool syncFolders(const QString& file, const QString& existingAncestor)
{
    QString folder = file;
    do {
        folder = QFileInfo(folder).absolutePath();
        if (!FileHandle::syncFolder(folder))
            return false;
    } while (folder != existingAncestor && !QDir(folder).isRoot());
    return true;
}

QString existingFolder(const QString& file)
{
    QString folder = QFileInfo(file).absolutePath();
    while (!QFileInfo::exists(folder) && !QDir(folder).isRoot())
        folder = QFileInfo(folder).absolutePath();
    return folder;
}
} // namespace files
