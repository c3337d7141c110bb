// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/file_handle.h"

#ifdef Q_OS_WIN

#include <cerrno>
#include <fcntl.h>
#include <io.h>
#include <sys/stat.h>

namespace files {
namespace {
constexpr int lockTimeoutMs = 5000;

int flagsFor(FileHandle::Mode mode)
{
    constexpr int common = _O_BINARY | _O_NOINHERIT;
    return mode == FileHandle::Mode::Append ? common | _O_RDWR | _O_APPEND | _O_CREAT
                                            : common | _O_RDONLY;
}
} // namespace

FileHandle::FileHandle(const QString& path, Mode mode)
    : m_descriptor(::_wopen(reinterpret_cast<const wchar_t*>(path.utf16()), flagsFor(mode),
                            _S_IREAD | _S_IWRITE))
    , m_lock(std::make_unique<QLockFile>(path + QStringLiteral(".lock")))
{
    m_lock->setStaleLockTime(0);
}

FileHandle::~FileHandle()
{
    m_lock->unlock();
    if (isOpen())
        ::_close(m_descriptor);
}

bool FileHandle::lock(Lock)
{
    if (m_lock->tryLock(lockTimeoutMs))
        return true;
    errno = EBUSY;
    return false;
}

FileHandle::LockResult FileHandle::tryLock(Lock)
{
    if (m_lock->tryLock(0))
        return LockResult::Locked;
    return m_lock->error() == QLockFile::LockFailedError ? LockResult::HeldElsewhere
                                                         : LockResult::Failed;
}

std::optional<FileHandle::Info> FileHandle::info() const
{
    struct _stat64 status = {};
    if (::_fstat64(m_descriptor, &status) != 0)
        return std::nullopt;
    return Info{{}, qint64(status.st_size), (status.st_mode & _S_IFREG) != 0};
}

std::optional<FileHandle::Info> FileHandle::infoOf(const QString& path)
{
    struct _stat64 status = {};
    if (::_wstat64(reinterpret_cast<const wchar_t*>(path.utf16()), &status) != 0)
        return std::nullopt;
    return Info{{}, qint64(status.st_size), (status.st_mode & _S_IFREG) != 0};
}

std::optional<QByteArray> FileHandle::read(qint64 offset, qint64 count) const
{
    if (::_lseeki64(m_descriptor, offset, SEEK_SET) < 0)
        return std::nullopt;
    QByteArray bytes(count, Qt::Uninitialized);
    qint64 done = 0;
    while (done < count) {
        const auto piece = unsigned(qMin<qint64>(count - done, 1 << 30));
        const int got = ::_read(m_descriptor, bytes.data() + done, piece);
        if (got < 0)
            return std::nullopt;
        if (got == 0)
            break;
        done += got;
    }
    bytes.truncate(done);
    return bytes;
}

bool FileHandle::write(const QByteArray& bytes)
{
    return ::_write(m_descriptor, bytes.constData(), unsigned(bytes.size())) == bytes.size();
}

bool FileHandle::sync()
{
    return ::_commit(m_descriptor) == 0;
}

bool FileHandle::truncate(qint64 size)
{
    return ::_chsize_s(m_descriptor, size) == 0;
}

bool FileHandle::syncFolder(const QString&)
{
    return true;
}
} // namespace files

#endif
