// SPDX-License-Identifier: GPL-3.0-or-later
// Snapshots to and from the disk; the text itself is made in snapshot.cpp.
#include "record/file_error.h"
#include "record/snapshot.h"

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

namespace record {
namespace {
const QString saving = QStringLiteral("save-snapshot");
const QString loading = QStringLiteral("load-snapshot");
constexpr qint64 largestFile = 4 * 1024 * 1024;

const auto openMode = QIODevice::WriteOnly | QIODevice::Unbuffered;

base::Result<void> saveInOneStep(const QByteArray& text, const QString& path)
{
    QSaveFile file(path);
    if (!file.open(openMode) || !writeAll(file, text) || !file.commit())
        return tl::unexpected(fileError(saving, file));
    return {};
}

// Renaming onto a pipe or device would replace it by a file.
base::Result<void> saveInPlace(const QByteArray& text, const QString& path)
{
    QFile file(path);
    if (!file.open(openMode) || !writeAll(file, text))
        return tl::unexpected(fileError(saving, file));
    return {};
}
} // namespace

base::Result<void> saveSnapshot(const Snapshot& snapshot, const QString& path)
{
    if (path.isEmpty())
        return tl::unexpected(noName(saving));
    const QFileInfo target(path);
    const bool special = target.exists() && !target.isFile() && !target.isDir();
    const QByteArray text = encodeSnapshot(snapshot);
    return special ? saveInPlace(text, path) : saveInOneStep(text, path);
}

base::Result<Snapshot> loadSnapshot(const QString& path)
{
    const QFileInfo source(path);
    if (!source.exists())
        return base::fail(base::ErrorCode::FileMissing, loading, path);
    QFile file(path);
    if (source.isDir() || !file.open(QIODevice::ReadOnly))
        return base::fail(base::ErrorCode::FileUnreadable, loading,
                          path + QStringLiteral(": ") + file.errorString());
    const QByteArray text = file.read(largestFile + 1);
    if (file.error() != QFileDevice::NoError)
        return base::fail(base::ErrorCode::FileUnreadable, loading,
                          path + QStringLiteral(": ") + file.errorString());
    if (text.size() > largestFile)
        return base::fail(base::ErrorCode::FileFormat, loading,
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
