// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/file_error.h"

#include <QFile>

#include <cerrno>
#include <system_error>

#ifdef Q_OS_UNIX
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace files {
namespace {
bool isDiskFullError(int systemError)
{
#ifdef EDQUOT
    if (systemError == EDQUOT)
        return true;
#endif
    return systemError == ENOSPC || systemError == EFBIG;
}
} // namespace

base::Error fileError(base::ErrorCode otherwise, const QString& operation, const QString& path,
                      int systemError)
{
    const auto message = QString::fromStdString(std::generic_category().message(systemError));
    return {isDiskFullError(systemError) ? base::ErrorCode::DiskFull : otherwise, operation,
            path + QStringLiteral(": ") + message};
}

base::Error fileError(const QString& operation, const QFileDevice& file)
{
    const bool full = file.error() == QFileDevice::ResourceError;
    return {full ? base::ErrorCode::DiskFull : base::ErrorCode::FileUnwritable, operation,
            file.fileName() + QStringLiteral(": ") + file.errorString()};
}

bool writeAll(QFileDevice& file, const QByteArray& bytes)
{
    qint64 done = 0;
    while (done < bytes.size()) {
        const qint64 put = file.write(bytes.constData() + done, bytes.size() - done);
        if (put <= 0)
            return false;
        done += put;
    }
    return true;
}

std::optional<base::Error> writeRefusal(const QString& operation, const QString& path)
{
#ifdef Q_OS_UNIX
    struct stat target = {};
    if (::stat(QFile::encodeName(path).constData(), &target) != 0 ||
        !(S_ISFIFO(target.st_mode) || S_ISSOCK(target.st_mode) || S_ISBLK(target.st_mode)))
        return std::nullopt;
    for (const int own : {STDOUT_FILENO, STDERR_FILENO}) {
        struct stat output = {};
        if (::fstat(own, &output) == 0 && output.st_dev == target.st_dev &&
            output.st_ino == target.st_ino)
            return std::nullopt;
    }
    return base::Error{base::ErrorCode::FileUnwritable, operation,
                       path + QStringLiteral(": not a regular file")};
#else
    Q_UNUSED(operation)
    Q_UNUSED(path)
    return std::nullopt;
#endif
}

base::Error noFileNameError(const QString& operation)
{
    return {base::ErrorCode::FileUnwritable, operation, QStringLiteral("no file name")};
}
} // namespace files
