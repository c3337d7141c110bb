// SPDX-License-Identifier: GPL-3.0-or-later
#include "record/append_file.h"

#include "record/file_error.h"
#include "record/file_handle.h"

#include <QDir>
#include <QFileInfo>

#include <cerrno>

namespace record {
bool syncFolders(const QString& file, const QString& topmostOld)
{
    QString folder = file;
    do {
        folder = QFileInfo(folder).absolutePath();
        if (!FileHandle::syncFolder(folder))
            return false;
    } while (folder != topmostOld && !QDir(folder).isRoot());
    return true;
}

QString existingFolder(const QString& file)
{
    QString folder = QFileInfo(file).absolutePath();
    while (!QFileInfo::exists(folder) && !QDir(folder).isRoot())
        folder = QFileInfo(folder).absolutePath();
    return folder;
}

namespace {
const QString operation = QStringLiteral("journal");

base::Error writeError(const QString& path)
{
    return fileError(base::ErrorCode::FileUnwritable, operation, path, errno);
}

base::Error readError(const QString& path)
{
    return fileError(base::ErrorCode::FileUnreadable, operation, path, errno);
}

base::Error wrongKind(const QString& path)
{
    return {base::ErrorCode::FileUnreadable, operation,
            path + QStringLiteral(": not a regular file")};
}

base::Result<void> create(const QString& path)
{
    const QString topmostOld = existingFolder(path);
    if (!QDir().mkpath(QFileInfo(path).absolutePath()))
        return tl::unexpected(writeError(path));
    const FileHandle file(path, FileHandle::Mode::Append);
    if (!file.isOpen() || !syncFolders(path, topmostOld))
        return tl::unexpected(writeError(path));
    return {};
}

bool endsInLine(const FileHandle& file, qint64 size)
{
    if (size == 0)
        return true;
    const auto last = file.read(size - 1, 1);
    return last && *last == "\n";
}
} // namespace

base::Result<void> appendLine(const QString& path, const QByteArray& line)
{
    if (!QFileInfo::exists(path)) {
        if (const auto created = create(path); !created)
            return created;
    }
    FileHandle file(path, FileHandle::Mode::Append);
    if (!file.isOpen() || !file.lock(FileHandle::Lock::Exclusive))
        return tl::unexpected(writeError(path));
    const auto info = file.info();
    if (!info)
        return tl::unexpected(writeError(path));
    if (!info->regular)
        return tl::unexpected(wrongKind(path));

    const QByteArray start = endsInLine(file, info->size) ? QByteArray() : QByteArray("\n");
    if (file.write(start + line + '\n') && file.sync())
        return {};
    const base::Error error = writeError(path);
    file.truncate(info->size);
    return tl::unexpected(error);
}

base::Result<Appended> readAppended(const QString& path, const FileMark& known, qint64 from)
{
    if (!QFileInfo::exists(path))
        return Appended{{}, true, {}};
    FileHandle file(path, FileHandle::Mode::Read);
    if (!file.isOpen() || !file.lock(FileHandle::Lock::Shared))
        return tl::unexpected(readError(path));
    const auto info = file.info();
    if (!info)
        return tl::unexpected(readError(path));
    if (!info->regular)
        return tl::unexpected(wrongKind(path));

    const bool replaced = !(info->mark == known) || info->size < from;
    const qint64 start = replaced ? 0 : from;
    const auto bytes = file.read(start, info->size - start);
    if (!bytes)
        return tl::unexpected(readError(path));
    return Appended{info->mark, replaced, *bytes};
}
} // namespace record
