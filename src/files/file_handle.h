// SPDX-License-Identifier: GPL-3.0-or-later
// A file as the operating system sees it: what QFile cannot do portably (shared append, locks
// between programs, syncing to disk). Owned by one function call, one thread. Every call answers
// whether it worked; errno then has the reason.
#pragma once

#include <QByteArray>
#include <QString>

#include <optional>
#ifdef Q_OS_WIN
#include <QLockFile>

#include <memory>
#endif

namespace files {
/// Distinguishes a file from one that replaced it.
struct FileId {
    quint64 device = 0;
    quint64 node = 0;
    bool operator==(const FileId&) const = default;
};

class FileHandle {
public:
    enum class Mode : std::uint8_t { Read, Append };
    enum class Lock : std::uint8_t { Shared, Exclusive };

    struct Info {
        FileId id;
        qint64 size = 0;
        bool regular = false;
    };

    /// Append creates the file.
    FileHandle(const QString& path, Mode mode);
    ~FileHandle();
    FileHandle(const FileHandle&) = delete;
    FileHandle& operator=(const FileHandle&) = delete;

    bool isOpen() const { return m_descriptor >= 0; }
    /// Waits some seconds for other programs; closing the file gives the lock back.
    bool lock(Lock lock);
    enum class LockResult : std::uint8_t { Locked, HeldElsewhere, Failed };
    LockResult tryLock(Lock lock); ///< without waiting
    std::optional<Info> info() const;
    /// Of what has this name now; none: nothing has.
    static std::optional<Info> infoOf(const QString& path);
    std::optional<QByteArray> read(qint64 offset, qint64 count) const;
    bool write(const QByteArray& bytes);
    bool sync();
    bool truncate(qint64 size);

    static bool syncFolder(const QString& folder);

private:
    int m_descriptor = -1;
#ifdef Q_OS_WIN
    std::unique_ptr<QLockFile> m_lock;
#endif
};
} // namespace files
