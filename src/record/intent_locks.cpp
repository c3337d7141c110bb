// SPDX-License-Identifier: GPL-3.0-or-later
#include "record/intent_locks.h"

#include <QDir>

namespace record {
IntentLocks::IntentLocks(QString folder)
    : m_folder(std::move(folder))
{}

IntentLocks::~IntentLocks()
{
    freeAll();
}

QString IntentLocks::fileOf(const QString& uuid) const
{
    return m_folder + QLatin1Char('/') + uuid;
}

void IntentLocks::take(const QString& uuid)
{
    QDir().mkpath(m_folder);
    auto file = std::make_unique<FileHandle>(fileOf(uuid), FileHandle::Mode::Append);
    if (!file->isOpen())
        return;
    if (file->tryLock(FileHandle::Lock::Exclusive) != FileHandle::Try::Locked) {
        file.reset();
        QFile::remove(fileOf(uuid));
        return;
    }
    const std::lock_guard lock(m_mutex);
    m_own[uuid] = std::move(file);
}

void IntentLocks::free(const QString& uuid)
{
    const std::lock_guard lock(m_mutex);
    if (m_own.erase(uuid) > 0)
        QFile::remove(fileOf(uuid));
}

void IntentLocks::freeAll()
{
    const std::lock_guard lock(m_mutex);
    while (!m_own.empty()) {
        const QString uuid = m_own.begin()->first;
        m_own.erase(m_own.begin()); // a file that is open cannot be removed everywhere
        QFile::remove(fileOf(uuid));
    }
}

bool IntentLocks::isHeldElsewhere(const QString& uuid) const
{
    {
        const std::lock_guard lock(m_mutex);
        if (m_own.count(uuid) > 0)
            return false;
    }
    bool stale = false;
    {
        FileHandle file(fileOf(uuid), FileHandle::Mode::Read);
        if (!file.isOpen())
            return false;
        const auto tried = file.tryLock(FileHandle::Lock::Shared); // others may ask as well
        if (tried == FileHandle::Try::HeldElsewhere)
            return true;
        stale = tried == FileHandle::Try::Locked;
    }
    if (stale)
        QFile::remove(fileOf(uuid));
    return false;
}
} // namespace record
