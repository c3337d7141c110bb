// SPDX-License-Identifier: GPL-3.0-or-later
// Snapshots to and from the disk; the text itself is made in snapshot.cpp.
#include "record/file_error.h"
#include "record/snapshot.h"

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

namespace record {
namespace {
constexpr qint64 largestFile = 4 * 1024 * 1024;

base::Result<void> saveInOneStep(const QByteArray& text, const QString& path)
{
    const QString operation = QStringLiteral("save-snapshot");
    QSaveFile file(path);
    // flush(), because commit() does not notice when its own flushing fails.
    const bool written =
        file.open(QIODevice::WriteOnly) && file.write(text) == text.size() && file.flush();
    if (!written || !file.commit())
        return tl::unexpected(fileError(operation, file));
    return {};
}

// Renaming onto a pipe or device would replace it by a file.
base::Result<void> saveInPlace(const QByteArray& text, const QString& path)
{
    const QString operation = QStringLiteral("save-snapshot");
    QFile file(path);
    if (!file.open(QIODevice::WriteOnly | QIODevice::Unbuffered) || file.write(text) != text.size())
        return tl::unexpected(fileError(operation, file));
    return {};
}
} // namespace

base::Result<void> saveSnapshot(const Snapshot& snapshot, const QString& path)
{
    if (path.isEmpty())
        return tl::unexpected(noName(QStringLiteral("save-snapshot")));
    const QFileInfo target(path);
    const bool special = target.exists() && !target.isFile() && !target.isDir();
    const QByteArray text = encodeSnapshot(snapshot);
    return special ? saveInPlace(text, path) : saveInOneStep(text, path);
}

base::Result<Snapshot> loadSnapshot(const QString& path)
{
    const QString operation = QStringLiteral("load-snapshot");
    const QFileInfo source(path);
    if (!source.exists())
        return base::fail(base::ErrorCode::FileMissing, operation, path);
    QFile file(path);
    if (source.isDir() || !file.open(QIODevice::ReadOnly))
        return base::fail(base::ErrorCode::FileUnreadable, operation,
                          path + QStringLiteral(": ") + file.errorString());
    const QByteArray text = file.read(largestFile + 1);
    if (file.error() != QFileDevice::NoError)
        return base::fail(base::ErrorCode::FileUnreadable, operation,
                          path + QStringLiteral(": ") + file.errorString());
    if (text.size() > largestFile)
        return base::fail(base::ErrorCode::FileFormat, operation,
                          path + QStringLiteral(": too large for a snapshot"));
    auto snapshot = decodeSnapshot(text);
    if (!snapshot) {
        base::Error error = snapshot.error();
        error.detail = path + QStringLiteral(": ") + error.detail;
        return tl::unexpected(error);
    }
    return snapshot;
}
} // namespace record
