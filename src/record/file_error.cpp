// SPDX-License-Identifier: GPL-3.0-or-later
#include "record/file_error.h"

#include <cerrno>
#include <system_error>

namespace record {
namespace {
bool meansNoRoom(int systemError)
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
    return {meansNoRoom(systemError) ? base::ErrorCode::DiskFull : otherwise, operation,
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

base::Error noName(const QString& operation)
{
    return {base::ErrorCode::FileUnwritable, operation, QStringLiteral("no file name")};
}
} // namespace record
