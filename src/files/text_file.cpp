// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/text_file.h"

#include "files/file_error.h"

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#ifdef Q_OS_UNIX
#include <fcntl.h>
#endif

namespace files {
namespace {
const auto openMode = QIODevice::WriteOnly | QIODevice::Unbuffered;

template <typename File>
bool writeChunks(File& file, const std::function<void(const TextSink&)>& write)
{
    if (!file.open(openMode))
        return false;
    bool fine = true;
    write([&](const QByteArray& piece) {
        fine = fine && writeAll(file, piece);
        return fine;
    });
    return fine;
}
/// Some system files are reported as regular but block until there is data (/proc/kmsg).
bool openForReading(QFile& file)
{
#ifdef Q_OS_UNIX
    const int descriptor = ::open(QFile::encodeName(file.fileName()).constData(),
                                  O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
    if (descriptor >= 0)
        return file.open(descriptor, QIODevice::ReadOnly, QFileDevice::AutoCloseHandle);
#endif
    return file.open(QIODevice::ReadOnly); // sets the reason
}
} // namespace

base::Result<QByteArray> readTextFile(const QString& operation, const QString& path, qint64 maxSize)
{
    const QFileInfo source(path);
    if (!source.exists())
        return base::fail(base::ErrorCode::FileMissing, operation, path);
    // A pipe would be waited for, and a device may never end.
    if (!source.isFile())
        return base::fail(base::ErrorCode::FileUnreadable, operation,
                          path + QStringLiteral(": not a regular file"));
    QFile file(path);
    if (!openForReading(file))
        return base::fail(base::ErrorCode::FileUnreadable, operation,
                          path + QStringLiteral(": ") + file.errorString());
    const QByteArray text = file.read(maxSize + 1);
    if (file.error() != QFileDevice::NoError)
        return base::fail(base::ErrorCode::FileUnreadable, operation,
                          path + QStringLiteral(": ") + file.errorString());
    if (text.size() > maxSize)
        return base::fail(base::ErrorCode::FileFormat, operation,
                          path + QStringLiteral(": too large for a file of this kind"));
    return text;
}

base::Result<void> saveTextFile(const QString& operation, const QByteArray& text,
                                const QString& path)
{
    return saveTextFile(
        operation, [&](const TextSink& sink) { sink(text); }, path);
}

base::Result<void> saveTextFile(const QString& operation,
                                const std::function<void(const TextSink&)>& write,
                                const QString& path)
{
    return saveTextFileIfValid(
        operation,
        [&](const TextSink& sink) -> base::Result<void> {
            write(sink);
            return {};
        },
        path);
}

base::Result<void>
saveTextFileIfValid(const QString& operation,
                    const std::function<base::Result<void>(const TextSink&)>& write,
                    const QString& path)
{
    base::Result<void> made;
    const auto all = [&](const TextSink& sink) { made = write(sink); };
    if (path.isEmpty())
        return tl::unexpected(noFileNameError(operation));
    if (auto special = writeRefusal(operation, path))
        return tl::unexpected(std::move(*special));
    const QFileInfo target(path);
    // Renaming onto a pipe or device would replace it by a file.
    if (target.exists() && !target.isFile() && !target.isDir()) {
        QFile file(path);
        if (!writeChunks(file, all))
            return tl::unexpected(fileError(operation, file));
        return made;
    }
    QSaveFile file(path);
    if (!writeChunks(file, all))
        return tl::unexpected(fileError(operation, file));
    if (!made) {
        file.cancelWriting();
        return made;
    }
    if (!file.commit())
        return tl::unexpected(fileError(operation, file));
    return {};
}
} // namespace files
