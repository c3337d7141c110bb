// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/file_handle.h"

#ifdef Q_OS_UNIX

#include <QFile>

#include <cerrno>
#include <chrono>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace files {
namespace {
constexpr auto lockTimeout = std::chrono::seconds(5);
constexpr auto lockRetryInterval = std::chrono::milliseconds(2);

// A pipe under the journal's name must not block the opening.
int flagsFor(FileHandle::Mode mode)
{
    constexpr int common = O_CLOEXEC | O_NONBLOCK;
    return mode == FileHandle::Mode::Append ? common | O_RDWR | O_APPEND | O_CREAT
                                            : common | O_RDONLY;
}

FileHandle::Info infoFrom(const struct stat& status)
{
    return {{quint64(status.st_dev), quint64(status.st_ino)},
            qint64(status.st_size),
            S_ISREG(status.st_mode)};
}
} // namespace

FileHandle::FileHandle(const QString& path, Mode mode)
    : m_descriptor(::open(QFile::encodeName(path).constData(), flagsFor(mode), 0666))
{}

FileHandle::~FileHandle()
{
    if (isOpen())
        ::close(m_descriptor);
}

bool FileHandle::lock(Lock lock)
{
    const int kind = lock == Lock::Shared ? LOCK_SH : LOCK_EX;
    const auto deadline = std::chrono::steady_clock::now() + lockTimeout;
    while (::flock(m_descriptor, kind | LOCK_NB) != 0) {
        if (errno != EWOULDBLOCK && errno != EINTR)
            return false;
        if (std::chrono::steady_clock::now() > deadline) {
            errno = EBUSY;
            return false;
        }
        std::this_thread::sleep_for(lockRetryInterval);
    }
    return true;
}

FileHandle::LockResult FileHandle::tryLock(Lock lock)
{
    const int kind = lock == Lock::Shared ? LOCK_SH : LOCK_EX;
    while (::flock(m_descriptor, kind | LOCK_NB) != 0) {
        if (errno != EINTR)
            return errno == EWOULDBLOCK ? LockResult::HeldElsewhere : LockResult::Failed;
    }
    return LockResult::Locked;
}

std::optional<FileHandle::Info> FileHandle::info() const
{
    struct stat status = {};
    if (::fstat(m_descriptor, &status) != 0)
        return std::nullopt;
    return infoFrom(status);
}

std::optional<FileHandle::Info> FileHandle::infoOf(const QString& path)
{
    struct stat status = {};
    if (::stat(QFile::encodeName(path).constData(), &status) != 0)
        return std::nullopt;
    return infoFrom(status);
}

std::optional<QByteArray> FileHandle::read(qint64 offset, qint64 count) const
{
    QByteArray bytes(count, Qt::Uninitialized);
    qint64 done = 0;
    while (done < count) {
        const auto got = ::pread(m_descriptor, bytes.data() + done, std::size_t(count - done),
                                 off_t(offset + done));
        if (got < 0 && errno != EINTR)
            return std::nullopt;
        if (got == 0)
            break;
        done += got > 0 ? got : 0;
    }
    bytes.truncate(done);
    return bytes;
}

bool FileHandle::write(const QByteArray& bytes)
{
    qint64 done = 0;
    while (done < bytes.size()) {
        const auto put =
            ::write(m_descriptor, bytes.constData() + done, std::size_t(bytes.size() - done));
        if (put < 0 && errno != EINTR)
            return false;
        done += put > 0 ? put : 0;
    }
    return true;
}

bool FileHandle::sync()
{
    return ::fsync(m_descriptor) == 0;
}

bool FileHandle::truncate(qint64 size)
{
    return ::ftruncate(m_descriptor, off_t(size)) == 0;
}

bool FileHandle::syncFolder(const QString& folder)
{
    const int descriptor =
        ::open(QFile::encodeName(folder).constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
        return false;
    // Some file systems cannot sync folders and return EINVAL; there is nothing more to do.
    const bool synced = ::fsync(descriptor) == 0 || errno == EINVAL;
    ::close(descriptor);
    return synced;
}
} // namespace files

#endif
